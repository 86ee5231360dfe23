// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The decomposition of a part with eight sub-volumes against its corefinement by CGAL with the same cuts, which are
// handed to CGAL while ours has to find them first. Checks are left out on both sides: ours of the input and of the
// result, CGAL's for self-intersections. The time is ours; the peer's stands in a counter, and so does the ratio.
#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "curved_parts.h"

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Decomposition = CCSweep::Decomposition<Kernel::Point_3>;
using random_parts::Part;

double seconds_of(const auto& function) {
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Two by four targets on four levels under three by three sources on three.
Part eight_volumes() {
  random_parts::Plan plan;
  auto add_tiles = [](std::vector<random_parts::Paint>& paints, std::vector<double> x, std::vector<double> y,
                      double height, double step) {
    for (std::size_t i = 1; i < x.size(); ++i, height += step)
      for (std::size_t j = 1; j < y.size(); ++j)
        paints.push_back(
            {{{x[i - 1], y[j - 1]}, {x[i], y[j - 1]}, {x[i], y[j]}, {x[i - 1], y[j]}}, height, true});
  };
  plan.material = {{{{0, 0}, {24, 0}, {24, 24}, {0, 24}}}};
  plan.bottom = 4;
  plan.top = 8;
  add_tiles(plan.bottoms, {0, 5, 11, 16, 24}, {0, 13, 24}, 1, 1);
  add_tiles(plan.tops, {0, 8, 14, 24}, {0, 9, 18, 24}, 8, 1);
  return *random_parts::build(plan);
}

// About as many triangles as asked for, evenly.
Part refined(Part part, std::size_t triangles) {
  constexpr int slices = 12;
  for (int axis = 0; axis < 3; ++axis) part = curved_parts::sliced(std::move(part), axis, slices);
  while (2 * part.triangles.size() < triangles)
    part = split_edges::once(part,
                             [](const auto& p, const auto& q) { return std::optional(split_edges::middle(p, q)); });
  return part;
}

// One mesh for each decomposition set: a junction of several is no manifold.
std::vector<Mesh> cuts(const Decomposition& found) {
  std::vector<Mesh> result(found.sets.size());
  for (std::size_t s = 0; s < found.sets.size(); ++s) {
    const Mesh& volume = found.volumes[found.sets[s].volumes[0]].mesh;
    const auto id = volume.property_map<Mesh::Face_index, int>("f:patch_id").first;
    std::map<Mesh::Vertex_index, Mesh::Vertex_index> copy;
    for (Mesh::Face_index f : volume.faces()) {
      if (id[f] != found.sets[s].id) continue;
      std::vector<Mesh::Vertex_index> corners;
      for (Mesh::Vertex_index v : volume.vertices_around_face(volume.halfedge(f))) {
        const auto [at, is_new] = copy.try_emplace(v);
        if (is_new) at->second = result[s].add_vertex(volume.point(v));
        corners.push_back(at->second);
      }
      result[s].add_face(corners);
    }
  }
  return result;
}

double corefinement_seconds(Mesh part, std::vector<Mesh> cuts) {
  return seconds_of([&] {
    for (Mesh& cut : cuts) PMP::corefine(part, cut);
    benchmark::DoNotOptimize(part.number_of_faces());
  });
}

bool is_right(const Part& part, const Decomposition& found) {
  if (found.volumes.size() != 8) return false;
  for (const auto& v : found.volumes)
    if (std::abs(PMP::volume(v.mesh) - part.sub_volumes.at(v.target)) > 1e-9 * part.volume) return false;
  return true;
}

void eight_volumes_against_corefinement(benchmark::State& state) {
  const Part part = refined(eight_volumes(), static_cast<std::size_t>(state.range(0)));
  const Mesh mesh = random_parts::mesh<Kernel::Point_3>(part);
  const auto patch = mesh.property_map<Mesh::Face_index, int>("f:patch_id").first;
  std::optional<Decomposition> found;
  double ours = 0;
  for (auto _ : state) {
    // The stage `part` without the check of the input.
    double seconds = seconds_of([&] {
      benchmark::DoNotOptimize(CCSweep::make_part<Kernel>(mesh, get(CGAL::vertex_point, mesh), patch).ok());
    });
    auto result = CCSweep::decompose(
        mesh, CCSweep::parameters::direction(std::array<double, 3>{0, 0, 1}).face_patch_map(patch));
    if (!result.ok()) return state.SkipWithError(result.status().reason.c_str());
    found = std::move(result).value();
    for (const auto& [stage, s] : found->seconds) seconds += stage == "part" || stage == "verification" ? 0 : s;
    state.SetIterationTime(seconds);
    ours += seconds;
  }
  if (!is_right(part, *found)) return state.SkipWithError("the sub-volumes are not those of the construction");
  const double peer = corefinement_seconds(mesh, cuts(*found));
  state.counters["triangles"] = static_cast<double>(part.triangles.size());
  state.counters["volumes"] = static_cast<double>(found->volumes.size());
  state.counters["sets"] = static_cast<double>(found->sets.size());
  state.counters["corefinement_ms"] = 1000 * peer;
  state.counters["times_faster"] = peer / (ours / static_cast<double>(state.iterations()));
}

}  // namespace

BENCHMARK(eight_volumes_against_corefinement)
    ->Arg(10000)->Arg(100000)->UseManualTime()->Unit(benchmark::kMillisecond);
