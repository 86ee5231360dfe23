// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_CROSSING_H
#define CCSWEEP_LOOPS_OVERLAY_CROSSING_H

#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/overlay_table.h>
#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/enum.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <type_traits>

namespace CCSweep::internal {

template <class Traits>
CGAL::Orientation turn(const typename Traits::Point_2& a, const typename Traits::Point_2& b,
                       const typename Traits::Point_2& c) {
  return Traits().orientation_2_object()(a, b, c);
}

template <class Traits>
bool is_less_xy(const typename Traits::Point_2& a, const typename Traits::Point_2& b) {
  return Traits().compare_xy_2_object()(a, b) == CGAL::SMALLER;
}

template <class Traits>
bool is_equal(const typename Traits::Point_2& a, const typename Traits::Point_2& b) {
  return Traits().compare_xy_2_object()(a, b) == CGAL::EQUAL;
}

// Whether p lies on the segment ab and is neither a nor b.
template <class Traits>
bool is_inside(const typename Traits::Point_2& a, const typename Traits::Point_2& b,
               const typename Traits::Point_2& p) {
  const bool ascending = is_less_xy<Traits>(a, b);
  return is_less_xy<Traits>(ascending ? a : b, p) && is_less_xy<Traits>(p, ascending ? b : a) &&
         turn<Traits>(a, b, p) == CGAL::COLLINEAR;
}

// Compares two points by their order along a segment, on the axis that the segment is longer in. Exact for points
// on the segment, and monotone for rounded ones.
template <class Traits>
class Along {
 public:
  using Point_2 = typename Traits::Point_2;

  Along(const Point_2& a, const Point_2& b) {
    const double dx = CGAL::to_double(b.x()) - CGAL::to_double(a.x());
    const double dy = CGAL::to_double(b.y()) - CGAL::to_double(a.y());
    by_x_ = std::fabs(dx) >= std::fabs(dy);
    sign_x_ = CGAL::compare(b.x(), a.x());
    sign_y_ = CGAL::compare(b.y(), a.y());
  }

  CGAL::Comparison_result operator()(const Point_2& p, const Point_2& q) const {
    const CGAL::Comparison_result first = by_x_ ? x(p, q) : y(p, q);
    return first != CGAL::EQUAL ? first : (by_x_ ? y(p, q) : x(p, q));
  }

 private:
  CGAL::Comparison_result x(const Point_2& p, const Point_2& q) const { return sign_x_ * CGAL::compare(p.x(), q.x()); }
  CGAL::Comparison_result y(const Point_2& p, const Point_2& q) const { return sign_y_ * CGAL::compare(p.y(), q.y()); }

  bool by_x_;
  CGAL::Sign sign_x_, sign_y_;
};

struct Crossing {
  Node_index node;
  bool exact;  // the node lies exactly on both segments
};

template <class FT>
inline constexpr bool has_exact_constructions =
    std::is_same_v<typename CGAL::Algebraic_structure_traits<FT>::Is_exact, CGAL::Tag_true>;

// Makes the nodes at crossings, and hands out an existing one where the place is taken already.
template <class Traits>
class Crossing_pool {
 public:
  using Point_2 = typename Traits::Point_2;
  using FT = typename Traits::FT;

  Crossing_pool(Layer_nodes<Traits>& nodes, double tolerance, double rounding)
      : nodes_(nodes), tolerance_(tolerance), rounding_(exact_constructions ? 0 : rounding) {
    cell_ = 4 * std::fmax(tolerance_, rounding_);
    first_new_ = nodes.points.size();
  }

  // Lets crossings find a node that is there already.
  void remember(Node_index n) {
    if constexpr (exact_constructions) known_.try_emplace(nodes_.point(n), n);
    if (cell_ > 0) {
      const Place_2 p = nodes_.place(n);
      grid_.insert(cell(std::floor(p[0] / cell_), std::floor(p[1] / cell_)), static_cast<std::uint32_t>(n.value()));
    }
  }

  // The node where the segments p[0] p[1] and p[2] p[3] cross, where p are the points of `ends`. Where `tolerant`, a
  // crossing made before is taken if it is within the tolerance.
  Crossing crossing(const std::array<Node_index, 4>& ends, bool fixed, bool tolerant) {
    const Point_2 point =
        constructed({nodes_.point(ends[0]), nodes_.point(ends[1]), nodes_.point(ends[2]), nodes_.point(ends[3])});
    if constexpr (exact_constructions) {
      if (const auto same = known_.find(point); same != known_.end()) return {same->second, true};
    }
    if (const std::optional<Node_index> near = nearest(point, tolerant, ends)) return {*near, false};
    const Node_index result = nodes_.add(point, fixed);
    remember(result);
    return {result, exact_constructions};
  }

  // The same where no other node is within the tolerance than those at the ends of the two.
  Crossing lonely_crossing(const std::array<Node_index, 4>& ends, bool fixed) {
    const Point_2 point =
        constructed({nodes_.point(ends[0]), nodes_.point(ends[1]), nodes_.point(ends[2]), nodes_.point(ends[3])});
    if constexpr (!exact_constructions) {
      const Place_2 place{CGAL::to_double(point.x()), CGAL::to_double(point.y())};
      for (Node_index n : ends) {
        if (are_within(place, nodes_.place(n), rounding_)) return {n, false};
      }
    }
    return {nodes_.add(point, fixed), exact_constructions};
  }

 private:
  static constexpr bool exact_constructions = has_exact_constructions<FT>;
  struct Less {
    bool operator()(const Point_2& a, const Point_2& b) const { return is_less_xy<Traits>(a, b); }
  };

  template <class Number, class Point>
  static std::array<Number, 2> solved(const Point& a, const Point& b, const Point& c, const Point& d) {
    // The type is named, as an expression of rationals would outlive its parts.
    const auto area = [&](const Point& p) -> Number {
      return (d[0] - c[0]) * (p[1] - c[1]) - (d[1] - c[1]) * (p[0] - c[0]);
    };
    const Number first = area(a), s = first / (first - area(b));
    return {a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])};
  }

  template <class Number>
  static std::array<Number, 2> solved_as(const std::array<Point_2, 4>& p) {
    const auto coordinates = [](const Point_2& q) { return std::array<Number, 2>{Number(q.x()), Number(q.y())}; };
    return solved<Number>(coordinates(p[0]), coordinates(p[1]), coordinates(p[2]), coordinates(p[3]));
  }

  Point_2 constructed(const std::array<Point_2, 4>& p) const {
    const std::array<FT, 2> result = solved_as<FT>(p);
    if constexpr (!exact_constructions) {
      // Where the segments are nearly parallel, rounding may take the crossing anywhere along them.
      const auto place = [](const auto& q) { return Place_2{CGAL::to_double(q.x()), CGAL::to_double(q.y())}; };
      const Place_2 found{CGAL::to_double(result[0]), CGAL::to_double(result[1])};
      if (!is_on(found, place(p[0]), place(p[1]), rounding_) || !is_on(found, place(p[2]), place(p[3]), rounding_)) {
        const auto exact = solved_as<CGAL::Exact_rational>(p);
        return Point_2(FT(CGAL::to_double(exact[0])), FT(CGAL::to_double(exact[1])));
      }
    }
    return Point_2(result[0], result[1]);
  }

  static std::uint64_t cell(double i, double j) { return mixed(i, j); }

  // The nearest node within rounding, or within the tolerance for crossings made before and where `tolerant`.
  std::optional<Node_index> nearest(const Point_2& point, bool tolerant, const std::array<Node_index, 4>& ends) const {
    std::optional<Node_index> best;
    if (cell_ == 0) return best;
    const Place_2 place{CGAL::to_double(point.x()), CGAL::to_double(point.y())};
    const double reach = std::fmax(tolerant ? tolerance_ : 0, rounding_);
    double smallest = std::numeric_limits<double>::infinity();
    const auto offer = [&](std::uint32_t number) {
      const Node_index n(number);
      const double d = distance(place, nodes_.place(n));
      if (d > reach || d > smallest || (d == smallest && *best < n)) return;
      if (d > rounding_ && (n.value() < first_new_ || !between(n, ends))) return;
      best = n;
      smallest = d;
    };
    const double last_i = std::floor((place[0] + reach) / cell_), last_j = std::floor((place[1] + reach) / cell_);
    for (double i = std::floor((place[0] - reach) / cell_); i <= last_i; ++i) {
      for (double j = std::floor((place[1] - reach) / cell_); j <= last_j; ++j) grid_.for_each(cell(i, j), offer);
    }
    return best;
  }

  // Whether bending both segments through the node keeps them running forward.
  bool between(Node_index n, const std::array<Node_index, 4>& ends) const {
    const Place_2 p = nodes_.place(n);
    const double s = closest(p, nodes_.place(ends[0]), nodes_.place(ends[1])).parameter;
    const double t = closest(p, nodes_.place(ends[2]), nodes_.place(ends[3])).parameter;
    return 0 < s && s < 1 && 0 < t && t < 1;
  }

  Layer_nodes<Traits>& nodes_;
  double tolerance_, rounding_, cell_;
  std::size_t first_new_;
  std::map<Point_2, Node_index, Less> known_;  // with exact constructions
  Number_table grid_;
};

}  // namespace CCSweep::internal

#endif
