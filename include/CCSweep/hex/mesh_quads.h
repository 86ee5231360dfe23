// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MESH_QUADS_H
#define CCSWEEP_HEX_MESH_QUADS_H

#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/map_quads.h>
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

/// Meshes a region with quads: structured where it has four sides that agree and that comes out well, else by pairing
/// triangles. The nodes on its loops are kept.
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
  auto paired = pair_quads(region, size);
  if (!paired) return best;
  smooth_quads(*paired, fixed);
  if (!best || worst_quality(*paired) > worst_quality(*best)) best = std::move(paired);
  return best;
}

}  // namespace CCSweep

#endif
