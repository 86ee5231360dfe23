// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_CANDIDATE_AXES_H
#define CCSWEEP_PART_CANDIDATE_AXES_H

#include <CCSweep/part/Part.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cstddef>
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

// Axes, each once.
class Distinct_axes {
 public:
  void add(Vec3 axis) {
    constexpr double same = 1e-4;  // radians
    axis = without_dust(axis);
    for (const Vec3& known : axes_)
      if (norm(cross(known, axis)) < same) return;
    axes_.push_back(axis);
  }

  template <class Traits>
  void add_planar_patches(const Part<Traits>& part) {
    for (std::size_t p = 0; p < part.number_of_patches(); ++p)
      if (part.planar[p]) add(part.normal[part.largest_face[p]]);
  }

  const std::vector<Vec3>& axes() const { return axes_; }

  std::vector<Vec3> in_both_senses() const {
    std::vector<Vec3> both;
    for (const Vec3& axis : axes_) {
      both.push_back(axis);
      both.push_back(reversed(axis));
    }
    return both;
  }

 private:
  std::vector<Vec3> axes_;
};

}  // namespace internal

/// The directions a part may be swept along: the normals of its planar patches and the axes of its cylindrical ones,
/// each once and in both senses, ordered by the lowest patch index they come from. Complexity: linear, times the
/// number of distinct directions.
template <class Traits>
std::vector<std::array<double, 3>> candidate_axes(const Part<Traits>& part) {
  using namespace internal;
  Distinct_axes found;
  found.add_planar_patches(part);
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    Vec3 axis;
    if (!part.planar[p] && fit_axis(part, Patch_index(p), axis)) found.add(axis);
  }
  return found.in_both_senses();
}

/// Further directions, for a part all caps of which bend: those along two of its planar patches, which then are walls.
/// Of planar patches with more than eight normals the first ones count. Complexity: as `candidate_axes()`.
template <class Traits>
std::vector<std::array<double, 3>> axes_along_planar_patches(const Part<Traits>& part) {
  using namespace internal;
  constexpr std::size_t most = 8;
  constexpr double least = 0.1;  // sine of the angle between two patches that tell a direction
  Distinct_axes normals, found;
  normals.add_planar_patches(part);
  for (std::size_t i = 0; i < std::min(normals.axes().size(), most); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const Vec3 along = cross(normals.axes()[j], normals.axes()[i]); norm(along) > least) found.add(along);
  return found.in_both_senses();
}

}  // namespace CCSweep

#endif
