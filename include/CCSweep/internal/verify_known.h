// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_KNOWN_H
#define CCSWEEP_INTERNAL_VERIFY_KNOWN_H

#include <CCSweep/internal/verify_scene.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CCSweep::internal::verification {

/// A surface's triangles by their corners.
class Known_triangles {
 public:
  Known_triangles(const Surface& surface, std::size_t number_of_points)
      : surface_(surface), first_(number_of_points + 1, 0), triangles_(surface.points.size()) {
    for (const Triple& p : surface.points) ++first_[lowest(p) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> place(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) triangles_[place[lowest(surface.points[t])]++] = t;
  }

  /// The triangle of a patch with these corners in this order, wherever it begins.
  std::optional<std::uint32_t> find(const Triple& p, int patch) const {
    const std::uint32_t corner = lowest(p);
    for (std::uint32_t i = first_[corner]; i < first_[corner + 1]; ++i) {
      const std::uint32_t t = triangles_[i];
      if (surface_.patch[t] == patch && rotated(surface_.points[t]) == rotated(p)) return t;
    }
    return std::nullopt;
  }

 private:
  static std::uint32_t lowest(const Triple& p) { return *std::min_element(p.begin(), p.end()); }
  static Triple rotated(Triple p) {
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    return p;
  }

  const Surface& surface_;
  std::vector<std::uint32_t> first_, triangles_;  ///< by the lowest corner
};

}  // namespace CCSweep::internal::verification

#endif
