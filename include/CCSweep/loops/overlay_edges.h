// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_EDGES_H
#define CCSWEEP_LOOPS_OVERLAY_EDGES_H

#include <CCSweep/Layer_drawing.h>
#include <CCSweep/internal/bucket_sort.h>
#include <CCSweep/loops/overlay_chains.h>
#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_labels.h>
#include <CCSweep/loops/overlay_nodes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// An edge of the overlay: a path of pieces that ascends by xy, between whose ends nothing else ends. It speaks for a
// set if its sides differ there.
struct Overlay_edge {
  std::uint32_t a, b;          // the ends of the path, in the list of all ends; a is less than b by xy
  std::uint32_t first, size;   // its nodes, both ends included, in the list of all edges
  std::array<Sides, 2> sides;  // in the sources, in the targets

  bool speaks(int set) const { return sides[set].left != sides[set].right; }
};

struct Overlay_edges {
  std::vector<Node_index> nodes;
  std::vector<Node_index> ends;  // the nodes where paths end
  std::vector<Overlay_edge> edges;

  std::span<const Node_index> path(std::size_t edge) const {
    return {nodes.data() + edges[edge].first, edges[edge].size};
  }
};

// Steps 4 and 5 of the outline in section 2.7, *merge coincident* vertices and edges: joins the pieces into paths,
// adds up what the drawing says of coincident ones, and keeps the edges that say anything. Linear, for a bounded
// number of edges at a node.
template <class Traits>
class Edge_sum {
 public:
  using Segment = typename Layer_drawing<Traits>::Segment;

  // `chains` are those of the segments, split until they meet in nodes only.
  static Overlay_edges of(const std::vector<Segment>& segments, const Node_chains& chains,
                          const Layer_nodes<Traits>& nodes) {
    Edge_sum sum(nodes);
    sum.count_ends(chains);
    sum.make_paths(segments, chains);
    sum.sort();
    sum.merge_coincident();
    return std::move(sum.result_);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  explicit Edge_sum(const Layer_nodes<Traits>& nodes)
      : nodes_(nodes), degree_(nodes.points.size(), 0), number_(nodes.points.size(), none) {}

  static bool is_silent(const Segment& segment) { return segment.left == segment.right; }

  // Most chains begin where the last one ended, so that each node is looked up once.
  void count_ends(const Node_chains& chains) {
    Node_index last;
    const auto end_at_last = [&] {
      if (last.is_valid()) ++degree_[last.value()];
    };
    for (std::size_t c = 0; c < chains.size(); ++c) {
      const std::span<const Node_index> chain = chains[c];
      if (chain.size() == 1) continue;
      const bool goes_on = chain.front() == last;
      if (!goes_on) end_at_last();
      degree_[chain.front().value()] += goes_on ? 2 : 1;
      for (std::size_t i = 1; i + 1 < chain.size(); ++i) degree_[chain[i].value()] += 2;
      last = chain.back();
    }
    end_at_last();
  }

  // A path goes on while the drawing does, through nodes where nothing else ends.
  void make_paths(const std::vector<Segment>& segments, const Node_chains& chains) {
    result_.nodes.reserve(2 * chains.size());
    const Segment* open = nullptr;
    Node_index last;
    bool ascends = false;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const Segment& segment = segments[s];
      if (is_silent(segment)) continue;
      const std::span<const Node_index> chain = chains[s];
      bool is_alike = open != nullptr && open->left == segment.left && open->right == segment.right;
      for (std::size_t i = 1; i < chain.size(); ++i) {
        const Node_index n = chain[i - 1], m = chain[i];
        const bool up = is_less_xy<Traits>(nodes_.point(n), nodes_.point(m));
        const bool goes_on =
            is_alike && last == n && up == ascends && degree_[n.value()] == 2 && !nodes_.corner[n.value()];
        if (!goes_on) {
          if (open != nullptr) close(*open, ascends);
          first_ = static_cast<std::uint32_t>(result_.nodes.size());
          result_.nodes.push_back(n);
        }
        result_.nodes.push_back(m);
        open = &segment;
        is_alike = true;
        last = m;
        ascends = up;
      }
    }
    if (open != nullptr) close(*open, ascends);
  }

  void close(const Segment& segment, bool ascends) {
    if (!ascends) std::reverse(result_.nodes.begin() + first_, result_.nodes.end());
    const Loop_label &l = ascends ? segment.left : segment.right, &r = ascends ? segment.right : segment.left;
    Overlay_edge& edge = result_.edges.emplace_back();
    edge.a = number_of(result_.nodes[first_]);
    edge.b = number_of(result_.nodes.back());
    edge.first = first_;
    edge.size = static_cast<std::uint32_t>(result_.nodes.size()) - first_;
    edge.sides = {Sides{l.source, r.source}, Sides{l.target, r.target}};
  }

  // Most nodes are inside paths. All that follows deals with the others, which have numbers of their own.
  std::uint32_t number_of(Node_index end) {
    std::uint32_t& number = number_[end.value()];
    if (number == none) {
      number = static_cast<std::uint32_t>(result_.ends.size());
      result_.ends.push_back(end);
    }
    return number;
  }

  // By the node they begin at, in linear time, then by the rest.
  void sort() {
    bucket_sort(
        result_.edges, result_.ends.size(), [](const Overlay_edge& e) { return e.a; },
        [](const Overlay_edge& e, const Overlay_edge& f) {
          return std::tie(e.b, e.size, e.sides, e.first) < std::tie(f.b, f.size, f.sides, f.first);
        });
  }

  // Paths of several pieces have nodes to themselves, so only single pieces coincide.
  void merge_coincident() {
    std::vector<Overlay_edge>& edges = result_.edges;
    std::size_t size = 0;
    for (std::size_t first = 0; first < edges.size();) {
      Overlay_edge edge = edges[first];
      std::size_t last = first + 1;
      const auto coincides = [&](const Overlay_edge& e) {
        return edge.size == 2 && e.size == 2 && e.a == edge.a && e.b == edge.b;
      };
      while (last < edges.size() && coincides(edges[last])) ++last;
      if (last - first > 1) {
        for (int set : {0, 1}) edge.sides[set] = summed(set, first, last);
      }
      if (edge.speaks(0) || edge.speaks(1)) edges[size++] = edge;
      first = last;
    }
    edges.resize(size);
  }

  Sides summed(int set, std::size_t first, std::size_t last) const {
    const std::vector<Overlay_edge>& edges = result_.edges;
    if (last - first == 2) {
      const std::optional<Sides> result = sum(edges[first].sides[set], edges[first + 1].sides[set]);
      if (result) return *result;
    }
    std::vector<Sides> said;
    for (std::size_t i = first; i < last; ++i) said.push_back(edges[i].sides[set]);
    if (const std::optional<Sides> result = sum(said)) return *result;
    fail_imprint(nodes_, result_.ends[edges[first].a],
                 set == 0 ? "sources that overlap along an edge" : "targets that overlap along an edge", patches(said));
  }

  const Layer_nodes<Traits>& nodes_;
  std::vector<std::uint32_t> degree_, number_;  // of each node
  std::uint32_t first_ = 0;
  Overlay_edges result_;
};

}  // namespace CCSweep::internal

#endif
