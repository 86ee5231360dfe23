// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_PLANE_H
#define CCSWEEP_HEX_PLANE_H

#include <CCSweep/part/Part.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CCSweep::internal {

using Point2 = std::array<double, 2>;

/// The plane across a layer, seen against the sweep.
class Plane_chart {
 public:
  explicit Plane_chart(const Vec3& up) : axes_(axes_across(up)) {}
  Point2 operator()(const Vec3& p) const { return {dot(axes_[0], p), dot(axes_[1], p)}; }
  std::vector<Point2> operator()(const std::vector<Vec3>& points) const {
    std::vector<Point2> result;
    for (const Vec3& p : points) result.push_back((*this)(p));
    return result;
  }
  /// A vector of space from its components in the plane.
  Vec3 lifted(double x, double y) const { return x * axes_[0] + y * axes_[1]; }

 private:
  std::array<Vec3, 2> axes_;
};

inline double signed_area(const std::vector<Point2>& loop) {
  double area = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    area += (a[0] - loop[0][0]) * (b[1] - loop[0][1]) - (b[0] - loop[0][0]) * (a[1] - loop[0][1]);
  }
  return area / 2;
}

/// How often a closed polygon turns about a point.
inline int winding_number(const std::vector<Point2>& loop, const Point2& p) {
  int turns = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a[1] <= p[1]) == (b[1] <= p[1])) continue;
    const double side = (b[0] - a[0]) * (p[1] - a[1]) - (p[0] - a[0]) * (b[1] - a[1]);
    if (a[1] <= p[1] && side > 0) ++turns;
    if (b[1] <= p[1] && side < 0) --turns;
  }
  return turns;
}

}  // namespace CCSweep::internal

#endif
