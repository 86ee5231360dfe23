// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_LAYER_CHART_H
#define CCSWEEP_LOOPS_LAYER_CHART_H

#include <CCSweep/part/Part.h>

#include <array>
#include <cmath>

namespace CCSweep {

/// The chart in which the layers of a straight sweep are imprinted: the plane across the sweep, seen against it, so
/// that targets turn counter-clockwise. Along a coordinate axis it only drops that coordinate, which is exact.
template <class Traits>
class Layer_chart {
 public:
  using FT = typename Traits::FT;
  using Point_2 = typename Traits::Point_2;
  using Point_3 = typename Traits::Point_3;
  using Direction = std::array<double, 3>;

  explicit Layer_chart(const Direction& up) : up_(up) {
    using namespace internal;
    // The coordinate axis that is most across the sweep spans the chart with its cross product.
    int least = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(up[i]) < std::abs(up[least])) least = i;
    Direction axis{};
    axis[least] = 1;
    x_ = unit(axis - dot(axis, up) * up);
    y_ = cross(up, x_);
  }

  const Direction& up() const { return up_; }

  Point_2 operator()(const Point_3& p) const { return Point_2(coordinate(x_, p), coordinate(y_, p)); }

 private:
  static FT coordinate(const Direction& axis, const Point_3& p) {
    return FT(axis[0]) * p.x() + FT(axis[1]) * p.y() + FT(axis[2]) * p.z();
  }

  Direction up_, x_, y_;
};

}  // namespace CCSweep

#endif
