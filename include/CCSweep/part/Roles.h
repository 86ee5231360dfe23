// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_ROLES_H
#define CCSWEEP_PART_ROLES_H

#include <CCSweep/volumes/Decomposition.h>

#include <array>
#include <vector>

namespace CCSweep {

/// What each patch is to a sweep along `direction`.
struct Roles {
  std::array<double, 3> direction{};             ///< unit vector from targets to sources, at the targets
  std::vector<Role> of_patch;                    ///< by `Patch_index`; never `Role::cut`
  bool is_doubtful = false;                      ///< a wall leans by more than 37 degrees, or narrows to a point
  std::vector<std::array<double, 3>> along_face; ///< of a bent sweep, by face: where it leads; empty if it is straight

  bool is_straight() const { return along_face.empty(); }
  const std::array<double, 3>& along(std::size_t face) const { return is_straight() ? direction : along_face[face]; }
};

/// What a user may say of the caps; an empty member leaves the choice to the algorithm.
struct Role_request {
  std::array<double, 3> direction{};  ///< zero: any
  std::vector<int> sources, targets;  ///< patch ids

  bool has_direction() const { return direction != std::array<double, 3>{}; }
  bool has_caps() const { return !sources.empty() || !targets.empty(); }
};

}  // namespace CCSweep

#endif
