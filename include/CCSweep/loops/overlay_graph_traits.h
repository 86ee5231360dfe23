// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_GRAPH_TRAITS_H
#define CCSWEEP_LOOPS_OVERLAY_GRAPH_TRAITS_H

#include <CCSweep/loops/Loop_face_graph.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>
#include <cstddef>
#include <utility>

namespace CCSweep::internal {

// Runs over the descriptors 0, 1, 2, ... of a graph.
template <class Descriptor>
class Descriptor_iterator : public boost::iterator_facade<Descriptor_iterator<Descriptor>, Descriptor,
                                                          boost::random_access_traversal_tag, Descriptor> {
 public:
  Descriptor_iterator() = default;
  explicit Descriptor_iterator(std::size_t number) : number_(number) {}

 private:
  friend class boost::iterator_core_access;

  Descriptor dereference() const {
    if constexpr (std::is_same_v<Descriptor, Loop_edge>) {
      return Loop_edge(Loop_coedge_index(2 * number_));
    } else {
      return Descriptor(number_);
    }
  }
  bool equal(const Descriptor_iterator& other) const { return number_ == other.number_; }
  void increment() { ++number_; }
  void decrement() { --number_; }
  void advance(std::ptrdiff_t n) { number_ += n; }
  std::ptrdiff_t distance_to(const Descriptor_iterator& other) const {
    return static_cast<std::ptrdiff_t>(other.number_) - static_cast<std::ptrdiff_t>(number_);
  }

  std::size_t number_ = 0;
};

template <class Descriptor>
CGAL::Iterator_range<Descriptor_iterator<Descriptor>> descriptors(std::size_t size) {
  return CGAL::make_range(Descriptor_iterator<Descriptor>(0), Descriptor_iterator<Descriptor>(size));
}

// The number of a descriptor, as a property map.
template <class Descriptor>
struct Descriptor_number {
  using key_type = Descriptor;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  friend std::size_t get(const Descriptor_number&, const Descriptor& d) { return d.value(); }
  std::size_t operator[](const Descriptor& d) const { return d.value(); }
};

}  // namespace CCSweep::internal

template <class Traits>
struct boost::graph_traits<CCSweep::Loop_face_graph<Traits>> {
 private:
  using Graph = CCSweep::Loop_face_graph<Traits>;
  struct Category : boost::bidirectional_graph_tag,
                    boost::vertex_list_graph_tag,
                    boost::edge_list_graph_tag,
                    boost::adjacency_graph_tag {};

 public:
  using vertex_descriptor = CCSweep::Loop_vertex_index;
  using edge_descriptor = CCSweep::Loop_edge;
  using halfedge_descriptor = CCSweep::Loop_coedge_index;
  using face_descriptor = CCSweep::Loop_index;

  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using traversal_category = Category;

  using vertex_iterator = CCSweep::internal::Descriptor_iterator<vertex_descriptor>;
  using edge_iterator = CCSweep::internal::Descriptor_iterator<edge_descriptor>;
  using halfedge_iterator = CCSweep::internal::Descriptor_iterator<halfedge_descriptor>;
  using face_iterator = CCSweep::internal::Descriptor_iterator<face_descriptor>;
  using out_edge_iterator = CGAL::Out_edge_iterator<Graph>;
  using in_edge_iterator = CGAL::In_edge_iterator<Graph>;
  using adjacency_iterator = CGAL::Vertex_around_target_iterator<Graph>;

  using vertices_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <class Traits>
struct boost::graph_traits<const CCSweep::Loop_face_graph<Traits>>
    : boost::graph_traits<CCSweep::Loop_face_graph<Traits>> {};

template <class Traits>
struct boost::property_map<CCSweep::Loop_face_graph<Traits>, boost::vertex_index_t> {
  using type = CCSweep::internal::Descriptor_number<CCSweep::Loop_vertex_index>;
  using const_type = type;
};
template <class Traits>
struct boost::property_map<CCSweep::Loop_face_graph<Traits>, boost::edge_index_t> {
  using type = CCSweep::internal::Descriptor_number<CCSweep::Loop_edge>;
  using const_type = type;
};
template <class Traits>
struct boost::property_map<CCSweep::Loop_face_graph<Traits>, boost::halfedge_index_t> {
  using type = CCSweep::internal::Descriptor_number<CCSweep::Loop_coedge_index>;
  using const_type = type;
};
template <class Traits>
struct boost::property_map<CCSweep::Loop_face_graph<Traits>, boost::face_index_t> {
  using type = CCSweep::internal::Descriptor_number<CCSweep::Loop_index>;
  using const_type = type;
};

// The free functions of the graph concepts; what they mean stands in the manuals of Boost.Graph and of CGAL.
namespace CCSweep {

template <class T>
auto num_vertices(const Loop_face_graph<T>& g) {
  return g.number_of_vertices();
}
template <class T>
auto num_edges(const Loop_face_graph<T>& g) {
  return g.number_of_edges();
}
template <class T>
auto num_halfedges(const Loop_face_graph<T>& g) {
  return g.number_of_halfedges();
}
template <class T>
auto num_faces(const Loop_face_graph<T>& g) {
  return g.number_of_loops();
}

template <class T>
auto vertices(const Loop_face_graph<T>& g) {
  return internal::descriptors<Loop_vertex_index>(num_vertices(g));
}
template <class T>
auto edges(const Loop_face_graph<T>& g) {
  return internal::descriptors<Loop_edge>(num_edges(g));
}
template <class T>
auto halfedges(const Loop_face_graph<T>& g) {
  return internal::descriptors<Loop_coedge_index>(num_halfedges(g));
}
template <class T>
auto faces(const Loop_face_graph<T>& g) {
  return internal::descriptors<Loop_index>(num_faces(g));
}

template <class T>
Loop_vertex_index source(Loop_coedge_index h, const Loop_face_graph<T>& g) {
  return g.source(h);
}
template <class T>
Loop_vertex_index target(Loop_coedge_index h, const Loop_face_graph<T>& g) {
  return g.target(h);
}
template <class T>
Loop_vertex_index source(Loop_edge e, const Loop_face_graph<T>& g) {
  return g.source(e.coedge());
}
template <class T>
Loop_vertex_index target(Loop_edge e, const Loop_face_graph<T>& g) {
  return g.target(e.coedge());
}

template <class T>
Loop_coedge_index next(Loop_coedge_index h, const Loop_face_graph<T>& g) {
  return g.next(h);
}
template <class T>
Loop_coedge_index prev(Loop_coedge_index h, const Loop_face_graph<T>& g) {
  return g.prev(h);
}
template <class T>
Loop_coedge_index opposite(Loop_coedge_index h, const Loop_face_graph<T>&) {
  return Loop_face_graph<T>::opposite(h);
}
template <class T>
Loop_edge edge(Loop_coedge_index h, const Loop_face_graph<T>&) {
  return Loop_edge(h);
}
template <class T>
Loop_index face(Loop_coedge_index h, const Loop_face_graph<T>& g) {
  return g.face(h);
}
template <class T>
Loop_coedge_index halfedge(Loop_edge e, const Loop_face_graph<T>&) {
  return e.coedge();
}
template <class T>
Loop_coedge_index halfedge(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  return g.halfedge(v);
}
template <class T>
Loop_coedge_index halfedge(Loop_index loop, const Loop_face_graph<T>& g) {
  return g.halfedge(loop);
}

template <class T>
auto halfedges_at_target(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  return CGAL::halfedges_around_target(g.halfedge(v), g);
}

/// One of the coedges from `u` to `v`, if there is any. Linear in the degree of `v`.
template <class T>
std::pair<Loop_coedge_index, bool> halfedge(Loop_vertex_index u, Loop_vertex_index v, const Loop_face_graph<T>& g) {
  for (Loop_coedge_index h : halfedges_at_target(v, g)) {
    if (g.source(h) == u) return {h, true};
  }
  return {Loop_coedge_index(), false};
}
template <class T>
std::pair<Loop_edge, bool> edge(Loop_vertex_index u, Loop_vertex_index v, const Loop_face_graph<T>& g) {
  const auto [h, found] = halfedge(u, v, g);
  return {Loop_edge(h), found};
}

template <class T>
std::size_t degree(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  const auto around = halfedges_at_target(v, g);
  return static_cast<std::size_t>(std::distance(around.begin(), around.end()));
}
template <class T>
std::size_t in_degree(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  return degree(v, g);
}
template <class T>
std::size_t out_degree(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  return degree(v, g);
}
template <class T>
std::size_t degree(Loop_index loop, const Loop_face_graph<T>& g) {
  const auto around = CGAL::halfedges_around_face(g.halfedge(loop), g);
  return static_cast<std::size_t>(std::distance(around.begin(), around.end()));
}

template <class T>
auto in_edges(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  using Iterator = CGAL::In_edge_iterator<Loop_face_graph<T>>;
  return CGAL::make_range(Iterator(g.halfedge(v), g), Iterator(g.halfedge(v), g, 1));
}
template <class T>
auto out_edges(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  using Iterator = CGAL::Out_edge_iterator<Loop_face_graph<T>>;
  return CGAL::make_range(Iterator(g.halfedge(v), g), Iterator(g.halfedge(v), g, 1));
}
template <class T>
auto adjacent_vertices(Loop_vertex_index v, const Loop_face_graph<T>& g) {
  return CGAL::vertices_around_target(g.halfedge(v), g);
}

template <class T>
internal::Descriptor_number<Loop_vertex_index> get(boost::vertex_index_t, const Loop_face_graph<T>&) {
  return {};
}
template <class T>
internal::Descriptor_number<Loop_edge> get(boost::edge_index_t, const Loop_face_graph<T>&) {
  return {};
}
template <class T>
internal::Descriptor_number<Loop_coedge_index> get(boost::halfedge_index_t, const Loop_face_graph<T>&) {
  return {};
}
template <class T>
internal::Descriptor_number<Loop_index> get(boost::face_index_t, const Loop_face_graph<T>&) {
  return {};
}

template <class Tag, class T, class Descriptor>
std::size_t get(Tag tag, const Loop_face_graph<T>& g, Descriptor d) {
  return get(get(tag, g), d);
}

}  // namespace CCSweep

#endif
