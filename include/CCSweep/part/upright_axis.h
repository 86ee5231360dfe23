// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_UPRIGHT_AXIS_H
#define CCSWEEP_PART_UPRIGHT_AXIS_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/candidate_axes.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <optional>

namespace CCSweep::internal {

template <class Traits>
bool has_flat_caps(const Part<Traits>& part, const Roles& roles) {
  constexpr double flat = 1e-6;
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    if (roles.of_patch[p] == Role::linking) continue;
    for (auto f : part.facing(Patch_index(p)))
      if (norm(cross(part.normal[f], roles.direction)) > flat) return false;
  }
  return true;
}

/// The axis that all linking faces stand along, if there is one, in the sense of the sweep: where caps slant, their
/// normals are but near it.
template <class Traits>
std::optional<Vec3> upright_axis(const Part<Traits>& part, const Roles& roles) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double area = 0;
  for (auto f : part.mesh.faces()) {
    if (roles.of_patch[part.patch(f).value()] != Role::linking) continue;
    const Eigen::Vector3d n(part.normal[f].data());
    covariance += part.area[f] * n * n.transpose();
    area += part.area[f];
  }
  if (!(area > 0)) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / area);
  constexpr double upright = 1e-12;  // squared
  if (solver.eigenvalues()[0] > upright || solver.eigenvalues()[1] < 1e-3) return std::nullopt;
  const Eigen::Vector3d a = solver.eigenvectors().col(0);
  const Vec3 axis = without_dust({a[0], a[1], a[2]});
  return dot(axis, roles.direction) < 0 ? reversed(axis) : axis;
}

}  // namespace CCSweep::internal

#endif
