// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_ANGLE_BOUND_H
#define CCSWEEP_HEX_ANGLE_BOUND_H

#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/plane.h>
#include <CCSweep/hex/quality.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace CCSweep::internal {

/// A node of a cell's outline on one of its caps: it, the nodes before and after it, with the cell on the left as seen
/// against the sweep, and where a wall leads to the next layer, the node of the wall there.
struct Outline_corner {
  Vec3 here, before, after;
  std::optional<Vec3> along;
};

/// The angle of the cell's section at a node, seen against the sweep: above zero, up to a full turn.
inline double angle_in_plane(const Outline_corner& corner, const Plane_chart& plane) {
  const Point2 a = plane(corner.after - corner.here), b = plane(corner.before - corner.here);
  const double angle = std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// The normal of a cap at a node of its outline, along the sweep: that of the plane through the node and two places
/// near by, which divide the angle there in three.
/// \param drop callable as `(const Vec3&) -> Vec3`: puts a place on the cap
template <class Drop>
Vec3 cap_normal(const Outline_corner& corner, const Plane_chart& plane, const Drop& drop) {
  constexpr double near = 0.05;
  const Point2 a = plane(corner.after - corner.here), b = plane(corner.before - corner.here);
  const double step = near * std::min(std::hypot(a[0], a[1]), std::hypot(b[0], b[1]));
  const double from = std::atan2(a[1], a[0]), third = angle_in_plane(corner, plane) / 3;
  const auto place = [&](double angle) {
    return drop(corner.here + plane.lifted(step * std::cos(angle), step * std::sin(angle))) - corner.here;
  };
  return unit(cross(place(from + third), place(from + 2 * third)));
}

/// The scaled Jacobian to ask of a mesh: as much as is wanted, or nearly what the angles allow.
inline double attainable(const Angle_bound& bound, double wanted) {
  constexpr double nearly = 0.9;
  return std::min(wanted, nearly * bound.scaled_jacobian);
}

/// What the angles at a node on the outline of a cap allow. The hexahedra around the column of the node share the angle
/// of the cap there. One alone has all three edges given. Of several the inner edges lie in the cap, whose normal is
/// given, so that each has at most the sine of its share times that of the wall's slope. Where no wall is, the column
/// may stand upright. Exact where the cap is plane.
/// \param is_source whether the cap is the upper end of the cell
template <class Drop>
Angle_bound angle_bound(const Outline_corner& corner, const Plane_chart& plane, const Drop& drop, bool is_source) {
  constexpr double turn = 2 * std::numbers::pi, degrees = 360 / turn;
  constexpr int most = 8;
  const Vec3 after = corner.after - corner.here, before = corner.before - corner.here;
  const Vec3 normal = cap_normal(corner, plane, drop);
  const Vec3 column = corner.along ? (is_source ? -1.0 : 1.0) * unit(*corner.along - corner.here) : normal;
  const bool turns_in = angle_in_plane(corner, plane) > turn / 2;
  const double on_cap = turns_in ? turn - angle(after, before) : angle(after, before);
  const double upright = dot(column, normal);
  double allowed = turns_in ? -1 : scaled_determinant(after, before, column);
  for (int hexes = 2; hexes <= most; ++hexes) allowed = std::max(allowed, std::sin(on_cap / hexes) * upright);
  return {std::min(allowed, 1.0), on_cap * degrees, std::asin(std::clamp(upright, -1.0, 1.0)) * degrees, corner.here,
          -1};
}

/// The tightest of the bounds around the outline of a cap.
/// \param outline the nodes of all loops, one loop after the other
/// \param next_layer the same of the layer next to the cap, where a wall leads there
/// \param loops the numbers of nodes of the loops
template <class Drop>
Angle_bound tightest_angle(const std::vector<Vec3>& outline, const std::vector<std::optional<Vec3>>& next_layer,
                           const std::vector<std::size_t>& loops, const Plane_chart& plane, const Drop& drop,
                           bool is_source) {
  Angle_bound tightest;
  std::size_t first = 0;
  for (std::size_t n : loops) {
    for (std::size_t i = 0; i < n; ++i) {
      const Outline_corner corner{outline[first + i], outline[first + (i + n - 1) % n], outline[first + (i + 1) % n],
                                  next_layer[first + i]};
      const Angle_bound found = angle_bound(corner, plane, drop, is_source);
      if (found.scaled_jacobian < tightest.scaled_jacobian) tightest = found;
    }
    first += n;
  }
  return tightest;
}

}  // namespace CCSweep::internal

#endif
