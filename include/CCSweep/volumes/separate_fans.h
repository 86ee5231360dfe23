// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_SEPARATE_FANS_H
#define CCSWEEP_VOLUMES_SEPARATE_FANS_H

#include <CCSweep/internal/Union_find.h>
#include <CCSweep/internal/bucket_sort.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/volumes/triangulate_plane.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Makes the closed boundary of a solid 2-manifold: where it touches itself in a vertex or along an edge, each sheet
/// gets a vertex of its own.
class Fan_separator {
 public:
  /// For each triangle the number of its fan at each corner; fans are numbered by vertex. Nothing where the triangles
  /// are not closed. `point` gives a vertex's coordinates. Complexity: O(n log n).
  static std::optional<std::vector<std::array<std::size_t, 3>>> run(
      const std::vector<Triangle>& triangles, const std::function<Vec3(std::uint32_t)>& point) {
    Fan_separator separator(triangles, point);
    if (!separator.pair_edges()) return std::nullopt;
    return separator.numbered_fans();
  }

 private:
  // Edge k of a triangle runs from corner k to the next.
  struct Side {
    std::uint32_t low, high;
    std::uint32_t number;  // 3 t + k for edge k of triangle t
    bool ascending;
  };

  Fan_separator(const std::vector<Triangle>& triangles, const std::function<Vec3(std::uint32_t)>& point)
      : triangles_(triangles), point_(point), fans_(3 * triangles.size()) {}

  bool pair_edges() {
    std::vector<Side> sides;
    sides.reserve(3 * triangles_.size());
    std::size_t vertices = 0;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const auto a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        sides.push_back({std::min(a, b), std::max(a, b), 3 * t + k, a < b});
        vertices = std::max<std::size_t>(vertices, a + 1);
      }
    bucket_sort(
        sides, vertices, [](const Side& s) { return s.low; },
        [](const Side& s, const Side& t) { return std::pair(s.high, s.number) < std::pair(t.high, t.number); });
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t j = i;
      while (j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high) ++j;
      if (!pair_sides(std::span(sides).subspan(i, j - i))) return false;
      i = j;
    }
    return true;
  }

  // Around an edge every sheet pairs with the next one on its material's side, so that wedges of material part.
  bool pair_sides(std::span<Side> around) {
    if (around.size() % 2 != 0) return false;
    if (around.size() > 2) sort_by_angle(around);
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (!around[i].ascending) continue;
      const Side& partner = around[(i + around.size() - 1) % around.size()];
      if (partner.ascending) return false;
      join_corners(around[i], partner);
    }
    return std::count_if(around.begin(), around.end(), [](const Side& s) { return s.ascending; }) * 2 ==
           std::ptrdiff_t(around.size());
  }

  void sort_by_angle(std::span<Side> around) const {
    const Vec3 origin = point_(around[0].low), axis = unit(point_(around[0].high) - origin);
    auto apex = [&](const Side& s) {
      const Vec3 w = point_(triangles_[s.number / 3][(s.number + 2) % 3]) - origin;
      return w - dot(w, axis) * axis;
    };
    const Vec3 x = unit(apex(around[0])), y = cross(axis, x);
    std::stable_sort(around.begin(), around.end(), [&](const Side& s, const Side& t) {
      const Vec3 a = apex(s), b = apex(t);
      return std::atan2(dot(a, y), dot(a, x)) < std::atan2(dot(b, y), dot(b, x));
    });
  }

  void join_corners(const Side& s, const Side& t) {
    fans_.join(s.number, end(t));
    fans_.join(end(s), t.number);
  }

  // The corner that a side runs to.
  static std::uint32_t end(const Side& s) { return s.number - s.number % 3 + (s.number + 1) % 3; }

  std::vector<std::array<std::size_t, 3>> numbered_fans() {
    std::vector<std::size_t> roots;
    const std::size_t corners = 3 * triangles_.size();
    for (std::size_t c = 0; c < corners; ++c)
      if (fans_.root(c) == c) roots.push_back(c);
    std::stable_sort(roots.begin(), roots.end(), [&](std::size_t c, std::size_t d) {
      return triangles_[c / 3][c % 3] < triangles_[d / 3][d % 3];
    });
    std::vector<std::size_t> number(corners);
    for (std::size_t i = 0; i < roots.size(); ++i) number[roots[i]] = i;
    std::vector<std::array<std::size_t, 3>> fans(triangles_.size());
    for (std::size_t c = 0; c < corners; ++c) fans[c / 3][c % 3] = number[fans_.root(c)];
    return fans;
  }

  const std::vector<Triangle>& triangles_;
  const std::function<Vec3(std::uint32_t)>& point_;
  Union_find fans_;  // of corners: three to a triangle
};

}  // namespace CCSweep::internal

#endif
