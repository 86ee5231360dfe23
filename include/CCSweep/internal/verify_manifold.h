// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_MANIFOLD_H
#define CCSWEEP_INTERNAL_VERIFY_MANIFOLD_H

#include <CCSweep/internal/verify_scene.h>

#include <cstdint>
#include <utility>
#include <vector>

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

/// The halfedges that leave each vertex of a surface.
class Outgoing_halfedges {
 public:
  explicit Outgoing_halfedges(const Surface& surface)
      : surface_(surface),
        first_(surface.number_of_vertices + 1, 0),
        halfedges_(3 * surface.vertices.size()),
        targets_(halfedges_.size()) {
    for (std::uint32_t h = 0; h < halfedges_.size(); ++h) ++first_[source(h) + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    std::vector<std::uint32_t> next = first_;
    for (std::uint32_t h = 0; h < halfedges_.size(); ++h) {
      const std::uint32_t place = next[source(h)]++;
      halfedges_[place] = h;
      targets_[place] = target(h);
    }
  }

  std::uint32_t source(std::uint32_t h) const { return surface_.vertices[h / 3][h % 3]; }
  std::uint32_t target(std::uint32_t h) const { return source(next_halfedge(h)); }

  /// The number of those from one vertex to another, and the last of them.
  std::pair<std::size_t, std::uint32_t> between(std::uint32_t from, std::uint32_t to) const {
    std::pair<std::size_t, std::uint32_t> result{0, 0};
    for (std::uint32_t i = first_[from]; i < first_[from + 1]; ++i)
      if (targets_[i] == to) result = {result.first + 1, halfedges_[i]};
    return result;
  }

 private:
  const Surface& surface_;
  std::vector<std::uint32_t> first_, halfedges_, targets_;
};

/// Pairs the halfedges: every directed edge once, and its opposite once.
template <class Kernel>
void check_closed(const Scene<Kernel>& scene, Surface& surface) {
  const Outgoing_halfedges outgoing(surface);
  surface.opposite.resize(3 * surface.vertices.size());
  for (std::uint32_t h = 0; h < surface.opposite.size(); ++h) {
    const auto fail_at = [&](const char* what) {
      reject(surface.title + what, {surface.patch[h / 3]}, scene.place(surface.points[h / 3][h % 3]));
    };
    const std::uint32_t from = outgoing.source(h), to = outgoing.target(h);
    const auto [number, opposite] = outgoing.between(to, from);
    if (number > 1 || outgoing.between(from, to).first > 1)
      fail_at(" has an edge with more than two triangles, or neighbours that are oriented differently");
    if (number == 0) fail_at(" is not closed: an edge has a triangle on one side only");
    surface.opposite[h] = opposite;
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
