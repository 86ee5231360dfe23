// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_TRIANGULATE_SOUP_H
#define CCSWEEP_PART_TRIANGULATE_SOUP_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Polygon_soup.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

// Triangulates one polygon in the coordinate plane it covers most of. Dropping a coordinate is exact, so no triangle
// without area can arise from three corners on one line.
class Polygon_triangulator {
 public:
  using Triangle = std::array<Polygon_soup::Vertex, 3>;

  Polygon_triangulator(const Polygon_soup& soup, std::size_t facet) : soup_(soup), polygon_(soup.polygon(facet)) {
    const std::array<double, 3> normal = area_vector();
    const auto magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
    dropped_ = static_cast<std::size_t>(std::max_element(normal.begin(), normal.end(), magnitude) - normal.begin());
    looks_up_ = normal[dropped_] > 0;
  }

  // The triangles, or none when the outline crosses or touches itself in that plane.
  std::vector<Triangle> triangles() const {
    Cdt cdt;
    try {
      std::vector<Cdt::Vertex_handle> corners;
      for (Polygon_soup::Vertex v : polygon_) {
        corners.push_back(cdt.insert(flat(v)));
        corners.back()->info() = v;
      }
      if (cdt.number_of_vertices() != polygon_.size()) return {};
      for (std::size_t i = 0; i < corners.size(); ++i)
        cdt.insert_constraint(corners[i], corners[(i + 1) % corners.size()]);
    } catch (const Cdt::Intersection_of_constraints_exception&) {
      return {};
    }
    std::vector<Triangle> result = inner_triangles(cdt);
    if (result.size() != polygon_.size() - 2) result.clear();
    return result;
  }

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Polygon_soup::Vertex, Kernel>;
  using Structure =
      CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

  std::array<double, 3> area_vector() const {
    std::array<double, 3> sum{};
    const auto& origin = soup_.points[polygon_[0]];
    for (std::size_t i = 1; i + 1 < polygon_.size(); ++i) {
      const auto& p = soup_.points[polygon_[i]];
      const auto& q = soup_.points[polygon_[i + 1]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
        sum[k] += (p[x] - origin[x]) * (q[y] - origin[y]) - (p[y] - origin[y]) * (q[x] - origin[x]);
      }
    }
    return sum;
  }

  Kernel::Point_2 flat(Polygon_soup::Vertex v) const {
    const auto& p = soup_.points[v];
    return {p[(dropped_ + 1) % 3], p[(dropped_ + 2) % 3]};
  }

  // The triangles that a walk from outside enters through an odd number of constrained edges.
  std::vector<Triangle> inner_triangles(const Cdt& cdt) const {
    std::vector<Triangle> result;
    CGAL::Unique_hash_map<Cdt::Face_handle, int> side(-1);
    std::vector<Cdt::Face_handle> pending = {cdt.infinite_face()};
    side[pending.back()] = 0;
    while (!pending.empty()) {
      const Cdt::Face_handle face = pending.back();
      pending.pop_back();
      if (side[face] == 1)
        result.push_back({face->vertex(0)->info(), face->vertex(looks_up_ ? 1 : 2)->info(),
                          face->vertex(looks_up_ ? 2 : 1)->info()});
      for (int i = 0; i < 3; ++i) {
        const Cdt::Face_handle neighbor = face->neighbor(i);
        if (side[neighbor] >= 0) continue;
        side[neighbor] = cdt.is_constrained({face, i}) ? 1 - side[face] : side[face];
        pending.push_back(neighbor);
      }
    }
    return result;
  }

  const Polygon_soup& soup_;
  std::span<const Polygon_soup::Vertex> polygon_;
  std::size_t dropped_ = 2;
  bool looks_up_ = true;
};

}  // namespace internal

/// Replaces every polygon with more than three corners by triangles, which inherit its patch id. No vertex is added.
/// The triangles of one polygon stand where it stood.
///
/// The soup must have passed `check_soup()`. Returns `Status_code::self_intersecting` with the facet and its place when
/// a polygon's outline is not simple.
inline Result<Polygon_soup> triangulate_soup(Polygon_soup soup) {
  if (soup.corners.size() == 3 * soup.number_of_polygons()) return soup;
  return internal::guarded([&] {
    Polygon_soup result;
    for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
      const auto polygon = soup.polygon(f);
      std::vector<internal::Polygon_triangulator::Triangle> triangles;
      if (polygon.size() == 3)
        triangles.push_back({polygon[0], polygon[1], polygon[2]});
      else
        triangles = internal::Polygon_triangulator(soup, f).triangles();
      if (triangles.empty())
        internal::fail(Status_code::self_intersecting, Stage::input,
                       "facet " + std::to_string(f) + " (counted from 0) has an outline that crosses or touches itself",
                       soup.has_patch_ids() ? std::vector<int>{soup.patch_ids[f]} : std::vector<int>{},
                       soup.points[polygon[0]]);
      for (const auto& triangle : triangles) {
        result.corners.insert(result.corners.end(), triangle.begin(), triangle.end());
        result.end_polygon();
        if (soup.has_patch_ids()) result.patch_ids.push_back(soup.patch_ids[f]);
      }
    }
    result.points = std::move(soup.points);
    return result;
  });
}

}  // namespace CCSweep

#endif
