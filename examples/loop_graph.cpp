// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The LoopFaces of a layer are a graph of Boost: counts its barrels, the pieces of the layer that don't hang together.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/decompose.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <boost/graph/connected_components.hpp>
#include <boost/property_map/vector_property_map.hpp>

#include <functional>
#include <iostream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

//! [visitor]
struct Barrel_counter : CCSweep::Visitor_base {
  template <class LoopFaceGraph>
  void imprinted(std::size_t layer, const LoopFaceGraph& graph) {
    const auto index = get(boost::vertex_index, graph);
    const auto component = boost::make_vector_property_map<std::size_t>(index);
    std::cout << "layer " << layer << ": " << num_vertices(graph) << " LoopVertices, " << num_edges(graph)
              << " LoopEdges, " << graph.number_of_loop_faces() << " LoopFaces in "
              << boost::connected_components(graph, component) << " pieces\n";
  }
};
//! [visitor]

int tell(const CCSweep::Status& status) {
  std::cerr << name(status.code) << " in stage " << name(status.stage) << ": " << status.reason << '\n';
  return 1;
}

int main(int argc, char* argv[]) {
  const auto part = CCSweep::read_part<Point>(argc > 1 ? argv[1] : CCSWEEP_EXAMPLE_DATA "/parallel_barrels.ply");
  if (!part) return tell(part.status());

  Barrel_counter counter;
  const auto result = CCSweep::decompose(
      part.value().mesh,
      CCSweep::parameters::face_patch_map(part.value().patch_ids()).visitor(std::ref(counter)));
  return result ? 0 : tell(result.status());
}
