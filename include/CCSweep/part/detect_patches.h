// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_DETECT_PATCHES_H
#define CCSWEEP_PART_DETECT_PATCHES_H

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <boost/graph/graph_traits.hpp>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

// A vector along the normal of a facet, in double: the comparison with an angle needs no more.
template <class FaceGraph, class VertexPointMap>
std::array<double, 3> facet_normal(const FaceGraph& mesh, VertexPointMap points,
                                   typename boost::graph_traits<FaceGraph>::face_descriptor f) {
  const auto h = halfedge(f, mesh);
  std::array<std::array<double, 3>, 3> corner;
  std::size_t i = 0;
  for (auto v : CGAL::vertices_around_face(h, mesh)) {
    if (i == 3) break;
    const auto& p = get(points, v);
    corner[i++] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
  std::array<double, 3> normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
    normal[k] = (corner[1][x] - corner[0][x]) * (corner[2][y] - corner[0][y]) -
                (corner[1][y] - corner[0][y]) * (corner[2][x] - corner[0][x]);
  }
  return normal;
}

// The angle between two vectors in degrees.
inline double angle_between(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const double c = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const double s = std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
  constexpr double degrees = 57.295779513082320877;
  return std::atan2(s, c) * degrees;
}

}  // namespace internal

/// Finds the patches of a triangle mesh that comes without them: facets belong together when a path of facets joins
/// them whose neighbours turn by at most `angle` degrees each.
///
/// Ids are counted from 0 in the order of the patches' lexicographically smallest facets, so that they depend neither
/// on the order of the facets nor on that of the vertices.
///
/// \tparam FaceGraph a model of `FaceListGraph`, its faces triangles
/// \tparam VertexPointMap a readable map from vertices to points
/// \tparam FacePatchMap a writable map from faces to `int`
/// \returns the number of patches
template <class FaceGraph, class VertexPointMap, class FacePatchMap>
std::size_t detect_patches(const FaceGraph& mesh, VertexPointMap points, FacePatchMap patches, double angle = 30) {
  using Face = typename boost::graph_traits<FaceGraph>::face_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  constexpr double slack = 1e-6;  // a turn of just the angle is smooth, whatever the rounding

  const std::vector<Face> all(faces(mesh).begin(), faces(mesh).end());
  auto rank = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  std::vector<std::array<double, 3>> normals;
  for (std::size_t i = 0; i < all.size(); ++i) {
    put(rank, all[i], i);
    normals.push_back(internal::facet_normal(mesh, points, all[i]));
  }

  std::vector<std::size_t> parent(all.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if (CGAL::is_border(e, mesh)) continue;
    const std::size_t f = get(rank, face(h, mesh)), g = get(rank, face(opposite(h, mesh), mesh));
    if (internal::angle_between(normals[f], normals[g]) <= angle + slack) parent[root(f)] = root(g);
  }

  using Key = std::array<Point, 3>;
  std::map<std::size_t, Key> smallest;  // facet of each patch, by its root
  for (std::size_t i = 0; i < all.size(); ++i) {
    Key key;
    std::size_t corner = 0;
    for (auto v : CGAL::vertices_around_face(halfedge(all[i], mesh), mesh))
      if (corner < 3) key[corner++] = get(points, v);
    std::sort(key.begin(), key.end());
    const auto [it, is_new] = smallest.try_emplace(root(i), key);
    if (!is_new && key < it->second) it->second = key;
  }
  std::vector<std::pair<Key, std::size_t>> order;
  for (const auto& [patch, key] : smallest) order.emplace_back(key, patch);
  std::sort(order.begin(), order.end());
  std::vector<int> id(all.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) id[order[i].second] = static_cast<int>(i);
  for (std::size_t i = 0; i < all.size(); ++i) put(patches, all[i], id[root(i)]);
  return order.size();
}

}  // namespace CCSweep

#endif
