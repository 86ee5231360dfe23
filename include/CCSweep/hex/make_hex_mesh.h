// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MAKE_HEX_MESH_H
#define CCSWEEP_HEX_MAKE_HEX_MESH_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Arc_intervals.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Best_try.h>
#include <CCSweep/hex/Cell_mesher.h>
#include <CCSweep/hex/Cell_outlines.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/Given_nodes.h>
#include <CCSweep/hex/Hex_builder.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/Parity_intervals.h>
#include <CCSweep/hex/bound_by_angles.h>
#include <CCSweep/hex/certify.h>
#include <CCSweep/hex/change_intervals.h>
#include <CCSweep/hex/given_arcs.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex/sizing.h>
#include <CCSweep/hex/smooth_hexes.h>
#include <CCSweep/hex/wanted_intervals.h>
#include <CCSweep/internal/guarded.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// Meshes all cells of a part, with the nodes on their arcs shared.
template <class CapDrop, SizingField Sizing, IntervalSolver Solver, QuadMesher Quads>
class Hex_mesher {
 public:
  Hex_mesher(const Layer_stack& layers, const Arc_stack& arcs, const std::vector<int>& patch_id, const CapDrop& drop,
             const Sizing& sizing, const Solver& solver, const Quads& mesh_quads, const Given_nodes& given)
      : stack_(layers, arcs, patch_id), given_(given_arcs(stack_, given)), drop_(drop), sizing_(sizing),
        solver_(solver), mesh_quads_(mesh_quads) {}

  /// The best mesh of a few tries: bad cells get even numbers of intervals, so that they can be subdivided; then
  /// smaller quads inside them; then more intervals. More hexahedra must be worth it.
  Hex_mesh run() {
    constexpr double whole = 1, quarter = 0.25, small_gain = 0.01, large_gain = 0.05;
    constexpr int refinements = 3;
    Arc_intervals as_wanted = wanted_intervals(stack_, sizing_);
    give_intervals(given_, as_wanted);
    Arc_intervals changed = as_wanted;
    Best_try best;
    Hex_try last = mesh_all(as_wanted, whole);
    if (best.show(last, small_gain, good)) return best.take();
    make_even(stack_, last.quality, good, changed);
    last = mesh_all(changed, whole);
    if (best.show(last, small_gain, acceptable)) return best.take();
    refine(stack_, last.quality, acceptable, last.outlines, changed);
    last = mesh_all(as_wanted, quarter);
    if (best.show(last, small_gain, acceptable)) return best.take();
    for (int i = 0; i < refinements; ++i) {
      last = mesh_all(changed, quarter);
      if (best.show(last, large_gain, acceptable) || best.has_grown()) return best.take();
      refine(stack_, last.quality, acceptable, last.outlines, changed);
    }
    if (best.empty()) refuse(last.quality);
    return best.take();
  }

 private:
  // Scaled Jacobians: below the one a mesh is tried again, up to the other its nodes are moved.
  static constexpr double acceptable = 0.2, good = 0.4, fine = 0.5;

  // There is a cell that has got no mesh.
  [[noreturn]] void refuse(const std::vector<double>& quality) const {
    const auto worst = std::min_element(quality.begin(), quality.end());
    const Cell& cell = stack_.cells[static_cast<std::size_t>(worst - quality.begin())];
    fail(Status_code::hex_mesh_failed, Stage::hex_mesh, "the outline of a cap is too fine to be meshed at this size",
         {stack_.id(cell.target), stack_.id(cell.source)}, stack_.arcs.arc(cell.top, cell.loops[0][0][0]).line[0]);
  }

  // The cells one by one, then all bad hexahedra together.
  Hex_try mesh_all(Arc_intervals& intervals, double smallest) const {
    intervals.solve(stack_.cells, stack_.turns, solver_);
    Hex_try made{Cell_outlines(stack_, intervals, drop_, given_), {}, {}};
    Hex_mesh& mesh = made.mesh;
    mesh.points = made.outlines.points();
    for (Patch_index target : stack_.targets) {
      mesh.targets.push_back(stack_.id(target));
      mesh.directions.push_back(stack_.up_at(target));
    }
    std::vector<Patch_index> patch;       // by boundary quad
    std::vector<std::size_t> first{0};    // hexahedron, by cell
    std::vector<Angle_bound> bounds;     // by cell
    Hex_builder builder(stack_, made.outlines, mesh, patch);
    for (std::size_t c = 0; c < stack_.cells.size(); ++c) {
      bounds.push_back(bound_on(c, made.outlines));
      if (const Cell_mesh cell = mesh_cell(c, made.outlines, attainable(bounds[c], acceptable), smallest);
          !cell.empty())
        builder.add(c, cell);
      first.push_back(mesh.hexes.size());
    }
    mesh.bounds = tightest_by_volume(bounds);
    made.quality = least_by_cell(first, Hex_smoother(mesh, patch, drop_to_caps()).run(fine));
    made.outlines.move_to(mesh.points);
    return made;
  }

  Cell_mesh mesh_cell(std::size_t c, const Cell_outlines& outlines, double wanted, double smallest) const {
    const Cell& cell = stack_.cells[c];
    const double size = size_between(sizing_, {stack_.id(cell.source), stack_.id(cell.target)});
    return Cell_mesher(stack_, c, outlines, drop_to(cell.target), drop_to(cell.source))
        .run(mesh_quads_, size, wanted, smallest);
  }

  Angle_bound bound_on(std::size_t c, const Cell_outlines& outlines) const {
    const auto at = [&](Patch_index cap) { return bound_by_angles(stack_, c, cap, outlines, drop_to(cap)); };
    const Angle_bound below = at(stack_.cells[c].target), above = at(stack_.cells[c].source);
    return above.scaled_jacobian < below.scaled_jacobian ? above : below;
  }

  std::vector<Angle_bound> tightest_by_volume(const std::vector<Angle_bound>& by_cell) const {
    std::vector<Angle_bound> tightest(stack_.targets.size());
    for (std::size_t c = 0; c < stack_.cells.size(); ++c)
      if (Angle_bound& of_volume = tightest[stack_.volume_of(stack_.cells[c])];
          by_cell[c].scaled_jacobian < of_volume.scaled_jacobian)
        of_volume = by_cell[c];
    return tightest;
  }

  static std::vector<double> least_by_cell(const std::vector<std::size_t>& first, const std::vector<double>& quality) {
    std::vector<double> least(first.size() - 1, -2);
    for (std::size_t c = 0; c + 1 < first.size(); ++c)
      if (first[c] < first[c + 1])
        least[c] = *std::min_element(quality.begin() + static_cast<std::ptrdiff_t>(first[c]),
                                     quality.begin() + static_cast<std::ptrdiff_t>(first[c + 1]));
    return least;
  }

  auto drop_to_caps() const {
    return [this](Patch_index cap, const Vec3& p) { return drop_(cap, p, stack_.up_at(cap)); };
  }
  auto drop_to(Patch_index cap) const {
    return [drop = drop_to_caps(), cap](const Vec3& p) { return drop(cap, p); };
  }

  Cell_stack stack_;
  std::vector<Given_arc> given_;
  const CapDrop& drop_;
  const Sizing& sizing_;
  const Solver& solver_;
  const Quads& mesh_quads_;
};

}  // namespace internal

/// Meshes a part with hexahedra: each cell of the arc stack gets a quad mesh that is swept from its source to its
/// target. The mesh conforms by construction, as arcs have their nodes once.
///
/// \param patch_id the id of each patch of the part
/// \param drop_to_cap as in `make_arc_stack()`
/// \param sizing the edge lengths wanted
/// \param solver what chooses the numbers of intervals
/// \param mesh_quads what meshes a section of a cell; where it can not, triangles are subdivided
/// \param given nodes on walls that another mesh has already
/// \return the mesh; throws `internal::Failure` where a hexahedron would not be positive.
/// Complexity: linear in the hexahedra, and one sparse factorisation for each cell.
template <class CapDrop, SizingField Sizing, IntervalSolver Solver = Parity_intervals, QuadMesher Quads = Best_quads>
Hex_mesh make_hex_mesh(const Layer_stack& stack, const Arc_stack& arcs, const std::vector<int>& patch_id,
                       const CapDrop& drop_to_cap, const Sizing& sizing, const Solver& solver = {},
                       const Quads& mesh_quads = {}, const internal::Given_nodes& given = {}) {
  internal::Hex_mesher mesher(stack, arcs, patch_id, drop_to_cap, sizing, solver, mesh_quads, given);
  Hex_mesh mesh = mesher.run();
  internal::certify(mesh);
  return mesh;
}

}  // namespace CCSweep

#endif
