// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_CHECK_INPUT_H
#define CCSWEEP_PART_CHECK_INPUT_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/self_contact.h>
#include <CCSweep/part/shells.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

// Stands for the face patch map of a part without one.
struct No_patches {};

template <class FaceGraph, class VertexPointMap, class FacePatchMap>
class Input_checker {
 public:
  Input_checker(const FaceGraph& mesh, VertexPointMap points, FacePatchMap patches)
      : mesh_(mesh), points_(points), patches_(patches) {}

  void check() {
    if (faces(mesh_).begin() == faces(mesh_).end()) fail(Status_code::empty_mesh, Stage::input, "there are no facets");
    check_coordinates();
    collect_triangles();
    check_areas();
    check_closed();
    check_fans();
    number_corners();
    check_self_contact();
    check_shells();
  }

 private:
  using Traits = boost::graph_traits<FaceGraph>;
  using Face = typename Traits::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  using Corners = std::array<Point, 3>;
  using Place = std::array<double, 3>;

  void check_coordinates() const {
    for (auto v : vertices(mesh_)) {
      const Place p = place_of(get(points_, v));
      if (std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); })) continue;
      std::vector<int> patches;
      for (auto h : CGAL::halfedges_around_target(halfedge(v, mesh_), mesh_))
        if (!CGAL::is_border(h, mesh_)) add_patch(face(h, mesh_), patches);
      fail(Status_code::non_finite_coordinate, Stage::input, "a vertex has a coordinate that is no finite number",
           std::move(patches));
    }
  }

  void collect_triangles() {
    for (Face f : faces(mesh_)) {
      if (!CGAL::is_triangle(halfedge(f, mesh_), mesh_))
        refuse(Status_code::invalid_parameter, {f}, "a facet is no triangle", get(points_, first_corner(f)));
      Corners corners;
      std::size_t i = 0;
      for (auto v : CGAL::vertices_around_face(halfedge(f, mesh_), mesh_)) corners[i++] = get(points_, v);
      faces_.push_back(f);
      surface_.triangles.push_back(std::move(corners));
    }
  }

  void check_areas() const {
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto& [p, q, r] = surface_.triangles[i];
      if (Kernel().collinear_3_object()(p, q, r))
        refuse(Status_code::degenerate_facet, {faces_[i]}, "a facet has no area: its corners lie on one line",
               middle(surface_.triangles[i]));
    }
  }

  void check_closed() const {
    for (auto h : halfedges(mesh_)) {
      if (!CGAL::is_border(h, mesh_)) continue;
      const auto o = opposite(h, mesh_);
      const Place a = place_of(get(points_, source(h, mesh_))), b = place_of(get(points_, target(h, mesh_)));
      const Place place = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
      if (CGAL::is_border(o, mesh_)) fail(Status_code::not_manifold, Stage::input, "an edge has no facets", {}, place);
      refuse(Status_code::not_closed, {face(o, mesh_)}, "a facet has an edge without a neighbour: the surface is open",
             place);
    }
  }

  // All halfedges that lead to a vertex must be met on one walk around it.
  void check_fans() const {
    auto degree = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh_);
    for (auto v : vertices(mesh_)) put(degree, v, 0);
    for (auto h : halfedges(mesh_)) put(degree, target(h, mesh_), get(degree, target(h, mesh_)) + 1);
    for (auto v : vertices(mesh_)) {
      if (get(degree, v) == 0) continue;
      const auto start = halfedge(v, mesh_);
      std::size_t walked = 0;
      auto h = start;
      do {
        ++walked;
        h = opposite(next(h, mesh_), mesh_);
      } while (h != start && walked <= get(degree, v));
      if (walked != get(degree, v))
        refuse(Status_code::not_manifold, {face(start, mesh_)},
               "a vertex has several fans of facets; surfaces that touch in a point need a vertex each",
               get(points_, v));
    }
  }

  // Of a surface that is closed.
  void number_corners() {
    auto number_of_vertex = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), mesh_);
    auto number_of_edge = get(CGAL::dynamic_halfedge_property_t<std::uint32_t>(), mesh_);
    std::uint32_t vertex = 0, edge = 0;
    for (auto v : vertices(mesh_)) put(number_of_vertex, v, vertex++);
    for (Face f : faces_) {
      auto& corners = surface_.corners.emplace_back();
      auto h = next(halfedge(f, mesh_), mesh_);  // leaves the first corner
      for (std::uint32_t& corner : corners) {
        corner = get(number_of_vertex, source(h, mesh_));
        put(number_of_edge, h, edge++);
        h = next(h, mesh_);
      }
      surface_.patch.push_back(patch_of(f));
    }
    surface_.opposite.reserve(edge);
    for (Face f : faces_) {
      auto h = halfedge(f, mesh_);
      for (int i = 0; i < 3; ++i) {
        h = next(h, mesh_);
        surface_.opposite.push_back(get(number_of_edge, opposite(h, mesh_)));
      }
    }
  }

  void check_self_contact() const {
    const auto pair = find_self_contact<Kernel>(surface_);
    if (!pair) return;
    const Face f = faces_[pair->first], g = faces_[pair->second];
    refuse(Status_code::self_intersecting, {f, g}, "two facets meet elsewhere than in common vertices and edges",
           middle(surface_.triangles[pair->first]));
  }

  // A solid has one outward surface, and any number of inward ones within: its cavities.
  void check_shells() const {
    const std::vector<std::vector<std::size_t>> groups = connected_facets();
    std::vector<Shell<Kernel>> shells;
    for (const auto& group : groups) {
      std::vector<typename Kernel::Triangle_3> triangles;
      for (std::size_t i : group) {
        const auto& [p, q, r] = surface_.triangles[i];
        triangles.emplace_back(p, q, r);
      }
      shells.emplace_back(std::move(triangles));
    }
    std::size_t solids = 0, second_solid = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
      const std::size_t depth =
          static_cast<std::size_t>(std::count_if(shells.begin(), shells.end(), [&](const auto& other) {
            return &other != &shells[i] && other.contains(shells[i]);
          }));
      const CGAL::Sign wanted = depth % 2 == 0 ? CGAL::POSITIVE : CGAL::NEGATIVE;
      if (shells[i].orientation() != wanted)
        refuse(Status_code::not_oriented, {faces_[groups[i].front()]},
               depth % 2 == 0 ? "the surface is inside out: its facets turn clockwise seen from outside"
                              : "an inner surface is turned outward: it bounds no cavity",
               middle(surface_.triangles[groups[i].front()]));
      if (depth % 2 == 0 && ++solids == 2) second_solid = i;
    }
    if (solids > 1)
      refuse(Status_code::disjoint_solids, {faces_[groups[second_solid].front()]},
             "there are " + std::to_string(solids) + " solids: each is a job of its own",
             middle(surface_.triangles[groups[second_solid].front()]));
  }

  std::vector<std::vector<std::size_t>> connected_facets() const {
    std::vector<char> seen(faces_.size(), 0);
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t start = 0; start < faces_.size(); ++start) {
      if (seen[start]) continue;
      seen[start] = 1;
      std::vector<std::size_t> group = {start};
      for (std::size_t k = 0; k < group.size(); ++k)
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t neighbor = surface_.opposite[3 * group[k] + i] / 3;
          if (!seen[neighbor]) group.push_back(neighbor);
          seen[neighbor] = 1;
        }
      groups.push_back(std::move(group));
    }
    return groups;
  }

  typename Traits::vertex_descriptor first_corner(Face f) const { return target(halfedge(f, mesh_), mesh_); }

  static Place place_of(const Point& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
  static Place place_of(const Place& p) { return p; }

  static Place middle(const Corners& corners) {
    Place sum{};
    for (const Point& corner : corners) {
      const Place p = place_of(corner);
      for (std::size_t i = 0; i < 3; ++i) sum[i] += p[i] / 3;
    }
    return sum;
  }

  int patch_of([[maybe_unused]] Face f) const {
    if constexpr (std::is_same_v<FacePatchMap, No_patches>)
      return 0;
    else
      return static_cast<int>(get(patches_, f));
  }

  void add_patch([[maybe_unused]] Face f, [[maybe_unused]] std::vector<int>& patches) const {
    if constexpr (!std::is_same_v<FacePatchMap, No_patches>) {
      const int id = patch_of(f);
      const auto at = std::lower_bound(patches.begin(), patches.end(), id);
      if (at == patches.end() || *at != id) patches.insert(at, id);
    }
  }

  template <class P>
  [[noreturn]] void refuse(Status_code code, std::initializer_list<Face> facets, std::string reason,
                           const P& where) const {
    std::vector<int> patches;
    for (Face f : facets) add_patch(f, patches);
    const Place place = place_of(where);
    fail(code, Stage::input, std::move(reason), std::move(patches), place);
  }

  const FaceGraph& mesh_;
  VertexPointMap points_;
  FacePatchMap patches_;
  std::vector<Face> faces_;
  Triangle_surface<Kernel> surface_;  // of them, in the same order
};

}  // namespace internal

/// Tells whether a mesh is the boundary of one solid, as everything else takes for granted: finite coordinates, facets
/// with an area, no border, one fan at each vertex, no self-intersection, outward orientation. A solid may have
/// cavities (inward surfaces inside it); its surfaces may touch themselves and each other in vertices and edges with
/// the same coordinates. All decisions are exact.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`, its faces triangles
/// \tparam VertexPointMap a readable map from vertices to 3D points; the predicates of their kernel are used, which
/// must be exact
/// \tparam FacePatchMap a readable map from faces to patch ids
/// \returns `ok`, or the first defect with a place and the patches of the facets at fault: `empty_mesh`,
/// `non_finite_coordinate`, `invalid_parameter` (a facet is no triangle), `degenerate_facet`, `not_closed`,
/// `not_manifold`, `self_intersecting`, `not_oriented`, `disjoint_solids`
template <class FaceGraph, class VertexPointMap, class FacePatchMap>
Status check_input(const FaceGraph& mesh, VertexPointMap points, FacePatchMap patches) {
  return internal::guarded([&] {
           internal::Input_checker<FaceGraph, VertexPointMap, FacePatchMap>(mesh, points, patches).check();
           return true;
         })
      .status();
}

/// \overload
/// For a mesh without patches: the status names none.
template <class FaceGraph, class VertexPointMap>
Status check_input(const FaceGraph& mesh, VertexPointMap points) {
  return check_input(mesh, points, internal::No_patches{});
}

}  // namespace CCSweep

#endif
