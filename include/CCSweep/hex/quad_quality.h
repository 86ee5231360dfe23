// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_QUAD_QUALITY_H
#define CCSWEEP_HEX_QUAD_QUALITY_H

#include <CCSweep/hex/plane.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CCSweep::internal {

/// Twice the signed area of a triangle.
inline double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

inline double squared_length(const Point2& a, const Point2& b) {
  return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

// Not std::hypot, which takes ten times as long to be right for lengths near the end of what a double holds.
inline double length_between(const Point2& a, const Point2& b) { return std::sqrt(squared_length(a, b)); }

/// The least sine of a quad's four angles, counter-clockwise: 1 for a rectangle, negative where it folds.
inline double quad_scaled_jacobian(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Point2* const p[4] = {&a, &b, &c, &d};
  const double length[4] = {length_between(a, b), length_between(b, c), length_between(c, d), length_between(d, a)};
  double worst = 1;
  for (int i = 0; i < 4; ++i) {
    const Point2 &before = *p[(i + 3) % 4], &here = *p[i], &after = *p[(i + 1) % 4];
    const double size = length[i] * length[(i + 3) % 4];
    worst = std::min(worst, size > 0 ? turn(here, after, before) / size : -1.0);
  }
  return worst;
}

/// The least over a quad's corners of the sine times how alike the two sides are: 1 for a square. What sees angles only
/// would shrink sides to nothing.
inline double quad_shape(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const Point2* const p[4] = {&a, &b, &c, &d};
  double worst = 1;
  for (int i = 0; i < 4; ++i) {
    const Point2 &before = *p[(i + 3) % 4], &here = *p[i], &after = *p[(i + 1) % 4];
    const double sum = squared_length(here, after) + squared_length(here, before);
    worst = std::min(worst, sum > 0 ? 2 * turn(here, after, before) / sum : -1.0);
  }
  return worst;
}

}  // namespace CCSweep::internal

#endif
