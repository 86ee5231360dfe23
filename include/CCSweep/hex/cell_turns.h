// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CELL_TURNS_H
#define CCSWEEP_HEX_CELL_TURNS_H

#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/plane.h>
#include <CCSweep/hex/trace_cells.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace CCSweep::internal {

/// How a cell's outline turns where its arcs begin, as the sides of a structured mesh do: 1 to the left, 0 straight on,
/// -1 to the right (White and Tautges, 2000). Empty where the outline can't be that of a structured mesh: with holes,
/// with an angle too sharp or folded back, or with turns that do not sum up to 4.
inline std::vector<int> cell_turns(const Layer_stack& stack, const Arc_stack& arcs, const Cell& cell) {
  constexpr double degree = std::numbers::pi / 180, least = 20 * degree, most = 315 * degree;
  if (cell.loops[0].size() != 1) return {};
  const Cell::Loop& loop = cell.loops[0][0];
  const Plane_chart plane(stack.layers[cell.top].up);
  // The direction in which an arc, seen in the loop's sense, sets out.
  const auto heading = [&](Arc_stack::Half_arc h) {
    const auto& line = arcs.arc(cell.top, h).line;
    return plane(Arc_stack::is_reversed(h) ? line[line.size() - 2] - line.back() : line[1] - line[0]);
  };
  std::vector<int> turns;
  int sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 out = heading(loop[i]), back = heading(Arc_stack::opposite(loop[(i + loop.size() - 1) % loop.size()]));
    double inside = std::atan2(out[0] * back[1] - out[1] * back[0], out[0] * back[0] + out[1] * back[1]);
    if (inside < 0) inside += 2 * std::numbers::pi;
    if (inside < least || inside > most) return {};
    turns.push_back(inside < 135 * degree ? 1 : inside < 225 * degree ? 0 : -1);
    sum += turns.back();
  }
  return sum == 4 ? turns : std::vector<int>();
}

}  // namespace CCSweep::internal

#endif
