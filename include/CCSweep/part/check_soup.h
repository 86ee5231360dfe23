// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_CHECK_SOUP_H
#define CCSWEEP_PART_CHECK_SOUP_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Polygon_soup.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace CCSweep {
namespace internal {

class Soup_checker {
 public:
  explicit Soup_checker(const Polygon_soup& soup) : soup_(soup) {}

  void check() {
    if (soup_.number_of_polygons() == 0) fail(Status_code::empty_mesh, Stage::input, "there are no facets");
    check_coordinates();
    check_facets();
    sort_half_edges();
    check_edges();
    check_vertices();
  }

 private:
  using Vertex = Polygon_soup::Vertex;

  // The edge from corner `corner` to the next one of polygon `facet`. Sorting brings those between the same two
  // vertices together.
  struct Half_edge {
    Vertex low, high;
    bool forward;
    std::size_t corner, facet;

    bool same_edge(const Half_edge& other) const { return low == other.low && high == other.high; }
    bool operator<(const Half_edge& other) const {
      return std::tie(low, high, corner) < std::tie(other.low, other.high, other.corner);
    }
  };

  void check_coordinates() const {
    for (std::size_t v = 0; v < soup_.points.size(); ++v)
      for (double coordinate : soup_.points[v])
        if (!std::isfinite(coordinate))
          fail(Status_code::non_finite_coordinate, Stage::input,
               "vertex " + std::to_string(v) + " (counted from 0) has a coordinate that is no finite number");
  }

  void check_facets() const {
    for (std::size_t f = 0; f < soup_.number_of_polygons(); ++f) {
      const auto polygon = soup_.polygon(f);
      if (polygon.size() < 3)
        refuse(Status_code::degenerate_facet, {f}, "has fewer than three corners", place_of(polygon));
      std::vector<Vertex> sorted(polygon.begin(), polygon.end());
      std::sort(sorted.begin(), sorted.end());
      if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        refuse(Status_code::degenerate_facet, {f}, "has the same vertex at two corners", place_of(polygon));
      if (is_flat(polygon))
        refuse(Status_code::degenerate_facet, {f}, "has no area: its corners lie on one line", place_of(polygon));
    }
  }

  bool is_flat(std::span<const Vertex> polygon) const {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    const auto point = [&](std::size_t i) {
      const auto& p = soup_.points[polygon[i]];
      return Point(p[0], p[1], p[2]);
    };
    std::size_t second = 1;
    while (second < polygon.size() && point(second) == point(0)) ++second;
    for (std::size_t third = second + 1; third < polygon.size(); ++third)
      if (!CGAL::collinear(point(0), point(second), point(third))) return false;
    return true;
  }

  void sort_half_edges() {
    half_edges_.reserve(soup_.corners.size());
    for (std::size_t f = 0; f < soup_.number_of_polygons(); ++f) {
      for (std::size_t c = soup_.offsets[f]; c < soup_.offsets[f + 1]; ++c) {
        const std::size_t next = c + 1 == soup_.offsets[f + 1] ? soup_.offsets[f] : c + 1;
        const Vertex a = soup_.corners[c], b = soup_.corners[next];
        half_edges_.push_back({std::min(a, b), std::max(a, b), a < b, c, f});
      }
    }
    std::sort(half_edges_.begin(), half_edges_.end());
  }

  // Too many facets first, then disagreeing ones, then missing ones: a facet that is there twice or turned around also
  // leaves borders, and the border is not what its author must mend.
  void check_edges() {
    opposite_.assign(soup_.corners.size(), 0);
    const Half_edge* turned = nullptr;
    const Half_edge* border = nullptr;
    for (std::size_t i = 0, end = 0; i < half_edges_.size(); i = end) {
      for (end = i + 1; end < half_edges_.size() && half_edges_[end].same_edge(half_edges_[i]);) ++end;
      const Half_edge* edge = &half_edges_[i];
      if (end - i > 2) refuse_crowded_edge(i, end);
      if (end - i == 1) {
        if (!border) border = edge;
      } else if (edge[0].forward == edge[1].forward) {
        if (!turned) turned = edge;
      } else {
        opposite_[edge[0].corner] = edge[1].corner;
        opposite_[edge[1].corner] = edge[0].corner;
      }
    }
    if (turned)
      refuse(Status_code::not_oriented, {turned[0].facet, turned[1].facet},
             "disagree about which side is outside: they run along their common edge in the same direction",
             middle(*turned));
    if (border)
      refuse(Status_code::not_closed, {border->facet}, "has an edge without a neighbour: the surface is open",
             middle(*border));
  }

  [[noreturn]] void refuse_crowded_edge(std::size_t begin, std::size_t end) const {
    const Half_edge& edge = half_edges_[begin];
    for (std::size_t i = begin + 1; i < end; ++i)
      if (same_corners(edge.facet, half_edges_[i].facet))
        refuse(Status_code::not_manifold, {edge.facet, half_edges_[i].facet}, "have the same corners", middle(edge));
    refuse(Status_code::not_manifold, {edge.facet, half_edges_[begin + 1].facet, half_edges_[begin + 2].facet},
           "share one edge, which has " + std::to_string(end - begin) + " facets", middle(edge));
  }

  bool same_corners(std::size_t f, std::size_t g) const {
    const auto a = soup_.polygon(f), b = soup_.polygon(g);
    return a.size() == b.size() && std::is_permutation(a.begin(), a.end(), b.begin());
  }

  // All corners at a vertex must be met on one walk around it.
  void check_vertices() const {
    std::vector<char> seen(soup_.corners.size(), 0), has_fan(soup_.points.size(), 0);
    std::vector<std::size_t> previous(soup_.corners.size()), facet(soup_.corners.size());
    for (const Half_edge& edge : half_edges_) {
      const std::size_t f = edge.facet;
      facet[edge.corner] = f;
      previous[edge.corner] = edge.corner == soup_.offsets[f] ? soup_.offsets[f + 1] - 1 : edge.corner - 1;
    }
    for (std::size_t start = 0; start < soup_.corners.size(); ++start) {
      if (seen[start]) continue;
      const Vertex v = soup_.corners[start];
      if (has_fan[v])
        refuse(Status_code::not_manifold, {facet[start]},
               "meets other facets in vertex " + std::to_string(v) +
                   " without a common edge; surfaces that touch in a point need a vertex each",
               soup_.points[v]);
      has_fan[v] = 1;
      for (std::size_t c = start; !seen[c]; c = opposite_[previous[c]]) seen[c] = 1;
    }
  }

  std::array<double, 3> middle(const Half_edge& edge) const {
    const std::array<Vertex, 2> ends = {edge.low, edge.high};
    return *place_of(ends);
  }

  std::optional<std::array<double, 3>> place_of(std::span<const Vertex> vertices) const {
    if (vertices.empty()) return std::nullopt;
    std::array<double, 3> place{};
    for (Vertex v : vertices)
      for (std::size_t i = 0; i < 3; ++i) place[i] += soup_.points[v][i] / static_cast<double>(vertices.size());
    return place;
  }

  [[noreturn]] void refuse(Status_code code, std::initializer_list<std::size_t> facets, const std::string& what,
                           std::optional<std::array<double, 3>> place) const {
    std::string reason = facets.size() > 1 ? "facets" : "facet";
    std::vector<int> patches;
    for (const std::size_t* f = facets.begin(); f != facets.end(); ++f) {
      const bool last = f + 1 == facets.end();
      reason += (f == facets.begin() ? " " : last ? " and " : ", ") + std::to_string(*f);
      if (soup_.has_patch_ids()) patches.push_back(soup_.patch_ids[*f]);
    }
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    fail(code, Stage::input, reason + " (counted from 0) " + what, std::move(patches), place);
  }

  const Polygon_soup& soup_;
  std::vector<Half_edge> half_edges_;
  std::vector<std::size_t> opposite_;  // the corner at which the half-edge opposite to that of a corner starts
};

}  // namespace internal

/// Tells whether polygons make up a closed, oriented, 2-manifold surface, so that a halfedge data structure can hold
/// them. Every corner must be the index of a point; points that no polygon uses are passed over, and two points may
/// have the same coordinates (surfaces that touch).
///
/// Returns `ok`, or the first defect with its place and facets (and their patches, if known) out of: `empty_mesh`,
/// `non_finite_coordinate`, `degenerate_facet` (fewer than three different corners, or all on one line: exact),
/// `not_manifold` (an edge with more than two facets, a vertex with several fans), `not_oriented` (neighbours
/// disagree), `not_closed`. What needs geometry (inside out, self-intersection) is left to `check_input()`.
inline Status check_soup(const Polygon_soup& soup) {
  return internal::guarded([&] {
           internal::Soup_checker(soup).check();
           return true;
         })
      .status();
}

}  // namespace CCSweep

#endif
