// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_LOOPS_DRAWINGS_H
#define CCSWEEP_TEST_LOOPS_DRAWINGS_H

#include <CCSweep/loops/imprint.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <vector>

namespace loops_test {

using CCSweep::Loop_label;
using CCSweep::Node_index;
using Loop = std::vector<std::array<double, 2>>;

struct Style {
  bool fixed = false;
  bool corners = false;
  double chord_error = 0;
};

// Draws a closed loop with the label on its left.
template <class K>
void draw(CCSweep::Layer_drawing<K>& drawing, const Loop& loop, Loop_label left, Style style = {}) {
  const std::size_t first = drawing.nodes.size(), n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    drawing.nodes.push_back({typename K::Point_2(loop[i][0], loop[i][1]), style.fixed, style.corners});
    drawing.segments.push_back(
        {Node_index(first + i), Node_index(first + (i + 1) % n), left, Loop_label{}, style.fixed, style.chord_error});
  }
}

inline Loop reversed(Loop loop) { return {loop.rbegin(), loop.rend()}; }

inline Loop rectangle(double x, double y, double w, double h) {
  return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

inline Loop regular(std::size_t n, double radius, double phase = 0, double x = 0, double y = 0) {
  Loop result;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = phase + 2 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    result.push_back({x + radius * std::cos(t), y + radius * std::sin(t)});
  }
  return result;
}

inline Loop star(std::mt19937& random, std::size_t n, double x, double y) {
  std::uniform_real_distribution<double> radius(0.2, 1);
  Loop result = regular(n, 1, radius(random));
  for (auto& p : result) {
    const double r = radius(random);
    p = {x + r * p[0], y + r * p[1]};
  }
  return result;
}

template <class K>
typename K::FT area(const std::vector<Node_index>& loop, const std::vector<typename K::Point_2>& points) {
  typename K::FT twice(0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto &p = points[loop[i].value()], &q = points[loop[(i + 1) % loop.size()].value()];
    twice += p.x() * q.y() - q.x() * p.y();
  }
  return twice / 2;
}

// Number and area of the LoopFaces of each label.
template <class FT>
struct Tally {
  std::size_t faces = 0;
  FT area = FT(0);
};

template <class K>
std::map<Loop_label, Tally<typename K::FT>> tally(const CCSweep::Imprint<K>& imprint) {
  std::map<Loop_label, Tally<typename K::FT>> result;
  for (std::size_t i = 0; i < imprint.graph.number_of_loop_faces(); ++i) {
    const CCSweep::Loop_face_index f(i);
    auto& entry = result[imprint.graph.label(f)];
    ++entry.faces;
    for (auto loop : imprint.graph.loops(f)) entry.area += area<K>(imprint.graph.nodes(loop), imprint.points);
  }
  return result;
}

}  // namespace loops_test

#endif
