// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_PARTITION_H
#define CCSWEEP_INTERNAL_VERIFY_PARTITION_H

#include <CCSweep/internal/verify_manifold.h>

#include <map>
#include <set>
#include <tuple>

namespace CCSweep::internal::verification {

inline std::string quoted(Role role) { return std::string("'") + name(role) + "'"; }

/// Every input patch has a role, and nothing else has one.
template <class Kernel, class Point>
void check_role_table(const Scene<Kernel>& scene, const Decomposition<Point>& result) {
  if (result.volumes.empty()) reject("there is no sub-volume");
  for (int patch : scene.patches) {
    auto found = result.roles.find(patch);
    if (found == result.roles.end()) reject("patch " + std::to_string(patch) + " has no role", {patch});
    if (found->second != Role::linking && found->second != Role::source && found->second != Role::target)
      reject("patch " + std::to_string(patch) + " has a role that no input patch can have", {patch});
  }
  for (const auto& [patch, role] : result.roles)
    if (!scene.is_input_patch(patch))
      reject("patch " + std::to_string(patch) + " has a role but is no patch of the input", {patch});
}

/// The direction is a unit vector, and the sub-volumes stand in the order of their targets.
template <class Point>
void check_order(const Decomposition<Point>& result) {
  if (!(std::abs(length(result.direction) - 1) < 1e-9)) reject("the direction is not a unit vector");
  for (std::size_t i = 1; i < result.volumes.size(); ++i)
    if (result.volumes[i - 1].target > result.volumes[i].target)
      reject("the sub-volumes are not in ascending order of their targets", {result.volumes[i].target});
}

/// One target in one piece, at least one source, and the roles of the input patches on all other triangles.
template <class Kernel, class Point>
void check_roles(const Scene<Kernel>& scene, const Decomposition<Point>& result, std::size_t volume) {
  const Surface& surface = scene.volumes[volume];
  std::set<int> targets, sources;
  for (std::size_t t = 0; t < surface.points.size(); ++t) {
    const int patch = surface.patch[t];
    const Role expected = scene.is_input_patch(patch) ? result.roles.at(patch) : Role::cut;
    if (surface.role[t] != static_cast<int>(expected))
      reject(surface.title + ": a triangle of patch " + std::to_string(patch) + " has the role number " +
                 std::to_string(surface.role[t]) + " where it should be " + quoted(expected),
             {patch}, scene.place(surface.points[t]));
    if (expected == Role::target) targets.insert(patch);
    if (expected == Role::source) sources.insert(patch);
  }
  const int target = result.volumes[volume].target;
  if (targets.size() != 1)
    reject(surface.title + " has " + std::to_string(targets.size()) + " targets", {targets.begin(), targets.end()});
  if (*targets.begin() != target)
    reject(surface.title + " has another target than it says", {target, *targets.begin()});
  if (sources.empty()) reject(surface.title + " has no source", {target});
  const std::vector<int>& named = result.volumes[volume].sources;
  if (!std::equal(named.begin(), named.end(), sources.begin(), sources.end()))
    reject(surface.title + " has other sources than it says", {sources.begin(), sources.end()});
  if (number_of_pieces(surface, [&](std::uint32_t t) { return surface.patch[t] == target; }) != 1)
    reject(surface.title + " has its target in several pieces", {target});
}

/// A triangle by its points, ordered so that both orientations are found together.
struct Facet {
  Triple key;  ///< ascending
  bool even;   ///< whether its orientation is that of the key
  std::uint32_t volume;
  std::uint32_t triangle;
};

inline Facet make_facet(Triple points, std::uint32_t volume, std::uint32_t triangle) {
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  const bool even = points[1] < points[2];
  if (!even) std::swap(points[1], points[2]);
  return {points, even, volume, triangle};
}

template <class Kernel>
std::vector<Facet> sorted_facets(const Scene<Kernel>& scene) {
  std::vector<Facet> facets;
  for (std::uint32_t v = 0; v < scene.volumes.size(); ++v)
    for (std::uint32_t t = 0; t < scene.volumes[v].points.size(); ++t)
      facets.push_back(make_facet(scene.volumes[v].points[t], v, t));
  std::sort(facets.begin(), facets.end(), [](const Facet& a, const Facet& b) {
    return std::tie(a.key, a.volume, a.triangle) < std::tie(b.key, b.volume, b.triangle);
  });
  return facets;
}

/// One cut triangle: in exactly two sub-volumes, as mirror images, under the same id.
template <class Kernel>
void check_interface(const Scene<Kernel>& scene, const Facet& a, const Facet& b) {
  const Surface &left = scene.volumes[a.volume], &right = scene.volumes[b.volume];
  const int patch = left.patch[a.triangle], other = right.patch[b.triangle];
  auto refuse = [&](const char* what) { reject(what, {patch, other}, scene.place(a.key)); };
  if (a.volume == b.volume) refuse("a triangle stands twice in one sub-volume");
  if (scene.is_input_patch(patch) || scene.is_input_patch(other))
    refuse("a triangle of an input patch stands in two sub-volumes");
  if (patch != other) refuse("a cut triangle has different ids in its two sub-volumes");
  if (a.even == b.even) refuse("a cut triangle has the same orientation in its two sub-volumes");
  for (std::uint32_t p : a.key)
    if (scene.two_zeros[p]) refuse("a point of a cut is written with -0 on one side and +0 on the other");
}

/// The cuts that the sub-volumes show, by id.
template <class Kernel>
std::map<int, Decomposition_set> find_cuts(const Scene<Kernel>& scene) {
  std::map<int, Decomposition_set> cuts;
  const std::vector<Facet> facets = sorted_facets(scene);
  for (std::size_t i = 0, j = 0; i < facets.size(); i = j) {
    while (j < facets.size() && facets[j].key == facets[i].key) ++j;
    const int patch = scene.volumes[facets[i].volume].patch[facets[i].triangle];
    if (j - i > 2) reject("a triangle stands in more than two places", {patch}, scene.place(facets[i].key));
    if (j - i == 1) {
      if (!scene.is_input_patch(patch))
        reject("a triangle of cut " + std::to_string(patch) + " has no counterpart in a neighbouring sub-volume",
               {patch}, scene.place(facets[i].key));
      continue;
    }
    check_interface(scene, facets[i], facets[i + 1]);
    const std::array<int, 2> pair{static_cast<int>(facets[i].volume), static_cast<int>(facets[i + 1].volume)};
    Decomposition_set& cut = cuts.try_emplace(patch, Decomposition_set{patch, pair, 0}).first->second;
    if (cut.volumes != pair)
      reject("cut " + std::to_string(patch) + " lies between more than two sub-volumes", {patch},
             scene.place(facets[i].key));
    ++cut.triangles;
  }
  return cuts;
}

/// The cuts agree with the list of decomposition sets.
template <class Kernel, class Point>
void check_sets(const Scene<Kernel>& scene, const Decomposition<Point>& result) {
  const std::map<int, Decomposition_set> cuts = find_cuts(scene);
  for (std::size_t i = 1; i < result.sets.size(); ++i)
    if (result.sets[i - 1].id >= result.sets[i].id)
      reject("the decomposition sets are not in ascending order of their ids", {result.sets[i].id});
  for (const Decomposition_set& set : result.sets) {
    auto cut = cuts.find(set.id);
    const std::string title = "decomposition set " + std::to_string(set.id);
    if (cut == cuts.end()) reject(title + " has no triangle in the sub-volumes", {set.id});
    if (cut->second.volumes != set.volumes) reject(title + " names other sub-volumes than it separates", {set.id});
    if (cut->second.triangles != set.triangles)
      reject(title + " says " + std::to_string(set.triangles) + " triangles and has " +
                 std::to_string(cut->second.triangles),
             {set.id});
  }
  if (cuts.size() == result.sets.size()) return;
  for (const auto& [id, cut] : cuts)
    if (std::none_of(result.sets.begin(), result.sets.end(), [id = id](const auto& s) { return s.id == id; }))
      reject("cut " + std::to_string(id) + " is missing in the list of decomposition sets", {id});
}

}  // namespace CCSweep::internal::verification

#endif
