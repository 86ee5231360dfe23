// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_QUAD_REGION_H
#define CCSWEEP_HEX_QUAD_REGION_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CCSweep {

/// A region of the plane to be meshed with quadrilaterals: one outer loop that turns counter-clockwise and any number
/// of inner loops that turn clockwise. The nodes on the loops are given and stay; their number is even.
struct Quad_region {
  using Point = std::array<double, 2>;
  struct Loop {
    std::vector<Point> nodes;
    std::vector<std::size_t> corners;  ///< indices of the nodes where a side ends, ascending; may be empty
    std::vector<std::size_t> reflex;   ///< of the corners that turn in, of a structured outline
  };
  std::vector<Loop> loops;  ///< the outer one first
};

/// How many nodes the loops of a region have.
inline std::size_t number_of_nodes(const Quad_region& region) {
  std::size_t count = 0;
  for (const auto& loop : region.loops) count += loop.nodes.size();
  return count;
}

/// Quadrilaterals that cover a region. The nodes of the region's loops come first, in their order.
struct Quad_mesh {
  std::vector<Quad_region::Point> points;
  std::vector<std::array<std::uint32_t, 4>> quads;  ///< counter-clockwise
};

}  // namespace CCSweep

#endif
