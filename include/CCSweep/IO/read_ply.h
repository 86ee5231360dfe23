// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_READ_PLY_H
#define CCSWEEP_IO_READ_PLY_H

#include <CCSweep/IO/internal/input_file.h>
#include <CCSweep/IO/internal/ply_header.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Polygon_soup.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace CCSweep {
namespace internal {

// The body of an ascii PLY: one row a line.
class Ply_text_rows {
 public:
  Ply_text_rows(const Input_file& file, const Ply_header& header) : cursor_(file, header.body, header.body_line) {}

  std::size_t remaining() const { return cursor_.remaining(); }
  static std::size_t least_size(const Ply_element& element) {
    return std::max<std::size_t>(1, 2 * element.properties.size());
  }
  static std::size_t least_size(Ply_type) { return 2; }

  double value(Ply_type) { return cursor_.number(cursor_.token(), "a number"); }

  void end_row() {
    if (const auto surplus = cursor_.token(); !surplus.empty())
      cursor_.fail("more values than the header announces: " + excerpt(surplus));
    cursor_.rest_of_line();
  }

  void end() {
    if (const auto surplus = cursor_.token_of_any_line(); !surplus.empty())
      cursor_.fail("more data than the header announces: " + excerpt(surplus));
  }

  [[noreturn]] void fail(const std::string& what) const { cursor_.fail(what); }

 private:
  Text_cursor cursor_;
};

// The body of a binary PLY.
class Ply_binary_rows {
 public:
  Ply_binary_rows(const Input_file& file, const Ply_header& header)
      : file_(&file),
        position_(header.body),
        swap_((header.format == Ply_format::binary_big_endian) != (std::endian::native == std::endian::big)) {}

  std::size_t remaining() const { return file_->data.size() - position_; }
  static std::size_t least_size(Ply_type type) { return size_of(type); }
  static std::size_t least_size(const Ply_element& element) {
    std::size_t size = 0;
    for (const Ply_property& property : element.properties)
      size += size_of(property.count_type.value_or(property.type));
    return size;
  }

  double value(Ply_type type) {
    switch (type) {
      case Ply_type::int8:
        return static_cast<double>(raw<std::int8_t>());
      case Ply_type::uint8:
        return static_cast<double>(raw<std::uint8_t>());
      case Ply_type::int16:
        return static_cast<double>(raw<std::int16_t>());
      case Ply_type::uint16:
        return static_cast<double>(raw<std::uint16_t>());
      case Ply_type::int32:
        return static_cast<double>(raw<std::int32_t>());
      case Ply_type::uint32:
        return static_cast<double>(raw<std::uint32_t>());
      case Ply_type::int64:
        return static_cast<double>(raw<std::int64_t>());
      case Ply_type::uint64:
        return static_cast<double>(raw<std::uint64_t>());
      case Ply_type::float32:
        return static_cast<double>(raw<float>());
      case Ply_type::float64:
        return raw<double>();
    }
    fail("unknown type");
  }

  void end_row() {}

  void end() {
    const auto surplus = std::find_if(file_->data.begin() + static_cast<std::ptrdiff_t>(position_), file_->data.end(),
                                      [](char c) { return c != '\n' && !is_blank(c); });
    if (surplus != file_->data.end()) fail("more data than the header announces");
  }

  [[noreturn]] void fail(const std::string& what) const {
    file_->fail("byte " + std::to_string(position_) + ": " + what);
  }

 private:
  template <class T>
  T raw() {
    if (remaining() < sizeof(T)) fail("the file ends too early");
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), file_->data.data() + position_, sizeof(T));
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    position_ += sizeof(T);
    return std::bit_cast<T>(bytes);
  }

  const Input_file* file_;
  std::size_t position_;
  bool swap_;
};

// Reads the rows of all elements into a soup. No count is believed before the rest of the file has room for it.
template <class Rows>
class Ply_body {
 public:
  Ply_body(const Ply_header& header, Rows rows) : header_(&header), rows_(std::move(rows)) {
    const Ply_element* vertices = header.find("vertex");
    const Ply_element* faces = header.find("face");
    if (!vertices) rows_.fail("the header has no element 'vertex'");
    if (!faces) rows_.fail("the header has no element 'face'");
    number_of_vertices_ = vertices->count;
  }

  Polygon_soup read() {
    for (const Ply_element& element : header_->elements) {
      if (const std::size_t least = rows_.least_size(element); least > 0) {
        const std::size_t room = (rows_.remaining() + 1) / least;
        if (element.count > room)
          rows_.fail("the header announces " + std::to_string(element.count) + " of element " + excerpt(element.name) +
                     ", but the rest of the file has room for " + std::to_string(room) + " at most");
      }
      if (&element == header_->find("vertex"))
        read_vertices(element);
      else if (&element == header_->find("face"))
        read_faces(element);
      else if (!element.properties.empty())
        skip(element);
    }
    rows_.end();
    return std::move(soup_);
  }

 private:
  void read_vertices(const Ply_element& element) {
    std::array<std::size_t, 3> at{};
    constexpr std::array<const char*, 3> names = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
      at[i] = element.find(names[i]);
      if (at[i] == element.properties.size() || element.properties[at[i]].count_type)
        rows_.fail(std::string("vertices have no property '") + names[i] + "'");
    }
    if (element.count >= std::numeric_limits<Polygon_soup::Vertex>::max()) rows_.fail("too many vertices");
    soup_.points.reserve(element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      std::array<double, 3> point{};
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        const auto coordinate = std::find(at.begin(), at.end(), i);
        if (coordinate == at.end())
          skip(element.properties[i]);
        else
          point[static_cast<std::size_t>(coordinate - at.begin())] = rows_.value(element.properties[i].type);
      }
      soup_.points.push_back(point);
      rows_.end_row();
    }
  }

  void read_faces(const Ply_element& element) {
    const std::size_t end = element.properties.size();
    std::size_t list = element.find("vertex_indices");
    if (list == end) list = element.find("vertex_index");
    if (list == end || !element.properties[list].count_type) rows_.fail("faces have no list 'vertex_indices'");
    const std::size_t patch = element.find("patch_id");
    if (patch != end && (element.properties[patch].count_type || !is_integral(element.properties[patch].type)))
      rows_.fail("the face property 'patch_id' must be an integer");
    std::size_t role = element.find("role");
    if (role != end && (element.properties[role].count_type || !is_integral(element.properties[role].type))) role = end;
    soup_.offsets.reserve(element.count + 1);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      for (std::size_t i = 0; i < end; ++i) {
        if (i == list)
          read_polygon(element.properties[i]);
        else if (i == patch)
          soup_.patch_ids.push_back(read_patch_id(element.properties[i].type));
        else if (i == role)
          soup_.roles.push_back(static_cast<int>(rows_.value(element.properties[i].type)));
        else
          skip(element.properties[i]);
      }
      rows_.end_row();
    }
  }

  void read_polygon(const Ply_property& property) {
    const std::uint64_t length = list_length(property);
    for (std::uint64_t i = 0; i < length; ++i) {
      const double index = rows_.value(property.type);
      if (!is_integer(index) || index < 0 || index >= static_cast<double>(number_of_vertices_))
        rows_.fail("a facet has a corner that is none of the " + std::to_string(number_of_vertices_) + " vertices");
      soup_.corners.push_back(static_cast<Polygon_soup::Vertex>(index));
    }
    soup_.end_polygon();
  }

  int read_patch_id(Ply_type type) {
    const double id = rows_.value(type);
    if (!is_integer(id) || id < std::numeric_limits<int>::min() || id > std::numeric_limits<int>::max())
      rows_.fail("a patch_id is no integer of 32 bits");
    return static_cast<int>(id);
  }

  std::uint64_t list_length(const Ply_property& property) {
    const double length = rows_.value(*property.count_type);
    const std::size_t room = (rows_.remaining() + 1) / rows_.least_size(property.type);
    if (!is_integer(length) || length < 0 || length > static_cast<double>(room))
      rows_.fail("the rest of the file has no room for the list " + excerpt(property.name));
    return static_cast<std::uint64_t>(length);
  }

  void skip(const Ply_property& property) {
    const std::uint64_t length = property.count_type ? list_length(property) : 1;
    for (std::uint64_t i = 0; i < length; ++i) rows_.value(property.type);
  }

  void skip(const Ply_element& element) {
    for (std::uint64_t row = 0; row < element.count; ++row) {
      for (const Ply_property& property : element.properties) skip(property);
      rows_.end_row();
    }
  }

  const Ply_header* header_;
  Rows rows_;
  Polygon_soup soup_;
  std::uint64_t number_of_vertices_ = 0;
};

}  // namespace internal

/// Reads a PLY file: ascii or binary of either byte order, faces of any number of corners in a list `vertex_indices` or
/// `vertex_index`, patch ids in the face property `patch_id` and roles in `role`, both of any integer type. Other
/// elements and properties are passed over.
///
/// Returns `Status_code::unreadable_file` with the line (ascii) or the byte offset (binary) when the file is missing or
/// truncated, when its header lies about what follows, or when a corner is none of its vertices. A count never makes
/// it allocate more than a small multiple of the file's size. The topology is not looked at: `check_soup()` does.
inline Result<Polygon_soup> read_ply(const std::string& path) {
  return internal::guarded([&] {
    const internal::Input_file file = internal::load(path);
    const internal::Ply_header header = internal::parse_ply_header(file);
    if (header.format == internal::Ply_format::ascii)
      return internal::Ply_body(header, internal::Ply_text_rows(file, header)).read();
    return internal::Ply_body(header, internal::Ply_binary_rows(file, header)).read();
  });
}

}  // namespace CCSweep

#endif
