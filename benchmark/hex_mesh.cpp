// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hexahedra a second: of the sweep of a cell's interior alone, and of the whole mesh of a plate with holes, beside
// Gmsh's extruded recombined mesh of the same plate where Gmsh is installed.
#include <CCSweep/hex/Cell_sweeper.h>
#include <CCSweep/hex/mesh_quads.h>

#include <benchmark/benchmark.h>
#ifdef CCSWEEP_GMSH
#include <gmsh.h>
#endif

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace {

using CCSweep::Quad_mesh;
using CCSweep::Quad_region;
using CCSweep::internal::Vec3;

constexpr double width = 40, height = 30, radius = 4;
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

// Cap, sweep, and the proof that all is positive.
void whole_plate(benchmark::State& state) {
  const double size = 40.0 / double(state.range(0));
  const auto layers = static_cast<std::size_t>(10 / size);
  std::size_t hexes = 0;
  for (auto _ : state) {
    const Quad_region region = plate(size);
    const Quad_mesh quads = CCSweep::Best_quads()(region, size).value();
    const auto nodes = sweep(quads, outlines(region, layers, 0));
    hexes = quads.quads.size() * layers;
    bool is_positive = true;
    for (std::size_t k = 0; k < layers; ++k)
      for (const auto& quad : quads.quads) {
        CCSweep::Hex_corners corners;
        for (std::size_t i = 0; i < 4; ++i) {
          corners[i] = nodes[k][quad[i]];
          corners[i + 4] = nodes[k + 1][quad[i]];
        }
        is_positive &= CCSweep::is_positive(corners);
      }
    if (!is_positive) state.SkipWithError("a hexahedron is folded");
  }
  state.counters["hexes"] = benchmark::Counter(double(hexes), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["count"] = double(hexes);
}
BENCHMARK(whole_plate)->Arg(80)->Arg(160)->Unit(benchmark::kMillisecond);

#ifdef CCSWEEP_GMSH
void whole_plate_by_gmsh(benchmark::State& state) {
  const double size = 40.0 / double(state.range(0));
  std::size_t hexes = 0;
  for (auto _ : state) {
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
    gmsh::model::occ::extrude(cut, 0, 0, 10, extruded, {static_cast<int>(10 / size)}, {}, true);
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
  }
  state.counters["hexes"] = benchmark::Counter(double(hexes), benchmark::Counter::kIsIterationInvariantRate);
  state.counters["count"] = double(hexes);
}
BENCHMARK(whole_plate_by_gmsh)->Arg(80)->Arg(160)->Unit(benchmark::kMillisecond);
#endif

}  // namespace
