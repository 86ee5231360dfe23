// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CELL_OUTLINES_H
#define CCSWEEP_HEX_CELL_OUTLINES_H

#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_nodes.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/even_heights.h>
#include <CCSweep/hex/given_arcs.h>
#include <CCSweep/hex/plane.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The nodes around all cells on all of their layers, at some numbers of intervals. Neighbours share them.
class Cell_outlines {
 public:
  using Numbers = std::vector<std::uint32_t>;
  using Half_arc = Arc_stack::Half_arc;

  /// \param intervals must live as long as this
  /// \param drop as in `make_arc_stack()`
  /// \param given arcs whose nodes are known
  template <class CapDrop>
  Cell_outlines(const Cell_stack& stack, const Arc_intervals& intervals, const CapDrop& drop,
                const std::vector<Given_arc>& given = {})
      : stack_(&stack), intervals_(&intervals), numbers_(stack.cells.size()) {
    Arc_nodes<CapDrop> nodes(stack.layers, stack.arcs, intervals, drop);
    for (std::size_t c = 0; c < stack.cells.size(); ++c) {
      const Cell& cell = stack.cells[c];
      for (std::size_t k = cell.bottom; k <= cell.top; ++k) {
        Numbers& around = numbers_[c].emplace_back();
        for (const Cell::Loop& loop : cell.loops[cell.top - k])
          for (std::uint32_t n : nodes.around(k, loop)) around.push_back(n);
      }
    }
    if (stack.layers.is_straight) Even_heights(stack.layers, stack.arcs, nodes).run();
    give_nodes(given, nodes);
    points_ = std::move(nodes.points);
  }

  const std::vector<Vec3>& points() const { return points_; }
  /// Takes over what has become of the nodes, which are the first ones of a mesh.
  void move_to(const std::vector<Vec3>& of_mesh) { std::copy_n(of_mesh.begin(), points_.size(), points_.begin()); }

  /// The nodes around a cell, by layer from the bottom up; of each layer one loop after the other.
  const std::vector<Numbers>& around(std::size_t c) const { return numbers_[c]; }

  /// Their places on one layer.
  std::vector<Vec3> places(std::size_t c, std::size_t layer) const {
    std::vector<Vec3> places;
    for (std::uint32_t n : numbers_[c][layer - stack_->cells[c].bottom]) places.push_back(points_[n]);
    return places;
  }

  std::size_t intervals(std::size_t layer, Half_arc h) const { return (*intervals_)(layer, h); }

  /// How many nodes a loop has.
  std::size_t length(std::size_t layer, const Cell::Loop& loop) const {
    std::size_t length = 0;
    for (Half_arc h : loop) length += intervals(layer, h);
    return length;
  }

  /// The section of a cell on a layer, to be meshed with quads.
  Quad_region region(std::size_t c, std::size_t layer, const std::vector<Vec3>& places) const {
    const Cell& cell = stack_->cells[c];
    const std::vector<int>& turns = stack_->turns[c];
    const Plane_chart plane(stack_->layers.layers[layer].up);
    Quad_region region;
    std::size_t at = 0;
    for (const Cell::Loop& loop : cell.loops[0]) {
      auto& made = region.loops.emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int turn = turns.empty() ? 0 : turns[i];
        if (turn > 0) made.corners.push_back(made.nodes.size());
        if (turn < 0) made.reflex.push_back(made.nodes.size());
        for (std::size_t k = 0; k < intervals(cell.top, loop[i]); ++k) made.nodes.push_back(plane(places[at++]));
      }
    }
    return region;
  }

 private:
  const Cell_stack* stack_;
  const Arc_intervals* intervals_;
  std::vector<std::vector<Numbers>> numbers_;  // by cell and layer from the bottom
  std::vector<Vec3> points_;
};

}  // namespace CCSweep::internal

#endif
