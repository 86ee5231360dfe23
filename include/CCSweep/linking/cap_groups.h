// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_CAP_GROUPS_H
#define CCSWEEP_LINKING_CAP_GROUPS_H

#include <CCSweep/indices.h>
#include <CCSweep/internal/Union_find.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Caps that touch each other, along a curve or in a point, stand on one level.
struct Cap_group {
  std::vector<Patch_index> caps;
  double height = 0;  // mean, along the sweep direction
  bool flat = true;   // all in one plane across the sweep
  Vec3 middle{}, ahead{};  // means over the area, unless flat; `ahead` is where the sweep leads
  double least_rise = 0;  // of the curves from here to other groups, where the height follows from them
};

// Two heights closer than this are one: what rounding in a rotated or far away part leaves.
template <class Traits>
double height_resolution(const Part<Traits>& part) {
  return 1e-7 * part.diagonal + 1e-14 * part.largest_coordinate;
}

// The lowest and the highest height on a patch; on a planar one these are on its border.
template <class Traits>
std::pair<double, double> heights(const Part<Traits>& part, const Vec3& direction, Patch_index patch) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto add = [&](auto h) {
    const double height = dot(direction, part.coordinates(part.mesh.target(h)));
    low = std::min(low, height);
    high = std::max(high, height);
  };
  if (part.planar[patch.value()])
    std::for_each(part.border[patch.value()].begin(), part.border[patch.value()].end(), add);
  else
    for (auto f : part.faces[patch.value()])
      for (auto h : part.mesh.halfedges_around_face(part.mesh.halfedge(f))) add(h);
  return {low, high};
}

// The means of a group that is not flat.
template <class Traits>
void measure(const Part<Traits>& part, const Roles& roles, Cap_group& group) {
  double area = 0;
  for (Patch_index p : group.caps) {
    const double sense = roles.of_patch[p.value()] == Role::source ? 1 : -1;
    for (auto f : part.faces[p.value()]) {
      Vec3 sum{};
      for (auto v : part.mesh.vertices_around_face(part.mesh.halfedge(f))) sum = sum + part.coordinates(v);
      group.middle = group.middle + (part.area[f] / 3) * sum;
      group.ahead = group.ahead + (sense * part.area[f]) * part.normal[f];
      area += part.area[f];
    }
  }
  group.middle = (1 / area) * group.middle;
  group.height = dot(roles.direction, group.middle);
  group.ahead = unit(group.ahead);
}

template <class Traits>
std::vector<Cap_group> group_caps(const Part<Traits>& part, const Roles& roles) {
  const auto& mesh = part.mesh;
  Union_find sets(part.number_of_patches());
  auto is_cap = [&](std::size_t p) { return roles.of_patch[p] != Role::linking; };
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    if (!is_cap(p)) continue;
    for (auto h : part.border[p])
      for (auto f : mesh.faces_around_target(h))
        if (is_cap(part.patch(f).value())) sets.join(p, part.patch(f).value());
  }
  std::vector<Cap_group> groups;
  std::vector<std::size_t> group_of(part.number_of_patches());
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    if (!is_cap(p)) continue;
    if (sets.root(p) == p) {
      group_of[p] = groups.size();
      groups.emplace_back();
    }
    groups[group_of[sets.root(p)]].caps.push_back(Patch_index(p));
  }
  for (Cap_group& group : groups) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Patch_index p : group.caps) {
      const auto [lowest, highest] = heights(part, roles.direction, p);
      low = std::min(low, lowest);
      high = std::max(high, highest);
    }
    group.flat = roles.is_straight() && high - low <= height_resolution(part);
    if (group.flat)
      group.height = low + (high - low) / 2;
    else
      measure(part, roles, group);
  }
  return groups;
}

}  // namespace CCSweep::internal

#endif
