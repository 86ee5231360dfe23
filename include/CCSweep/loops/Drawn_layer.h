// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_DRAWN_LAYER_H
#define CCSWEEP_LOOPS_DRAWN_LAYER_H

#include <CCSweep/internal/Key_map.h>
#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/loops/Layer_chart.h>
#include <CCSweep/Layer_drawing.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CCSweep::internal {

/// The drawing of one layer while it is made, with what each of its nodes and segments stands for.
///
/// Everything that runs along one edge of the part (the borders of two caps, a row of the linking mesh) is drawn over
/// the same nodes, so that coincident segments are equal, not merely close.
template <class Traits>
class Drawn_layer {
 public:
  using Carrier = Wall_loop::Carrier;
  static constexpr std::size_t no_cut = std::size_t(-1);

  /// What a segment of the drawing was drawn for.
  struct Origin {
    Carrier carrier;             // of a fixed segment
    std::size_t cut = no_cut;    // of a free segment: the cut below it
  };

  Drawn_layer(const Part<Traits>& part, const Layer_chart<Traits>& chart, Layered_loops<Traits>& loops)
      : part_(part), chart_(chart), loops_(loops), first_node_(loops.nodes.size()) {}

  const Layer_drawing<Traits>& drawing() const { return drawing_; }
  const std::vector<Node_index>& nodes() const { return node_of_local_; }
  const Origin& origin(std::size_t segment) const { return origins_[segment]; }

  /// The node of the drawing that a node of this layer was drawn as; invalid where it was not.
  Node_index drawn_node(Node_index n) const {
    const std::size_t i = n.value() - first_node_;
    return i < local_of_node_.size() ? local_of_node_[i] : Node_index();
  }

  /// The node at a vertex, or at the crossing of an edge, on this layer; made at the first call.
  Node_index node_at(const Surface_location& where) {
    Node_index& node = node_at_[where.key()];
    if (!node.is_valid()) {
      const bool is_vertex = where.kind == Surface_location::Kind::vertex;
      using Vertex = typename Part<Traits>::Vertex;
      using Edge = typename Part<Traits>::Edge;
      node = add_node(is_vertex ? part_.point(Vertex(where.index)) : point_on_edge(part_, Edge(where.index), where.t),
                      where, is_vertex && part_.corner[where.index]);
    }
    return node;
  }

  Node_index add_node(const typename Traits::Point_3& point, const Surface_location& where, bool loop_vertex) {
    loops_.nodes.push_back({point, where, loop_vertex});
    return Node_index(loops_.nodes.size() - 1);
  }

  /// Puts a node on a carrier, where columns from below meet it.
  void insert_on_carrier(const Carrier& carrier, Node_index node) { inserted_[key(carrier)].push_back(node); }

  /// The nodes along a carrier from one of its ends to the other, both included.
  std::vector<Node_index> nodes_along(const Carrier& carrier, Node_index from, Node_index to) const {
    std::vector<Node_index> chain{from};
    if (auto found = inserted_.find(key(carrier)); found != inserted_.end()) {
      std::vector<Node_index> inner = found->second;
      const Vec3 a = coordinates(from), w = coordinates(to) - a;
      std::sort(inner.begin(), inner.end(), [&](Node_index m, Node_index n) {
        return dot(coordinates(m) - a, w) < dot(coordinates(n) - a, w);
      });
      chain.insert(chain.end(), inner.begin(), inner.end());
    }
    chain.push_back(to);
    return chain;
  }

  /// Draws a fixed chain of nodes along a carrier, where it may have been drawn before.
  void draw_along(const Carrier& carrier, const std::vector<Node_index>& chain, const Loop_label& left,
                  const Loop_label& right) {
    Run& run = drawn_[key(carrier)];
    const bool is_first = run.first == none;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const std::size_t s = draw_fixed(carrier, chain[i], chain[i + 1], left, right);
      if (is_first) append(run, s);
    }
  }

  /// Draws the next piece of a row along a carrier and returns its segment.
  std::size_t draw_row_piece(const Carrier& carrier, Node_index a, Node_index b, const Loop_label& left,
                             const Loop_label& right) {
    const std::size_t s = draw_fixed(carrier, a, b, left, right);
    append(drawn_[key(carrier)], s);
    return s;
  }

  /// Draws the image of a cut's lower border.
  void draw_free(std::size_t cut, Node_index a, Node_index b, const Loop_label& left, const Loop_label& right,
                 double chord_error) {
    drawing_.segments.push_back({local(a), local(b), left, right, false, chord_error});
    origins_.push_back({Carrier(), cut});
  }

  /// Calls a function with the segments that were first drawn along a carrier, in that sense.
  template <class Function>
  void for_each_along(const Carrier& carrier, const Function& function) const {
    for (std::size_t s = drawn_[key(carrier)].first; s != none; s = next_along_[s]) function(s);
  }

  Vec3 coordinates(Node_index n) const { return Part<Traits>::coordinates(loops_.node(n).point); }

 private:
  static constexpr std::size_t none = std::size_t(-1);

  // A list of segments, each of which knows the next.
  struct Run {
    std::size_t first = none, last = none;
  };

  void append(Run& run, std::size_t segment) {
    next_along_.resize(segment + 1, none);
    (run.first == none ? run.first : next_along_[run.last]) = segment;
    run.last = segment;
  }

  std::size_t draw_fixed(const Carrier& carrier, Node_index a, Node_index b, const Loop_label& left,
                         const Loop_label& right) {
    const double chord_error = carrier.is_edge ? part_.chord_error[carrier.index] : 0;
    drawing_.segments.push_back({local(a), local(b), left, right, true, chord_error});
    origins_.push_back({carrier, no_cut});
    return origins_.size() - 1;
  }

  static std::uint64_t key(const Carrier& c) { return 2 * std::uint64_t(c.index) + c.is_edge; }

  Node_index local(Node_index n) {
    if (n.value() - first_node_ >= local_of_node_.size()) local_of_node_.resize(loops_.nodes.size() - first_node_);
    Node_index& local = local_of_node_[n.value() - first_node_];
    if (!local.is_valid()) {
      local = Node_index(node_of_local_.size());
      const auto& node = loops_.node(n);
      node_of_local_.push_back(n);
      const bool is_on_surface = node.where.on_surface();
      drawing_.nodes.push_back(
          {chart_(node.point), is_on_surface, node.loop_vertex, is_on_surface ? 0 : loops_.reach});
    }
    return local;
  }

  const Part<Traits>& part_;
  const Layer_chart<Traits>& chart_;
  Layered_loops<Traits>& loops_;
  std::size_t first_node_;  // all nodes of the layer come after it
  Layer_drawing<Traits> drawing_;
  std::vector<Origin> origins_;
  std::vector<Node_index> node_of_local_;
  std::vector<Node_index> local_of_node_;                                  // from `first_node_` on
  Key_map<Node_index> node_at_;                                            // by the place's key
  std::unordered_map<std::uint64_t, std::vector<Node_index>> inserted_;    // by the carrier's key
  Key_map<Run> drawn_;                                                     // by the carrier's key
  std::vector<std::size_t> next_along_;                                    // by segment, in the run of its carrier
};

}  // namespace CCSweep::internal

#endif
