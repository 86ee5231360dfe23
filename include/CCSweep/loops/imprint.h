// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_IMPRINT_H
#define CCSWEEP_LOOPS_IMPRINT_H

#include <CCSweep/Status.h>
#include <CCSweep/concepts.h>
#include <CCSweep/internal/bucket_sort.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/Layer_drawing.h>
#include <CCSweep/loops/Loop_face_graph.h>
#include <CCSweep/loops/overlay_build.h>
#include <CCSweep/loops/overlay_chains.h>
#include <CCSweep/loops/overlay_edges.h>
#include <CCSweep/loops/overlay_face_labels.h>
#include <CCSweep/loops/overlay_pieces.h>
#include <CCSweep/loops/overlay_snap.h>
#include <CCSweep/loops/overlay_table.h>
#include <CCSweep/loops/segment_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CCSweep {

/// A layer after its imprint.
template <class Traits>
struct Imprint {
  using Point_2 = typename Traits::Point_2;

  /// A straight piece of a LoopEdge between two neighbouring nodes.
  struct Segment {
    Node_index source, target;
    Loop_label left, right;                 ///< empty on the outside
    Loop_face_index left_face, right_face;  ///< invalid on the outside
    Loop_coedge_index coedge;               ///< the LoopCoEdge that runs the same way and has `left_face` on its left
  };

  Loop_face_graph<Traits> graph;
  std::vector<Point_2> points;             ///< of all nodes: those of the drawing where they are now, then new ones
  std::vector<bool> fixed;                 ///< per node: lies on the input surface
  std::vector<bool> corner;                ///< per node: is a LoopVertex whatever meets there
  std::vector<Node_index> representative;  ///< per node of the drawing: the node it was merged into, else itself
  Node_chains chains;                      ///< per segment of the drawing: the nodes from its source to its target
  std::vector<int> lost;                   ///< labels of the drawing that no LoopFace has any more
  std::vector<std::string> notes;          ///< what was merged away

  /// The LoopFaces in a source and a target: the paper's Theta(o).
  std::vector<Loop_face_index> overlaps() const { return select(true, true); }
  /// The LoopFaces in a source only: the paper's Theta(s).
  std::vector<Loop_face_index> source_only() const { return select(true, false); }
  /// The LoopFaces in a target only: the paper's Theta(t).
  std::vector<Loop_face_index> target_only() const { return select(false, true); }

  /// The straight pieces of all LoopEdges, ascending by end nodes, with `source` less than `target`. Linear, for a
  /// bounded number of segments at a node.
  std::vector<Segment> segments() const {
    std::vector<Segment> result;
    for (std::size_t e = 0; e < graph.number_of_edges(); ++e) add_segments(Loop_coedge_index(2 * e), result);
    internal::bucket_sort(
        result, points.size(), [](const Segment& s) { return s.source.value(); },
        [](const Segment& s, const Segment& t) { return s.target < t.target; });
    return result;
  }

 private:
  void add_segments(Loop_coedge_index coedge, std::vector<Segment>& result) const {
    const Loop_coedge_index back = graph.opposite(coedge);
    const Segment forward{{}, {}, graph.label(coedge), graph.label(back), graph.loop_face(coedge),
                          graph.loop_face(back), coedge};
    const Segment backward{{}, {}, forward.right, forward.left, forward.right_face, forward.left_face, back};
    const std::span<const Node_index> nodes = graph.nodes(coedge);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      Segment& segment = result.emplace_back(nodes[i - 1] < nodes[i] ? forward : backward);
      std::tie(segment.source, segment.target) = std::minmax(nodes[i - 1], nodes[i]);
    }
  }

  std::vector<Loop_face_index> select(bool in_source, bool in_target) const {
    std::vector<Loop_face_index> result;
    for (std::size_t i = 0; i < graph.number_of_loop_faces(); ++i) {
      const Loop_label label = graph.label(Loop_face_index(i));
      if ((label.source != Loop_label::none) == in_source && (label.target != Loop_label::none) == in_target) {
        result.emplace_back(i);
      }
    }
    return result;
  }
};

namespace internal {

template <class Traits>
void draw_loops(Layer_drawing<Traits>& drawing, const std::vector<std::vector<typename Traits::Point_2>>& loops,
                const Loop_label& inside) {
  for (const auto& loop : loops) {
    const std::size_t first = drawing.nodes.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      drawing.nodes.push_back({loop[i]});
      drawing.segments.push_back({Node_index(first + i), Node_index(first + (i + 1) % loop.size()), inside, {}});
    }
  }
}

// Finds the labels that a drawing has on the sides of segments and of which nothing is left.
template <class Traits>
void find_lost(const std::vector<std::array<Loop_label, 2>>& drawn, Imprint<Traits>& imprint) {
  Number_set known;
  known.insert(Loop_label::none);
  Loop_label last;
  for (std::size_t f = 0; f < imprint.graph.number_of_loop_faces(); ++f) {
    const Loop_label l = imprint.graph.label(Loop_face_index(f));
    if (l.source != last.source) known.insert(l.source);
    if (l.target != last.target) known.insert(l.target);
    last = l;
  }
  for (const auto& sides : drawn) {
    for (const Loop_label& l : sides) {
      if (known.insert(l.source)) imprint.lost.push_back(l.source);
      if (known.insert(l.target)) imprint.lost.push_back(l.target);
    }
  }
  std::sort(imprint.lost.begin(), imprint.lost.end());
}

template <class Traits, class SegmentIndex>
Imprint<Traits> imprinted(const Layer_drawing<Traits>& drawing, double tolerance) {
  Imprint<Traits> result;
  using Pieces = Overlay_pieces<Traits>;
  Checked_drawing<Traits> checked = internal::checked(drawing, tolerance);
  Layer_nodes<Traits>& nodes = checked.nodes;
  const double off = has_exact_constructions<typename Traits::FT> ? 0 : checked.rounding();
  Snapped_segments snapped = snap<Traits, SegmentIndex>(drawing, checked, tolerance, Pieces::slack(off));

  const auto is_fixed = [&](std::size_t s) { return drawing.segments[s].fixed; };
  Pieces pieces(nodes, snapped.chains, snapped.steps, is_fixed, snapped.twins, std::move(snapped.near), tolerance, off);
  pieces.split_all();
  result.chains = pieces.expanded();

  const Overlay_edges edges = Edge_sum<Traits>::of(drawing.segments, result.chains, nodes);
  const Planar_map<Traits> map(nodes, edges);
  Graph_builder<Traits> builder(map, nodes, Face_labels<Traits>::of(map, nodes));
  result.graph = std::move(builder.graph());

  result.points = std::move(nodes.points);
  result.fixed = std::move(nodes.fixed);
  result.corner = std::move(nodes.corner);
  result.representative = std::move(nodes.representative);
  result.notes = std::move(nodes.notes);
  find_lost(checked.sides, result);
  return result;
}

}  // namespace internal

/// Imprints and merges the sources and targets of a layer (section 2.7): overlays everything drawn into one graph of
/// LoopFaces, each with the source and the target it is part of.
///
/// First the drawing is snapped; the rules, in this order:
/// 1. Nodes with equal points are merged. With `tolerance` 0 that is all.
/// 2. A free node within the tolerance of a fixed node merges into it, then free nodes into corners, then free nodes
///    into one another; nearest first. Fixed nodes never move, nor do fixed segments.
/// 3. A free node within the tolerance of a fixed segment moves to the foot on it (or to an end that is within the
///    tolerance of the foot), becomes fixed, and splits the segment.
/// 4. A node within the tolerance of a free segment splits it, and the segment bends through the node. Fixed segments,
///    and free ones between two points of a fixed one, bend through nodes within rounding only.
/// In 3 and 4 the tolerance is the larger of `tolerance` and the chord errors where the segment and a segment of the
/// node both stand for arcs and run within 30 degrees of each other; and a free node, or a free segment by those at its
/// ends, snaps to what is fixed within its `reach`. No rule reaches further than a third of the
/// distance to the nearest fixed feature that is not incident to node or segment.
/// Then the overlay is exact: every decision is an exact predicate. Where the kernel rounds constructions, the pieces
/// at a rounded crossing are tested again, a bounded number of times.
///
/// What coincident segments say of a set adds up; edges that then say nothing are dropped. Edges are joined into
/// LoopEdges through nodes where nothing ends and that are no corners. A closed curve without a LoopVertex gets two,
/// both of degree 2 and no corners.
///
/// @tparam Traits a model of `SweepTraits`
/// @tparam SegmentIndex a model of `SegmentIndex_2`
/// @param tolerance absolute, in units of the chart; not negative
/// @return `imprint_failed` with place and patch ids where pieces of one set overlap, an outline is not closed, or
/// rounding does not settle; `invalid_parameter` for a bad tolerance, a segment whose nodes do not exist or a point
/// that is not finite.
/// The place is in the chart, its third coordinate 0.
///
/// O((n + k) log n) for n segments and k crossings and snaps, where boxes of distant segments seldom overlap.
template <SweepTraits Traits, SegmentIndex_2 SegmentIndex = Rtree_segment_index_2<Traits>>
Result<Imprint<Traits>> imprint_layer(const Layer_drawing<Traits>& drawing, double tolerance) {
  return internal::guarded([&] { return internal::imprinted<Traits, SegmentIndex>(drawing, tolerance); });
}

/// The imprint operator of Fig. 11 for two faces: cuts S and T into what they share and what is in one of them only,
/// which the queries `overlaps()`, `source_only()` and `target_only()` of the result list. All nodes are free.
///
/// @param s, t the loops of the faces, with the face on their left: outer ones counterclockwise, inner ones clockwise
/// @return as `imprint_layer`; the label of S is source 0, that of T target 0
template <SweepTraits Traits, SegmentIndex_2 SegmentIndex = Rtree_segment_index_2<Traits>>
Result<Imprint<Traits>> imprint_faces(const std::vector<std::vector<typename Traits::Point_2>>& s,
                                      const std::vector<std::vector<typename Traits::Point_2>>& t, double tolerance) {
  Layer_drawing<Traits> drawing;
  internal::draw_loops(drawing, s, Loop_label{0, Loop_label::none});
  internal::draw_loops(drawing, t, Loop_label{Loop_label::none, 0});
  return imprint_layer<Traits, SegmentIndex>(drawing, tolerance);
}

}  // namespace CCSweep

#endif
