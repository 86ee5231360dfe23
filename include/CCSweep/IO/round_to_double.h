// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_ROUND_TO_DOUBLE_H
#define CCSWEEP_IO_ROUND_TO_DOUBLE_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/part/Tagged_mesh.h>
#include <CCSweep/volumes/Decomposition.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CCSweep {

/// The points that files hold.
using Double_point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

namespace internal {

// The same mesh with its coordinates rounded, and those of its face properties of type int that are named.
template <class Point>
CGAL::Surface_mesh<Double_point> rounded_mesh(const CGAL::Surface_mesh<Point>& mesh,
                                              std::initializer_list<const char*> properties) {
  using From = CGAL::Surface_mesh<Point>;
  using To = CGAL::Surface_mesh<Double_point>;
  To result;
  result.reserve(mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces());
  std::vector<typename To::Vertex_index> vertices(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  for (auto v : mesh.vertices()) {
    const auto p = file_point(mesh.point(v));
    vertices[v] = result.add_vertex({p[0], p[1], p[2]});
  }
  std::vector<typename From::Face_index> source;
  for (auto f : mesh.faces()) {
    std::array<typename To::Vertex_index, 3> corners;
    std::size_t i = 0;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) corners[i++] = vertices[v];
    result.add_face(corners);
    source.push_back(f);
  }
  for (const char* name : properties) {
    const auto from = mesh.template property_map<typename From::Face_index, int>(name).first;
    auto to = result.template add_property_map<typename To::Face_index, int>(name).first;
    for (auto f : result.faces()) to[f] = from[source[f]];
  }
  return result;
}

}  // namespace internal

/// The part with its coordinates rounded to the doubles that a file holds; its faces are triangles.
template <class Point>
Tagged_mesh<Double_point> round_to_double(const Tagged_mesh<Point>& part) {
  return {internal::rounded_mesh(part.mesh, {Tagged_mesh<Point>::patch_id_map})};
}

/// The decomposition with its coordinates rounded to the doubles that `write_volumes()` writes. Points that are equal
/// before are equal after; nothing else is promised, so that the result has to be verified again.
template <class Point>
Decomposition<Double_point> round_to_double(const Decomposition<Point>& decomposition) {
  Decomposition<Double_point> result{{},
                                     decomposition.sets,
                                     decomposition.roles,
                                     decomposition.direction,
                                     decomposition.levels,
                                     decomposition.layers,
                                     decomposition.sweep_parameters,
                                     decomposition.tolerance,
                                     decomposition.notes,
                                     decomposition.seconds};
  for (const Sub_volume<Point>& volume : decomposition.volumes)
    result.volumes.push_back(
        {internal::rounded_mesh(volume.mesh, {volume.patch_id_map, volume.role_map}), volume.target, volume.sources});
  return result;
}

}  // namespace CCSweep

#endif
