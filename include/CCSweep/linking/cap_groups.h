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
#include <vector>

namespace CCSweep::internal {

// Caps that touch each other, along a curve or in a point, stand on one level.
struct Cap_group {
  std::vector<Patch_index> caps;
  double height = 0;  // mean over the area, along the sweep direction
  bool flat = true;   // all in one plane across the sweep
  Vec3 middle{}, ahead{};  // means over the area; `ahead` is where the sweep leads
  double least_rise = 0;  // of the curves from here to other groups, where the height follows from them
};

// Two heights closer than this are one: what rounding in a rotated or far away part leaves.
template <class Traits>
double height_resolution(const Part<Traits>& part) {
  return 1e-7 * part.diagonal + 1e-14 * part.largest_coordinate;
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
    double area = 0, low = 1e300, high = -1e300;
    for (Patch_index p : group.caps)
      for (auto f : part.faces[p.value()]) {
        double sum = 0;
        for (auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
          const double h = dot(roles.direction, part.coordinates(v));
          sum += h;
          group.middle = group.middle + (part.area[f] / 3) * part.coordinates(v);
          low = std::min(low, h);
          high = std::max(high, h);
        }
        area += part.area[f];
        group.height += part.area[f] * sum / 3;
        const double sense = roles.of_patch[p.value()] == Role::source ? 1 : -1;
        group.ahead = group.ahead + (sense * part.area[f]) * part.normal[f];
      }
    group.height /= area;
    group.middle = (1 / area) * group.middle;
    group.ahead = unit(group.ahead);
    group.flat = roles.is_straight() && high - low <= height_resolution(part);
  }
  return groups;
}

}  // namespace CCSweep::internal

#endif
