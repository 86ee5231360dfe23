// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_LAYERED_LOOPS_H
#define CCSWEEP_LOOPS_LAYERED_LOOPS_H

#include <CCSweep/indices.h>
#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/part/Surface_location.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CCSweep {

/// What the sweep over the layers leaves behind: all nodes, the imprinted layers as segments between nodes, and which
/// segment stands above which. Patches in labels are `Patch_index`es.
template <class Traits>
struct Layered_loops {
  struct Node {
    typename Traits::Point_3 point;
    Surface_location where;
    bool loop_vertex = false;  ///< a corner of a cap, here or carried along the sweep, or a crossing
  };

  /// The labels of one side of a segment.
  struct Side {
    Patch_index source;  ///< the cap above, where the column ends here
    Patch_index target;  ///< the cap below that the column came from
    bool material_above() const { return target.is_valid() && !source.is_valid(); }
    bool operator==(const Side&) const = default;
  };

  /// An elementary segment of an imprinted layer.
  struct Segment {
    Node_index a, b;
    Side left, right;
  };

  /// The lower border of a cut between two layers: segment `bottom` of the lower layer goes up and, after the upper
  /// layer's imprint, passes through the nodes `top` there, from above bottom.a to above bottom.b. Where the imprint
  /// made it vanish, `top` has one node.
  struct Cut {
    std::size_t bottom;  ///< index among the segments of the lower layer
    std::vector<Node_index> top;
    std::array<std::array<double, 3>, 2> projected{};  ///< where the images of bottom.a and bottom.b were projected to
  };

  /// Two nodes above one another on the linking faces, where a cut meets them.
  struct Wall_column {
    Node_index bottom, top;
    auto operator<=>(const Wall_column&) const = default;
  };

  /// A segment on an edge between linking faces and a layer's row, with the target its material came from: tells
  /// whose wall the linking face is.
  struct Wall_label {
    Node_index a, b;  ///< in the sense of the section: the material is on the left
    std::uint32_t edge;  ///< of the part
    bool above = false;  ///< speaks of the linking face above the edge, otherwise of the one below
    Patch_index target;
  };

  /// A wall between two layers, as the ring between a loop below and a loop above.
  struct Wall_ring {
    std::vector<Node_index> bottom, top;  ///< in the nodes of the imprinted layers; the material is on the left
    std::vector<Wall_strip::Rail> rails;  ///< positions in `bottom` and `top` that stand above one another
    std::vector<Patch_index> patch;       ///< by piece of `bottom`: the linking patch above it
    std::size_t barrel = 0;               ///< equal for the rings of one body between the two layers
  };

  std::vector<Node> nodes;
  std::vector<std::array<double, 3>> up;              ///< by layer: unit vector along the sweep
  std::vector<std::vector<Segment>> segments;         ///< by layer
  std::vector<std::vector<Cut>> cuts;                 ///< by layer below
  std::vector<std::vector<Wall_column>> wall_columns; ///< by layer below
  std::vector<std::vector<Wall_ring>> rings;          ///< by layer below
  std::vector<Wall_label> wall_labels;
  double reach = 0;                                   ///< how far what was carried up snaps to the surface
  bool is_upright = false;                            ///< all walls stand along a straight sweep
  std::vector<std::string> notes;

  const Node& node(Node_index n) const { return nodes[n.value()]; }
};

}  // namespace CCSweep

#endif
