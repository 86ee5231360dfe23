// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The projection of the interior nodes of a layer, equations (1) to (5), beside the plain search of an r-tree for each
// node. The images are compared in the same run.
#include <CCSweep/loops/projection.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <array>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Projection = CCSweep::Layer_projection<Kernel>;
using Point = std::array<double, 3>;

constexpr std::size_t neighbours = 10;

Eigen::Vector3d vector(const Point& p) { return {p[0], p[1], p[2]}; }
Point difference(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }

// A ring of control nodes and its image, which is not affine, and interior nodes on loops within it.
struct Layer {
  std::vector<Point> from, to, interior;

  Layer(std::size_t n, std::size_t s) {
    for (std::size_t i = 0; i < n; ++i) {
      const double t = angle(i, n), r = 1 + 0.1 * std::sin(5 * t);
      from.push_back({r * std::cos(t), r * std::sin(t), 0});
      to.push_back({1.1 * r * std::cos(t), r * std::sin(t) + 0.02 * std::cos(3 * t), 1 + 0.05 * std::sin(2 * t)});
    }
    const std::size_t loops = 20;
    for (std::size_t loop = 0; loop < loops; ++loop) {
      const double scale = 0.95 * static_cast<double>(loop + 1) / static_cast<double>(loops);
      for (std::size_t i = 0; i < s / loops; ++i) {
        const double t = angle(i, s / loops), r = scale * (1 + 0.1 * std::sin(5 * t));
        interior.push_back({r * std::cos(t), r * std::sin(t), 0});
      }
    }
  }
  static double angle(std::size_t i, std::size_t n) {
    return 2 * M_PI * (static_cast<double>(i) + 0.37) / static_cast<double>(n);
  }
  Projection projection() const {
    std::vector<std::size_t> loop(from.size());
    for (std::size_t i = 0; i < loop.size(); ++i) loop[i] = i;
    return Projection::make(from, to, {loop}, neighbours).value();
  }
};

const Layer& layer() {
  static const Layer result(1000, 100000);
  return result;
}

void walk(benchmark::State& state) {
  const Projection projection = layer().projection();
  std::vector<Point> images(layer().interior.size());
  for (auto _ : state) {
    Projection::Walk walk = projection.walk();
    for (std::size_t i = 0; i < images.size(); ++i) images[i] = walk(layer().interior[i]);
    benchmark::DoNotOptimize(images.data());
  }
  for (std::size_t i = 0; i < images.size(); i += 7) {
    if (images[i] != projection(layer().interior[i])) state.SkipWithError("the walk leads elsewhere");
  }
}

void one_by_one(benchmark::State& state) {
  const Projection projection = layer().projection();
  std::vector<Point> images(layer().interior.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < images.size(); ++i) images[i] = projection(layer().interior[i]);
    benchmark::DoNotOptimize(images.data());
  }
}

// What a user would write: the tree of the mapped control nodes, its ten nearest, and the equations.
void plain_rtree(benchmark::State& state) {
  namespace bg = boost::geometry;
  using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
  using Value = std::pair<Corner, std::uint32_t>;
  const Projection projection = layer().projection();
  const Eigen::Matrix3d a = projection.matrix();
  const Point mapped_first = difference(layer().to[0], projection.residual(0));
  const Eigen::Vector3d origin = vector(mapped_first) - a * vector(layer().from[0]);
  std::vector<Value> values;
  for (std::size_t i = 0; i < layer().from.size(); ++i) {
    const Point p = difference(layer().to[i], projection.residual(i));
    values.emplace_back(Corner(p[0], p[1], p[2]), static_cast<std::uint32_t>(i));
  }
  const bg::index::rtree<Value, bg::index::quadratic<16>> tree(values);
  std::vector<Point> images(layer().interior.size());
  std::vector<Value> found;
  for (auto _ : state) {
    for (std::size_t i = 0; i < images.size(); ++i) {
      const Eigen::Vector3d place = origin + a * vector(layer().interior[i]);
      found.clear();
      tree.query(bg::index::nearest(Corner(place[0], place[1], place[2]), neighbours), std::back_inserter(found));
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double total = 0;
      for (const auto& [corner, k] : found) {
        const Eigen::Vector3d control(corner.get<0>(), corner.get<1>(), corner.get<2>());
        const double weight = 1 / (place - control).squaredNorm();
        sum += weight * (vector(layer().to[k]) - control);
        total += weight;
      }
      const Eigen::Vector3d image = place + sum / total;
      images[i] = {image[0], image[1], image[2]};
    }
    benchmark::DoNotOptimize(images.data());
  }
  for (std::size_t i = 0; i < images.size(); i += 7) {
    const Point expected = projection(layer().interior[i]);
    if ((vector(images[i]) - vector(expected)).norm() > 1e-9) state.SkipWithError("the images differ");
  }
}

BENCHMARK(walk)->Name("projection/ccsweep_walk")->Unit(benchmark::kMillisecond);
BENCHMARK(one_by_one)->Name("projection/ccsweep_one_by_one")->Unit(benchmark::kMillisecond);
BENCHMARK(plain_rtree)->Name("projection/plain_rtree")->Unit(benchmark::kMillisecond);

}  // namespace
