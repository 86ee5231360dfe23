// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_PATCH_SLOPE_H
#define CCSWEEP_PART_PATCH_SLOPE_H

#include <CCSweep/part/Part.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CCSweep::internal {

/// The cosines between the normals of a patch and a direction.
struct Patch_slope {
  double low = 1, high = -1, mean = 0, area = 0;
};

/// The slopes of a patch, apart from a little of its area at either end: where the facets of a round wall are large,
/// the chord errors of its curves leave slivers that lie at any angle.
class Slope_range {
 public:
  void add(double slope, double area) {
    Bin& bin = bins_[static_cast<std::size_t>(std::clamp((slope + 1) * half, 0.0, 2.0 * half - 1))];
    bin.low = std::min(bin.low, slope);
    bin.high = std::max(bin.high, slope);
    bin.area += area;
    area_ += area;
  }

  double low() const { return first(bins_.begin(), bins_.end()).low; }
  double high() const { return first(bins_.rbegin(), bins_.rend()).high; }

 private:
  static constexpr double slivers = 0.01;  // of the area
  static constexpr int half = 100;
  struct Bin {
    double low = 1, high = -1, area = 0;
  };

  template <class Iterator>
  const Bin& first(Iterator bin, Iterator end) const {
    double passed = bin->area;
    while (passed <= slivers * area_ && bin + 1 != end) passed += (++bin)->area;
    return *bin;
  }

  std::array<Bin, 2 * half> bins_;
  double area_ = 0;
};

template <class Traits>
Patch_slope slope(const Part<Traits>& part, Patch_index patch, const Vec3& direction) {
  Slope_range range;
  Patch_slope s;
  double area = 0;
  for (auto f : part.facing(patch)) {
    const double c = dot(part.normal[f], direction);
    s.mean += part.area[f] * c;
    area += part.area[f];
    range.add(c, part.area[f]);
  }
  s.mean /= area;
  s.low = range.low();
  s.high = range.high();
  s.area = part.area_of_patch[patch.value()];
  return s;
}

}  // namespace CCSweep::internal

#endif
