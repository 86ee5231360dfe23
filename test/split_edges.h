// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_SPLIT_EDGES_H
#define CCSWEEP_TEST_SPLIT_EDGES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

// Finer facets for anything with `points`, `triangles` and `patch`.
namespace split_edges {

using Coordinates = std::array<double, 3>;
using Facet = std::array<std::size_t, 3>;

inline Coordinates between(const Coordinates& p, const Coordinates& q, double t) {
  Coordinates result;
  for (int k = 0; k < 3; ++k) result[k] = (1 - t) * p[k] + t * q[k];
  return result;
}

inline Coordinates middle(const Coordinates& p, const Coordinates& q) { return between(p, q, 0.5); }

/// Splits in two each edge for which `node_on` gives a point; both of its facets get it, so the mesh stays closed.
template <class Soup, class Node_on>
Soup once(const Soup& soup, const Node_on& node_on) {
  constexpr std::size_t none = -1;
  Soup result = soup;
  result.triangles.clear();
  result.patch.clear();
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> nodes;
  auto node = [&](std::size_t a, std::size_t b) {
    const auto [found, is_new] = nodes.try_emplace(std::minmax(a, b), none);
    if (!is_new) return found->second;
    const std::optional<Coordinates> p = node_on(soup.points[std::min(a, b)], soup.points[std::max(a, b)]);
    if (!p) return none;
    found->second = result.points.size();
    result.points.push_back(*p);
    return found->second;
  };
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      result.triangles.push_back({a, b, c});
      result.patch.push_back(soup.patch[i]);
    };
    Facet t = soup.triangles[i];
    Facet m{node(t[0], t[1]), node(t[1], t[2]), node(t[2], t[0])};
    const auto split = 3 - std::count(m.begin(), m.end(), none);
    // The odd one out comes first: the one edge that is split, or the one that is not.
    while ((split == 1 && m[0] == none) || (split == 2 && m[0] != none)) {
      std::rotate(t.begin(), t.begin() + 1, t.end());
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if (split == 0) {
      add(t[0], t[1], t[2]);
    } else if (split == 1) {
      add(t[0], m[0], t[2]);
      add(m[0], t[1], t[2]);
    } else if (split == 2) {
      add(m[1], t[2], m[2]);
      add(t[0], t[1], m[1]);
      add(t[0], m[1], m[2]);
    } else {
      add(t[0], m[0], m[2]);
      add(m[0], t[1], m[1]);
      add(m[2], m[1], t[2]);
      add(m[0], m[1], m[2]);
    }
  }
  return result;
}

}  // namespace split_edges

#endif
