// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_FIT_HEIGHTS_H
#define CCSWEEP_LINKING_FIT_HEIGHTS_H

#include <CCSweep/linking/cap_groups.h>
#include <CCSweep/linking/level_ties.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CCSweep::internal {

template <class Traits>
std::vector<int> groups_of_vertices(const Part<Traits>& part, const std::vector<int>& group_of_patch) {
  std::vector<int> group_of_vertex(part.mesh.number_of_vertices(), -1);
  for (auto f : part.mesh.faces())
    if (const int g = group_of_patch[part.patch(f).value()]; g >= 0)
      for (auto v : part.mesh.vertices_around_face(part.mesh.halfedge(f))) group_of_vertex[v] = g;
  return group_of_vertex;
}

// The feature curves between linking faces.
template <class Traits>
std::vector<Rising_curve> rising_curves(const Part<Traits>& part, const Roles& roles,
                                        const std::vector<int>& group_of_patch) {
  const auto& mesh = part.mesh;
  const std::vector<int> group_of_vertex = groups_of_vertices(part, group_of_patch);
  auto is_rising = [&](auto h) {
    return part.feature[mesh.edge(h)] && roles.of_patch[part.patch(mesh.face(h)).value()] == Role::linking &&
           roles.of_patch[part.patch(mesh.face(mesh.opposite(h))).value()] == Role::linking;
  };
  auto rise = [&](auto h) {
    return dot(roles.along(mesh.face(h)), part.coordinates(mesh.target(h)) - part.coordinates(mesh.source(h)));
  };
  std::vector<Rising_curve> curves;
  for (auto start : mesh.halfedges()) {
    if (!is_rising(start) || group_of_vertex[mesh.source(start)] < 0) continue;
    auto h = start;
    double distance = rise(h);
    while (group_of_vertex[mesh.target(h)] < 0) {
      auto onward = h;
      int ways = 0;
      for (auto in : mesh.halfedges_around_target(h))
        if (in != h && is_rising(in)) {
          onward = mesh.opposite(in);
          ++ways;
        }
      if (ways != 1) break;
      h = onward;
      distance += rise(h);
    }
    const int g = group_of_vertex[mesh.source(start)], k = group_of_vertex[mesh.target(h)];
    if (k >= 0 && g != k && distance > 0) curves.push_back({g, k, distance});
  }
  return curves;
}

// Where walls need not have feature curves: from every cap vertex the path over the linking faces' edges that rises
// fastest.
template <class Traits>
std::vector<Rising_curve> rising_paths(const Part<Traits>& part, const Roles& roles,
                                       const std::vector<int>& group_of_patch) {
  using Vertex = typename Part<Traits>::Vertex;
  const auto& mesh = part.mesh;
  const std::vector<int> group_of_vertex = groups_of_vertices(part, group_of_patch);
  std::vector<Rising_curve> paths;
  for (Vertex start : mesh.vertices()) {
    if (group_of_vertex[start] < 0) continue;
    Vertex v = start;
    Rising_curve path{group_of_vertex[start], -1, 0, {part.coordinates(start)}, {0}};
    for (std::size_t steps = 0; steps < mesh.number_of_edges(); ++steps) {
      double best = 0.1, rise = 0;
      Vertex next = v;
      for (auto h : mesh.halfedges_around_target(mesh.halfedge(v))) {
        const auto f = mesh.face(h), g = mesh.face(mesh.opposite(h));
        for (auto side : {f, g}) {
          if (roles.of_patch[part.patch(side).value()] != Role::linking) continue;
          const Vec3 step = part.coordinates(mesh.source(h)) - part.coordinates(v);
          const double slope = dot(roles.along(side), unit(step));
          if (slope <= best) continue;
          best = slope;
          rise = dot(roles.along(side), step);
          next = mesh.source(h);
        }
      }
      if (next == v) break;
      v = next;
      path.distance += rise;
      path.points.push_back(part.coordinates(v));
      path.risen.push_back(path.distance);
      if (group_of_vertex[v] >= 0) break;
    }
    path.high = group_of_vertex[v];
    if (path.high >= 0 && path.low != path.high) paths.push_back(std::move(path));
  }
  return paths;
}

// The least squares fit of the distances along the curves, each with a weight by its distance, and of what stands
// beside what, held weakly at the means.
template <class Weight>
Eigen::VectorXd fitted_heights(const std::vector<Cap_group>& groups, const std::vector<Rising_curve>& curves,
                               const std::vector<Level_tie>& ties, const Weight& weight_of) {
  const auto n = static_cast<Eigen::Index>(groups.size());
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (const Rising_curve& c : curves) {
    const double weight = weight_of(c.distance);
    m(c.low, c.low) += weight;
    m(c.high, c.high) += weight;
    m(c.low, c.high) -= weight;
    m(c.high, c.low) -= weight;
    right(c.low) -= weight * c.distance;
    right(c.high) += weight * c.distance;
  }
  for (const Level_tie& tie : ties) {
    const std::array<std::pair<int, double>, 3> row{
        {{tie.group, 1}, {tie.low, tie.fraction - 1}, {tie.high, -tie.fraction}}};
    for (const auto& [i, a] : row)
      for (const auto& [j, b] : row) m(i, j) += tie.weight * a * b;
  }
  for (Eigen::Index g = 0; g < n; ++g) {
    const Cap_group& group = groups[static_cast<std::size_t>(g)];
    const double weight = group.flat ? 1e-3 : 1e-6;
    m(g, g) += weight;
    right(g) += weight * group.height;
  }
  return m.ldlt().solve(right);
}

// The curves of a straight sweep; and where walls without feature curves, a round pocket's for one, join groups that no
// curve does, the paths up those.
template <class Traits>
std::vector<Rising_curve> straight_curves(const Part<Traits>& part, const Roles& roles,
                                          const std::vector<int>& group_of_patch) {
  std::vector<Rising_curve> result = rising_curves(part, roles, group_of_patch);
  std::set<std::pair<int, int>> joined;
  for (const Rising_curve& curve : result) joined.emplace(curve.low, curve.high);
  for (Rising_curve& path : rising_paths(part, roles, group_of_patch))
    if (joined.count({path.low, path.high}) == 0) result.push_back(std::move(path));
  return result;
}

// Bent groups have no one height. The curves that run up the linking faces from one group to another tell how far
// apart they are: the heights become the least squares fit of these distances, held weakly at the means, which also
// places the groups that no curve ties. Of a sweep that bends, the fit also heeds which caps stand beside which curves.
template <class Traits>
void fit_heights(const Part<Traits>& part, const Roles& roles, std::vector<Cap_group>& groups) {
  if (std::all_of(groups.begin(), groups.end(), [](const Cap_group& g) { return g.flat; })) return;
  std::vector<int> group_of_patch(part.number_of_patches(), -1);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (Patch_index p : groups[g].caps) group_of_patch[p.value()] = static_cast<int>(g);
  const auto curves = roles.is_straight() ? straight_curves(part, roles, group_of_patch)
                                          : rising_paths(part, roles, group_of_patch);
  for (const Rising_curve& c : curves)
    for (Cap_group* group : {&groups[c.low], &groups[c.high]})
      group->least_rise = group->least_rise == 0 ? c.distance : std::min(group->least_rise, c.distance);
  std::vector<Level_tie> ties;
  if (!roles.is_straight()) ties = Level_tie_finder(groups, part.diagonal).run(curves);
  Eigen::VectorXd heights = fitted_heights(groups, curves, ties, [](double) { return 1.0; });
  // Long curves differ by more, and must not all but take away or reverse the rise of a short one.
  if (std::any_of(curves.begin(), curves.end(), [&](const Rising_curve& c) {
        return heights(c.high) - heights(c.low) < c.distance / 2;
      }))
    heights = fitted_heights(groups, curves, ties, [&](double distance) {
      return part.diagonal / distance * (part.diagonal / distance);
    });
  for (std::size_t g = 0; g < groups.size(); ++g) groups[g].height = heights(static_cast<Eigen::Index>(g));
}

}  // namespace CCSweep::internal

#endif
