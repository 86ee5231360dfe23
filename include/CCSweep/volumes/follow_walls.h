// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_FOLLOW_WALLS_H
#define CCSWEEP_VOLUMES_FOLLOW_WALLS_H

#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Surface_location.h>
#include <CCSweep/volumes/Cut_rows.h>
#include <CCSweep/volumes/Cut_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Gives the inner columns beside walls vertices at the heights where the wall bends. The triangles between a bent
/// curve on a wall and a straight column then lie about across the sweep; else they would run far up or down over a few
/// steps away from the wall, to where its facets stand out further, and cut into these.
template <class Traits>
class Wall_follower {
  using Vertex = typename Cut_surface<Traits>::Vertex;

 public:
  Wall_follower(const Layered_loops<Traits>& loops, const std::vector<Cut_row>& rows, Cut_surface<Traits>& surface)
      : loops_(loops), rows_(rows), surface_(surface) {}

  void run() {
    for (const Cut_row& row : rows_)
      for (std::size_t i = 0; i + 1 < row.bottom.size(); ++i) {
        follow(row, i, i + 1);
        follow(row, i + 1, i);
      }
  }

 private:
  Vertex vertex(Node_index n) const { return surface_.vertex_of_node[n.value()]; }
  bool is_on_surface(Node_index n) const { return loops_.node(n).where.on_surface(); }
  Vec3 coordinates(Vertex v) const { return Part<Traits>::coordinates(surface_.points[v]); }

  void follow(const Cut_row& row, std::size_t wall, std::size_t column) {
    if (is_on_surface(row.bottom[column]) && is_on_surface(row.top[column])) return;
    const Vertex low = vertex(row.bottom[column]), high = vertex(row.top[column]);
    if (low == high || surface_.path_between.count(std::minmax(low, high))) return;
    const std::vector<double> heights = bends(surface_.path(vertex(row.bottom[wall]), vertex(row.top[wall])));
    if (heights.empty()) return;
    std::vector<Vertex> path{low};
    for (double t : heights) {
      path.push_back(static_cast<Vertex>(surface_.points.size()));
      surface_.points.push_back(point_between(surface_.points[low], surface_.points[high], t));
    }
    path.push_back(high);
    surface_.path_between.emplace(std::minmax(low, high), std::move(path));
  }

  // The fractions of the way up at which a curve turns.
  std::vector<double> bends(const std::vector<Vertex>& curve) const {
    constexpr double straight = 1e-6, apart = 1e-6;
    const Vec3 start = coordinates(curve.front()), along = coordinates(curve.back()) - start;
    std::vector<double> result;
    for (std::size_t k = 1; k + 1 < curve.size(); ++k) {
      const Vec3 here = coordinates(curve[k]);
      if (angle(here - coordinates(curve[k - 1]), coordinates(curve[k + 1]) - here) <= straight) continue;
      const double t = dot(here - start, along) / dot(along, along);
      if (t > (result.empty() ? 0 : result.back()) + apart && t < 1 - apart) result.push_back(t);
    }
    return result;
  }

  const Layered_loops<Traits>& loops_;
  const std::vector<Cut_row>& rows_;
  Cut_surface<Traits>& surface_;
};

}  // namespace CCSweep::internal

#endif
