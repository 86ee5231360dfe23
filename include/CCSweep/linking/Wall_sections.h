// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_WALL_SECTIONS_H
#define CCSWEEP_LINKING_WALL_SECTIONS_H

#include <CCSweep/indices.h>
#include <CCSweep/part/Surface_location.h>

#include <cstdint>
#include <vector>

namespace CCSweep {

/// A closed row of the linking mesh: a loop of nodes on the linking faces at one layer, with the material on its left
/// when seen against the sweep (outer loops turn counter-clockwise).
struct Wall_loop {
  /// The piece of the surface that the row runs along from one node to the next.
  struct Carrier {
    bool is_edge = false;       ///< an edge of the part, otherwise a face
    std::uint32_t index = 0;
    bool operator==(const Carrier&) const = default;
  };

  std::vector<Surface_location> nodes;
  std::vector<Carrier> carriers;  ///< carriers[i] from nodes[i] to the next

  std::size_t size() const { return nodes.size(); }
};

/// The piece of the linking faces between two loops on neighbouring layers: a ring, as every cap is on a layer.
struct Wall_strip {
  std::size_t bottom = 0;  ///< index among the loops that leave the lower layer
  std::size_t top = 0;     ///< index among the loops that arrive at the upper layer
  /// Sharp edges that run up the strip: the positions of their nodes in the bottom and in the top loop.
  struct Rail {
    std::size_t bottom, top;
  };
  std::vector<Rail> rails;  ///< in the order of the bottom loop
};

/// All rows of the linking mesh. On a layer with caps, the loops that arrive from below and those that leave upwards
/// differ: by the sources that end there and the targets that begin.
struct Wall_sections {
  std::vector<std::vector<Wall_loop>> arriving, leaving;  ///< by layer
  std::vector<std::vector<Wall_strip>> strips;            ///< by layer below the strip
};

}  // namespace CCSweep

#endif
