// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CCSweep/loops/Loop_face_graph.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/graph_concepts.h>

#include <boost/concept/assert.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/graph_concepts.hpp>
#include <boost/test/unit_test.hpp>
#include <unordered_set>
#include <vector>

#include "loops_drawings.h"

namespace {

using namespace CCSweep;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Graph = Loop_face_graph<Kernel>;

BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::BidirectionalGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::VertexListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::EdgeListGraphConcept<Graph>));
BOOST_CONCEPT_ASSERT((boost::AdjacencyGraphConcept<Graph>));
static_assert(LoopFaceGraph<Graph>);

// A closed curve through n nodes from `first` on, in two LoopEdges; returns a coedge in the nodes' order.
Loop_coedge_index add_circle(Graph& graph, std::size_t first, std::size_t n) {
  std::vector<Node_index> half, rest;
  for (std::size_t i = 0; i <= n / 2; ++i) half.emplace_back(first + i);
  for (std::size_t i = n / 2; i <= n; ++i) rest.emplace_back(first + i % n);
  const Loop_vertex_index u = graph.add_vertex(half.front()), v = graph.add_vertex(rest.front());
  const Loop_coedge_index g = graph.add_edge(u, v, half), h = graph.add_edge(v, u, rest);
  graph.set_next(g, h);
  graph.set_next(h, g);
  graph.set_next(graph.opposite(g), graph.opposite(h));
  graph.set_next(graph.opposite(h), graph.opposite(g));
  return g;
}

std::vector<Kernel::Point_2> points(const std::vector<loops_test::Loop>& loops) {
  std::vector<Kernel::Point_2> result;
  for (const auto& loop : loops) {
    for (const auto& p : loop) result.emplace_back(p[0], p[1]);
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loops_graph)

BOOST_AUTO_TEST_CASE(annulus) {
  Graph graph;
  const Loop_coedge_index outer = add_circle(graph, 0, 8), inner = add_circle(graph, 8, 8);
  const Loop_face_index ring = graph.add_loop_face({1, 2}, outer, {graph.opposite(inner)});
  BOOST_TEST(is_valid(graph));
  BOOST_TEST(is_valid(graph, points({loops_test::regular(8, 2), loops_test::regular(8, 1)})));
  BOOST_TEST(!is_valid(graph, points({loops_test::regular(8, 1), loops_test::regular(8, 2)})));
  BOOST_TEST(!is_valid(graph, points({loops_test::regular(8, 2), loops_test::reversed(loops_test::regular(8, 1))})));
  BOOST_TEST(!is_valid(graph, points({loops_test::regular(8, 2), loops_test::regular(8, 1, 0, 5)})));
  BOOST_TEST(graph.loops(ring).size() == 2u);
  BOOST_TEST(graph.is_outer(graph.outer_loop(ring)));
  BOOST_TEST(graph.loop_face(inner).is_valid() == false);
  BOOST_TEST(graph.nodes(graph.outer_loop(ring)).size() == 8u);
  std::vector<std::size_t> component(num_vertices(graph));
  const auto map = boost::make_iterator_property_map(component.begin(), get(boost::vertex_index, graph));
  BOOST_TEST(boost::connected_components(graph, map) == 2);
  BOOST_TEST(component[0] != component[2]);
}

BOOST_AUTO_TEST_CASE(edges_are_pairs_of_coedges) {
  Graph graph;
  const Loop_coedge_index h = add_circle(graph, 0, 6);
  const Loop_edge e = edge(h, graph), f = edge(graph.opposite(h), graph);
  BOOST_TEST((e == f));
  BOOST_TEST((halfedge(e, graph) == h));
  BOOST_TEST((halfedge(f, graph) == graph.opposite(h)));
  BOOST_TEST((std::unordered_set<Loop_edge>{e, f}.size() == 1));
  BOOST_TEST((source(e, graph) == target(f, graph)));
  BOOST_TEST(num_edges(graph) == 2u);
  BOOST_TEST(degree(source(e, graph), graph) == 2u);
  BOOST_TEST(halfedge(source(e, graph), target(e, graph), graph).second);
  const std::vector<Node_index> back(graph.nodes(h).rbegin(), graph.nodes(h).rend());
  BOOST_TEST(std::ranges::equal(graph.nodes(graph.opposite(h)), back));
  std::size_t out = 0;
  for (Loop_edge o : CGAL::make_range(out_edges(source(e, graph), graph))) {
    BOOST_TEST((source(o, graph) == source(e, graph)));
    ++out;
  }
  BOOST_TEST(out == 2u);
}

BOOST_AUTO_TEST_CASE(faults_are_found) {
  {
    Graph graph;
    add_circle(graph, 0, 6);
    BOOST_TEST(!is_valid(graph));  // the same label on both sides: none
  }
  {
    Graph graph;
    graph.add_loop_face({}, add_circle(graph, 0, 6));
    BOOST_TEST(!is_valid(graph));  // no label
  }
  {
    Graph graph;
    const Loop_coedge_index h = add_circle(graph, 0, 6);
    graph.add_loop_face({1, 1}, h);
    graph.set_next(h, h);
    BOOST_TEST(!is_valid(graph));  // broken links
  }
  {
    Graph graph;
    const Loop_vertex_index v = graph.add_vertex(Node_index(0));
    const std::vector<Node_index> nodes{Node_index(0), Node_index(1), Node_index(2), Node_index(0)};
    const Loop_coedge_index h = graph.add_edge(v, v, nodes);
    graph.set_next(h, h);
    graph.set_next(graph.opposite(h), graph.opposite(h));
    graph.add_loop_face({1, 1}, h);
    BOOST_TEST(!is_valid(graph));  // a self-loop
  }
}

BOOST_AUTO_TEST_SUITE_END()
