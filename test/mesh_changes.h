// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_MESH_CHANGES_H
#define CCSWEEP_TEST_MESH_CHANGES_H

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "split_edges.h"

// Changes of a part that must change its decomposition in a known way.
namespace mesh_changes {

using Coordinates = std::array<double, 3>;
using Facet = std::array<std::size_t, 3>;

/// A closed triangle mesh with the patch id of each facet.
struct Soup {
  std::vector<Coordinates> points;
  std::vector<Facet> triangles;
  std::vector<int> patch;
};

template <class Mesh>
Soup soup(const Mesh& mesh) {
  Soup result;
  const auto patch = mesh.template property_map<typename Mesh::Face_index, int>("f:patch_id").first;
  std::map<typename Mesh::Vertex_index, std::size_t> number;
  for (auto v : mesh.vertices()) {
    number[v] = result.points.size();
    const auto& p = mesh.point(v);
    result.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    result.triangles.push_back(
        {number[mesh.source(h)], number[mesh.target(h)], number[mesh.target(mesh.next(h))]});
    result.patch.push_back(patch[f]);
  }
  return result;
}

/// The soup as a mesh with the face property `f:patch_id`.
template <class Point>
CGAL::Surface_mesh<Point> mesh(const Soup& soup) {
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh result;
  auto patch = result.template add_property_map<typename Mesh::Face_index, int>("f:patch_id", -1).first;
  std::vector<typename Mesh::Vertex_index> v;
  for (const Coordinates& p : soup.points) v.push_back(result.add_vertex(Point(p[0], p[1], p[2])));
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Facet& t = soup.triangles[i];
    patch[result.add_face(v[t[0]], v[t[1]], v[t[2]])] = soup.patch[i];
  }
  return result;
}

template <class Function>
Soup moved(Soup soup, Function f) {
  for (Coordinates& p : soup.points) p = f(p);
  return soup;
}

inline Coordinates scaled(const Coordinates& p, double factor) {
  return {factor * p[0], factor * p[1], factor * p[2]};
}

inline Coordinates mirrored(const Coordinates& p) { return {-p[0], p[1], p[2]}; }

inline Soup mirrored(Soup soup) {
  for (Coordinates& p : soup.points) p = mirrored(p);
  for (Facet& t : soup.triangles) std::swap(t[1], t[2]);
  return soup;
}

/// Turned by an angle (in radians) about the axis (1, 2, 3), which is no axis of any part.
inline Coordinates turned(const Coordinates& p, double angle) {
  const double n = std::sqrt(14.0), c = std::cos(angle), s = std::sin(angle);
  const Coordinates k{1 / n, 2 / n, 3 / n};
  const Coordinates cross{k[1] * p[2] - k[2] * p[1], k[2] * p[0] - k[0] * p[2], k[0] * p[1] - k[1] * p[0]};
  const double dot = k[0] * p[0] + k[1] * p[1] + k[2] * p[2];
  Coordinates result;
  for (int i = 0; i < 3; ++i) result[i] = c * p[i] + s * cross[i] + (1 - c) * dot * k[i];
  return result;
}

/// The same mesh with its vertices and facets in another order, and each facet from another corner.
inline Soup shuffled(const Soup& soup, std::uint32_t seed) {
  std::mt19937 random(seed);
  auto permutation = [&](std::size_t n) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t(0));
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
  };
  Soup result;
  const std::vector<std::size_t> place = permutation(soup.points.size());
  result.points.resize(soup.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) result.points[place[i]] = soup.points[i];
  for (std::size_t i : permutation(soup.triangles.size())) {
    Facet t = soup.triangles[i];
    for (std::size_t& v : t) v = place[v];
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    result.triangles.push_back(t);
    result.patch.push_back(soup.patch[i]);
  }
  return result;
}

/// Each facet in three, about its centroid.
inline Soup with_split_facets(const Soup& soup) {
  Soup result;
  result.points = soup.points;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Facet& t = soup.triangles[i];
    Coordinates centroid{};
    for (std::size_t v : t)
      for (int k = 0; k < 3; ++k) centroid[k] += soup.points[v][k] / 3;
    const std::size_t c = result.points.size();
    result.points.push_back(centroid);
    for (int k = 0; k < 3; ++k) {
      result.triangles.push_back({t[k], t[(k + 1) % 3], c});
      result.patch.push_back(soup.patch[i]);
    }
  }
  return result;
}

/// Each edge in two, each facet in four.
inline Soup with_split_edges(const Soup& soup) {
  return split_edges::once(soup, [](const Coordinates& p, const Coordinates& q) {
    return std::optional(split_edges::middle(p, q));
  });
}

/// About half of a patch gets another id, so that both are in one piece; nothing where the patch is a single facet or
/// no such half is found.
inline std::optional<Soup> with_split_patch(const Soup& soup, int patch, int new_id) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> facet_at;
  std::vector<std::size_t> facets;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    if (soup.patch[i] != patch) continue;
    facets.push_back(i);
    for (int k = 0; k < 3; ++k) facet_at[{soup.triangles[i][k], soup.triangles[i][(k + 1) % 3]}] = i;
  }
  auto grown = [&](std::size_t seed, std::size_t limit, const std::set<std::size_t>& but) {
    std::vector<std::size_t> found{seed};
    std::set<std::size_t> seen{seed};
    for (std::size_t i = 0; i < found.size() && found.size() < limit; ++i)
      for (int k = 0; k < 3 && found.size() < limit; ++k) {
        const Facet& t = soup.triangles[found[i]];
        const auto next = facet_at.find({t[(k + 1) % 3], t[k]});
        if (next != facet_at.end() && !but.count(next->second) && seen.insert(next->second).second)
          found.push_back(next->second);
      }
    return seen;
  };
  if (facets.size() < 2) return std::nullopt;
  for (std::size_t seed : facets) {
    const std::set<std::size_t> half = grown(seed, (facets.size() + 1) / 2, {});
    const auto other =
        std::find_if(facets.begin(), facets.end(), [&](std::size_t f) { return half.count(f) == 0; });
    if (other == facets.end() || half.size() + grown(*other, facets.size(), half).size() != facets.size()) continue;
    Soup result = soup;
    for (std::size_t f : half) result.patch[f] = new_id;
    return result;
  }
  return std::nullopt;
}

}  // namespace mesh_changes

#endif
