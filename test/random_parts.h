// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_RANDOM_PARTS_H
#define CCSWEEP_TEST_RANDOM_PARTS_H

#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <string>

#include "random_parts_answer.h"

// A seeded generator of straight multi-sweep parts with a known answer; see `Plan`, `Part` and `build()`.
namespace random_parts {

enum class Family {
  grids,     ///< independent rectangle grids below and above, five levels each
  barrels,   ///< a slab with rectangular legs, posts, pads, pockets and through-holes, overlapping at will
  polygons,  ///< the same with convex polygons
  circles,   ///< the same with circles, rings off-centre, and arcs over straight edges
  mixed,     ///< the same with all of them
  split,     ///< level caps that fall into patches without a step
  windows,   ///< a slot through the part from side to side, with material above it
};
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
    } else {
      for (int i = 0, n = 1 + pick(3); i < n; ++i) p.bottoms.push_back({shape(), heights_below[pick(5)]});
      for (int i = 0, n = 1 + pick(3); i < n; ++i) p.tops.push_back({shape(), heights_above[pick(5)]});
      for (int i = 0, n = pick(3); i < n; ++i) p.material.push_back({shape(), false});
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
    const double start = turned ? pick(360) * pi / 180 : pick(n) * pi / (n * n);
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

/// The part of a seed: the first plan from there on that makes a sound one.
inline Part make(Family family, std::uint32_t seed, bool may_touch_itself = false) {
  Generator generator(family, seed);
  for (;;)
    if (std::optional<Part> part = build(generator.plan()); part && (may_touch_itself || !part->touches_itself))
      return *part;
}

/// The part moved by `f`, which takes and returns a point.
template <class Function>
Part moved(Part part, Function f) {
  for (auto& p : part.points) p = f(p);
  return part;
}

/// Turned about two axes, scaled, then shifted. The sweep then runs along `turned({0, 0, 1})`.
inline std::array<double, 3> turned(const std::array<double, 3>& p) {
  const std::array<double, 3> q{0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2]};
  return {q[0], 5.0 / 13 * q[1] - 12.0 / 13 * q[2], 12.0 / 13 * q[1] + 5.0 / 13 * q[2]};
}

inline Part placed(const Part& part, bool turn, double scale, const std::array<double, 3>& shift) {
  Part result = moved(part, [&](std::array<double, 3> p) {
    if (turn) p = turned(p);
    for (int k = 0; k < 3; ++k) p[k] = scale * p[k] + shift[k];
    return p;
  });
  const double factor = scale * scale * scale;
  result.volume *= factor;
  for (auto& [target, volume] : result.sub_volumes) volume *= factor;
  return result;
}

/// The part as a mesh with the face property `f:patch_id`.
template <class Point>
CGAL::Surface_mesh<Point> mesh(const Part& part) {
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh result;
  auto patch = result.template add_property_map<typename Mesh::Face_index, int>("f:patch_id", -1).first;
  std::vector<typename Mesh::Vertex_index> v;
  for (const auto& p : part.points) v.push_back(result.add_vertex(Point(p[0], p[1], p[2])));
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const auto& t = part.triangles[i];
    patch[result.add_face(v[t[0]], v[t[1]], v[t[2]])] = part.patch[i];
  }
  return result;
}

/// Writes the part as ascii PLY with the face property `patch_id`.
inline void write_ply(const Part& part, std::ostream& out) {
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "ply\nformat ascii 1.0\nelement vertex " << part.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << part.triangles.size()
      << "\nproperty list uchar int vertex_indices\nproperty int patch_id\nend_header\n";
  for (const auto& p : part.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (std::size_t i = 0; i < part.triangles.size(); ++i)
    out << "3 " << part.triangles[i][0] << ' ' << part.triangles[i][1] << ' ' << part.triangles[i][2] << ' '
        << part.patch[i] << '\n';
}

/// The same into a file; false when it can't be written.
inline bool write_ply(const Part& part, const std::string& file) {
  std::ofstream out(file);
  write_ply(part, out);
  return static_cast<bool>(out.flush());
}

}  // namespace random_parts

#endif
