// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_NODES_H
#define CCSWEEP_LOOPS_OVERLAY_NODES_H

#include <CCSweep/indices.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/Layer_drawing.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CCSweep::internal {

using Place_2 = std::array<double, 2>;

// The nodes of a layer while it is being imprinted: first those of the drawing, then the new ones.
template <class Traits>
struct Layer_nodes {
  using Point_2 = typename Traits::Point_2;

  std::vector<Point_2> points;
  std::vector<bool> fixed, corner;
  std::vector<Node_index> representative;  // of the drawing's nodes; never a chain of two steps
  std::vector<double> reaches;             // of the drawing's nodes; empty if all are 0
  std::vector<std::string> notes;

  const Point_2& point(Node_index n) const { return points[n.value()]; }
  Place_2 place(Node_index n) const { return {CGAL::to_double(point(n).x()), CGAL::to_double(point(n).y())}; }
  // How far a node snaps to what is fixed, if that is more than the tolerance.
  double reach(Node_index n) const { return reaches.empty() ? 0 : reaches[n.value()]; }
  double reach(Node_index a, Node_index b) const { return std::max(reach(a), reach(b)); }
  CGAL::Bbox_2 box(Node_index n) const {
    const auto [xmin, xmax] = CGAL::to_interval(point(n).x());
    const auto [ymin, ymax] = CGAL::to_interval(point(n).y());
    return {xmin, ymin, xmax, ymax};
  }
  CGAL::Bbox_2 box(Node_index a, Node_index b) const { return box(a) + box(b); }

  Node_index add(const Point_2& point, bool is_fixed) {
    points.push_back(point);
    fixed.push_back(is_fixed);
    corner.push_back(false);
    return Node_index(points.size() - 1);
  }
};

template <class Traits>
[[noreturn]] void fail_imprint(const Layer_nodes<Traits>& nodes, Node_index where, std::string reason,
                               std::vector<int> patches = {}) {
  const Place_2 place = nodes.place(where);
  fail(Status_code::imprint_failed, Stage::imprint, std::move(reason), std::move(patches),
       std::array<double, 3>{place[0], place[1], 0});
}

inline double distance(Place_2 a, Place_2 b) {
  const double x = a[0] - b[0], y = a[1] - b[1];
  return std::sqrt(x * x + y * y);
}

inline CGAL::Bbox_2 inflated(const CGAL::Bbox_2& box, double by) {
  return {box.xmin() - by, box.ymin() - by, box.xmax() + by, box.ymax() + by};
}

// The point of a segment that is closest to p: its parameter in [0, 1] and its distance.
struct Closest {
  double parameter = 0;
  double distance = std::numeric_limits<double>::infinity();
};

inline Closest closest(Place_2 p, Place_2 a, Place_2 b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], length = dx * dx + dy * dy;
  double t = length > 0 ? ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length : 0;
  t = std::min(1., std::max(0., t));
  return {t, distance(p, {a[0] + t * dx, a[1] + t * dy})};
}

// Positive if p is left of the line ab and farther from it than `reach`, negative if so on the right, else 0. What
// rounding does to the coordinates must be within the reach.
inline double clear_side(Place_2 a, Place_2 b, Place_2 p, double reach) {
  const double x = b[0] - a[0], y = b[1] - a[1];
  const double side = x * (p[1] - a[1]) - y * (p[0] - a[0]);
  return side * side > reach * reach * (x * x + y * y) ? side : 0;
}

// Whether p is certainly within `reach` of the segment ab, up to what rounding does to the coordinates.
inline bool is_on(Place_2 p, Place_2 a, Place_2 b, double reach) {
  const double half = reach / 2;
  const auto is_between = [half](double x, double u, double v) {
    return std::min(u, v) - half <= x && x <= std::max(u, v) + half;
  };
  return is_between(p[0], a[0], b[0]) && is_between(p[1], a[1], b[1]) && clear_side(a, b, p, half) == 0;
}

inline bool are_within(Place_2 a, Place_2 b, double reach) {
  const double x = a[0] - b[0], y = a[1] - b[1];
  return x * x + y * y <= reach * reach;
}

// Coordinates as they are, so that arithmetic with them errs by a few units in the last place only.
template <class Traits>
inline constexpr bool has_plain_coordinates = std::is_floating_point_v<typename Traits::FT>;

}  // namespace CCSweep::internal

#endif
