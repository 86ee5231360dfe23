// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_MANIFOLD_H
#define CCSWEEP_INTERNAL_VERIFY_MANIFOLD_H

#include <CCSweep/internal/verify_scene.h>

#include <tuple>

namespace CCSweep::internal::verification {

inline std::uint32_t next_halfedge(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline std::uint32_t previous_halfedge(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// No triangle without area, by an exact predicate.
template <class Kernel>
void check_triangles(const Scene<Kernel>& scene, const Surface& surface) {
  for (std::size_t t = 0; t < surface.points.size(); ++t) {
    const Triple& p = surface.points[t];
    if (CGAL::collinear(scene.points[p[0]], scene.points[p[1]], scene.points[p[2]]))
      reject(surface.title + " has a triangle without area", {surface.patch[t]}, scene.place(p));
  }
}

/// Pairs the halfedges: every directed edge once, and its opposite once.
template <class Kernel>
void check_closed(const Scene<Kernel>& scene, Surface& surface) {
  using Directed = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;  // from, to, halfedge
  std::vector<Directed> edges;
  const auto& triangles = surface.vertices;
  for (std::uint32_t h = 0; h < 3 * triangles.size(); ++h)
    edges.emplace_back(triangles[h / 3][h % 3], triangles[h / 3][next_halfedge(h) % 3], h);
  std::sort(edges.begin(), edges.end());
  surface.opposite.resize(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [from, to, h] = edges[i];
    auto fail_at = [&, h = h](const char* what) {
      reject(surface.title + what, {surface.patch[h / 3]}, scene.place(surface.points[h / 3][h % 3]));
    };
    if (i > 0 && std::get<0>(edges[i - 1]) == from && std::get<1>(edges[i - 1]) == to)
      fail_at(" has an edge with more than two triangles, or neighbours that are oriented differently");
    auto found = std::lower_bound(edges.begin(), edges.end(), Directed(to, from, 0));
    if (found == edges.end() || std::get<0>(*found) != to || std::get<1>(*found) != from)
      fail_at(" is not closed: an edge has a triangle on one side only");
    surface.opposite[h] = std::get<2>(*found);
  }
}

/// The triangles around each vertex form one fan.
template <class Kernel>
void check_fans(const Scene<Kernel>& scene, const Surface& surface) {
  std::vector<char> seen_halfedge(surface.opposite.size()), seen_vertex(surface.number_of_vertices);
  for (std::uint32_t h = 0; h < surface.opposite.size(); ++h) {
    if (seen_halfedge[h]) continue;
    char& seen = seen_vertex[surface.vertices[h / 3][h % 3]];
    if (seen)
      reject(surface.title + " is not 2-manifold: several fans of triangles share one vertex", {surface.patch[h / 3]},
             scene.place(surface.points[h / 3][h % 3]));
    seen = true;
    for (std::uint32_t g = h; !seen_halfedge[g]; g = surface.opposite[previous_halfedge(g)]) seen_halfedge[g] = true;
  }
}

/// The number of edge-connected pieces of the triangles for which `chosen(t)` holds.
template <class Predicate>
std::size_t number_of_pieces(const Surface& surface, Predicate chosen) {
  Groups groups(surface.vertices.size());
  for (std::uint32_t h = 0; h < surface.opposite.size(); ++h)
    if (chosen(h / 3) && chosen(surface.opposite[h] / 3)) groups.unite(h / 3, surface.opposite[h] / 3);
  std::size_t pieces = 0;
  for (std::uint32_t t = 0; t < surface.vertices.size(); ++t) pieces += chosen(t) && groups.find(t) == t;
  return pieces;
}

/// All triangles hang together by edges.
inline void check_one_surface(const Surface& surface) {
  if (number_of_pieces(surface, [](std::uint32_t) { return true; }) != 1)
    reject(surface.title + " consists of several separate surfaces", {surface.patch.front()});
}

/// Closed, 2-manifold as indexed, no triangle without area.
template <class Kernel>
void check_manifold(const Scene<Kernel>& scene, Surface& surface) {
  check_triangles(scene, surface);
  check_closed(scene, surface);
  check_fans(scene, surface);
}

}  // namespace CCSweep::internal::verification

#endif
