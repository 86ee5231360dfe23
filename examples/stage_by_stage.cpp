// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls the stages one by one, and looks at what each hands to the next.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/linking/make_layering.h>
#include <CCSweep/linking/make_wall_sections.h>
#include <CCSweep/loops/point_index.h>
#include <CCSweep/loops/segment_index.h>
#include <CCSweep/loops/sweep_layers.h>
#include <CCSweep/part/assign_roles.h>
#include <CCSweep/part/check_input.h>
#include <CCSweep/part/make_part.h>
#include <CCSweep/visitor.h>
#include <CCSweep/volumes/draw_cuts.h>
#include <CCSweep/volumes/make_cut_rows.h>
#include <CCSweep/volumes/make_sub_volumes.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

//! [visitor]
// Is told of every imprinted level while the layers are swept.
struct Onlooker : CCSweep::Visitor_base {
  template <class LoopFaceGraph>
  void imprinted(std::size_t layer, const LoopFaceGraph& graph) {
    std::cout << "  layer " << layer << " has " << graph.number_of_loop_faces() << " LoopFaces\n";
  }
};
//! [visitor]

//! [stages]
// Throws `CCSweep::Bad_result` at the first stage that fails.
void decompose(const char* file) {
  const auto input = CCSweep::read_part<Kernel::Point_3>(file).value();
  const auto valid = CCSweep::check_input(input.mesh, input.mesh.points(), input.patch_ids());
  if (!valid.ok()) throw CCSweep::Bad_result(valid);

  const auto part = CCSweep::make_part<Kernel>(input.mesh, input.mesh.points(), input.patch_ids()).value();
  std::cout << part.number_of_patches() << " patches\n";

  const auto candidates = CCSweep::assign_roles(part, {}).value();
  const CCSweep::Roles& roles = candidates.front();
  std::cout << "sweep along " << roles.direction[0] << ' ' << roles.direction[1] << ' ' << roles.direction[2] << '\n';

  const auto layering = CCSweep::make_layering(part, roles, {}).value();
  std::cout << layering.number_of_layers() << " layers, " << layering.caps.size() << " of them with caps\n";

  const auto sections = CCSweep::make_wall_sections(part, roles, layering).value();
  Onlooker onlooker;
  auto loops = CCSweep::sweep_layers<Kernel, CCSweep::Rtree_segment_index_2<Kernel>, CCSweep::Rtree_point_index_3>(
                   part, roles, layering, sections, 1e-5 * part.diagonal, 10, onlooker)
                   .value();

  const auto rows = CCSweep::make_cut_rows(part, layering, loops).value();
  const auto surface = CCSweep::draw_cuts(part, roles, loops, rows).value();
  std::cout << "the surface, cut along " << rows.size() << " rows of the cuts, has " << surface.triangles.size()
            << " triangles\n";

  const auto result = CCSweep::make_sub_volumes(part, roles, layering, loops, rows, surface).value();
  std::cout << result.volumes.size() << " sub-volumes, parted by " << result.sets.size() << " decomposition sets\n";
}
//! [stages]

int main(int argc, char* argv[]) {
  try {
    decompose(argc > 1 ? argv[1] : CCSWEEP_EXAMPLE_DATA "/parallel_barrels.ply");
  } catch (const CCSweep::Bad_result& failure) {
    const CCSweep::Status& status = failure.status();
    std::cerr << name(status.code) << " in stage " << name(status.stage) << ": " << status.reason << '\n';
    return 1;
  }
}
