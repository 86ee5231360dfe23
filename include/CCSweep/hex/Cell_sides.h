// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CELL_SIDES_H
#define CCSWEEP_HEX_CELL_SIDES_H

#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/plane.h>
#include <CCSweep/hex/trace_cells.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace CCSweep::internal {

/// The arcs of a cell's outline at which its four sides begin; empty where it is no quadrangle.
inline std::vector<std::size_t> quadrangle_corners(const Layer_stack& stack, const Arc_stack& arcs, const Cell& cell) {
  constexpr double degree = std::numbers::pi / 180, corner = 135 * degree, least = 20 * degree, side = 225 * degree;
  if (cell.loops[0].size() != 1) return {};
  const Cell::Loop& loop = cell.loops[0][0];
  const Plane_chart plane(stack.layers[cell.top].up);
  // The direction in which an arc, seen in the loop's sense, sets out.
  const auto heading = [&](Arc_stack::Half_arc h) {
    const auto& line = arcs.arc(cell.top, h).line;
    return plane(Arc_stack::is_reversed(h) ? line[line.size() - 2] - line.back() : line[1] - line[0]);
  };
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 out = heading(loop[i]), back = heading(Arc_stack::opposite(loop[(i + loop.size() - 1) % loop.size()]));
    double inside = std::atan2(out[0] * back[1] - out[1] * back[0], out[0] * back[0] + out[1] * back[1]);
    if (inside < 0) inside += 2 * std::numbers::pi;
    if (inside < least || inside > side) return {};
    if (inside < corner) corners.push_back(i);
  }
  return corners.size() == 4 ? corners : std::vector<std::size_t>();
}

/// Gives opposite sides of quadrangles equally many intervals where that takes few more. A change in one cell reaches
/// others through its columns, so this goes on till nothing changes, boundedly.
inline void balance_quadrangles(const std::vector<Cell>& cells, const std::vector<std::vector<std::size_t>>& corners,
                                Arc_intervals& intervals) {
  constexpr int passes = 10;
  bool changed = true;
  for (int pass = 0; changed && pass < passes; ++pass) {
    changed = false;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (corners[c].empty()) continue;
      const Cell::Loop& loop = cells[c].loops[0][0];
      std::vector<std::size_t> sum(4, 0), longest(4, 0);
      for (std::size_t s = 0; s < 4; ++s)
        for (std::size_t i = corners[c][s]; i != corners[c][(s + 1) % 4]; i = (i + 1) % loop.size()) {
          const std::size_t n = intervals(cells[c].top, loop[i]);
          if (sum[s] == 0 || n > intervals(cells[c].top, loop[longest[s]])) longest[s] = i;
          sum[s] += n;
        }
      for (std::size_t s : {0, 1}) {
        const std::size_t low = sum[s] < sum[s + 2] ? s : s + 2, high = s + (s + 2) - low;
        const std::size_t more = sum[high] - sum[low];
        if (more == 0 || more > std::max<std::size_t>(2, sum[low])) continue;
        intervals.add(cells[c].top, loop[longest[low]], more);
        changed = true;
      }
    }
  }
}

}  // namespace CCSweep::internal

#endif
