// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_SEGMENT_INDEX_H
#define CCSWEEP_LOOPS_SEGMENT_INDEX_H

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CCSweep {

/// A spatial index over segments in the plane. It is built once from the segments' boxes and asked for the segments
/// whose box meets a given one. It must report every such segment, in any order, each once; it may report more. So
/// boxes rounded outwards to double serve any kernel, and the decisions stay with the caller's exact predicates.
template <class Index>
concept SegmentIndex_2 = std::constructible_from < Index,
        const std::vector<CGAL::Bbox_2>
& > &&requires(const Index& index, const CGAL::Bbox_2& box, std::vector<std::size_t>& found) {
  index.candidates(box, std::back_inserter(found));
};

/// An index that finds all pairs of its own segments whose boxes meet at once, the lower number first, each pair once,
/// in any order; it may report more. Where an index can, it is asked for this instead of once for every segment.
template <class Index>
concept SelfJoiningSegmentIndex_2 = SegmentIndex_2<Index> &&
    requires(const Index& index, std::vector<std::pair<std::uint32_t, std::uint32_t>>& found) {
  index.pairs(std::back_inserter(found));
};

/// Model of `SegmentIndex_2`: a packed r-tree. Building takes O(n log n), a query O(log n + found) on well spread
/// input. `Traits` is the kernel of the segments.
template <class Traits>
class Rtree_segment_index_2 {
 public:
  explicit Rtree_segment_index_2(const std::vector<CGAL::Bbox_2>& boxes) : tree_(values(boxes)) {}

  /// Writes the numbers of all segments whose box meets `box`, in no particular order.
  template <class OutputIterator>
  OutputIterator candidates(const CGAL::Bbox_2& box, OutputIterator out) const {
    const auto number = [&out](const Value& value) { *out++ = std::size_t{value.second}; };
    tree_.query(boost::geometry::index::intersects(rectangle(box)), boost::make_function_output_iterator(number));
    return out;
  }

 private:
  using Point = boost::geometry::model::d2::point_xy<double>;
  using Rectangle = boost::geometry::model::box<Point>;
  using Value = std::pair<Rectangle, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<Value, boost::geometry::index::quadratic<16>>;

  static Rectangle rectangle(const CGAL::Bbox_2& box) {
    return {Point(box.xmin(), box.ymin()), Point(box.xmax(), box.ymax())};
  }

  static std::vector<Value> values(const std::vector<CGAL::Bbox_2>& boxes) {
    std::vector<Value> result;
    result.reserve(boxes.size());
    for (const CGAL::Bbox_2& box : boxes) {
      result.emplace_back(rectangle(box), static_cast<std::uint32_t>(result.size()));
    }
    return result;
  }

  Tree tree_;
};

/// Model of `SelfJoiningSegmentIndex_2`: a hierarchy of boxes over runs of consecutive segments. Outlines are ordered,
/// so nothing is sorted: building is linear, and a query takes O(log n + found) where neighbours in the sequence lie
/// side by side. On segments in no order a query takes O(n). `Traits` is the kernel of the segments.
template <class Traits>
class Run_segment_index_2 {
 public:
  explicit Run_segment_index_2(const std::vector<CGAL::Bbox_2>& boxes) : boxes_(boxes), levels_(1, {0, boxes.size()}) {
    boxes_.reserve(boxes.size() + boxes.size() / (fan - 1) + 64);
    while (levels_.back().size > 1) {
      const Level below = levels_.back();
      levels_.push_back({boxes_.size(), (below.size + fan - 1) / fan});
      for (std::size_t i = 0; i < below.size; i += fan) {
        CGAL::Bbox_2 run = boxes_[below.first + i];
        for (std::size_t j = i + 1; j < below.size && j < i + fan; ++j) run += boxes_[below.first + j];
        boxes_.push_back(run);
      }
    }
  }

  /// Writes the numbers of all segments whose box meets `box`, ascending.
  template <class OutputIterator>
  OutputIterator candidates(const CGAL::Bbox_2& box, OutputIterator out) const {
    if (levels_.front().size > 0 && meet(boxes_.back(), box)) descend(levels_.size() - 1, 0, box, out);
    return out;
  }

  /// Writes the pairs of all segments whose boxes meet.
  template <class OutputIterator>
  OutputIterator pairs(OutputIterator out) const {
    if (levels_.front().size > 0) join(levels_.size() - 1, 0, out);
    return out;
  }

 private:
  static constexpr std::size_t fan = 4;
  struct Level {
    std::size_t first, size;  // in boxes_; level 0 are the segments
  };

  const CGAL::Bbox_2& box(std::size_t level, std::size_t run) const { return boxes_[levels_[level].first + run]; }

  // The number after the last of the runs, one level below, that a run is made of.
  std::size_t end(std::size_t level, std::size_t run) const {
    return std::min(fan * (run + 1), levels_[level - 1].size);
  }

  // All four, as a branch that can't be foreseen takes longer.
  static bool meet(const CGAL::Bbox_2& a, const CGAL::Bbox_2& b) {
    return static_cast<bool>((a.xmin() <= b.xmax()) & (b.xmin() <= a.xmax()) & (a.ymin() <= b.ymax()) &
                             (b.ymin() <= a.ymax()));
  }

  // Writes those runs, one level below, that a run is made of and that meet a box.
  std::size_t* meeting(std::size_t level, std::size_t run, const CGAL::Bbox_2& other, std::size_t* out) const {
    for (std::size_t i = fan * run; i < end(level, run); ++i) {
      *out = i;
      out += meet(box(level - 1, i), other);
    }
    return out;
  }

  // For a run that meets the box.
  template <class OutputIterator>
  void descend(std::size_t level, std::size_t run, const CGAL::Bbox_2& other, OutputIterator& out) const {
    if (level == 0) {
      *out++ = run;
      return;
    }
    std::size_t parts[fan];
    const std::size_t* const last = meeting(level, run, other, parts);
    for (const std::size_t* i = parts; i != last; ++i) descend(level - 1, *i, other, out);
  }

  template <class OutputIterator>
  void join(std::size_t level, std::size_t run, OutputIterator& out) const {
    if (level == 0) return;
    for (std::size_t i = fan * run; i < end(level, run); ++i) {
      join(level - 1, i, out);
      for (std::size_t j = i + 1; j < end(level, run); ++j) {
        if (meet(box(level - 1, i), box(level - 1, j))) join(level - 1, i, j, out);
      }
    }
  }

  // For two runs that meet.
  template <class OutputIterator>
  void join(std::size_t level, std::size_t run, std::size_t other, OutputIterator& out) const {
    if (level == 0) {
      *out++ = std::pair(static_cast<std::uint32_t>(run), static_cast<std::uint32_t>(other));
      return;
    }
    std::size_t parts[fan], other_parts[fan];
    const std::size_t* const last = meeting(level, run, box(level, other), parts);
    const std::size_t* const other_last = meeting(level, other, box(level, run), other_parts);
    for (const std::size_t* i = parts; i != last; ++i) {
      for (const std::size_t* j = other_parts; j != other_last; ++j) {
        if (meet(box(level - 1, *i), box(level - 1, *j))) join(level - 1, *i, *j, out);
      }
    }
  }

  std::vector<CGAL::Bbox_2> boxes_;
  std::vector<Level> levels_;
};

/// Model of `SegmentIndex_2` that looks at every segment: the oracle of the others. A query takes O(n).
template <class Traits>
class Brute_force_segment_index_2 {
 public:
  explicit Brute_force_segment_index_2(const std::vector<CGAL::Bbox_2>& boxes) : boxes_(boxes) {}

  /// Writes the numbers of all segments whose box meets `box`, ascending.
  template <class OutputIterator>
  OutputIterator candidates(const CGAL::Bbox_2& box, OutputIterator out) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (CGAL::do_overlap(boxes_[i], box)) *out++ = i;
    }
    return out;
  }

 private:
  std::vector<CGAL::Bbox_2> boxes_;
};

}  // namespace CCSweep

#endif
