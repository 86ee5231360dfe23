// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_BENCHMARK_IMPRINT_FAMILIES_H
#define CCSWEEP_BENCHMARK_IMPRINT_FAMILIES_H

#include <CCSweep/Layer_drawing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace imprint_benchmark {

using Place = std::array<double, 2>;
using Loop = std::vector<Place>;

// A face with its loops in the sense of the face: the outer one counterclockwise, holes clockwise.
struct Face {
  int label = 0;
  std::vector<Loop> loops;
};

struct Scene {
  std::vector<Face> sources, targets;
};

// Areas of what is in both sets, in a source only and in a target only.
using Areas = std::array<double, 3>;

inline double area(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Place &p = loop[i], &q = loop[(i + 1) % loop.size()];
    twice += p[0] * q[1] - q[0] * p[1];
  }
  return twice / 2;
}

// A circle of n nodes whose radius waves.
inline Loop circle(std::size_t n, double x, double radius, double phase, double amplitude, std::size_t waves) {
  Loop result;
  result.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = phase + 2 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    const double r = radius * (1 + amplitude * std::sin(static_cast<double>(waves) * t));
    result.push_back({x + r * std::cos(t), r * std::sin(t)});
  }
  return result;
}

inline Loop circle(std::size_t n, double x, double radius) { return circle(n, x, radius, 0.1234, 0, 0); }

// Two faces of n segments each.
enum class Family { apart, root, quarter, root_holes, quarter_holes };

inline std::size_t crossings(Family family, std::size_t n) {
  if (family == Family::apart) return 2;
  const bool root = family == Family::root || family == Family::root_holes;
  return root ? static_cast<std::size_t>(std::sqrt(static_cast<double>(n))) : n / 4;
}

// Of a face with four holes every hole has a tenth of the segments.
inline Face with_holes(Loop outer, std::size_t n, double x) {
  Face result{0, {std::move(outer)}};
  for (int i = 0; i < 4; ++i) {
    Loop hole = circle(n / 10, 0, 0.2);
    for (Place& p : hole) p = {p[0] + x + (i % 2 == 0 ? 0.4 : -0.4), p[1] + (i / 2 == 0 ? 0.4 : -0.4)};
    result.loops.emplace_back(hole.rbegin(), hole.rend());
  }
  return result;
}

inline Scene two_faces(Family family, std::size_t n) {
  if (family == Family::apart) return {{{0, {circle(n, 0, 1)}}}, {{0, {circle(n, 0.5, 1)}}}};
  const bool holes = family == Family::root_holes || family == Family::quarter_holes;
  const std::size_t outer = holes ? n - 4 * (n / 10) : n;
  const std::size_t waves = crossings(family, n) / 2;
  const double amplitude = 1 / static_cast<double>(std::max<std::size_t>(waves, 50));  // not steeper than 45 degrees
  const Loop wavy = circle(outer, 0, 1, 0.01, amplitude, waves), plain = circle(outer, 0, 1);
  if (!holes) return {{{0, {wavy}}}, {{0, {plain}}}};
  return {{with_holes(wavy, n, 0)}, {with_holes(plain, n, 0.05)}};
}

// m x m squares, turned about their middle.
inline std::vector<Face> grid(std::size_t m, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), middle = static_cast<double>(m) / 2;
  const auto node = [&](std::size_t i, std::size_t j) {
    const double x = static_cast<double>(i) - middle, y = static_cast<double>(j) - middle;
    return Place{c * x - s * y, s * x + c * y};
  };
  std::vector<Face> result;
  for (std::size_t j = 0; j < m; ++j) {
    for (std::size_t i = 0; i < m; ++i) {
      result.push_back(
          {static_cast<int>(j * m + i), {{node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}}});
    }
  }
  return result;
}

inline Scene layer(std::size_t m) { return {grid(m, 0.3), grid(m, 0)}; }

inline std::size_t size(const std::vector<Face>& faces) {
  std::size_t result = 0;
  for (const Face& face : faces) {
    for (const Loop& loop : face.loops) result += loop.size();
  }
  return result;
}

inline Scene turned_sources(Scene scene, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Face& face : scene.sources) {
    for (Loop& loop : face.loops) {
      for (Place& p : loop) p = {c * p[0] - s * p[1], s * p[0] + c * p[1]};
    }
  }
  return scene;
}

// Scenes that differ by turns of their sources, to be measured one after another. Nobody imprints one layer over and
// over: a processor that does so soon knows all the branches of a small scene by heart, and what is left of searching
// in a tree is a third of what it costs once.
inline std::vector<Scene> variations(const Scene& scene, double turn) {
  constexpr std::size_t segments = 1 << 16, most = 32;
  const std::size_t number = std::clamp<std::size_t>(segments / size(scene.sources), 1, most);
  std::vector<Scene> result;
  for (std::size_t i = 0; i < number; ++i) result.push_back(turned_sources(scene, turn * static_cast<double>(i)));
  return result;
}

template <class Kernel>
CCSweep::Layer_drawing<Kernel> drawing(const Scene& scene) {
  CCSweep::Layer_drawing<Kernel> result;
  const auto draw = [&](const Loop& loop, CCSweep::Loop_label label) {
    const std::size_t first = result.nodes.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      result.nodes.push_back({typename Kernel::Point_2(loop[i][0], loop[i][1])});
      result.segments.push_back(
          {CCSweep::Node_index(first + i), CCSweep::Node_index(first + (i + 1) % loop.size()), label, {}});
    }
  };
  for (const Face& face : scene.sources) {
    for (const Loop& loop : face.loops) draw(loop, {face.label, CCSweep::Loop_label::none});
  }
  for (const Face& face : scene.targets) {
    for (const Loop& loop : face.loops) draw(loop, {CCSweep::Loop_label::none, face.label});
  }
  return result;
}

}  // namespace imprint_benchmark

#endif
