// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_SELF_CONTACT_H
#define CCSWEEP_PART_SELF_CONTACT_H

#include <CCSweep/part/Surface_charts.h>
#include <CCSweep/part/Triangle_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

// Decides whether two triangles meet elsewhere than in corners and edges that have the same coordinates in both. All
// predicates are the kernel's own.
template <class Kernel>
class Forbidden_contact {
 public:
  using Point = typename Kernel::Point_3;
  using Corners = std::array<Point, 3>;

  bool operator()(const Corners& s, const Corners& t) const {
    std::array<std::size_t, 3> in_s{}, in_t{};  // common corners first
    std::size_t common = 0;
    std::array<bool, 3> used{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (!used[j] && s[i] == t[j]) {
          in_s[common] = i;
          in_t[common++] = j;
          used[j] = true;
          break;
        }
    switch (common) {
      case 0:
        return intersect(triangle(s), triangle(t));
      case 1:
        return beyond_corner(s, in_s[0], t, in_t[0]);
      case 2:
        return beyond_edge(s, in_s, t, in_t);
      default:
        return true;
    }
  }

 private:
  template <class A, class B>
  bool intersect(const A& a, const B& b) const {
    return kernel_.do_intersect_3_object()(a, b);
  }

  typename Kernel::Triangle_3 triangle(const Corners& t) const {
    return kernel_.construct_triangle_3_object()(t[0], t[1], t[2]);
  }

  typename Kernel::Segment_3 opposite_edge(const Corners& t, std::size_t corner) const {
    return kernel_.construct_segment_3_object()(t[(corner + 1) % 3], t[(corner + 2) % 3]);
  }

  // Two triangles that meet in more than their common corner also meet in the edge opposite to it of one of them.
  bool beyond_corner(const Corners& s, std::size_t i, const Corners& t, std::size_t j) const {
    if (on_one_side(s, t[(j + 1) % 3], t[(j + 2) % 3]) || on_one_side(t, s[(i + 1) % 3], s[(i + 2) % 3])) return false;
    return intersect(triangle(s), opposite_edge(t, j)) || intersect(triangle(t), opposite_edge(s, i));
  }

  bool on_one_side(const Corners& t, const Point& a, const Point& b) const {
    const CGAL::Orientation side = orientation(t[0], t[1], t[2], a);
    return side != CGAL::COPLANAR && side == orientation(t[0], t[1], t[2], b);
  }

  // Two triangles on a common edge meet in more than it only when they lie in one plane on the same side of it.
  bool beyond_edge(const Corners& s, const std::array<std::size_t, 3>& in_s, const Corners& t,
                   const std::array<std::size_t, 3>& in_t) const {
    const Point &p = s[in_s[0]], &q = s[in_s[1]], &r = s[3 - in_s[0] - in_s[1]], &u = t[3 - in_t[0] - in_t[1]];
    if (orientation(p, q, r, u) != CGAL::COPLANAR) return false;
    return kernel_.coplanar_orientation_3_object()(p, q, r, u) == CGAL::POSITIVE;
  }

  CGAL::Orientation orientation(const Point& p, const Point& q, const Point& r, const Point& s) const {
    return kernel_.orientation_3_object()(p, q, r, s);
  }

  Kernel kernel_;
};

// The first pair of triangles with a forbidden contact, by their numbers. On a surface that is nothing but such pairs
// the search stops early, with one of them.
template <class Kernel>
std::optional<std::pair<std::uint32_t, std::uint32_t>> find_self_contact(const Triangle_surface<Kernel>& surface) {
  constexpr std::size_t limit = 10000;
  std::vector<CGAL::Bbox_3> boxes;
  boxes.reserve(surface.triangles.size());
  for (const auto& [p, q, r] : surface.triangles) boxes.push_back(p.bbox() + q.bbox() + r.bbox());

  const Forbidden_contact<Kernel> is_forbidden;
  std::optional<std::pair<std::uint32_t, std::uint32_t>> first;
  std::size_t found = 0;
  const auto look_at = [&](std::uint32_t s, std::uint32_t t) {
    if (!is_forbidden(surface.triangles[s], surface.triangles[t])) return true;
    const std::pair<std::uint32_t, std::uint32_t> pair = std::minmax(s, t);
    if (!first || pair < *first) first = pair;
    return ++found < limit;
  };
  Triangle_tree(boxes, Surface_charts<Kernel>::of(surface)).for_each_pair(look_at);
  return first;
}

}  // namespace internal
}  // namespace CCSweep

#endif
