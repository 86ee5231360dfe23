// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_POINT_INDEX_H
#define CCSWEEP_LOOPS_POINT_INDEX_H

#include <CGAL/Fuzzy_iso_box.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/cartesian/distance_pythagoras_point_box.hpp>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace CCSweep {

/// A spatial index over points in space. It is built once and asked for the numbers of the `k` points nearest to a
/// place, nearest first, of equally near ones the lower number; all of them if there are fewer. So every model gives
/// the same answer.
template <class Index>
concept PointIndex_3 = std::constructible_from < Index,
        const std::vector<std::array<double, 3>>
& > &&requires(const Index& index, const std::array<double, 3>& place, std::size_t k) {
  { index.nearest(place, k) } -> std::same_as<std::vector<std::size_t>>;
};

namespace internal {

inline double squared_distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

// The k nearest of some candidates, ties broken by number.
inline std::vector<std::size_t> nearest_of(const std::vector<std::size_t>& candidates,
                                           const std::vector<std::array<double, 3>>& points,
                                           const std::array<double, 3>& place, std::size_t k) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i : candidates) order.emplace_back(squared_distance(points[i], place), i);
  k = std::min(k, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), order.end());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < k; ++i) result.push_back(order[i].second);
  return result;
}

// How far from the place an index must look again, not to miss a point as near as the farthest of those it found.
inline double search_radius(const std::vector<std::size_t>& found, const std::vector<std::array<double, 3>>& points,
                            const std::array<double, 3>& place) {
  double farthest = 0;
  for (std::size_t i : found) farthest = std::max(farthest, squared_distance(points[i], place));
  return std::sqrt(farthest) * (1 + 1e-12);
}

}  // namespace internal

/// Model of `PointIndex_3`: a packed r-tree. Building takes O(n log n), a query O(k log n) on well spread points.
class Rtree_point_index_3 {
 public:
  using Point = std::array<double, 3>;

  explicit Rtree_point_index_3(const std::vector<Point>& points) : points_(points), tree_(values(points)) {}

  std::vector<std::size_t> nearest(const Point& place, std::size_t k) const {
    namespace bgi = boost::geometry::index;
    k = std::min(k, points_.size());
    if (k == 0) return {};
    // Which of several equally near points come last is for the numbers to decide, not for the tree: one point more
    // tells whether there are such.
    std::vector<std::size_t> found = numbers(bgi::nearest(corner(place, 0), static_cast<unsigned>(k + 1)));
    found = internal::nearest_of(found, points_, place, k + 1);
    const double radius = internal::search_radius(found, points_, place);
    const bool is_tie = found.size() > k && squared(found[k - 1], place) * (1 + 1e-12) >= squared(found[k], place);
    if (is_tie) {
      found = numbers(bgi::intersects(Box(corner(place, -radius), corner(place, radius))));
      found = internal::nearest_of(found, points_, place, k);
    }
    found.resize(k);
    return found;
  }

 private:
  using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Corner>;
  using Value = std::pair<Corner, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<Value, boost::geometry::index::quadratic<16>>;

  double squared(std::size_t i, const Point& place) const { return internal::squared_distance(points_[i], place); }
  static Corner corner(const Point& p, double by) { return {p[0] + by, p[1] + by, p[2] + by}; }

  static std::vector<Value> values(const std::vector<Point>& points) {
    std::vector<Value> result;
    for (const Point& p : points) result.emplace_back(corner(p, 0), static_cast<std::uint32_t>(result.size()));
    return result;
  }

  template <class Predicate>
  std::vector<std::size_t> numbers(const Predicate& predicate) const {
    std::vector<Value> found;
    tree_.query(predicate, std::back_inserter(found));
    std::vector<std::size_t> result;
    for (const Value& value : found) result.push_back(value.second);
    return result;
  }

  std::vector<Point> points_;
  Tree tree_;
};

/// Model of `PointIndex_3` that looks at every point: the oracle of the others. A query takes O(n + k log n).
class Brute_force_point_index_3 {
 public:
  using Point = std::array<double, 3>;

  explicit Brute_force_point_index_3(const std::vector<Point>& points) : points_(points) {}

  std::vector<std::size_t> nearest(const Point& place, std::size_t k) const {
    std::vector<std::size_t> all(points_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return internal::nearest_of(all, points_, place, k);
  }

 private:
  std::vector<Point> points_;
};

/// Model of `PointIndex_3`: CGAL's kd-tree. Building takes O(n log n), a query O(k log n) on well spread points. It
/// can be moved, not copied.
class Kd_tree_point_index_3 {
 public:
  using Point = std::array<double, 3>;

  explicit Kd_tree_point_index_3(const std::vector<Point>& points)
      : points_(std::make_unique<const std::vector<Point>>(points)) {
    std::vector<std::size_t> all(points.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    tree_ = std::make_unique<Tree>(all.begin(), all.end(), typename Tree::Splitter(), traits());
    if (!points.empty()) tree_->build();
  }

  std::vector<std::size_t> nearest(const Point& place, std::size_t k) const {
    if (points_->empty() || k == 0) return {};
    const Distance distance(Places{points_.get()});
    const Search search(*tree_, Query(place[0], place[1], place[2]), static_cast<unsigned>(k), 0, true, distance);
    std::vector<std::size_t> found;
    for (const auto& [i, squared] : search) found.push_back(i);
    const double r = internal::search_radius(found, *points_, place);
    found.clear();
    const CGAL::Fuzzy_iso_box<Search_traits> box(Query(place[0] - r, place[1] - r, place[2] - r),
                                                 Query(place[0] + r, place[1] + r, place[2] + r), 0, traits());
    tree_->search(std::back_inserter(found), box);
    return internal::nearest_of(found, *points_, place, k);
  }

 private:
  using Query = CGAL::Simple_cartesian<double>::Point_3;

  // Lets CGAL see the numbers as points.
  struct Places {
    using key_type = std::size_t;
    using value_type = Query;
    using reference = Query;
    using category = boost::readable_property_map_tag;

    const std::vector<Point>* points;
    friend Query get(const Places& places, std::size_t i) {
      const Point& p = (*places.points)[i];
      return {p[0], p[1], p[2]};
    }
  };

  using Basic_traits = CGAL::Search_traits_3<CGAL::Simple_cartesian<double>>;
  using Search_traits = CGAL::Search_traits_adapter<std::size_t, Places, Basic_traits>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Search_traits>;
  using Tree = Search::Tree;
  using Distance = Search::Distance;

  Search_traits traits() const { return Search_traits(Places{points_.get()}); }

  std::unique_ptr<const std::vector<Point>> points_;
  std::unique_ptr<Tree> tree_;
};

/// A point among the nearest.
struct Neighbour {
  double squared_distance;
  std::size_t number;
  auto operator<=>(const Neighbour&) const = default;
};

/// Finds the nearest points of places that come one after another, each near the one before, as the nodes of a layer
/// do. The index is asked for more points than wanted, around a place; as long as a step does not lead out of what they
/// cover, the answer is among them. It is the same that the index would give.
///
/// A walk refers to the index and its points. It has a state, so threads need one each.
template <PointIndex_3 PointIndex>
class Neighbour_walk {
 public:
  using Point = std::array<double, 3>;

  Neighbour_walk(const PointIndex& index, const std::vector<Point>& points, std::size_t k)
      : index_(&index), points_(&points), k_(std::min(k, points.size())) {}

  /// The `k` nearest, nearest first, of equally near ones the lower number first; valid until the next call.
  /// O(k) while the steps are short, else a query of the index.
  std::span<const Neighbour> operator()(const Point& place) {
    if (known_.empty() || !is_among_known(place)) {
      ask(place);
      select(place, 0);
    }
    return nearest_;
  }

 private:
  static constexpr std::size_t surplus = 5;

  struct Known {
    Point point;
    std::size_t number;
    double from_centre;
  };

  // Selects from the known points; whether these are certainly the nearest of all.
  bool is_among_known(const Point& place) {
    const double step = std::sqrt(internal::squared_distance(place, centre_));
    select(place, step);
    const double farthest = std::sqrt(nearest_.back().squared_distance);
    return (farthest + step) * (1 + 1e-12) < radius_;
  }

  // `step` is the way from the centre. Known points are in the order of their distance from there.
  void select(const Point& place, double step) {
    nearest_.clear();
    for (const Known& known : known_) {
      const double least = known.from_centre * (1 - 1e-12) - step;
      if (nearest_.size() == k_ && least > 0 && least * least > nearest_.back().squared_distance) return;
      const Neighbour n{internal::squared_distance(known.point, place), known.number};
      if (nearest_.size() == k_) {
        if (!(n < nearest_.back())) continue;
        nearest_.pop_back();
      }
      auto place_of_n = nearest_.insert(nearest_.end(), n);
      for (; place_of_n != nearest_.begin() && n < *std::prev(place_of_n); --place_of_n) {
        *place_of_n = *std::prev(place_of_n);
      }
      *place_of_n = n;
    }
  }

  void ask(const Point& place) {
    const std::vector<std::size_t> found = index_->nearest(place, surplus * k_);
    known_.clear();
    for (std::size_t i : found) {
      known_.push_back({(*points_)[i], i, std::sqrt(internal::squared_distance((*points_)[i], place))});
    }
    centre_ = place;
    radius_ = found.size() == points_->size() ? std::numeric_limits<double>::infinity()
                                              : known_.back().from_centre;
  }

  const PointIndex* index_;
  const std::vector<Point>* points_;
  std::size_t k_;
  Point centre_{};
  double radius_ = 0;  // all points nearer to the centre than this are known
  std::vector<Known> known_;
  std::vector<Neighbour> nearest_;
};

}  // namespace CCSweep

#endif
