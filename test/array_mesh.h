// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_ARRAY_MESH_H
#define CCSWEEP_TEST_ARRAY_MESH_H

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// A mesh as a user may have it who knows nothing of CGAL: a halfedge structure in plain arrays. What the library asks
// of it are the free functions below, found by argument-dependent lookup.
namespace array_mesh {

/// Numbers that are told apart by what they name.
template <int kind>
struct Handle {
  int value = -1;
  friend auto operator<=>(const Handle&, const Handle&) = default;
  Handle& operator++() { return ++value, *this; }
  Handle& operator--() { return --value, *this; }
  friend std::size_t hash_value(const Handle& h) { return static_cast<std::size_t>(h.value); }
};
using Vertex = Handle<0>;
using Halfedge = Handle<1>;
using Edge = Handle<2>;
using Face = Handle<3>;

/// Halfedges 2 e and 2 e + 1 make up edge e.
struct Array_mesh {
  struct Halfedge_record {
    Vertex target;
    Halfedge next, prev;
    Face face;
  };
  std::vector<Halfedge_record> halfedges;
  std::vector<Halfedge> of_vertex;  ///< one that points to it
  std::vector<Halfedge> of_face;

  /// A closed mesh of polygons over vertices 0 to n - 1.
  Array_mesh(std::size_t n, const std::vector<std::vector<std::size_t>>& polygons) : of_vertex(n) {
    std::map<std::pair<std::size_t, std::size_t>, Halfedge> known;
    for (const auto& polygon : polygons) {
      const Face f{static_cast<int>(of_face.size())};
      std::vector<Halfedge> around;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        Halfedge h{static_cast<int>(halfedges.size())};
        if (const auto other = known.find({b, a}); other != known.end()) {
          h = {other->second.value ^ 1};
        } else {
          halfedges.resize(halfedges.size() + 2);
          halfedges[h.value ^ 1].target = {static_cast<int>(a)};
        }
        known[{a, b}] = h;
        halfedges[h.value].target = {static_cast<int>(b)};
        halfedges[h.value].face = f;
        of_vertex[b] = h;
        around.push_back(h);
      }
      for (std::size_t i = 0; i < around.size(); ++i) {
        const Halfedge h = around[i], k = around[(i + 1) % around.size()];
        halfedges[h.value].next = k;
        halfedges[k.value].prev = h;
      }
      of_face.push_back(around.back());
    }
  }
};

template <class H>
using Handle_iterator = boost::counting_iterator<H, std::bidirectional_iterator_tag, std::ptrdiff_t>;
/// A pair of iterators, as Boost wants it, and a range, as CGAL wants it.
template <class H>
struct Handle_range : std::pair<Handle_iterator<H>, Handle_iterator<H>> {
  explicit Handle_range(std::size_t n)
      : std::pair<Handle_iterator<H>, Handle_iterator<H>>(H{0}, H{static_cast<int>(n)}) {}
  Handle_iterator<H> begin() const { return this->first; }
  Handle_iterator<H> end() const { return this->second; }
};

inline std::size_t num_vertices(const Array_mesh& m) { return m.of_vertex.size(); }
inline std::size_t num_halfedges(const Array_mesh& m) { return m.halfedges.size(); }
inline std::size_t num_edges(const Array_mesh& m) { return m.halfedges.size() / 2; }
inline std::size_t num_faces(const Array_mesh& m) { return m.of_face.size(); }
inline Handle_range<Vertex> vertices(const Array_mesh& m) { return Handle_range<Vertex>(num_vertices(m)); }
inline Handle_range<Halfedge> halfedges(const Array_mesh& m) { return Handle_range<Halfedge>(num_halfedges(m)); }
inline Handle_range<Edge> edges(const Array_mesh& m) { return Handle_range<Edge>(num_edges(m)); }
inline Handle_range<Face> faces(const Array_mesh& m) { return Handle_range<Face>(num_faces(m)); }

inline Halfedge next(Halfedge h, const Array_mesh& m) { return m.halfedges[h.value].next; }
inline Halfedge prev(Halfedge h, const Array_mesh& m) { return m.halfedges[h.value].prev; }
inline Halfedge opposite(Halfedge h, const Array_mesh&) { return {h.value ^ 1}; }
inline Vertex target(Halfedge h, const Array_mesh& m) { return m.halfedges[h.value].target; }
inline Vertex source(Halfedge h, const Array_mesh& m) { return target(opposite(h, m), m); }
inline Face face(Halfedge h, const Array_mesh& m) { return m.halfedges[h.value].face; }
inline Edge edge(Halfedge h, const Array_mesh&) { return {h.value / 2}; }
inline Halfedge halfedge(Vertex v, const Array_mesh& m) { return m.of_vertex[v.value]; }
inline Halfedge halfedge(Edge e, const Array_mesh&) { return {2 * e.value}; }
inline Halfedge halfedge(Face f, const Array_mesh& m) { return m.of_face[f.value]; }
inline Vertex source(Edge e, const Array_mesh& m) { return source(halfedge(e, m), m); }
inline Vertex target(Edge e, const Array_mesh& m) { return target(halfedge(e, m), m); }
inline std::pair<Halfedge, bool> halfedge(Vertex v, Vertex w, const Array_mesh& m) {
  const Halfedge start = halfedge(w, m);
  Halfedge h = start;
  do {
    if (source(h, m) == v) return {h, true};
    h = opposite(next(h, m), m);
  } while (h != start);
  return {{}, false};
}

/// What the handles of a mesh stand for, kept apart from it.
template <class Key, class Value>
struct Table_map {
  using key_type = Key;
  using value_type = Value;
  using reference = const Value&;
  using category = boost::readable_property_map_tag;
  const std::vector<Value>* values;
  friend const Value& get(const Table_map& map, Key key) { return (*map.values)[key.value]; }
};

}  // namespace array_mesh

template <>
struct boost::graph_traits<array_mesh::Array_mesh> {
  using vertex_descriptor = array_mesh::Vertex;
  using halfedge_descriptor = array_mesh::Halfedge;
  using edge_descriptor = array_mesh::Edge;
  using face_descriptor = array_mesh::Face;
  using vertex_iterator = array_mesh::Handle_iterator<vertex_descriptor>;
  using halfedge_iterator = array_mesh::Handle_iterator<halfedge_descriptor>;
  using edge_iterator = array_mesh::Handle_iterator<edge_descriptor>;
  using face_iterator = array_mesh::Handle_iterator<face_descriptor>;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::disallow_parallel_edge_tag;
  struct traversal_category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag {};
  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

// CGAL names this type for every mesh, also where a vertex point map is given and this one is not used.
template <>
struct boost::property_map<array_mesh::Array_mesh, boost::vertex_point_t> {
  using type = void;
  using const_type = void;
};

template <int kind>
struct std::hash<array_mesh::Handle<kind>> {
  std::size_t operator()(const array_mesh::Handle<kind>& h) const noexcept { return hash_value(h); }
};

#endif
