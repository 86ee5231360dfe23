// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_SNAP_SEGMENTS_H
#define CCSWEEP_LOOPS_SNAP_SEGMENTS_H

#include <CCSweep/Layer_drawing.h>
#include <CCSweep/loops/box_runs.h>
#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/snap_clearance.h>
#include <CCSweep/loops/snap_merge.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// The vertex-segment rule. A free node near a fixed segment moves to the foot on it and splits it; a node near a
// free segment splits that one, which then bends through the node. Facets of one arc get a tolerance of their own:
// a node and a segment whose facets stand for arcs and run nearly parallel snap within the larger chord error. Only
// rounding may bend a fixed segment, and a free one between two points of a fixed one stays with it.
template <class Traits, class SegmentIndex>
class Segment_snapper {
 public:
  using Drawing = Layer_drawing<Traits>;
  using Segment = typename Drawing::Segment;

  Segment_snapper(const Drawing& drawing, Layer_nodes<Traits>& nodes,
                  const Snap_clearance<Traits, SegmentIndex>& clearance, double tolerance, double rounding)
      : drawing_(drawing), nodes_(nodes), clearance_(clearance), tolerance_(tolerance), rounding_(rounding) {
    splits_.resize(drawing.segments.size());
    foot_on_.resize(drawing.nodes.size(), none);
    places_.reserve(drawing.nodes.size());
    own_.resize(drawing.nodes.size());
    walls_at_.resize(drawing.nodes.size());
    for (std::size_t i = 0; i < drawing.nodes.size(); ++i) places_.push_back(nodes.place(Node_index(i)));
    for (std::size_t s = 0; s < drawing.segments.size(); ++s) {
      if (is_point(s)) continue;
      for (Node_index n : {a(s), b(s)}) {
        if (drawing.segments[s].chord_error > 0) own_[n.value()].push_back(s);
        if (drawing.segments[s].fixed) walls_at_[n.value()].push_back(s);
      }
    }
  }

  void run() {
    move_to_fixed();
    merge_equal(nodes_);
    bend_segments();
  }

  // The nodes that a segment of the drawing passes through, representatives only.
  std::vector<Node_index> chain(std::size_t s) const {
    std::vector<std::pair<double, Node_index>> inner = splits_[s];
    for (auto& [parameter, n] : inner) n = nodes_.representative[n.value()];
    std::sort(inner.begin(), inner.end());
    std::vector<Node_index> result{a(s)};
    for (const auto& [parameter, n] : inner) {
      if (n != b(s)) result.push_back(n);
    }
    result.push_back(b(s));
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr double nearly_parallel = 0.75;  // squared cosine of 30 degrees

  struct Hit {
    double distance, parameter;
    std::size_t segment;
    auto operator<=>(const Hit&) const = default;
  };

  Node_index a(std::size_t s) const { return nodes_.representative[drawing_.segments[s].source.value()]; }
  Node_index b(std::size_t s) const { return nodes_.representative[drawing_.segments[s].target.value()]; }
  bool is_point(std::size_t s) const { return a(s) == b(s); }
  bool stands(std::size_t n) const { return nodes_.representative[n] == Node_index(n); }

  bool are_parallel(std::size_t s, std::size_t t) const {
    const Place_2 &p = places_[a(s).value()], &q = places_[b(s).value()];
    const Place_2 &v = places_[a(t).value()], &w = places_[b(t).value()];
    const double sx = q[0] - p[0], sy = q[1] - p[1], tx = w[0] - v[0], ty = w[1] - v[1];
    const double dot = sx * tx + sy * ty;
    return dot * dot >= nearly_parallel * (sx * sx + sy * sy) * (tx * tx + ty * ty);
  }

  // Design, 'Facets of the same arc differ'.
  double tolerance(Node_index n, std::size_t s) const {
    double result = tolerance_;
    // What was carried here reaches for what is fixed.
    if (nodes_.fixed[n.value()] != drawing_.segments[s].fixed)
      result = std::max(result, drawing_.segments[s].fixed ? nodes_.reach(n) : segment_reach(s));
    const double chord = drawing_.segments[s].chord_error;
    if (!(chord > 0)) return result;
    for (std::size_t own : own_[n.value()]) {
      if (own == s || !are_parallel(own, s)) continue;
      result = std::fmax(result, std::fmax(chord, drawing_.segments[own].chord_error));
    }
    return result;
  }

  double segment_reach(std::size_t s) const {
    return nodes_.reach(drawing_.segments[s].source, drawing_.segments[s].target);
  }

  double reach(Node_index n) const {
    double result = std::max(tolerance_, nodes_.reach(n));
    for (std::size_t own : own_[n.value()]) result = std::fmax(result, drawing_.segments[own].chord_error);
    return result;
  }

  CGAL::Bbox_2 around(Node_index n) const { return inflated(nodes_.box(n), reach(n)); }

  // The segments that are fixed, or those that are not, and an index of them that nodes within reach will find.
  std::vector<std::size_t> segments(bool fixed) const {
    std::vector<std::size_t> result;
    for (std::size_t s = 0; s < drawing_.segments.size(); ++s) {
      if (drawing_.segments[s].fixed == fixed && !is_point(s)) result.push_back(s);
    }
    return result;
  }

  Run_search<SegmentIndex> index(const std::vector<std::size_t>& segments) const {
    std::vector<Flat_box> boxes;
    boxes.reserve(segments.size());
    for (std::size_t s : segments) {
      const double by = 2 * drawing_.segments[s].chord_error + segment_reach(s) + displacement(s);
      boxes.push_back(flat_box(inflated(nodes_.box(a(s), b(s)), by)));
    }
    return Run_search<SegmentIndex>(std::move(boxes));
  }

  double displacement(Node_index n) const { return distance(nodes_.place(n), places_[n.value()]); }
  // How far snapping has moved the ends of a segment; its inner points may be as much further from their partners.
  double displacement(std::size_t s) const {
    const Segment& segment = drawing_.segments[s];
    return std::fmax(displacement(segment.source), displacement(segment.target));
  }

  // Nodes whose fixed features are no ledge to n and s. A fixed node must not draw s away from walls of its own.
  std::vector<Node_index> incident(Node_index n, std::size_t s) const {
    std::vector<Node_index> result;
    const auto add = [&](Node_index end) {
      result.push_back(end);
      if (foot_on_[end.value()] == none) return;
      result.insert(result.end(), {a(foot_on_[end.value()]), b(foot_on_[end.value()])});
    };
    add(n);
    if (nodes_.fixed[n.value()]) return result;
    add(a(s));
    add(b(s));
    return result;
  }

  void move_to_fixed() {
    const std::vector<std::size_t> walls = segments(true);
    const Run_search<SegmentIndex> near(index(walls));
    std::vector<std::pair<Node_index, Hit>> moves;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Node_index n(i);
      if (!stands(i) || nodes_.fixed[i]) continue;
      found.clear();
      near.find(around(n), found);
      for (std::size_t& f : found) f = walls[f];
      if (const std::optional<Hit> hit = nearest_wall(n, found)) moves.emplace_back(n, *hit);
    }
    for (const auto& [n, hit] : moves) move(n, hit);
  }

  std::optional<Hit> nearest_wall(Node_index n, const std::vector<std::size_t>& walls) const {
    std::vector<Hit> hits;
    std::map<Node_index, int> at_end;
    for (std::size_t s : walls) {
      const Closest c = closest(places_[n.value()], nodes_.place(a(s)), nodes_.place(b(s)));
      if (c.distance > tolerance(n, s)) continue;
      hits.push_back({c.distance, c.parameter, s});
      if (const Node_index end = end_near(hits.back()); end.is_valid()) ++at_end[end];
    }
    std::sort(hits.begin(), hits.end());
    for (const Hit& hit : hits) {
      // Beyond the end of an arc its chord error means nothing; at a bend of it, two facets end here.
      const Node_index end = end_near(hit);
      if (hit.distance > tolerance_ && end.is_valid() && at_end[end] < 2) continue;
      if (clearance_.allows(places_[n.value()], hit.distance, incident(n, hit.segment))) return hit;
      return std::nullopt;
    }
    return std::nullopt;
  }

  // The end of the segment that the hit is within the tolerance of, if any.
  Node_index end_near(const Hit& hit) const {
    const double length = distance(nodes_.place(a(hit.segment)), nodes_.place(b(hit.segment)));
    if (hit.parameter == 0 || hit.parameter * length <= tolerance_) return a(hit.segment);
    if (hit.parameter == 1 || (1 - hit.parameter) * length <= tolerance_) return b(hit.segment);
    return Node_index();
  }

  void move(Node_index n, const Hit& hit) {
    if (const Node_index end = end_near(hit); end.is_valid()) return merge(nodes_, n, end);
    const auto &p = nodes_.point(a(hit.segment)), &q = nodes_.point(b(hit.segment));
    const typename Traits::FT t(hit.parameter);
    nodes_.points[n.value()] = typename Traits::Point_2(p.x() + t * (q.x() - p.x()), p.y() + t * (q.y() - p.y()));
    nodes_.fixed[n.value()] = true;
    foot_on_[n.value()] = hit.segment;
    splits_[hit.segment].emplace_back(hit.parameter, n);
  }

  void bend_segments() {
    std::vector<std::size_t> all = segments(false);
    const std::vector<std::size_t> walls = segments(true);
    all.insert(all.end(), walls.begin(), walls.end());
    const Run_search<SegmentIndex> near(index(all));
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!stands(i)) continue;
      const Node_index n(i);
      found.clear();
      near.find(around(n), found);
      std::sort(found.begin(), found.end());
      for (std::size_t f : found) bend(all[f], n);
    }
  }

  void bend(std::size_t s, Node_index n) {
    if (n == a(s) || n == b(s) || foot_on_[n.value()] == s) return;
    const bool is_wall = drawing_.segments[s].fixed || runs_along_a_wall(s);
    const Closest c = closest(nodes_.place(n), nodes_.place(a(s)), nodes_.place(b(s)));
    // Where both ends of an arc's facet came onto walls, those of another facet, the corner between is that much
    // further from it.
    const bool is_on_walls = nodes_.fixed[a(s).value()] && nodes_.fixed[b(s).value()];
    const double moved = is_on_walls && tolerance(n, s) > tolerance_
                             ? std::fmax(displacement(s), drawing_.segments[s].chord_error)
                             : displacement(s);
    const double allowed = is_wall ? rounding_ : tolerance(n, s) + moved;
    if (c.parameter == 0 || c.parameter == 1 || c.distance > allowed) return;
    if (!is_wall && !clearance_.allows(nodes_.place(n), c.distance, incident(n, s))) return;
    splits_[s].emplace_back(c.parameter, n);
  }

  // Whether both ends lie on the same fixed segment.
  bool runs_along_a_wall(std::size_t s) const {
    const std::vector<std::size_t> first = walls_at(a(s)), second = walls_at(b(s));
    return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) != first.end();
  }

  std::vector<std::size_t> walls_at(Node_index n) const {
    std::vector<std::size_t> result = walls_at_[n.value()];
    if (foot_on_[n.value()] != none) result.push_back(foot_on_[n.value()]);
    return result;
  }

  const Drawing& drawing_;
  Layer_nodes<Traits>& nodes_;
  const Snap_clearance<Traits, SegmentIndex>& clearance_;
  double tolerance_, rounding_;
  std::vector<Place_2> places_;  // before this rule moved anything
  std::vector<std::vector<std::pair<double, Node_index>>> splits_;
  std::vector<std::size_t> foot_on_;
  std::vector<std::vector<std::size_t>> own_;       // the arc facets at each node
  std::vector<std::vector<std::size_t>> walls_at_;  // the fixed segments at each node
};

}  // namespace CCSweep::internal

#endif
