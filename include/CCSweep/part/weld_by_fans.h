// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_WELD_BY_FANS_H
#define CCSWEEP_PART_WELD_BY_FANS_H

#include <CCSweep/part/Polygon_soup.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

class Fan_welder {
 public:
  explicit Fan_welder(Polygon_soup soup) : soup_(std::move(soup)) {}

  Polygon_soup weld() {
    unite_equal_points();
    if (pair_half_edges()) separate_fans();
    return std::move(soup_);
  }

 private:
  using Vertex = Polygon_soup::Vertex;
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

  // The edge from corner `corner` to the next corner of its triangle.
  struct Half_edge {
    Vertex low, high;
    std::size_t corner;
    bool forward;

    bool operator<(const Half_edge& other) const {
      return std::tie(low, high, corner) < std::tie(other.low, other.high, other.corner);
    }
  };

  static std::size_t next(std::size_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

  Point point(Vertex v) const { return {soup_.points[v][0], soup_.points[v][1], soup_.points[v][2]}; }
  Point apex(const Half_edge& edge) const { return point(soup_.corners[next(next(edge.corner))]); }

  void unite_equal_points() {
    const auto& points = soup_.points;
    std::vector<Vertex> order(points.size());
    std::iota(order.begin(), order.end(), Vertex(0));
    // NaN has no place in an order; check_soup() refuses it, and what it is united with till then does not matter.
    const auto is_finite = [&](Vertex v) {
      return std::all_of(points[v].begin(), points[v].end(), [](double x) { return std::isfinite(x); });
    };
    const auto finite_end = std::stable_partition(order.begin(), order.end(), is_finite);
    std::stable_sort(order.begin(), finite_end, [&](Vertex a, Vertex b) { return points[a] < points[b]; });
    std::vector<Vertex> united(points.size());
    std::vector<std::array<double, 3>> different;
    for (auto it = order.begin(); it != order.end(); ++it) {
      if (different.empty() || it >= finite_end || different.back() != points[*it]) different.push_back(points[*it]);
      united[*it] = static_cast<Vertex>(different.size() - 1);
    }
    for (Vertex& v : soup_.corners) v = united[v];
    soup_.points = std::move(different);
  }

  // Finds the neighbour of every half-edge; false when one has none, or none for certain.
  bool pair_half_edges() {
    std::vector<Half_edge> edges;
    edges.reserve(soup_.corners.size());
    for (std::size_t c = 0; c < soup_.corners.size(); ++c) {
      const Vertex a = soup_.corners[c], b = soup_.corners[next(c)];
      if (a == b) return false;
      edges.push_back({std::min(a, b), std::max(a, b), c, a < b});
    }
    std::sort(edges.begin(), edges.end());
    opposite_.assign(soup_.corners.size(), 0);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
      for (end = i + 1; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high;)
        ++end;
      if (end - i > 2 && !sort_around_edge(&edges[i], &edges[0] + end)) return false;
      if (!pair_alternating(&edges[i], end - i)) return false;
    }
    return true;
  }

  // Sorts the facets at an edge counter-clockwise, seen against the direction from its lower to its higher vertex.
  // False when two of them cover each other.
  bool sort_around_edge(Half_edge* begin, Half_edge* end) const {
    const Point p = point(begin->low), q = point(begin->high), first = apex(*begin);
    const auto quarter = [&](const Point& r) {
      switch (CGAL::orientation(p, q, first, r)) {
        case CGAL::POSITIVE:
          return 1;
        case CGAL::NEGATIVE:
          return 3;
        default:
          return CGAL::coplanar_orientation(p, q, first, r) == CGAL::POSITIVE ? 0 : 2;
      }
    };
    const auto before = [&](const Half_edge& e, const Half_edge& f) {
      const Point r = apex(e), s = apex(f);
      const int a = quarter(r), b = quarter(s);
      return a != b ? a < b : a % 2 == 1 && CGAL::orientation(p, q, r, s) == CGAL::POSITIVE;
    };
    for (const Half_edge* e = begin; e != end; ++e)
      if (CGAL::collinear(p, q, apex(*e))) return false;
    std::sort(begin, end, before);
    return std::adjacent_find(begin, end, [&](const auto& e, const auto& f) { return !before(e, f); }) == end;
  }

  // A facet that runs along the edge forward has the material before it, one that runs backward after it. Those on
  // both sides of one wedge of material are neighbours.
  bool pair_alternating(const Half_edge* edges, std::size_t n) {
    if (n % 2 == 1) return false;
    for (std::size_t i = 0; i < n; ++i) {
      const Half_edge &e = edges[i], &f = edges[(i + 1) % n];
      if (e.forward == f.forward) return false;
      if (e.forward) continue;
      opposite_[e.corner] = f.corner;
      opposite_[f.corner] = e.corner;
    }
    return true;
  }

  // Every walk around a vertex from neighbour to neighbour gets a vertex of its own.
  void separate_fans() {
    constexpr Vertex none = std::numeric_limits<Vertex>::max();
    std::vector<Vertex> fan(soup_.corners.size(), none);
    std::vector<std::array<double, 3>> points;
    for (std::size_t start = 0; start < fan.size(); ++start) {
      if (fan[start] != none) continue;
      for (std::size_t c = start; fan[c] == none; c = opposite_[next(next(c))])
        fan[c] = static_cast<Vertex>(points.size());
      points.push_back(soup_.points[soup_.corners[start]]);
    }
    soup_.corners = std::move(fan);
    soup_.points = std::move(points);
  }

  Polygon_soup soup_;
  std::vector<std::size_t> opposite_;
};

}  // namespace internal

/// Unites the vertices of a triangle soup that have exactly the same coordinates, as far as that gives a manifold:
/// where surfaces touch in an edge or a vertex, each keeps vertices of its own. At an edge with four or more facets
/// those are neighbours that bound the same wedge of material.
///
/// Where that is not possible (open or overlapping facets, disagreeing orientations) all equal points are united, and
/// `check_soup()` names the defect.
inline Polygon_soup weld_by_fans(Polygon_soup triangles) { return internal::Fan_welder(std::move(triangles)).weld(); }

}  // namespace CCSweep

#endif
