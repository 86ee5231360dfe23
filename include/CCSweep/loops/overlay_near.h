// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_NEAR_H
#define CCSWEEP_LOOPS_OVERLAY_NEAR_H

#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/segment_index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CCSweep::internal {

using Near_pair = std::pair<std::uint32_t, std::uint32_t>;

// A box that costs no calls.
struct Flat_box {
  double xmin, ymin, xmax, ymax;

  friend bool boxes_meet(const Flat_box& a, const Flat_box& b) {
    return a.xmin <= b.xmax && b.xmin <= a.xmax && a.ymin <= b.ymax && b.ymin <= a.ymax;
  }
  void add(const Flat_box& b) {
    xmin = std::min(xmin, b.xmin);
    ymin = std::min(ymin, b.ymin);
    xmax = std::max(xmax, b.xmax);
    ymax = std::max(ymax, b.ymax);
  }
  CGAL::Bbox_2 bbox() const { return {xmin, ymin, xmax, ymax}; }
};

inline Flat_box flat_box(const CGAL::Bbox_2& b, double inflated_by = 0) {
  return {b.xmin() - inflated_by, b.ymin() - inflated_by, b.xmax() + inflated_by, b.ymax() + inflated_by};
}

// Whether all of a segment cd is on one side of the line ab, and farther from it than `reach`. What rounding does to
// the coordinates must be within the reach.
inline bool is_beside(Place_2 a, Place_2 b, Place_2 c, Place_2 d, double reach) {
  const double x = b[0] - a[0], y = b[1] - a[1];
  const double s = x * (c[1] - a[1]) - y * (c[0] - a[0]), t = x * (d[1] - a[1]) - y * (d[0] - a[0]);
  const double nearest = reach * reach * (x * x + y * y);
  return s * t > 0 && s * s > nearest && t * t > nearest;
}

// Whether two segments are certainly farther apart than `reach`.
template <class Traits>
bool are_apart(const Layer_nodes<Traits>& nodes, const std::array<Node_index, 2>& s, const std::array<Node_index, 2>& t,
               double reach) {
  if constexpr (has_plain_coordinates<Traits>) {
    const Place_2 a = nodes.place(s[0]), b = nodes.place(s[1]), c = nodes.place(t[0]), d = nodes.place(t[1]);
    return is_beside(a, b, c, d, reach) || is_beside(c, d, a, b, reach);
  }
  return false;
}

// Whether a segment goes on from another by less than a right angle, and so meets it where it begins only.
template <class Traits>
bool runs_on(const Layer_nodes<Traits>& nodes, const std::array<Node_index, 2>& s,
             const std::array<Node_index, 2>& t) {
  if constexpr (has_plain_coordinates<Traits>) {
    if (s[1] != t[0]) return false;
    const Place_2 a = nodes.place(s[0]), b = nodes.place(s[1]), c = nodes.place(t[1]);
    return (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) > 0;
  }
  return false;
}

// Finds all pairs of segments whose boxes meet and that `may_meet` lets pass. Outlines are ordered: neighbours in the
// sequence lie side by side in the plane, so the index gets short runs of them, and is an eighth of the size and asked
// an eighth as often.
template <class SegmentIndex, class May_meet>
class Near_pairs {
 public:
  static std::vector<Near_pair> of(const std::vector<Flat_box>& boxes, const May_meet& may_meet) {
    Near_pairs search(boxes, may_meet);
    search.make_runs();
    search.find();
    return std::move(search.pairs_);
  }

 private:
  static constexpr std::uint32_t length = 8;

  Near_pairs(const std::vector<Flat_box>& boxes, const May_meet& may_meet) : boxes_(boxes), may_meet_(may_meet) {}

  // Segments in no order do not meet their predecessors, and make runs of one.
  void make_runs() {
    const std::uint32_t size = static_cast<std::uint32_t>(boxes_.size());
    firsts_.reserve(size / length + 2);
    runs_.reserve(size / length + 1);
    for (std::uint32_t i = 0; i < size;) {
      firsts_.push_back(i);
      Flat_box run = boxes_[i];
      const std::uint32_t end = std::min(i + length, size);
      for (++i; i < end && boxes_meet(run, boxes_[i]); ++i) run.add(boxes_[i]);
      runs_.push_back(run.bbox());
    }
    firsts_.push_back(size);
  }

  void find() {
    const SegmentIndex index(runs_);
    std::vector<std::size_t> found;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      within(run);
      found.clear();
      index.candidates(runs_[run], std::back_inserter(found));
      for (std::size_t other : found) {
        if (run < other) between(run, other);
      }
    }
  }

  void within(std::size_t run) {
    for (std::uint32_t i = firsts_[run]; i < firsts_[run + 1]; ++i) {
      for (std::uint32_t j = i + 1; j < firsts_[run + 1]; ++j) {
        if (boxes_meet(boxes_[i], boxes_[j]) && may_meet_(i, j)) pairs_.emplace_back(i, j);
      }
    }
  }

  void between(std::size_t run, std::size_t other) {
    const Flat_box first = flat_box(runs_[run]), second = flat_box(runs_[other]);
    std::uint32_t near[length];
    std::uint32_t size = 0;
    for (std::uint32_t j = firsts_[other]; j < firsts_[other + 1]; ++j) {
      if (boxes_meet(boxes_[j], first)) near[size++] = j;
    }
    if (size == 0) return;
    for (std::uint32_t i = firsts_[run]; i < firsts_[run + 1]; ++i) {
      if (!boxes_meet(boxes_[i], second)) continue;
      for (std::uint32_t k = 0; k < size; ++k) {
        if (boxes_meet(boxes_[i], boxes_[near[k]]) && may_meet_(i, near[k])) pairs_.emplace_back(i, near[k]);
      }
    }
  }

  const std::vector<Flat_box>& boxes_;
  const May_meet& may_meet_;
  std::vector<std::uint32_t> firsts_;  // the first segment of each run, and the number of segments
  std::vector<CGAL::Bbox_2> runs_;
  std::vector<Near_pair> pairs_;
};

}  // namespace CCSweep::internal

#endif
