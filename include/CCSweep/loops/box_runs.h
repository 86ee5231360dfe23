// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_BOX_RUNS_H
#define CCSWEEP_LOOPS_BOX_RUNS_H

#include <CGAL/Bbox_2.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CCSweep::internal {

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
  Flat_box inflated(double by) const { return {xmin - by, ymin - by, xmax + by, ymax + by}; }
  CGAL::Bbox_2 bbox() const { return {xmin, ymin, xmax, ymax}; }
};

inline Flat_box flat_box(const CGAL::Bbox_2& b) { return {b.xmin(), b.ymin(), b.xmax(), b.ymax()}; }

// Boxes of segments in short runs. Outlines are ordered: neighbours in the sequence lie side by side in the plane, so an
// index gets the boxes of the runs, and is an eighth of the size and asked an eighth as often.
class Box_runs {
 public:
  static constexpr std::uint32_t length = 8;

  // Segments in no order do not meet their predecessors, and make runs of one.
  template <class Box>
  explicit Box_runs(const std::vector<Box>& boxes) {
    const std::uint32_t size = static_cast<std::uint32_t>(boxes.size());
    firsts_.reserve(size / length + 2);
    boxes_.reserve(size / length + 1);
    for (std::uint32_t i = 0; i < size;) {
      firsts_.push_back(i);
      Flat_box run = boxes[i];
      const std::uint32_t end = std::min(i + length, size);
      for (++i; i < end && boxes_meet(run, boxes[i]); ++i) run.add(boxes[i]);
      boxes_.push_back(run.bbox());
    }
    firsts_.push_back(size);
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(boxes_.size()); }
  const std::vector<CGAL::Bbox_2>& boxes() const { return boxes_; }
  std::uint32_t begin(std::uint32_t run) const { return firsts_[run]; }
  std::uint32_t end(std::uint32_t run) const { return firsts_[run + 1]; }

 private:
  std::vector<std::uint32_t> firsts_;  // the first segment of each run, and the number of segments
  std::vector<CGAL::Bbox_2> boxes_;    // by run
};

// Finds those of a sequence of segments whose boxes meet a box, by an index of their runs.
template <class SegmentIndex>
class Run_search {
 public:
  explicit Run_search(std::vector<Flat_box> boxes) : boxes_(std::move(boxes)), runs_(boxes_), index_(runs_.boxes()) {}

  // Appends the numbers of the segments, in no particular order.
  void find(const CGAL::Bbox_2& box, std::vector<std::size_t>& found) const {
    const Flat_box wanted = flat_box(box);
    const auto look_through = [&](std::uint32_t run) {
      for (std::uint32_t i = runs_.begin(run); i < runs_.end(run); ++i)
        if (boxes_meet(boxes_[i], wanted)) found.push_back(i);
    };
    index_.candidates(box, boost::make_function_output_iterator(look_through));
  }

 private:
  std::vector<Flat_box> boxes_;
  Box_runs runs_;
  SegmentIndex index_;
};

}  // namespace CCSweep::internal

#endif
