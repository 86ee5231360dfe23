// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_QUALITY_H
#define CCSWEEP_HEX_QUALITY_H

#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CCSweep {

/// The corners of a hexahedron, in VTK's order.
using Hex_corners = std::array<std::array<double, 3>, 8>;

namespace internal {

inline Hex_corners corners_of(const Hex_mesh& mesh, std::size_t hex) {
  Hex_corners p;
  for (int i = 0; i < 8; ++i) p[i] = mesh.points[mesh.hexes[hex][i]];
  return p;
}

/// At each corner its neighbours, in the sense that makes the determinant of the edges positive.
inline constexpr int hex_neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                             {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};

/// The determinant of three vectors over their lengths; -1 where one of them vanishes.
inline double scaled_determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double size = norm(a) * norm(b) * norm(c);
  return size > 0 ? dot(a, cross(b, c)) / size : -1;
}

/// The Bezier coefficients of a quadratic from its values at 0, 1/2 and 1.
inline std::array<double, 3> bezier(double a, double m, double b) { return {a, 2 * m - (a + b) / 2, b}; }

/// The determinant of the trilinear map of the unit cube at a place.
inline double jacobian_at(const Hex_corners& p, const std::array<double, 3>& at) {
  constexpr int cube[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::array<Vec3, 3> d{};
  for (int n = 0; n < 8; ++n)
    for (int k = 0; k < 3; ++k) {
      double w = cube[n][k] ? 1 : -1;
      for (int j = 0; j < 3; ++j)
        if (j != k) w *= cube[n][j] ? at[j] : 1 - at[j];
      d[k] = d[k] + w * p[n];
    }
  return dot(d[0], cross(d[1], d[2]));
}

/// The least Bezier coefficient of the determinant over a box in the unit cube: a bound from below of its values.
inline double bezier_bound(const Hex_corners& p, const std::array<double, 3>& low, double width) {
  std::array<std::array<std::array<double, 3>, 3>, 3> c;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        c[i][j][k] = jacobian_at(p, {low[0] + width * i / 2, low[1] + width * j / 2, low[2] + width * k / 2});
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c[i][j] = bezier(c[i][j][0], c[i][j][1], c[i][j][2]);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      const auto b = bezier(c[i][0][k], c[i][1][k], c[i][2][k]);
      for (int j = 0; j < 3; ++j) c[i][j][k] = b[j];
    }
  double least = 1e300;
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k)
      for (double x : bezier(c[0][j][k], c[1][j][k], c[2][j][k])) least = std::min(least, x);
  return least;
}

/// Whether each triple of an edge along each of the three axes turns to the positive: the determinant is a mean of
/// theirs everywhere, so then it is positive. Cheap, and enough for nearly all hexahedra.
inline bool has_positive_triples(const Hex_corners& p) {
  const Vec3 u[4] = {p[1] - p[0], p[2] - p[3], p[5] - p[4], p[6] - p[7]};
  const Vec3 v[4] = {p[3] - p[0], p[2] - p[1], p[7] - p[4], p[6] - p[5]};
  const Vec3 w[4] = {p[4] - p[0], p[5] - p[1], p[6] - p[2], p[7] - p[3]};
  double least = 1e300;
  for (const Vec3& b : v)
    for (const Vec3& c : w) {
      const Vec3 n = cross(b, c);
      for (const Vec3& a : u) least = std::min(least, dot(a, n));
    }
  return least > 0;
}

inline bool is_positive_in(const Hex_corners& p, const std::array<double, 3>& low, double width, int halvings) {
  if (bezier_bound(p, low, width) > 0) return true;
  if (halvings == 0) return false;
  const double half = width / 2;
  for (int i = 0; i < 8; ++i)
    if (!is_positive_in(p, {low[0] + (i & 1) * half, low[1] + (i >> 1 & 1) * half, low[2] + (i >> 2) * half}, half,
                        halvings - 1))
      return false;
  return true;
}

}  // namespace internal

/// The scaled Jacobian in Verdict's definition: the least of the determinants of the edges at the eight corners and of
/// the principal axes, each over the product of the lengths. 1 for a brick, not positive where the hexahedron folds.
inline double scaled_jacobian(const Hex_corners& p) {
  using namespace internal;
  // The edges along the three axes; each meets two corners.
  constexpr int ends[3][4][2] = {{{0, 1}, {3, 2}, {4, 5}, {7, 6}}, {{0, 3}, {1, 2}, {4, 7}, {5, 6}},
                                 {{0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  constexpr int edges_at[8][3] = {{0, 0, 0}, {0, 1, 1}, {1, 1, 2}, {1, 0, 3},
                                  {2, 2, 0}, {2, 3, 1}, {3, 3, 2}, {3, 2, 3}};
  Vec3 edge[3][4], axis[3] = {};
  double squared_length[3][4];
  for (int k = 0; k < 3; ++k)
    for (int e = 0; e < 4; ++e) {
      edge[k][e] = p[ends[k][e][1]] - p[ends[k][e][0]];
      squared_length[k][e] = dot(edge[k][e], edge[k][e]);
      if (!(squared_length[k][e] > 0)) return -1;
      axis[k] = axis[k] + edge[k][e];
    }
  // Quotients are ordered as their squares that keep the sign, so one root is enough.
  const auto signed_square = [](double x) { return x * std::abs(x); };
  const double of_axes = dot(axis[0], axis[0]) * dot(axis[1], axis[1]) * dot(axis[2], axis[2]);
  if (!(of_axes > 0)) return -1;
  double least = std::min(1.0, signed_square(dot(axis[0], cross(axis[1], axis[2]))) / of_axes);
  for (const auto& [u, v, w] : edges_at) {
    const double lengths = squared_length[0][u] * squared_length[1][v] * squared_length[2][w];
    least = std::min(least, signed_square(dot(edge[0][u], cross(edge[1][v], edge[2][w]))) / lengths);
  }
  return std::copysign(std::sqrt(std::abs(least)), least);
}

/// The scaled Jacobian of each hexahedron. Complexity: linear.
inline std::vector<double> scaled_jacobians(const Hex_mesh& mesh) {
  std::vector<double> result;
  result.reserve(mesh.hexes.size());
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h) result.push_back(scaled_jacobian(internal::corners_of(mesh, h)));
  return result;
}

/// Whether the Jacobian determinant is positive everywhere in a hexahedron, not only in its corners: proved by its
/// Bezier coefficients, which bound it from below, on ever smaller boxes. False where that does not succeed.
inline bool is_positive(const Hex_corners& p) {
  if (internal::has_positive_triples(p)) return true;
  for (int i = 0; i < 8; ++i) {
    using namespace internal;
    const auto& n = hex_neighbours[i];
    if (!(dot(p[n[0]] - p[i], cross(p[n[1]] - p[i], p[n[2]] - p[i])) > 0)) return false;
  }
  return internal::is_positive_in(p, {0, 0, 0}, 1, 4);
}

}  // namespace CCSweep

#endif
