// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_CURVED_PARTS_H
#define CCSWEEP_TEST_CURVED_PARTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
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
  faceted,   ///< circles have other nodes above than below
};
inline constexpr std::array<Shape, 15> shapes = {
    Shape::straight, Shape::placed, Shape::leaning, Shape::tapered, Shape::twisted,  Shape::barrel,  Shape::slanted,
    Shape::domed,    Shape::saddle, Shape::fan,     Shape::bent,    Shape::u_bend,   Shape::bent_bar, Shape::slender,
    Shape::faceted};

inline const char* name(Shape shape) {
  constexpr std::array<const char*, 15> names = {"straight", "placed", "leaning",  "tapered", "twisted",
                                                 "barrel",   "slanted", "domed",   "saddle",  "fan",
                                                 "bent",     "u_bend",  "bent_bar", "slender", "faceted"};
  return names[static_cast<std::size_t>(shape)];
}

/// A map of the box [0, 24]² x [0, 12] that parts are drawn in.
struct Map {
  std::function<Coordinates(const Coordinates&)> place;
  /// Where the sweep leads at a height of the box.
  std::function<Coordinates(double)> direction = [](double) { return Coordinates{0, 0, 1}; };
  std::array<int, 3> slices{1, 1, 1};  ///< across each axis, so that what lies between two is all but straight
};

/// Draws maps; the same seed gives the same map.
class Map_maker {
 public:
  explicit Map_maker(std::uint32_t seed) : random_(seed) {}

  Map make(Shape shape) {
    switch (shape) {
      case Shape::straight:
      case Shape::faceted: return {[](const Coordinates& p) { return p; }};
      case Shape::placed: return placed();
      case Shape::leaning: return leaning(between(-0.5, 0.5), between(-0.5, 0.5));
      case Shape::tapered: return scaled_by_height([a = between(-0.35, 0.35)](double t) { return 1 + a * t; }, 1);
      case Shape::barrel:
        return scaled_by_height([a = between(0.05, 0.2)](double t) { return 1 + a * std::sin(pi * t); }, 8);
      case Shape::twisted: return twisted(between(5, 25) * degree);
      case Shape::slanted: return slanted(between(-0.3, 0.3), between(-0.3, 0.3));
      case Shape::domed: return lifted(between(0.5, 2.5), 1);
      case Shape::saddle: return lifted(between(0.5, 2), -1);
      case Shape::fan: return bent(between(20, 60) * degree, between(14, 18), 0.8, 0);
      case Shape::bent: return bent(between(30, 90) * degree, between(18, 30), 0.5, 0);
      case Shape::u_bend: return bent(between(150, 260) * degree, between(18, 25), 0.5, 0);
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
  static Map scaled_by_height(const Function& factor, int slices) {
    auto place = [=](const Coordinates& p) {
      const double k = factor(p[2] / height);
      return Coordinates{middle + k * (p[0] - middle), middle + k * (p[1] - middle), p[2]};
    };
    return {place, Map().direction, {1, 1, slices}};
  }

  Map twisted(double angle) {
    auto place = [=](const Coordinates& p) {
      const double t = angle * p[2] / height, x = p[0] - middle, y = p[1] - middle;
      return Coordinates{std::cos(t) * x - std::sin(t) * y, std::sin(t) * x + std::cos(t) * y, p[2]};
    };
    return {place, Map().direction, {1, 1, rows_of(angle)}};
  }

  /// None turns by more than 6 degrees.
  int rows_of(double angle) { return 1 + static_cast<int>(angle / (between(3, 6) * degree)); }

  static Map slanted(double a, double b) {
    return {[=](const Coordinates& p) {
      return Coordinates{p[0], p[1], p[2] + p[2] / height * (a * (p[0] - middle) + b * (p[1] - middle))};
    }};
  }

  static Map lifted(double lift, double sense) {
    auto place = [=](const Coordinates& p) {
      const double x = (p[0] - middle) / middle, y = (p[1] - middle) / middle;
      return Coordinates{p[0], p[1], p[2] - lift * (0.5 + 0.5 * p[2] / height) * (x * x + sense * y * y)};
    };
    return {place, Map().direction, {8, 8, 1}};
  }

  /// About the y axis, at `radius` from it in the middle; what lies below `begin` stays straight.
  Map bent(double angle, double radius, double width, double begin) {
    auto turn = [=](double z) { return angle * std::max(0., z - begin) / (height - begin); };
    auto place = [=](const Coordinates& p) {
      const double t = turn(p[2]), r = radius + width * (p[0] - middle);
      return Coordinates{r * std::cos(t), width * (p[1] - middle), r * std::sin(t) + std::min(0., p[2] - begin)};
    };
    auto direction = [=](double z) { return Coordinates{-std::sin(turn(z)), 0, std::cos(turn(z))}; };
    return {place, direction, {1, 1, rows_of(angle)}};
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

/// The volume of what a map makes of a prism, as that of many small ones.
inline double mapped_volume(const Prism& prism, const Map& map) {
  constexpr int across = 4, up = 32;
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

/// Nodes wherever an edge meets one of some planes across an axis, evenly spaced over the box.
inline Part sliced(Part part, int axis, int slices) {
  for (int k = 0; k + 1 < slices; ++k) {
    const double off = axis == 0 ? 0.87 : axis == 1 ? 0.41 : 0.63;  // not where the nodes are
    const double at = (k + off) * (axis == 2 ? 12. : 24.) / slices;
    part = split_edges::once(part, [&](const Coordinates& p, const Coordinates& q) -> std::optional<Coordinates> {
      if ((p[axis] - at) * (q[axis] - at) >= 0) return std::nullopt;
      Coordinates node = split_edges::between(p, q, (at - p[axis]) / (q[axis] - p[axis]));
      node[axis] = at;
      return node;
    });
  }
  return part;
}

inline Swept_part mapped(Part part, const Map& map) {
  for (int axis = 0; axis < 3; ++axis) part = sliced(std::move(part), axis, map.slices[axis]);
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

/// A plate with circles below and above that coincide, but for their facets: those above the middle are turned by a
/// part of a facet, and may have twice the nodes.
inline Part faceted(std::uint32_t seed) {
  struct Circle {
    double x, y, radius;
    int nodes;
    double turn;  ///< of a facet
    bool finer;
  };
  std::mt19937 random(seed);
  auto pick = [&](int n) { return static_cast<int>(random() % static_cast<std::uint32_t>(n)); };
  constexpr double pi = 3.14159265358979323846, middle = 6, near = 1e-3;
  std::vector<Circle> circles;
  random_parts::Plan plan;
  plan.material = {{{{0, 0}, {24, 0}, {24, 24}, {0, 24}}}};
  plan.bottom = 4;
  plan.top = 8;
  for (double x : {6., 18.})
    for (double y : {6., 18.}) {
      const Circle c{x + pick(3) - 1, y + pick(3) - 1, 2 + pick(5) / 2., 24 + 4 * pick(11), pick(5) / 8., pick(2) > 0};
      random_parts::Outline outline;
      for (int k = 0; k < c.nodes; ++k)
        outline.push_back({c.x + c.radius * std::cos(2 * pi * k / c.nodes),
                           c.y + c.radius * std::sin(2 * pi * k / c.nodes)});
      if (const int kind = pick(4); kind == 0)
        plan.material.push_back({outline, false});
      else
        plan.bottoms.push_back({outline, double(pick(3))}), plan.tops.push_back({outline, kind == 1 ? 7. : 10. + kind});
      circles.push_back(c);
    }
  auto circle_at = [&](const Coordinates& p) -> const Circle* {
    if (p[2] < middle) return nullptr;
    for (const Circle& c : circles)
      if (std::abs(std::hypot(p[0] - c.x, p[1] - c.y) - c.radius) < near) return &c;
    return nullptr;
  };
  Part part = *random_parts::build(plan);
  part = split_edges::once(part, [&](const Coordinates& p, const Coordinates& q) -> std::optional<Coordinates> {
    const Circle* const c = circle_at(p);
    const double facet = c ? 2 * c->radius * std::sin(pi / c->nodes) : 0;
    if (!c || !c->finer || circle_at(q) != c || p[2] != q[2] || std::hypot(p[0] - q[0], p[1] - q[1]) > facet + near)
      return std::nullopt;
    const Coordinates m = split_edges::middle(p, q);
    const double k = c->radius / std::hypot(m[0] - c->x, m[1] - c->y);
    return Coordinates{c->x + k * (m[0] - c->x), c->y + k * (m[1] - c->y), m[2]};
  });
  return random_parts::moved(std::move(part), [&](const Coordinates& p) {
    const Circle* const c = circle_at(p);
    if (!c) return p;
    const double t = 2 * pi * c->turn / c->nodes, x = p[0] - c->x, y = p[1] - c->y;
    return Coordinates{c->x + std::cos(t) * x - std::sin(t) * y, c->y + std::sin(t) * x + std::cos(t) * y, p[2]};
  });
}

/// Facets that stand for a curve may cut into each other where features are close.
inline bool is_sound(const Part& part) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  return !CGAL::Polygon_mesh_processing::does_self_intersect(random_parts::mesh<Point>(part));
}

/// The part of a shape, family and seed: the first sound one from there on.
inline Swept_part make(Shape shape, random_parts::Family family, std::uint32_t seed) {
  constexpr std::uint32_t step = 1000003;
  for (;; seed += step) {
    Swept_part swept;
    if (shape == Shape::faceted)
      swept.part = faceted(16 * seed + static_cast<std::uint32_t>(family));
    else
      swept.part = random_parts::make(family, seed);
    if (shape != Shape::faceted && shape != Shape::straight)
      swept = mapped(std::move(swept.part), Map_maker(seed).make(shape));
    if (is_sound(swept.part)) return swept;
  }
}

}  // namespace curved_parts

#endif
