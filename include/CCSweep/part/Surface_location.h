// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_SURFACE_LOCATION_H
#define CCSWEEP_PART_SURFACE_LOCATION_H

#include <CCSweep/part/Part.h>

#include <compare>
#include <cstdint>
#include <vector>

namespace CCSweep {

/// Where a node lies on the part's surface, or that it lies inside.
struct Surface_location {
  enum class Kind : std::uint8_t { interior, vertex, edge, face };

  Kind kind = Kind::interior;
  std::uint32_t index = 0;  ///< of the vertex, edge or face
  double t = 0;             ///< on an edge: the fraction from the source of its first halfedge

  static Surface_location vertex(std::uint32_t v) { return {Kind::vertex, v, 0}; }
  static Surface_location edge(std::uint32_t e, double t) { return {Kind::edge, e, t}; }
  static Surface_location face(std::uint32_t f) { return {Kind::face, f, 0}; }

  bool on_surface() const { return kind != Kind::interior; }
  bool on_edge(std::uint32_t e) const { return kind == Kind::edge && index == e; }
  /// A number for the vertex, edge or face.
  std::uint64_t key() const { return 4 * std::uint64_t(index) + std::uint64_t(kind); }
  bool same_place(const Surface_location& other) const {
    return on_surface() && kind != Kind::face && kind == other.kind && index == other.index;
  }
};

namespace internal {

/// The point at fraction t from a to b; exactly on the segment when the number type is exact.
template <class Point>
Point point_between(const Point& a, const Point& b, double t) {
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  return t == 0 ? a : t == 1 ? b : a + FT(t) * (b - a);
}

template <class Traits>
typename Traits::Point_3 point_on_edge(const Part<Traits>& part, typename Part<Traits>::Edge e, double t) {
  const auto h = part.first_halfedge(e);
  return point_between(part.point(part.mesh.source(h)), part.point(part.mesh.target(h)), t);
}

/// The coordinates of a vertex or of a place on an edge.
template <class Traits>
Vec3 coordinates(const Part<Traits>& part, const Surface_location& where) {
  if (where.kind == Surface_location::Kind::vertex)
    return part.coordinates(typename Part<Traits>::Vertex(where.index));
  return Part<Traits>::coordinates(point_on_edge(part, typename Part<Traits>::Edge(where.index), where.t));
}

/// The faces that meet at a place.
template <class Traits>
std::vector<typename Part<Traits>::Face> faces_at(const Part<Traits>& part, const Surface_location& where) {
  using Kind = Surface_location::Kind;
  const auto& mesh = part.mesh;
  std::vector<typename Part<Traits>::Face> faces;
  if (where.kind == Kind::face) faces.emplace_back(where.index);
  if (where.kind == Kind::edge) {
    const auto h = mesh.halfedge(typename Part<Traits>::Edge(where.index));
    faces = {mesh.face(h), mesh.face(mesh.opposite(h))};
  }
  if (where.kind == Kind::vertex)
    for (auto f : mesh.faces_around_target(mesh.halfedge(typename Part<Traits>::Vertex(where.index))))
      faces.push_back(f);
  return faces;
}

/// The edge of the part that both places lie on, if any.
template <class Traits>
typename Part<Traits>::Edge common_edge(const Part<Traits>& part, const Surface_location& a,
                                        const Surface_location& b) {
  using Kind = Surface_location::Kind;
  using Edge = typename Part<Traits>::Edge;
  using Vertex = typename Part<Traits>::Vertex;
  auto ends_in = [&](Edge e, const Surface_location& where) {
    const auto h = part.first_halfedge(e);
    return Vertex(where.index) == part.mesh.source(h) || Vertex(where.index) == part.mesh.target(h);
  };
  if (a.kind == Kind::edge)
    return b.on_edge(a.index) || (b.kind == Kind::vertex && ends_in(Edge(a.index), b)) ? Edge(a.index) : Edge();
  if (a.kind != Kind::vertex) return Edge();
  if (b.kind == Kind::edge) return ends_in(Edge(b.index), a) ? Edge(b.index) : Edge();
  if (b.kind != Kind::vertex || a.index == b.index) return Edge();
  const auto h = part.mesh.halfedge(Vertex(a.index), Vertex(b.index));
  return h.is_valid() ? part.mesh.edge(h) : Edge();
}

/// The fraction at which a place that lies on an edge, or at its end, does so.
template <class Traits>
double fraction_on_edge(const Part<Traits>& part, typename Part<Traits>::Edge e, const Surface_location& where) {
  if (where.on_edge(e)) return where.t;
  return typename Part<Traits>::Vertex(where.index) == part.mesh.source(part.first_halfedge(e)) ? 0 : 1;
}

}  // namespace internal
}  // namespace CCSweep

#endif
