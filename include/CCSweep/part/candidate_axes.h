// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_CANDIDATE_AXES_H
#define CCSWEEP_PART_CANDIDATE_AXES_H

#include <CCSweep/part/Part.h>

#include <Eigen/Eigenvalues>

#include <vector>

namespace CCSweep {
namespace internal {

// The direction that the normals of a bent patch avoid: the axis of a cylinder (or of any extruded patch).
template <class Traits>
bool fit_axis(const Part<Traits>& part, Patch_index patch, Vec3& axis) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double area = 0;
  for (auto f : part.faces[patch.value()]) {
    const Eigen::Vector3d n(part.normal[f].data());
    covariance += part.area[f] * n * n.transpose();
    area += part.area[f];
  }
  if (!(area > 0)) return false;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance / area);
  // Facets of a cylinder lean by a chord error at most; cones and spheres lie far above this.
  if (solver.eigenvalues()[0] > 1e-4 || solver.eigenvalues()[1] < 1e-3) return false;
  const Eigen::Vector3d a = solver.eigenvectors().col(0);
  axis = {a[0], a[1], a[2]};
  return true;
}

// Rounding in the input must not lean an axis-parallel sweep.
inline Vec3 without_dust(Vec3 axis) {
  for (double& x : axis)
    if (std::abs(x) < 1e-9) x = 0;
  return unit(axis);
}

}  // namespace internal

/// The directions a part may be swept along: the normals of its planar patches and the axes of its cylindrical ones,
/// each once and in both senses, ordered by the lowest patch index they come from. Complexity: linear, times the
/// number of distinct directions.
template <class Traits>
std::vector<std::array<double, 3>> candidate_axes(const Part<Traits>& part) {
  using namespace internal;
  constexpr double same = 1e-4;  // radians
  std::vector<Vec3> axes;
  auto add = [&](Vec3 axis) {
    axis = without_dust(axis);
    for (const Vec3& known : axes)
      if (norm(cross(known, axis)) < same) return;
    axes.push_back(axis);
  };
  for (std::size_t p = 0; p < part.number_of_patches(); ++p)
    if (part.planar[p]) add(part.normal[part.largest_face[p]]);
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    Vec3 axis;
    if (!part.planar[p] && fit_axis(part, Patch_index(p), axis)) add(axis);
  }
  std::vector<Vec3> both;
  for (const Vec3& axis : axes) {
    both.push_back(axis);
    both.push_back(reversed(axis));
  }
  return both;
}

}  // namespace CCSweep

#endif
