// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MAKE_HEX_MESH_H
#define CCSWEEP_HEX_MAKE_HEX_MESH_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_nodes.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Cell_sweeper.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/Parity_intervals.h>
#include <CCSweep/hex/angle_bound.h>
#include <CCSweep/hex/cell_turns.h>
#include <CCSweep/hex/even_heights.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex/outline_faults.h>
#include <CCSweep/hex/plane.h>
#include <CCSweep/hex/sizing.h>
#include <CCSweep/hex/smooth_hexes.h>
#include <CCSweep/hex/trace_cells.h>
#include <CCSweep/internal/guarded.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// Makes room for further elements: for no more than these where that is much, so that a large cell fills no more
/// memory than it needs, but for many small cells at once.
template <class T>
void reserve_more(std::vector<T>& list, std::size_t count) {
  const std::size_t wanted = list.size() + count;
  if (wanted > list.capacity()) list.reserve(std::max(wanted, list.size() + list.size() / 2));
}

/// Meshes all cells of a part, with the nodes on their arcs shared.
template <class CapDrop, SizingField Sizing, IntervalSolver Solver, QuadMesher Quads>
class Hex_mesher {
 public:
  Hex_mesher(const Layer_stack& stack, const Arc_stack& arcs, const std::vector<int>& patch_id, const CapDrop& drop,
             const Sizing& sizing, const Solver& solver, const Quads& mesh_quads)
      : stack_(stack), arcs_(arcs), patch_id_(patch_id), drop_(drop), sizing_(sizing), solver_(solver),
        mesh_quads_(mesh_quads), cells_(trace_cells(stack, arcs)) {
    number_volumes();
    for (const Cell& cell : cells_) turns_.push_back(cell_turns(stack_, arcs_, cell));
  }

  /// The best mesh of a few tries: bad cells get even numbers of intervals, so that they can be subdivided; then
  /// smaller quads inside them; then more intervals.
  Hex_mesh run() {
    constexpr int tries = 6;
    Arc_intervals intervals(arcs_, [&](std::size_t k, const Arc_stack::Arc& arc) {
      return size_between(sizing_, patches_of(k, arc));
    });
    Arc_intervals as_wanted = intervals;
    Hex_mesh best;
    double best_quality = -2;
    std::size_t most = 0;
    for (int i = 0; i < tries; ++i) {
      Arc_intervals& tried = i == 2 ? as_wanted : intervals;
      finest_ = i < 2 ? 1 : 0.25;
      tried.solve(cells_, turns_, solver_);
      const std::vector<double> quality = mesh_all(tried);
      const double worst = *std::min_element(quality.begin(), quality.end());
      // More hexahedra must be worth it.
      const bool is_better =
          best_quality <= 0 ? worst > best_quality : worst > best_quality + (i < 3 ? small_gain : large_gain);
      if (is_better) best_quality = worst;
      if (most == 0 && worst > -2) most = growth * mesh_.hexes.size();
      const bool is_done =
          best_quality >= (i == 0 ? good : acceptable) || (most > 0 && mesh_.hexes.size() > most);
      if (!is_done && i == 0) make_even(quality, intervals);
      if (!is_done && (i == 1 || i > 2)) refine(quality, intervals);
      if (is_better) best = std::move(mesh_);
      if (is_done) break;
    }
    if (best_quality == -2)
      fail(Status_code::hex_mesh_failed, Stage::hex_mesh, "the outline of a cap is too fine to be meshed at this size");
    return best;
  }

 private:
  using Nodes = Arc_nodes<CapDrop>;
  using Drop = std::function<Vec3(const Vec3&)>;

  // Scaled Jacobians: below the one a mesh is tried again, up to the other its nodes are moved.
  static constexpr double acceptable = 0.2, good = 0.4, fine = 0.5, small_gain = 0.01, large_gain = 0.05;
  static constexpr std::size_t growth = 4;  // of the number of hexahedra from try to try

  // Sub-volumes ascend by the id of their target, as in a decomposition.
  void number_volumes() {
    for (const Cell& cell : cells_) targets_.push_back(cell.target);
    const auto by_id = [&](Patch_index a, Patch_index b) {
      return std::pair(patch_id_[a.value()], a) < std::pair(patch_id_[b.value()], b);
    };
    std::sort(targets_.begin(), targets_.end(), by_id);
    targets_.erase(std::unique(targets_.begin(), targets_.end()), targets_.end());
  }

  // The ids of the patches that an arc lies on.
  std::vector<int> patches_of(std::size_t layer, const Arc_stack::Arc& arc) const {
    std::vector<int> ids;
    const auto add = [&](Patch_index patch) {
      if (patch.is_valid()) ids.push_back(patch_id_[patch.value()]);
    };
    for (const auto* side : {&arc.left, &arc.right}) {
      add(side->source);
      if (side->target.is_valid() && stack_.layer_of_cap[side->target.value()] == layer) add(side->target);
    }
    for (Patch_index wall : arc.wall) add(wall);
    return ids;
  }

  void make_even(const std::vector<double>& quality, Arc_intervals& intervals) const {
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      if (quality[c] >= good) continue;
      for (const Cell::Loop& loop : cells_[c].loops[0])
        for (Arc_stack::Half_arc h : loop) intervals.make_even(cells_[c].top, h);
    }
  }

  // Several cells may want the same arcs refined, which is done once.
  void refine(const std::vector<double>& quality, Arc_intervals& intervals) const {
    std::set<std::size_t> too_coarse;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (quality[c] < acceptable) too_coarse.merge(arcs_to_refine(c, quality[c] > -2, intervals));
    for (std::size_t arc_class : too_coarse) intervals.refine(arc_class);
  }

  // The classes of the arcs at fault, else, of a cell that has a mesh, of those at narrow gaps, or of all where there
  // is none.
  std::set<std::size_t> arcs_to_refine(std::size_t c, bool has_mesh, const Arc_intervals& intervals) const {
    const Cell& cell = cells_[c];
    std::vector<Arc_stack::Half_arc> halves;
    for (const Cell::Loop& loop : cell.loops[0]) halves.insert(halves.end(), loop.begin(), loop.end());
    std::set<std::size_t> faults;
    for (const auto& find : {arcs_too_coarse, arcs_at_gaps}) {
      for (std::size_t k = cell.bottom; k <= cell.top; ++k) faults.merge(find(edges_of(c, k, intervals)));
      if (!faults.empty() || !has_mesh) break;
    }
    std::set<std::size_t> classes;
    for (std::size_t i = 0; i < halves.size(); ++i)
      if (faults.empty() || faults.count(i) > 0) classes.insert(intervals.arc_class(cell.top, halves[i]));
    return classes;
  }

  // The outline of a cell on a layer, as of the last try.
  std::vector<Outline_edge> edges_of(std::size_t c, std::size_t layer, const Arc_intervals& intervals) const {
    const Plane_chart plane(stack_.layers[layer].up);
    std::vector<Point2> nodes;
    for (std::uint32_t n : outlines_[c][layer - cells_[c].bottom]) nodes.push_back(plane(mesh_.points[n]));
    std::vector<Outline_edge> edges;
    std::size_t arc = 0;
    for (const Cell::Loop& loop : cells_[c].loops[0]) {
      const std::size_t first = edges.size();
      for (Arc_stack::Half_arc h : loop) {
        for (std::size_t i = 0; i < intervals(cells_[c].top, h); ++i)
          edges.push_back({nodes[edges.size()], {}, arc});
        ++arc;
      }
      for (std::size_t e = first; e < edges.size(); ++e) edges[e].b = nodes[e + 1 < edges.size() ? e + 1 : first];
    }
    return edges;
  }

  // Returns the least scaled Jacobian of each cell; -2 where it can't be meshed.
  std::vector<double> mesh_all(const Arc_intervals& intervals) {
    mesh_ = Hex_mesh();
    patch_.clear();
    for (Patch_index target : targets_) mesh_.targets.push_back(patch_id_[target.value()]);
    Nodes nodes(stack_, arcs_, intervals, drop_);
    outlines_.assign(cells_.size(), {});
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (std::size_t k = cells_[c].bottom; k <= cells_[c].top; ++k) {
        outlines_[c].emplace_back();
        for (const Cell::Loop& loop : cells_[c].loops[cells_[c].top - k])
          for (std::uint32_t n : nodes.around(k, loop)) outlines_[c].back().push_back(n);
      }
    if (stack_.is_straight) Even_heights(stack_, arcs_, nodes).run();
    mesh_.points = nodes.points;
    std::vector<std::size_t> first{0};  // hexahedron, by cell
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      bound_by_angles(c, intervals);
      mesh_cell(c, intervals, outlines_[c]);
      first.push_back(mesh_.hexes.size());
    }
    const std::vector<double> quality = smooth();
    std::vector<double> worst(cells_.size(), -2);
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (first[c] < first[c + 1])
        worst[c] = *std::min_element(quality.begin() + static_cast<std::ptrdiff_t>(first[c]),
                                     quality.begin() + static_cast<std::ptrdiff_t>(first[c + 1]));
    return worst;
  }

  std::vector<double> smooth() {
    const auto drop = [&](Patch_index cap, const Vec3& p) { return drop_to(cap)(p); };
    return Hex_smoother(mesh_, patch_, drop).run(fine);
  }

  auto drop_to(Patch_index cap) const {
    return [this, cap](const Vec3& p) { return drop_(cap, p, stack_.layers[stack_.layer_of_cap[cap.value()]].up); };
  }

  // Looks at the outlines of a cell's two caps.
  void bound_by_angles(std::size_t c, const Arc_intervals& intervals) {
    const Cell& cell = cells_[c];
    bound_by_angles_of_cap(c, cell.target, cell.bottom, cell.bottom + 1, intervals);
    bound_by_angles_of_cap(c, cell.source, cell.top, cell.top - 1, intervals);
  }

  void bound_by_angles_of_cap(std::size_t c, Patch_index cap, std::size_t layer, std::size_t next,
                              const Arc_intervals& intervals) {
    const Cell& cell = cells_[c];
    std::vector<std::size_t> loops;
    for (const Cell::Loop& loop : cell.loops[cell.top - layer]) loops.push_back(length_of(loop, layer, intervals));
    const std::size_t upper = std::max(layer, next);  // whose arcs know the walls between
    Angle_bound found =
        tightest_angle(outline_on(c, layer), only_on_walls(cell, upper, outline_on(c, next), intervals), loops,
                       Plane_chart(stack_.layers[layer].up), drop_to(cap), layer == cell.top);
    found.patch_id = patch_id_[cap.value()];
    if (found.scaled_jacobian < mesh_.tightest.scaled_jacobian) mesh_.tightest = found;
  }

  std::vector<Vec3> outline_on(std::size_t c, std::size_t layer) const {
    std::vector<Vec3> points;
    for (std::uint32_t n : outlines_[c][layer - cells_[c].bottom]) points.push_back(mesh_.points[n]);
    return points;
  }

  // Of the points of an outline those at the walls below the arcs of a layer.
  std::vector<std::optional<Vec3>> only_on_walls(const Cell& cell, std::size_t layer, const std::vector<Vec3>& points,
                                                 const Arc_intervals& intervals) const {
    std::vector<std::optional<Vec3>> result(points.size());
    std::size_t first = 0;
    for (const Cell::Loop& loop : cell.loops[cell.top - layer]) {
      const std::size_t length = length_of(loop, layer, intervals);
      std::size_t at = 0;
      for (Arc_stack::Half_arc h : loop) {
        const std::size_t end = at + intervals(layer, h);
        for (std::size_t i = at; i <= end && arcs_.arc(layer, h).wall[h % 2].is_valid(); ++i)
          result[first + i % length] = points[first + i % length];
        at = end;
      }
      first += length;
    }
    return result;
  }

  static std::size_t length_of(const Cell::Loop& loop, std::size_t layer, const Arc_intervals& intervals) {
    std::size_t length = 0;
    for (Arc_stack::Half_arc h : loop) length += intervals(layer, h);
    return length;
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
        const int turn = turns_[c].empty() ? 0 : turns_[c][i];
        if (turn > 0) made.corners.push_back(made.nodes.size());
        if (turn < 0) made.reflex.push_back(made.nodes.size());
        for (std::size_t k = 0; k < intervals(cell.top, loop[i]); ++k) made.nodes.push_back(plane(outline[at++]));
      }
    }
    return region;
  }

  void mesh_cell(std::size_t c, const Arc_intervals& intervals,
                   const std::vector<std::vector<std::uint32_t>>& outlines) {
    const Cell& cell = cells_[c];
    const double size = size_between(sizing_, {patch_id_[cell.source.value()], patch_id_[cell.target.value()]});
    std::vector<std::vector<Vec3>> points;
    std::vector<double> heights;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      points.push_back(outline_on(c, cell.bottom + k));
      heights.push_back(stack_.layers[cell.bottom + k].value);
    }
    const Drop to_target = drop_to(cell.target), to_source = drop_to(cell.source);
    Quad_mesh quads;
    Cell_nodes nodes;
    double best = -2;
    // The layer on which the cap's mesh is made matters where the cell widens or bends.
    const auto mesh_with = [&](const auto& mesher, double length) {
      for (std::size_t k : {outlines.size() - 1, std::size_t(0), outlines.size() / 2}) {
        auto made = mesher(region_of(c, cell.bottom + k, intervals, points[k]), length);
        if (!made) continue;
        Cell_nodes swept = sweep_cell(*made, points, heights, to_target, to_source);
        const double quality = worst_quality(*made, swept);
        if (quality <= best) continue;
        best = quality;
        quads = std::move(*made);
        nodes = std::move(swept);
        if (best >= good) break;
      }
    };
    // Smaller quads inside, where the edges of the outline are long beside its width.
    for (double share = 1; best < acceptable && share >= finest_; share /= 2) mesh_with(mesh_quads_, share * size);
    if (best == -2) mesh_with(Subdivided_quads(), size);  // whatever the policy can't do
    if (best > -2) add_cell(c, intervals, outlines, quads, nodes);
  }

  void add_cell(std::size_t c, const Arc_intervals& intervals, const std::vector<std::vector<std::uint32_t>>& outlines,
                const Quad_mesh& quads, const Cell_nodes& nodes) {
    const Cell& cell = cells_[c];
    const int volume = static_cast<int>(std::find(targets_.begin(), targets_.end(), cell.target) - targets_.begin());
    std::vector<std::vector<std::uint32_t>> number = outlines;
    reserve_more(mesh_.points, nodes.size() * (nodes[0].size() - outlines[0].size()));
    reserve_more(mesh_.hexes, (nodes.size() - 1) * quads.quads.size());
    reserve_more(mesh_.volume, (nodes.size() - 1) * quads.quads.size());
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
      patch_.push_back(patch);
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
        const std::size_t length = length_of(loop, k, intervals);
        std::size_t at = 0;
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
  const Sizing& sizing_;
  const Solver& solver_;
  const Quads& mesh_quads_;
  std::vector<Cell> cells_;
  std::vector<std::vector<int>> turns_;  // by cell
  std::vector<Patch_index> targets_;     // by sub-volume
  double finest_ = 1;  // of the quads inside a cap that may be tried, as a share of the size
  Hex_mesh mesh_;
  std::vector<std::vector<std::vector<std::uint32_t>>> outlines_;  // by cell and layer from the bottom: the nodes
  std::vector<Patch_index> patch_;       // by boundary quad
};

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

}  // namespace internal

/// Meshes a part with hexahedra: each cell of the arc stack gets a quad mesh that is swept from its source to its
/// target. The mesh conforms by construction, as arcs have their nodes once.
///
/// \param patch_id the id of each patch of the part
/// \param drop_to_cap as in `make_arc_stack()`
/// \param sizing the edge lengths wanted
/// \param solver what chooses the numbers of intervals
/// \param mesh_quads what meshes a section of a cell; where it can not, triangles are subdivided
/// \return the mesh; throws `internal::Failure` where a hexahedron would not be positive.
/// Complexity: linear in the hexahedra, and one sparse factorisation for each cell.
template <class CapDrop, SizingField Sizing, IntervalSolver Solver = Parity_intervals, QuadMesher Quads = Best_quads>
Hex_mesh make_hex_mesh(const Layer_stack& stack, const Arc_stack& arcs, const std::vector<int>& patch_id,
                       const CapDrop& drop_to_cap, const Sizing& sizing, const Solver& solver = {},
                       const Quads& mesh_quads = {}) {
  internal::Hex_mesher mesher(stack, arcs, patch_id, drop_to_cap, sizing, solver, mesh_quads);
  Hex_mesh mesh = mesher.run();
  internal::certify(mesh);
  return mesh;
}

}  // namespace CCSweep

#endif
