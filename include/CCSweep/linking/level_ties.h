// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_LEVEL_TIES_H
#define CCSWEEP_LINKING_LEVEL_TIES_H

#include <CCSweep/linking/cap_groups.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CCSweep::internal {

/// A curve on the linking faces that rises from one group of caps to another.
struct Rising_curve {
  int low, high;                    ///< groups
  double distance;                  ///< along the sweep
  std::vector<Vec3> points = {};    ///< of a bent sweep: its vertices
  std::vector<double> risen = {};   ///< and the distance at each
};

/// A group of caps stands beside a curve: at this fraction of the way from one group to another.
struct Level_tie {
  int group, low, high;
  double fraction, weight;
};

/// Where curves rise past a group of caps, across the sweep: a sweep that fans out leads farther outside than inside,
/// so that distances alone don't tell that caps stand beside one another.
class Level_tie_finder {
 public:
  Level_tie_finder(const std::vector<Cap_group>& groups, double diagonal) : groups_(groups), diagonal_(diagonal) {}

  std::vector<Level_tie> run(const std::vector<Rising_curve>& curves) const {
    std::vector<Level_tie> ties;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      for (const Rising_curve& curve : curves) {
        if (curve.low == static_cast<int>(g) || curve.high == static_cast<int>(g)) continue;
        if (const auto crossing = nearest_crossing(groups_[g], curve)) {
          // Distances count 1; what is near tells more than what is far.
          const double nearness = diagonal_ / std::max(crossing->distance, 1e-3 * diagonal_);
          ties.push_back({static_cast<int>(g), curve.low, curve.high, crossing->fraction, 10 * nearness * nearness});
        }
      }
    return ties;
  }

 private:
  struct Crossing {
    double fraction, distance;
  };

  // A curve may end just short of the plane, or begin just beyond it: it goes on straight for a little.
  std::optional<Crossing> nearest_crossing(const Cap_group& group, const Rising_curve& curve) const {
    constexpr double beyond = 0.1, aslant = 0.5;
    std::optional<Crossing> best;
    const std::size_t last = curve.points.size() - 2;
    for (std::size_t k = 0; k <= last; ++k) {
      const Vec3 step = curve.points[k + 1] - curve.points[k];
      const double rise = dot(group.ahead, step);
      if (rise < aslant * norm(step)) continue;
      const double u = dot(group.ahead, group.middle - curve.points[k]) / rise;
      const double fraction =
          (curve.risen[k] + u * (curve.risen[k + 1] - curve.risen[k])) / curve.distance;
      if (k == 0 ? fraction < -beyond : u < 0) continue;
      if (k == last ? fraction > 1 + beyond : u > 1) continue;
      const double distance = norm(curve.points[k] + u * step - group.middle);
      if (!best || distance < best->distance) best = Crossing{fraction, distance};
    }
    return best;
  }

  const std::vector<Cap_group>& groups_;
  double diagonal_;
};

}  // namespace CCSweep::internal

#endif
