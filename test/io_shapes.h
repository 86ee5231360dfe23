// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_IO_SHAPES_H
#define CCSWEEP_TEST_IO_SHAPES_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/round_to_double.h>
#include <CCSweep/part/Polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <ostream>
#include <random>
#include <string>
#include <vector>

// Small soups, and the files that hold them.
namespace shapes {

using CCSweep::Polygon_soup;
using Vertex = Polygon_soup::Vertex;
using Xyz = std::array<double, 3>;
using Part = CCSweep::Tagged_mesh<CCSweep::Double_point>;

inline void add_polygon(Polygon_soup& soup, std::initializer_list<Vertex> corners, int patch) {
  soup.corners.insert(soup.corners.end(), corners);
  soup.end_polygon();
  soup.patch_ids.push_back(patch);
}

// A box of six quads with the patches 0 (bottom), 1 (top), 2, 3, 4, 5.
inline Polygon_soup box(const Xyz& low, const Xyz& high) {
  Polygon_soup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.push_back({i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
  add_polygon(soup, {0, 2, 3, 1}, 0);
  add_polygon(soup, {4, 5, 7, 6}, 1);
  add_polygon(soup, {0, 1, 5, 4}, 2);
  add_polygon(soup, {2, 6, 7, 3}, 3);
  add_polygon(soup, {0, 4, 6, 2}, 4);
  add_polygon(soup, {1, 3, 7, 5}, 5);
  return soup;
}

inline Polygon_soup cube() { return box({0, 0, 0}, {1, 1, 1}); }

inline Polygon_soup triangulated(const Polygon_soup& soup) { return CCSweep::triangulate_soup(soup).value(); }

inline Polygon_soup inside_out(Polygon_soup soup) {
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f)
    std::reverse(soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.offsets[f]),
                 soup.corners.begin() + static_cast<std::ptrdiff_t>(soup.offsets[f + 1]));
  return soup;
}

// Both, with vertices of their own.
inline Polygon_soup both(Polygon_soup a, const Polygon_soup& b) {
  const auto shift = static_cast<Vertex>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (std::size_t f = 0; f < b.number_of_polygons(); ++f) {
    for (Vertex v : b.polygon(f)) a.corners.push_back(v + shift);
    a.end_polygon();
    a.patch_ids.push_back(b.patch_ids[f]);
  }
  return a;
}

// Equal points become one vertex, whatever comes of it.
inline Polygon_soup merged(Polygon_soup soup) {
  for (Vertex& v : soup.corners)
    v = static_cast<Vertex>(std::find(soup.points.begin(), soup.points.end(), soup.points[v]) - soup.points.begin());
  return soup;
}

// A plate that carries two cubes which touch in a vertical edge; the solids are one.
inline Polygon_soup bosses_that_touch() {
  Polygon_soup soup;
  // 0..8: the grid on top of the plate; 9..12: corners of its bottom.
  for (double y : {0.0, 1.0, 2.0})
    for (double x : {0.0, 1.0, 2.0}) soup.points.push_back({x, y, 1});
  for (double y : {0.0, 2.0})
    for (double x : {0.0, 2.0}) soup.points.push_back({x, y, 0});
  for (const auto& p : std::initializer_list<Xyz>{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 1, 2}})  // 13..16
    soup.points.push_back(p);
  for (const auto& p : std::initializer_list<Xyz>{{1, 1, 2}, {2, 1, 2}, {1, 2, 2}, {2, 2, 2}})  // 17..20
    soup.points.push_back(p);
  add_polygon(soup, {9, 11, 12, 10}, 0);
  add_polygon(soup, {0, 9, 10, 2, 1}, 1);
  add_polygon(soup, {8, 12, 11, 6, 7}, 2);
  add_polygon(soup, {6, 11, 9, 0, 3}, 3);
  add_polygon(soup, {2, 10, 12, 8, 5}, 4);
  add_polygon(soup, {1, 2, 5, 4}, 5);
  add_polygon(soup, {3, 4, 7, 6}, 6);
  add_polygon(soup, {13, 14, 16, 15}, 7);
  add_polygon(soup, {0, 1, 14, 13}, 8);
  add_polygon(soup, {0, 13, 15, 3}, 9);
  add_polygon(soup, {17, 18, 20, 19}, 12);
  add_polygon(soup, {5, 8, 20, 18}, 13);
  add_polygon(soup, {7, 19, 20, 8}, 14);
  // Around the common edge: its foot is one vertex, as one walk over walls and floors leads around it; its top is two.
  add_polygon(soup, {1, 4, 16, 14}, 10);
  add_polygon(soup, {4, 3, 15, 16}, 11);
  add_polygon(soup, {4, 5, 18, 17}, 15);
  add_polygon(soup, {7, 4, 17, 19}, 16);
  return soup;
}

inline std::string number(double x) {
  std::string text;
  CCSweep::internal::append_text(text, x);
  return text;
}

inline std::string ply_header(const Polygon_soup& soup, const std::string& format, bool has_ids = true) {
  return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " +
         std::to_string(soup.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(soup.number_of_polygons()) + "\nproperty list uchar int vertex_indices\n" +
         (has_ids ? "property int patch_id\n" : "") + "end_header\n";
}

inline std::string ascii_ply(const Polygon_soup& soup, bool has_ids = true) {
  std::string text = ply_header(soup, "ascii", has_ids);
  for (const Xyz& p : soup.points) text += number(p[0]) + " " + number(p[1]) + " " + number(p[2]) + "\n";
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    text += std::to_string(soup.polygon(f).size());
    for (Vertex v : soup.polygon(f)) text += " " + std::to_string(v);
    text += (has_ids ? " " + std::to_string(soup.patch_ids[f]) : std::string()) + "\n";
  }
  return text;
}

template <class T>
void append_bytes(std::string& out, T value, bool is_big) {
  CCSweep::internal::append_little_endian(out, value);
  if (is_big) std::reverse(out.end() - sizeof(T), out.end());
}

inline std::string binary_ply(const Polygon_soup& soup, bool is_big = false) {
  std::string out = ply_header(soup, is_big ? "binary_big_endian" : "binary_little_endian");
  for (const Xyz& p : soup.points)
    for (double x : p) append_bytes(out, x, is_big);
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    append_bytes(out, static_cast<std::uint8_t>(soup.polygon(f).size()), is_big);
    for (Vertex v : soup.polygon(f)) append_bytes(out, static_cast<std::int32_t>(v), is_big);
    append_bytes(out, static_cast<std::int32_t>(soup.patch_ids[f]), is_big);
  }
  return out;
}

inline std::string off(const Polygon_soup& soup) {
  std::string text = "OFF\n# made by a test\n" + std::to_string(soup.points.size()) + " " +
                     std::to_string(soup.number_of_polygons()) + " 0\n";
  for (const Xyz& p : soup.points) text += number(p[0]) + " " + number(p[1]) + " " + number(p[2]) + "\n";
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    text += std::to_string(soup.polygon(f).size());
    for (Vertex v : soup.polygon(f)) text += " " + std::to_string(v);
    text += " 255 0 0\n";
  }
  return text;
}

inline std::string ascii_stl(const Polygon_soup& triangles) {
  std::string text = "solid a part of a test\n";
  for (std::size_t f = 0; f < triangles.number_of_polygons(); ++f) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (Vertex v : triangles.polygon(f)) {
      const Xyz& p = triangles.points[v];
      text += "  vertex " + number(p[0]) + " " + number(p[1]) + " " + number(p[2]) + "\n";
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid a part of a test\n";
}

inline std::string binary_stl(const Polygon_soup& triangles) {
  std::string out = "solid in spite of this word it is binary";
  out.resize(80);
  append_bytes(out, static_cast<std::uint32_t>(triangles.number_of_polygons()), false);
  for (std::size_t f = 0; f < triangles.number_of_polygons(); ++f) {
    out.append(12, '\0');
    for (Vertex v : triangles.polygon(f))
      for (double x : triangles.points[v]) append_bytes(out, static_cast<float>(x), false);
    out.append(2, '\0');
  }
  return out;
}

// A folder that goes with the test.
class Scratch {
 public:
  Scratch()
      : folder_(std::filesystem::temp_directory_path() / ("ccsweep_test_" + std::to_string(std::random_device()()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& content) const {
    std::filesystem::remove(path(name));  // some file systems wait for the disk when a file is written over
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  CCSweep::Result<Part> read(const std::string& name, const std::string& content,
                             const CCSweep::Read_options& options = {}) const {
    return CCSweep::read_part<CCSweep::Double_point>(write(name, content), options);
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  std::filesystem::path folder_;
};

// A mesh as a sorted list of facets, each with its patch: equal for equal surfaces, however they are stored.
struct Facet {
  std::array<Xyz, 3> corners;
  int patch;
  auto operator<=>(const Facet&) const = default;
};

inline std::vector<Facet> facets(const Part& part) {
  std::vector<Facet> result;
  const auto patches = part.patch_ids();
  for (auto f : part.mesh.faces()) {
    Facet facet{{}, patches[f]};
    std::size_t i = 0;
    for (auto v : CGAL::vertices_around_face(part.mesh.halfedge(f), part.mesh))
      facet.corners[i++] = CCSweep::internal::file_point(part.mesh.point(v));
    std::rotate(facet.corners.begin(), std::min_element(facet.corners.begin(), facet.corners.end()),
                facet.corners.end());
    result.push_back(facet);
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline std::size_t number_of_patches(const Part& part) {
  std::vector<int> ids;
  for (auto f : part.mesh.faces()) ids.push_back(part.patch_ids()[f]);
  std::sort(ids.begin(), ids.end());
  return static_cast<std::size_t>(std::unique(ids.begin(), ids.end()) - ids.begin());
}

}  // namespace shapes

namespace CCSweep {
// For the messages of Boost.Test.
inline std::ostream& operator<<(std::ostream& out, Status_code code) { return out << name(code); }
}  // namespace CCSweep

#endif
