// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_CURVED_PARTS_H
#define CCSWEEP_TEST_CURVED_PARTS_H

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "random_parts.h"
#include "split_edges.h"

// Straight parts put through smooth one-to-one maps that keep them sweepable: the same patches have the same roles, and
// there are as many sub-volumes and decomposition sets, as lines of the sweep stay lines of the sweep.
namespace curved_parts {

using Coordinates = std::array<double, 3>;
using random_parts::Part;
using random_parts::Prism;

enum class Shape {
  straight,
  placed,    ///< turned, moved and scaled, to 1e6 away and a thousandth or ten thousand times the size
  leaning,   ///< walls all at one slant
  tapered,   ///< sections shrink or grow
  twisted,   ///< sections turn
  barrel,    ///< sections swell up to the middle
  slanted,   ///< the top is at a slant
  domed,     ///< caps bulge, more so at the top
  saddle,    ///< caps bend up one way and down the other
  fan,       ///< the sweep is bent about an axis close by, layers fan out
  bent,      ///< bent along an arc, up to a quarter torus
  u_bend,    ///< bent by a half turn and more
  bent_bar,  ///< a straight piece before the bend
  slender,   ///< 100 : 1
};
inline constexpr std::array<Shape, 14> shapes = {
    Shape::straight, Shape::placed, Shape::leaning, Shape::tapered, Shape::twisted, Shape::barrel,   Shape::slanted,
    Shape::domed,    Shape::saddle, Shape::fan,     Shape::bent,    Shape::u_bend,  Shape::bent_bar, Shape::slender};

inline const char* name(Shape shape) {
  constexpr std::array<const char*, 14> names = {"straight", "placed", "leaning", "tapered", "twisted",
                                                 "barrel",   "slanted", "domed",  "saddle",  "fan",
                                                 "bent",     "u_bend",  "bent_bar", "slender"};
  return names[static_cast<std::size_t>(shape)];
}

/// A map of the box [0, 24]² x [0, 12] that parts are drawn in.
struct Map {
  std::function<Coordinates(const Coordinates&)> place;
  /// Where the sweep leads at a height of the box.
  std::function<Coordinates(double)> direction = [](double) { return Coordinates{0, 0, 1}; };
};

/// Draws maps; the same seed gives the same map.
class Map_maker {
 public:
  explicit Map_maker(std::uint32_t seed) : random_(seed) {}

  Map make(Shape shape) {
    switch (shape) {
      case Shape::straight: return {[](const Coordinates& p) { return p; }};
      case Shape::placed: return placed();
      case Shape::leaning: return leaning(between(-0.5, 0.5), between(-0.5, 0.5));
      case Shape::tapered: return scaled_by_height([a = between(-0.35, 0.35)](double t) { return 1 + a * t; });
      case Shape::barrel:
        return scaled_by_height([a = between(0.05, 0.2)](double t) { return 1 + a * std::sin(pi * t); });
      case Shape::twisted: return twisted(between(5, 25) * degree);
      case Shape::slanted: return slanted(between(-0.3, 0.3), between(-0.3, 0.3));
      case Shape::domed: return lifted(between(0.5, 2.5), 1);
      case Shape::saddle: return lifted(between(0.5, 2), -1);
      case Shape::fan: return bent(between(20, 60) * degree, between(14, 18), 0.8, 0);
      case Shape::bent: return bent(between(30, 90) * degree, between(18, 30), 0.5, 0);
      case Shape::u_bend: return bent(between(150, 270) * degree, between(18, 25), 0.5, 0);
      case Shape::bent_bar: return bent(between(30, 90) * degree, between(18, 30), 0.5, 6);
      case Shape::slender:
        return {[](const Coordinates& p) { return Coordinates{p[0] * 100 / 24, p[1] / 24, p[2] / 12}; }};
    }
    return {};
  }

 private:
  static constexpr double pi = 3.14159265358979323846, degree = pi / 180, middle = 12, height = 12;

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }

  Map placed() {
    const double a = between(0, 2 * pi), b = between(0, pi), scale = std::pow(10., between(-3, 4)),
                 away = std::min(1e6, 1e5 * scale) * between(-1, 1);
    auto turn = [=](const Coordinates& p) {
      const double x = std::cos(a) * p[0] - std::sin(a) * p[1], y = std::sin(a) * p[0] + std::cos(a) * p[1];
      return Coordinates{x, std::cos(b) * y - std::sin(b) * p[2], std::sin(b) * y + std::cos(b) * p[2]};
    };
    auto place = [=](const Coordinates& p) {
      const Coordinates q = turn(p);
      return Coordinates{scale * q[0] + away, scale * q[1] - away, scale * q[2] + away};
    };
    return {place, [=](double) { return turn({0, 0, 1}); }};
  }

  static Map leaning(double a, double b) {
    return {[=](const Coordinates& p) { return Coordinates{p[0] + a * p[2], p[1] + b * p[2], p[2]}; }};
  }

  template <class Function>
  static Map scaled_by_height(const Function& factor) {
    return {[=](const Coordinates& p) {
      const double k = factor(p[2] / height);
      return Coordinates{middle + k * (p[0] - middle), middle + k * (p[1] - middle), p[2]};
    }};
  }

  static Map twisted(double angle) {
    return {[=](const Coordinates& p) {
      const double t = angle * p[2] / height, x = p[0] - middle, y = p[1] - middle;
      return Coordinates{std::cos(t) * x - std::sin(t) * y, std::sin(t) * x + std::cos(t) * y, p[2]};
    }};
  }

  static Map slanted(double a, double b) {
    return {[=](const Coordinates& p) {
      return Coordinates{p[0], p[1], p[2] + p[2] / height * (a * (p[0] - middle) + b * (p[1] - middle))};
    }};
  }

  static Map lifted(double lift, double sense) {
    return {[=](const Coordinates& p) {
      const double x = (p[0] - middle) / middle, y = (p[1] - middle) / middle;
      return Coordinates{p[0], p[1], p[2] - lift * (0.5 + 0.5 * p[2] / height) * (x * x + sense * y * y)};
    }};
  }

  /// About the y axis, at `radius` from it in the middle; what lies below `begin` stays straight.
  static Map bent(double angle, double radius, double width, double begin) {
    auto turn = [=](double z) { return angle * std::max(0., z - begin) / (height - begin); };
    auto place = [=](const Coordinates& p) {
      const double t = turn(p[2]), r = radius + width * (p[0] - middle);
      return Coordinates{r * std::cos(t), width * (p[1] - middle), r * std::sin(t) + std::min(0., p[2] - begin)};
    };
    return {place, [=](double z) { return Coordinates{-std::sin(turn(z)), 0, std::cos(turn(z))}; }};
  }

  std::mt19937 random_;
};

inline double volume_of_prism(const std::array<Coordinates, 6>& p) {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  auto tetrahedron = [&](int a, int b, int c, int d) {
    auto point = [&](int i) { return Point(p[i][0], p[i][1], p[i][2]); };
    return CGAL::volume(point(a), point(b), point(c), point(d));
  };
  return tetrahedron(0, 1, 2, 3) + tetrahedron(1, 2, 3, 4) + tetrahedron(2, 3, 4, 5);
}

/// The volume of what a map makes of a prism, as that of 512 small prisms.
inline double mapped_volume(const Prism& prism, const Map& map) {
  constexpr int across = 8, up = 8;
  auto node = [&](int i, int j, int k) {
    const double a = double(i) / across, b = double(j) / across, t = double(k) / up;
    Coordinates p;
    for (int c = 0; c < 2; ++c) p[c] = (1 - a - b) * prism.base[0][c] + a * prism.base[1][c] + b * prism.base[2][c];
    p[2] = (1 - t) * prism.low + t * prism.high;
    return map.place(p);
  };
  double sum = 0;
  auto add = [&](std::array<int, 2> p, std::array<int, 2> q, std::array<int, 2> r, int k) {
    sum += volume_of_prism({node(p[0], p[1], k), node(q[0], q[1], k), node(r[0], r[1], k), node(p[0], p[1], k + 1),
                            node(q[0], q[1], k + 1), node(r[0], r[1], k + 1)});
  };
  for (int k = 0; k < up; ++k)
    for (int i = 0; i < across; ++i)
      for (int j = 0; i + j < across; ++j) {
        add({i, j}, {i + 1, j}, {i, j + 1}, k);
        if (i + j + 1 < across) add({i + 1, j}, {i + 1, j + 1}, {i, j + 1}, k);
      }
  return sum;
}

/// A part with its direction at the lowest target.
struct Swept_part {
  Part part;
  Coordinates direction{0, 0, 1};
};

/// Facets as fine as the map asks for: no edge of the result is further than `error` from the curve it stands for.
inline Swept_part mapped(Part part, const Map& map, double error = 0.02) {
  part = split_edges::until_done(part, [&](const Coordinates& p, const Coordinates& q) -> std::optional<Coordinates> {
    const Coordinates a = map.place(p), b = map.place(q);
    for (double t : {0.25, 0.5, 0.75}) {
      const Coordinates c = map.place(split_edges::between(p, q, t)), d = split_edges::between(a, b, t);
      if (std::hypot(c[0] - d[0], c[1] - d[1], c[2] - d[2]) > error) return split_edges::middle(p, q);
    }
    return std::nullopt;
  });
  part.sub_volumes.clear();
  part.volume = 0;
  double lowest = part.prisms.front().low;
  for (const Prism& prism : part.prisms) {
    const double volume = mapped_volume(prism, map);
    part.sub_volumes[prism.target] += volume;
    part.volume += volume;
    lowest = std::min(lowest, prism.low);
  }
  return {random_parts::moved(std::move(part), map.place), map.direction(lowest)};
}

inline Swept_part make(Shape shape, random_parts::Family family, std::uint32_t seed) {
  const Map map = Map_maker(seed).make(shape);
  Part part = random_parts::make(family, seed);
  if (shape == Shape::straight) return {std::move(part)};
  return mapped(std::move(part), map);
}

}  // namespace curved_parts

#endif
