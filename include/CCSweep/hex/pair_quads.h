// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_PAIR_QUADS_H
#define CCSWEEP_HEX_PAIR_QUADS_H

#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/Cap_triangulation.h>
#include <CCSweep/hex/pair_triangles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// Triangles joined to quads where these are good; the rest stay triangles.
inline std::vector<std::vector<std::uint32_t>> pair_triangles(const Cap_triangulation& coarse) {
  constexpr double least = 0.3;
  const std::vector<Triangle_pair> pairs = pairs_of_triangles(coarse, least);
  const std::vector<std::size_t> chosen = choose_pairs(pairs, coarse.triangles.size(), false);
  std::vector<std::vector<std::uint32_t>> cells;
  for (std::size_t i : chosen) cells.emplace_back(pairs[i].quad.begin(), pairs[i].quad.end());
  for (std::size_t t : left_over(pairs, chosen, coarse.triangles.size()))
    cells.emplace_back(coarse.triangles[t].begin(), coarse.triangles[t].end());
  return cells;
}

/// Cuts every triangle in three and every quad in four, from its middle to the middles of its sides. On the loops
/// those are the nodes that the coarse cells left out.
class Midpoint_subdivision {
 public:
  explicit Midpoint_subdivision(const Cap_triangulation& coarse) {
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
/// \return nothing where a loop has an odd number of nodes, or every second one is too coarse to outline the region.
/// Complexity: O(n log n) in the quads, times the nodes on the loops for the size that is wanted at a place.
inline std::optional<Quad_mesh> pair_quads(const Quad_region& region, double size) {
  for (const auto& loop : region.loops)
    if (loop.nodes.size() % 2 != 0) return std::nullopt;
  internal::Cap_triangulation coarse(region, size, 2);
  if (!coarse.run()) return std::nullopt;
  const auto cells = internal::pair_triangles(coarse);
  return internal::Midpoint_subdivision(coarse).run(cells);
}

}  // namespace CCSweep

#endif
