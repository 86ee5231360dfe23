// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Decomposes a part and tells what became of it.
//! [decompose]
#include <CCSweep/IO/read_part.h>
#include <CCSweep/decompose.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iostream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int tell(const CCSweep::Status& status) {
  std::cerr << name(status.code) << " in stage " << name(status.stage) << ": " << status.reason << '\n';
  return 1;
}

int main(int argc, char* argv[]) {
  const auto part = CCSweep::read_part<Point>(argc > 1 ? argv[1] : CCSWEEP_EXAMPLE_DATA "/cylinder.ply");
  if (!part) return tell(part.status());

  const auto patches = part.value().patch_ids();
  const auto result = CCSweep::decompose(part.value().mesh, CCSweep::parameters::face_patch_map(patches));
  if (!result) return tell(result.status());

  for (const auto& volume : result.value().volumes) {
    std::cout << "target " << volume.target << ", " << volume.sources.size() << " sources, "
              << num_faces(volume.mesh) << " triangles\n";
  }
}
//! [decompose]
