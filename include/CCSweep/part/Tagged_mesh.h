// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_TAGGED_MESH_H
#define CCSWEEP_PART_TAGGED_MESH_H

#include <CGAL/Surface_mesh.h>

namespace CCSweep {

/// A part as it is read from a file: a triangle mesh whose faces carry the id of their CAD face in the face property
/// map `"f:patch_id"`.
template <class Point>
struct Tagged_mesh {
  using Mesh = CGAL::Surface_mesh<Point>;
  using Patch_map = typename Mesh::template Property_map<typename Mesh::Face_index, int>;
  static constexpr const char* patch_id_map = "f:patch_id";  ///< face property of type int

  Mesh mesh;

  /// The face patch map, ready for `CGAL::parameters::face_patch_map()`. It is added where the mesh has none.
  Patch_map patch_ids() {
    return mesh.template add_property_map<typename Mesh::Face_index, int>(patch_id_map, -1).first;
  }
  Patch_map patch_ids() const { return mesh.template property_map<typename Mesh::Face_index, int>(patch_id_map).first; }
};

}  // namespace CCSweep

#endif
