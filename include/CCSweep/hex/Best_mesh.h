// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_BEST_MESH_H
#define CCSWEEP_HEX_BEST_MESH_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/quality.h>
#include <CCSweep/internal/guarded.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The least scaled Jacobian in each sub-volume of a mesh.
inline std::vector<double> least_by_volume(const Hex_mesh& mesh) {
  std::vector<double> least(mesh.targets.size(), 1);
  const std::vector<double> quality = scaled_jacobians(mesh);
  for (std::size_t h = 0; h < quality.size(); ++h)
    least[mesh.volume[h]] = std::min(least[mesh.volume[h]], quality[h]);
  return least;
}

/// The least scaled Jacobian of a mesh.
inline double least_quality(const Hex_mesh& mesh) {
  const std::vector<double> quality = scaled_jacobians(mesh);
  return *std::min_element(quality.begin(), quality.end());
}

/// Keeps the mesh with the best worst hexahedron of those it is shown; if there is none, the first failure.
class Best_mesh {
 public:
  /// \param good what makes further meshes needless
  explicit Best_mesh(double good) : good_(good) {}

  /// \return whether it is so good that no other one is needed
  bool show(Result<Hex_mesh> result) {
    if (!result) {
      if (result.status().code == Status_code::cancelled) throw Failure{result.status()};
      if (!first_failure_) first_failure_ = result.status();
      return false;
    }
    if (const double quality = least_quality(result.value()); !mesh_ || quality > quality_) {
      quality_ = quality;
      mesh_ = std::move(result).value();
    }
    return quality_ >= good_;
  }

  /// The least scaled Jacobian of the mesh that is kept; 0 if there is none.
  double quality() const { return quality_; }

  Hex_mesh take() {
    if (!mesh_) throw Failure{*first_failure_};
    return std::move(*mesh_);
  }

 private:
  double good_;
  std::optional<Hex_mesh> mesh_;
  double quality_ = 0;
  std::optional<Status> first_failure_;
};

}  // namespace CCSweep::internal

#endif
