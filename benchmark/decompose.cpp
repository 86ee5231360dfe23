// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The whole decomposition, on parts whose polygons get finer and on parts with ever more features. The time is that of
// all stages; each stage's share stands in a counter, and so does the verification's, which is not in `time_without`.
#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Point = std::array<double, 2>;

constexpr double pi = 3.14159265358979323846;

// Builds a plate with prisms below and above: each prism is a closed polygon on the plate, a wall and a cap. The
// plate's faces are triangulated between the polygons by cells: each prism stands alone in a square cell.
class Table {
 public:
  // A grid of k x k unit cells; each cell may carry one prism below and one above.
  explicit Table(int k) : k_(k) {
    patch_ = mesh_.add_property_map<Mesh::Face_index, int>("f:patch_id", -1).first;
    for (int side : {0, 1}) {
      corners_[side].resize((k + 1) * (k + 1));
      for (int j = 0; j <= k; ++j)
        for (int i = 0; i <= k; ++i) corners_[side][j * (k + 1) + i] = add_vertex({double(i), double(j)}, side);
    }
    add_rim();
  }

  // `side` 0: below, the outline must turn counter-clockwise and surround the cell's centre as a star.
  void add_cell(int i, int j, int side, const std::vector<Point>& outline, double height) {
    const double plane = side;
    std::vector<Mesh::Vertex_index> foot, tip;
    for (const Point& p : outline) foot.push_back(add_vertex(p, plane));
    if (outline.empty()) {
      const auto c = cell(i, j, side);
      add(c[0], c[1], c[2], side, side);
      add(c[0], c[2], c[3], side, side);
      return;
    }
    for (const Point& p : outline) tip.push_back(add_vertex(p, plane + height));
    add_surroundings(i, j, side, outline, foot);
    const int wall = next_patch_++, cap = next_patch_++;
    const std::size_t n = outline.size();
    for (std::size_t a = 0; a < n; ++a) {
      const std::size_t b = (a + 1) % n;
      add(foot[a], foot[b], tip[b], side, wall);
      add(foot[a], tip[b], tip[a], side, wall);
    }
    for (std::size_t a = 1; a + 1 < n; ++a) add(tip[0], tip[a], tip[a + 1], side, cap);
  }

  const Mesh& mesh() const { return mesh_; }
  auto patch() const { return patch_; }

 private:
  Mesh::Vertex_index add_vertex(const Point& p, double z) { return mesh_.add_vertex(Kernel::Point_3(p[0], p[1], z)); }

  // As seen from above; the lower side is turned over.
  void add(Mesh::Vertex_index a, Mesh::Vertex_index b, Mesh::Vertex_index c, int side, int id) {
    patch_[side == 0 ? mesh_.add_face(a, c, b) : mesh_.add_face(a, b, c)] = id;
  }

  std::array<Mesh::Vertex_index, 4> cell(int i, int j, int side) const {
    auto at = [&](int x, int y) { return corners_[side][y * (k_ + 1) + x]; };
    return {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
  }

  // Between the outline and its cell: zipped up by angle about the cell's centre.
  void add_surroundings(int i, int j, int side, const std::vector<Point>& outline,
                        const std::vector<Mesh::Vertex_index>& foot) {
    const auto corners = cell(i, j, side);
    auto turn = [&](const Point& p) {
      return std::atan2(p[1] - j - 0.5, p[0] - i - 0.5) + pi;  // each corner sees its quadrant
    };
    std::size_t first = 0;
    for (std::size_t a = 1; a < outline.size(); ++a)
      if (turn(outline[a]) < turn(outline[first])) first = a;
    const std::size_t n = outline.size();
    std::size_t a = 0, c = 0;
    while (a < n || c < 4) {
      const auto inner = foot[(first + a) % n];
      const auto outer = corners[c % 4];
      const double next_inner = a + 1 < n ? turn(outline[(first + a + 1) % n]) : 2 * pi + turn(outline[first]);
      const double next_outer = (c + 1) * pi / 2;
      if (c < 4 && (a == n || next_outer <= next_inner)) {
        add(inner, outer, corners[(c + 1) % 4], side, side);
        ++c;
      } else {
        add(inner, outer, foot[(first + a + 1) % n], side, side);
        ++a;
      }
    }
  }

  void add_rim() {
    auto wall = [&](int x, int y, int u, int v, int id) {
      const auto a = corners_[0][y * (k_ + 1) + x], b = corners_[0][v * (k_ + 1) + u],
                 c = corners_[1][v * (k_ + 1) + u], d = corners_[1][y * (k_ + 1) + x];
      add(a, b, c, 1, id);
      add(a, c, d, 1, id);
    };
    for (int i = 0; i < k_; ++i) {
      wall(i, 0, i + 1, 0, 2);
      wall(k_, i, k_, i + 1, 3);
      wall(i + 1, k_, i, k_, 4);
      wall(0, i + 1, 0, i, 5);
    }
  }

  int k_, next_patch_ = 6;
  Mesh mesh_;
  Mesh::Property_map<Mesh::Face_index, int> patch_;
  std::array<std::vector<Mesh::Vertex_index>, 2> corners_;
};

std::vector<Point> circle(double x, double y, double radius, int n) {
  std::vector<Point> result;
  for (int i = 0; i < n; ++i)
    result.push_back({x + radius * std::cos(2 * pi * i / n), y + radius * std::sin(2 * pi * i / n)});
  return result;
}

std::vector<Point> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// Four round legs and four round posts that overlap them halfway; circles of n segments.
Table round_table(int n) {
  Table table(2);
  for (int j : {0, 1})
    for (int i : {0, 1}) {
      table.add_cell(i, j, 0, circle(i + 0.45, j + 0.45, 0.25, n), -2);
      table.add_cell(i, j, 1, circle(i + 0.58, j + 0.52, 0.2, n), 1);
    }
  return table;
}

// The same with posts that stand on the legs, each node above another: everything coincides.
Table matching_table(int n) {
  Table table(2);
  for (int j : {0, 1})
    for (int i : {0, 1}) {
      table.add_cell(i, j, 0, circle(i + 0.5, j + 0.5, 0.25, n), -2);
      table.add_cell(i, j, 1, circle(i + 0.5, j + 0.5, 0.25, n), 1);
    }
  return table;
}

// Square posts over square legs, half a leg aside, k x k of both; the legs differ in height, so there are many levels.
Table forest(int k, int heights) {
  Table table(k);
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i) {
      table.add_cell(i, j, 0, rectangle(i + 0.2, j + 0.2, i + 0.7, j + 0.7), -1.0 - (i + j) % heights);
      table.add_cell(i, j, 1, rectangle(i + 0.4, j + 0.3, i + 0.8, j + 0.6), 1.0 + (2 * i + j) % heights);
    }
  return table;
}

void measure(benchmark::State& state, const Table& table) {
  std::map<std::string, double> seconds;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = CCSweep::decompose(
        table.mesh(), CCSweep::parameters::direction(std::array<double, 3>{0, 0, 1}).face_patch_map(table.patch()));
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!result.ok()) {
      state.SkipWithError(result.status().reason.c_str());
      return;
    }
    const auto& found = result.value();
    for (const auto& [stage, s] : found.seconds) seconds[stage] += s;
    state.SetIterationTime(all - found.seconds.at("verification"));
    double known = 0;
    for (const auto& [stage, s] : found.seconds) known += s;
    seconds["input"] += all - known;
    state.counters["volumes"] = static_cast<double>(found.volumes.size());
    state.counters["sets"] = static_cast<double>(found.sets.size());
  }
  for (const auto& [stage, s] : seconds)
    state.counters[stage] = benchmark::Counter(s, benchmark::Counter::kAvgIterations);
  state.counters["facets"] = static_cast<double>(table.mesh().number_of_faces());
  state.SetComplexityN(static_cast<benchmark::IterationCount>(table.mesh().number_of_faces()));
}

void finer_circles_that_cross(benchmark::State& state) {
  measure(state, round_table(static_cast<int>(state.range(0))));
}

void finer_circles_that_match(benchmark::State& state) {
  measure(state, matching_table(static_cast<int>(state.range(0))));
}
void more_posts_and_legs(benchmark::State& state) { measure(state, forest(static_cast<int>(state.range(0)), 1)); }
void more_posts_and_legs_on_six_levels(benchmark::State& state) {
  measure(state, forest(static_cast<int>(state.range(0)), 3));
}

}  // namespace

BENCHMARK(finer_circles_that_cross)
    ->RangeMultiplier(4)->Range(64, 16384)->UseManualTime()->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(finer_circles_that_match)
    ->RangeMultiplier(4)->Range(64, 16384)->UseManualTime()->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(more_posts_and_legs)
    ->RangeMultiplier(2)->Range(2, 32)->UseManualTime()->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(more_posts_and_legs_on_six_levels)
    ->RangeMultiplier(2)->Range(2, 32)->UseManualTime()->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
