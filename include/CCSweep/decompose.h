// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_DECOMPOSE_H
#define CCSWEEP_DECOMPOSE_H

#include <CCSweep/Status.h>
#include <CCSweep/concepts.h>
#include <CCSweep/internal/Input.h>
#include <CCSweep/internal/Options.h>
#include <CCSweep/internal/Pipeline.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/divide_walls.h>
#include <CCSweep/part/assign_roles.h>
#include <CCSweep/part/check_input.h>
#include <CCSweep/part/make_part.h>
#include <CCSweep/verify.h>
#include <CCSweep/volumes/Decomposition.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {

/// What `inspect()` tells of a part: how it would be swept.
struct Sweep_plan {
  std::array<double, 3> direction{};         ///< unit vector from targets to sources, at the targets
  std::map<int, Role> roles;                 ///< role of each patch
  std::vector<std::vector<int>> levels;      ///< the caps (patch ids) of each level, from the lowest
  std::vector<double> sweep_parameters;      ///< of each level
};

namespace internal {

/// Tries the possible roles, best first, and verifies what comes out.
template <class Traits, class SegmentIndex, class PointIndex, class Visitor>
class Decomposer {
  using Point_3 = typename Traits::Point_3;
  using Result_type = Decomposition<Point_3>;

 public:
  Decomposer(const Part<Traits>& part, const Options& options, Visitor& visitor, Stage_runner<Visitor>& run)
      : part_(part), options_(options), visitor_(visitor), run_(run) {}

  Result_type run() {
    const std::vector<Roles> candidates =
        run_(Stage::roles, [&] { return assign_roles(part_, options_.roles); });
    std::optional<Result_type> best = first_success(candidates);
    if (!best && candidates.front().is_straight())
      best = first_success(run_(Stage::roles, [&] { return assign_bent_roles(part_, options_.roles); }));
    if (!best)
      throw Failure{candidates.front().is_straight() ? *first_failure_
                                                     : refusal(candidates.front(), *first_failure_)};
    best->notes.insert(best->notes.begin(), notes_.begin(), notes_.end());
    best->seconds = run_.seconds();
    return std::move(*best);
  }

 private:
  static std::size_t targets(const Roles& roles) {
    return std::count(roles.of_patch.begin(), roles.of_patch.end(), Role::target);
  }

  std::optional<Result_type> first_success(const std::vector<Roles>& candidates) {
    for (std::size_t i = 0; i < candidates.size();) {
      // Candidates with equally many targets compete by their decomposition sets.
      std::size_t j = i + 1;
      if (targets(candidates[i]) > 1)
        while (j < candidates.size() && candidates[j].is_doubtful == candidates[i].is_doubtful &&
               targets(candidates[j]) == targets(candidates[i]))
          ++j;
      if (auto best = best_of(candidates, i, j)) return best;
      i = j;
    }
    return std::nullopt;
  }

  std::optional<Result_type> best_of(const std::vector<Roles>& candidates, std::size_t first, std::size_t last) {
    std::optional<Result_type> best;
    for (std::size_t i = first; i < last; ++i) {
      Result<Result_type> attempt = attempt_refined(candidates[i]);
      if (attempt) {
        if (!best || attempt.value().sets.size() < best->sets.size()) best = std::move(attempt).value();
        continue;
      }
      const Status status = attempt.status();
      if (status.code == Status_code::cancelled || status.code == Status_code::invalid_parameter)
        throw Failure{status};
      notes_.push_back("along " + text(candidates[i].direction) + ": " + status.reason);
      if (!first_failure_) first_failure_ = status;
    }
    return best;
  }

  // A bent sweep is tried where no straight one fits; what fails there was not sweepable.
  Status refusal(const Roles& roles, Status status) const {
    status.code = Status_code::not_sweepable;
    status.reason = "no straight sweep fits, and one that bends fails: " + status.reason;
    if (status.patches.empty())
      for (std::size_t p = 0; p < part_.number_of_patches(); ++p)
        if (roles.of_patch[p] != Role::linking) status.patches.push_back(part_.patch_id[p]);
    return status;
  }

  static std::string text(const Vec3& d) {
    return "(" + std::to_string(d[0]) + ", " + std::to_string(d[1]) + ", " + std::to_string(d[2]) + ")";
  }

  // A result that fails is never returned; it is refined and tried again, boundedly: first by cuts that follow the
  // bends of the walls between two layers, then by rows that pass through the vertices of the linking faces, then by
  // walls of smaller facets, by more rows, at last by cuts that missed the walls and may be drawn to them from further
  // off.
  Result<Result_type> attempt_refined(const Roles& roles) {
    const std::optional<Part<Traits>> divided = divide_flat_facets(part_, roles);
    const Part<Traits>& part = divided ? *divided : part_;
    constexpr std::array<Refinement, 8> refinements{{{},
                                                     {.follows_walls = true},
                                                     {.follows_walls = true, .through_vertices = true},
                                                     {.follows_walls = true, .divides_walls = true},
                                                     {.follows_walls = true, .times_slabs = 2},
                                                     {.follows_walls = true, .times_slabs = 4},
                                                     {.follows_walls = true, .reach = 10},
                                                     {.follows_walls = true, .reach = 50}}};
    std::optional<Part<Traits>> finer;
    std::optional<Status> failure;
    for (const Refinement& refinement : refinements) {
      if (failure && !may_mend(refinement, failure->code)) continue;
      if (refinement.divides_walls && !(finer = divide_walls(part, roles))) continue;
      Result<Result_type> attempt = guarded([&] {
        Result_type result = Pipeline<Traits, SegmentIndex, PointIndex, Visitor>(
            refinement.divides_walls ? *finer : part, options_, visitor_, run_)(roles, refinement);
        run_(Stage::verification, [&] { return verified(result); });
        return result;
      });
      if (attempt) return attempt;
      if (!failure) failure = attempt.status();
    }
    return *failure;
  }

  static bool may_mend(const Refinement& refinement, Status_code failure) {
    switch (failure) {
      case Status_code::verification_failed:
        return true;
      case Status_code::projection_folded:
      case Status_code::imprint_failed:  // before there are cuts that could follow anything
        return refinement.through_vertices || refinement.divides_walls || refinement.times_slabs > 1 ||
               refinement.reach > 0;
      case Status_code::inconsistent_levels:
      case Status_code::cut_failed:
      case Status_code::sub_volume_not_closed:  // by the facets of walls that bend; more rows alone rarely mend that
        return refinement.through_vertices || refinement.divides_walls || refinement.reach > 0;
      default:
        return false;
    }
  }

  Result<bool> verified(const Result_type& result) const {
    const auto patch_of = boost::make_function_property_map<typename Part<Traits>::Face, int>(
        [this](typename Part<Traits>::Face f) { return part_.id(part_.patch(f)); });
    const Status status = verify(part_.mesh, patch_of, result);
    if (!status.ok()) return status;
    return true;
  }

  const Part<Traits>& part_;
  const Options& options_;
  Visitor& visitor_;
  Stage_runner<Visitor>& run_;
  std::optional<Status> first_failure_;
  std::vector<std::string> notes_;  // of what was tried before
};

}  // namespace internal

/// Decomposes a multi-sweep volume into many-to-one sweepable sub-volumes.
///
/// The algorithm is CCSweep (White, Saigal, Owen 2004), section 2:
/// 1. the patches become sources, targets and linking faces,
/// 2. the linking faces are meshed by rows and columns, which order the caps in levels and layers,
/// 3. on each layer the targets below, pushed up like cookie cutters, are imprinted with the sources,
/// 4. the columns under the imprints make up cut surfaces, the decomposition sets,
/// 5. which part the volume into one sub-volume for each target.
/// The result is verified before it is returned (see `verify()`).
///
/// \tparam FaceGraph a model of `SweepMesh`. The mesh must be closed, 2-manifold and oriented outward, without
/// self-intersection; faces with more than three vertices are triangulated in a copy.
/// \param np a sequence of named parameters, see `CCSweep::parameters`; `face_patch_map` is needed
///
/// \return the decomposition; or a status that names stage, patches and reason, and then the input is untouched.
/// Complexity: O(n log n) in the size of input and output, where cuts cross few facets.
template <SweepMesh FaceGraph, class NamedParameters>
auto decompose(const FaceGraph& mesh, const NamedParameters& np)
    -> Result<Decomposition<typename internal::Call<FaceGraph, NamedParameters>::Traits::Point_3>> {
  using Call = internal::Call<FaceGraph, NamedParameters>;
  using Traits = typename Call::Traits;
  return internal::guarded([&] {
    auto&& visitor = Call::visitor(np);
    using Visitor = std::remove_reference_t<decltype(visitor)>;
    const internal::Options options = internal::unpack(np);
    internal::Stage_runner<Visitor> run(visitor);
    const Part<Traits> part = run(Stage::part, [&] {
      return internal::guarded(
          [&] { return internal::read_input<Traits>(mesh, Call::points(mesh, np), Call::patches(np)); });
    });
    return internal::Decomposer<Traits, typename Call::Segment_index, typename Call::Point_index, Visitor>(
               part, options, visitor, run)
        .run();
  });
}

/// Tells how a part would be swept, without decomposing it: roles, axis and levels of the best candidate.
/// \return the plan; or the status `decompose()` would fail with before it imprints anything.
template <SweepMesh FaceGraph, class NamedParameters>
Result<Sweep_plan> inspect(const FaceGraph& mesh, const NamedParameters& np) {
  using Call = internal::Call<FaceGraph, NamedParameters>;
  using Traits = typename Call::Traits;
  return internal::guarded([&] {
    const internal::Options options = internal::unpack(np);
    const Part<Traits> part = internal::read_input<Traits>(mesh, Call::points(mesh, np), Call::patches(np));
    const auto candidates = internal::value_or_fail(assign_roles(part, options.roles));
    const Roles& roles = candidates.front();
    const Layering layering = internal::value_or_fail(make_layering(part, roles, options.layering));
    Sweep_plan plan;
    plan.direction = roles.direction;
    for (std::size_t p = 0; p < part.number_of_patches(); ++p) plan.roles[part.patch_id[p]] = roles.of_patch[p];
    for (std::size_t k = 0; k < layering.layers.size(); ++k)
      if (layering.level_of_layer[k].is_valid()) plan.sweep_parameters.push_back(layering.layers[k]);
    for (const auto& caps : layering.caps) {
      plan.levels.emplace_back();
      for (Patch_index p : caps) plan.levels.back().push_back(part.id(p));
    }
    return plan;
  });
}

}  // namespace CCSweep

#endif
