// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_READ_OFF_H
#define CCSWEEP_IO_READ_OFF_H

#include <CCSweep/IO/internal/input_file.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Polygon_soup.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace CCSweep {
namespace internal {

class Off_reader {
 public:
  explicit Off_reader(const Input_file& file) : cursor_(file) {}

  Polygon_soup read() {
    read_keyword();
    const std::size_t vertices = count("the number of vertices"), facets = count("the number of facets");
    cursor_.rest_of_line();  // the number of edges, which nobody fills in
    require_room(vertices, 6, "vertices");
    soup_.points.reserve(vertices);
    for (std::size_t v = 0; v < vertices; ++v) read_vertex();
    require_room(facets, 2, "facets");
    soup_.offsets.reserve(facets + 1);
    for (std::size_t f = 0; f < facets; ++f) read_facet();
    if (const auto surplus = token(); !surplus.empty())
      cursor_.fail("more data than the header announces: " + excerpt(surplus));
    return std::move(soup_);
  }

 private:
  // Normals, colours and texture coordinates follow the coordinates in their line and are passed over.
  void read_keyword() {
    const std::string_view keyword = token();
    for (const char* known : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STNOFF", "STCOFF", "STCNOFF"}) {
      if (keyword != known) continue;
      Text_cursor ahead = cursor_;
      if (ahead.token() == "BINARY") cursor_.fail("binary OFF files are not read");
      return;
    }
    cursor_.fail("an OFF file begins with OFF, not " + excerpt(keyword));
  }

  void read_vertex() {
    std::array<double, 3> point{};
    for (double& coordinate : point) coordinate = cursor_.number(token(), "a coordinate");
    soup_.points.push_back(point);
    cursor_.rest_of_line();
  }

  void read_facet() {
    const std::size_t corners = count("the number of corners");
    require_room(corners, 2, "corners");
    for (std::size_t i = 0; i < corners; ++i) {
      const std::size_t v = count("a corner");
      if (v >= soup_.points.size())
        cursor_.fail("a facet has corner " + std::to_string(v) + ", but there are " +
                     std::to_string(soup_.points.size()) + " vertices");
      soup_.corners.push_back(static_cast<Polygon_soup::Vertex>(v));
    }
    soup_.end_polygon();
    cursor_.rest_of_line();  // the colour
  }

  std::string_view token() { return cursor_.token_of_any_line('#'); }

  std::size_t count(const char* what) {
    const double value = cursor_.number(token(), what);
    if (!is_integer(value) || value < 0 || value >= std::numeric_limits<Polygon_soup::Vertex>::max())
      cursor_.fail(std::string(what) + " is not possible");
    return static_cast<std::size_t>(value);
  }

  void require_room(std::size_t count, std::size_t least, const char* what) const {
    if (count > (cursor_.remaining() + 1) / least)
      cursor_.fail("the rest of the file has no room for " + std::to_string(count) + " " + what);
  }

  Text_cursor cursor_;
  Polygon_soup soup_;
};

}  // namespace internal

/// Reads an ascii OFF file with facets of any number of corners: one vertex and one facet a line; what follows them in
/// their line (colours, normals) and comments are passed over.
///
/// Returns `Status_code::unreadable_file` with the line when the file is missing or truncated, when its counts lie, or
/// when a corner is none of its vertices. The topology is not looked at: `check_soup()` does.
inline Result<Polygon_soup> read_off(const std::string& path) {
  return internal::guarded([&] {
    const internal::Input_file file = internal::load(path);
    return internal::Off_reader(file).read();
  });
}

}  // namespace CCSweep

#endif
