// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_CONNECT_TRIANGLES_H
#define CCSWEEP_INTERNAL_CONNECT_TRIANGLES_H

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CCSweep::internal {

/// Connects the vertices of a mesh, which has nothing else yet, by the triangles of a closed 2-manifold. Halfedges,
/// edges and faces come in the order in which `CGAL::Euler::add_face()` makes them, which looks for borders to link at
/// every vertex of every face; here nothing is linked before its neighbour is there.
template <class Point>
class Triangle_connector {
  using Mesh = CGAL::Surface_mesh<Point>;
  using Size = typename Mesh::size_type;
  using Vertex = CGAL::SM_Vertex_index;
  using Halfedge = CGAL::SM_Halfedge_index;
  using Face = CGAL::SM_Face_index;

 public:
  /// Returns whether every edge has two triangles, which run along it in opposite senses; otherwise the mesh is left
  /// half made. Complexity: linear, where no vertex has very many triangles.
  /// \param corners tells the three vertices of a triangle
  template <class Triangle, class Corners>
  static bool run(const std::vector<Triangle>& triangles, const Corners& corners, Mesh& mesh) {
    if (triangles.size() % 2 != 0) return false;
    return Triangle_connector(triangles.size(), mesh).connect(triangles, corners);
  }

 private:
  static constexpr Size none = std::numeric_limits<Size>::max();

  Triangle_connector(std::size_t triangles, Mesh& mesh)
      : mesh_(mesh), first_edge_(mesh.number_of_vertices(), none), edges_(3 * triangles / 2) {
    mesh.resize(mesh.number_of_vertices(), static_cast<Size>(edges_.size()), static_cast<Size>(triangles));
  }

  template <class Triangle, class Corners>
  bool connect(const std::vector<Triangle>& triangles, const Corners& corners) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const std::array<std::uint32_t, 3> v = corners(triangles[t]);
      std::array<Halfedge, 3> sides;
      const Face face(static_cast<Size>(t));
      for (std::size_t k = 0; k < 3; ++k) {
        sides[k] = side(v[k], v[(k + 1) % 3]);
        if (!sides[k].is_valid()) return false;
        mesh_.set_face(sides[k], face);
        mesh_.set_halfedge(Vertex(v[(k + 1) % 3]), sides[k]);
      }
      for (std::size_t k = 0; k < 3; ++k) mesh_.set_next(sides[k], sides[(k + 1) % 3]);
      mesh_.set_halfedge(face, sides[2]);
    }
    return true;  // of twice as many sides as edges, every second one has found its opposite
  }

  // The halfedge from a to b: opposite to one that is there, or the first of a new edge. Invalid where it is there
  // already or where there are too many edges.
  Halfedge side(Size a, Size b) {
    if (a == b) return Halfedge();
    if (const Size edge = edge_from(b, a); edge != none) {
      const Halfedge back(2 * edge + 1);
      return mesh_.face(back).is_valid() ? Halfedge() : back;
    }
    if (number_of_edges_ == edges_.size() || edge_from(a, b) != none) return Halfedge();
    const Halfedge made(2 * number_of_edges_);
    mesh_.set_target(made, Vertex(b));
    mesh_.set_target(mesh_.opposite(made), Vertex(a));
    edges_[number_of_edges_] = {b, first_edge_[a]};
    first_edge_[a] = number_of_edges_++;
    return made;
  }

  // The edge whose first halfedge leads from a to b.
  Size edge_from(Size a, Size b) const {
    Size edge = first_edge_[a];
    while (edge != none && edges_[edge].target != b) edge = edges_[edge].next;
    return edge;
  }

  // Of the list of the edges whose first halfedge leaves a vertex.
  struct Listed_edge {
    Size target, next;
  };

  Mesh& mesh_;
  std::vector<Size> first_edge_;  // by vertex
  std::vector<Listed_edge> edges_;
  Size number_of_edges_ = 0;
};

/// Whether all triangles at a vertex are met on one walk around it.
template <class Point>
bool has_single_fans(const CGAL::Surface_mesh<Point>& mesh) {
  std::size_t corners = 0;
  for (auto v : mesh.vertices()) {
    const auto start = mesh.halfedge(v);
    auto h = start;
    do {
      ++corners;
      h = mesh.opposite(mesh.next(h));
    } while (h != start);
  }
  return corners == mesh.number_of_halfedges();
}

}  // namespace CCSweep::internal

#endif
