// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_COLUMN_MAP_H
#define CCSWEEP_LINKING_COLUMN_MAP_H

#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CCSweep {

/// A place on a closed loop of nodes: a fraction of the way from node `index` to the next.
struct Loop_place {
  std::size_t index = 0;
  double fraction = 0;
};

/// The columns of one wall strip: which place of its upper loop stands above a place of its lower one (section 2.3).
///
/// Both loops get one cyclic coordinate v. Rails have the same v at both ends; between them v is shared out by length,
/// measured across the sweep, so that on a wall along the sweep columns follow it however the caps slant or bend. A
/// strip without rails (a round hole) is aligned by the loops' centroids. Counts of nodes need not agree: a column
/// starts at each node of either loop.
class Column_map {
 public:
  using Point = std::array<double, 3>;

  Column_map(std::vector<Point> bottom, std::vector<Point> top, const std::vector<Wall_strip::Rail>& rails,
             const Point& direction)
      : bottom_(std::move(bottom)), top_(std::move(top)), direction_(direction) {
    if (rails.empty())
      align_by_centroids();
    else
      align_by_rails(rails);
  }

  /// The place of the upper loop above node i of the lower one.
  Loop_place above(std::size_t i) const { return locate(top_v_, bottom_v_[i]); }
  /// The place of the lower loop below node i of the upper one.
  Loop_place below(std::size_t i) const { return locate(bottom_v_, top_v_[i]); }

  /// The same for any place of a loop.
  Loop_place above(const Loop_place& place) const { return locate(top_v_, bottom_v_.at(place)); }
  Loop_place below(const Loop_place& place) const { return locate(bottom_v_, top_v_.at(place)); }

  Point point_above(std::size_t i) const { return at(top_, above(i)); }
  Point point_below(std::size_t i) const { return at(bottom_, below(i)); }

 private:
  // The cyclic coordinate of a loop: `start` is the node with the smallest v; v grows from there by `period` in all.
  struct Coordinates {
    std::vector<double> of_node;
    std::size_t start = 0;
    double period = 1;
    double operator[](std::size_t i) const { return of_node[i]; }
    double at(const Loop_place& place) const {
      const double a = of_node[place.index];
      double b = of_node[(place.index + 1) % of_node.size()];
      if (b < a) b += period;
      return a + place.fraction * (b - a);
    }
  };

  double length_across(const Point& a, const Point& b) const {
    using namespace internal;
    const Point w = b - a;
    const Point across = w - dot(w, direction_) * direction_;
    // A little of the whole length keeps v growing on pieces that run along the sweep.
    return norm(across) + 1e-9 * norm(w) + std::numeric_limits<double>::min();
  }

  // Shares out [v, v + width] over the nodes from `first` to `last` by length.
  void share_out(const std::vector<Point>& loop, std::size_t first, std::size_t last, double v, double width,
                 Coordinates& coordinates) const {
    const std::size_t n = loop.size();
    const std::size_t count = last > first ? last - first : last + n - first;
    std::vector<double> sum(count + 1, 0);
    for (std::size_t k = 0; k < count; ++k)
      sum[k + 1] = sum[k] + length_across(loop[(first + k) % n], loop[(first + k + 1) % n]);
    for (std::size_t k = 0; k < count; ++k) coordinates.of_node[(first + k) % n] = v + width * (sum[k] / sum[count]);
  }

  void align_by_rails(const std::vector<Wall_strip::Rail>& rails) {
    const std::size_t m = rails.size();
    for (Coordinates* c : {&bottom_v_, &top_v_}) c->period = double(m);
    bottom_v_.of_node.resize(bottom_.size());
    top_v_.of_node.resize(top_.size());
    bottom_v_.start = rails[0].bottom;
    top_v_.start = rails[0].top;
    for (std::size_t i = 0; i < m; ++i) {
      share_out(bottom_, rails[i].bottom, rails[(i + 1) % m].bottom, double(i), 1, bottom_v_);
      share_out(top_, rails[i].top, rails[(i + 1) % m].top, double(i), 1, top_v_);
    }
  }

  void align_by_centroids() {
    using namespace internal;
    const Point shift = centroid(top_) - centroid(bottom_);
    bottom_v_.of_node.resize(bottom_.size());
    top_v_.of_node.resize(top_.size());
    share_out(bottom_, 0, 0, 0, 1, bottom_v_);
    const Loop_place seam = nearest(top_, bottom_[0] + shift);
    // v of the top loop starts at the seam, which need not be a node.
    std::vector<double> from_first(top_.size() + 1, 0);
    for (std::size_t i = 0; i < top_.size(); ++i)
      from_first[i + 1] = from_first[i] + length_across(top_[i], top_[(i + 1) % top_.size()]);
    const double whole = from_first.back();
    const double at_seam =
        from_first[seam.index] + seam.fraction * (from_first[seam.index + 1] - from_first[seam.index]);
    for (std::size_t i = 0; i < top_.size(); ++i) {
      const double v = (from_first[i] - at_seam) / whole;
      top_v_.of_node[i] = v < 0 ? v + 1 : v;
    }
    top_v_.start = std::min_element(top_v_.of_node.begin(), top_v_.of_node.end()) - top_v_.of_node.begin();
  }

  Point centroid(const std::vector<Point>& loop) const {
    using namespace internal;
    Point sum{};
    double whole = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double l = length_across(a, b);
      sum = sum + (l / 2) * (a + b);
      whole += l;
    }
    return (1 / whole) * sum;
  }

  Loop_place nearest(const std::vector<Point>& loop, const Point& p) const {
    using namespace internal;
    Loop_place best;
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point &a = loop[i], w = loop[(i + 1) % loop.size()] - a;
      const double t = std::clamp(dot(p - a, w) / std::max(dot(w, w), 1e-300), 0.0, 1.0);
      const double d = norm(p - (a + t * w));
      if (d < best_distance) {
        best_distance = d;
        best = {i, t};
      }
    }
    if (best.fraction == 1) best = {(best.index + 1) % loop.size(), 0};
    return best;
  }

  static Point at(const std::vector<Point>& loop, const Loop_place& place) {
    using namespace internal;
    const Point &a = loop[place.index], &b = loop[(place.index + 1) % loop.size()];
    return a + place.fraction * (b - a);
  }

  static Loop_place locate(const Coordinates& c, double v) {
    const std::size_t n = c.of_node.size();
    auto node = [&](std::size_t k) { return c.start + k < n ? c.start + k : c.start + k - n; };
    if (v < c[c.start]) v += c.period;  // before the first node: on the piece that closes the loop
    if (v >= c[c.start] + c.period) v -= c.period;
    std::size_t low = 0, high = n;      // the last node whose v is not larger
    while (high - low > 1) {
      const std::size_t middle = (low + high) / 2;
      (c[node(middle)] <= v ? low : high) = middle;
    }
    const double a = c[node(low)], b = low + 1 < n ? c[node(low + 1)] : c[c.start] + c.period;
    const double fraction = b > a ? std::clamp((v - a) / (b - a), 0.0, 1.0) : 0.0;
    return fraction == 1 ? Loop_place{node(low + 1), 0} : Loop_place{node(low), fraction};
  }

  std::vector<Point> bottom_, top_;
  Point direction_;
  Coordinates bottom_v_, top_v_;
};

}  // namespace CCSweep

#endif
