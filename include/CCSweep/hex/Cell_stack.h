// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CELL_STACK_H
#define CCSWEEP_HEX_CELL_STACK_H

#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/cell_turns.h>
#include <CCSweep/hex/trace_cells.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// All cells of a part, how their outlines turn, and the sub-volumes they belong to.
class Cell_stack {
 public:
  const Layer_stack& layers;
  const Arc_stack& arcs;
  const std::vector<int>& patch_id;  ///< by patch
  std::vector<Cell> cells;
  std::vector<std::vector<int>> turns;  ///< by cell, as of `cell_turns()`
  std::vector<Patch_index> targets;     ///< by sub-volume

  Cell_stack(const Layer_stack& layers, const Arc_stack& arcs, const std::vector<int>& patch_id)
      : layers(layers), arcs(arcs), patch_id(patch_id), cells(trace_cells(layers, arcs)) {
    for (const Cell& cell : cells) turns.push_back(cell_turns(layers, arcs, cell));
    number_volumes();
  }

  int id(Patch_index patch) const { return patch_id[patch.value()]; }
  int volume_of(const Cell& cell) const {
    return static_cast<int>(std::find(targets.begin(), targets.end(), cell.target) - targets.begin());
  }
  /// The direction of the sweep at a cap.
  const Vec3& up_at(Patch_index cap) const { return layers.layers[layers.layer_of_cap[cap.value()]].up; }

 private:
  // Sub-volumes ascend by the id of their target, as in a decomposition.
  void number_volumes() {
    for (const Cell& cell : cells) targets.push_back(cell.target);
    std::sort(targets.begin(), targets.end(),
              [&](Patch_index a, Patch_index b) { return std::pair(id(a), a) < std::pair(id(b), b); });
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  }
};

}  // namespace CCSweep::internal

#endif
