// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_RANDOM_PLANS_H
#define CCSWEEP_TEST_RANDOM_PLANS_H

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "random_parts_solid.h"

// Plans of straight multi-sweep parts, drawn at random from families.
namespace random_parts {

enum class Family {
  grids,         ///< independent rectangle grids below and above, five levels each
  barrels,       ///< a slab with rectangular legs, posts, pads, pockets and through-holes, overlapping at will
  polygons,      ///< the same with convex polygons
  circles,       ///< the same with circles, rings off-centre, and arcs over straight edges
  mixed,         ///< the same with all of them
  split,         ///< level caps that fall into patches without a step
  windows,       ///< a slot through the part from side to side, with material above it
  steps,         ///< flights of steps on both sides, five deep, with a hole through them
  counterbores,  ///< round through-holes that are wider above and below, not always about one axis
  pockets,       ///< blind pockets from both sides with islands in them
  lobes,         ///< a wheel of up to 72 lobes with legs and posts
  many,          ///< 30 sources on 20 targets
};
inline constexpr std::array<Family, 12> all_families = {
    Family::grids, Family::barrels, Family::polygons,     Family::circles, Family::mixed, Family::split,
    Family::windows, Family::steps, Family::counterbores, Family::pockets, Family::lobes, Family::many};
/// Those that need no long time each.
inline constexpr std::array<Family, 7> families = {Family::grids, Family::barrels, Family::polygons, Family::circles,
                                                   Family::mixed, Family::split,   Family::windows};

/// Makes plans. All coordinates are multiples of 2^-12, so that the overlay is exact; the same seed gives the same
/// plan with every standard library.
class Generator {
 public:
  Generator(Family family, std::uint32_t seed)
      : family_(family), random_(seed * 7919u + static_cast<std::uint32_t>(family)) {}

  Plan plan() {
    Plan p;
    p.material.push_back({rectangle(0, 0, size, size)});
    p.bottom = 4;
    p.top = 8;
    if (family_ == Family::grids) {
      p.bottoms = grid({0, 1, 2, 3, 4});
      p.tops = grid({6, 7, 8, 9, 10});
    } else if (family_ == Family::split) {
      p.bottoms = strips({4, 4, 3}, pick(2));
      p.tops = strips({8, 8, 9}, pick(2));
    } else if (family_ == Family::windows) {
      p.bottoms = strips({0, 1, 0}, pick(2));
      p.tops = strips({8, 9, 10}, pick(2));
      add_window(p);
    } else if (family_ == Family::steps) {
      add_steps(p);
    } else if (family_ == Family::counterbores) {
      add_counterbores(p);
    } else if (family_ == Family::pockets) {
      add_pockets(p);
    } else if (family_ == Family::lobes) {
      add_lobes(p);
    } else if (family_ == Family::many) {
      add_tiles(p.bottoms, 4, 5, -1);
      add_tiles(p.tops, 6, 5, 1);
    } else {
      add_shapes(p);
    }
    return p;
  }

 private:
  static constexpr int size = 24;
  static constexpr std::array<double, 5> heights_below{0, 1, 2, 3, 5};
  static constexpr std::array<double, 5> heights_above{6, 7, 9, 10, 12};

  int pick(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
  static double rounded(double x) { return std::round(x * 4096) / 4096; }

  static Outline rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  }

  void add_shapes(Plan& p) {
    for (int i = 0, n = 1 + pick(3); i < n; ++i) p.bottoms.push_back({shape(), heights_below[pick(5)]});
    for (int i = 0, n = 1 + pick(3); i < n; ++i) p.tops.push_back({shape(), heights_above[pick(5)]});
    for (int i = 0, n = pick(3); i < n; ++i) p.material.push_back({shape(), false});
  }

  /// Five strips whose heights fall or rise one after another, below and above.
  void add_steps(Plan& p) {
    for (const bool above : {false, true}) {
      const std::vector<int> x = cuts(4);
      const bool along_x = pick(2), falls = pick(2);
      for (int i = 0; i < 5; ++i) {
        const int k = falls ? 4 - i : i;
        (above ? p.tops : p.bottoms)
            .push_back({along_x ? rectangle(0, x[i], size, x[i + 1]) : rectangle(x[i], 0, x[i + 1], size),
                        above ? 8.0 + k : double(k)});
      }
    }
    if (pick(2)) p.material.push_back({shape(), false});
  }

  void add_counterbores(Plan& p) {
    for (int i = 0, n = 1 + pick(4); i < n; ++i) {
      const double x = 5 + pick(15), y = 5 + pick(15), r = 1 + pick(3) / 2.;
      auto bore = [&](double wider) {
        const double radius = r + wider + pick(3) / 2.;
        return circle(x + pick(2) / 4., y + pick(2) / 4., radius, 24 + 4 * pick(4));
      };
      if (pick(3)) p.tops.push_back({bore(0.75), 6.5 + pick(2) / 2.});
      if (pick(3)) p.bottoms.push_back({bore(0.75), 5.5 - pick(2) / 2.});
      p.material.push_back({circle(x, y, r, 24), false});
    }
    if (pick(2)) p.tops.push_back({rectangle(0, 0, 2 + pick(20), size), 9});
  }

  void add_pockets(Plan& p) {
    for (auto* paints : {&p.bottoms, &p.tops}) {
      const bool above = paints == &p.tops;
      for (int i = 0, n = 1 + pick(2); i < n; ++i) {
        const int x = 1 + pick(10), y = 1 + pick(10), w = 6 + pick(6), h = 6 + pick(6);
        paints->push_back({rectangle(x, y, x + w, y + h), above ? 6.5 : 5.5});
        paints->push_back({pick(2) ? rectangle(x + 2, y + 2, x + w - 2, y + h - 2)
                                   : circle(x + w / 2., y + h / 2., 2, 24 + 4 * pick(4)),
                           above ? 7.0 + pick(4) : 5.0 - pick(4)});
      }
    }
  }

  /// Columns and rows of tiles, each a patch of its own; they go up and down from one column to the next.
  void add_tiles(std::vector<Paint>& paints, int columns, int rows, int away) {
    const std::vector<int> x = cuts(columns - 1), y = cuts(rows - 1);
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double height = away > 0 ? 8 + pick(5) : 4 - pick(5);
      for (std::size_t j = 1; j < y.size(); ++j)
        paints.push_back({rectangle(x[i - 1], y[j - 1], x[i], y[j]), height, true});
    }
  }

  void add_lobes(Plan& p) {
    const int lobes = 8 + pick(65);
    p.material = {{wheel(lobes, pick(2))}};
    for (auto* paints : {&p.bottoms, &p.tops}) {
      const int x = 6 + pick(5), y = 6 + pick(5);
      paints->push_back({pick(2) ? rectangle(x, y, x + 3 + pick(4), y + 3 + pick(4)) : circle(x + 2, y + 2, 2.5, 32),
                         paints == &p.tops ? heights_above[pick(5)] : heights_below[pick(5)]});
    }
    if (pick(2)) p.material.push_back({circle(12, 12, 1 + pick(8), 48), false});
  }

  /// Teeth, or round lobes, about the middle.
  static Outline wheel(int lobes, bool is_round) {
    Outline result;
    const int nodes = is_round ? 8 : 4;
    for (int i = 0; i < nodes * lobes; ++i) {
      const double angle = 2 * pi * i / (nodes * lobes);
      const double lobe = std::cos(lobes * angle) * std::min(1.5, 12. / lobes);
      const double radius = is_round ? 10.5 + lobe : i % 4 < 2 ? 12 : 10;
      result.push_back({rounded(12 + radius * std::cos(angle)), rounded(12 + radius * std::sin(angle))});
    }
    return result;
  }

  /// Rows and columns of cells with random heights.
  std::vector<Paint> grid(const std::vector<double>& heights) {
    const std::vector<int> x = cuts(1 + pick(3)), y = cuts(pick(3));
    std::vector<Paint> result;
    for (std::size_t i = 1; i < x.size(); ++i)
      for (std::size_t j = 1; j < y.size(); ++j)
        result.push_back({rectangle(x[i - 1], y[j - 1], x[i], y[j]), heights[pick(static_cast<int>(heights.size()))]});
    return result;
  }

  std::vector<int> cuts(int n) {
    std::set<int> chosen{0, size};
    while (static_cast<int>(chosen.size()) < n + 2) chosen.insert(1 + pick(size - 1));
    return {chosen.begin(), chosen.end()};
  }

  /// Strips from side to side, each a patch of its own.
  std::vector<Paint> strips(const std::vector<double>& heights, bool along_x) {
    const std::vector<int> x = cuts(1 + pick(3));
    std::vector<Paint> result;
    for (std::size_t i = 1; i < x.size(); ++i)
      result.push_back({along_x ? rectangle(0, x[i - 1], size, x[i]) : rectangle(x[i - 1], 0, x[i], size),
                        heights[pick(static_cast<int>(heights.size()))], true});
    return result;
  }

  void add_window(Plan& p) {
    const std::vector<int> x = cuts(2);
    const bool along_x = pick(2);
    p.windows.push_back(
        {along_x ? rectangle(0, x[1], size, x[2]) : rectangle(x[1], 0, x[2], size), 3.0 + pick(2), 5.0 + pick(2)});
    if (pick(2)) p.material.push_back({rectangle(x[1], x[1], x[2], x[2]), false});
  }

  Outline shape() {
    int kind = pick(3);
    if (family_ == Family::barrels) kind = 0;
    if (family_ == Family::polygons) kind = 1;
    if (family_ == Family::circles && kind == 1) kind = 2;
    if (kind == 0) {
      const int x = pick(size - 4), y = pick(size - 4);
      return rectangle(x, y, std::min(x + 3 + pick(10), size), std::min(y + 3 + pick(10), size));
    }
    const int n = kind == 1 ? 3 + pick(4) : 24 + 4 * pick(6);
    return round(n, kind == 1 ? 4 + pick(5) : 3 + pick(5), kind == 1);
  }

  /// A polygon around a random centre inside the part, as an arc or turned at random.
  Outline round(int n, double radius, bool turned) {
    const double x = radius + 1 + pick(static_cast<int>(size - 2 * radius - 1)),
                 y = radius + 1 + pick(static_cast<int>(size - 2 * radius - 1));
    return circle(x, y, radius, n, turned ? pick(360) * pi / 180 : pick(n) * pi / (n * n));
  }

  static Outline circle(double x, double y, double radius, int n, double start = 0) {
    Outline result;
    for (int i = 0; i < n; ++i) {
      const double angle = start + 2 * pi * i / n;
      result.push_back({rounded(x + radius * std::cos(angle)), rounded(y + radius * std::sin(angle))});
    }
    return result;
  }

  static constexpr double pi = 3.14159265358979323846;
  Family family_;
  std::mt19937 random_;
};

}  // namespace random_parts

#endif
