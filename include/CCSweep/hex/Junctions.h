// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_JUNCTIONS_H
#define CCSWEEP_HEX_JUNCTIONS_H

#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/Slab_columns.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The corners of the mesh: the nodes of the layers where segments fork, corners of caps and walls, and whatever lies
/// in one column with such a node. A junction on a segment gets a node of its own.
class Junctions {
 public:
  using Node = Layer_stack::Node;

  Junctions(const Layer_stack& stack, const std::vector<Slab_columns>& slabs)
      : points(stack.points), stack_(stack), slabs_(slabs), is_junction_(stack.points.size(), false) {
    collect_incident();
    for (const auto& layer : stack.layers) inserted_.emplace_back(layer.segments.size());
  }

  void run() {
    for (std::size_t k = 0; k < stack_.layers.size(); ++k) {
      for (const auto& s : stack_.layers[k].segments)
        for (Node n : {s.a, s.b})
          if (incident_[n].size() != 2) mark(k, n);
      for (const auto& ring : stack_.layers[k].rings)
        for (const auto& rail : ring.rails) {
          mark(k, ring.bottom[rail.bottom]);
          mark(k + 1, ring.top[rail.top]);
        }
    }
    // Where a column has met a wall, and the imprint has moved what it carries to a node of the wall near by, that is
    // one place.
    for (std::size_t k = 0; k < stack_.layers.size(); ++k)
      for (const auto& s : stack_.layers[k].segments)
        for (Node n : {s.a, s.b})
          if (stack_.corner[n] && !is_junction_[n] && !near(k, places(k, n)[0], reach(k, places(k, n)[0]))) mark(k, n);
    spread();
    for (std::size_t k = 0; k < stack_.layers.size(); ++k) seed_closed_curves(k);
  }

  bool is_junction(Node n) const { return is_junction_[n]; }
  const std::vector<std::uint32_t>& incident(Node n) const { return incident_[n]; }
  /// The junctions inside a segment, by ascending fraction.
  const std::vector<std::pair<double, Node>>& inside(std::size_t layer, std::size_t segment) const {
    return inserted_[layer][segment];
  }

  /// The places of a junction: on every segment that it ends, or inside one.
  std::vector<Segment_place> places(std::size_t layer, Node n) const {
    if (n >= incident_.size()) return {place_of_inserted_[n - incident_.size()]};
    std::vector<Segment_place> result;
    for (std::uint32_t s : incident_[n]) result.push_back({s, stack_.layers[layer].segments[s].a == n ? 0.0 : 1.0});
    return result;
  }

  /// The junction at a place, which must have been made.
  Node at(std::size_t layer, const Segment_place& p) const {
    if (const auto found = near(layer, p, reach(layer, p))) return *found;
    const auto& s = stack_.layers[layer].segments[p.segment];
    Node best = p.fraction < 0.5 ? s.a : s.b;
    double distance = is_junction_[best] ? std::min(p.fraction, 1 - p.fraction) : 2;
    for (const auto& [f, n] : inserted_[layer][p.segment])
      if (std::abs(f - p.fraction) < distance) {
        distance = std::abs(f - p.fraction);
        best = n;
      }
    return best;
  }

  std::vector<Vec3> points;  ///< of the stack's nodes and of the new ones

 private:
  struct Task {
    std::size_t layer;
    Segment_place place;
  };

  void collect_incident() {
    incident_.resize(stack_.points.size());
    for (std::size_t k = 0; k < stack_.layers.size(); ++k) {
      const auto& segments = stack_.layers[k].segments;
      for (std::size_t s = 0; s < segments.size(); ++s)
        for (Node n : {segments[s].a, segments[s].b}) incident_[n].push_back(static_cast<std::uint32_t>(s));
    }
  }

  void mark(std::size_t layer, Node n) {
    if (is_junction_[n]) return;
    is_junction_[n] = true;
    for (const Segment_place& p : places(layer, n)) tasks_.push_back({layer, p});
  }

  // How far columns on a wall may miss one another: on a bent one they follow facets, and those of two layers differ by
  // as much as a chord strays from its arc.
  double reach(std::size_t layer, const Segment_place& p) const {
    constexpr int few = 3;
    double length = 0, longest = 0, turning = 0;
    for (bool forward : {true, false}) {
      Step step{p.segment, forward};
      for (int i = 0; i <= few; ++i) {
        const double l = norm(vector_of(layer, step));
        longest = std::max(longest, l);
        if (i > 0 || forward) length += l;
        const auto [next, turn] = go_on(layer, step);
        if (next.segment == step.segment) break;
        turning += turn;
        step = next;
      }
    }
    return std::max(stack_.tolerance, turning * longest * longest / (8 * length));
  }

  // A segment in the one sense or the other.
  struct Step {
    std::uint32_t segment;
    bool forward;
  };

  Vec3 vector_of(std::size_t layer, const Step& step) const {
    const auto& s = stack_.layers[layer].segments[step.segment];
    return step.forward ? stack_.points[s.b] - stack_.points[s.a] : stack_.points[s.a] - stack_.points[s.b];
  }

  // The segment that goes on straightest, and the turn into it; the same one again where all turn as corners do.
  std::pair<Step, double> go_on(std::size_t layer, const Step& step) const {
    constexpr double corner = std::numbers::pi / 6;
    const auto& segments = stack_.layers[layer].segments;
    const Node n = step.forward ? segments[step.segment].b : segments[step.segment].a;
    std::pair<Step, double> best{step, corner};
    for (const std::uint32_t i : incident_[n]) {
      if (i == step.segment) continue;
      const Step next{i, segments[i].a == n};
      if (const double turn = angle(vector_of(layer, step), vector_of(layer, next)); turn < best.second)
        best = {next, turn};
    }
    return best;
  }

  // Whether two junctions of neighbouring layers are each the nearest to where the column of the other one arrives.
  bool are_one_column(const Task& from, std::size_t layer, Node n) const {
    const auto origin = near(from.layer, from.place, stack_.tolerance);
    const bool up = layer > from.layer;
    for (const Segment_place& p : places(layer, n))
      for (const auto& back : up ? slabs_[from.layer].below(p) : slabs_[layer].above(p))
        if (near(from.layer, back.place, reach(from.layer, back.place)) == origin) return true;
    return false;
  }

  // Columns up and down a wall do not come back to the very same place; what is closer than the tolerance is one.
  void add(const Task& from, std::size_t layer, const Segment_place& p) {
    if (near(layer, p, stack_.tolerance)) return;
    if (const auto found = near(layer, p, reach(layer, p)); found && are_one_column(from, layer, *found)) return;
    const auto& s = stack_.layers[layer].segments[p.segment];
    const double length = norm(stack_.points[s.b] - stack_.points[s.a]);
    const double close = std::min(stack_.tolerance, length / 3);
    if (p.fraction * length <= close) return mark(layer, s.a);
    if ((1 - p.fraction) * length <= close) return mark(layer, s.b);
    auto& inside = inserted_[layer][p.segment];
    const auto next = std::lower_bound(inside.begin(), inside.end(), std::pair(p.fraction, Node(0)));
    inside.insert(next, {p.fraction, static_cast<Node>(points.size())});
    place_of_inserted_.push_back(p);
    points.push_back(stack_.points[s.a] + p.fraction * (stack_.points[s.b] - stack_.points[s.a]));
    tasks_.push_back({layer, p});
  }

  // The nearest junction within a distance, along the segments.
  std::optional<Node> near(std::size_t layer, const Segment_place& p, double reach) const {
    std::optional<Node> best;
    for (bool forward : {true, false}) {
      Segment_place at = p;
      bool ahead = forward;
      for (double gone = 0; gone <= reach;) {
        const auto& s = stack_.layers[layer].segments[at.segment];
        const double length = norm(stack_.points[s.b] - stack_.points[s.a]);
        for (const auto& [f, n] : inserted_[layer][at.segment]) {
          const double d = gone + (ahead ? f - at.fraction : at.fraction - f) * length;
          if (d >= gone && d <= reach) {
            reach = d;
            best = n;
          }
        }
        gone += (ahead ? 1 - at.fraction : at.fraction) * length;
        const Node n = ahead ? s.b : s.a;
        if (gone > reach) break;
        if (is_junction_[n]) {
          reach = gone;
          best = n;
          break;
        }
        const auto& incident = incident_[n];
        if (incident.size() != 2 || incident[0] == incident[1]) break;
        const std::uint32_t onward = incident[0] == at.segment ? incident[1] : incident[0];
        ahead = stack_.layers[layer].segments[onward].a == n;
        at = {onward, ahead ? 0.0 : 1.0};
        if (onward == p.segment) break;
      }
    }
    return best;
  }

  // Every junction has one above and one below, as far as its column reaches.
  void spread() {
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      if (task.layer > 0)
        for (const auto& p : slabs_[task.layer - 1].below(task.place)) add(task, task.layer - 1, p.place);
      if (task.layer < slabs_.size())
        for (const auto& p : slabs_[task.layer].above(task.place)) add(task, task.layer + 1, p.place);
    }
  }

  // A closed curve without any junction gets one.
  void seed_closed_curves(std::size_t layer) {
    const auto& segments = stack_.layers[layer].segments;
    std::vector<bool> seen(segments.size(), false);
    for (std::size_t first = 0; first < segments.size(); ++first) {
      if (seen[first]) continue;
      bool has_junction = false;
      Node n = segments[first].a;
      std::size_t s = first;
      do {
        seen[s] = true;
        has_junction |= is_junction_[n] || !inserted_[layer][s].empty();
        n = segments[s].a == n ? segments[s].b : segments[s].a;
        if (incident_[n].size() != 2) break;
        s = incident_[n][0] == s ? incident_[n][1] : incident_[n][0];
      } while (!seen[s]);
      const bool is_closed = s == first && n == segments[first].a;
      if (is_closed && !has_junction) {
        mark(layer, segments[first].a);
        spread();
      }
    }
  }

  const Layer_stack& stack_;
  const std::vector<Slab_columns>& slabs_;
  std::vector<bool> is_junction_;
  std::vector<std::vector<std::uint32_t>> incident_;  // segments, by node
  std::vector<std::vector<std::vector<std::pair<double, Node>>>> inserted_;  // by layer and segment
  std::vector<Segment_place> place_of_inserted_;  // by junction inside a segment
  std::vector<Task> tasks_;
};

}  // namespace CCSweep::internal

#endif
