// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_SNAP_MERGE_H
#define CCSWEEP_LOOPS_SNAP_MERGE_H

#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/overlay_table.h>
#include <CCSweep/loops/snap_clearance.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CCSweep::internal {

// The node that stands for n, found by following the merges.
template <class Traits>
Node_index representative(Layer_nodes<Traits>& nodes, Node_index n) {
  while (nodes.representative[n.value()] != n) n = nodes.representative[n.value()];
  return n;
}

template <class Traits>
void merge(Layer_nodes<Traits>& nodes, Node_index from, Node_index into) {
  nodes.representative[from.value()] = into;
  if (nodes.corner[from.value()]) nodes.corner[into.value()] = true;
}

// Lets every node point at its representative itself, and takes over its place.
template <class Traits>
void settle(Layer_nodes<Traits>& nodes) {
  for (std::size_t i = 0; i < nodes.representative.size(); ++i) {
    const Node_index n = representative(nodes, Node_index(i));
    nodes.representative[i] = n;
    nodes.points[i] = nodes.points[n.value()];
    nodes.fixed[i] = nodes.fixed[n.value()];
  }
}

// The nodes that stand for themselves, in the order in which those with equal points are kept: a fixed node before a
// corner, a corner before another, then the first.
template <class Traits>
std::vector<Node_index> by_rank(const Layer_nodes<Traits>& nodes) {
  std::vector<Node_index> result;
  result.reserve(nodes.representative.size());
  const auto rank = [&](std::size_t i) {
    return nodes.fixed[i] ? (nodes.corner[i] ? 0 : 1) : (nodes.corner[i] ? 2 : 3);
  };
  for (int wanted = 0; wanted < 4; ++wanted) {
    for (std::size_t i = 0; i < nodes.representative.size(); ++i) {
      if (nodes.representative[i] == Node_index(i) && rank(i) == wanted) result.emplace_back(i);
    }
  }
  return result;
}

// Merges nodes with equal points. Linear where coordinates are floating point numbers, else O(n log n).
template <class Traits>
void merge_equal(Layer_nodes<Traits>& nodes) {
  bool any = false;
  using Point_2 = typename Traits::Point_2;
  if constexpr (std::is_floating_point_v<typename Traits::FT>) {
    Number_table table(nodes.representative.size());
    for (Node_index n : by_rank(nodes)) {
      const Point_2& point = nodes.point(n);
      const std::uint64_t hash = mixed(static_cast<double>(point.x()), static_cast<double>(point.y()));
      Node_index kept = n;
      table.for_each(hash, [&](std::uint32_t m) {
        if (is_equal<Traits>(nodes.points[m], point)) kept = Node_index(m);
      });
      if (kept == n) {
        table.insert(hash, static_cast<std::uint32_t>(n.value()));
      } else {
        merge(nodes, n, kept);
        any = true;
      }
    }
  } else {
    const auto less = [](const Point_2& p, const Point_2& q) { return is_less_xy<Traits>(p, q); };
    std::map<Point_2, Node_index, decltype(less)> kept(less);
    for (Node_index n : by_rank(nodes)) {
      const auto [place, is_new] = kept.try_emplace(nodes.point(n), n);
      if (is_new) continue;
      merge(nodes, n, place->second);
      any = true;
    }
  }
  if (any) settle(nodes);
}

// The vertex-vertex rule: free nodes merge into fixed ones within the tolerance, then into corners, then into one
// another, nearest first. O((n + k) log n) for k pairs within the tolerance.
template <class Traits, class SegmentIndex>
class Node_merger {
 public:
  Node_merger(Layer_nodes<Traits>& nodes, const Snap_clearance<Traits, SegmentIndex>& clearance, double tolerance)
      : nodes_(nodes), clearance_(clearance), tolerance_(tolerance) {}

  void run() {
    std::vector<Pair> pairs = close_pairs();
    std::sort(pairs.begin(), pairs.end());
    for (const Pair& pair : pairs) {
      const bool both_stand = stands(pair.moving) && stands(pair.kept);
      if (both_stand && clearance_.allows(nodes_.place(pair.moving), pair.distance, {pair.moving, pair.kept})) {
        merge(nodes_, pair.moving, pair.kept);
      }
    }
    settle(nodes_);
  }

 private:
  struct Pair {
    int rank;  // 0 for a fixed node that is kept, 1 for a corner, 2 for any other
    double distance;
    Node_index kept, moving;
    auto operator<=>(const Pair&) const = default;
  };

  bool stands(Node_index n) const { return nodes_.representative[n.value()] == n; }
  int rank(Node_index n) const { return nodes_.fixed[n.value()] ? 0 : nodes_.corner[n.value()] ? 1 : 2; }

  std::vector<Pair> close_pairs() const {
    std::vector<Node_index> standing;
    std::vector<CGAL::Bbox_2> boxes;
    for (std::size_t i = 0; i < nodes_.representative.size(); ++i) {
      if (!stands(Node_index(i))) continue;
      standing.emplace_back(i);
      boxes.push_back(nodes_.box(Node_index(i)));
    }
    const SegmentIndex index(boxes);
    const double reach = std::accumulate(nodes_.reaches.begin(), nodes_.reaches.end(), tolerance_,
                                         [](double a, double b) { return std::max(a, b); });
    std::vector<Pair> pairs;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < standing.size(); ++i) {
      found.clear();
      index.candidates(inflated(boxes[i], reach), std::back_inserter(found));
      for (std::size_t j : found) {
        if (i < j) add_pair(standing[i], standing[j], pairs);
      }
    }
    return pairs;
  }

  void add_pair(Node_index n, Node_index m, std::vector<Pair>& pairs) const {
    const double d = distance(nodes_.place(n), nodes_.place(m));
    const bool is_one_fixed = nodes_.fixed[n.value()] != nodes_.fixed[m.value()];
    const double allowed = is_one_fixed ? std::max(tolerance_, nodes_.reach(n, m)) : tolerance_;
    if (d > allowed || (rank(n) == 0 && rank(m) == 0)) return;
    const bool keep_first = std::tuple(rank(n), n) < std::tuple(rank(m), m);
    pairs.push_back({std::min(rank(n), rank(m)), d, keep_first ? n : m, keep_first ? m : n});
  }

  Layer_nodes<Traits>& nodes_;
  const Snap_clearance<Traits, SegmentIndex>& clearance_;
  double tolerance_;
};

}  // namespace CCSweep::internal

#endif
