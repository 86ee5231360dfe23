// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MAP_QUADS_H
#define CCSWEEP_HEX_MAP_QUADS_H

#include <CCSweep/hex/Quad_region.h>

#include <cstdint>
#include <vector>

namespace CCSweep {

/// Whether a region is bounded by four sides of which opposite ones have equally many nodes.
inline bool is_mappable(const Quad_region& region) {
  const auto& c = region.loops[0].corners;
  if (region.loops.size() != 1 || c.size() != 4 || !region.loops[0].reflex.empty()) return false;
  const std::size_t n = region.loops[0].nodes.size();
  return c[1] - c[0] == c[3] - c[2] && c[2] - c[1] == c[0] + n - c[3];
}

/// The structured mesh of a mappable region, by transfinite interpolation. Complexity: linear in the quads.
inline Quad_mesh map_quads(const Quad_region& region) {
  const auto& loop = region.loops[0];
  const std::size_t n = loop.nodes.size(), width = loop.corners[1] - loop.corners[0],
                    height = loop.corners[2] - loop.corners[1];
  const auto on_loop = [&](std::size_t k) { return static_cast<std::uint32_t>((loop.corners[0] + k) % n); };
  Quad_mesh mesh;
  mesh.points = loop.nodes;
  std::vector<std::uint32_t> grid((width + 1) * (height + 1));
  const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& { return grid[j * (width + 1) + i]; };
  for (std::size_t i = 0; i <= width; ++i) {
    at(i, 0) = on_loop(i);
    at(i, height) = on_loop(width + height + (width - i));
  }
  for (std::size_t j = 0; j <= height; ++j) {
    at(0, j) = on_loop(n - j);
    at(width, j) = on_loop(width + j);
  }
  for (std::size_t j = 1; j < height; ++j)
    for (std::size_t i = 1; i < width; ++i) {
      const double s = double(i) / double(width), t = double(j) / double(height);
      Quad_region::Point p;
      for (int x : {0, 1}) {
        const auto c = [&](std::size_t a, std::size_t b) { return loop.nodes[at(a, b)][x]; };
        p[x] = (1 - t) * c(i, 0) + t * c(i, height) + (1 - s) * c(0, j) + s * c(width, j) -
               ((1 - s) * (1 - t) * c(0, 0) + s * (1 - t) * c(width, 0) + s * t * c(width, height) +
                (1 - s) * t * c(0, height));
      }
      at(i, j) = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.push_back(p);
    }
  for (std::size_t j = 0; j < height; ++j)
    for (std::size_t i = 0; i < width; ++i)
      mesh.quads.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

}  // namespace CCSweep

#endif
