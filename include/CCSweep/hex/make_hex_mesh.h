// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MAKE_HEX_MESH_H
#define CCSWEEP_HEX_MAKE_HEX_MESH_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_nodes.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Cell_sides.h>
#include <CCSweep/hex/Cell_sweeper.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/even_heights.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex/trace_cells.h>
#include <CCSweep/internal/guarded.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// Meshes all cells of a part, with the nodes on their arcs shared.
template <class CapDrop>
class Hex_mesher {
 public:
  Hex_mesher(const Layer_stack& stack, const Arc_stack& arcs, const std::vector<int>& patch_id, const CapDrop& drop,
             double size)
      : stack_(stack), arcs_(arcs), patch_id_(patch_id), drop_(drop), size_(size), cells_(trace_cells(stack, arcs)) {
    number_volumes();
  }

  Hex_mesh run() {
    constexpr int tries = 5;
    Arc_intervals intervals(arcs_, size_);
    for (const Cell& cell : cells_) corners_.push_back(quadrangle_corners(stack_, arcs_, cell));
    for (int i = 0; i < tries; ++i) {
      balance_quadrangles(cells_, corners_, intervals);
      const std::vector<std::size_t> too_coarse = mesh_all(intervals);
      const bool all_meshed = number_of_meshed_ == cells_.size();
      if (too_coarse.empty() || (all_meshed && i + 1 == tries)) return std::move(mesh_);
      for (std::size_t c : too_coarse) refine(cells_[c], intervals);
    }
    fail(Status_code::hex_mesh_failed, Stage::hex_mesh, "the outline of a cap is too fine to be meshed at this size");
  }

 private:
  using Nodes = Arc_nodes<CapDrop>;
  using Drop = std::function<Vec3(const Vec3&)>;

  // Sub-volumes ascend by the id of their target, as in a decomposition.
  void number_volumes() {
    for (const Cell& cell : cells_) targets_.push_back(cell.target);
    const auto by_id = [&](Patch_index a, Patch_index b) {
      return std::pair(patch_id_[a.value()], a) < std::pair(patch_id_[b.value()], b);
    };
    std::sort(targets_.begin(), targets_.end(), by_id);
    targets_.erase(std::unique(targets_.begin(), targets_.end()), targets_.end());
    for (Patch_index target : targets_) mesh_.targets.push_back(patch_id_[target.value()]);
  }

  static void refine(const Cell& cell, Arc_intervals& intervals) {
    for (const Cell::Loop& loop : cell.loops[0])
      for (Arc_stack::Half_arc h : loop) intervals.add(cell.top, h, intervals(cell.top, h));
  }

  // Returns the cells whose outline is too coarse: they can't be meshed, or come out folded or nearly so.
  std::vector<std::size_t> mesh_all(const Arc_intervals& intervals) {
    constexpr double bad = 0.02;
    std::vector<std::size_t> too_coarse;
    number_of_meshed_ = 0;
    const std::vector<int> targets = mesh_.targets;
    mesh_ = Hex_mesh();
    mesh_.targets = targets;
    Nodes nodes(stack_, arcs_, intervals, drop_);
    std::vector<std::vector<std::vector<std::uint32_t>>> outlines(cells_.size());  // by cell and layer from the bottom
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (std::size_t k = cells_[c].bottom; k <= cells_[c].top; ++k) {
        outlines[c].emplace_back();
        for (const Cell::Loop& loop : cells_[c].loops[cells_[c].top - k])
          for (std::uint32_t n : nodes.around(k, loop)) outlines[c].back().push_back(n);
      }
    if (stack_.is_straight) Even_heights(stack_, arcs_, nodes).run();
    mesh_.points = nodes.points;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (mesh_cell(c, intervals, outlines[c]) < bad) too_coarse.push_back(c);
    return too_coarse;
  }

  Quad_region region_of(std::size_t c, std::size_t layer, const Arc_intervals& intervals,
                        const std::vector<Vec3>& outline) const {
    const Cell& cell = cells_[c];
    const Plane_chart plane(stack_.layers[layer].up);
    Quad_region region;
    std::size_t at = 0;
    for (const Cell::Loop& loop : cell.loops[0]) {
      auto& made = region.loops.emplace_back();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const bool is_corner = region.loops.size() == 1 && std::count(corners_[c].begin(), corners_[c].end(), i) > 0;
        if (is_corner) made.corners.push_back(made.nodes.size());
        for (std::size_t k = 0; k < intervals(cell.top, loop[i]); ++k) made.nodes.push_back(plane(outline[at++]));
      }
    }
    return region;
  }

  // Returns the least scaled Jacobian.
  double mesh_cell(std::size_t c, const Arc_intervals& intervals,
                   const std::vector<std::vector<std::uint32_t>>& outlines) {
    constexpr double good = 0.3;
    const Cell& cell = cells_[c];
    std::vector<std::vector<Vec3>> points;
    std::vector<double> heights;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      points.emplace_back();
      for (std::uint32_t n : outlines[k]) points.back().push_back(mesh_.points[n]);
      heights.push_back(stack_.layers[cell.bottom + k].value);
    }
    const Drop to_target = [&](const Vec3& p) { return drop_(cell.target, p, stack_.layers[cell.bottom].up); };
    const Drop to_source = [&](const Vec3& p) { return drop_(cell.source, p, stack_.layers[cell.top].up); };
    Quad_mesh quads;
    Cell_nodes nodes;
    double best = -2;
    // The layer on which the cap's mesh is made matters where the cell widens or bends.
    for (std::size_t k : {outlines.size() - 1, std::size_t(0), outlines.size() / 2}) {
      auto made = mesh_quads(region_of(c, cell.bottom + k, intervals, points[k]), size_);
      if (!made) continue;
      Cell_nodes swept = sweep_cell(*made, points, heights, to_target, to_source);
      const double quality = worst_quality(*made, swept);
      if (quality <= best) continue;
      best = quality;
      quads = std::move(*made);
      nodes = std::move(swept);
      if (best >= good) break;
    }
    if (best == -2) return best;
    add_cell(c, intervals, outlines, quads, nodes);
    ++number_of_meshed_;
    return best;
  }

  void add_cell(std::size_t c, const Arc_intervals& intervals, const std::vector<std::vector<std::uint32_t>>& outlines,
                const Quad_mesh& quads, const Cell_nodes& nodes) {
    const Cell& cell = cells_[c];
    const int volume = static_cast<int>(std::find(targets_.begin(), targets_.end(), cell.target) - targets_.begin());
    std::vector<std::vector<std::uint32_t>> number = outlines;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t i = outlines[k].size(); i < nodes[k].size(); ++i) {
        number[k].push_back(static_cast<std::uint32_t>(mesh_.points.size()));
        mesh_.points.push_back(nodes[k][i]);
      }
    for (std::size_t k = 0; k + 1 < number.size(); ++k)
      for (const auto& [a, b, d, e] : quads.quads) {
        const auto &low = number[k], &high = number[k + 1];
        mesh_.hexes.push_back({low[a], low[b], low[d], low[e], high[a], high[b], high[d], high[e]});
        mesh_.volume.push_back(volume);
      }
    const auto add_quad = [&](std::array<std::uint32_t, 4> quad, Patch_index patch, Role role) {
      mesh_.boundary.push_back({quad, patch_id_[patch.value()], role, volume});
    };
    for (const auto& [a, b, d, e] : quads.quads) {
      const auto &low = number.front(), &high = number.back();
      add_quad({low[a], low[e], low[d], low[b]}, cell.target, Role::target);
      add_quad({high[a], high[b], high[d], high[e]}, cell.source, Role::source);
    }
    add_walls(cell, intervals, outlines, add_quad);
  }

  template <class AddQuad>
  void add_walls(const Cell& cell, const Arc_intervals& intervals,
                 const std::vector<std::vector<std::uint32_t>>& outlines, const AddQuad& add_quad) const {
    for (std::size_t k = cell.bottom + 1; k <= cell.top; ++k) {
      const auto &low = outlines[k - 1 - cell.bottom], &high = outlines[k - cell.bottom];
      std::size_t first = 0;
      for (const Cell::Loop& loop : cell.loops[cell.top - k]) {
        std::size_t length = 0, at = 0;
        for (auto h : loop) length += intervals(k, h);
        for (auto h : loop) {
          const Patch_index wall = arcs_.arc(k, h).wall[h % 2];
          for (std::size_t i = 0; i < intervals(k, h); ++i, ++at)
            if (const std::size_t a = first + at, b = first + (at + 1) % length; wall.is_valid())
              add_quad({low[a], low[b], high[b], high[a]}, wall, Role::linking);
        }
        first += length;
      }
    }
  }

  const Layer_stack& stack_;
  const Arc_stack& arcs_;
  const std::vector<int>& patch_id_;
  const CapDrop& drop_;
  double size_;
  std::vector<Cell> cells_;
  std::vector<std::vector<std::size_t>> corners_;  // by cell
  std::vector<Patch_index> targets_;               // by sub-volume
  std::size_t number_of_meshed_ = 0;               // cells
  Hex_mesh mesh_;
};

/// Fails with the place of a hexahedron that can't be shown to be positive everywhere.
inline void certify(const Hex_mesh& mesh) {
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h) {
    const Hex_corners corners = corners_of(mesh, h);
    if (scaled_jacobian(corners) > 0 && is_positive(corners)) continue;
    const int target = mesh.targets[mesh.volume[h]];
    Vec3 middle{};
    for (const Vec3& p : corners) middle = middle + 0.125 * p;
    fail(Status_code::hex_mesh_failed, Stage::hex_mesh,
         "a hexahedron of the sub-volume on target " + std::to_string(target) + " is folded; another size may help",
         {target}, middle);
  }
}

}  // namespace internal

/// Meshes a part with hexahedra: each cell of the arc stack gets a quad mesh that is swept from its source to its
/// target. The mesh conforms by construction, as arcs have their nodes once.
///
/// \param patch_id the id of each patch of the part
/// \param drop_to_cap as in `make_arc_stack()`
/// \param size the edge length wanted
/// \return the mesh; throws `internal::Failure` where a hexahedron would not be positive.
/// Complexity: linear in the hexahedra, and one sparse factorisation for each cell.
template <class CapDrop>
Hex_mesh make_hex_mesh(const Layer_stack& stack, const Arc_stack& arcs, const std::vector<int>& patch_id,
                       const CapDrop& drop_to_cap, double size) {
  Hex_mesh mesh = internal::Hex_mesher<CapDrop>(stack, arcs, patch_id, drop_to_cap, size).run();
  internal::certify(mesh);
  return mesh;
}

}  // namespace CCSweep

#endif
