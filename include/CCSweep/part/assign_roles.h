// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_ASSIGN_ROLES_H
#define CCSWEEP_PART_ASSIGN_ROLES_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/candidate_axes.h>
#include <CCSweep/part/patch_slope.h>
#include <CCSweep/part/pointed_walls.h>
#include <CCSweep/part/upright_axis.h>
#include <CCSweep/part/walk_roles.h>
#include <CCSweep/part/walls_at_ridges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace CCSweep {
namespace internal {

// A patch stands across the sweep (a cap), along it (linking), or it does neither. The limits leave room for drafts,
// chamfers and domes: a wall may lean by 48 degrees, a cap may bend by 72.
struct Role_limits {
  static constexpr double steepest_wall = 0.75;   // |n.d|, in the mean
  static constexpr double steepest_facet = 0.8;   // of a wall: those of a cone stand steeper and flatter than it does
  static constexpr double steep_wall = 0.6;       // |n.d| of a wall that hardly is one any more
  static constexpr double flattest_cap = 0.3;     // |n.d| anywhere on a cap
  static constexpr double tangent = 30 * 3.14159265358979323846 / 180;
};

// What stands in the way of one axis.
struct Objection {
  std::vector<int> patches;
  std::string reason;
};

struct Axis_trial {
  Roles roles;
  std::vector<Objection> objections;
  std::size_t targets = 0;
  double target_area = 0, objectionable_area = 0;
  int lowest_target = 0;
};

// Steep perhaps, but nowhere along the sweep.
inline bool is_across(const Patch_slope& s) {
  return s.low > Role_limits::flattest_cap || s.high < -Role_limits::flattest_cap;
}
inline bool is_cap(const Patch_slope& s) {
  return std::abs(s.mean) > Role_limits::steepest_wall &&
         is_across(s);
}
inline Role cap_role(const Patch_slope& s) { return s.mean > 0 ? Role::source : Role::target; }
inline bool is_wall(const Patch_slope& s) {
  return std::abs(s.mean) <= Role_limits::steepest_wall && s.low >= -Role_limits::steepest_facet &&
         s.high <= Role_limits::steepest_facet;
}

template <class Traits>
void classify_patches(const Part<Traits>& part, Axis_trial& trial) {
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    const Patch_slope s = slope(part, Patch_index(p), trial.roles.direction);
    Role role = Role::linking;
    if (is_cap(s)) {
      role = cap_role(s);
    } else if (!is_wall(s)) {
      trial.objectionable_area += s.area;
      const int id = part.patch_id[p];
      trial.objections.push_back(
          {{id}, "patch " + std::to_string(id) + " stands neither across the sweep nor along it" +
                     (s.low * s.high < 0 ? " (a hole across the sweep, or a closed round surface)"
                                         : " (it bends from cap to wall: a fillet?)")});
    } else if (std::max(-s.low, s.high) > Role_limits::steep_wall) {
      trial.roles.is_doubtful = true;
    }
    trial.roles.of_patch.push_back(role);
  }
}

// Walls that meet in a ridge or at the bottom of a groove, and are not too steep, are caps after all.
template <class Traits>
void cap_ridges(const Part<Traits>& part, Axis_trial& trial) {
  for (Patch_index p : walls_at_ridges(part, trial.roles))
    if (const Patch_slope s = slope(part, p, trial.roles.direction); is_across(s)) {
      trial.roles.of_patch[p.value()] = cap_role(s);
      trial.roles.is_doubtful = true;
    }
}

template <class Traits>
void refuse_pointed_walls(const Part<Traits>& part, Axis_trial& trial) {
  for (const auto& [wall, cap, other] : Pointed_wall_search(part, trial.roles).between_caps()) {
    const std::vector<int> ids{part.id(wall), part.id(cap), part.id(other)};
    trial.objections.push_back({ids, "patch " + std::to_string(ids[0]) + " narrows to a point between patches " +
                                         std::to_string(ids[1]) + " and " + std::to_string(ids[2])});
  }
}

template <class Traits>
void count_targets(const Part<Traits>& part, Axis_trial& trial) {
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    if (trial.roles.of_patch[p] != Role::target) continue;
    trial.lowest_target = trial.targets == 0 ? part.patch_id[p] : std::min(trial.lowest_target, part.patch_id[p]);
    ++trial.targets;
    trial.target_area += part.area_of_patch[p];
  }
}

// No wall is as steep, apart from those that chord errors leave.
inline bool is_sliver_of_wall(double slope) { return std::abs(slope) > Role_limits::steepest_facet; }

// Across a curve the roles must fit the angle there: caps of different kinds can't share an edge, and a wall that
// leaves a cap without a bend has no edge to sweep along.
template <class Traits>
void check_curves(const Part<Traits>& part, Axis_trial& trial) {
  std::map<std::pair<int, int>, std::pair<double, double>> tangent;  // by patch ids: tangent and whole length
  std::set<std::pair<int, int>> knife;
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    if (trial.roles.of_patch[p] == Role::linking) continue;
    for (auto h : part.border[p]) {
      const auto f = part.mesh.face(h), g = part.mesh.face(part.mesh.opposite(h));
      const Patch_index q = part.patch(g);
      const Role r = trial.roles.of_patch[p], s = trial.roles.of_patch[q.value()];
      const std::pair<int, int> ids = std::minmax({part.patch_id[p], part.id(q)});
      if (s != Role::linking) {
        if (r != s) knife.insert(ids);
        continue;
      }
      if (is_sliver_of_wall(dot(part.normal[g], trial.roles.direction))) continue;
      const double length = norm(part.coordinates(part.mesh.target(h)) - part.coordinates(part.mesh.source(h)));
      auto& [smooth, all] = tangent[ids];
      all += length;
      if (angle(part.normal[f], part.normal[g]) < Role_limits::tangent) smooth += length;
    }
  }
  auto object = [&](const std::pair<int, int>& ids, const std::string& what) {
    trial.objections.push_back({{ids.first, ids.second}, "patches " + std::to_string(ids.first) + " and " +
                                                             std::to_string(ids.second) + " " + what});
  };
  for (const auto& ids : knife) object(ids, "are a source and a target that meet in a knife edge");
  for (const auto& [ids, lengths] : tangent)
    if (lengths.first > lengths.second / 2) object(ids, "join without an edge (a blend between cap and wall)");
}

template <class Traits>
Axis_trial try_axis(const Part<Traits>& part, const Vec3& direction) {
  Axis_trial trial;
  trial.roles.direction = direction;
  classify_patches(part, trial);
  if (trial.objections.empty()) cap_ridges(part, trial);
  count_targets(part, trial);
  if (trial.objections.empty()) check_curves(part, trial);
  if (trial.objections.empty()) refuse_pointed_walls(part, trial);
  if (trial.objections.empty() && Pointed_wall_search(part, trial.roles).between_walls())
    trial.roles.is_doubtful = true;
  auto has = [&](Role role) {
    return std::find(trial.roles.of_patch.begin(), trial.roles.of_patch.end(), role) != trial.roles.of_patch.end();
  };
  if (trial.objections.empty() && !has(Role::linking))
    trial.objections.push_back({part.patch_id, "there is no linking face"});
  if (trial.objections.empty() && (!has(Role::source) || !has(Role::target)))
    trial.objections.push_back({part.patch_id, "there is no source or no target face"});
  return trial;
}

// The same roles along the axis of the walls, where the caps that gave the axis slant.
template <class Traits>
Axis_trial along_walls(const Part<Traits>& part, Axis_trial trial) {
  if (!trial.objections.empty() || has_flat_caps(part, trial.roles)) return trial;
  const std::optional<Vec3> axis = upright_axis(part, trial.roles);
  if (!axis) return trial;
  Axis_trial upright = try_axis(part, *axis);
  return upright.objections.empty() && upright.roles.of_patch == trial.roles.of_patch ? upright : trial;
}

template <class Traits>
std::set<int> ids_with_role(const Part<Traits>& part, const Roles& roles, Role role) {
  std::set<int> ids;
  for (std::size_t p = 0; p < part.number_of_patches(); ++p)
    if (roles.of_patch[p] == role) ids.insert(part.patch_id[p]);
  return ids;
}

// The caps a user named against those of a trial; a list left empty agrees with any.
template <class Traits>
void compare_with_request(const Part<Traits>& part, const Role_request& request, Axis_trial& trial) {
  auto compare = [&](const std::vector<int>& wanted, Role role) {
    if (wanted.empty()) return;
    const std::set<int> want(wanted.begin(), wanted.end()), have = ids_with_role(part, trial.roles, role);
    for (int id : want)
      if (!have.count(id))
        trial.objections.push_back({{id}, "patch " + std::to_string(id) + " can't be a " + name(role)});
    for (int id : have)
      if (!want.count(id))
        trial.objections.push_back(
            {{id}, "patch " + std::to_string(id) + " is a " + name(role) + " that was not listed"});
  };
  compare(request.sources, Role::source);
  compare(request.targets, Role::target);
}

template <class Traits>
void check_request(const Part<Traits>& part, const Role_request& request) {
  const std::set<int> known(part.patch_id.begin(), part.patch_id.end());
  for (const auto* list : {&request.sources, &request.targets})
    for (int id : *list)
      if (!known.count(id))
        fail(Status_code::invalid_parameter, Stage::roles, "there is no patch " + std::to_string(id), {id});
  for (int id : request.sources)
    if (std::find(request.targets.begin(), request.targets.end(), id) != request.targets.end())
      fail(Status_code::invalid_parameter, Stage::roles,
           "patch " + std::to_string(id) + " can't be a source and a target", {id});
  for (double x : request.direction)
    if (!std::isfinite(x)) fail(Status_code::invalid_parameter, Stage::roles, "the direction is not finite");
}

// A direction that was typed in is taken for the axis of the part that it is within a few degrees of.
template <class Traits>
std::vector<Vec3> axes_to_try(const Part<Traits>& part, const Role_request& request) {
  std::vector<Vec3> axes = candidate_axes(part);
  if (!request.has_direction()) return axes;
  const Vec3 wanted = unit(request.direction);
  constexpr double near = 5 * 3.14159265358979323846 / 180;
  const Vec3* best = nullptr;
  for (const Vec3& axis : axes)
    if (angle(axis, wanted) < near && (!best || angle(axis, wanted) < angle(*best, wanted))) best = &axis;
  return {best ? *best : without_dust(wanted)};
}

template <class Traits>
void try_axes(const Part<Traits>& part, const Role_request& request, const std::vector<Vec3>& axes,
              std::vector<Axis_trial>& sweepable, std::vector<Axis_trial>& refused) {
  for (const Vec3& axis : axes) {
    Axis_trial trial = along_walls(part, try_axis(part, axis));
    const auto is_same = [&](const Axis_trial& known) { return known.roles.direction == trial.roles.direction; };
    if (std::any_of(sweepable.begin(), sweepable.end(), is_same)) continue;
    if (trial.objections.empty()) compare_with_request(part, request, trial);
    (trial.objections.empty() ? sweepable : refused).push_back(std::move(trial));
  }
}

// Where no straight sweep fits, every planar patch may be the first target of one that bends.
template <class Traits>
std::vector<Axis_trial> try_bent_sweeps(const Part<Traits>& part, const Role_request& request) {
  constexpr double near = 5 * 3.14159265358979323846 / 180;
  constexpr std::size_t most_seeds = 64;
  std::vector<Axis_trial> sweepable;
  std::vector<std::size_t> seeds;
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    if (!part.planar[p]) continue;
    const Vec3 up = reversed(part.normal[part.faces[p].front()]);
    if (!request.has_direction() || angle(up, unit(request.direction)) < near) seeds.push_back(p);
  }
  if (seeds.size() > most_seeds) seeds.resize(most_seeds);
  std::set<std::size_t> known_targets;
  for (std::size_t p : seeds) {
    if (known_targets.count(p)) continue;
    std::optional<Roles> roles = Role_walk<Traits>::run(part, Patch_index(p));
    if (!roles) continue;
    Axis_trial trial;
    trial.roles = std::move(*roles);
    count_targets(part, trial);
    for (std::size_t q = 0; q < part.number_of_patches(); ++q)
      if (trial.roles.of_patch[q] == Role::target) known_targets.insert(q);
    compare_with_request(part, request, trial);
    if (trial.objections.empty()) sweepable.push_back(std::move(trial));
  }
  return sweepable;
}

// The roles of all trials, best first.
template <class Traits>
std::vector<Roles> ranked(const Part<Traits>& part, std::vector<Axis_trial> trials) {
  // Areas that differ by rounding only must not decide before the patch ids do.
  const double unit_area = 1e-9 * part.diagonal * part.diagonal;
  std::stable_sort(trials.begin(), trials.end(), [&](const Axis_trial& a, const Axis_trial& b) {
    return std::tuple(a.roles.is_doubtful, a.targets, std::llround(a.target_area / unit_area), a.lowest_target) <
           std::tuple(b.roles.is_doubtful, b.targets, std::llround(b.target_area / unit_area), b.lowest_target);
  });
  std::vector<Roles> result;
  for (Axis_trial& trial : trials) result.push_back(std::move(trial.roles));
  return result;
}

[[noreturn]] inline void refuse(const Axis_trial& best) {
  std::set<int> patches;
  std::ostringstream reason;
  const Vec3& d = best.roles.direction;
  reason << "not sweepable; along the best axis (" << d[0] << ", " << d[1] << ", " << d[2] << ") ";
  const std::size_t told = std::min<std::size_t>(best.objections.size(), 8);
  for (std::size_t i = 0; i < best.objections.size(); ++i) {
    if (i < told) reason << (i ? "; " : "") << best.objections[i].reason;
    patches.insert(best.objections[i].patches.begin(), best.objections[i].patches.end());
  }
  if (told < best.objections.size()) reason << "; and " << best.objections.size() - told << " more";
  fail(Status_code::not_sweepable, Stage::roles, reason.str(), {patches.begin(), patches.end()});
}

}  // namespace internal

/// Finds the axes and senses along which every patch is a source, a target or a linking face (section 2.1; White and
/// Tautges 2000), by the angles of the patches with the sweep and of the curves between them; where no straight sweep
/// fits, walks from each planar patch over the linking faces to find one that bends.
///
/// \return the possible roles, best first: without walls that are steep or narrow to a point (a sweep along the
/// diagonal of a chamfered block fits, but is nobody's first choice), fewest targets, then smaller target area, then
/// the lowest patch id among the targets; never empty. Where there are none: `not_sweepable` with, for the best axis,
/// the patches that stand in the way and why; `invalid_parameter` where the request names no patch of the part.
/// Complexity: linear in the faces, times the number of candidate axes.
template <class Traits>
Result<std::vector<Roles>> assign_roles(const Part<Traits>& part, const Role_request& request) {
  return internal::guarded([&] {
    using namespace internal;
    check_request(part, request);
    std::vector<Axis_trial> sweepable, refused;
    try_axes(part, request, axes_to_try(part, request), sweepable, refused);
    if (sweepable.empty() && !request.has_direction())
      try_axes(part, request, axes_along_planar_patches(part), sweepable, refused);
    if (sweepable.empty()) sweepable = try_bent_sweeps(part, request);
    if (sweepable.empty()) {
      if (refused.empty())
        fail(Status_code::not_sweepable, Stage::roles, "no planar patch and no cylinder gives a sweep axis",
             part.patch_id);
      refuse(*std::min_element(refused.begin(), refused.end(), [](const Axis_trial& a, const Axis_trial& b) {
        return std::tuple(a.objectionable_area, a.objections.size()) <
               std::tuple(b.objectionable_area, b.objections.size());
      }));
    }
    return ranked(part, std::move(sweepable));
  });
}

/// The possible roles of sweeps that bend, best first. They are for parts on which every straight sweep fails: one
/// that bends little passes for straight at first sight. May be empty.
template <class Traits>
Result<std::vector<Roles>> assign_bent_roles(const Part<Traits>& part, const Role_request& request) {
  return internal::guarded([&] { return internal::ranked(part, internal::try_bent_sweeps(part, request)); });
}

}  // namespace CCSweep

#endif
