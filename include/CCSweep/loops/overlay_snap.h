// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_SNAP_H
#define CCSWEEP_LOOPS_OVERLAY_SNAP_H

#include <CCSweep/Layer_drawing.h>
#include <CCSweep/loops/overlay_chains.h>
#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_near.h>
#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/snap_clearance.h>
#include <CCSweep/loops/snap_merge.h>
#include <CCSweep/loops/snap_segments.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace CCSweep::internal {

// A drawing, looked through once.
template <class Traits>
struct Checked_drawing {
  Layer_nodes<Traits> nodes;
  double size = 0;               // the largest coordinate
  double reach = 0;              // the largest chord error or reach of a node
  bool has_neighbours = false;   // a set has several faces: what they share is often drawn twice
  bool has_loose_nodes = false;  // no segment ends there
  bool has_short_segments = false;
  std::vector<std::array<Loop_label, 2>> sides;  // all that segments have, some of them more than once

  // How far rounding may take a constructed point from where it should be: a few units in the last place.
  double rounding() const { return 8 * std::numeric_limits<double>::epsilon() * size; }
};

template <class Traits>
void read_nodes(const Layer_drawing<Traits>& drawing, Checked_drawing<Traits>& result) {
  const std::size_t size = drawing.nodes.size();
  Layer_nodes<Traits>& nodes = result.nodes;
  nodes.points.reserve(2 * size);  // those at crossings will follow
  nodes.representative.reserve(size);
  nodes.fixed.assign(size, false);
  nodes.corner.assign(size, false);
  double largest = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const auto& node = drawing.nodes[i];
    const double x = std::fabs(CGAL::to_double(node.point.x())), y = std::fabs(CGAL::to_double(node.point.y()));
    if (!std::isfinite(x) || !std::isfinite(y)) {
      fail(Status_code::invalid_parameter, Stage::imprint, "a coordinate of the layer is not a finite number");
    }
    largest = std::max(largest, std::max(x, y));
    nodes.points.push_back(node.point);
    nodes.representative.emplace_back(i);
    if (node.fixed) nodes.fixed[i] = true;
    if (node.corner) nodes.corner[i] = true;
    if (node.reach > 0) {
      nodes.reaches.resize(size, 0);
      nodes.reaches[i] = node.reach;
      result.reach = std::max(result.reach, node.reach);
    }
  }
  result.size = largest;
}

// Whether a set has several faces.
inline bool have_neighbours(const std::vector<std::array<Loop_label, 2>>& sides) {
  Loop_label first;
  const auto is_another = [](int label, int& known) {
    if (known == Loop_label::none) known = label;
    return label != Loop_label::none && label != known;
  };
  for (const auto& both : sides) {
    for (const Loop_label& label : both) {
      if (is_another(label.source, first.source) || is_another(label.target, first.target)) return true;
    }
  }
  return false;
}

// Whether snapping may make a point of a segment.
template <class Traits>
bool is_short(const typename Layer_drawing<Traits>::Segment& segment, const Layer_nodes<Traits>& nodes,
              double tolerance) {
  if (tolerance == 0) return is_equal<Traits>(nodes.point(segment.source), nodes.point(segment.target));
  return distance(nodes.place(segment.source), nodes.place(segment.target)) <=
         std::max(tolerance, segment.chord_error);
}

template <class Traits>
void read_segments(const Layer_drawing<Traits>& drawing, double tolerance, Checked_drawing<Traits>& result) {
  std::vector<char> is_end(drawing.nodes.size(), false);
  std::array<Loop_label, 2> last;
  for (const auto& segment : drawing.segments) {
    const Node_index a = segment.source, b = segment.target;
    if (std::max(a, b).value() >= is_end.size()) {
      fail(Status_code::invalid_parameter, Stage::imprint, "a segment ends at a node that does not exist");
    }
    is_end[a.value()] = is_end[b.value()] = true;
    // What a fixed segment ends at can't move without it.
    if (segment.fixed) result.nodes.fixed[a.value()] = result.nodes.fixed[b.value()] = true;
    result.reach = std::max(result.reach, segment.chord_error);
    if (is_short(segment, result.nodes, tolerance)) result.has_short_segments = true;
    if (segment.left == last[0] && segment.right == last[1]) continue;
    last = {segment.left, segment.right};
    result.sides.push_back(last);
  }
  result.has_neighbours = have_neighbours(result.sides);
  result.has_loose_nodes = std::find(is_end.begin(), is_end.end(), false) != is_end.end();
}

// Refuses what is no drawing.
template <class Traits>
Checked_drawing<Traits> checked(const Layer_drawing<Traits>& drawing, double tolerance) {
  if (!(tolerance >= 0) || std::isinf(tolerance)) {
    fail(Status_code::invalid_parameter, Stage::imprint, "the tolerance must be a finite number, and not negative");
  }
  Checked_drawing<Traits> result;
  read_nodes(drawing, result);
  read_segments(drawing, tolerance, result);
  return result;
}

// The drawing after snapping: each of its segments as a chain of nodes.
struct Snapped_segments {
  Node_chains chains;
  std::vector<Step> steps;           // of all chains
  std::vector<std::uint32_t> twins;  // per step, as `first_twins` tells; may be empty
  std::vector<Near_pair> near;       // the steps that may meet, without twins
};

// The chains of segments that nothing splits, and their steps.
template <class Traits>
Snapped_segments straight_segments(const Layer_drawing<Traits>& drawing, const Layer_nodes<Traits>& nodes) {
  Snapped_segments result;
  std::vector<Node_index> chained(2 * drawing.segments.size());
  std::vector<std::uint32_t> ends(drawing.segments.size());
  result.steps.reserve(ends.size());
  std::uint32_t size = 0;
  for (std::size_t s = 0; s < ends.size(); ++s) {
    const auto& segment = drawing.segments[s];
    const Node_index a = nodes.representative[segment.source.value()], b = nodes.representative[segment.target.value()];
    chained[size] = a;
    chained[size + 1] = b;
    size += a == b ? 1 : 2;
    ends[s] = size;
    if (a != b) result.steps.push_back({a, b});
  }
  chained.resize(size);
  result.chains = {std::move(chained), std::move(ends)};
  return result;
}

template <class Traits>
std::vector<Fixed_feature> fixed_features(const Layer_drawing<Traits>& drawing, const Layer_nodes<Traits>& nodes) {
  std::vector<Fixed_feature> result;
  std::vector<bool> covered(drawing.nodes.size(), false);
  for (const auto& segment : drawing.segments) {
    const Node_index a = nodes.representative[segment.source.value()], b = nodes.representative[segment.target.value()];
    if (!segment.fixed || a == b) continue;
    result.push_back({a, b});
    covered[a.value()] = covered[b.value()] = true;
  }
  for (std::size_t i = 0; i < drawing.nodes.size(); ++i) {
    const Node_index n(i);
    if (nodes.fixed[i] && !covered[i] && nodes.representative[i] == n) result.push_back({n, n});
  }
  return result;
}

template <class Traits>
std::size_t number_merged(const Layer_nodes<Traits>& nodes) {
  std::size_t result = 0;
  for (std::size_t i = 0; i < nodes.representative.size(); ++i) {
    if (nodes.representative[i] != Node_index(i)) ++result;
  }
  return result;
}

// Says whether snapping could change anything where all nodes are ends and no segment is short; if not, all of it can
// be left out.
template <class Traits>
class Snap_need {
 public:
  Snap_need(const Layer_drawing<Traits>& drawing, const std::vector<Step>& steps, const Layer_nodes<Traits>& nodes,
            double tolerance)
      : drawing_(drawing), steps_(steps), nodes_(nodes), tolerance_(tolerance) {}

  // `near` are the pairs of segments within the tolerance, their chord errors and reaches, or more. Neighbours that run
  // on are not as near as either is long.
  bool exists(const std::vector<Near_pair>& near) const {
    return std::any_of(near.begin(), near.end(), [this](const Near_pair& pair) {
      return tolerance_ == 0 ? have_equal_ends(steps_[pair.first], steps_[pair.second])
                             : is_close(drawing_.segments[pair.first], drawing_.segments[pair.second]);
    });
  }

 private:
  using Segment = typename Layer_drawing<Traits>::Segment;

  bool have_equal_ends(const Step& s, const Step& t) const {
    for (const Node_index n : s) {
      for (const Node_index m : t) {
        if (n != m && is_equal<Traits>(nodes_.point(n), nodes_.point(m))) return true;
      }
    }
    return false;
  }

  bool is_close(const Segment& s, const Segment& t) const {
    const double reach = std::max({tolerance_, s.chord_error, t.chord_error, nodes_.reach(s.source, s.target),
                                   nodes_.reach(t.source, t.target)});
    for (Node_index common : {s.source, s.target}) {
      if (common != t.source && common != t.target) continue;
      const Node_index n = common == s.source ? s.target : s.source, m = common == t.source ? t.target : t.source;
      return n != m && are_close_beyond(common, n, m, reach);
    }
    return touches(s.source, t, reach) || touches(s.target, t, reach) || touches(t.source, s, reach) ||
           touches(t.target, s, reach);
  }

  // For segments from a common node to n and m.
  bool are_close_beyond(Node_index common, Node_index n, Node_index m, double reach) const {
    const Place_2 c = nodes_.place(common), p = nodes_.place(n), q = nodes_.place(m);
    if ((p[0] - c[0]) * (q[0] - c[0]) + (p[1] - c[1]) * (q[1] - c[1]) <= 0) return false;
    return std::fmin(closest(p, c, q).distance, closest(q, c, p).distance) <= reach * safety;
  }

  bool touches(Node_index n, const Segment& segment, double reach) const {
    return closest(nodes_.place(n), nodes_.place(segment.source), nodes_.place(segment.target)).distance <=
           reach * safety;
  }

  static constexpr double safety = 1 + 1e-6;  // the same distances, computed in another order
  const Layer_drawing<Traits>& drawing_;
  const std::vector<Step>& steps_;  // one for each segment
  const Layer_nodes<Traits>& nodes_;
  double tolerance_;
};

template <class Traits, class SegmentIndex>
Node_chains snapped_chains(const Layer_drawing<Traits>& drawing, Layer_nodes<Traits>& nodes, double tolerance,
                           double rounding) {
  const std::size_t equal = number_merged(nodes);
  const Snap_clearance<Traits, SegmentIndex> clearance(nodes, fixed_features(drawing, nodes));
  Node_merger<Traits, SegmentIndex>(nodes, clearance, tolerance).run();
  Segment_snapper<Traits, SegmentIndex> segments(drawing, nodes, clearance, tolerance, rounding);
  segments.run();
  if (const std::size_t snapped = number_merged(nodes) - equal; snapped > 0) {
    nodes.notes.push_back(std::to_string(snapped) + " nodes were merged within the tolerance");
  }
  Node_chains result;
  for (std::size_t s = 0; s < drawing.segments.size(); ++s) {
    for (Node_index n : segments.chain(s)) result.push_back(n);
    result.close();
  }
  return result;
}

// Tolerant snapping (section 2.7) of a drawing and the nodes it was checked with; the rules stand at `imprint_layer`.
// `slack` is what may still move later on.
template <class Traits, class SegmentIndex>
Snapped_segments snap(const Layer_drawing<Traits>& drawing, Checked_drawing<Traits>& checked, double tolerance,
                      double slack) {
  Layer_nodes<Traits>& nodes = checked.nodes;
  Snapped_segments result;
  const bool is_sure = checked.has_loose_nodes || checked.has_short_segments;
  if (!is_sure && !(tolerance == 0 && checked.has_neighbours)) {
    const double reach = tolerance == 0 ? 0 : std::fmax(tolerance, checked.reach);
    result = straight_segments(drawing, nodes);
    result.near = near_steps<SegmentIndex>(result.steps, {}, nodes, reach + slack);
    if (!Snap_need<Traits>(drawing, result.steps, nodes, tolerance).exists(result.near)) return result;
  }
  merge_equal(nodes);
  if (tolerance == 0) {
    result = straight_segments(drawing, nodes);
  } else {
    result.chains = snapped_chains<Traits, SegmentIndex>(drawing, nodes, tolerance, checked.rounding());
    result.steps = steps_of(result.chains);
  }
  result.twins = first_twins(result.steps, nodes.points.size());
  result.near = near_steps<SegmentIndex>(result.steps, result.twins, nodes, tolerance + slack);
  return result;
}

}  // namespace CCSweep::internal

#endif
