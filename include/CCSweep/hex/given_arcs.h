// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_GIVEN_ARCS_H
#define CCSWEEP_HEX_GIVEN_ARCS_H

#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_nodes.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/Given_nodes.h>
#include <CCSweep/part/Part.h>

#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// An arc on walls whose nodes are given.
struct Given_arc {
  std::size_t layer;
  Arc_stack::Half_arc half;
  std::vector<Vec3> nodes;  ///< from the one end to the other
};

/// All of them: above and below the walls.
inline std::vector<Given_arc> given_arcs(const Cell_stack& stack, const Given_nodes& given) {
  std::set<std::pair<std::size_t, Arc_stack::Half_arc>> found;
  for (std::size_t k = 1; k < stack.arcs.arcs.size(); ++k)
    for (std::size_t a = 0; a < stack.arcs.arcs[k].size(); ++a)
      for (std::size_t side : {0, 1}) {
        const Arc_stack::Arc& arc = stack.arcs.arcs[k][a];
        if (!arc.wall[side].is_valid() || !given.are_on(stack.id(arc.wall[side]))) continue;
        found.emplace(k, static_cast<Arc_stack::Half_arc>(2 * a));
        if (const auto below = arc.below[side]; below != Arc_stack::none)
          found.emplace(k - 1, static_cast<Arc_stack::Half_arc>(2 * Arc_stack::arc_of(below)));
      }
  std::vector<Given_arc> arcs;
  for (const auto& [layer, half] : found)
    if (auto nodes = given.along(stack.arcs.arc(layer, half).line); nodes.size() > 1)
      arcs.push_back({layer, half, std::move(nodes)});
  return arcs;
}

/// Fixes the numbers of intervals on such arcs.
inline void give_intervals(const std::vector<Given_arc>& arcs, Arc_intervals& intervals) {
  for (const Given_arc& arc : arcs) intervals.give(arc.layer, arc.half, arc.nodes.size() - 1);
}

/// Puts the nodes of such arcs where they are given, if the solver could keep their numbers.
template <class CapDrop>
void give_nodes(const std::vector<Given_arc>& arcs, Arc_nodes<CapDrop>& nodes) {
  for (const Given_arc& arc : arcs) {
    if (!nodes.is_used(arc.layer, arc.half)) continue;
    const std::vector<std::uint32_t> on_arc = nodes.on(arc.layer, arc.half);
    if (on_arc.size() != arc.nodes.size()) continue;
    for (std::size_t i = 0; i < on_arc.size(); ++i) nodes.points[on_arc[i]] = arc.nodes[i];
  }
}

}  // namespace CCSweep::internal

#endif
