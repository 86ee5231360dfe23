// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_OUTER_MESH_H
#define CCSWEEP_INTERNAL_OUTER_MESH_H

#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Tagged_mesh.h>
#include <CCSweep/volumes/Decomposition.h>

#include <CGAL/boost/graph/iterator.h>

#include <map>

namespace CCSweep::internal {

/// The part that a decomposition was made of: the faces of its sub-volumes that are no cuts, joined where their points
/// are the same.
template <class Point>
Tagged_mesh<Point> outer_mesh(const Decomposition<Point>& decomposition) {
  using Mesh = typename Tagged_mesh<Point>::Mesh;
  Tagged_mesh<Point> outer;
  auto patch_ids = outer.patch_ids();
  std::map<Point, typename Mesh::Vertex_index> vertex_at;
  for (const auto& volume : decomposition.volumes) {
    const auto& mesh = volume.mesh;
    const auto patch = mesh.template property_map<typename Mesh::Face_index, int>(volume.patch_id_map);
    const auto role = mesh.template property_map<typename Mesh::Face_index, int>(volume.role_map);
    if (!patch.second || !role.second)
      fail(Status_code::invalid_parameter, Stage::input,
           "a sub-volume does not tell the patches and roles of its faces");
    for (auto f : mesh.faces()) {
      if (role.first[f] == static_cast<int>(Role::cut)) continue;
      std::vector<typename Mesh::Vertex_index> corners;
      for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
        const auto [found, is_new] = vertex_at.try_emplace(mesh.point(v));
        if (is_new) found->second = outer.mesh.add_vertex(mesh.point(v));
        corners.push_back(found->second);
      }
      const auto made = outer.mesh.add_face(corners);
      if (!made.is_valid())
        fail(Status_code::not_manifold, Stage::input, "the sub-volumes do not fit together to a part");
      patch_ids[made] = patch.first[f];
    }
  }
  return outer;
}

}  // namespace CCSweep::internal

#endif
