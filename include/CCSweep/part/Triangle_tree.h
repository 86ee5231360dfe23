// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_TRIANGLE_TREE_H
#define CCSWEEP_PART_TRIANGLE_TREE_H

#include <CCSweep/part/Surface_charts.h>
#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// A hierarchy of boxes over the triangles of a surface, to find the pairs of triangles near each other. Each chart has
// a branch to itself, so the pairs inside of it, which need no look, are left out together. Building takes O(n log n).
class Triangle_tree {
 public:
  // `charts` as `Surface_charts` tells.
  Triangle_tree(const std::vector<CGAL::Bbox_3>& boxes, const std::vector<std::uint32_t>& charts) : boxes_(boxes) {
    order_.reserve(boxes.size());
    for (std::uint32_t t = 0; t < boxes.size(); ++t) order_.push_back(t);
    std::stable_sort(order_.begin(), order_.end(), [&](auto s, auto t) { return charts[s] < charts[t]; });
    std::vector<Run> runs;
    for (std::uint32_t first = 0, last; first < order_.size(); first = last) {
      const std::uint32_t chart = charts[order_[first]];
      for (last = first + 1; last < order_.size() && charts[order_[last]] == chart;) ++last;
      runs.push_back({first, last, chart != none, hull(first, last)});
    }
    if (!runs.empty()) build_charts(runs.begin(), runs.end());
  }

  // Calls f for the triangles of each pair whose boxes meet and that is not within a chart, until it returns false.
  template <class Function>
  void for_each_pair(const Function& f) const {
    if (!nodes_.empty()) within(0, f);
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t leaf_size = 4;

  // Triangles that follow one another in the order.
  struct Run {
    std::uint32_t first, last;
    bool is_chart;
    CGAL::Bbox_3 box;
  };
  struct Node : Run {
    std::uint32_t left = none, right = none;  // its parts; a leaf has none
    bool is_leaf() const { return left == none; }
  };

  CGAL::Bbox_3 hull(std::uint32_t first, std::uint32_t last) const {
    CGAL::Bbox_3 result;
    for (std::uint32_t i = first; i < last; ++i) result += boxes_[order_[i]];
    return result;
  }

  static int longest_axis(const CGAL::Bbox_3& box) {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
      if (box.max(k) - box.min(k) > box.max(axis) - box.min(axis)) axis = k;
    return axis;
  }
  static double middle(const CGAL::Bbox_3& box, int axis) { return box.min(axis) + box.max(axis); }

  std::uint32_t add(const Run& run) {
    nodes_.push_back({run});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }

  // A branch of several charts is split between them.
  std::uint32_t build_charts(std::vector<Run>::iterator first, std::vector<Run>::iterator last) {
    if (last - first == 1) return build(*first);
    CGAL::Bbox_3 box;
    for (auto run = first; run != last; ++run) box += run->box;
    const std::uint32_t node = add({0, 0, false, box});
    const auto half = first + (last - first) / 2;
    std::nth_element(first, half, last, [axis = longest_axis(box)](const Run& a, const Run& b) {
      return middle(a.box, axis) < middle(b.box, axis);
    });
    const std::uint32_t left = build_charts(first, half), right = build_charts(half, last);
    nodes_[node].left = left;
    nodes_[node].right = right;
    return node;
  }

  std::uint32_t build(const Run& run) {
    const std::uint32_t node = add(run);
    if (run.last - run.first <= leaf_size) return node;
    const std::uint32_t half = run.first + (run.last - run.first) / 2;
    std::nth_element(order_.begin() + run.first, order_.begin() + half, order_.begin() + run.last,
                     [&, axis = longest_axis(run.box)](std::uint32_t s, std::uint32_t t) {
                       return middle(boxes_[s], axis) < middle(boxes_[t], axis);
                     });
    const std::uint32_t left = build({run.first, half, run.is_chart, hull(run.first, half)});
    const std::uint32_t right = build({half, run.last, run.is_chart, hull(half, run.last)});
    nodes_[node].left = left;
    nodes_[node].right = right;
    return node;
  }

  // These return whether to go on.
  template <class Function>
  bool within(std::uint32_t number, const Function& f) const {
    const Node& node = nodes_[number];
    if (node.is_chart) return true;
    if (!node.is_leaf()) return within(node.left, f) && within(node.right, f) && between(node.left, node.right, f);
    for (std::uint32_t i = node.first; i < node.last; ++i)
      for (std::uint32_t j = i + 1; j < node.last; ++j)
        if (!look_at(order_[i], order_[j], f)) return false;
    return true;
  }

  template <class Function>
  bool between(std::uint32_t number, std::uint32_t other, const Function& f) const {
    const Node &a = nodes_[number], &b = nodes_[other];
    if (!CGAL::do_overlap(a.box, b.box)) return true;
    if (a.is_leaf() && b.is_leaf()) {
      for (std::uint32_t i = a.first; i < a.last; ++i)
        for (std::uint32_t j = b.first; j < b.last; ++j)
          if (!look_at(order_[i], order_[j], f)) return false;
      return true;
    }
    const bool split_first = b.is_leaf() || (!a.is_leaf() && extent(a.box) >= extent(b.box));
    if (split_first) return between(a.left, other, f) && between(a.right, other, f);
    return between(number, b.left, f) && between(number, b.right, f);
  }

  static double extent(const CGAL::Bbox_3& box) { return box.x_span() + box.y_span() + box.z_span(); }

  template <class Function>
  bool look_at(std::uint32_t s, std::uint32_t t, const Function& f) const {
    return !CGAL::do_overlap(boxes_[s], boxes_[t]) || f(s, t);
  }

  const std::vector<CGAL::Bbox_3>& boxes_;
  std::vector<std::uint32_t> order_;  // of the triangles
  std::vector<Node> nodes_;           // the root first
};

}  // namespace CCSweep::internal

#endif
