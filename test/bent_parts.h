// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_BENT_PARTS_H
#define CCSWEEP_TEST_BENT_PARTS_H

#include "random_parts.h"

#include <cmath>
#include <cstddef>
#include <vector>

// Rods along an arc whose ends are split in halves along different diameters: two targets, two sources, and, where
// the halves cross, two decomposition sets.
namespace bent_parts {

/// A rod of radius 2 with `around` sides and `patches_around` walls, bent about the z axis at radius 6 by `angle`.
inline random_parts::Part rod(double angle, std::size_t around, std::size_t patches_around) {
  constexpr double pi = 3.14159265358979323846;
  random_parts::Part part;
  const auto along = static_cast<std::size_t>(std::ceil(angle / (5 * pi / 180)));
  for (std::size_t i = 0; i <= along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const double t = angle * double(i) / double(along), s = 2 * pi * double(j) / double(around);
      const double r = 6 + 2 * std::cos(s);
      part.points.push_back({r * std::cos(t), r * std::sin(t), 2 * std::sin(s)});
    }
  auto node = [&](std::size_t i, std::size_t j) { return i * around + j % around; };
  auto add = [&](std::size_t a, std::size_t b, std::size_t c, int patch) {
    part.triangles.push_back({a, c, b});
    part.patch.push_back(patch);
  };
  for (std::size_t i = 0; i < along; ++i)
    for (std::size_t j = 0; j < around; ++j) {
      const int wall = static_cast<int>(j * patches_around / around);
      add(node(i, j), node(i + 1, j + 1), node(i + 1, j), wall);
      add(node(i, j), node(i, j + 1), node(i + 1, j + 1), wall);
    }
  // Half an end from node `first` on, as a fan.
  auto add_half = [&](std::size_t i, std::size_t first, int patch) {
    for (std::size_t k = 1; k < around / 2; ++k)
      i == 0 ? add(node(0, first), node(0, first + k + 1), node(0, first + k), patch)
             : add(node(i, first), node(i, first + k), node(i, first + k + 1), patch);
  };
  add_half(0, around / 4, 100);
  add_half(0, around / 4 + around / 2, 101);
  add_half(along, 0, 200);
  add_half(along, around / 2, 201);
  return part;
}

}  // namespace bent_parts

#endif
