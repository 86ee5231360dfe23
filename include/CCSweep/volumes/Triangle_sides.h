// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_TRIANGLE_SIDES_H
#define CCSWEEP_VOLUMES_TRIANGLE_SIDES_H

#include <CCSweep/volumes/triangulate_plane.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CCSweep::internal {

/// The sides of a triangle soup by their first vertex. Side 3 t + k runs from corner k of triangle t to the next
/// corner. Built in linear time; a side is found in time linear in the triangles at a vertex.
class Triangle_sides {
 public:
  Triangle_sides(std::span<const Triangle> triangles, std::size_t number_of_vertices)
      : first_(number_of_vertices + 1, 0), sides_(3 * triangles.size()) {
    for (const Triangle& t : triangles)
      for (std::uint32_t v : t) ++first_[v + 1];
    for (std::size_t v = 0; v < number_of_vertices; ++v) first_[v + 1] += first_[v];
    std::vector<std::uint32_t> next = first_;
    std::uint32_t number = 0;
    for (const Triangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) sides_[next[t[k]]++] = {t[k == 2 ? 0 : k + 1], number++};
  }

  /// Calls a function with each side from v to w.
  template <class Function>
  void for_each(std::uint32_t v, std::uint32_t w, const Function& function) const {
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i)
      if (sides_[i].target == w) function(sides_[i].number);
  }

 private:
  struct Side {
    std::uint32_t target, number;
  };

  std::vector<std::uint32_t> first_;  // by vertex, in `sides_`
  std::vector<Side> sides_;
};

}  // namespace CCSweep::internal

#endif
