// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_VALIDITY_H
#define CCSWEEP_LOOPS_OVERLAY_VALIDITY_H

#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_graph_traits.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace CCSweep {
namespace internal {

// The number of cycles of next links around the null face, and of connected components.
template <class Graph>
std::size_t number_of_border_cycles(const Graph& g) {
  std::vector<bool> seen(num_halfedges(g), false);
  std::size_t result = 0;
  for (Loop_coedge_index start : halfedges(g)) {
    if (seen[start.value()] || g.face(start).is_valid()) continue;
    ++result;
    for (Loop_coedge_index h = start; !seen[h.value()]; h = g.next(h)) seen[h.value()] = true;
  }
  return result;
}

template <class Graph>
std::size_t number_of_components(const Graph& g) {
  std::vector<bool> seen(num_vertices(g), false);
  std::vector<Loop_vertex_index> stack;
  std::size_t result = 0;
  for (Loop_vertex_index start : vertices(g)) {
    if (seen[start.value()]) continue;
    ++result;
    seen[start.value()] = true;
    stack.push_back(start);
    while (!stack.empty()) {
      const Loop_vertex_index v = stack.back();
      stack.pop_back();
      for (Loop_coedge_index h : halfedges_at_target(v, g)) {
        const Loop_vertex_index w = g.source(h);
        if (!seen[w.value()]) stack.push_back(w);
        seen[w.value()] = true;
      }
    }
  }
  return result;
}

template <class Graph>
bool are_edges_valid(const Graph& g) {
  return std::all_of(halfedges(g).begin(), halfedges(g).end(), [&](Loop_coedge_index h) {
    const std::span<const Node_index> nodes = g.nodes(h), back = g.nodes(g.opposite(h));
    return nodes.size() >= 2 && g.source(h) != g.target(h) && nodes.front() == g.node(g.source(h)) &&
           nodes.back() == g.node(g.target(h)) && std::equal(nodes.begin(), nodes.end(), back.rbegin(), back.rend()) &&
           g.label(h) != g.label(g.opposite(h));
  });
}

template <class Graph>
bool are_loop_faces_valid(const Graph& g) {
  std::vector<int> owners(num_faces(g), 0);
  for (std::size_t i = 0; i < g.number_of_loop_faces(); ++i) {
    const Loop_face_index f(i);
    if (g.loops(f).empty() || g.label(f).empty()) return false;
    for (Loop_index loop : g.loops(f)) {
      if (loop.value() >= owners.size() || g.loop_face(loop) != f) return false;
      ++owners[loop.value()];
    }
  }
  return std::all_of(owners.begin(), owners.end(), [](int count) { return count == 1; });
}

// A loop turns left wherever it visits its lowest node exactly if it is an outer one.
template <class Traits>
bool turns_left(const std::vector<Node_index>& loop, const std::vector<typename Traits::Point_2>& points) {
  const auto point = [&](std::size_t i) -> const auto& { return points[loop[i % loop.size()].value()]; };
  const Node_index lowest = *std::min_element(loop.begin(), loop.end(), [&](Node_index n, Node_index m) {
    return is_less_xy<Traits>(points[n.value()], points[m.value()]);
  });
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i] != lowest) continue;
    if (turn<Traits>(point(i + loop.size() - 1), point(i), point(i + 1)) != CGAL::LEFT_TURN) return false;
  }
  return true;
}

// Whether p is inside the loop, or on it.
template <class Traits>
bool encloses(const std::vector<Node_index>& loop, const std::vector<typename Traits::Point_2>& points,
              const typename Traits::Point_2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto &a = points[loop[i].value()], &b = points[loop[(i + 1) % loop.size()].value()];
    const bool a_below = CGAL::compare(a.y(), p.y()) != CGAL::LARGER;
    const bool b_below = CGAL::compare(b.y(), p.y()) != CGAL::LARGER;
    const CGAL::Orientation side = turn<Traits>(a, b, p);
    if (is_equal<Traits>(p, a) || is_inside<Traits>(a, b, p)) return true;
    if (a_below != b_below && side == (a_below ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN)) inside = !inside;
  }
  return inside;
}

}  // namespace internal

/// Checks the graph: CGAL's halfedge and face graph validity; the nodes of every LoopEdge fit its vertices and both of
/// its coedges; labels differ across every LoopEdge; every loop belongs to one LoopFace with a label; and Euler's
/// formula V - E + (L + B) = 2 C for L loops, B border cycles and C components. Linear but for the degrees.
template <class Traits>
bool is_valid(const Loop_face_graph<Traits>& graph) {
  if (!CGAL::is_valid_halfedge_graph(graph) || !CGAL::is_valid_face_graph(graph)) return false;
  if (!internal::are_edges_valid(graph) || !internal::are_loop_faces_valid(graph)) return false;
  const std::size_t cycles = num_faces(graph) + internal::number_of_border_cycles(graph);
  return num_vertices(graph) + cycles == num_edges(graph) + 2 * internal::number_of_components(graph);
}

/// Checks the graph as above, and against the points of its nodes, by exact predicates: outer loops run
/// counterclockwise, inner ones clockwise and inside their outer one. Takes O(n) for each inner loop.
template <class Traits>
bool is_valid(const Loop_face_graph<Traits>& graph, const std::vector<typename Traits::Point_2>& points) {
  if (!is_valid(graph)) return false;
  for (std::size_t i = 0; i < graph.number_of_loop_faces(); ++i) {
    const Loop_face_index f(i);
    const std::vector<Node_index> outer = graph.nodes(graph.outer_loop(f));
    for (Loop_index loop : graph.loops(f)) {
      const std::vector<Node_index> nodes = graph.nodes(loop);
      if (internal::turns_left<Traits>(nodes, points) != graph.is_outer(loop)) return false;
      if (!internal::encloses<Traits>(outer, points, points[nodes.front().value()])) return false;
    }
  }
  return true;
}

}  // namespace CCSweep

#endif
