// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LAYER_DRAWING_H
#define CCSWEEP_LAYER_DRAWING_H

#include <CCSweep/indices.h>

#include <vector>

namespace CCSweep {

/// What a piece of a layer belongs to: the number of the source above it and of the target below it, or `none`. In a
/// decomposition these are `Patch_index`es: a patch id may name several pieces, each a source or target of its own.
struct Loop_label {
  static constexpr int none = -1;
  int source = none;
  int target = none;

  bool empty() const { return source == none && target == none; }
  friend auto operator<=>(const Loop_label&, const Loop_label&) = default;
};

/// A layer before its imprint: the boundaries of its sources and targets as segments in the layer's chart, each
/// with the labels of its two sides. A segment speaks only for the sets whose labels differ from one side to the
/// other; where segments coincide, their labels add up.
template <class Traits>
struct Layer_drawing {
  using Point_2 = typename Traits::Point_2;

  struct Node {
    Point_2 point;
    bool fixed = false;   ///< lies on the input surface and may not move; projected nodes are free
    bool corner = false;  ///< a LoopVertex: the corner of a cap, here or carried along the sweep
    double reach = 0;     ///< of a free node that may have been carried past a fixed one: how far it snaps to those
  };

  struct Segment {
    Node_index source, target;
    Loop_label left, right;
    bool fixed = false;      ///< lies on the input surface; nothing may move it
    double chord_error = 0;  ///< how far the arc it stands for may bulge from it; 0 for a straight edge
  };

  std::vector<Node> nodes;
  std::vector<Segment> segments;
};

}  // namespace CCSweep

#endif
