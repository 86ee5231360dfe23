// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_ARC_STACK_H
#define CCSWEEP_HEX_ARC_STACK_H

#include <CCSweep/hex/Junctions.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/Slab_columns.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CCSweep {

/// The layers of a part as junctions and arcs between them, where every arc knows the arc below it.
struct Arc_stack {
  using Node = Layer_stack::Node;
  using Side = Layer_stack::Side;
  using Vec3 = Layer_stack::Vec3;
  /// An arc with a sense: twice its number, plus one against its own sense.
  using Half_arc = std::uint32_t;
  static constexpr Half_arc none = Half_arc(-1);

  struct Arc {
    Node from, to;                 ///< junctions; equal for a closed curve
    std::vector<Vec3> line;        ///< from the one to the other
    Side left, right;
    std::array<Half_arc, 2> below{none, none};  ///< of the next lower layer, under the material on the left, the right
    std::array<Patch_index, 2> wall{};          ///< the linking patch in between, where there is one
    internal::Segment_place middle;             ///< a place well inside, for an arc of the imprint
    bool along_segment = true;                  ///< the sense of that place's segment is the arc's
  };

  std::vector<Vec3> points;            ///< by junction
  std::vector<std::vector<Arc>> arcs;  ///< by layer

  static std::size_t arc_of(Half_arc h) { return h / 2; }
  static bool is_reversed(Half_arc h) { return h % 2 == 1; }
  static Half_arc opposite(Half_arc h) { return h ^ 1; }

  const Arc& arc(std::size_t layer, Half_arc h) const { return arcs[layer][arc_of(h)]; }
  Node source(std::size_t layer, Half_arc h) const { return is_reversed(h) ? arc(layer, h).to : arc(layer, h).from; }
  Node target(std::size_t layer, Half_arc h) const { return source(layer, opposite(h)); }
  const Side& side(std::size_t layer, Half_arc h) const {
    return is_reversed(h) ? arc(layer, h).right : arc(layer, h).left;
  }
  Half_arc below(std::size_t layer, Half_arc h) const { return arc(layer, h).below[h % 2]; }
};

namespace internal {

/// Joins the segments of one layer to arcs between junctions.
class Arc_builder {
  using Node = Layer_stack::Node;
  using Arc = Arc_stack::Arc;
  using Half_arc = Arc_stack::Half_arc;

 public:
  Arc_builder(const Layer_stack& stack, const Junctions& junctions, std::size_t layer)
      : stack_(stack), junctions_(junctions), layer_(layer), segments_(stack.layers[layer].segments) {
    for (std::size_t s = 0; s < segments_.size(); ++s)
      half_.emplace_back(junctions.inside(layer, s).size() + 1, Arc_stack::none);
  }

  std::vector<Arc> run() {
    for (std::uint32_t s = 0; s < segments_.size(); ++s)
      for (std::uint32_t j = 0; j < half_[s].size(); ++j)
        for (bool forward : {true, false})
          if (half_[s][j] == Arc_stack::none && starts_at_junction({s, j, forward})) follow({s, j, forward});
    return std::move(arcs_);
  }

  /// The arc that runs along a segment at a place, in the sense of the segment.
  Half_arc half_arc_at(const Segment_place& p) const {
    const auto& inside = junctions_.inside(layer_, p.segment);
    std::size_t j = 0;
    while (j < inside.size() && inside[j].first < p.fraction) ++j;
    return half_[p.segment][j];
  }

 private:
  // Part j of a segment, between its junctions, with a sense.
  struct Step {
    std::uint32_t segment, part;
    bool forward;
  };

  double fraction(std::uint32_t s, std::size_t border) const {
    const auto& inside = junctions_.inside(layer_, s);
    return border == 0 ? 0 : border > inside.size() ? 1 : inside[border - 1].first;
  }
  Node node(std::uint32_t s, std::size_t border) const {
    const auto& inside = junctions_.inside(layer_, s);
    return border == 0 ? segments_[s].a : border > inside.size() ? segments_[s].b : inside[border - 1].second;
  }
  Node start(const Step& t) const { return node(t.segment, t.forward ? t.part : t.part + 1); }
  Node end(const Step& t) const { return node(t.segment, t.forward ? t.part + 1 : t.part); }

  bool is_junction(Node n) const { return n >= stack_.points.size() || junctions_.is_junction(n); }
  bool starts_at_junction(const Step& t) const { return is_junction(start(t)); }

  void follow(Step t) {
    Arc arc;
    arc.from = start(t);
    arc.line.push_back(junctions_.points[arc.from]);
    const auto& first = segments_[t.segment];
    arc.left = t.forward ? first.left : first.right;
    arc.right = t.forward ? first.right : first.left;
    double longest = -1;
    for (;;) {
      half_[t.segment][t.part] = static_cast<Half_arc>(2 * arcs_.size() + (t.forward ? 0 : 1));
      arc.to = end(t);
      const Vec3& p = junctions_.points[arc.to];
      if (const double length = norm(p - arc.line.back()); length > longest) {
        longest = length;
        arc.middle = {t.segment, 0.5 * (fraction(t.segment, t.part) + fraction(t.segment, t.part + 1))};
        arc.along_segment = t.forward;
      }
      arc.line.push_back(p);
      if (is_junction(arc.to)) break;
      t = next(t);
    }
    arcs_.push_back(std::move(arc));
  }

  // Goes on through a node where only two segments meet.
  Step next(const Step& t) const {
    const Node n = end(t);
    const auto& incident = junctions_.incident(n);
    const std::uint32_t s = incident[0] == t.segment ? incident[1] : incident[0];
    if (segments_[s].a == n) return {s, 0, true};
    return {s, static_cast<std::uint32_t>(half_[s].size() - 1), false};
  }

  const Layer_stack& stack_;
  const Junctions& junctions_;
  std::size_t layer_;
  const std::vector<Layer_stack::Segment>& segments_;
  std::vector<std::vector<Half_arc>> half_;  // by segment and part: the arc in the segment's sense
  std::vector<Arc> arcs_;
};

}  // namespace internal
}  // namespace CCSweep

#endif
