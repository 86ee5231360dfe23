// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_BUILD_H
#define CCSWEEP_LOOPS_OVERLAY_BUILD_H

#include <CCSweep/loops/Loop_face_graph.h>
#include <CCSweep/loops/overlay_planar_map.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Makes the LoopFace graph from the subdivision of a layer: edges are joined into LoopEdges through nodes where
// nothing ends, faces without a label become the outside.
template <class Traits>
class Graph_builder {
 public:
  Graph_builder(const Planar_map<Traits>& map, const Layer_nodes<Traits>& nodes, const std::vector<Loop_label>& labels)
      : map_(map), coedges_(map.number_of_halfedges()), vertices_(map.number_of_ends()), stops_(map.number_of_ends()) {
    for (std::uint32_t n = 0; n < map.number_of_ends(); ++n) {
      stops_[n] = map.degree(n) > 0 && (map.degree(n) != 2 || nodes.corner[map.node(n).value()]);
    }
    graph_.reserve(coedges_.size() / 2, map.number_of_path_nodes());
    add_edges();
    link();
    add_faces(labels);
  }

  Loop_face_graph<Traits>& graph() { return graph_; }

 private:
  void add_edges() {
    for (std::uint32_t h = 0; h < coedges_.size(); ++h) {
      if (!coedges_[h].is_valid() && stops(map_.source(h))) add_edge(h);
    }
    // What is left are closed curves without a vertex. They get one here, and the second by the rule below.
    for (std::uint32_t h = 0; h < coedges_.size(); ++h) {
      if (coedges_[h].is_valid()) continue;
      stops_[map_.source(h)] = true;
      add_edge(h);
    }
  }

  void add_edge(std::uint32_t start) {
    run_.assign(1, start);
    while (!stops(map_.target(run_.back()))) run_.push_back(map_.next(run_.back()));
    const std::span<const std::uint32_t> run(run_);
    if (map_.target(run.back()) != map_.source(start)) return add_edge(run);
    // A curve that returns to its only vertex gets another one, for a self-loop is no edge of a halfedge graph.
    const std::size_t half = run.size() / 2;
    stops_[map_.source(run[half])] = true;
    add_edge(run.first(half));
    add_edge(run.subspan(half));
  }

  void add_edge(std::span<const std::uint32_t> run) {
    const Loop_vertex_index source = vertex(map_.source(run.front())), target = vertex(map_.target(run.back()));
    const Loop_coedge_index coedge = graph_.add_edge(source, target, nodes(run));
    for (std::uint32_t h : run) {
      coedges_[h] = coedge;
      coedges_[h ^ 1] = graph_.opposite(coedge);
    }
  }

  std::span<const Node_index> nodes(std::span<const std::uint32_t> run) {
    if (run.size() == 1 && run.front() % 2 == 0) return map_.path(run.front() / 2);
    chain_.assign(1, map_.node(map_.source(run.front())));
    for (std::uint32_t h : run) {
      const std::span<const Node_index> path = map_.path(h / 2);
      if (h % 2 == 0) {
        chain_.insert(chain_.end(), path.begin() + 1, path.end());
      } else {
        chain_.insert(chain_.end(), path.rbegin() + 1, path.rend());
      }
    }
    return chain_;
  }

  void link() {
    for (std::uint32_t h = 0; h < coedges_.size(); ++h) {
      if (stops(map_.target(h))) graph_.set_next(coedges_[h], coedges_[map_.next(h)]);
    }
  }

  void add_faces(const std::vector<Loop_label>& labels) {
    std::vector<Loop_coedge_index> inner;
    for (std::uint32_t face = 1; face < map_.number_of_faces(); ++face) {
      if (labels[face].empty()) continue;
      Loop_coedge_index outer;
      inner.clear();
      map_.for_each_cycle(face, [&](std::uint32_t h) {
        if (outer.is_valid())
          inner.push_back(coedges_[h]);
        else
          outer = coedges_[h];
      });
      graph_.add_loop_face(labels[face], outer, inner);
    }
  }

  // Whether LoopEdges end where edges do.
  bool stops(std::uint32_t end) const { return stops_[end]; }

  Loop_vertex_index vertex(std::uint32_t end) {
    Loop_vertex_index& v = vertices_[end];
    if (!v.is_valid()) v = graph_.add_vertex(map_.node(end));
    return v;
  }

  const Planar_map<Traits>& map_;
  Loop_face_graph<Traits> graph_;
  std::vector<Loop_coedge_index> coedges_;
  std::vector<Loop_vertex_index> vertices_;  // per end
  std::vector<char> stops_;
  std::vector<std::uint32_t> run_;
  std::vector<Node_index> chain_;  // the nodes of a run, if of several edges
};

}  // namespace CCSweep::internal

#endif
