// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_LAYER_CHART_H
#define CCSWEEP_LOOPS_LAYER_CHART_H

#include <CCSweep/part/Part.h>

#include <array>

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

  explicit Layer_chart(const Direction& up) : up_(up), axes_(internal::axes_across(up)) {}

  const Direction& up() const { return up_; }

  Point_2 operator()(const Point_3& p) const { return Point_2(coordinate(axes_[0], p), coordinate(axes_[1], p)); }

 private:
  static FT coordinate(const Direction& axis, const Point_3& p) {
    return FT(axis[0]) * p.x() + FT(axis[1]) * p.y() + FT(axis[2]) * p.z();
  }

  Direction up_;
  std::array<Direction, 2> axes_;
};

}  // namespace CCSweep

#endif
