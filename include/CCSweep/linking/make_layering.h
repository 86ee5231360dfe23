// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_MAKE_LAYERING_H
#define CCSWEEP_LINKING_MAKE_LAYERING_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Layering.h>
#include <CCSweep/linking/cap_groups.h>
#include <CCSweep/linking/fit_heights.h>
#include <CCSweep/linking/rows_through_vertices.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace CCSweep {
namespace internal {

template <class Traits>
void rank_levels(const Part<Traits>& part, std::vector<Cap_group>& groups, Layering& layering) {
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Cap_group& a, const Cap_group& b) { return a.height < b.height; });
  layering.level_of_patch.assign(part.number_of_patches(), Level_index());
  // Heights that were fitted are not known to the last digit, and layers all but on top of each other would make
  // slivers; but no curve may lead from a level to itself.
  constexpr double share = 0.1;
  const Cap_group* first = nullptr;  // of the level
  for (const Cap_group& group : groups) {
    if (!first || group.height - first->height >
                      std::max(height_resolution(part), share * std::min(group.least_rise, first->least_rise))) {
      layering.caps.emplace_back();
      layering.layers.push_back(group.height);
      first = &group;
    }
    for (Patch_index p : group.caps) {
      layering.caps.back().push_back(p);
      layering.level_of_patch[p.value()] = Level_index(layering.caps.size() - 1);
    }
  }
  for (auto& caps : layering.caps) std::sort(caps.begin(), caps.end());
}

// The boundary of a cap carries the cap's own value.
template <class Traits>
void tie_cap_borders(const Part<Traits>& part, Layering& layering) {
  std::vector<Patch_index> tied(part.mesh.number_of_vertices());
  for (std::size_t level = 0; level < layering.caps.size(); ++level)
    for (Patch_index p : layering.caps[level])
      for (auto h : part.border[p.value()]) {
        const auto v = part.mesh.target(h);
        if (tied[v].is_valid() && layering.parameter[v] != layering.layers[level])
          fail(Status_code::inconsistent_levels, Stage::layers,
               "patches " + std::to_string(part.id(tied[v])) + " and " + std::to_string(part.id(p)) +
                   " meet in a point but stand on different levels",
               {part.id(tied[v]), part.id(p)}, part.coordinates(v));
        tied[v] = p;
        layering.parameter[v] = layering.layers[level];
      }
}

// So does its inside, where that has no height of its own.
template <class Traits>
void tie_cap_vertices(const Part<Traits>& part, Layering& layering) {
  for (std::size_t level = 0; level < layering.caps.size(); ++level)
    for (Patch_index p : layering.caps[level])
      for (auto f : part.faces[p.value()])
        for (auto v : part.mesh.vertices_around_face(part.mesh.halfedge(f)))
          layering.parameter[v] = layering.layers[level];
}

// A straight sweep between flat caps: the parameter is the height itself.
template <class Traits>
void use_heights(const Part<Traits>& part, const Roles& roles, Layering& layering) {
  for (auto v : part.mesh.vertices())
    if (std::isnan(layering.parameter[v])) layering.parameter[v] = dot(roles.direction, part.coordinates(v));
}

// A vertex that a row all but meets is a node of that row; otherwise rounding would make rows of slivers.
template <class Traits>
void snap_vertices_to_layers(const Part<Traits>& part, Layering& layering) {
  const double resolution = height_resolution(part);
  for (double& u : layering.parameter) {
    auto layer = std::lower_bound(layering.layers.begin(), layering.layers.end(), u - resolution);
    if (layer != layering.layers.end() && std::abs(*layer - u) <= resolution) u = *layer;
  }
}

// Along a feature curve that rises over the linking faces from one cap to another the parameter grows evenly, as it
// does where the curve has no inner vertices: rows must not depend on how finely curves are divided.
template <class Traits>
void tie_rising_curves(const Part<Traits>& part, const Roles& roles, Layering& layering) {
  const auto& mesh = part.mesh;
  const std::vector<double> tied = layering.parameter;
  auto is_rising = [&](auto h) {
    return part.feature[mesh.edge(h)] && roles.of_patch[part.patch(mesh.face(h)).value()] == Role::linking &&
           roles.of_patch[part.patch(mesh.face(mesh.opposite(h))).value()] == Role::linking;
  };
  for (auto start : mesh.halfedges()) {
    if (!is_rising(start) || std::isnan(tied[mesh.source(start)]) || !std::isnan(tied[mesh.target(start)])) continue;
    std::vector<std::pair<typename Part<Traits>::Vertex, double>> inner;
    double length = 0;
    auto h = start;
    for (;;) {
      length += norm(part.coordinates(mesh.target(h)) - part.coordinates(mesh.source(h)));
      if (!std::isnan(tied[mesh.target(h)]) || part.corner[mesh.target(h)]) break;
      inner.push_back({mesh.target(h), length});
      for (auto in : mesh.halfedges_around_target(h))
        if (in != h && part.feature[mesh.edge(in)]) {
          h = mesh.opposite(in);
          break;
        }
    }
    const double low = tied[mesh.source(start)], high = tied[mesh.target(h)];
    if (!(low < high)) continue;
    for (const auto& [v, l] : inner) layering.parameter[v] = low + (high - low) * (l / length);
  }
}

// What the corner of a face at the target of a halfedge adds to the weights of its two edges there, over their length:
// mean value weights (Floater 2003). They are positive, so that the solution has its extremes on the caps, and
// reproduce linear functions, so that rows on a flat wall don't depend on how it is triangulated.
template <class Traits>
double corner_weight(const Part<Traits>& part, typename Part<Traits>::Halfedge h) {
  const Vec3 v = part.coordinates(part.mesh.target(h));
  const double corner =
      angle(part.coordinates(part.mesh.source(h)) - v, part.coordinates(part.mesh.target(part.mesh.next(h))) - v);
  return std::tan(std::clamp(corner, 1e-9, 3.14159) / 2);
}

// Between bent or leaning caps: harmonic on the linking faces, with the levels' values on the caps' curves.
template <class Traits>
void solve_harmonic(const Part<Traits>& part, const Roles& roles, Layering& layering) {
  const auto& mesh = part.mesh;
  std::vector<int> unknown(mesh.number_of_vertices(), -1);
  int n = 0;
  for (auto v : mesh.vertices())
    if (std::isnan(layering.parameter[v])) unknown[v] = n++;
  if (n == 0) return;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (auto h : mesh.halfedges()) {
    const auto v = mesh.target(h);
    if (unknown[v] < 0 || roles.of_patch[part.patch(mesh.face(h)).value()] != Role::linking) continue;
    const double corner = corner_weight(part, h);
    for (auto u : {mesh.source(h), mesh.target(mesh.next(h))}) {
      const double w = corner / norm(part.coordinates(u) - part.coordinates(v));
      entries.emplace_back(unknown[v], unknown[v], w);
      if (unknown[u] >= 0)
        entries.emplace_back(unknown[v], unknown[u], -w);
      else
        right[unknown[v]] += w * layering.parameter[u];
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success)
    fail(Status_code::inconsistent_levels, Stage::layers, "a linking face is tied to no source and no target");
  const Eigen::VectorXd solution = solver.solve(right);
  if (!solution.allFinite())
    fail(Status_code::inconsistent_levels, Stage::layers, "a linking face is tied to no source and no target");
  for (auto v : mesh.vertices())
    if (unknown[v] >= 0) layering.parameter[v] = solution[unknown[v]];
}

// How far the sweep turns between two values, in radians: the largest angle between the directions that the linking
// faces lead in and their mean, twice.
template <class Traits>
double turning_between(const Part<Traits>& part, const Roles& roles, const Layering& layering, double low,
                       double high) {
  if (roles.is_straight()) return 0;
  std::vector<Vec3> directions;
  Vec3 mean{};
  for (auto f : part.mesh.faces()) {
    if (roles.of_patch[part.patch(f).value()] != Role::linking) continue;
    double least = 1e300, most = -1e300;
    for (auto v : part.mesh.vertices_around_face(part.mesh.halfedge(f))) {
      least = std::min(least, layering.parameter[v]);
      most = std::max(most, layering.parameter[v]);
    }
    if (most <= low || least >= high) continue;
    directions.push_back(roles.along(f));
    mean = mean + part.area[f] * roles.along(f);
  }
  double worst = 0;
  for (const Vec3& d : directions) worst = std::max(worst, 2 * angle(d, mean));
  return worst;
}

// The slabs between two levels that the bending of the walls or the user asks for.
template <class Traits>
std::size_t slabs_between(const Part<Traits>& part, const Roles& roles, const Layering_options& options,
                          const Layering& layering, double low, double high) {
  const double turning = turning_between(part, roles, layering, low, high);
  const double spanning = options.spanning_angle * 3.14159265358979323846 / 180;
  const std::size_t slabs = 1 + static_cast<std::size_t>(turning / spanning);
  // A half, which rounding may have lifted or lowered, counts as lowered.
  return std::max({slabs, static_cast<std::size_t>(options.slabs),
                   static_cast<std::size_t>(std::lround((high - low) / options.spacing - 1e-6))});
}

// Further rows between the levels, where walls bend or the user asks for them; the counts of sub-volumes and sets do
// not depend on them.
template <class Traits>
void insert_rows(const Part<Traits>& part, const Roles& roles, const Layering_options& options,
                 Layering& layering) {
  const std::vector<double> levels = layering.layers;
  layering.layers.clear();
  layering.level_of_layer.clear();
  const auto add_row = [&](double value) {
    layering.layers.push_back(value);
    layering.level_of_layer.push_back(Level_index());
  };
  for (std::size_t i = 0; i < levels.size(); ++i) {
    layering.layers.push_back(levels[i]);
    layering.level_of_layer.push_back(Level_index(i));
    if (i + 1 == levels.size()) break;
    const double gap = levels[i + 1] - levels[i];
    std::size_t slabs = slabs_between(part, roles, options, layering, levels[i], levels[i + 1]);
    std::vector<double> stops{levels[i]};
    const double resolution = height_resolution(part);
    for (double value : options.through)
      if (value > levels[i] + resolution && value < levels[i + 1] - resolution) stops.push_back(value);
    if (stops.size() > 1)
      slabs = 1;
    else if (options.through_vertices)
      stops = rows_through_vertices(part, roles, levels[i], levels[i + 1], gap / double(slabs), layering.parameter);
    for (std::size_t s = 0; s < stops.size(); ++s) {
      if (s > 0) add_row(stops[s]);
      const double between = (s + 1 < stops.size() ? stops[s + 1] : levels[i + 1]) - stops[s];
      const double parts = std::max(1., std::ceil(between / gap * double(slabs) - 0.1));
      for (double k = 1; k < parts; ++k) add_row(stops[s] + between * k / parts);
    }
  }
}

inline void check_options(const Layering_options& options) {
  if (!(options.spanning_angle > 0 && options.spanning_angle <= 180))
    fail(Status_code::invalid_parameter, Stage::layers, "the spanning angle must lie between 0 and 180 degrees");
  if (options.slabs < 1 || options.slabs > 10000)
    fail(Status_code::invalid_parameter, Stage::layers, "the number of layers must lie between 1 and 10000");
}

}  // namespace internal

/// Computes the sweep parameter, ranks the caps into levels and places the layers (sections 2.1 to 2.3).
///
/// Between flat caps across a straight sweep the parameter is the height; otherwise it is harmonic on the linking
/// faces with one value on each group of connected caps. A cap's level is the rank of its parameter among all caps,
/// so blind pockets and leg tips, which no wall ties to the caps around them, have one as well; of a sweep that bends,
/// the planes of the caps say which of them stand beside one another.
/// \return `inconsistent_levels` naming the patches where caps contradict each other.
/// Complexity: O(n log n); the harmonic case solves one sparse system. For a sweep that bends, also linear in the paths
/// up the linking faces for each group of caps.
template <class Traits>
Result<Layering> make_layering(const Part<Traits>& part, const Roles& roles, const Layering_options& options) {
  return internal::guarded([&] {
    using namespace internal;
    check_options(options);
    Layering layering;
    layering.parameter.assign(part.mesh.number_of_vertices(), Layering::none);
    std::vector<Cap_group> groups = group_caps(part, roles);
    fit_heights(part, roles, groups);
    rank_levels(part, groups, layering);
    tie_cap_borders(part, layering);
    if (std::all_of(groups.begin(), groups.end(), [](const Cap_group& g) { return g.flat; })) {
      use_heights(part, roles, layering);
    } else {
      tie_cap_vertices(part, layering);
      tie_rising_curves(part, roles, layering);
      solve_harmonic(part, roles, layering);
    }
    insert_rows(part, roles, options, layering);
    snap_vertices_to_layers(part, layering);
    return layering;
  });
}

}  // namespace CCSweep

#endif
