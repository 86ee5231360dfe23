// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_READ_STL_H
#define CCSWEEP_IO_READ_STL_H

#include <CCSweep/IO/internal/input_file.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Polygon_soup.h>
#include <CCSweep/part/weld_by_fans.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CCSweep {
namespace internal {

inline void add_stl_corner(Polygon_soup& soup, const std::array<double, 3>& point) {
  soup.corners.push_back(static_cast<Polygon_soup::Vertex>(soup.points.size()));
  soup.points.push_back(point);
}

class Ascii_stl_reader {
 public:
  explicit Ascii_stl_reader(const Input_file& file) : cursor_(file) {}

  // One or several solids; their facets make up one part.
  Polygon_soup read() {
    expect("solid");
    while (true) {
      cursor_.rest_of_line();  // the name, which may be any text
      std::string_view keyword = token();
      for (; is(keyword, "facet"); keyword = token()) read_facet();
      require(keyword, "endsolid");
      cursor_.rest_of_line();
      const std::string_view another = token();
      if (another.empty()) return std::move(soup_);
      require(another, "solid");
    }
  }

 private:
  void read_facet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) token();  // the normal follows from the corners
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      std::array<double, 3> point{};
      for (double& coordinate : point) coordinate = cursor_.number(token(), "a coordinate");
      add_stl_corner(soup_, point);
    }
    soup_.end_polygon();
    expect("endloop");
    expect("endfacet");
  }

  std::string_view token() { return cursor_.token_of_any_line(); }

  static bool is(std::string_view token, std::string_view keyword) {
    return std::equal(token.begin(), token.end(), keyword.begin(), keyword.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
  }

  void expect(const char* keyword) { require(token(), keyword); }

  void require(std::string_view token, const char* keyword) const {
    if (!is(token, keyword))
      cursor_.fail(token.empty() ? "ends where '" + std::string(keyword) + "' is expected"
                                 : "'" + std::string(keyword) + "' is expected, not " + excerpt(token));
  }

  Text_cursor cursor_;
  Polygon_soup soup_;
};

constexpr std::size_t stl_header_size = 84;
constexpr std::size_t stl_facet_size = 50;

inline std::uint32_t little_endian_word(const std::string& data, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(data[offset + i]);
  return word;
}

inline std::uint64_t binary_stl_size(const Input_file& file) {
  return stl_header_size + stl_facet_size * std::uint64_t{little_endian_word(file.data, 80)};
}

inline Polygon_soup read_binary_stl(const Input_file& file) {
  if (file.data.size() != binary_stl_size(file))
    file.fail("byte 80: the header announces " + std::to_string(little_endian_word(file.data, 80)) +
              " facets, which take " + std::to_string(binary_stl_size(file)) + " bytes, but the file has " +
              std::to_string(file.data.size()));
  Polygon_soup soup;
  for (std::size_t facet = stl_header_size; facet < file.data.size(); facet += stl_facet_size) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<double, 3> point{};
      for (std::size_t i = 0; i < 3; ++i)
        point[i] = std::bit_cast<float>(little_endian_word(file.data, facet + 12 * (corner + 1) + 4 * i));
      add_stl_corner(soup, point);
    }
    soup.end_polygon();
  }
  return soup;
}

// Binary files may begin with "solid" too: the size decides first, then whether the beginning is text.
inline bool is_ascii_stl(const Input_file& file) {
  const bool says_solid = file.data.compare(0, 5, "solid") == 0 || file.data.compare(0, 5, "SOLID") == 0;
  if (file.data.size() < stl_header_size) {
    if (!says_solid) file.fail("is no STL file: it is shorter than the header of one");
    return true;
  }
  if (file.data.size() == binary_stl_size(file)) return false;
  return says_solid && file.data.substr(0, 512).find('\0') == std::string::npos;
}

}  // namespace internal

/// Reads an STL file, ascii or binary, and welds its facets by exactly equal coordinates (`weld_by_fans()`). Normals,
/// names and attribute bytes are passed over.
///
/// Returns `Status_code::unreadable_file` with the line (ascii) or the byte offset (binary) when the file is missing or
/// truncated or when its count lies. The topology is not looked at: `check_soup()` does.
inline Result<Polygon_soup> read_stl(const std::string& path) {
  return internal::guarded([&] {
    const internal::Input_file file = internal::load(path);
    return weld_by_fans(internal::is_ascii_stl(file) ? internal::Ascii_stl_reader(file).read()
                                                     : internal::read_binary_stl(file));
  });
}

}  // namespace CCSweep

#endif
