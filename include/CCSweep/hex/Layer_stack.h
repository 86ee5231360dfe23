// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_LAYER_STACK_H
#define CCSWEEP_HEX_LAYER_STACK_H

#include <CCSweep/indices.h>
#include <CCSweep/linking/Layering.h>
#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/part/Part.h>

#include <cstdint>
#include <vector>

namespace CCSweep {

/// The imprinted layers of a part as the mesher sees them: in double, and free of all that belongs to the kernel.
/// A node belongs to one layer.
struct Layer_stack {
  using Node = std::uint32_t;
  using Vec3 = internal::Vec3;

  /// What lies on one side of a segment: the cap above, where the column ends here, and the target the column came
  /// from.
  struct Side {
    Patch_index source, target;
    bool operator==(const Side&) const = default;
  };
  struct Segment {
    Node a, b;
    Side left, right;
  };
  /// Segment `bottom` of a layer passes through the nodes `top` of the next one.
  struct Cut {
    std::uint32_t bottom;
    std::vector<Node> top;
  };
  /// A wall between a loop of a layer and the loop above it.
  struct Ring {
    std::vector<Node> bottom, top;
    std::vector<Wall_strip::Rail> rails;
    std::vector<Patch_index> patch;  ///< by piece of `bottom`
    std::size_t barrel;
  };
  struct Layer {
    double value;  ///< of the sweep parameter
    Vec3 up;
    std::vector<Segment> segments;
    std::vector<Cut> cuts;    ///< up to the next layer
    std::vector<Ring> rings;  ///< up to the next layer
  };

  std::vector<Vec3> points;               ///< by node
  std::vector<bool> corner;               ///< by node
  std::vector<Layer> layers;
  std::vector<std::size_t> layer_of_cap;  ///< by patch; meaningless for linking patches
  bool is_straight = true;                ///< the sweep leads along one direction
  bool is_upright = false;                ///< and so do all walls
  double tolerance = 0;                   ///< nodes of a loop that are closer are one place

  /// Whether material lies below one side of a segment of a layer.
  bool is_below(const Side& side, std::size_t layer) const {
    return side.target.is_valid() && layer_of_cap[side.target.value()] < layer;
  }
  static bool is_above(const Side& side) { return side.target.is_valid() && !side.source.is_valid(); }
};

namespace internal {

inline std::vector<Layer_stack::Node> numbers(const std::vector<Node_index>& nodes) {
  std::vector<Layer_stack::Node> result;
  for (Node_index n : nodes) result.push_back(static_cast<Layer_stack::Node>(n.value()));
  return result;
}

template <class Traits>
Layer_stack::Layer stack_layer(const Layering& layering, const Layered_loops<Traits>& loops, std::size_t k) {
  using Node = Layer_stack::Node;
  Layer_stack::Layer layer{layering.layers[k], loops.up[k], {}, {}, {}};
  for (const auto& s : loops.segments[k])
    layer.segments.push_back({static_cast<Node>(s.a.value()), static_cast<Node>(s.b.value()),
                              {s.left.source, s.left.target}, {s.right.source, s.right.target}});
  for (const auto& c : loops.cuts[k]) layer.cuts.push_back({static_cast<std::uint32_t>(c.bottom), numbers(c.top)});
  for (const auto& r : loops.rings[k])
    layer.rings.push_back({numbers(r.bottom), numbers(r.top), r.rails, r.patch, r.barrel});
  return layer;
}

}  // namespace internal

/// Takes over the layers of a sweep.
template <class Traits>
Layer_stack make_layer_stack(const Layering& layering, const Layered_loops<Traits>& loops, bool is_straight,
                             double tolerance) {
  Layer_stack stack;
  stack.tolerance = tolerance;
  stack.is_straight = is_straight;
  stack.is_upright = loops.is_upright;
  for (const auto& node : loops.nodes) {
    stack.points.push_back(Part<Traits>::coordinates(node.point));
    stack.corner.push_back(node.loop_vertex);
  }
  std::vector<std::size_t> layer_of_level(layering.caps.size());
  for (std::size_t k = 0; k < layering.number_of_layers(); ++k) {
    stack.layers.push_back(internal::stack_layer(layering, loops, k));
    if (layering.level_of_layer[k].is_valid()) layer_of_level[layering.level_of_layer[k].value()] = k;
  }
  for (Level_index level : layering.level_of_patch)
    stack.layer_of_cap.push_back(level.is_valid() ? layer_of_level[level.value()] : 0);
  return stack;
}

}  // namespace CCSweep

#endif
