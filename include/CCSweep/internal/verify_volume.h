// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_VOLUME_H
#define CCSWEEP_INTERNAL_VERIFY_VOLUME_H

#include <CCSweep/internal/verify_scene.h>
#include <CGAL/Exact_integer.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>

#include <sstream>

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

  explicit Exact_volume(const Scene<Kernel>& scene) {
    [[maybe_unused]] const int unit = smallest_exponent(scene);
    for (const auto& p : scene.points) {
      if constexpr (rounded)
        coordinates_.push_back({scaled(p.x(), unit), scaled(p.y(), unit), scaled(p.z(), unit)});
      else
        coordinates_.push_back({exact_value(p.x()), exact_value(p.y()), exact_value(p.z())});
    }
  }

  /// Six times the signed volume between a triangle and the plane z = 0.
  Number operator()(const Triple& t) const {
    const auto &a = coordinates_[t[0]], &b = coordinates_[t[1]], &c = coordinates_[t[2]];
    const Number area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return (a[2] + b[2] + c[2]) * area;
  }

  static double ratio(const Number& a, const Number& b) {
    if constexpr (rounded)
      return CGAL::to_double(CGAL::Exact_rational(a) / CGAL::Exact_rational(b));
    else
      return CGAL::to_double(Number(a / b));
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

  std::vector<std::array<Number, 3>> coordinates_;
};

/// The area of all triangles, rounded.
template <class Kernel>
double area(const Scene<Kernel>& scene, const Surface& surface) {
  double sum = 0;
  for (const Triple& t : surface.points) sum += length(vector_area(scene, t));
  return sum;
}

/// Every sub-volume is positive; together they are, exactly, what their outer triangles enclose; and that is the
/// input: exactly with exact numbers, else as far as the rounding of the vertices allows.
template <class Kernel>
void check_volumes(const Scene<Kernel>& scene) {
  const Exact_volume<Kernel> volume(scene);
  using Number = typename Exact_volume<Kernel>::Number;
  Number total(0), outer(0), input(0);
  for (const Surface& surface : scene.volumes) {
    Number sum(0);
    for (std::size_t t = 0; t < surface.points.size(); ++t) {
      const Number part = volume(surface.points[t]);
      sum += part;
      if (scene.is_input_patch(surface.patch[t])) outer += part;
    }
    if (!(sum > 0)) reject(surface.title + " is inside out: its volume is not positive", {surface.patch.front()});
    total += sum;
  }
  for (const Triple& t : scene.input.points) input += volume(t);
  if (!(input > 0)) reject("the volume of the input is not positive");
  if (total != outer) reject("the sub-volumes do not sum up to the volume that their outer triangles enclose");
  if (total == input) return;
  if (scene.exact) reject("the sub-volumes do not sum up to the input");
  // Each vertex is rounded by up to an ulp of its coordinates; the surface then sweeps over that much volume.
  const double input_volume = [&] {
    double sum = 0;
    for (const Triple& t : scene.input.points)
      sum += dot(scene.near[t[0]], cross(scene.near[t[1]], scene.near[t[2]])) / 6;
    return sum;
  }();
  const double slack = 1e-12 + 4e-15 * scene.extent * area(scene, scene.input) / input_volume;
  const double error = std::abs(Exact_volume<Kernel>::ratio(Number(total - input), input));
  if (error <= slack) return;
  std::ostringstream reason;
  reason << "the sub-volumes do not sum up to the input: the relative error is " << error;
  reject(reason.str());
}

}  // namespace CCSweep::internal::verification

#endif
