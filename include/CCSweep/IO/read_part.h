// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_READ_PART_H
#define CCSWEEP_IO_READ_PART_H

#include <CCSweep/IO/read_off.h>
#include <CCSweep/IO/read_ply.h>
#include <CCSweep/IO/read_stl.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Polygon_soup.h>
#include <CCSweep/part/Tagged_mesh.h>
#include <CCSweep/part/check_soup.h>
#include <CCSweep/part/detect_patches.h>
#include <CCSweep/part/triangulate_soup.h>
#include <CCSweep/part/weld_by_fans.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {

/// How `read_part()` reads.
struct Read_options {
  bool detect_patches = true;  ///< make patches from the dihedral angles when the file has no patch ids
  double angle = 30;           ///< two neighbours that turn by more than this, in degrees, belong to different patches
};

/// Reads the polygons of a file, its format told by the ending of its name: `.ply`, `.off` or `.stl`.
/// Returns `Status_code::unreadable_file` on failure, see `read_ply()`, `read_off()`, `read_stl()`.
inline Result<Polygon_soup> read_soup(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".ply") return read_ply(path);
  if (ending == ".off") return read_off(path);
  if (ending == ".stl") return read_stl(path);
  return Status{
      Status_code::unreadable_file, Stage::input, {}, {}, path + ": the name of a part ends in .ply, .off or .stl"};
}

namespace internal {

// The mesh of a triangle soup that has passed check_soup().
template <class Point>
Tagged_mesh<Point> make_mesh(const Polygon_soup& soup) {
  Tagged_mesh<Point> result;
  using Mesh = typename Tagged_mesh<Point>::Mesh;
  using Vertex = typename Mesh::Vertex_index;
  auto patches = result.patch_ids();
  const std::size_t n = soup.number_of_polygons();
  result.mesh.reserve(n / 2 + 2, n / 2 * 3, n);
  std::vector<Vertex> vertices(soup.points.size(), Mesh::null_vertex());
  for (std::size_t f = 0; f < n; ++f) {
    const auto corners = soup.polygon(f);
    for (Polygon_soup::Vertex v : corners)
      if (vertices[v] == Mesh::null_vertex())
        vertices[v] = result.mesh.add_vertex(Point(soup.points[v][0], soup.points[v][1], soup.points[v][2]));
    const auto face = result.mesh.add_face(vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]);
    if (face == Mesh::null_face())
      fail(Status_code::not_manifold, Stage::input, "facet " + std::to_string(f) + " does not fit to its neighbours",
           {}, soup.points[corners[0]]);
    if (soup.has_patch_ids()) patches[face] = soup.patch_ids[f];
  }
  return result;
}

inline bool is_triangulated(const Polygon_soup& soup) { return soup.corners.size() == 3 * soup.number_of_polygons(); }

// Fails with the status of a step, the file named in its reason.
inline void require(Status status, const std::string& path) {
  if (status.ok()) return;
  if (status.reason.rfind(path, 0) != 0) status.reason = path + ": " + status.reason;
  throw Failure{std::move(status)};
}

template <class T>
T take(Result<T> result, const std::string& path) {
  require(result.status(), path);
  return std::move(result).value();
}

}  // namespace internal

/// Reads a part: the file's polygons are checked (`check_soup()`), triangulated, and get patch ids by their dihedral
/// angles (`detect_patches()`) unless the file brings them.
///
/// Where the surface only touches itself, in an edge or a vertex that its sheets share in the file, each sheet gets
/// vertices of its own (`weld_by_fans()`).
///
/// What needs geometry (inside out, self-intersection, several solids) is not checked here: `check_input()` does.
///
/// \tparam Point a 3D point of any kernel whose points can be made from three doubles
/// \returns the mesh, or one of: `unreadable_file`; the codes of `check_soup()`; `self_intersecting` (a facet that is
/// no simple polygon); `missing_patch_ids` (the file has none, and they are not to be detected); `invalid_parameter`
/// (the angle is not between 0 and 180). The reason begins with the path.
template <class Point>
Result<Tagged_mesh<Point>> read_part(const std::string& path, const Read_options& options = {}) {
  return internal::guarded([&] {
    if (!(options.angle > 0 && options.angle < 180))
      internal::fail(Status_code::invalid_parameter, Stage::input,
                     "the dihedral angle must lie between 0 and 180 degrees");
    Polygon_soup soup = internal::take(read_soup(path), path);
    if (!soup.has_patch_ids() && !options.detect_patches)
      internal::fail(Status_code::missing_patch_ids, Stage::input, path + ": the facets carry no patch ids");
    Status status = check_soup(soup);
    if (status.ok() && !internal::is_triangulated(soup)) {
      soup = internal::take(triangulate_soup(std::move(soup)), path);
      status = check_soup(soup);  // two diagonals may have fallen on the same edge
    }
    if (status.code == Status_code::not_manifold && internal::is_triangulated(soup)) {
      Polygon_soup apart = weld_by_fans(soup);
      if (check_soup(apart).ok()) {
        soup = std::move(apart);
        status = Status();
      }
    }
    internal::require(status, path);
    Tagged_mesh<Point> part = internal::make_mesh<Point>(soup);
    if (!soup.has_patch_ids()) detect_patches(part.mesh, part.mesh.points(), part.patch_ids(), options.angle);
    return part;
  });
}

}  // namespace CCSweep

#endif
