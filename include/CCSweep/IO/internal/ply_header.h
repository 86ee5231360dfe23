// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_INTERNAL_PLY_HEADER_H
#define CCSWEEP_IO_INTERNAL_PLY_HEADER_H

#include <CCSweep/IO/internal/input_file.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CCSweep::internal {

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

inline std::size_t size_of(Ply_type type) {
  constexpr std::array<std::size_t, 10> sizes = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

inline bool is_integral(Ply_type type) { return type != Ply_type::float32 && type != Ply_type::float64; }

inline std::optional<Ply_type> ply_type(std::string_view name) {
  struct Entry {
    std::string_view name, alias;
    Ply_type type;
  };
  static constexpr std::array<Entry, 10> entries = {{{"char", "int8", Ply_type::int8},
                                                     {"uchar", "uint8", Ply_type::uint8},
                                                     {"short", "int16", Ply_type::int16},
                                                     {"ushort", "uint16", Ply_type::uint16},
                                                     {"int", "int32", Ply_type::int32},
                                                     {"uint", "uint32", Ply_type::uint32},
                                                     {"long", "int64", Ply_type::int64},
                                                     {"ulong", "uint64", Ply_type::uint64},
                                                     {"float", "float32", Ply_type::float32},
                                                     {"double", "float64", Ply_type::float64}}};
  for (const Entry& entry : entries)
    if (name == entry.name || name == entry.alias) return entry.type;
  return std::nullopt;
}

struct Ply_property {
  std::string name;
  Ply_type type = Ply_type::int32;
  std::optional<Ply_type> count_type;  // of a list
};

struct Ply_element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Ply_property> properties;

  // Index of the property of that name, or the number of properties.
  std::size_t find(std::string_view property) const {
    const auto it = std::find_if(properties.begin(), properties.end(),
                                 [&](const Ply_property& candidate) { return candidate.name == property; });
    return static_cast<std::size_t>(it - properties.begin());
  }
};

enum class Ply_format { ascii, binary_little_endian, binary_big_endian };

struct Ply_header {
  Ply_format format = Ply_format::ascii;
  std::vector<Ply_element> elements;
  std::size_t body = 0;       // byte offset of what follows the header
  std::size_t body_line = 1;  // and its line

  const Ply_element* find(std::string_view name) const {
    for (const Ply_element& element : elements)
      if (element.name == name) return &element;
    return nullptr;
  }
};

inline Ply_format parse_ply_format(Text_cursor& cursor) {
  const std::string_view format = cursor.token(), version = cursor.token();
  if (version != "1.0") cursor.fail("PLY version 1.0 is expected, not " + excerpt(version));
  if (format == "ascii") return Ply_format::ascii;
  if (format == "binary_little_endian") return Ply_format::binary_little_endian;
  if (format == "binary_big_endian") return Ply_format::binary_big_endian;
  cursor.fail("unknown PLY format " + excerpt(format));
}

inline Ply_element parse_ply_element(Text_cursor& cursor) {
  Ply_element element;
  element.name = cursor.token();
  const std::string_view count = cursor.token();
  const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (element.name.empty() || count.empty() || error != std::errc() || stop != count.data() + count.size())
    cursor.fail("an element has a name and a number, not " + excerpt(element.name) + " " + excerpt(count));
  return element;
}

inline Ply_property parse_ply_property(Text_cursor& cursor) {
  const auto type = [&](std::string_view token) {
    const auto known = ply_type(token);
    if (!known) cursor.fail("unknown type " + excerpt(token));
    return *known;
  };
  Ply_property property;
  std::string_view token = cursor.token();
  if (token == "list") {
    property.count_type = type(cursor.token());
    if (!is_integral(*property.count_type)) cursor.fail("the length of a list must be an integer");
    token = cursor.token();
  }
  property.type = type(token);
  property.name = cursor.token();
  if (property.name.empty()) cursor.fail("a property needs a name");
  return property;
}

inline Ply_header parse_ply_header(const Input_file& file) {
  Text_cursor cursor(file);
  if (cursor.rest_of_line() != "ply") file.fail("is no PLY file: its first line is not 'ply'");
  Ply_header header;
  bool has_format = false;
  while (true) {
    if (cursor.remaining() == 0) cursor.fail("the file ends within its header");
    const std::string_view keyword = cursor.token();
    if (keyword == "format") {
      header.format = parse_ply_format(cursor);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(parse_ply_element(cursor));
    } else if (keyword == "property") {
      if (header.elements.empty()) cursor.fail("a property stands before any element");
      Ply_property property = parse_ply_property(cursor);
      Ply_element& element = header.elements.back();
      if (element.find(property.name) != element.properties.size())
        cursor.fail("property " + excerpt(property.name) + " is there twice");
      element.properties.push_back(std::move(property));
    } else if (keyword == "end_header") {
      break;
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      cursor.fail("unknown keyword " + excerpt(keyword) + " in the header");
    }
    cursor.rest_of_line();
  }
  if (!has_format) cursor.fail("the header names no format");
  cursor.rest_of_line();
  header.body = cursor.position();
  header.body_line = cursor.line();
  return header;
}

}  // namespace CCSweep::internal

#endif
