// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_CUT_ROWS_H
#define CCSWEEP_VOLUMES_CUT_ROWS_H

#include <CCSweep/indices.h>

#include <vector>

namespace CCSweep {

/// The piece of a cut between two layers: columns of nodes, one above another. Seen against the sweep and along
/// `bottom`, target `left` is on the left.
struct Cut_row {
  Layer_index layer;  ///< the lower one
  std::vector<Node_index> bottom, top;
  Patch_index left, right;  ///< targets
  std::vector<double> lift;  ///< by upper node: how far the imprint moved it along the sweep from its projection
};

}  // namespace CCSweep

#endif
