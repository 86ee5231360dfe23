// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_CURVES_H
#define CCSWEEP_INTERNAL_VERIFY_CURVES_H

#include <CCSweep/internal/verify_partition.h>

namespace CCSweep::internal::verification {

/// What is known of the edges between two patches.
struct Curve {
  double length = 0;
  std::uint32_t point = 0;  ///< somewhere on it
};
using Curves = std::map<std::pair<int, int>, Curve>;

/// One side of an edge between two points.
struct Edge_side {
  std::uint32_t low, high;
  bool forward;
  int patch;
  auto operator<=>(const Edge_side&) const = default;
};

/// Notes the sides of the outer triangles of a surface, without edges inside a patch: their sides cancel.
template <class Kernel>
void collect_sides(const Scene<Kernel>& scene, const Surface& surface, std::vector<Edge_side>& sides) {
  for (std::size_t t = 0; t < surface.points.size(); ++t) {
    if (!scene.is_input_patch(surface.patch[t])) continue;
    for (int k = 0; k < 3; ++k) {
      if (surface.patch[surface.opposite[3 * t + k] / 3] == surface.patch[t]) continue;
      const std::uint32_t from = surface.points[t][k], to = surface.points[t][(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from < to, surface.patch[t]});
    }
  }
}

/// The lengths of the curves between patches. Every edge must be passed as often in one direction as in the other.
/// Where the solid touches itself along an edge, four triangles meet there; which belong together does not matter,
/// as the same rule is applied to the input and to the result.
template <class Kernel>
Curves measure_curves(const Scene<Kernel>& scene, std::vector<Edge_side> sides, const std::string& title) {
  std::sort(sides.begin(), sides.end());
  Curves curves;
  std::vector<int> there, back, only_there, only_back;
  for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
    there.clear(), back.clear(), only_there.clear(), only_back.clear();
    for (; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high; ++j)
      (sides[j].forward ? there : back).push_back(sides[j].patch);
    const std::uint32_t low = sides[i].low, high = sides[i].high;
    if (there.size() != back.size())
      reject(title + " do not close: an edge has a triangle on one side only", {sides[i].patch}, scene.place(low));
    std::set_difference(there.begin(), there.end(), back.begin(), back.end(), std::back_inserter(only_there));
    std::set_difference(back.begin(), back.end(), there.begin(), there.end(), std::back_inserter(only_back));
    for (std::size_t k = 0; k < only_there.size(); ++k) {
      Curve& curve = curves[std::minmax(only_there[k], only_back[k])];
      curve.length += length(minus(scene.near[low], scene.near[high]));
      curve.point = low;
    }
  }
  return curves;
}

/// Every curve between two patches has the length it had, and there are no others.
template <class Kernel>
void check_curves(const Scene<Kernel>& scene) {
  std::vector<Edge_side> sides;
  collect_sides(scene, scene.input, sides);
  const Curves before = measure_curves(scene, std::move(sides), "the triangles of the input");
  sides.clear();
  for (const Surface& volume : scene.volumes) collect_sides(scene, volume, sides);
  Curves after = measure_curves(scene, std::move(sides), "the outer triangles of the sub-volumes");
  const double slack = 1e-9 * scene.diagonal + 1e-14 * scene.extent;
  for (const auto& [pair, curve] : before) {
    const double length = after[pair].length;
    if (std::abs(length - curve.length) > 1e-9 * curve.length + slack)
      reject("the curve between patches " + std::to_string(pair.first) + " and " + std::to_string(pair.second) +
                 " is not kept",
             {pair.first, pair.second}, scene.place(curve.point));
  }
  for (const auto& [pair, curve] : after)
    if (!before.count(pair) && curve.length > slack)
      reject("patches " + std::to_string(pair.first) + " and " + std::to_string(pair.second) +
                 " meet in the sub-volumes but not in the input",
             {pair.first, pair.second}, scene.place(curve.point));
}

/// Tells the points of a surface where three or more patches meet.
inline std::vector<char> corners(const Surface& surface, std::size_t number_of_points) {
  struct Meeting {
    int size = 0;
    std::array<int, 2> patches{};  // the first of them
  };
  std::vector<Meeting> meetings(number_of_points);
  for (std::size_t t = 0; t < surface.points.size(); ++t)
    for (std::uint32_t p : surface.points[t]) {
      auto& [size, patches] = meetings[p];
      if (size == 3 || std::find(patches.begin(), patches.begin() + size, surface.patch[t]) != patches.begin() + size)
        continue;
      if (size < 2) patches[size] = surface.patch[t];
      ++size;
    }
  std::vector<char> result;
  for (const Meeting& meeting : meetings) result.push_back(meeting.size == 3);
  return result;
}

/// Every input vertex where three or more patches meet is an outer vertex of a sub-volume that touches these patches.
template <class Kernel>
void check_corners(const Scene<Kernel>& scene) {
  const std::vector<char> is_corner = corners(scene.input, scene.points.size());
  auto patches_at = [&](const Surface& surface, std::vector<std::pair<std::uint32_t, int>>& found) {
    for (std::size_t t = 0; t < surface.points.size(); ++t)
      for (std::uint32_t p : surface.points[t])
        if (is_corner[p] && scene.is_input_patch(surface.patch[t])) found.emplace_back(p, surface.patch[t]);
  };
  auto tidy = [](auto& found) {
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  };
  std::vector<std::pair<std::uint32_t, int>> before, after;
  patches_at(scene.input, before);
  for (const Surface& volume : scene.volumes) patches_at(volume, after);
  tidy(before);
  tidy(after);
  for (const auto& kept : before)
    if (!std::binary_search(after.begin(), after.end(), kept))
      reject("a corner of the input is not kept", {kept.second}, scene.place(kept.first));
}

}  // namespace CCSweep::internal::verification

#endif
