// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CERTIFY_H
#define CCSWEEP_HEX_CERTIFY_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/quality.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Part.h>

#include <cstddef>
#include <string>

namespace CCSweep::internal {

/// Fails with the place of a hexahedron that can't be shown to be positive everywhere.
inline void certify(const Hex_mesh& mesh) {
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h) {
    const Hex_corners corners = corners_of(mesh, h);
    if (is_positive(corners)) continue;
    const int target = mesh.targets[mesh.volume[h]];
    Vec3 middle{};
    for (const Vec3& p : corners) middle = middle + 0.125 * p;
    fail(Status_code::hex_mesh_failed, Stage::hex_mesh,
         "a hexahedron of the sub-volume on target " + std::to_string(target) + " is folded; another size may help",
         {target}, middle);
  }
}

}  // namespace CCSweep::internal

#endif
