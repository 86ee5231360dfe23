// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_CUT_SURFACE_H
#define CCSWEEP_VOLUMES_CUT_SURFACE_H

#include <CCSweep/indices.h>
#include <CCSweep/volumes/triangulate_plane.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CCSweep {

/// The part's surface after all curves were drawn on it: a triangle soup over shared vertices. The first vertices are
/// those of the part.
template <class Traits>
struct Cut_surface {
  using Vertex = std::uint32_t;
  static constexpr Vertex none = Vertex(-1);

  std::vector<typename Traits::Point_3> points;
  std::vector<internal::Triangle> triangles;
  std::vector<Patch_index> patch;                                    ///< by triangle
  std::vector<Vertex> vertex_of_node;            ///< by node of the layers; `none` where it was not placed
  std::map<internal::Vertex_pair, std::vector<Vertex>> path_between;  ///< drawn curves that got further vertices
  std::vector<std::vector<Vertex>> chains;       ///< edges of the part that got further vertices
  std::map<Vertex, std::size_t> chain_of_vertex; ///< the edge that a further vertex lies on

  /// The vertices from v to w, both included, along the curve or the edge of the part that joins them.
  std::vector<Vertex> path(Vertex v, Vertex w) const {
    if (const auto found = path_between.find(std::minmax(v, w)); found != path_between.end())
      return oriented(found->second, v);
    auto chain = chain_of_vertex.find(v);
    if (chain == chain_of_vertex.end()) chain = chain_of_vertex.find(w);
    if (chain == chain_of_vertex.end()) return {v, w};
    const std::vector<Vertex>& all = chains[chain->second];
    auto first = std::find(all.begin(), all.end(), v), last = std::find(all.begin(), all.end(), w);
    if (first == all.end() || last == all.end()) return {v, w};
    if (last < first) std::swap(first, last);
    return oriented({first, last + 1}, v);
  }

 private:
  static std::vector<Vertex> oriented(std::vector<Vertex> path, Vertex first) {
    if (path.front() != first) std::reverse(path.begin(), path.end());
    return path;
  }
};

}  // namespace CCSweep

#endif
