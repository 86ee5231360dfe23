// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_VOLUME_H
#define CCSWEEP_INTERNAL_VERIFY_VOLUME_H

#include <CCSweep/internal/verify_known.h>
#include <CCSweep/internal/verify_scene.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace CCSweep::internal::verification {

template <class ET>
ET exact_value(const CGAL::Lazy_exact_nt<ET>& x) {
  return x.exact();
}
template <class NT>
NT exact_value(const NT& x) {
  return x;
}

/// Volumes in exact arithmetic. Doubles are made integers by a common power of two, which is many times faster
/// than fractions; all volumes are then in the same unknown unit, and only their signs and ratios are used.
template <class Kernel>
class Exact_volume {
  using FT = typename Kernel::FT;
  static constexpr bool rounded = std::is_floating_point_v<FT>;

 public:
  using Number = std::conditional_t<rounded, CGAL::Exact_integer, decltype(exact_value(std::declval<const FT&>()))>;

  explicit Exact_volume(const Scene<Kernel>& scene) : scene_(scene) {
    if constexpr (rounded) unit_ = smallest_exponent(scene);
  }

  /// Six times the signed volume between a triangle and the plane z = 0.
  Number operator()(const Triple& t) const {
    const auto a = coordinates(t[0]), b = coordinates(t[1]), c = coordinates(t[2]);
    const Number area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return (a[2] + b[2] + c[2]) * area;
  }

  /// The quotient of an exact volume and a rounded one, which is positive.
  double relative(const Number& six_volumes, double volume) const {
    if constexpr (rounded) {
      const CGAL::Exact_rational units(scaled(1, unit_));  // in a length of one
      return CGAL::to_double(CGAL::Exact_rational(six_volumes) /
                             (CGAL::Exact_rational(6 * volume) * units * units * units));
    } else {
      return CGAL::to_double(six_volumes) / (6 * volume);
    }
  }

 private:
  static constexpr int digits = std::numeric_limits<double>::digits;
  static constexpr int step = 900;  // a power of two that a mantissa can be multiplied with

  static int smallest_exponent(const Scene<Kernel>& scene) {
    int smallest = 0;
    if constexpr (rounded) {
      for (const auto& p : scene.points)
        for (int k = 0; k < 3; ++k) {
          int exponent = 0;
          std::frexp(p[k], &exponent);
          smallest = std::min(smallest, exponent - digits);
        }
    }
    return smallest;
  }

  static CGAL::Exact_integer scaled(double x, int unit) {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(x, &exponent), digits);
    if (mantissa == 0) return CGAL::Exact_integer(0);
    int shift = exponent - digits - unit;
    CGAL::Exact_integer result(std::ldexp(mantissa, std::min(shift, step)));
    for (shift -= step; shift > 0; shift -= step) result *= CGAL::Exact_integer(std::ldexp(1.0, std::min(shift, step)));
    return result;
  }

  std::array<Number, 3> coordinates(std::uint32_t point) const {
    const auto& p = scene_.points[point];
    if constexpr (rounded)
      return {scaled(p.x(), unit_), scaled(p.y(), unit_), scaled(p.z(), unit_)};
    else
      return {exact_value(p.x()), exact_value(p.y()), exact_value(p.z())};
  }

  const Scene<Kernel>& scene_;
  int unit_ = 0;  // the exponent of the common power of two
};

/// The area of all triangles, rounded.
template <class Kernel>
double area(const Scene<Kernel>& scene, const Surface& surface) {
  double sum = 0;
  for (const Triple& t : surface.points) sum += length(vector_area(scene, t));
  return sum;
}

/// The volume that a closed surface encloses, rounded, and a bound of its error.
template <class Kernel>
std::pair<double, double> rounded_volume(const Scene<Kernel>& scene, const Surface& surface) {
  double sum = 0, most = 0;
  for (const Triple& t : surface.points) {
    const Place &a = scene.near[t[0]], &b = scene.near[t[1]], &c = scene.near[t[2]];
    sum += dot(a, cross(b, c)) / 6;
    most += length(a) * length(b) * length(c);
  }
  // A summand is off by some ulps, of which coordinates and products have one each, the sum by one for each summand.
  return {sum, std::numeric_limits<double>::epsilon() * (64 + double(surface.points.size())) * most};
}

/// Whether the volume is positive. What rounding leaves open is decided by the exact sum.
template <class Kernel>
bool is_outward(const Scene<Kernel>& scene, const Surface& surface, const Exact_volume<Kernel>& volume) {
  if (!scene.exact) {
    const auto [rounded, error] = rounded_volume(scene, surface);
    if (rounded > error) return true;
  }
  typename Exact_volume<Kernel>::Number sum(0);
  for (const Triple& t : surface.points) sum += volume(t);
  return sum > 0;
}

/// Six times the volume of all outer triangles without that of the input. Equal triangles cancel.
template <class Kernel>
typename Exact_volume<Kernel>::Number excess(const Scene<Kernel>& scene, const Exact_volume<Kernel>& volume) {
  typename Exact_volume<Kernel>::Number sum(0);
  const Known_triangles known(scene.input, scene.points.size());
  std::vector<char> is_cancelled(scene.input.points.size(), false);
  for (const Surface& surface : scene.volumes)
    for (std::size_t t = 0; t < surface.points.size(); ++t) {
      if (!scene.is_input_patch(surface.patch[t])) continue;
      const auto same = known.find(surface.points[t], surface.patch[t]);
      if (same && !is_cancelled[*same])
        is_cancelled[*same] = true;
      else
        sum += volume(surface.points[t]);
    }
  for (std::size_t t = 0; t < is_cancelled.size(); ++t)
    if (!is_cancelled[t]) sum -= volume(scene.input.points[t]);
  return sum;
}

/// Every sub-volume is positive; together they are, exactly, what their outer triangles enclose, as the cuts enclose
/// nothing; and that is the input: exactly with exact numbers, else as far as the rounding of the vertices allows.
template <class Kernel>
void check_volumes(const Scene<Kernel>& scene) {
  const Exact_volume<Kernel> volume(scene);
  using Number = typename Exact_volume<Kernel>::Number;
  Number cuts(0);
  for (const Surface& surface : scene.volumes) {
    if (!is_outward(scene, surface, volume))
      reject(surface.title + " is inside out: its volume is not positive", {surface.patch.front()});
    for (std::size_t t = 0; t < surface.points.size(); ++t)
      if (!scene.is_input_patch(surface.patch[t])) cuts += volume(surface.points[t]);
  }
  if (!is_outward(scene, scene.input, volume)) reject("the volume of the input is not positive");
  if (cuts != 0) reject("the sub-volumes do not sum up to the volume that their outer triangles enclose");
  const Number more = excess(scene, volume);
  if (more == 0) return;
  if (scene.exact) reject("the sub-volumes do not sum up to the input");
  // Each vertex is rounded by up to an ulp of its coordinates; the surface then sweeps over that much volume.
  const double input_volume = rounded_volume(scene, scene.input).first;
  const double slack = 1e-12 + 4e-15 * scene.extent * area(scene, scene.input) / input_volume;
  const double error = std::abs(volume.relative(more, input_volume));
  if (error <= slack) return;
  std::ostringstream reason;
  reason << "the sub-volumes do not sum up to the input: the relative error is " << error;
  reject(reason.str());
}

}  // namespace CCSweep::internal::verification

#endif
