// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_WANTED_INTERVALS_H
#define CCSWEEP_HEX_WANTED_INTERVALS_H

#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/sizing.h>

#include <cstddef>
#include <vector>

namespace CCSweep::internal {

/// The ids of the patches that an arc lies on.
inline std::vector<int> patches_of(const Cell_stack& stack, std::size_t layer, const Arc_stack::Arc& arc) {
  std::vector<int> ids;
  const auto add = [&](Patch_index patch) {
    if (patch.is_valid()) ids.push_back(stack.id(patch));
  };
  for (const auto* side : {&arc.left, &arc.right}) {
    add(side->source);
    if (side->target.is_valid() && stack.layers.layer_of_cap[side->target.value()] == layer) add(side->target);
  }
  for (Patch_index wall : arc.wall) add(wall);
  return ids;
}

/// The intervals of all arcs by the edge lengths wanted, yet to be solved for.
template <SizingField Sizing>
Arc_intervals wanted_intervals(const Cell_stack& stack, const Sizing& sizing) {
  return Arc_intervals(stack.arcs, [&](std::size_t k, const Arc_stack::Arc& arc) {
    return size_between(sizing, patches_of(stack, k, arc));
  });
}

}  // namespace CCSweep::internal

#endif
