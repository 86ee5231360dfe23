// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_CANONICAL_COPY_H
#define CCSWEEP_PART_CANONICAL_COPY_H

#include <CCSweep/internal/bucket_sort.h>
#include <CCSweep/internal/connect_triangles.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Vertices by coordinates. Those at the same place (solids that touch in an edge or a vertex) are told apart by the
// coordinates of their neighbours.
template <class FaceGraph, class VertexPointMap>
class Canonical_vertices {
  using Vertex = typename boost::graph_traits<FaceGraph>::vertex_descriptor;
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using FT = std::decay_t<decltype(std::declval<Point_3>().x())>;

 public:
  struct Placed {
    std::array<FT, 3> place;
    Vertex vertex;
  };

  Canonical_vertices(const FaceGraph& mesh, VertexPointMap point_of) : mesh_(mesh), point_of_(point_of) {}

  std::vector<Placed> run() const {
    std::vector<Placed> order;
    order.reserve(num_vertices(mesh_));
    for (auto v : vertices(mesh_)) {
      const Point_3& p = get(point_of_, v);
      order.push_back({{p.x(), p.y(), p.z()}, v});
    }
    sort_from_axis<0>(order);
    return order;
  }

 private:
  // By the coordinates from an axis on. In meshes many are equal, so that it pays to sort by one after another.
  template <std::size_t axis>
  void sort_from_axis(std::span<Placed> range) const {
    const auto is_less = [](const Placed& a, const Placed& b) { return a.place[axis] < b.place[axis]; };
    if constexpr (std::is_same_v<FT, double>)
      boost::sort::spreadsort::integer_sort(range.begin(), range.end(), Shifted<axis>(), is_less);
    else
      std::sort(range.begin(), range.end(), is_less);
    for (std::size_t first = 0, last = 0; first < range.size(); first = last) {
      while (last < range.size() && range[last].place[axis] == range[first].place[axis]) ++last;
      if (last - first == 1) continue;
      if constexpr (axis < 2)
        sort_from_axis<axis + 1>(range.subspan(first, last - first));
      else
        sort_by_neighbours(range.subspan(first, last - first));
    }
  }

  // Whole numbers in the order of the coordinates: the bits of a double, all inverted if it is negative. Boost's own
  // sort of floating-point numbers subtracts signed ones and may overflow.
  template <std::size_t axis>
  struct Shifted {
    std::uint64_t operator()(const Placed& p, unsigned offset) const {
      constexpr std::uint64_t sign = std::uint64_t(1) << 63;
      const auto bits = std::bit_cast<std::uint64_t>(p.place[axis]);
      return ((bits & sign) != 0 ? ~bits : bits | sign) >> offset;
    }
  };

  void sort_by_neighbours(std::span<Placed> range) const {
    std::sort(range.begin(), range.end(), [this](const Placed& a, const Placed& b) {
      return a.vertex != b.vertex && neighbours(a.vertex) < neighbours(b.vertex);
    });
  }

  std::vector<Point_3> neighbours(Vertex v) const {
    std::vector<Point_3> points;
    for (auto h : CGAL::halfedges_around_target(v, mesh_)) points.push_back(get(point_of_, source(h, mesh_)));
    std::sort(points.begin(), points.end());
    return points;
  }

  const FaceGraph& mesh_;
  VertexPointMap point_of_;
};

/// Copies a closed triangle mesh in canonical order: vertices by coordinates, faces by vertices. Returns the patch id
/// of each face. Complexity: O(n log n), of which only the vertices' order is more than linear.
template <class FaceGraph, class VertexPointMap, class FacePatchMap, class Point_3>
std::vector<int> copy_in_canonical_order(const FaceGraph& input, VertexPointMap point_of, FacePatchMap patch_of,
                                         CGAL::Surface_mesh<Point_3>& mesh) {
  struct Facet {
    std::array<std::uint32_t, 3> corners;
    int id;
  };
  const auto rank = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), input);
  const auto order = Canonical_vertices<FaceGraph, VertexPointMap>(input, point_of).run();
  mesh.resize(static_cast<std::uint32_t>(order.size()), 0, 0);
  for (std::uint32_t v = 0; v < order.size(); ++v) {
    mesh.point(CGAL::SM_Vertex_index(v)) = get(point_of, order[v].vertex);
    put(rank, order[v].vertex, v);
  }
  std::vector<Facet> facets;
  facets.reserve(num_faces(input));
  for (auto f : faces(input)) {
    const auto h = halfedge(f, input);
    std::array<std::uint32_t, 3> v{get(rank, source(h, input)), get(rank, target(h, input)),
                                   get(rank, target(next(h, input), input))};
    while (v[0] > v[1] || v[0] > v[2]) v = {v[1], v[2], v[0]};
    facets.push_back({v, static_cast<int>(get(patch_of, f))});
  }
  bucket_sort(
      facets, mesh.number_of_vertices(), [](const Facet& f) { return f.corners[0]; },
      [](const Facet& f, const Facet& g) { return f.corners < g.corners; });
  Triangle_connector<Point_3>::run(facets, [](const Facet& f) { return f.corners; }, mesh);
  std::vector<int> id_of_face;
  id_of_face.reserve(facets.size());
  for (const Facet& f : facets) id_of_face.push_back(f.id);
  return id_of_face;
}

}  // namespace CCSweep::internal

#endif
