// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MESH_H
#define CCSWEEP_HEX_MESH_H

#include <CCSweep/Status.h>
#include <CCSweep/concepts.h>
#include <CCSweep/hex/Cap_drop.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/Parity_intervals.h>
#include <CCSweep/hex/make_arc_stack.h>
#include <CCSweep/hex/make_hex_mesh.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex/sizing.h>
#include <CCSweep/internal/Input.h>
#include <CCSweep/internal/Options.h>
#include <CCSweep/internal/Pipeline.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/internal/outer_mesh.h>
#include <CCSweep/part/assign_roles.h>
#include <CCSweep/volumes/Decomposition.h>

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// The policies of a call.
template <class Sizing, class Solver, class Quads>
struct Hex_policies {
  Sizing sizing;
  Solver solver;
  Quads mesh_quads;
};

inline Patch_sizes to_sizing(double size) { return size; }
template <SizingField Sizing>
  requires(!std::is_arithmetic_v<Sizing>)
Sizing to_sizing(const Sizing& sizing) {
  return sizing;
}

/// Tries the possible roles, best first, till one gives a mesh.
template <class Traits, class SegmentIndex, class PointIndex, class Visitor, class Policies>
class Hex_pipeline {
 public:
  Hex_pipeline(const Part<Traits>& part, const Options& options, const Policies& policies, Visitor& visitor)
      : part_(part), options_(options), policies_(policies), size_(policies.sizing.on_part()), visitor_(visitor),
        run_(visitor) {}

  Hex_mesh operator()() {
    check_size();
    const std::vector<Roles> candidates =
        run_(Stage::roles, [&] { return assign_roles(part_, options_.roles); });
    std::optional<Status> first_failure;
    for (const Roles& roles : candidates) {
      Result<Hex_mesh> attempt = guarded([&] { return mesh(roles); });
      if (attempt) return std::move(attempt).value();
      if (attempt.status().code == Status_code::cancelled) throw Failure{attempt.status()};
      if (!first_failure) first_failure = attempt.status();
    }
    throw Failure{*first_failure};
  }

 private:
  // Far more hexahedra than fit a computer are a slip of the pen, not a wish.
  void check_size() const {
    constexpr double most = 5e7;
    if (!policies_.sizing.are_valid() || !std::isfinite(size_) || !(size_ > 0))
      fail(Status_code::invalid_parameter, Stage::hex_mesh, "every size must be a number above 0");
    const double smallest = size_between(policies_.sizing, part_.patch_id);
    double volume = 0;
    for (auto f : part_.mesh.faces()) {
      const auto h = part_.mesh.halfedge(f);
      volume += dot(part_.coordinates(part_.mesh.source(h)) - part_.coordinates(*part_.mesh.vertices().begin()),
                    part_.area[f] * part_.normal[f]) / 3;
    }
    if (!(volume / size_ / size_ / size_ <= most) || !(part_.diagonal / smallest <= std::sqrt(most)))
      fail(Status_code::invalid_parameter, Stage::hex_mesh, "at this size there would be too many hexahedra");
  }

  Hex_mesh mesh(const Roles& roles) {
    Layering_options layers = options_.layering;
    layers.spacing = size_;
    const double tolerance = options_.tolerance * part_.diagonal;
    const Layering layering = run_(Stage::layers, [&] { return make_layering(part_, roles, layers); });
    const Wall_sections sections =
        run_(Stage::linking_mesh, [&] { return make_wall_sections(part_, roles, layering); });
    const Layered_loops<Traits> loops = run_(Stage::loop_faces, [&] {
      return sweep_layers<Traits, SegmentIndex, PointIndex>(part_, roles, layering, sections, tolerance,
                                                            options_.neighbours, visitor_);
    });
    return run_(Stage::hex_mesh, [&] {
      return guarded([&] {
        const Layer_stack stack = make_layer_stack(layering, loops, roles.is_straight(), tolerance);
        const Cap_drop<Traits> drop(part_);
        const Arc_stack arcs = make_arc_stack(stack, drop);
        return make_hex_mesh(stack, arcs, part_.patch_id, drop, policies_.sizing, policies_.solver,
                             policies_.mesh_quads);
      });
    });
  }

  const Part<Traits>& part_;
  const Options& options_;
  const Policies& policies_;
  double size_;
  Visitor& visitor_;
  Stage_runner<Visitor> run_;
};

template <class T>
inline constexpr bool is_decomposition = false;
template <class Point>
inline constexpr bool is_decomposition<Decomposition<Point>> = true;

}  // namespace internal

/// Meshes a multi-sweep part with hexahedra, conformal across all the sub-volumes that `decompose()` would make of it.
///
/// The layers of the decomposition, with further ones at the size asked for, are cut into columns of one source and one
/// target each; one quad mesh of a column's section is swept from its source to its target. Neighbouring columns share
/// the nodes between them. Nodes on the boundary lie on the facets of the part.
///
/// \tparam FaceGraph a model of `SweepMesh`, with what `decompose()` asks of it
/// \param np a sequence of named parameters, see `CCSweep::parameters`; `face_patch_map` and `size` are needed
///
/// \return the mesh, every hexahedron of which has a positive Jacobian determinant everywhere; or a status that names
/// stage, patches and place. `hex_mesh_failed` if a hexahedron would fold, `invalid_parameter` for a size that is no
/// positive number or absurdly small.
/// The sizes are a number or a `SizingField`, for example `Patch_sizes(2).patch(7, 0.5)`.
/// Complexity: linear in the hexahedra, and one sparse factorisation for each column's section.
template <class FaceGraph, class NamedParameters>
  requires(!internal::is_decomposition<FaceGraph> && SweepMesh<FaceGraph>)
Result<Hex_mesh> hex_mesh(const FaceGraph& mesh, const NamedParameters& np) {
  using Call = internal::Call<FaceGraph, NamedParameters>;
  using Traits = typename Call::Traits;
  return internal::guarded([&] {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    auto&& visitor = Call::visitor(np);
    const internal::Options options = internal::unpack(np);
    const internal::Hex_policies policies{
        internal::to_sizing(choose_parameter(get_parameter(np, CGAL::internal_np::size), 0.0)),
        choose_parameter(get_parameter(np, internal_np::interval_solver), Parity_intervals()),
        choose_parameter(get_parameter(np, internal_np::quad_mesher), Best_quads())};
    const Part<Traits> part = internal::read_input<Traits>(mesh, Call::points(mesh, np), Call::patches(np));
    return internal::Hex_pipeline<Traits, typename Call::Segment_index, typename Call::Point_index,
                                  std::remove_reference_t<decltype(visitor)>, std::remove_const_t<decltype(policies)>>(
        part, options, policies, visitor)();
  });
}

/// Meshes a decomposition with hexahedra at any size: the part it was made of, in the same sense and with the same
/// caps.
/// \param np a sequence of named parameters; `size` is needed, roles and direction are those of the decomposition
template <class Point, class NamedParameters>
Result<Hex_mesh> hex_mesh(const Decomposition<Point>& decomposition, const NamedParameters& np) {
  return internal::guarded([&] {
    const auto outer = internal::outer_mesh(decomposition);
    std::vector<int> sources, targets;
    for (const auto& [patch, role] : decomposition.roles) {
      if (role == Role::source) sources.push_back(patch);
      if (role == Role::target) targets.push_back(patch);
    }
    return internal::value_or_fail(hex_mesh(outer.mesh, np.direction(decomposition.direction)
                                                            .sources(sources)
                                                            .targets(targets)
                                                            .face_patch_map(outer.patch_ids())));
  });
}

}  // namespace CCSweep

#endif
