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
#include <CCSweep/hex/quality.h>
#include <CCSweep/hex/sizing.h>
#include <CCSweep/internal/Input.h>
#include <CCSweep/internal/Options.h>
#include <CCSweep/internal/Pipeline.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/internal/outer_mesh.h>
#include <CCSweep/linking/divide_walls.h>
#include <CCSweep/part/assign_roles.h>
#include <CCSweep/volumes/Decomposition.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
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

/// The least scaled Jacobian of a mesh.
inline double least_quality(const Hex_mesh& mesh) {
  const std::vector<double> quality = scaled_jacobians(mesh);
  return *std::min_element(quality.begin(), quality.end());
}

/// Keeps the mesh with the best worst hexahedron of those it is shown; if there is none, the first failure.
class Best_mesh {
 public:
  /// \param good what makes further meshes needless
  explicit Best_mesh(double good) : good_(good) {}

  /// \return whether it is so good that no other one is needed
  bool show(Result<Hex_mesh> result) {
    if (!result) {
      if (result.status().code == Status_code::cancelled) throw Failure{result.status()};
      if (!first_failure_) first_failure_ = result.status();
      return false;
    }
    if (const double quality = least_quality(result.value()); !mesh_ || quality > quality_) {
      quality_ = quality;
      mesh_ = std::move(result).value();
    }
    return quality_ >= good_;
  }

  Hex_mesh take() {
    if (!mesh_) throw Failure{*first_failure_};
    return std::move(*mesh_);
  }

 private:
  double good_;
  std::optional<Hex_mesh> mesh_;
  double quality_ = 0;
  std::optional<Status> first_failure_;
};

/// The direction in which a sub-volume leads away from its target.
template <class Point>
std::array<double, 3> direction_of(const Sub_volume<Point>& volume) {
  using Volume = Sub_volume<Point>;
  const auto& mesh = volume.mesh;
  const auto role = mesh.template property_map<typename Volume::Mesh::Face_index, int>(Volume::role_map).first;
  const auto place = [&](auto v) {
    const Point& p = mesh.point(v);
    return Vec3{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  };
  Vec3 sum{};
  for (auto f : mesh.faces()) {
    if (role[f] != static_cast<int>(Role::target)) continue;
    const auto h = mesh.halfedge(f);
    const Vec3 a = place(mesh.source(h)), b = place(mesh.target(h)), c = place(mesh.target(mesh.next(h)));
    sum = sum - cross(b - a, c - a);
  }
  return sum;
}

/// Tries the possible roles, those first that look best, till one gives a mesh that will do; else takes the best.
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
    if (candidates.size() == 1) return mesh(candidates[0]);
    constexpr double acceptable = 0.2;
    Best_mesh best(acceptable);
    for (const Roles& roles : candidates)
      if (best.show(guarded([&] { return mesh(roles); }))) break;
    return best.take();
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
    if (const std::optional<Part<Traits>> divided = divide_flat_facets(part_, roles))
      return Hex_pipeline(*divided, options_, policies_, visitor_).mesh_with_layers(roles);
    return mesh_with_layers(roles);
  }

  // Where layers can't be imprinted, or a column is lost between two of them, others are tried, as `decompose()` does.
  Hex_mesh mesh_with_layers(const Roles& roles) {
    constexpr std::array<Refinement, 7> refinements{
        {{}, {.through_vertices = true}, {.divides_walls = true}, {.times_slabs = 2}, {.times_slabs = 4}, {.reach = 10}, {.reach = 50}}};
    std::optional<Part<Traits>> finer;
    std::optional<Status> failure;
    for (const Refinement& refinement : refinements) {
      if (refinement.divides_walls && !(finer = divide_walls(part_, roles))) continue;
      Result<Hex_mesh> attempt = guarded([&] {
        if (refinement.divides_walls) return Hex_pipeline(*finer, options_, policies_, visitor_).mesh(roles, refinement);
        return mesh(roles, refinement);
      });
      if (attempt) return std::move(attempt).value();
      if (!failure || attempt.status().code == Status_code::cancelled) failure = attempt.status();
      if (!is_of_layers(failure->code)) throw Failure{*failure};
    }
    if (failure->stage == Stage::hex_mesh) failure->code = Status_code::hex_mesh_failed;
    throw Failure{*failure};
  }

  static bool is_of_layers(Status_code code) {
    return code == Status_code::projection_folded || code == Status_code::imprint_failed ||
           code == Status_code::inconsistent_levels;
  }

  Hex_mesh mesh(const Roles& roles, const Refinement& refinement) {
    Layering_options layers = options_.layering;
    layers.spacing = size_;
    layers.through_vertices = refinement.through_vertices;
    layers.slabs *= refinement.times_slabs;
    const double tolerance = options_.tolerance * part_.diagonal;
    const Layering layering = run_(Stage::layers, [&] { return make_layering(part_, roles, layers); });
    const Wall_sections sections =
        run_(Stage::linking_mesh, [&] { return make_wall_sections(part_, roles, layering); });
    const Layered_loops<Traits> loops = run_(Stage::loop_faces, [&] {
      return sweep_layers<Traits, SegmentIndex, PointIndex>(part_, roles, layering, sections, tolerance,
                                                            options_.neighbours, visitor_,
                                                            refinement.reach * tolerance);
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
template <class T>
inline constexpr bool is_sub_volume = false;
template <class Point>
inline constexpr bool is_sub_volume<Sub_volume<Point>> = true;

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
  requires(!internal::is_decomposition<FaceGraph> && !internal::is_sub_volume<FaceGraph>) && SweepMesh<FaceGraph>
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

/// Meshes one sub-volume by itself, in the direction that suits it best: its own, from its target to its sources, or if
/// no good mesh comes of that, any other in which it can be swept. Its cuts then are faces like all others, so the mesh
/// need not conform to those of its neighbours.
/// \param np a sequence of named parameters; `size` is needed
template <class Point, class NamedParameters>
Result<Hex_mesh> hex_mesh(const Sub_volume<Point>& volume, const NamedParameters& np) {
  return internal::guarded([&] {
    constexpr double good = 0.4;
    using Volume = Sub_volume<Point>;
    const auto patch =
        volume.mesh.template property_map<typename Volume::Mesh::Face_index, int>(Volume::patch_id_map).first;
    internal::Best_mesh best(good);
    if (!best.show(hex_mesh(volume.mesh, np.direction(internal::direction_of(volume))
                                             .sources(volume.sources)
                                             .targets(std::vector<int>{volume.target})
                                             .face_patch_map(patch))))
      best.show(hex_mesh(volume.mesh, np.face_patch_map(patch)));
    return best.take();
  });
}

}  // namespace CCSweep

#endif
