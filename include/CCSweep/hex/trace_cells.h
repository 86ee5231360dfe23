// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_TRACE_CELLS_H
#define CCSWEEP_HEX_TRACE_CELLS_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/plane.h>
#include <CCSweep/internal/guarded.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace CCSweep {

/// A column of material from one target to one source, without a further outline inside: it is swept one to one.
struct Cell {
  using Loop = std::vector<Arc_stack::Half_arc>;  ///< with the cell on the left

  Patch_index target, source;
  std::size_t bottom, top;               ///< layers
  std::vector<std::vector<Loop>> loops;  ///< from the top layer down to the bottom one; the outer loop first
};

namespace internal {

/// Finds the cells that end on one layer.
class Cell_tracer {
  using Half_arc = Arc_stack::Half_arc;
  using Node = Arc_stack::Node;

 public:
  Cell_tracer(const Layer_stack& stack, const Arc_stack& arcs, std::size_t layer)
      : stack_(stack), arcs_(arcs), layer_(layer), plane_(stack.layers[layer].up) {
    for (Half_arc h = 0; h < 2 * arcs.arcs[layer].size(); ++h)
      around_[arcs.source(layer, h)].emplace_back(heading(h), h);
    for (auto& [node, halves] : around_) std::sort(halves.begin(), halves.end());
  }

  std::vector<Cell> run() {
    std::vector<Loop> outer, inner;
    std::vector<bool> seen(2 * arcs_.arcs[layer_].size(), false);
    for (Half_arc h = 0; h < seen.size(); ++h) {
      if (seen[h] || !ends_here(h)) continue;
      Loop loop = trace(h, seen);
      (loop.area > 0 ? outer : inner).push_back(std::move(loop));
    }
    std::vector<Cell> cells;
    for (const Loop& loop : outer) {
      const auto& side = arcs_.side(layer_, loop.halves[0]);
      cells.push_back({side.target, side.source, stack_.layer_of_cap[side.target.value()], layer_, {{loop.halves}}});
    }
    for (const Loop& loop : inner) cells[cell_around(loop, outer)].loops[0].push_back(loop.halves);
    return cells;
  }

 private:
  struct Loop {
    std::vector<Half_arc> halves;
    std::vector<Point2> outline;
    double area = 0;
  };

  bool ends_here(Half_arc h) const {
    const auto& side = arcs_.side(layer_, h);
    return side.source.is_valid() && side.target.is_valid();
  }

  double heading(Half_arc h) const {
    const auto& line = arcs_.arc(layer_, h).line;
    const bool r = Arc_stack::is_reversed(h);
    const Point2 w = plane_(r ? line[line.size() - 2] - line.back() : line[1] - line[0]);
    return std::atan2(w[1], w[0]);
  }

  // The next half arc about the face on the left: the first one clockwise from where this one came.
  Half_arc next(Half_arc h) const {
    const auto& halves = around_.at(arcs_.target(layer_, h));
    const Half_arc back = Arc_stack::opposite(h);
    const auto at = std::find_if(halves.begin(), halves.end(), [&](const auto& x) { return x.second == back; });
    return (at == halves.begin() ? halves.back() : *std::prev(at)).second;
  }

  Loop trace(Half_arc first, std::vector<bool>& seen) const {
    Loop loop;
    for (Half_arc h = first; !seen[h]; h = next(h)) {
      if (!(arcs_.side(layer_, h) == arcs_.side(layer_, first)))
        fail(Status_code::imprint_failed, Stage::hex_mesh, "the outlines on a layer do not close", {},
             arcs_.arc(layer_, h).line[0]);
      seen[h] = true;
      loop.halves.push_back(h);
      const std::vector<Point2> line = plane_(arcs_.arc(layer_, h).line);
      if (Arc_stack::is_reversed(h))
        loop.outline.insert(loop.outline.end(), line.rbegin(), line.rend() - 1);
      else
        loop.outline.insert(loop.outline.end(), line.begin(), line.end() - 1);
    }
    loop.area = signed_area(loop.outline);
    return loop;
  }

  std::size_t cell_around(const Loop& inner, const std::vector<Loop>& outer) const {
    std::size_t best = outer.size();
    for (std::size_t i = 0; i < outer.size(); ++i)
      if (arcs_.side(layer_, outer[i].halves[0]) == arcs_.side(layer_, inner.halves[0]) &&
          winding_number(outer[i].outline, inner.outline[0]) > 0 &&
          (best == outer.size() || outer[i].area < outer[best].area))
        best = i;
    if (best == outer.size())
      fail(Status_code::imprint_failed, Stage::hex_mesh, "an inner outline on a layer lies in no outer one", {},
           arcs_.arc(layer_, inner.halves[0]).line[0]);
    return best;
  }

  const Layer_stack& stack_;
  const Arc_stack& arcs_;
  std::size_t layer_;
  Plane_chart plane_;
  std::map<Node, std::vector<std::pair<double, Half_arc>>> around_;  // by heading
};

/// Follows a cell's loops down to its target.
inline void descend(const Arc_stack& arcs, Cell& cell) {
  for (std::size_t k = cell.top; k > cell.bottom; --k) {
    cell.loops.push_back(cell.loops.back());
    for (Cell::Loop& loop : cell.loops.back()) {
      for (Arc_stack::Half_arc& h : loop) h = arcs.below(k, h);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto next = loop[(i + 1) % loop.size()];
        if (loop[i] == Arc_stack::none || next == Arc_stack::none ||
            arcs.target(k - 1, loop[i]) != arcs.source(k - 1, next))
          fail(Status_code::inconsistent_levels, Stage::hex_mesh, "a column does not close on the layer below", {},
               arcs.arc(k, cell.loops[cell.top - k][0][0]).line[0]);
      }
    }
  }
}

}  // namespace internal

/// Finds all cells, by the layer they end on.
/// Complexity: O(n log n) in the arcs, and the inner loops of a layer times its outer ones.
inline std::vector<Cell> trace_cells(const Layer_stack& stack, const Arc_stack& arcs) {
  std::vector<Cell> cells;
  for (std::size_t k = 1; k < stack.layers.size(); ++k)
    for (Cell& cell : internal::Cell_tracer(stack, arcs, k).run()) {
      internal::descend(arcs, cell);
      cells.push_back(std::move(cell));
    }
  return cells;
}

}  // namespace CCSweep

#endif
