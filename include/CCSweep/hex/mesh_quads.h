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
#include <CCSweep/hex/submap_quads.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>

namespace CCSweep {

/// The least scaled Jacobian of a quad mesh.
inline double worst_quality(const Quad_mesh& mesh) {
  double worst = 1;
  for (const auto& [a, b, c, d] : mesh.quads)
    worst = std::min(worst, internal::quad_scaled_jacobian(mesh.points[a], mesh.points[b], mesh.points[c],
                                                           mesh.points[d]));
  return worst;
}

/// What meshes plane regions with quads, keeping the nodes on their loops as the first ones of the mesh.
template <class Mesher>
concept QuadMesher = std::copy_constructible<Mesher> &&
    requires(const Mesher& mesher, const Quad_region& r, double size) {
  { mesher(r, size) } -> std::same_as<std::optional<Quad_mesh>>;
};

/// Meshes by matching triangles into quads. \sa `match_quads()`
struct Matched_quads {
  std::optional<Quad_mesh> operator()(const Quad_region& region, double size) const {
    auto mesh = match_quads(region, size);
    if (mesh) smooth_quads(*mesh, number_of_nodes(region));
    return mesh;
  }
};

/// Meshes by pairing triangles of twice the size and subdividing pairs and triangles. \sa `pair_quads()`
struct Subdivided_quads {
  std::optional<Quad_mesh> operator()(const Quad_region& region, double size) const {
    auto mesh = pair_quads(region, size);
    if (mesh) smooth_quads(*mesh, number_of_nodes(region));
    return mesh;
  }
};

/// Meshes regions whose outline allows it with a structured mesh. \sa `map_quads()`, `submap_quads()`
struct Structured_quads {
  std::optional<Quad_mesh> operator()(const Quad_region& region, double) const {
    constexpr double good = 0.4;
    auto mesh = is_mappable(region) ? std::optional(map_quads(region)) : submap_quads(region);
    if (mesh && worst_quality(*mesh) < good) smooth_quads(*mesh, number_of_nodes(region));
    return mesh;
  }
};

/// The default: a structured mesh where there is one and it comes out well, else the better one of subdivided pairs of
/// triangles and of matched triangles. Matching takes four times as many triangles, and so is left out for a large
/// region where subdivision comes out well.
struct Best_quads {
  std::optional<Quad_mesh> operator()(const Quad_region& region, double size) const {
    constexpr std::size_t large = 1000;
    std::optional<Quad_mesh> best;
    double quality = -2;
    const auto is_good = [&](std::optional<Quad_mesh> made, double good) {
      if (const double q = made ? worst_quality(*made) : -2; q > quality) {
        quality = q;
        best = std::move(made);
      }
      return quality >= good;
    };
    if (is_good(Structured_quads()(region, size), 0.4)) return best;
    if (is_good(Subdivided_quads()(region, size), internal::good_quad_shape) && best->quads.size() > large) return best;
    is_good(Matched_quads()(region, size), 1);
    return best;
  }
};

}  // namespace CCSweep

#endif
