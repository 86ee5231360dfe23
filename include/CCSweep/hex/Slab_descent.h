// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_SLAB_DESCENT_H
#define CCSWEEP_HEX_SLAB_DESCENT_H

#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/plane.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Column_map.h>
#include <CCSweep/loops/projection.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Carries points inside the material from a layer down to the next lower one: by the affine map and the residuals of
/// the walls and cuts of their barrel (section 2.6, downwards).
class Slab_descent {
 public:
  using Node = Layer_stack::Node;

  Slab_descent(const Layer_stack& stack, std::size_t lower)
      : stack_(stack), low_(stack.layers[lower]), plane_(low_.up) {
    for (const auto& ring : low_.rings) barrels_[ring.barrel].push_back(&ring);
  }

  /// The barrel that a point of the upper layer lies in.
  std::size_t barrel_of(const Vec3& p) const {
    if (barrels_.size() > 1)
      for (const auto& [barrel, rings] : barrels_) {
        int turns = 0;
        for (const auto* ring : rings) turns += winding_number(plane_(points(ring->top)), plane_(p));
        if (turns > 0) return barrel;
      }
    return barrels_.begin()->first;
  }

  Vec3 operator()(std::size_t barrel, const Vec3& p) {
    auto found = maps_.find(barrel);
    if (found == maps_.end()) found = maps_.emplace(barrel, make_map(barrel)).first;
    const Vec3 q = found->second(p);
    return stack_.is_upright ? p + dot(low_.up, q - p) * low_.up : q;
  }

 private:
  using Map = Layer_projection<void>;
  struct Control {
    std::vector<Vec3> from, to;
    std::vector<Map::Loop> loops;
    void add(const Vec3& high, const Vec3& low) {
      from.push_back(high);
      to.push_back(low);
    }
  };

  std::vector<Vec3> points(const std::vector<Node>& nodes) const {
    std::vector<Vec3> result;
    for (Node n : nodes) result.push_back(stack_.points[n]);
    return result;
  }

  Map make_map(std::size_t barrel) const {
    Control control;
    for (const auto* ring : barrels_.at(barrel)) add_ring(*ring, control);
    for (const auto& cut : low_.cuts) {
      const auto& s = low_.segments[cut.bottom];
      if (barrel_below(s) != barrel) continue;
      control.add(stack_.points[cut.top.front()], stack_.points[s.a]);
      control.add(stack_.points[cut.top.back()], stack_.points[s.b]);
    }
    std::optional<Vec3> direction;
    if (stack_.is_straight) direction = low_.up;
    return value_or_fail(Map::make(control.from, control.to, control.loops, 10, direction));
  }

  std::size_t barrel_below(const Layer_stack::Segment& s) const {
    if (barrels_.size() == 1) return barrels_.begin()->first;
    const auto p = plane_(0.5 * (stack_.points[s.a] + stack_.points[s.b]));
    for (const auto& [barrel, rings] : barrels_) {
      int turns = 0;
      for (const auto* ring : rings) turns += winding_number(plane_(points(ring->bottom)), p);
      if (turns > 0) return barrel;
    }
    return barrels_.begin()->first;
  }

  void add_ring(const Layer_stack::Ring& ring, Control& control) const {
    const std::vector<Vec3> low = points(ring.bottom), high = points(ring.top);
    const Column_map map(low, high, ring.rails, low_.up);
    control.loops.emplace_back();
    for (std::size_t i = 0; i < high.size(); ++i) {
      control.loops.back().push_back(control.from.size());
      control.add(high[i], map.point_below(i));
    }
    for (std::size_t i = 0; i < low.size(); ++i) control.add(map.point_above(i), low[i]);
  }

  const Layer_stack& stack_;
  const Layer_stack::Layer& low_;
  Plane_chart plane_;
  std::map<std::size_t, std::vector<const Layer_stack::Ring*>> barrels_;
  std::map<std::size_t, Map> maps_;
};

}  // namespace CCSweep::internal

#endif
