// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The decomposition of a part with eight sub-volumes against its corefinement by CGAL with the same cuts, which are
// handed to CGAL while ours has to find them first. Checks are left out on both sides: ours of the input and of the
// result, CGAL's for self-intersections. The time is ours; the peer's stands in a counter, and so does the ratio. As a
// corefined part is not cut yet, two more counters tell what it takes with CGAL to get the eight closed meshes.
#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
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

struct Soup {
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  void add(const Mesh& mesh, Mesh::Face_index f, bool is_reversed) {
    auto& t = triangles.emplace_back();
    std::size_t k = 0;
    for (Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      t[k++] = points.size();
      points.push_back(mesh.point(v));
    }
    if (is_reversed) std::swap(t[1], t[2]);
  }

  Mesh connected() {
    Mesh mesh;
    PMP::merge_duplicate_points_in_polygon_soup(points, triangles);
    PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
    return mesh;
  }
};

// The sub-volume at each border edge of the cuts that lies on the part, by the direction of the part's halfedge there.
std::map<std::array<Kernel::Point_3, 2>, int> sides(const std::vector<Mesh>& cuts, const Decomposition& found) {
  std::map<std::array<Kernel::Point_3, 2>, int> result;
  for (std::size_t s = 0; s < cuts.size(); ++s)
    for (Mesh::Halfedge_index h : cuts[s].halfedges()) {
      if (!cuts[s].is_border(h)) continue;
      const auto &p = cuts[s].point(cuts[s].source(h)), &q = cuts[s].point(cuts[s].target(h));
      result[{p, q}] = found.sets[s].volumes[0];
      result[{q, p}] = found.sets[s].volumes[1];
    }
  return result;
}

// The pieces of the corefined part between the cuts, and the cuts on both of their sides, joined to closed meshes.
std::vector<Mesh> closed_by_corefinement(Mesh& part, std::vector<Mesh>& cuts, const Decomposition& found) {
  const auto on_cut = part.add_property_map<Mesh::Edge_index, bool>("e:on_cut", false).first;
  const auto constrained = CGAL::parameters::edge_is_constrained_map(on_cut);
  for (Mesh& cut : cuts) PMP::corefine(part, cut, constrained);
  const auto piece = part.add_property_map<Mesh::Face_index, std::size_t>("f:piece").first;
  std::vector<int> volume(PMP::connected_components(part, piece, constrained), 0);
  const auto side = sides(cuts, found);
  for (Mesh::Halfedge_index h : part.halfedges())
    if (on_cut[part.edge(h)])
      if (const auto known = side.find({part.point(part.source(h)), part.point(part.target(h))}); known != side.end())
        volume[piece[part.face(h)]] = known->second;
  std::vector<Soup> soups(found.volumes.size());
  for (Mesh::Face_index f : part.faces()) soups[volume[piece[f]]].add(part, f, false);
  for (std::size_t s = 0; s < cuts.size(); ++s)
    for (Mesh::Face_index f : cuts[s].faces())
      for (std::size_t i : {0, 1}) soups[found.sets[s].volumes[i]].add(cuts[s], f, i == 1);
  std::vector<Mesh> result;
  for (Soup& soup : soups) result.push_back(soup.connected());
  return result;
}

bool are_alike(const std::vector<Mesh>& meshes, const Decomposition& found) {
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const double ours = PMP::volume(found.volumes[i].mesh);
    if (!CGAL::is_closed(meshes[i]) || std::abs(PMP::volume(meshes[i]) - ours) > 1e-9 * ours) return false;
  }
  return meshes.size() == found.volumes.size();
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
  Mesh corefined = mesh;
  std::vector<Mesh> cut_meshes = cuts(*found), closed;
  const double closing_peer = seconds_of([&] { closed = closed_by_corefinement(corefined, cut_meshes, *found); });
  if (!are_alike(closed, *found)) return state.SkipWithError("the peer's volumes are not those of the decomposition");
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
