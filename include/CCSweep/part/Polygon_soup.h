// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_POLYGON_SOUP_H
#define CCSWEEP_PART_POLYGON_SOUP_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CCSweep {

/// Polygons that index into points: what a file holds, before anything is known about its topology. Coordinates are
/// doubles, whatever kernel the mesh made from it uses.
struct Polygon_soup {
  using Vertex = std::uint32_t;

  std::vector<std::array<double, 3>> points;
  std::vector<Vertex> corners;             ///< the corners of all polygons, one polygon after the other
  std::vector<std::size_t> offsets = {0};  ///< polygon `f` owns `corners[offsets[f]]` up to `corners[offsets[f + 1]]`
  std::vector<int> patch_ids;              ///< one for each polygon, or empty where the file knows none
  std::vector<int> roles;                  ///< of each polygon in a file of a sub-volume, a `Role`; else empty

  std::size_t number_of_polygons() const { return offsets.size() - 1; }
  bool has_patch_ids() const { return !patch_ids.empty(); }

  /// The corners of a polygon, counter-clockwise seen from outside.
  std::span<const Vertex> polygon(std::size_t f) const {
    return {corners.data() + offsets[f], offsets[f + 1] - offsets[f]};
  }

  /// Ends the polygon whose corners have been appended to `corners`.
  void end_polygon() { offsets.push_back(corners.size()); }
};

}  // namespace CCSweep

#endif
