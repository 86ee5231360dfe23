// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_DIVIDE_FLAT_FACETS_H
#define CCSWEEP_LINKING_DIVIDE_FLAT_FACETS_H

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

/// The edges inside linking patches around the facets all of whose corners lie on one group of caps.
template <class Traits>
std::vector<typename Part<Traits>::Edge> chords_of_flat_facets(const Part<Traits>& part, const Roles& roles) {
  const auto& mesh = part.mesh;
  const std::vector<Cap_group> groups = group_caps(part, roles);
  std::vector<typename Part<Traits>::Edge> chords;
  if (std::all_of(groups.begin(), groups.end(), [](const Cap_group& g) { return g.flat; })) return chords;
  std::vector<int> group_of_patch(part.number_of_patches(), -1);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (Patch_index p : groups[g].caps) group_of_patch[p.value()] = static_cast<int>(g);
  const std::vector<int> group = groups_of_vertices(part, group_of_patch);
  for (auto f : mesh.faces()) {
    if (group_of_patch[part.patch(f).value()] >= 0) continue;
    const auto h = mesh.halfedge(f);
    const int g = group[mesh.target(h)];
    if (g < 0 || group[mesh.source(h)] != g || group[mesh.target(mesh.next(h))] != g) continue;
    for (auto side : mesh.halfedges_around_face(h))
      if (!part.feature[mesh.edge(side)]) chords.push_back(mesh.edge(side));
  }
  std::sort(chords.begin(), chords.end());
  chords.erase(std::unique(chords.begin(), chords.end()), chords.end());
  return chords;
}

}  // namespace internal

/// Between bent or leaning caps the sweep parameter has one value on each group of them. A facet of a wall all corners
/// of which lie on one group, as where a single facet spans a gable, would lie across the sweep. This halves the edges
/// inside the wall around such facets, so that it has vertices between.
/// \return the part with these further vertices, the patches of which have the same numbers; nothing if there is no
/// such facet. Complexity: linear if there is none, else O(n log n).
template <class Traits>
std::optional<Part<Traits>> divide_flat_facets(const Part<Traits>& part, const Roles& roles) {
  if (!roles.is_straight()) return std::nullopt;
  const auto chords = internal::chords_of_flat_facets(part, roles);
  if (chords.empty()) return std::nullopt;
  auto mesh = part.mesh;
  using Face = typename Part<Traits>::Face;
  auto number = mesh.template add_property_map<Face, int>("f:patch_number").first;
  for (Face f : mesh.faces()) number[f] = static_cast<int>(part.patch(f).value());
  for (const auto e : chords) {
    const auto h = mesh.halfedge(e);
    const auto middle = internal::point_between(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), 0.5);
    const auto first = CGAL::Euler::split_edge(h, mesh);  // ends in the new vertex; h goes on from there
    mesh.point(mesh.target(first)) = middle;
    const auto back = mesh.opposite(h);
    for (const auto& [in, across] : {std::pair(first, mesh.next(h)), std::pair(back, mesh.next(mesh.next(back)))}) {
      const auto made = CGAL::Euler::split_face(in, across, mesh);
      number[mesh.face(mesh.opposite(made))] = number[mesh.face(made)];
    }
  }
  Part<Traits> divided = internal::value_or_fail(make_part<Traits>(mesh, mesh.points(), number));
  divided.patch_id = part.patch_id;
  return divided;
}

}  // namespace CCSweep

#endif
