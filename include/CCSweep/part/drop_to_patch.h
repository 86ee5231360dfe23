// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_DROP_TO_PATCH_H
#define CCSWEEP_PART_DROP_TO_PATCH_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Surface_location.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CCSweep::internal {

template <class Traits>
struct Dropped_point {
  typename Traits::Point_3 point;
  Surface_location where;
};

/// Where the line along `direction` through p meets the plane of face f; exact with an exact number type.
template <class Traits>
typename Traits::Point_3 drop_to_plane(const Part<Traits>& part, typename Part<Traits>::Face f,
                                       const typename Traits::Point_3& p, const Vec3& direction) {
  using FT = typename Traits::FT;
  const auto h = part.mesh.halfedge(f);
  const auto& a = part.point(part.mesh.source(h));
  const auto n = CGAL::cross_product(part.point(part.mesh.target(h)) - a,
                                     part.point(part.mesh.target(part.mesh.next(h))) - a);
  const typename Traits::Vector_3 d{FT(direction[0]), FT(direction[1]), FT(direction[2])};
  return p + ((a - p) * n / (d * n)) * d;
}

/// How far p lies outside face f when seen along `direction`; not positive inside.
template <class Traits>
double distance_outside(const Part<Traits>& part, typename Part<Traits>::Face f, const Vec3& p,
                        const Vec3& direction) {
  double worst = -std::numeric_limits<double>::infinity();
  const double sense = dot(part.normal[f], direction) > 0 ? 1 : -1;
  for (auto h : part.mesh.halfedges_around_face(part.mesh.halfedge(f))) {
    const Vec3 a = part.coordinates(part.mesh.source(h)), b = part.coordinates(part.mesh.target(h));
    const Vec3 outward = (sense)*cross(b - a, direction);
    worst = std::max(worst, dot(outward, p - a) / std::max(norm(outward), 1e-300));
  }
  return worst;
}

/// A place in a face, or on the edge or the vertex of the face that it all but lies on: a curve from there would cross
/// that edge again within a rounding error.
template <class Traits>
Dropped_point<Traits> settled_in_face(const Part<Traits>& part, typename Part<Traits>::Face f,
                                      const typename Traits::Point_3& p) {
  const double near = 1e-9 * part.diagonal;
  const Vec3 q = Part<Traits>::coordinates(p);
  for (auto h : part.mesh.halfedges_around_face(part.mesh.halfedge(f))) {
    const auto e = part.mesh.edge(h);
    const auto first = part.first_halfedge(e);
    const Vec3 a = part.coordinates(part.mesh.source(first)), w = part.coordinates(part.mesh.target(first)) - a;
    const double length = norm(w), along = dot(q - a, w) / length;
    if (along < -near || along > length + near || norm(cross(w, q - a)) > near * length) continue;
    if (along <= near || along >= length - near) {
      const auto v = along <= near ? part.mesh.source(first) : part.mesh.target(first);
      return {part.point(v), Surface_location::vertex(v)};
    }
    const double t = along / length;
    return {point_on_edge(part, e, t), Surface_location::edge(e, t)};
  }
  return {p, Surface_location::face(f)};
}

/// The point of a patch that p meets along `direction`. On a planar patch the location names any of its faces, as the
/// patch is cut as a whole. Complexity: constant on a planar patch, else linear in its faces.
template <class Traits>
std::optional<Dropped_point<Traits>> drop_to_patch(const Part<Traits>& part, Patch_index patch,
                                                   const typename Traits::Point_3& p, const Vec3& direction) {
  const auto& faces = part.faces[patch.value()];
  auto best = part.largest_face[patch.value()];
  if (!part.planar[patch.value()]) {
    const Vec3 q = Part<Traits>::coordinates(p);
    double least = std::numeric_limits<double>::infinity();
    for (auto f : faces) {
      const double d = distance_outside(part, f, q, direction);
      if (d >= least) continue;
      least = d;
      best = f;
    }
    if (!(least <= 1e-6 * part.diagonal)) return std::nullopt;
  }
  const auto dropped = drop_to_plane(part, best, p, direction);
  if (part.planar[patch.value()]) return Dropped_point<Traits>{dropped, Surface_location::face(best)};
  return settled_in_face(part, best, dropped);
}

}  // namespace CCSweep::internal

#endif
