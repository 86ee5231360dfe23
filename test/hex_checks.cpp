// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "hex_checks.h"

#include <CCSweep/hex_mesh.h>
#include <CCSweep/parameters.h>

namespace hex_checks {

CCSweep::Result<Hex_mesh> mesh(const Part_mesh& part, const std::array<double, 3>& direction, double size) {
  const auto patch = part.property_map<Part_mesh::Face_index, int>("f:patch_id").first;
  return CCSweep::hex_mesh(part, CCSweep::parameters::direction(direction).size(size).face_patch_map(patch));
}

CCSweep::Result<Hex_mesh> mesh(const CCSweep::Sub_volume<Part_mesh::Point>& volume, double size) {
  return CCSweep::hex_mesh(volume, CCSweep::parameters::size(size));
}

}  // namespace hex_checks
