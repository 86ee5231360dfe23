// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_BOUND_BY_ANGLES_H
#define CCSWEEP_HEX_BOUND_BY_ANGLES_H

#include <CCSweep/hex/Cell_outlines.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/angle_bound.h>
#include <CCSweep/hex/plane.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CCSweep::internal {

/// Of the points of an outline on a layer those at the walls below the arcs of a layer.
inline std::vector<std::optional<Vec3>> only_on_walls(const Cell_stack& stack, const Cell& cell, std::size_t layer,
                                                      const Cell_outlines& outlines, const std::vector<Vec3>& points) {
  std::vector<std::optional<Vec3>> result(points.size());
  std::size_t first = 0;
  for (const Cell::Loop& loop : cell.loops[cell.top - layer]) {
    const std::size_t length = outlines.length(layer, loop);
    std::size_t at = 0;
    for (Arc_stack::Half_arc h : loop) {
      const std::size_t end = at + outlines.intervals(layer, h);
      for (std::size_t i = at; i <= end && stack.arcs.arc(layer, h).wall[h % 2].is_valid(); ++i)
        result[first + i % length] = points[first + i % length];
      at = end;
    }
    first += length;
  }
  return result;
}

/// The tightest bound by the angles around one of a cell's two caps.
/// \param drop puts a place on the cap
template <class Drop>
Angle_bound bound_by_angles(const Cell_stack& stack, std::size_t c, Patch_index cap, const Cell_outlines& outlines,
                            const Drop& drop) {
  const Cell& cell = stack.cells[c];
  const bool is_source = cap == cell.source;
  const std::size_t layer = is_source ? cell.top : cell.bottom, next = is_source ? layer - 1 : layer + 1;
  std::vector<std::size_t> loops;
  for (const Cell::Loop& loop : cell.loops[cell.top - layer]) loops.push_back(outlines.length(layer, loop));
  const std::size_t upper = std::max(layer, next);  // whose arcs know the walls between
  Angle_bound found = tightest_angle(outlines.places(c, layer),
                                     only_on_walls(stack, cell, upper, outlines, outlines.places(c, next)),
                                     loops, Plane_chart(stack.layers.layers[layer].up), drop, is_source);
  found.patch_id = stack.id(cap);
  return found;
}

}  // namespace CCSweep::internal

#endif
