// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// The topology of the sources and targets of one layer, section 2.5 of the paper.
///
/// Refines `HalfedgeListGraph` and `FaceListGraph` of CGAL and `BidirectionalGraph`, `VertexListGraph` and
/// `EdgeListGraph` of Boost, where a LoopVertex is a vertex, a LoopEdge an edge, a LoopCoEdge a halfedge and a
/// LoopLoop a face. So algorithms of Boost.Graph and CGAL run on it as it stands. Adds a second level, the LoopFaces,
/// each with one outer and any number of inner loops: a face of a halfedge graph has one boundary cycle, and an
/// algorithm that walks a face with a second one would miss the hole.
///
/// There are no self-loops (a closed curve has two vertices); parallel edges are ordinary. The outside is
/// `null_face()`.
///
/// Checked at compile time by `CCSweep::LoopFaceGraph`.
///
/// Model: `CCSweep::Loop_face_graph`.
class LoopFaceGraph {
 public:
  /// A LoopVertex.
  typedef unspecified_type Vertex_index;
  /// A LoopCoEdge.
  typedef unspecified_type Halfedge_index;
  /// A LoopLoop.
  typedef unspecified_type Face_index;

  /// The node of the layer at a LoopVertex.
  Node_index node(Vertex_index v) const;
  /// The nodes along a LoopCoEdge in its own direction, both ends included; those of the opposite one are reversed.
  /// Here and below a type that converts to this one will do.
  std::span<const Node_index> nodes(Halfedge_index h) const;
  /// The LoopFace that a loop bounds.
  Loop_face_index loop_face(Face_index loop) const;
  /// The loop around a LoopFace.
  Face_index outer_loop(Loop_face_index f) const;
  /// All loops of a LoopFace, the outer one first.
  std::span<const Face_index> loops(Loop_face_index f) const;
  /// The source and the target that a LoopFace belongs to.
  Loop_label label(Loop_face_index f) const;
  /// LoopFaces are numbered from 0 on without gaps.
  std::size_t number_of_loop_faces() const;
};
