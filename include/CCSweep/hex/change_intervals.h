// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CHANGE_INTERVALS_H
#define CCSWEEP_HEX_CHANGE_INTERVALS_H

#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Cell_outlines.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/outline_faults.h>
#include <CCSweep/hex/plane.h>

#include <cstddef>
#include <set>
#include <vector>

namespace CCSweep::internal {

/// The edges around a cell on a layer, seen along the sweep.
inline std::vector<Outline_edge> outline_edges(const Cell_stack& stack, std::size_t c, std::size_t layer,
                                               const Cell_outlines& outlines) {
  const Cell& cell = stack.cells[c];
  const Plane_chart plane(stack.layers.layers[layer].up);
  const std::vector<Point2> nodes = plane(outlines.places(c, layer));
  std::vector<Outline_edge> edges;
  std::size_t arc = 0;
  for (const Cell::Loop& loop : cell.loops[0]) {
    const std::size_t first = edges.size();
    for (Arc_stack::Half_arc h : loop) {
      for (std::size_t i = 0; i < outlines.intervals(cell.top, h); ++i) edges.push_back({nodes[edges.size()], {}, arc});
      ++arc;
    }
    for (std::size_t e = first; e < edges.size(); ++e) edges[e].b = nodes[e + 1 < edges.size() ? e + 1 : first];
  }
  return edges;
}

/// The arcs of a cell's outline that are drawn too coarsely on some layer; where there are none, and the cell has a
/// mesh, those at narrow gaps.
inline std::set<std::size_t> arcs_at_fault(const Cell_stack& stack, std::size_t c, const Cell_outlines& outlines,
                                           bool has_mesh) {
  const Cell& cell = stack.cells[c];
  std::set<std::size_t> faults;
  for (const auto& find : {arcs_too_coarse, arcs_at_gaps}) {
    for (std::size_t k = cell.bottom; k <= cell.top; ++k) faults.merge(find(outline_edges(stack, c, k, outlines)));
    if (!faults.empty() || !has_mesh) break;
  }
  return faults;
}

/// Asks for even numbers around the cells whose quality is not good, so that they can be subdivided.
inline void make_even(const Cell_stack& stack, const std::vector<double>& quality, double good,
                      Arc_intervals& intervals) {
  for (std::size_t c = 0; c < stack.cells.size(); ++c) {
    if (quality[c] >= good) continue;
    for (const Cell::Loop& loop : stack.cells[c].loops[0])
      for (Arc_stack::Half_arc h : loop) intervals.make_even(stack.cells[c].top, h);
  }
}

/// Asks for more intervals on the arcs at fault of the cells whose quality is not acceptable, or on all around them
/// where none is at fault. Several cells may want the same arcs refined, which is done once.
/// \param quality by cell; below -1 where a cell has no mesh
inline void refine(const Cell_stack& stack, const std::vector<double>& quality, double acceptable,
                   const Cell_outlines& outlines, Arc_intervals& intervals) {
  std::set<std::size_t> too_coarse;
  for (std::size_t c = 0; c < stack.cells.size(); ++c) {
    if (quality[c] >= acceptable) continue;
    const std::set<std::size_t> faults = arcs_at_fault(stack, c, outlines, quality[c] > -2);
    std::size_t arc = 0;
    for (const Cell::Loop& loop : stack.cells[c].loops[0])
      for (Arc_stack::Half_arc h : loop)
        if (faults.count(arc++) > 0 || faults.empty())
          too_coarse.insert(intervals.arc_class(stack.cells[c].top, h));
  }
  for (std::size_t arc_class : too_coarse) intervals.refine(arc_class);
}

}  // namespace CCSweep::internal

#endif
