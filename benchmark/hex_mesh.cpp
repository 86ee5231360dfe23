// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hexahedra a second: of the sweep of a cell's interior alone, and of the whole mesh of a plate with holes, beside
// Gmsh's extruded recombined mesh of the same plate where Gmsh is installed.
#include <CCSweep/decompose.h>
#include <CCSweep/hex/Cap_triangulation.h>
#include <CCSweep/hex/Cell_sweeper.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex_mesh.h>
#include <CCSweep/parameters.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>
#ifdef CCSWEEP_GMSH
#include <gmsh.h>
#endif

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using CCSweep::Quad_mesh;
using CCSweep::Quad_region;
using CCSweep::internal::Vec3;

constexpr double width = 40, height = 30, thickness = 10, radius = 4;
constexpr double centres[4][2] = {{10, 8}, {30, 8}, {10, 22}, {30, 22}};

void add_side(Quad_region::Loop& loop, Quad_region::Point a, Quad_region::Point b, double size) {
  const int n = 2 * std::max(1, static_cast<int>(std::lround(std::hypot(b[0] - a[0], b[1] - a[1]) / size / 2)));
  for (int k = 0; k < n; ++k) loop.nodes.push_back({a[0] + (b[0] - a[0]) * k / n, a[1] + (b[1] - a[1]) * k / n});
}

// The plate seen from above.
Quad_region plate(double size) {
  Quad_region region;
  auto& outer = region.loops.emplace_back();
  const Quad_region::Point corners[4] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  for (int i = 0; i < 4; ++i) add_side(outer, corners[i], corners[(i + 1) % 4], size);
  for (const auto& c : centres) {
    auto& hole = region.loops.emplace_back();
    const int n = 2 * static_cast<int>(std::lround(std::numbers::pi * radius / size));
    for (int k = 0; k < n; ++k) {
      const double angle = -2 * std::numbers::pi * k / n;
      hole.nodes.push_back({c[0] + radius * std::cos(angle), c[1] + radius * std::sin(angle)});
    }
  }
  return region;
}

// The outline on the layers of a sweep that bulges, so that no affine map fits it.
std::vector<std::vector<Vec3>> outlines(const Quad_region& region, std::size_t layers, double bulge) {
  std::vector<std::vector<Vec3>> result;
  for (std::size_t k = 0; k <= layers; ++k) {
    auto& outline = result.emplace_back();
    const double t = double(k) / double(layers), b = bulge * std::sin(std::numbers::pi * t);
    for (const auto& loop : region.loops)
      for (const auto& [x, y] : loop.nodes)
        outline.push_back({x + b * std::sin(y / 5), y + b * std::sin(x / 7), 10 * t});
  }
  return result;
}

CCSweep::internal::Cell_nodes sweep(const Quad_mesh& quads, const std::vector<std::vector<Vec3>>& outlines) {
  std::vector<double> heights;
  for (std::size_t k = 0; k < outlines.size(); ++k) heights.push_back(double(k));
  const auto stay = [](const Vec3& p) { return p; };
  return CCSweep::internal::sweep_cell(quads, outlines, heights, stay, stay);
}

void sweep_interior(benchmark::State& state) {
  const double size = 40.0 / double(state.range(0));
  const std::size_t layers = 100;
  const Quad_region region = plate(size);
  const Quad_mesh quads = CCSweep::Best_quads()(region, size).value();
  const auto rows = outlines(region, layers, 0.5);
  for (auto _ : state) benchmark::DoNotOptimize(sweep(quads, rows));
  state.counters["hexes"] = benchmark::Counter(double(quads.quads.size() * layers),
                                               benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(sweep_interior)->Arg(40)->Arg(80)->Unit(benchmark::kMillisecond);

// The plate as a closed triangle mesh: its outline, twice, with walls between; a patch for each face.
Mesh plate_mesh() {
  constexpr double chord = 0.5;
  const Quad_region region = plate(chord);
  Mesh mesh;
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch_id", -1).first;
  std::vector<Mesh::Vertex_index> low, high;
  for (const auto& loop : region.loops)
    for (const auto& [x, y] : loop.nodes) {
      low.push_back(mesh.add_vertex({x, y, 0}));
      high.push_back(mesh.add_vertex({x, y, thickness}));
    }
  const auto add = [&](auto a, auto b, auto c, int id) { patch[mesh.add_face(a, b, c)] = id; };
  CCSweep::internal::Cap_triangulation caps(region, 100, 1);
  caps.run();
  std::vector<Mesh::Vertex_index> below(low), above(high);
  for (std::size_t n = low.size(); n < caps.points.size(); ++n) {
    below.push_back(mesh.add_vertex({caps.points[n][0], caps.points[n][1], 0}));
    above.push_back(mesh.add_vertex({caps.points[n][0], caps.points[n][1], thickness}));
  }
  for (const auto& [a, b, c] : caps.triangles) {
    add(below[a], below[c], below[b], 0);
    add(above[a], above[b], above[c], 1);
  }
  std::size_t first = 0;
  int id = 2;
  for (const auto& loop : region.loops) {
    const bool is_outer = first == 0;
    for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
      const std::size_t a = first + i, b = first + (i + 1) % loop.nodes.size();
      const auto& p = loop.nodes[i];
      const bool turns = is_outer && (p[0] == 0 || p[0] == width) && (p[1] == 0 || p[1] == height);
      if (i > 0 && turns) ++id;
      add(low[a], low[b], high[b], id);
      add(low[a], high[b], high[a], id);
    }
    ++id;
    first += loop.nodes.size();
  }
  return mesh;
}

// A figure of this process from the system, in bytes: VmRSS is the memory it has, VmHWM the most it had.
double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == name + ':' && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

// Gives back what is free, and forgets the most there was.
void forget_peak() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::size_t memory_of(const CCSweep::Hex_mesh& mesh) {
  return mesh.points.size() * sizeof mesh.points[0] +
         mesh.hexes.size() * (sizeof mesh.hexes[0] + sizeof mesh.volume[0]) +
         mesh.boundary.size() * sizeof mesh.boundary[0];
}

// All of `hex_mesh()` on a decomposition, from the check of its surface on. Its last step, the proof that all
// hexahedra are positive, is timed by itself: it stands in a counter, and not in the time. So does the memory at its
// peak, in units of the mesh's own.
void whole_plate(benchmark::State& state) {
  const double size = width / double(state.range(0));
  const Mesh plate = plate_mesh();
  const auto patch = plate.property_map<Mesh::Face_index, int>("f:patch_id").first;
  const auto np = CCSweep::parameters::direction(std::array<double, 3>{0, 0, 1}).face_patch_map(patch);
  const auto decomposition = CCSweep::decompose(plate, np).value();
  std::size_t hexes = 0;
  double proof = 0, peak = 0;
  for (auto _ : state) {
    forget_peak();
    const double before = memory("VmRSS"), start = cpu_seconds();
    const auto made = CCSweep::hex_mesh(decomposition, CCSweep::parameters::size(size));
    const double end = cpu_seconds();
    if (!made) {
      state.SkipWithError(made.status().reason.c_str());
      break;
    }
    peak = std::max(peak, (memory("VmHWM") - before) / double(memory_of(made.value())));
    hexes = made.value().hexes.size();
    const double proof_start = cpu_seconds();
    CCSweep::internal::certify(made.value());
    proof = cpu_seconds() - proof_start;
    state.SetIterationTime(end - start - proof);
  }
  state.counters["hexes"] = benchmark::Counter(double(hexes), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["count"] = double(hexes);
  state.counters["proof_ms"] = 1000 * proof;
  state.counters["memory"] = peak;
}
BENCHMARK(whole_plate)->Arg(92)->Arg(120)->Arg(160)->UseManualTime()->Unit(benchmark::kMillisecond);

#ifdef CCSWEEP_GMSH
void whole_plate_by_gmsh(benchmark::State& state) {
  const double size = 40.0 / double(state.range(0));
  std::size_t hexes = 0;
  for (auto _ : state) {
    const double start = cpu_seconds();
    gmsh::initialize();
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.MeshSizeMin", size);
    gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    const int plate = gmsh::model::occ::addRectangle(0, 0, 0, width, height);
    gmsh::vectorpair holes, cut, extruded;
    std::vector<gmsh::vectorpair> map;
    for (const auto& c : centres) holes.push_back({2, gmsh::model::occ::addDisk(c[0], c[1], 0, radius, radius)});
    gmsh::model::occ::cut({{2, plate}}, holes, cut, map);
    gmsh::model::occ::extrude(cut, 0, 0, thickness, extruded, {static_cast<int>(thickness / size)}, {}, true);
    gmsh::model::occ::synchronize();
    gmsh::model::mesh::setRecombine(2, cut[0].second);
    gmsh::model::mesh::generate(3);
    std::vector<int> types;
    std::vector<std::vector<std::size_t>> tags, nodes;
    gmsh::model::mesh::getElements(types, tags, nodes, 3);
    hexes = 0;
    for (std::size_t i = 0; i < types.size(); ++i)
      if (types[i] == 5) hexes += tags[i].size();
    gmsh::finalize();
    state.SetIterationTime(cpu_seconds() - start);
  }
  state.counters["hexes"] = benchmark::Counter(double(hexes), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["count"] = double(hexes);
}
BENCHMARK(whole_plate_by_gmsh)->Arg(92)->Arg(120)->Arg(160)->UseManualTime()->Unit(benchmark::kMillisecond);
#endif

}  // namespace
