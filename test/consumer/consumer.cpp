// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/IO/read_part.h>
#include <CCSweep/decompose.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <iostream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int main(int, char* argv[]) {
  auto part = CCSweep::read_part<Point>(argv[1]);
  auto mesh = part.value().mesh;
  auto patches = mesh.property_map<CGAL::Surface_mesh<Point>::Face_index, int>("f:patch_id").first;
  auto result = CCSweep::decompose(mesh, CCSweep::parameters::face_patch_map(patches));
  std::cout << result.value().volumes.size() << '\n';
}
