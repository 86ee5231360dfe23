// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_NEAR_H
#define CCSWEEP_LOOPS_OVERLAY_NEAR_H

#include <CCSweep/internal/bucket_sort.h>
#include <CCSweep/loops/box_runs.h>
#include <CCSweep/loops/overlay_chains.h>
#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/segment_index.h>

#include <algorithm>
#include <array>
#include <boost/iterator/function_output_iterator.hpp>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace CCSweep::internal {

using Near_pair = std::pair<std::uint32_t, std::uint32_t>;
using Step = std::array<Node_index, 2>;  // from a node of a chain to the next

// Whether all of a segment cd is on one side of the line ab, and farther from it than `reach`.
inline bool is_beside(Place_2 a, Place_2 b, Place_2 c, Place_2 d, double reach) {
  return clear_side(a, b, c, reach) * clear_side(a, b, d, reach) > 0;
}

// Whether segments from c to u and to v get farther from each other than `reach`, wherever they end.
inline bool are_spread(Place_2 c, Place_2 u, Place_2 v, double reach) {
  const double ux = u[0] - c[0], uy = u[1] - c[1], vx = v[0] - c[0], vy = v[1] - c[1];
  const double nearest = reach * reach;
  if (ux * vx + uy * vy < 0) return ux * ux + uy * uy > nearest && vx * vx + vy * vy > nearest;
  return clear_side(c, u, v, reach) != 0 && clear_side(c, v, u, reach) != 0;
}

// Whether two segments are certainly farther apart than `reach`.
template <class Traits>
bool are_apart(const Layer_nodes<Traits>& nodes, const Step& s, const Step& t, double reach) {
  if constexpr (has_plain_coordinates<Traits>) {
    const Place_2 a = nodes.place(s[0]), b = nodes.place(s[1]), c = nodes.place(t[0]), d = nodes.place(t[1]);
    return is_beside(a, b, c, d, reach) || is_beside(c, d, a, b, reach);
  }
  return false;
}

// Whether a segment goes on from another by less than a right angle, and so meets it where it begins only.
template <class Traits>
bool runs_on(const Layer_nodes<Traits>& nodes, const Step& s, const Step& t) {
  if constexpr (has_plain_coordinates<Traits>) {
    if (s[1] != t[0]) return false;
    const Place_2 a = nodes.place(s[0]), b = nodes.place(s[1]), c = nodes.place(t[1]);
    return (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) > 0;
  }
  return false;
}

// Numbers the courses of a sequence of segments: a course is as long as the sequence runs on without turning back in x
// or y, and no segment of it is short. Segments of one course never come near each other, but for neighbours, which
// meet where the second begins.
class Course_counter {
 public:
  explicit Course_counter(double reach) : reach_(reach) {}

  // The course of a segment from box `a` to box `b`, which are those of its ends.
  std::uint32_t operator()(Node_index from, const Flat_box& a, Node_index to, const Flat_box& b) {
    const unsigned senses =
        this->senses(a.xmin, a.xmax, b.xmin, b.xmax) | this->senses(a.ymin, a.ymax, b.ymin, b.ymax) << 2;
    const double gap_x = std::max(b.xmin - a.xmax, a.xmin - b.xmax);
    const double gap_y = std::max(b.ymin - a.ymax, a.ymin - b.ymax);
    const bool is_short = !(std::max(gap_x, gap_y) > reach_);
    senses_ &= senses;
    if (from != end_ || is_short || (senses_ & 3) == 0 || (senses_ & 12) == 0) {
      ++course_;
      senses_ = is_short ? 0 : senses;
    }
    end_ = to;
    return course_;
  }

  // What follows does not run on.
  void interrupt() { end_ = Node_index(); }

 private:
  // One bit if a coordinate does not fall, another if it does not rise.
  static unsigned senses(double a_low, double a_high, double b_low, double b_high) {
    return static_cast<unsigned>(a_low <= b_low && a_high <= b_high) |
           static_cast<unsigned>(a_low >= b_low && a_high >= b_high) << 1;
  }

  double reach_;
  Node_index end_;
  unsigned senses_ = 0;
  std::uint32_t course_ = 0;
};

// Segments in a sequence, as a search for near ones sees them.
struct Course_box : Flat_box {
  std::uint32_t course;
};

// Finds all pairs of segments whose boxes meet and that `may_meet` lets pass, except pairs of one course. The index gets
// runs of segments.
template <class SegmentIndex, class May_meet>
class Near_pairs {
 public:
  static std::vector<Near_pair> of(const std::vector<Course_box>& boxes, const May_meet& may_meet) {
    Near_pairs search(boxes, may_meet);
    for (std::uint32_t run = 0; run < search.runs_.size(); ++run) search.within(run);
    search.find();
    return std::move(search.pairs_);
  }

 private:
  Near_pairs(const std::vector<Course_box>& boxes, const May_meet& may_meet)
      : boxes_(boxes), may_meet_(may_meet), runs_(boxes) {}

  void find() {
    const SegmentIndex index(runs_.boxes());
    if constexpr (SelfJoiningSegmentIndex_2<SegmentIndex>) {
      const auto meet = [this](const Near_pair& pair) { between(pair.first, pair.second); };
      index.pairs(boost::make_function_output_iterator(meet));
    } else {
      std::vector<std::size_t> found;
      for (std::uint32_t run = 0; run < runs_.size(); ++run) {
        found.clear();
        index.candidates(runs_.boxes()[run], std::back_inserter(found));
        for (std::size_t other : found) {
          if (run < other) between(run, static_cast<std::uint32_t>(other));
        }
      }
    }
  }

  bool are_one_course(std::uint32_t i, std::uint32_t j) const { return boxes_[i].course == boxes_[j].course; }

  void within(std::uint32_t run) {
    const std::uint32_t first = runs_.begin(run), last = runs_.end(run);
    if (are_one_course(first, last - 1)) return;
    std::uint32_t next_course = first;
    for (std::uint32_t i = first; i < last; ++i) {
      while (next_course < last && are_one_course(i, next_course)) ++next_course;
      for (std::uint32_t j = next_course; j < last; ++j) add(i, j);
    }
  }

  void between(std::uint32_t run, std::uint32_t other) {
    if (are_one_course(runs_.begin(run), runs_.end(other) - 1)) return;
    const Flat_box first = flat_box(runs_.boxes()[run]), second = flat_box(runs_.boxes()[other]);
    std::uint32_t near[Box_runs::length];
    std::uint32_t size = 0;
    for (std::uint32_t j = runs_.begin(other); j < runs_.end(other); ++j) {
      if (boxes_meet(boxes_[j], first)) near[size++] = j;
    }
    if (size == 0) return;
    for (std::uint32_t i = runs_.begin(run); i < runs_.end(run); ++i) {
      if (!boxes_meet(boxes_[i], second)) continue;
      for (std::uint32_t k = 0; k < size; ++k) add(i, near[k]);
    }
  }

  void add(std::uint32_t i, std::uint32_t j) {
    if (!are_one_course(i, j) && boxes_meet(boxes_[i], boxes_[j]) && may_meet_(i, j)) pairs_.emplace_back(i, j);
  }

  const std::vector<Course_box>& boxes_;
  const May_meet& may_meet_;
  Box_runs runs_;
  std::vector<Near_pair> pairs_;
};

// The steps of all chains.
inline std::vector<Step> steps_of(const Node_chains& chains) {
  std::vector<Step> result;
  result.reserve(chains.number_of_nodes() - chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c) {
    const std::span<const Node_index> chain = chains[c];
    for (std::size_t i = 1; i < chain.size(); ++i) result.push_back({chain[i - 1], chain[i]});
  }
  return result;
}

// For each step the first one with the same ends, itself if there is none before it. Linear, for a bounded number of
// steps at a node.
inline std::vector<std::uint32_t> first_twins(const std::vector<Step>& steps, std::size_t number_of_nodes) {
  std::vector<std::uint32_t> order(steps.size()), result(steps.size());
  std::iota(order.begin(), order.end(), 0);
  const auto low = [&](std::uint32_t s) { return std::min(steps[s][0], steps[s][1]); };
  const auto high = [&](std::uint32_t s) { return std::max(steps[s][0], steps[s][1]); };
  bucket_sort(
      order, number_of_nodes, [&](std::uint32_t s) { return low(s).value(); },
      [&](std::uint32_t s, std::uint32_t t) { return std::pair(high(s), s) < std::pair(high(t), t); });
  std::uint32_t first = 0;
  for (const std::uint32_t s : order) {
    if (s == order.front() || low(s) != low(first) || high(s) != high(first)) first = s;
    result[s] = first;
  }
  return result;
}

// Pairs of steps that come within twice `reach` of each other, except neighbours that run on; without steps that have
// an earlier twin, where `twins` are given.
template <class SegmentIndex, class Traits>
std::vector<Near_pair> near_steps(const std::vector<Step>& steps, const std::vector<std::uint32_t>& twins,
                                  const Layer_nodes<Traits>& nodes, double reach) {
  std::vector<Course_box> boxes;
  boxes.reserve(steps.size());
  std::vector<std::uint32_t> number;  // of the step of each box, if some have none
  Course_counter course(2 * reach);
  for (std::uint32_t s = 0; s < steps.size(); ++s) {
    if (!twins.empty() && twins[s] != s) {
      course.interrupt();
      continue;
    }
    if (!twins.empty()) number.push_back(s);
    const auto [from, to] = steps[s];
    const Flat_box a = flat_box(nodes.box(from)), b = flat_box(nodes.box(to));
    // Number by number, for a box that is put together and then copied has to wait for the numbers to arrive.
    Course_box& box = boxes.emplace_back();
    box.xmin = std::min(a.xmin, b.xmin) - reach;
    box.ymin = std::min(a.ymin, b.ymin) - reach;
    box.xmax = std::max(a.xmax, b.xmax) + reach;
    box.ymax = std::max(a.ymax, b.ymax) + reach;
    box.course = course(from, a, to, b);
  }
  const auto step = [&](std::uint32_t box) { return number.empty() ? box : number[box]; };
  const auto may_meet = [&](std::uint32_t i, std::uint32_t j) {
    const Step &s = steps[step(i)], &t = steps[step(j)];
    return !(step(j) == step(i) + 1 && runs_on(nodes, s, t)) && !are_apart(nodes, s, t, 2 * reach);
  };
  std::vector<Near_pair> result = Near_pairs<SegmentIndex, decltype(may_meet)>::of(boxes, may_meet);
  for (auto& [i, j] : result) {
    i = step(i);
    j = step(j);
  }
  return result;
}

}  // namespace CCSweep::internal

#endif
