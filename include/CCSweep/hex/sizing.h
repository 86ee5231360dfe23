// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_SIZING_H
#define CCSWEEP_HEX_SIZING_H

#include <algorithm>
#include <cmath>
#include <concepts>
#include <map>
#include <utility>
#include <vector>

namespace CCSweep {

/// The edge lengths wanted: of the part, on a patch, and on the curve between two patches. Where several apply, the
/// smallest counts. That of the part also is the height of the layers.
template <class Sizing>
concept SizingField = std::copy_constructible<Sizing> && requires(const Sizing& sizing, int patch) {
  { sizing.on_part() } -> std::convertible_to<double>;
  { sizing.on_patch(patch) } -> std::convertible_to<double>;
  { sizing.on_curve(patch, patch) } -> std::convertible_to<double>;
  { sizing.are_valid() } -> std::convertible_to<bool>;
};

/// One size for the whole part, and others for some patches and curves.
class Patch_sizes {
 public:
  Patch_sizes(double of_part) : of_part_(of_part) {}  // NOLINT: a number is a sizing

  /// Sets the size on a patch, by its id.
  Patch_sizes& patch(int id, double size) {
    of_patch_[id] = size;
    return *this;
  }
  /// Sets the size on the curves between two patches.
  Patch_sizes& curve(int a, int b, double size) {
    of_curve_[std::minmax(a, b)] = size;
    return *this;
  }

  double on_part() const { return of_part_; }
  double on_patch(int id) const {
    const auto found = of_patch_.find(id);
    return found == of_patch_.end() ? of_part_ : found->second;
  }
  double on_curve(int a, int b) const {
    const auto found = of_curve_.find(std::minmax(a, b));
    return found == of_curve_.end() ? std::min(on_patch(a), on_patch(b)) : found->second;
  }
  /// Whether all sizes are finite numbers above 0.
  bool are_valid() const {
    const auto is_valid = [](double size) { return std::isfinite(size) && size > 0; };
    const auto all = [&](const auto& sizes) {
      return std::all_of(sizes.begin(), sizes.end(), [&](const auto& s) { return is_valid(s.second); });
    };
    return is_valid(of_part_) && all(of_patch_) && all(of_curve_);
  }

 private:
  double of_part_;
  std::map<int, double> of_patch_;
  std::map<std::pair<int, int>, double> of_curve_;
};

/// The size of an edge between patches: the smallest of theirs and of the curves between them.
template <SizingField Sizing>
double size_between(const Sizing& sizing, const std::vector<int>& patches) {
  double size = sizing.on_part();
  for (std::size_t i = 0; i < patches.size(); ++i) {
    size = std::min(size, double(sizing.on_patch(patches[i])));
    for (std::size_t j = 0; j < i; ++j) size = std::min(size, double(sizing.on_curve(patches[i], patches[j])));
  }
  return size;
}

}  // namespace CCSweep

#endif
