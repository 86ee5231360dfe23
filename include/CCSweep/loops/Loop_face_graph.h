// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_LOOP_FACE_GRAPH_H
#define CCSWEEP_LOOPS_LOOP_FACE_GRAPH_H

#include <CCSweep/indices.h>
#include <CCSweep/Layer_drawing.h>

#include <algorithm>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <span>
#include <vector>

namespace CCSweep {

using Loop_vertex_index = Index<struct Loop_vertex_kind>;  ///< a LoopVertex
using Loop_coedge_index = Index<struct Loop_coedge_kind>;  ///< a LoopCoEdge; its opposite differs in the last bit
using Loop_index = Index<struct Loop_kind>;                ///< a LoopLoop
using Loop_face_index = Index<struct Loop_face_kind>;      ///< a LoopFace

/// A LoopEdge: a pair of LoopCoEdges. It remembers the one it was made from, and is compared by the pair.
class Loop_edge {
 public:
  constexpr Loop_edge() = default;
  constexpr explicit Loop_edge(Loop_coedge_index coedge) : coedge_(coedge) {}

  constexpr Loop_coedge_index coedge() const { return coedge_; }
  constexpr bool is_valid() const { return coedge_.is_valid(); }
  /// The number of the edge, from 0 on without gaps.
  constexpr std::size_t value() const { return coedge_.value() / 2; }

  friend constexpr bool operator==(Loop_edge a, Loop_edge b) { return a.value() == b.value(); }
  friend constexpr auto operator<=>(Loop_edge a, Loop_edge b) { return a.value() <=> b.value(); }
  friend std::ostream& operator<<(std::ostream& out, Loop_edge edge) { return out << edge.value(); }

 private:
  Loop_coedge_index coedge_;
};

/// The topology of the sources and targets of one layer (section 2.5): LoopVertices, LoopEdges, LoopCoEdges,
/// LoopLoops and LoopFaces. A model of CGAL's `HalfedgeListGraph` and `FaceListGraph` and of Boost's
/// `BidirectionalGraph`, `VertexListGraph` and `EdgeListGraph`, where a LoopVertex is a vertex, a LoopCoEdge a
/// halfedge and a LoopLoop a face; what no loop bounds is the null face. A LoopFace stands above that: it groups one
/// outer and any number of inner loops and carries a label. Parallel edges are ordinary, self-loops are not allowed.
/// All queries take constant time. `Traits` is the kernel of the layer's chart.
template <class Traits>
class Loop_face_graph {
 public:
  using Point_2 = typename Traits::Point_2;
  using Vertex_index = Loop_vertex_index;
  using Halfedge_index = Loop_coedge_index;
  using Edge_index = Loop_edge;
  using Face_index = Loop_index;

  /// Makes room for so many edges, with so many nodes together.
  void reserve(std::size_t edges, std::size_t nodes) {
    coedges_.reserve(2 * edges);
    nodes_.reserve(2 * nodes);
  }

  /// Adds a LoopVertex at a node of the layer.
  Vertex_index add_vertex(Node_index node) {
    vertices_.push_back({node, Halfedge_index()});
    return Vertex_index(vertices_.size() - 1);
  }

  /// Adds a LoopEdge that runs through `nodes`, both end nodes included; returns its coedge from `source` to
  /// `target`. The coedges belong to no loop and have no neighbours yet.
  Halfedge_index add_edge(Vertex_index source, Vertex_index target, std::span<const Node_index> nodes) {
    const Halfedge_index forward(coedges_.size());
    coedges_.push_back({target, {}, {}, {}, add_nodes(nodes.begin(), nodes.end())});
    coedges_.push_back({source, {}, {}, {}, add_nodes(nodes.rbegin(), nodes.rend())});
    vertices_[target.value()].coedge = forward;
    vertices_[source.value()].coedge = opposite(forward);
    return forward;
  }

  /// Makes `second` follow `first` in their loop.
  void set_next(Halfedge_index first, Halfedge_index second) {
    coedges_[first.value()].next = second;
    coedges_[second.value()].prev = first;
  }

  /// Adds a LoopFace bounded by the loops that pass through the given coedges. The coedges' next links must be set,
  /// and the loops must belong to no LoopFace yet. Linear in the number of coedges.
  Loop_face_index add_loop_face(Loop_label label, Halfedge_index outer, const std::vector<Halfedge_index>& inner = {}) {
    const Loop_face_index face(loop_faces_.size());
    loop_faces_.push_back(
        {label, static_cast<std::uint32_t>(loops_.size()), static_cast<std::uint32_t>(1 + inner.size())});
    add_loop(outer, face);
    for (Halfedge_index coedge : inner) add_loop(coedge, face);
    return face;
  }

  std::size_t number_of_vertices() const { return vertices_.size(); }
  std::size_t number_of_halfedges() const { return coedges_.size(); }
  std::size_t number_of_edges() const { return coedges_.size() / 2; }
  std::size_t number_of_loops() const { return loops_.size(); }
  std::size_t number_of_loop_faces() const { return loop_faces_.size(); }

  static Halfedge_index opposite(Halfedge_index h) { return Halfedge_index(h.value() ^ 1); }
  Vertex_index target(Halfedge_index h) const { return coedges_[h.value()].target; }
  Vertex_index source(Halfedge_index h) const { return target(opposite(h)); }
  Halfedge_index next(Halfedge_index h) const { return coedges_[h.value()].next; }
  Halfedge_index prev(Halfedge_index h) const { return coedges_[h.value()].prev; }
  /// A coedge that ends at the vertex; invalid for a vertex without edges.
  Halfedge_index halfedge(Vertex_index v) const { return vertices_[v.value()].coedge; }
  /// The coedge by which the loop was added.
  Halfedge_index halfedge(Face_index loop) const { return loops_[loop.value()].coedge; }
  /// The LoopLoop left of the coedge; invalid on the outside.
  Face_index face(Halfedge_index h) const { return coedges_[h.value()].loop; }

  /// The node of a vertex.
  Node_index node(Vertex_index v) const { return vertices_[v.value()].node; }
  /// The nodes of the coedge in its own direction, both ends included.
  std::span<const Node_index> nodes(Halfedge_index h) const {
    const Range& range = coedges_[h.value()].nodes;
    return {nodes_.data() + range.first, range.size};
  }

  /// The LoopFace of a loop.
  Loop_face_index loop_face(Face_index loop) const { return loops_[loop.value()].loop_face; }
  /// The LoopFace left of a coedge; invalid on the outside.
  Loop_face_index loop_face(Halfedge_index h) const {
    const Face_index loop = face(h);
    return loop.is_valid() ? loop_face(loop) : Loop_face_index();
  }
  /// All loops of a LoopFace, the outer one first.
  std::span<const Face_index> loops(Loop_face_index f) const {
    const Loop_face& face = loop_faces_[f.value()];
    return {numbers_.data() + face.first_loop, face.number_of_loops};
  }
  Face_index outer_loop(Loop_face_index f) const { return loops(f).front(); }
  bool is_outer(Face_index loop) const { return outer_loop(loop_face(loop)) == loop; }
  /// The source and the target that the LoopFace is part of.
  Loop_label label(Loop_face_index f) const { return loop_faces_[f.value()].label; }
  /// The label left of a coedge; empty on the outside.
  Loop_label label(Halfedge_index h) const {
    const Loop_face_index f = loop_face(h);
    return f.is_valid() ? label(f) : Loop_label();
  }

  /// The nodes of a loop in order, each once per visit, beginning at the source of `halfedge(loop)`.
  std::vector<Node_index> nodes(Face_index loop) const {
    std::vector<Node_index> result;
    Halfedge_index h = halfedge(loop);
    do {
      const std::span<const Node_index> path = nodes(h);
      result.insert(result.end(), path.begin(), path.end() - 1);
      h = next(h);
    } while (h != halfedge(loop));
    return result;
  }

 private:
  struct Vertex {
    Node_index node;
    Halfedge_index coedge;
  };
  struct Range {
    std::uint32_t first, size;
  };
  struct Coedge {
    Vertex_index target;
    Halfedge_index next, prev;
    Face_index loop;
    Range nodes;
  };
  struct Loop {
    Halfedge_index coedge;
    Loop_face_index loop_face;
  };
  struct Loop_face {
    Loop_label label;
    std::uint32_t first_loop, number_of_loops;
  };

  template <class Iterator>
  Range add_nodes(Iterator first, Iterator last) {
    const std::size_t size = nodes_.size();
    nodes_.insert(nodes_.end(), first, last);
    return {static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(nodes_.size() - size)};
  }

  void add_loop(Halfedge_index start, Loop_face_index face) {
    const Face_index loop(loops_.size());
    loops_.push_back({start, face});
    numbers_.push_back(loop);
    Halfedge_index h = start;
    do {
      coedges_[h.value()].loop = loop;
      h = next(h);
    } while (h != start);
  }

  std::vector<Vertex> vertices_;
  std::vector<Coedge> coedges_;
  std::vector<Node_index> nodes_;  // of all coedges, one after the other
  std::vector<Loop> loops_;
  std::vector<Face_index> numbers_;  // of all loops; those of a LoopFace follow one another
  std::vector<Loop_face> loop_faces_;
};

/// What the stages ask of the topology of a layer beyond CGAL's `HalfedgeListGraph` and `FaceListGraph`: the second
/// level of LoopFaces, and the nodes along the coedges. `Loop_face_graph` is a model.
template <class Graph>
concept LoopFaceGraph = requires(const Graph& graph, typename Graph::Halfedge_index h, typename Graph::Vertex_index v,
                                 typename Graph::Face_index loop, Loop_face_index f) {
  { graph.node(v) } -> std::convertible_to<Node_index>;
  { graph.nodes(h) } -> std::convertible_to<std::span<const Node_index>>;
  { graph.loop_face(loop) } -> std::convertible_to<Loop_face_index>;
  { graph.outer_loop(f) } -> std::convertible_to<typename Graph::Face_index>;
  { graph.loops(f) } -> std::convertible_to<std::span<const typename Graph::Face_index>>;
  { graph.label(f) } -> std::convertible_to<Loop_label>;
  { graph.number_of_loop_faces() } -> std::convertible_to<std::size_t>;
};

}  // namespace CCSweep

template <>
struct std::hash<CCSweep::Loop_edge> {
  std::size_t operator()(CCSweep::Loop_edge edge) const noexcept { return edge.value(); }
};

#include <CCSweep/loops/overlay_graph_traits.h>
#include <CCSweep/loops/overlay_validity.h>

#endif
