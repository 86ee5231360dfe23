// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_SUBMAP_QUADS_H
#define CCSWEEP_HEX_SUBMAP_QUADS_H

#include <CCSweep/hex/Quad_laplacian.h>
#include <CCSweep/hex/Quad_region.h>

#include <Eigen/Core>

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

/// A region's outline drawn on a square grid: one step for each interval, and a quarter turn at each corner.
class Grid_outline {
 public:
  using Place = std::array<int, 2>;

  explicit Grid_outline(const Quad_region::Loop& loop) {
    constexpr Place step[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    std::vector<int> turn(loop.nodes.size(), 0);
    for (std::size_t i : loop.corners) turn[i] = 1;
    for (std::size_t i : loop.reflex) turn[i] = 3;
    Place at{};
    int direction = 0;
    for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
      is_simple_ &= node_.try_emplace(at, static_cast<std::uint32_t>(i)).second;
      direction = (direction + turn[i]) % 4;
      const Place to{at[0] + step[direction][0], at[1] + step[direction][1]};
      if (direction % 2 == 1) upright_[std::min(at[1], to[1])].push_back({at[0], direction == 1 ? -1 : 1});
      at = to;
    }
    is_simple_ &= at == Place{};
    for (auto& [row, edges] : upright_) std::sort(edges.begin(), edges.end());
  }

  /// Whether it closes and does not touch itself.
  bool is_simple() const { return is_simple_; }

  /// The squares inside, by their lower left corners.
  std::vector<Place> squares() const {
    std::vector<Place> result;
    for (const auto& [row, edges] : upright_) {
      int winding = 0;
      for (std::size_t e = 0; e + 1 < edges.size(); ++e) {
        winding += edges[e].second;  // the outline leads down on the left of the inside, and up on its right
        for (int i = edges[e].first; winding > 0 && i < edges[e + 1].first; ++i) result.push_back({i, row});
      }
    }
    return result;
  }

  const std::map<Place, std::uint32_t>& nodes() const { return node_; }

 private:
  bool is_simple_ = true;
  std::map<Place, std::uint32_t> node_;  // of the outline
  // By row: the places of the upright edges, each with -1 for one that leads up.
  std::map<int, std::vector<std::pair<int, int>>> upright_;
};

}  // namespace internal

/// The structured mesh of a region whose sides meet in corners of a quarter and of three quarters of a turn, where the
/// outline closes on a square grid (Whiteley et al., submapping, 1996): the squares inside, each inner node in the
/// middle of its neighbours.
/// \return nothing where the outline does not close on the grid, or touches itself there.
/// Complexity: O(n log n) in the quads, and a sparse factorisation.
inline std::optional<Quad_mesh> submap_quads(const Quad_region& region) {
  const auto& loop = region.loops[0];
  if (region.loops.size() != 1 || loop.corners.size() != loop.reflex.size() + 4) return std::nullopt;
  const internal::Grid_outline outline(loop);
  if (!outline.is_simple()) return std::nullopt;
  Quad_mesh mesh;
  mesh.points = loop.nodes;
  auto node = outline.nodes();
  for (const auto& [i, j] : outline.squares()) {
    const auto at = [&](int x, int y) {
      const auto [found, is_new] = node.try_emplace({x, y}, static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) mesh.points.push_back({});
      return found->second;
    };
    mesh.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  const std::size_t fixed = loop.nodes.size();
  internal::Quad_laplacian::Values on_outline(static_cast<Eigen::Index>(fixed), 2);
  for (std::size_t n = 0; n < fixed; ++n)
    for (int x : {0, 1}) on_outline(static_cast<Eigen::Index>(n), x) = loop.nodes[n][x];
  const auto inner = internal::Quad_laplacian(mesh, fixed)(on_outline);
  for (std::size_t n = fixed; n < mesh.points.size(); ++n)
    for (int x : {0, 1}) mesh.points[n][x] = inner(static_cast<Eigen::Index>(n - fixed), x);
  return mesh;
}

}  // namespace CCSweep

#endif
