// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "decompose_runs.h"

#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>

#include <functional>

namespace decompose_runs {

Outcome decompose(const Mesh& mesh, const Request& request, Recorder& recorder) {
  const auto patch = mesh.property_map<Mesh::Face_index, int>("f:patch_id").first;
  return CCSweep::decompose(mesh, CCSweep::parameters::direction(request.direction)
                                      .sources(request.sources)
                                      .targets(request.targets)
                                      .layers(request.layers)
                                      .spanning_angle(request.spanning_angle)
                                      .visitor(std::ref(recorder))
                                      .face_patch_map(patch));
}

}  // namespace decompose_runs
