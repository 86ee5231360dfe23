// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_HEX_PIPELINE_H
#define CCSWEEP_INTERNAL_HEX_PIPELINE_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Best_mesh.h>
#include <CCSweep/hex/Cap_drop.h>
#include <CCSweep/hex/Given_nodes.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/make_arc_stack.h>
#include <CCSweep/hex/make_hex_mesh.h>
#include <CCSweep/hex/replace_volume.h>
#include <CCSweep/hex/sizing.h>
#include <CCSweep/internal/Options.h>
#include <CCSweep/internal/Pipeline.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/divide_walls.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/assign_roles.h>
#include <CCSweep/part/make_part.h>
#include <CCSweep/volumes/Decomposition.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The policies of a call.
template <class Sizing, class Solver, class Quads>
struct Hex_policies {
  Sizing sizing;
  Solver solver;
  Quads mesh_quads;
};

/// Tries the possible roles, those first that look best, till one gives a mesh that will do; else takes the best.
template <class Traits, class SegmentIndex, class PointIndex, class Visitor, class Policies>
class Hex_pipeline {
  using Volume = Sub_volume<typename Traits::Point_3>;

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
    constexpr std::array<Refinement, 7> refinements{{{},
                                                     {.through_vertices = true},
                                                     {.divides_walls = true},
                                                     {.times_slabs = 2},
                                                     {.times_slabs = 4},
                                                     {.reach = 10},
                                                     {.reach = 50}}};
    std::optional<Part<Traits>> finer;
    std::optional<Status> failure;
    for (const Refinement& refinement : refinements) {
      if (refinement.divides_walls && !(finer = divide_walls(part_, roles))) continue;
      Result<Hex_mesh> attempt = guarded([&] {
        if (!refinement.divides_walls) return mesh(roles, refinement);
        return Hex_pipeline(*finer, options_, policies_, visitor_).mesh(roles, refinement);
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

  // All sub-volumes by one sweep; then, as the paper does after decomposing (3.1), those that it does not suit by
  // sweeps of their own.
  Hex_mesh mesh(const Roles& roles, const Refinement& refinement) {
    Swept_layers<Traits> swept = sweep_along(roles, refinement, {});
    Hex_mesh mesh = mesh_of(roles, swept, {});
    const std::vector<double> least = least_by_volume(mesh);
    if (least.size() < 2 || *std::min_element(least.begin(), least.end()) >= good) return mesh;
    const auto cut_up = guarded([&] { return cut(part_, roles, std::move(swept), refinement.follows_walls, run_); });
    if (!is_made(cut_up)) return mesh;
    for (const Volume& volume : cut_up.value().volumes) {
      const auto target = std::find(mesh.targets.begin(), mesh.targets.end(), volume.target);
      const auto v = static_cast<std::size_t>(target - mesh.targets.begin());
      if (v < least.size() && least[v] < good) sweep_anew(volume, v, least[v], mesh);
    }
    return mesh;
  }

  // What can be done without may fail, but not go on after the call was cancelled.
  template <class T>
  static bool is_made(const Result<T>& result) {
    if (!result && result.status().code == Status_code::cancelled) throw Failure{result.status()};
    return result.ok();
  }

  Swept_layers<Traits> sweep_along(const Roles& roles, const Refinement& refinement, std::vector<double> through) {
    Layering_options layers = options_.layering;
    layers.spacing = size_;
    layers.through_vertices = refinement.through_vertices;
    layers.through = std::move(through);
    layers.slabs *= refinement.times_slabs;
    return sweep<Traits, SegmentIndex, PointIndex>(part_, roles, layers, tolerance(), refinement.reach,
                                                   options_.neighbours, visitor_, run_);
  }

  Hex_mesh mesh_of(const Roles& roles, const Swept_layers<Traits>& swept, const Given_nodes& given) {
    return run_(Stage::hex_mesh, [&] {
      return guarded([&] {
        const Layer_stack stack = make_layer_stack(swept.layering, swept.loops, roles.is_straight(), tolerance());
        const Cap_drop<Traits> drop(part_);
        const Arc_stack arcs = make_arc_stack(stack, drop);
        return make_hex_mesh(stack, arcs, part_.patch_id, drop, policies_.sizing, policies_.solver,
                             policies_.mesh_quads, given);
      });
    });
  }

  // Replaces the mesh of a sub-volume by the best one of those in other directions, if it is better. Straight sweeps
  // along the cuts can keep the nodes there, so that the whole stays conformal.
  void sweep_anew(const Volume& volume, std::size_t number, double least, Hex_mesh& whole) {
    constexpr double gain = 0.01;
    using Face = typename Volume::Mesh::Face_index;
    const auto patch = volume.mesh.template property_map<Face, int>(Volume::patch_id_map).first;
    const auto part = make_part<Traits>(volume.mesh, volume.mesh.points(), patch);
    if (!part) return;
    Options options = options_;
    options.roles = {};
    Hex_pipeline sweeper(part.value(), options, policies_, visitor_);
    const std::set<int> cuts = cuts_of(volume);
    const std::vector<Roles> candidates = sweeper.roles_along(cuts, whole.directions[number]);
    if (candidates.empty()) return;
    const std::vector<Hex_face> shared = shared_faces(whole, static_cast<int>(number));
    const Volume_replacer replacer(whole, static_cast<int>(number), shared);
    Best_mesh best(good);
    for (const Roles& roles : candidates) {
      const bool will_do = best.show(guarded([&] {
        Hex_mesh made = sweeper.mesh_beside(roles, whole, shared, cuts);
        if (!replacer.fits(made, cuts))
          fail(Status_code::hex_mesh_failed, Stage::hex_mesh, "not all nodes on the cuts could be kept");
        return made;
      }));
      if (will_do) break;
    }
    if (best.quality() > least + gain) whole = replacer.with(best.take(), cuts);
  }

  static std::set<int> cuts_of(const Volume& volume) {
    using Face = typename Volume::Mesh::Face_index;
    const auto patch = volume.mesh.template property_map<Face, int>(Volume::patch_id_map).first;
    const auto role = volume.mesh.template property_map<Face, int>(Volume::role_map).first;
    std::set<int> cuts;
    for (auto f : volume.mesh.faces())
      if (role[f] == static_cast<int>(Role::cut)) cuts.insert(patch[f]);
    return cuts;
  }

  // The straight sweeps in other directions that lead along all cuts.
  std::vector<Roles> roles_along(const std::set<int>& cuts, const Vec3& direction) {
    constexpr double same = 1 - 1e-6;
    auto all = assign_roles(part_, options_.roles);
    std::vector<Roles> along;
    for (std::size_t i = 0; all && i < all.value().size(); ++i) {
      const Roles& roles = all.value()[i];
      bool is_along = roles.is_straight() && std::abs(dot(roles.direction, direction)) < same;
      for (std::size_t p = 0; p < part_.number_of_patches(); ++p)
        is_along = is_along && (cuts.count(part_.patch_id[p]) == 0 || roles.of_patch[p] == Role::linking);
      if (is_along) along.push_back(roles);
    }
    return along;
  }

  // A mesh with the nodes that a mesh around this part has on the cuts.
  Hex_mesh mesh_beside(const Roles& roles, const Hex_mesh& whole, const std::vector<Hex_face>& shared,
                       const std::set<int>& cuts) {
    const double tolerance = 1e-9 * part_.diagonal;
    std::set<std::uint32_t> numbers;
    for (const auto& [a, b, c, d] : shared)
      if (!is_between_rows({whole.points[a], whole.points[b], whole.points[c], whole.points[d]}, roles.direction,
                           tolerance))
        fail(Status_code::hex_mesh_failed, Stage::hex_mesh, "the faces on a cut do not lie between layers", {},
             whole.points[a]);
    for (const Hex_face& face : shared) numbers.insert(face.begin(), face.end());
    std::vector<Vec3> nodes;
    for (std::uint32_t n : numbers) nodes.push_back(whole.points[n]);
    const Given_nodes given(nodes, cuts, roles.direction, tolerance);
    return mesh_of(roles, sweep_along(roles, {}, given.heights()), given);
  }

  // The scaled Jacobian from which on no other direction is looked for: what other sweeps can add to it is little.
  static constexpr double good = 0.8;

  double tolerance() const { return options_.tolerance * part_.diagonal; }

  const Part<Traits>& part_;
  const Options& options_;
  const Policies& policies_;
  double size_;
  Visitor& visitor_;
  Stage_runner<Visitor> run_;
};

}  // namespace CCSweep::internal

#endif
