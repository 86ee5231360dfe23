// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Decomposes a part in rational numbers, where nothing is rounded: the volumes of the sub-volumes add up to the
// volume of the part exactly.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/decompose.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

//! [kernel]
using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
//! [kernel]

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::FT volume_of(const Mesh& mesh) {
  Kernel::FT sum = 0;
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += CGAL::volume(Kernel::Point_3(CGAL::ORIGIN), mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
  }
  return sum;
}

int tell(const CCSweep::Status& status) {
  std::cerr << name(status.code) << " in stage " << name(status.stage) << ": " << status.reason << '\n';
  return 1;
}

int main(int argc, char* argv[]) {
  const auto part = CCSweep::read_part<Kernel::Point_3>(argc > 1 ? argv[1] : CCSWEEP_EXAMPLE_DATA "/cylinder.ply");
  if (!part) return tell(part.status());
  const auto& mesh = part.value().mesh;
  const auto result = CCSweep::decompose(
      mesh, CCSweep::parameters::face_patch_map(part.value().patch_ids()).geom_traits(Kernel()));
  if (!result) return tell(result.status());

  Kernel::FT rest = volume_of(mesh);
  for (const auto& volume : result.value().volumes) {
    const Kernel::FT size = volume_of(volume.mesh);
    std::cout << "target " << volume.target << ": " << CGAL::to_double(size) << '\n';
    rest -= size;
  }
  std::cout << "left over: " << rest << '\n';
  return rest == 0 ? 0 : 1;
}
