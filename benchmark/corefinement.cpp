// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The decomposition of a part with eight sub-volumes against its corefinement by CGAL with the same cuts, which are
// handed to CGAL while ours has to find them first. Checks are left out on both sides: ours of the input and of the
// result, CGAL's for self-intersections. The time is ours; the peer's stands in a counter, and so does the ratio.
//
// A corefined part is not cut yet: the border of a cut lies off the part by rounding, so that the part's facets stay
// whole where it lies inside, and what is drawn doesn't part the surface. Two more counters tell what it takes with
// CGAL to get the eight closed meshes: Boolean operations with boxes that end where the cuts do, sparing CGAL their
// triangles, and that split the part in halves, these again and so on, so that each triangle takes part in three.
#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <utility>
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

// Where targets meet.
constexpr std::array<double, 3> along{5, 11, 16};
constexpr double across = 13;

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
  add_tiles(plan.bottoms, {0, along[0], along[1], along[2], 24}, {0, across, 24}, 1, 1);
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

// A box of twelve triangles, from beyond the part up to (x, y).
Mesh box_up_to(double x, double y) {
  constexpr double low = -1, high = 25;
  const auto at = [&](double u, double v, double w) { return Kernel::Point_3(u, v, w); };
  Mesh box;
  CGAL::make_hexahedron(at(low, low, low), at(x, low, low), at(x, y, low), at(low, y, low), at(low, y, high),
                        at(low, low, high), at(x, low, high), at(x, y, high), box);
  PMP::triangulate_faces(box);
  return box;
}

// What is inside a box and what is outside.
std::array<Mesh, 2> split(Mesh& mesh, Mesh box) {
  std::array<Mesh, 2> sides;
  std::array<boost::optional<Mesh*>, 4> wanted;
  wanted[PMP::Corefinement::INTERSECTION] = &sides[0];
  wanted[PMP::Corefinement::TM1_MINUS_TM2] = &sides[1];
  PMP::corefine_and_compute_boolean_operations(mesh, box, wanted);
  return sides;
}

// Splits at the middle one of some values of x and goes on with both sides; at last at the one value of y.
void add_pieces(Mesh mesh, std::span<const double> x, std::vector<Mesh>& pieces) {
  constexpr double beyond = 25;
  if (x.empty()) {
    std::ranges::move(split(mesh, box_up_to(beyond, across)), std::back_inserter(pieces));
    return;
  }
  const std::size_t middle = x.size() / 2;
  auto [left, right] = split(mesh, box_up_to(x[middle], beyond));
  add_pieces(std::move(left), x.first(middle), pieces);
  add_pieces(std::move(right), x.subspan(middle + 1), pieces);
}

std::vector<double> volumes(const auto& solids, const auto& mesh_of) {
  std::vector<double> result;
  for (const auto& solid : solids) result.push_back(PMP::volume(mesh_of(solid)));
  std::ranges::sort(result);
  return result;
}

bool are_alike(const std::vector<Mesh>& pieces, const Decomposition& found) {
  const auto theirs = volumes(pieces, std::identity()), ours = volumes(found.volumes, [](auto& v) -> auto& { return v.mesh; });
  return std::ranges::all_of(pieces, [](const Mesh& piece) { return CGAL::is_closed(piece); }) &&
         std::ranges::equal(theirs, ours, [](double v, double w) { return std::abs(v - w) <= 1e-9 * w; });
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
  std::vector<Mesh> pieces;
  const double closing_peer = seconds_of([&] { add_pieces(mesh, along, pieces); });
  if (!are_alike(pieces, *found)) return state.SkipWithError("the peer's volumes are not those of the decomposition");
  state.counters["triangles"] = static_cast<double>(part.triangles.size());
  state.counters["volumes"] = static_cast<double>(found->volumes.size());
  state.counters["sets"] = static_cast<double>(found->sets.size());
  state.counters["corefinement_ms"] = 1000 * peer;
  const double mean = ours / static_cast<double>(state.iterations());
  state.counters["times_faster"] = peer / mean;
  state.counters["closed_meshes_ms"] = 1000 * closing_peer;
  state.counters["times_faster_than_closed_meshes"] = closing_peer / mean;
}

}  // namespace

BENCHMARK(eight_volumes_against_corefinement)
    ->Arg(10000)->Arg(100000)->UseManualTime()->Unit(benchmark::kMillisecond);
