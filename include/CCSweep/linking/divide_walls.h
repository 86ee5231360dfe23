// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_DIVIDE_WALLS_H
#define CCSWEEP_LINKING_DIVIDE_WALLS_H

#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/cap_groups.h>
#include <CCSweep/linking/fit_heights.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/Surface_location.h>
#include <CCSweep/part/make_part.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

template <class Traits>
using Edges_of = std::vector<typename Part<Traits>::Edge>;

/// The edges inside linking patches around some facets, each once.
template <class Traits, class IsChosen>
Edges_of<Traits> edges_inside_walls(const Part<Traits>& part, const Roles& roles, const IsChosen& is_chosen) {
  const auto& mesh = part.mesh;
  Edges_of<Traits> edges;
  for (auto f : mesh.faces()) {
    if (roles.of_patch[part.patch(f).value()] != Role::linking || !is_chosen(f)) continue;
    for (auto side : mesh.halfedges_around_face(mesh.halfedge(f)))
      if (!part.feature[mesh.edge(side)]) edges.push_back(mesh.edge(side));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// The group of caps that all corners of a facet lie on; -1 where there is none.
template <class Traits>
int group_of_corners(const Part<Traits>& part, const std::vector<int>& group_of_vertex,
                     typename Part<Traits>::Face f) {
  const auto h = part.mesh.halfedge(f);
  const int g = group_of_vertex[part.mesh.target(h)];
  const bool is_same = group_of_vertex[part.mesh.source(h)] == g &&
                       group_of_vertex[part.mesh.target(part.mesh.next(h))] == g;
  return is_same ? g : -1;
}

/// The part with a vertex in the middle of some edges inside patches. The patches keep their numbers.
template <class Traits>
Part<Traits> with_edges_halved(const Part<Traits>& part, const Edges_of<Traits>& edges) {
  using Face = typename Part<Traits>::Face;
  auto mesh = part.mesh;
  auto patch = mesh.template add_property_map<Face, int>("f:patch").first;
  for (Face f : mesh.faces()) patch[f] = static_cast<int>(part.patch(f).value());
  for (const auto e : edges) {
    const auto h = mesh.halfedge(e);
    const auto middle = point_between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), 0.5);
    const auto first = CGAL::Euler::split_edge(h, mesh);  // ends in the new vertex; h goes on from there
    mesh.point(mesh.target(first)) = middle;
    const auto back = mesh.opposite(h);
    for (const auto& [in, across] : {std::pair(first, mesh.next(h)), std::pair(back, mesh.next(mesh.next(back)))}) {
      const auto made = CGAL::Euler::split_face(in, across, mesh);
      patch[mesh.face(mesh.opposite(made))] = patch[mesh.face(made)];
    }
  }
  Part<Traits> halved = value_or_fail(make_part<Traits>(mesh, mesh.points(), patch));
  halved.patch_id = part.patch_id;
  return halved;
}

/// Whether the sweep parameter is more than the height: harmonic on the linking faces.
inline bool has_harmonic_parameter(const std::vector<Cap_group>& groups, const Roles& roles) {
  return roles.is_straight() && std::any_of(groups.begin(), groups.end(), [](const Cap_group& g) { return !g.flat; });
}

}  // namespace internal

/// Between leaning or bent caps the sweep parameter has one value on each group of them. A facet of a wall all corners
/// of which lie on one group, as where a single facet fills a gable, would lie across the sweep. This puts vertices on
/// the edges around such facets that lie inside the wall.
/// \return the part with these further vertices, the patches of which have the same numbers; nothing if there is no
/// such facet, or the sweep bends. Complexity: linear if there is none, else O(n log n).
template <class Traits>
std::optional<Part<Traits>> divide_flat_facets(const Part<Traits>& part, const Roles& roles) {
  const std::vector<internal::Cap_group> groups = internal::group_caps(part, roles);
  if (!internal::has_harmonic_parameter(groups, roles)) return std::nullopt;
  std::vector<int> group_of_patch(part.number_of_patches(), -1);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (Patch_index p : groups[g].caps) group_of_patch[p.value()] = static_cast<int>(g);
  const std::vector<int> group_of_vertex = internal::groups_of_vertices(part, group_of_patch);
  const auto edges = internal::edges_inside_walls(
      part, roles, [&](auto f) { return internal::group_of_corners(part, group_of_vertex, f) >= 0; });
  if (edges.empty()) return std::nullopt;
  return internal::with_edges_halved(part, edges);
}

/// On walls of few large facets the harmonic parameter is coarse, and rows across it stray from the sections of the
/// part. This puts vertices on the edges inside the walls, once at least and till there are many facets.
/// \return as `divide_flat_facets()`; nothing where the parameter is not harmonic. Complexity: O(n log n).
template <class Traits>
std::optional<Part<Traits>> divide_walls(const Part<Traits>& part, const Roles& roles) {
  if (!internal::has_harmonic_parameter(internal::group_caps(part, roles), roles)) return std::nullopt;
  constexpr std::size_t many = 2000;
  constexpr int most_rounds = 4;
  std::optional<Part<Traits>> divided;
  for (int round = 0; round < most_rounds; ++round) {
    const Part<Traits>& last = divided ? *divided : part;
    const auto edges = internal::edges_inside_walls(last, roles, [](auto) { return true; });
    if (edges.empty() || (divided && last.mesh.number_of_faces() > many)) break;
    divided = internal::with_edges_halved(last, edges);
  }
  return divided;
}

}  // namespace CCSweep

#endif
