// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_LAYERING_H
#define CCSWEEP_LINKING_LAYERING_H

#include <CCSweep/indices.h>

#include <limits>
#include <vector>

namespace CCSweep {

/// The sweep parameter on the linking faces, the levels of the caps and the layers (sections 2.2 and 2.3).
struct Layering {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::vector<double> parameter;                ///< by vertex of the part; `none` inside a cap
  std::vector<std::vector<Patch_index>> caps;   ///< by level, the lowest first
  std::vector<Level_index> level_of_patch;      ///< by patch; invalid for linking faces
  std::vector<double> layers;                   ///< the value of each layer, ascending
  std::vector<Level_index> level_of_layer;      ///< by layer; invalid where a layer carries no caps

  std::size_t number_of_layers() const { return layers.size(); }
  double value(Layer_index layer) const { return layers[layer.value()]; }
  Level_index level(Layer_index layer) const { return level_of_layer[layer.value()]; }
};

/// How finely the linking faces are to be layered.
struct Layering_options {
  /// Degrees the sweep may turn between two layers. The paper's 60 (section 2.1) is an upper bound: a cut is straight
  /// between layers and would leave a bend that turns so far.
  double spanning_angle = 7.5;
  int slabs = 1;  ///< the least number of slabs between two levels
  /// How far the sweep parameter may grow between two layers, to the nearest whole number of slabs.
  double spacing = std::numeric_limits<double>::infinity();
  /// Rows pass through vertices of the linking faces as well, where these are not too dense.
  bool through_vertices = false;
  /// Values, ascending, at which there must be rows; between two levels with such values there are no others.
  std::vector<double> through = {};
};

}  // namespace CCSweep

#endif
