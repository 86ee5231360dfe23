// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MESH_QUADS_H
#define CCSWEEP_HEX_MESH_QUADS_H

#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/map_quads.h>
#include <CCSweep/hex/match_quads.h>
#include <CCSweep/hex/pair_quads.h>
#include <CCSweep/hex/quad_quality.h>
#include <CCSweep/hex/smooth_quads.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CCSweep {

/// The least scaled Jacobian of a quad mesh.
inline double worst_quality(const Quad_mesh& mesh) {
  double worst = 1;
  for (const auto& [a, b, c, d] : mesh.quads)
    worst = std::min(worst, internal::quad_scaled_jacobian(mesh.points[a], mesh.points[b], mesh.points[c],
                                                           mesh.points[d]));
  return worst;
}

/// Meshes a region with quads: structured where it has four sides that agree and that comes out well, else by matching
/// triangles, or pairing and subdividing them, whichever is better. The nodes on its loops are kept.
/// \param size the edge length wanted inside
/// \return nothing where the nodes on the loops are too coarse to outline the region
inline std::optional<Quad_mesh> mesh_quads(const Quad_region& region, double size) {
  constexpr double good = 0.4;
  std::size_t fixed = 0;
  for (const auto& loop : region.loops) fixed += loop.nodes.size();
  std::optional<Quad_mesh> best;
  if (is_mappable(region)) {
    best = map_quads(region);
    if (worst_quality(*best) < good) smooth_quads(*best, fixed);
    if (worst_quality(*best) >= good) return best;
  }
  for (const auto make : {match_quads, pair_quads}) {
    auto made = make(region, size);
    if (!made) continue;
    smooth_quads(*made, fixed);
    if (!best || worst_quality(*made) > worst_quality(*best)) best = std::move(made);
    if (worst_quality(*best) >= good) break;
  }
  return best;
}

}  // namespace CCSweep

#endif
