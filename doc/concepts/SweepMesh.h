// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// The surface of a part as the library reads it: the concepts `HalfedgeListGraph` and `FaceListGraph` of CGAL.
///
/// The mesh must be a closed, 2-manifold, outward oriented surface. That is checked when it is read, always, and
/// told by a `CCSweep::Status` with the place of the defect. Faces need not be triangles when a file is read, but
/// are for the stages. The library never changes the mesh.
///
/// Checked at compile time by `CCSweep::SweepMesh` in `CCSweep/concepts.h`. Every stage reads the mesh once, so
/// the time of a query matters little.
///
/// Models: `CGAL::Surface_mesh`, `CGAL::Polyhedron_3`, and any other halfedge structure that CGAL's graph concepts
/// have been written for.
///
/// Goes with two property maps:
/// - a vertex point map (named parameter `vertex_point_map`), by default that of the mesh;
/// - a face patch map (named parameter `face_patch_map`) with the `int` id of each face's CAD face.
class SweepMesh {
 public:
  /// \name Valid expressions
  /// With `g` a constant mesh, `v`, `h`, `e`, `f` descriptors of a vertex, halfedge, edge and face of
  /// `boost::graph_traits`: ranges `vertices(g)`, `halfedges(g)`, `edges(g)`, `faces(g)` and their `num_...(g)`;
  /// `next(h, g)`, `prev(h, g)`, `opposite(h, g)`, `source(h, g)`, `target(h, g)`, `face(h, g)`, `edge(h, g)`;
  /// `halfedge(v, g)`, `halfedge(e, g)`, `halfedge(f, g)`; `boost::graph_traits<Mesh>::null_face()`.
  /// @{
  /// @}
};
