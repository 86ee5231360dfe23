// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_PAIR_QUADS_H
#define CCSWEEP_HEX_PAIR_QUADS_H

#include <CCSweep/hex/Coarse_triangulation.h>
#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/quad_quality.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// The least sine of the angles that a coarse quad will have when it is subdivided.
inline double quality_of_pair(const Coarse_triangulation& coarse, const std::array<std::uint32_t, 4>& quad) {
  const auto& p = coarse.points;
  double worst = quad_scaled_jacobian(p[quad[0]], p[quad[1]], p[quad[2]], p[quad[3]]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point2 &here = p[quad[i]], &after = coarse.towards(quad[i], quad[(i + 1) % 4]),
                 &before = coarse.towards(quad[i], quad[(i + 3) % 4]);
    worst = std::min(worst, turn(here, after, before) / (length_between(here, after) * length_between(here, before)));
  }
  return worst;
}

/// Triangles joined to quads where these are good; the rest stay triangles.
inline std::vector<std::vector<std::uint32_t>> pair_triangles(const Coarse_triangulation& coarse) {
  struct Pair {
    double quality;
    std::size_t first, second;
    std::array<std::uint32_t, 4> quad;
  };
  constexpr double least = 0.3;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::size_t>> side;  // triangle, corner
  for (std::size_t t = 0; t < coarse.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) side[{coarse.triangles[t][i], coarse.triangles[t][(i + 1) % 3]}] = {t, i};
  std::vector<Pair> pairs;
  for (const auto& [edge, here] : side) {
    const auto there = side.find({edge.second, edge.first});
    if (there == side.end() || edge.first > edge.second) continue;
    const std::uint32_t tip = coarse.triangles[here.first][(here.second + 2) % 3];
    const std::uint32_t foot = coarse.triangles[there->second.first][(there->second.second + 2) % 3];
    const double quality = quality_of_pair(coarse, {edge.first, foot, edge.second, tip});
    if (quality > least)
      pairs.push_back({quality, here.first, there->second.first, {edge.first, foot, edge.second, tip}});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.quality > b.quality; });
  std::vector<bool> used(coarse.triangles.size(), false);
  std::vector<std::vector<std::uint32_t>> cells;
  for (const Pair& pair : pairs) {
    if (used[pair.first] || used[pair.second]) continue;
    used[pair.first] = used[pair.second] = true;
    cells.emplace_back(pair.quad.begin(), pair.quad.end());
  }
  for (std::size_t t = 0; t < used.size(); ++t)
    if (!used[t]) cells.emplace_back(coarse.triangles[t].begin(), coarse.triangles[t].end());
  return cells;
}

/// Cuts every triangle in three and every quad in four, from its middle to the middles of its sides. On the loops
/// those are the nodes that the coarse cells left out.
class Midpoint_subdivision {
 public:
  explicit Midpoint_subdivision(const Coarse_triangulation& coarse) {
    mesh_.points = coarse.points;
    for (const auto& [edge, node] : coarse.middles()) middle_[std::minmax(edge.first, edge.second)] = node;
  }

  Quad_mesh run(const std::vector<std::vector<std::uint32_t>>& cells) {
    for (const auto& cell : cells) {
      const std::uint32_t centre = add(cell);
      const std::size_t n = cell.size();
      for (std::size_t i = 0; i < n; ++i)
        mesh_.quads.push_back(
            {cell[i], middle(cell[i], cell[(i + 1) % n]), centre, middle(cell[(i + n - 1) % n], cell[i])});
    }
    return std::move(mesh_);
  }

 private:
  std::uint32_t add(const std::vector<std::uint32_t>& corners) {
    Point2 sum{};
    for (std::uint32_t n : corners)
      for (int x : {0, 1}) sum[x] += mesh_.points[n][x] / double(corners.size());
    mesh_.points.push_back(sum);
    return static_cast<std::uint32_t>(mesh_.points.size() - 1);
  }

  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto key = std::pair(std::min(a, b), std::max(a, b));
    const auto found = middle_.find(key);
    if (found != middle_.end()) return found->second;
    return middle_[key] = add({a, b});
  }

  Quad_mesh mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_;
};

}  // namespace internal

/// An unstructured mesh of a region: triangles of twice the size are paired to quads, and every cell is subdivided, so
/// that triangles left over do no harm.
/// \return nothing where every second node of the loops is too coarse to outline the region.
/// Complexity: O(n log n) in the quads, times the nodes on the loops for the size that is wanted at a place.
inline std::optional<Quad_mesh> pair_quads(const Quad_region& region, double size) {
  internal::Coarse_triangulation coarse(region, size);
  if (!coarse.run()) return std::nullopt;
  const auto cells = internal::pair_triangles(coarse);
  return internal::Midpoint_subdivision(coarse).run(cells);
}

}  // namespace CCSweep

#endif
