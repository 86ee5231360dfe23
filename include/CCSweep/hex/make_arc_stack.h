// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MAKE_ARC_STACK_H
#define CCSWEEP_HEX_MAKE_ARC_STACK_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Carried_columns.h>
#include <CCSweep/hex/Junctions.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/Slab_columns.h>
#include <CCSweep/hex/Slab_descent.h>
#include <CCSweep/internal/guarded.h>

#include <map>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// From the top layer down, finds the arc below every arc, and carries the arcs that no wall and no cut leads down,
/// the outlines of the sources inside a target's column, through the material.
template <class CapDrop>
class Arc_linker {
  using Node = Arc_stack::Node;
  using Arc = Arc_stack::Arc;
  using Half_arc = Arc_stack::Half_arc;

 public:
  Arc_linker(const Layer_stack& stack, const CapDrop& drop_to_cap)
      : stack_(stack),
        columns_(stack, result_,
                 [&](Patch_index cap, const Vec3& p, const Vec3& up) { return drop_to_cap(cap, p, up); }) {}

  Arc_stack run() {
    const std::size_t n = stack_.layers.size();
    for (std::size_t k = 0; k + 1 < n; ++k) slabs_.emplace_back(stack_, k);
    Junctions junctions(stack_, slabs_);
    junctions.run();
    std::vector<Arc_builder> builders;
    for (std::size_t k = 0; k < n; ++k) result_.arcs.push_back(builders.emplace_back(stack_, junctions, k).run());
    result_.points = junctions.points;
    for (std::size_t k = n; k-- > 1;) link_layer(k, junctions, builders[k - 1]);
    columns_.correct();
    return std::move(result_);
  }

 private:
  void link_layer(std::size_t k, const Junctions& junctions, const Arc_builder& lower) {
    Slab_descent descent(stack_, k - 1);
    carried_.clear();
    for (std::size_t a = 0; a < result_.arcs[k].size(); ++a) {
      Arc& arc = result_.arcs[k][a];
      const bool on_left = stack_.is_below(arc.left, k), on_right = stack_.is_below(arc.right, k);
      if (on_left && on_right && arc.left.target == arc.right.target) {
        carry_down(k, a, junctions, descent);
      } else {
        if (on_left) follow_column(k, arc, 0, lower);
        if (on_right) follow_column(k, arc, 1, lower);
      }
    }
  }

  // Down the wall or the cut under one side of an arc.
  void follow_column(std::size_t k, Arc& arc, int side, const Arc_builder& lower) const {
    for (const Column_place& column : slabs_[k - 1].below(arc.middle)) {
      if (column.wall.is_valid() && column.is_left != (arc.along_segment == (side == 0))) continue;
      const Half_arc along = lower.half_arc_at(column.place);
      const bool same_sense = arc.along_segment != column.is_reversed;
      const Half_arc below = same_sense ? along : Arc_stack::opposite(along);
      arc.below[side] = side == 0 ? below : Arc_stack::opposite(below);
      arc.wall[side] = column.wall;
      return;
    }
    fail(Status_code::inconsistent_levels, Stage::hex_mesh, "a curve of a layer has nothing below it", {}, arc.line[0]);
  }

  void carry_down(std::size_t k, std::size_t a, const Junctions& junctions, Slab_descent& descent) {
    Arc& arc = result_.arcs[k][a];
    const Patch_index target = arc.left.target;
    const std::size_t barrel = descent.barrel_of(arc.line[arc.line.size() / 2]);
    const auto down = [&](const Vec3& p) { return descent(barrel, p); };
    Arc lower;
    lower.left = lower.right = {Patch_index(), target};
    lower.from = junction_below(k, arc.from, target, junctions, down);
    lower.to = junction_below(k, arc.to, target, junctions, down);
    lower.line.push_back(result_.points[lower.from]);
    for (std::size_t i = 1; i + 1 < arc.line.size(); ++i) lower.line.push_back(down(arc.line[i]));
    lower.line.push_back(result_.points[lower.to]);
    const auto h = static_cast<Half_arc>(2 * result_.arcs[k - 1].size());
    arc.below = {h, Arc_stack::opposite(h)};
    columns_.add_arc(k - 1, a, result_.arcs[k - 1].size(), target);
    result_.arcs[k - 1].push_back(std::move(lower));
  }

  // A junction on the border of a target's column has one below it; any other is carried down.
  template <class Down>
  Node junction_below(std::size_t k, Node n, Patch_index target, const Junctions& junctions, const Down& down) {
    const auto goes_up_from = [&](const Layer_stack::Side& side) {
      return Layer_stack::is_above(side) && side.target == target;
    };
    if (n < junctions.points.size())
      for (const Segment_place& place : junctions.places(k, n))
        for (const Column_place& column : slabs_[k - 1].below(place)) {
          const auto& s = stack_.layers[k - 1].segments[column.place.segment];
          if (goes_up_from(s.left) || goes_up_from(s.right)) return junctions.at(k - 1, column.place);
        }
    const auto [found, is_new] = carried_.try_emplace(n, static_cast<Node>(result_.points.size()));
    if (is_new) {
      result_.points.push_back(down(result_.points[n]));
      columns_.add_junction(k - 1, n, found->second, target);
    }
    return found->second;
  }

  const Layer_stack& stack_;
  std::vector<Slab_columns> slabs_;
  Arc_stack result_;
  Carried_columns columns_;
  std::map<Node, Node> carried_;  // junctions inside the material of one slab: the one below
};

}  // namespace internal

/// Turns the imprinted layers into junctions and arcs with their columns (sections 2.3 and 2.7): every junction
/// appears on every layer its column reaches, and the outlines of all sources are carried down to their targets.
///
/// \param drop_to_cap callable as `(Patch_index cap, const Vec3& p, const Vec3& up) -> Vec3`: the point of the cap that
/// the line along `up` through p meets
/// \return the arcs; throws `internal::Failure` where a column is lost.
/// Complexity: O(n log n) in the nodes of all layers.
template <class CapDrop>
Arc_stack make_arc_stack(const Layer_stack& stack, const CapDrop& drop_to_cap) {
  return internal::Arc_linker<CapDrop>(stack, drop_to_cap).run();
}

}  // namespace CCSweep

#endif
