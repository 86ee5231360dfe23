// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_HEX_MESH_H
#define CCSWEEP_HEX_HEX_MESH_H

#include <CCSweep/volumes/Decomposition.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CCSweep {

/// What the angles of a part and of its imprint allow at a node on the outline of a cap: of the hexahedra that meet
/// there and keep to the curves, one has no more than this scaled Jacobian.
struct Angle_bound {
  double scaled_jacobian = 1;
  double angle = 90;  ///< which the outline encloses there on the cap, in degrees
  double slope = 90;  ///< of the columns against the cap, in degrees
  std::array<double, 3> place{};
  int patch_id = -1;  ///< of the cap; -1 where nothing is in the way
};

/// A conformal mesh of hexahedra: neighbours share whole faces, and no two nodes stand at the same place.
struct Hex_mesh {
  using Point = std::array<double, 3>;

  /// A face of exactly one hexahedron, turning outward.
  struct Boundary_quad {
    std::array<std::uint32_t, 4> nodes;
    int patch_id;  ///< of the input patch it lies on
    Role role;     ///< source, target or linking, in the sweep of its sub-volume
    int volume;    ///< index of the sub-volume
  };

  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 8>> hexes;  ///< nodes in VTK's order: the bottom quad, then the top one
  std::vector<int> volume;                          ///< by hexahedron: index of the sub-volume
  std::vector<int> targets;                         ///< by sub-volume: id of its target patch in the common sweep
  std::vector<std::array<double, 3>> directions;    ///< by sub-volume: in which it was swept, at its target
  std::vector<Boundary_quad> boundary;
  std::vector<Angle_bound> bounds;  ///< by sub-volume: the tightest on the outlines of its caps
};

/// The tightest of the bounds that the angles of a part and of its imprint set, before nodes inside caps are moved.
inline Angle_bound tightest_bound(const Hex_mesh& mesh) {
  const auto tightest = std::min_element(mesh.bounds.begin(), mesh.bounds.end(), [](const auto& a, const auto& b) {
    return a.scaled_jacobian < b.scaled_jacobian;
  });
  return tightest == mesh.bounds.end() ? Angle_bound() : *tightest;
}

}  // namespace CCSweep

#endif
