// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_OUTLINE_FAULTS_H
#define CCSWEEP_HEX_OUTLINE_FAULTS_H

#include <CCSweep/hex/quad_quality.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace CCSweep::internal {

/// An edge of an outline that is drawn anew, coarser than it was, and the arc it belongs to.
struct Outline_edge {
  Point2 a, b;
  std::size_t arc;
};

/// Calls `f` with the numbers of two edges, in either order, for all that come as near to each other as `reach` times
/// the length of the longer one, and some others. Complexity: O(n log n), where few are so near.
template <class Function>
void for_each_near_pair(const std::vector<Outline_edge>& edges, double reach, const Function& f) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [a, b, arc] = edges[i];
    const double by = reach * length_between(a, b);
    boxes.emplace_back(CGAL::Bbox_2(std::min(a[0], b[0]) - by, std::min(a[1], b[1]) - by, std::max(a[0], b[0]) + by,
                                    std::max(a[1], b[1]) + by),
                       i);
  }
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
                                [&](const Box& s, const Box& t) { f(s.info(), t.info()); });
}

/// The arcs that were drawn so coarsely that the outline crosses itself, or folds back where two of its edges meet: of
/// each two edges concerned the arc of the longer one.
inline std::set<std::size_t> arcs_too_coarse(const std::vector<Outline_edge>& edges) {
  constexpr double flat = 0.02;  // sine of the angle at which edges count as folded
  const auto meet = [](const Outline_edge& e, const Outline_edge& f) {
    if (e.a == f.b || e.b == f.a) {
      const Point2 &here = e.a == f.b ? e.a : e.b, &there = e.a == f.b ? e.b : e.a, &other = e.a == f.b ? f.a : f.b;
      const double x = there[0] - here[0], y = there[1] - here[1], u = other[0] - here[0], v = other[1] - here[1];
      return x * u + y * v > 0 && std::abs(x * v - y * u) < flat * std::hypot(x, y) * std::hypot(u, v);
    }
    if (e.a == f.a || e.b == f.b) return false;
    return (turn(e.a, e.b, f.a) > 0) != (turn(e.a, e.b, f.b) > 0) &&
           (turn(f.a, f.b, e.a) > 0) != (turn(f.a, f.b, e.b) > 0);
  };
  std::set<std::size_t> arcs;
  for_each_near_pair(edges, 0, [&](std::size_t i, std::size_t j) {
    const Outline_edge &e = edges[std::max(i, j)], &f = edges[std::min(i, j)];
    if (e.arc != f.arc && meet(e, f)) arcs.insert(length_between(e.a, e.b) > length_between(f.a, f.b) ? e.arc : f.arc);
  });
  return arcs;
}

/// The arcs whose edges are long beside the gap to another part of the outline: no quad of good shape fits in there.
inline std::set<std::size_t> arcs_at_gaps(const std::vector<Outline_edge>& edges) {
  constexpr double narrow = 0.4;
  const auto distance = [](const Point2& p, const Outline_edge& e) {
    const Point2 w{e.b[0] - e.a[0], e.b[1] - e.a[1]};
    const double along = ((p[0] - e.a[0]) * w[0] + (p[1] - e.a[1]) * w[1]) / std::max(squared_length(e.a, e.b), 1e-300);
    const double t = std::clamp(along, 0.0, 1.0);
    return length_between(p, {e.a[0] + t * w[0], e.a[1] + t * w[1]});
  };
  std::set<std::size_t> arcs;
  for_each_near_pair(edges, narrow, [&](std::size_t i, std::size_t j) {
    const Outline_edge &e = edges[i], &f = edges[j];
    if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return;
    const double gap = std::min({distance(e.a, f), distance(e.b, f), distance(f.a, e), distance(f.b, e)});
    for (const Outline_edge* edge : {&e, &f})
      if (gap < narrow * length_between(edge->a, edge->b)) arcs.insert(edge->arc);
  });
  return arcs;
}

}  // namespace CCSweep::internal

#endif
