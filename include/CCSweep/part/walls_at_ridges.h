// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_WALLS_AT_RIDGES_H
#define CCSWEEP_PART_WALLS_AT_RIDGES_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/Wall_edges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CCSweep::internal {

/// Finds linking faces that close a part or open it along an edge across a straight sweep: both faces at a ridge lie
/// below it, both at the bottom of a groove above. No column can go on there, so one of the two must be a cap.
template <class Traits>
std::vector<Patch_index> walls_at_ridges(const Part<Traits>& part, const Roles& roles) {
  using Edges = Wall_edges<Traits>;
  const Edges edges(part, roles);
  const auto is_ridge = [&](auto h) {
    const auto back = part.mesh.opposite(h);
    if (!edges.is_wall(h) || !edges.is_wall(back) || std::abs(edges.rise(h)) > Edges::level) return false;
    const double here = edges.rise_inward(h), beyond = edges.rise_inward(back);
    return std::min(here, beyond) > Edges::level || std::max(here, beyond) < -Edges::level;
  };
  std::vector<Patch_index> found;
  for (std::size_t p = 0; p < part.number_of_patches(); ++p)
    if (std::any_of(part.border[p].begin(), part.border[p].end(), is_ridge)) found.emplace_back(p);
  return found;
}

}  // namespace CCSweep::internal

#endif
