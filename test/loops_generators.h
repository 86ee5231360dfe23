// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_LOOPS_GENERATORS_H
#define CCSWEEP_TEST_LOOPS_GENERATORS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "loops_scene.h"

namespace loops_test {

// Random scenes. Pieces of one set do not overlap, and each has a label of its own.
class Generator {
 public:
  static constexpr int kinds = 10;

  static Scene make(int kind, unsigned seed) {
    Generator g(seed * 16 + static_cast<unsigned>(kind));
    static const char* const names[kinds] = {"stars", "frames",          "combs", "pies",            "bitset grids",
                                             "arcs",  "nested rings",    "blobs", "near-degenerate", "turned grids"};
    Scene scene{names[kind] + (" " + std::to_string(seed)), g.set(kind, true), g.set(kind, false)};
    if (kind == 8) scene.targets = {g.shaken(scene.sources.front())};
    return scene;
  }

 private:
  explicit Generator(unsigned seed) : random_(seed) {}

  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
  double real(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }

  std::vector<Piece> set(int kind, bool first) {
    switch (kind) {
      case 0: return {{1, star(random_, whole(3, 25), real(-0.5, 0.5), real(-0.5, 0.5))}};
      case 1: return frame(first);
      case 2: return {{1, comb(first)}};
      case 3: return pie();
      case 4: return bitset_grid(first);
      case 5: return {arc(first)};
      case 6: return rings();
      case 7: return {{1, blob()}};
      case 8: return {{1, whole(0, 1) ? blob() : star(random_, whole(3, 12), 0, 0)}};
      default: return turned_grid();
    }
  }

  std::vector<Piece> frame(bool first) {
    const double shift = first ? 0 : real(-1, 1);
    std::vector<Piece> result{{1, rectangle(-3 + shift, -3, 6, 6)}};
    for (int i = 0; i < 2; ++i) {
      const double x = shift + (i == 0 ? -1.4 : 1.4);
      result[0].holes.push_back(star(random_, whole(3, 12), x, 0));
      // The star's hole leaves room for an island about its middle.
      if (whole(0, 1)) result.push_back({2 + i, regular(whole(3, 7), 0.02, real(0, 6), x, 0)});
    }
    return result;
  }

  // Teeth on a grid, so that sides lie on one another, or meet in nodes.
  Loop comb(bool up) {
    const int teeth = whole(1, 8), width = whole(1, 2), height = whole(1, 4), x = whole(-2, 2);
    Loop result{{double(x), 0}, {double(x + 2 * teeth * width), 0}};
    for (int i = teeth; i-- > 0;) {
      const double left = x + 2 * i * width, right = left + width;
      result.insert(result.end(),
                    {{left + 2 * width, 1}, {right, 1}, {right, 1. + height}, {left, 1. + height}});
    }
    if (up) return result;
    const double top = whole(1, 5);
    for (auto& p : result) p[1] = top - p[1];
    return reversed(result);
  }

  // Sectors that meet in one point.
  std::vector<Piece> pie() {
    const int n = whole(3, 12);
    const bool crooked = whole(0, 1);
    const double x = whole(0, 2) / 2., y = crooked ? real(0, 1) : 0;
    const Loop around = regular(n, whole(1, 2), crooked ? real(0, 6) : 0, x, y);
    std::vector<Piece> result;
    for (int i = 0; i < n; ++i) {
      if (whole(0, 3)) result.push_back({i + 1, {{x, y}, around[i], around[(i + 1) % n]}});
    }
    return result;
  }

  std::vector<Piece> bitset_grid(bool first) {
    const int n = whole(1, 5);
    const double shift = first ? 0 : whole(-4, 4) / 4., width = whole(0, 2) ? 1 : 0.5;
    std::vector<Piece> result;
    for (int i = 0; i < n * n; ++i) {
      if (whole(0, 1)) result.push_back({i + 1, rectangle(shift + i % n * width, shift + i / n * width, width, width)});
    }
    return result;
  }

  // Facetings of arcs about one centre, with holes about the same.
  Piece arc(bool first) {
    const double phase = first || whole(0, 1) ? 0 : real(0, 1);
    Piece result{1, regular(whole(3, 40), 1, phase)};
    if (whole(0, 1)) result.holes.push_back(regular(whole(3, 40), 0.25 + 0.0625 * whole(0, 2), phase));
    return result;
  }

  std::vector<Piece> rings() {
    const int n = whole(1, 5);
    const double width = whole(0, 2) ? 1 : 1.5, x = whole(0, 4) / 4.;
    std::vector<Piece> result;
    for (int i = 0; i < n; ++i) {
      const double outer = width * (2 * n - 2 * i), inner = outer - width;
      result.push_back({1 + i,
                        rectangle(x - outer, -outer, 2 * outer, 2 * outer),
                        {rectangle(x - inner, -inner, 2 * inner, 2 * inner)}});
    }
    return result;
  }

  // A random polygon on a coarse grid, one node for each direction from the middle.
  Loop blob() {
    std::vector<std::array<int, 2>> points{
        {4, whole(-2, 2)}, {whole(-2, 2), 4}, {-4, whole(-2, 2)}, {whole(-2, 2), -4}};
    for (int i = whole(0, 12); i > 0; --i) points.push_back({whole(-5, 5), whole(-5, 5)});
    std::erase(points, std::array<int, 2>{0, 0});
    const auto half = [](const auto& p) { return p[1] < 0 || (p[1] == 0 && p[0] < 0); };
    const auto cross = [](const auto& p, const auto& q) { return p[0] * q[1] - p[1] * q[0]; };
    const auto before = [&](const auto& p, const auto& q) {
      return half(p) != half(q) ? half(p) < half(q) : cross(p, q) > 0;
    };
    std::stable_sort(points.begin(), points.end(), before);
    Loop result;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0 && !before(points[i - 1], points[i])) continue;
      result.push_back({double(points[i][0]), double(points[i][1])});
    }
    return result;
  }

  // The same again, its nodes off by nothing, by rounding, or by little; with nodes that say the same twice.
  Piece shaken(const Piece& piece) {
    Piece result{1, {}};
    const double noise = std::pow(10., -whole(9, 17));
    const std::size_t size = piece.outer.size();
    for (std::size_t i = 0; i < size; ++i) {
      std::array<double, 2> p = piece.outer[i], q = piece.outer[(i + 1) % size];
      if (whole(0, 2) == 0) p = {p[0] + real(-noise, noise), p[1] + real(-noise, noise)};
      if (whole(0, 4) == 0) p[0] = std::nextafter(p[0], 10);
      result.outer.push_back(p);
      if (whole(0, 4) == 0) result.outer.push_back(p);
      const double t = whole(1, 7) / 8.;
      if (whole(0, 1)) result.outer.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
    }
    return result;
  }

  std::vector<Piece> turned_grid() {
    const int n = whole(1, 4);
    const double angle = whole(0, 3) ? real(0, 6.3) : 0, c = std::cos(angle), s = std::sin(angle);
    std::vector<Piece> result;
    for (int i = 0; i < n * n; ++i) {
      Loop cell = rectangle(i % n - n / 2., i / n - n / 2., 1, 1);
      for (auto& p : cell) p = {c * p[0] - s * p[1], s * p[0] + c * p[1]};
      result.push_back({i + 1, cell});
    }
    return result;
  }

  std::mt19937 random_;
};

}  // namespace loops_test

#endif
