// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_ARC_NODES_H
#define CCSWEEP_HEX_ARC_NODES_H

#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/trace_cells.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CCSweep::internal {

/// The nodes of the mesh on the arcs of all layers: each junction and each arc has its nodes once, whichever cells
/// share it, so that the mesh conforms by construction.
///
/// \tparam CapDrop as in `make_arc_stack()`
template <class CapDrop>
class Arc_nodes {
  using Half_arc = Arc_stack::Half_arc;

 public:
  Arc_nodes(const Layer_stack& stack, const Arc_stack& arcs, const Arc_intervals& intervals, const CapDrop& drop)
      : stack_(stack), arcs_(arcs), intervals_(intervals), drop_(drop), of_junction_(arcs.points.size(), none) {
    for (const auto& layer : arcs.arcs) first_of_arc_.emplace_back(layer.size(), none);
  }

  /// The nodes around a loop of a layer, by their numbers in `points`.
  std::vector<std::uint32_t> around(std::size_t layer, const Cell::Loop& loop) {
    std::vector<std::uint32_t> nodes;
    for (Half_arc h : loop) {
      const std::uint32_t first = first_of(layer, h);
      const std::size_t inner = intervals_(layer, h) - 1;
      nodes.push_back(junction(arcs_.source(layer, h)));
      for (std::size_t i = 0; i < inner; ++i)
        nodes.push_back(first + static_cast<std::uint32_t>(Arc_stack::is_reversed(h) ? inner - 1 - i : i));
    }
    return nodes;
  }

  /// The nodes of an arc, both ends included.
  std::vector<std::uint32_t> on(std::size_t layer, Half_arc h) {
    std::vector<std::uint32_t> nodes = around(layer, {h});
    nodes.push_back(junction(arcs_.target(layer, h)));
    return nodes;
  }

  bool is_used(std::size_t layer, Half_arc h) const { return first_of_arc_[layer][Arc_stack::arc_of(h)] != none; }

  std::vector<Vec3> points;

 private:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  std::uint32_t junction(Arc_stack::Node n) {
    if (of_junction_[n] == none) {
      of_junction_[n] = static_cast<std::uint32_t>(points.size());
      points.push_back(arcs_.points[n]);
    }
    return of_junction_[n];
  }

  std::uint32_t first_of(std::size_t layer, Half_arc h) {
    std::uint32_t& first = first_of_arc_[layer][Arc_stack::arc_of(h)];
    if (first != none) return first;
    first = static_cast<std::uint32_t>(points.size());
    const Arc_stack::Arc& arc = arcs_.arc(layer, h);
    const Vec3& up = stack_.layers[layer].up;
    const std::vector<Vec3> nodes = place_on_arc(arc, intervals_(layer, h), up);
    const Patch_index cap = cap_of(layer, arc);
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
      points.push_back(cap.is_valid() ? drop_(cap, nodes[i], up) : nodes[i]);
    return first;
  }

  // The cap inside which an arc lies. Between its nodes it may leave the facets of a bent one.
  Patch_index cap_of(std::size_t layer, const Arc_stack::Arc& arc) const {
    if (arc.left.source.is_valid() && arc.left.source == arc.right.source) return arc.left.source;
    const Patch_index target = arc.left.target;
    const bool inside = target.is_valid() && target == arc.right.target && arc.below[0] == Arc_stack::none &&
                        arc.below[1] == Arc_stack::none && stack_.layer_of_cap[target.value()] == layer;
    return inside ? target : Patch_index();
  }

  const Layer_stack& stack_;
  const Arc_stack& arcs_;
  const Arc_intervals& intervals_;
  const CapDrop& drop_;
  std::vector<std::uint32_t> of_junction_;
  std::vector<std::vector<std::uint32_t>> first_of_arc_;
};

}  // namespace CCSweep::internal

#endif
