// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_SURFACE_CUTTER_H
#define CCSWEEP_VOLUMES_SURFACE_CUTTER_H

#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Surface_location.h>
#include <CCSweep/volumes/Cut_surface.h>
#include <CCSweep/volumes/trace_path.h>
#include <CCSweep/volumes/triangulate_plane.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Draws curves on the part's surface and triangulates it anew where they run. A planar patch with curves inside is
/// triangulated as a whole from its boundary and its curves; elsewhere each facet that is met is, in its own plane, so
/// that the result lies on the input facets.
template <class Traits>
class Surface_cutter {
  using Part_type = Part<Traits>;
  using Point_2 = typename Traits::Point_2;
  using Point_3 = typename Traits::Point_3;
  using Face = typename Part_type::Face;
  using Edge = typename Part_type::Edge;
  using Mesh_vertex = typename Part_type::Vertex;
  using Halfedge = typename Part_type::Halfedge;
  using Kind = Surface_location::Kind;
  using Vertex = typename Cut_surface<Traits>::Vertex;

 public:
  /// \param nodes how many vertices may come to those of the part
  Surface_cutter(const Part_type& part, std::size_t nodes) : part_(part) {
    surface_.points.reserve(part.mesh.number_of_vertices() + nodes);
    for (auto v : part.mesh.vertices()) surface_.points.push_back(part.point(v));
  }

  /// The surface's vertex at a place; made where there is none yet.
  Vertex place(const Surface_location& where, const Point_3& point) {
    if (where.kind == Kind::vertex) return where.index;
    if (where.kind == Kind::edge) return place_on_edge(where, point);
    return add_vertex(where, point);
  }

  /// A vertex inside the solid.
  Vertex place_inside(const Point_3& point) { return add_vertex(Surface_location(), point); }

  /// Draws a curve from v to w; `normal` lies in the plane of the curve, `is_allowed` tells on which faces it runs.
  /// Returns false where no path was found.
  template <class Predicate>
  bool draw(Vertex v, Vertex w, const Vec3& normal, const Predicate& is_allowed) {
    if (v == w || surface_.path_between.count(std::minmax(v, w)) || !drawn_.insert(std::minmax(v, w)).second)
      return true;
    const auto locations =
        Path_tracer<Traits>::trace(part_, where(v), coordinates(v), where(w), coordinates(w), normal, is_allowed);
    if (!locations) return false;
    std::vector<Vertex> path{v};
    for (std::size_t i = 1; i + 1 < locations->size(); ++i)
      if (!is_inside_planar_patch((*locations)[i])) path.push_back(place(point_at((*locations)[i])));
    path.push_back(w);
    add_path(std::move(path));
    return true;
  }

  /// Draws a curve from v to w along edges of the part, past the vertices between.
  void draw_along_edges(Vertex v, Vertex w, const std::vector<Mesh_vertex>& between) {
    if (v == w || !drawn_.insert(std::minmax(v, w)).second) return;
    std::vector<Vertex> path{v};
    for (Mesh_vertex u : between) path.push_back(static_cast<Vertex>(u));
    path.push_back(w);
    add_path(std::move(path));
  }

  /// Draws a straight curve inside a planar patch.
  void draw_in_plane(Vertex v, Vertex w, Patch_index patch) {
    if (!drawn_.insert(std::minmax(v, w)).second || is_drawn_by_an_edge(v, w)) return;
    curves_of_patch_[patch].push_back({v, w});
  }

  Cut_surface<Traits> run() {
    sort_edges();
    find_met_faces();
    surface_.triangles.reserve(part_.mesh.number_of_faces());
    surface_.patch.reserve(part_.mesh.number_of_faces());
    for (std::size_t p = 0; p < part_.number_of_patches(); ++p) {
      const auto curves = curves_of_patch_.find(Patch_index(p));
      if (part_.planar[p] && curves != curves_of_patch_.end())
        triangulate_patch(Patch_index(p), curves->second);
      else
        for (Face f : part_.faces[p]) triangulate_face(f);
    }
    return std::move(surface_);
  }

 private:
  Vec3 coordinates(Vertex v) const { return Part_type::coordinates(surface_.points[v]); }

  Surface_location where(Vertex v) const {
    const std::size_t first = part_.mesh.number_of_vertices();
    return v < first ? Surface_location::vertex(v) : where_of_added_[v - first];
  }

  Vertex add_vertex(const Surface_location& where, const Point_3& point) {
    surface_.points.push_back(point);
    where_of_added_.push_back(where);
    return static_cast<Vertex>(surface_.points.size() - 1);
  }

  Vertex place_on_edge(const Surface_location& where, const Point_3& point) {
    auto& on_edge = on_edge_[where.index];
    const Halfedge h = part_.first_halfedge(Edge(where.index));
    const double length = norm(part_.coordinates(part_.mesh.target(h)) - part_.coordinates(part_.mesh.source(h)));
    const double near = 1e-10 * part_.diagonal;
    if (where.t * length <= near) return part_.mesh.source(h);
    if ((1 - where.t) * length <= near) return part_.mesh.target(h);
    for (const auto& [t, v] : on_edge)
      if (std::abs(t - where.t) * length <= near) return v;
    on_edge.push_back({where.t, add_vertex(where, point)});
    return on_edge.back().second;
  }

  Vertex place(const std::pair<Surface_location, Point_3>& at) { return place(at.first, at.second); }

  std::pair<Surface_location, Point_3> point_at(const Surface_location& where) const {
    if (where.kind == Kind::vertex) return {where, part_.point(Mesh_vertex(where.index))};
    return {where, point_on_edge(part_, Edge(where.index), where.t)};
  }

  // Such a place needs no vertex: the patch is triangulated anew as a whole.
  bool is_inside_planar_patch(const Surface_location& where) const {
    const auto& mesh = part_.mesh;
    const Halfedge first =
        where.kind == Kind::edge ? mesh.halfedge(Edge(where.index)) : mesh.halfedge(Mesh_vertex(where.index));
    const Patch_index patch = part_.patch(mesh.face(first));
    if (!part_.planar[patch.value()]) return false;
    if (where.kind == Kind::edge) return part_.patch(mesh.face(mesh.opposite(first))) == patch;
    for (Face f : mesh.faces_around_target(first))
      if (part_.patch(f) != patch) return false;
    return true;
  }

  // Edges inside a planar patch don't outlive its triangulation.
  bool is_drawn_by_an_edge(Vertex v, Vertex w) const {
    const Edge e = common_edge(part_, where(v), where(w));
    return e.is_valid() &&
           (part_.feature[e] || !part_.planar[part_.patch(part_.mesh.face(part_.mesh.halfedge(e))).value()]);
  }

  void add_path(std::vector<Vertex> path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (is_drawn_by_an_edge(path[i], path[i + 1])) continue;
      const Face f = common_face(path[i], path[i + 1]);
      if (f.is_valid())
        add_curve(f, path[i], path[i + 1]);
      else
        add_curve_in_common_patch(path[i], path[i + 1]);
    }
    if (path.size() > 2) surface_.path_between.emplace(std::minmax(path.front(), path.back()), std::move(path));
  }

  void add_curve(Face f, Vertex v, Vertex w) {
    const Patch_index patch = part_.patch(f);
    if (part_.planar[patch.value()])
      curves_of_patch_[patch].push_back({v, w});
    else
      curves_of_face_[f].push_back({v, w});
  }

  void add_curve_in_common_patch(Vertex v, Vertex w) {
    for (Face f : faces_at(part_, where(v)))
      for (Face g : faces_at(part_, where(w)))
        if (part_.patch(f) == part_.patch(g) && part_.planar[part_.patch(f).value()]) {
          curves_of_patch_[part_.patch(f)].push_back({v, w});
          return;
        }
    fail(Status_code::cut_failed, Stage::sub_volumes, "a curve leaves the surface", {}, coordinates(v));
  }

  Face common_face(Vertex v, Vertex w) const {
    const auto a = faces_at(part_, where(v)), b = faces_at(part_, where(w));
    for (Face f : a)
      if (std::find(b.begin(), b.end(), f) != b.end()) return f;
    return Face();
  }

  // Where nodes lie on edges or curves run.
  void find_met_faces() {
    is_met_.assign(part_.mesh.number_of_faces(), false);
    for (const auto& [e, on_edge] : on_edge_)
      for (Face f : faces_at(part_, Surface_location::edge(e, 0))) is_met_[f] = true;
    for (const auto& [f, curves] : curves_of_face_) is_met_[f] = true;
  }

  void sort_edges() {
    for (auto& [e, on_edge] : on_edge_) {
      std::sort(on_edge.begin(), on_edge.end());
      const Halfedge h = part_.first_halfedge(Edge(e));
      std::vector<Vertex> chain{part_.mesh.source(h)};
      for (const auto& [t, v] : on_edge) chain.push_back(v);
      chain.push_back(part_.mesh.target(h));
      for (const auto& [t, v] : on_edge) surface_.chain_of_vertex[v] = surface_.chains.size();
      surface_.path_between[std::minmax(chain.front(), chain.back())] = chain;
      surface_.chains.push_back(std::move(chain));
    }
  }

  std::vector<Vertex> along(Halfedge h) const {
    return surface_.path(part_.mesh.source(h), part_.mesh.target(h));
  }

  void add_boundary(Halfedge h, Planar_region<Traits>& region) const {
    const auto chain = along(h);
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) region.boundary.push_back({chain[i], chain[i + 1]});
  }

  void add_region(Planar_region<Traits>& region, const Vec3& normal, Patch_index patch) {
    const auto [x, y] = chart_axes(normal);
    for (const auto* list : {&region.boundary, &region.curves})
      for (const auto& [v, w] : *list)
        for (Vertex u : {v, w}) region.points.emplace_back(u, Point_2(surface_.points[u][x], surface_.points[u][y]));
    std::uint32_t fault = 0;
    const auto triangles = Region_triangulation<Traits>::run(region, &fault);
    if (!triangles)
      fail(Status_code::cut_failed, Stage::sub_volumes,
           "the curves on patch " + std::to_string(part_.id(patch)) + " cross or fall together", {part_.id(patch)},
           coordinates(fault));
    for (const Triangle& t : *triangles) add_triangle(t, patch);
  }

  void triangulate_patch(Patch_index patch, const std::vector<Vertex_pair>& curves) {
    Planar_region<Traits> region;
    region.curves = curves;
    for (Halfedge h : part_.border[patch.value()]) add_boundary(h, region);
    add_region(region, part_.normal[part_.largest_face[patch.value()]], patch);
  }

  void triangulate_face(Face f) {
    const auto& mesh = part_.mesh;
    const Halfedge h = mesh.halfedge(f);
    if (!is_met_[f]) {
      add_triangle({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}, part_.patch(f));
      return;
    }
    Planar_region<Traits> region;
    if (const auto curves = curves_of_face_.find(f); curves != curves_of_face_.end()) region.curves = curves->second;
    for (Halfedge side : mesh.halfedges_around_face(h)) add_boundary(side, region);
    add_region(region, part_.normal[f], part_.patch(f));
  }

  void add_triangle(const Triangle& t, Patch_index patch) {
    surface_.triangles.push_back(t);
    surface_.patch.push_back(patch);
  }

  const Part_type& part_;
  Cut_surface<Traits> surface_;
  std::vector<Surface_location> where_of_added_;  // by vertex of the surface, after those of the part
  std::map<std::uint32_t, std::vector<std::pair<double, Vertex>>> on_edge_;
  std::set<Vertex_pair> drawn_;
  std::map<Patch_index, std::vector<Vertex_pair>> curves_of_patch_;
  std::map<Face, std::vector<Vertex_pair>> curves_of_face_;
  std::vector<bool> is_met_;  // by face
};

}  // namespace CCSweep::internal

#endif
