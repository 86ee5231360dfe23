// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_TRIANGULATE_PLANE_H
#define CCSWEEP_VOLUMES_TRIANGULATE_PLANE_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep::internal {

using Triangle = std::array<std::uint32_t, 3>;
using Vertex_pair = std::pair<std::uint32_t, std::uint32_t>;

/// The two coordinates that a plane with a normal is drawn in, so that counter-clockwise stays so.
inline std::pair<int, int> chart_axes(const std::array<double, 3>& normal) {
  int drop = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(normal[i]) > std::abs(normal[drop])) drop = i;
  std::pair<int, int> axes{(drop + 1) % 3, (drop + 2) % 3};
  if (normal[drop] < 0) std::swap(axes.first, axes.second);
  return axes;
}

/// A planar region to be triangulated: closed polygons and curves inside, between numbered vertices.
template <class Traits>
struct Planar_region {
  std::vector<std::pair<std::uint32_t, typename Traits::Point_2>> points;  ///< in any order, and any number of times
  std::vector<Vertex_pair> boundary;  ///< each once; any number of loops
  std::vector<Vertex_pair> curves;
};

template <class Traits>
class Region_triangulation {
  struct Domain {
    int depth = -1;
  };
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Traits>;
  using Face_base = CGAL::Triangulation_face_base_with_info_2<Domain, Traits>;
  using Structure =
      CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Constrained_triangulation_face_base_2<Traits, Face_base>>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
      Traits, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;
  using Vertex_handle = typename Triangulation::Vertex_handle;

 public:
  /// The triangles, counter-clockwise; nothing where two vertices fall together or curves cross.
  /// \param fault is then set to a vertex near by
  static std::optional<std::vector<Triangle>> run(const Planar_region<Traits>& region,
                                                  std::uint32_t* fault = nullptr) {
    Region_triangulation t(region);
    auto result = t.insert(region) ? t.triangles(region) : std::nullopt;
    if (!result && fault) *fault = t.last_;
    return result;
  }

 private:
  using Numbered_point = std::pair<typename Traits::Point_2, std::uint32_t>;

  explicit Region_triangulation(const Planar_region<Traits>& region) {
    for (const auto& [v, p] : region.points) vertices_.push_back(v);
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    handles_.resize(vertices_.size());
  }

  // Where a vertex stands among those of the region.
  std::uint32_t place(std::uint32_t vertex) const {
    return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin());
  }

  bool insert(const Planar_region<Traits>& region) {
    std::vector<Numbered_point> points(vertices_.size());
    for (const auto& [v, p] : region.points) points[place(v)] = {p, place(v)};
    triangulation_.insert(points.begin(), points.end());
    for (auto v : triangulation_.finite_vertex_handles()) handles_[v->info()] = v;
    if (const auto missing = std::find(handles_.begin(), handles_.end(), Vertex_handle()); missing != handles_.end()) {
      last_ = vertices_[missing - handles_.begin()];
      return false;
    }
    try {
      for (const auto* list : {&region.boundary, &region.curves})
        for (const auto& [a, b] : *list) {
          last_ = a;
          triangulation_.insert_constraint(handles_[place(a)], handles_[place(b)]);
        }
    } catch (const typename Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    return true;
  }

  // Inside is what an odd number of boundary edges parts from the infinite face.
  std::optional<std::vector<Triangle>> triangles(const Planar_region<Traits>& region) {
    std::vector<Vertex_pair> boundary;
    for (const auto& [a, b] : region.boundary) boundary.push_back(std::minmax({place(a), place(b)}));
    std::sort(boundary.begin(), boundary.end());
    auto is_boundary = [&](auto face, int i) {
      if (!face->is_constrained(i)) return false;
      const auto v = face->vertex(triangulation_.cw(i)), w = face->vertex(triangulation_.ccw(i));
      return std::binary_search(boundary.begin(), boundary.end(), Vertex_pair(std::minmax(v->info(), w->info())));
    };
    std::vector<typename Triangulation::Face_handle> stack{triangulation_.infinite_face()};
    triangulation_.infinite_face()->info().depth = 0;
    while (!stack.empty()) {
      const auto f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto g = f->neighbor(i);
        const int depth = f->info().depth ^ int(is_boundary(f, i));
        if (g->info().depth < 0) {
          g->info().depth = depth;
          stack.push_back(g);
        } else if (g->info().depth != depth) {
          return std::nullopt;
        }
      }
    }
    std::vector<Triangle> result;
    for (auto f : triangulation_.finite_face_handles())
      if (f->info().depth == 1) {
        Triangle& t = result.emplace_back();
        for (int i = 0; i < 3; ++i) t[i] = vertices_[f->vertex(i)->info()];
      }
    for (Triangle& t : result) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(result.begin(), result.end());
    return result;
  }

  Triangulation triangulation_;
  std::vector<std::uint32_t> vertices_;  // of the region, ascending; those of the triangulation know their place here
  std::vector<Vertex_handle> handles_;
  std::uint32_t last_ = 0;  // the vertex that was worked on last
};

}  // namespace CCSweep::internal

#endif
