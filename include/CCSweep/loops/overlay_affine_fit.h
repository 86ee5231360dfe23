// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_AFFINE_FIT_H
#define CCSWEEP_LOOPS_OVERLAY_AFFINE_FIT_H

#include <CCSweep/internal/guarded.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CCSweep::internal {

inline Eigen::Vector3d vector(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }
inline std::array<double, 3> array(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// The affine map between the control nodes of two layers, x -> c' + A (x - c) with the centroids c and c'. Least
// squares alone leave A open across a plane, so the pseudo-normals of the loops are made to map to each other as well
// (as by Roca and Sarrate), weighted like the loops' own extent. A translation, and any similarity, is reproduced.
class Affine_fit {
 public:
  using Point = std::array<double, 3>;

  Affine_fit(const std::vector<Point>& from, const std::vector<Point>& to,
             const std::vector<std::vector<std::size_t>>& loops, const std::optional<Point>& direction = std::nullopt)
      : centre_(centroid(from)), image_(centroid(to)) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero(), b = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Eigen::Vector3d x = vector(from[i]) - centre_, y = vector(to[i]) - image_;
      m += x * x.transpose();
      b += y * x.transpose();
    }
    const double weight = m.trace() / 2;
    auto [across, across_image] = across_the_layers(from, to, loops, weight / static_cast<double>(from.size()));
    if (direction) across = across_image = vector(*direction).normalized();
    m += weight * across * across.transpose();
    b += weight * across_image * across.transpose();
    hold_open_directions(m, b);
    matrix_ = clamped(m.ldlt().solve(b.transpose()).transpose());
    if (!(matrix_.determinant() > 0)) {
      fail(Status_code::projection_folded, Stage::projection, "the map between two layers turns the part inside out",
           {}, array(centre_));
    }
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return image_ + matrix_ * (x - centre_); }
  const Eigen::Matrix3d& matrix() const { return matrix_; }

 private:
  static constexpr double smallest_stretch = 0.2, largest_stretch = 5;
  static constexpr double negligible = 1e-9;

  static Eigen::Vector3d centroid(const std::vector<Point>& points) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Point& p : points) sum += vector(p);
    return sum / static_cast<double>(points.size());
  }

  // Half the sum of the cross products along the loops, which does not depend on the origin.
  static Eigen::Vector3d pseudo_area(const std::vector<Point>& points, const Eigen::Vector3d& origin,
                                     const std::vector<std::vector<std::size_t>>& loops) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::vector<std::size_t>& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Eigen::Vector3d p = vector(points[loop[i]]) - origin;
        sum += p.cross(vector(points[loop[(i + 1) % loop.size()]]) - origin) / 2;
      }
    }
    return sum;
  }

  // A unit vector across the layer, and what it should become.
  std::array<Eigen::Vector3d, 2> across_the_layers(const std::vector<Point>& from, const std::vector<Point>& to,
                                                   const std::vector<std::vector<std::size_t>>& loops,
                                                   double mean_square) const {
    const Eigen::Vector3d a = pseudo_area(from, centre_, loops), b = pseudo_area(to, image_, loops);
    if (a.norm() > negligible * mean_square && b.norm() > negligible * mean_square) {
      return {a.normalized(), std::sqrt(b.norm() / a.norm()) * b.normalized()};
    }
    const Eigen::Vector3d offset = image_ - centre_;
    if (offset.squaredNorm() <= negligible * mean_square) return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    return {offset.normalized(), offset.normalized()};
  }

  // Directions that neither nodes nor normals speak of map to themselves.
  static void hold_open_directions(Eigen::Matrix3d& m, Eigen::Matrix3d& b) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
    const double scale = m.trace() > 0 ? m.trace() : 1;
    for (int i = 0; i < 3; ++i) {
      if (solver.eigenvalues()[i] > 1e-12 * scale) continue;
      const Eigen::Vector3d v = solver.eigenvectors().col(i);
      m += scale * v * v.transpose();
      b += scale * v * v.transpose();
    }
  }

  static Eigen::Matrix3d clamped(const Eigen::Matrix3d& a) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3d stretch = svd.singularValues();
    if (stretch.maxCoeff() <= largest_stretch && stretch.minCoeff() >= smallest_stretch) return a;
    const Eigen::Vector3d bounded = stretch.cwiseMax(smallest_stretch).cwiseMin(largest_stretch);
    return svd.matrixU() * bounded.asDiagonal() * svd.matrixV().transpose();
  }

  Eigen::Vector3d centre_, image_;
  Eigen::Matrix3d matrix_;
};

}  // namespace CCSweep::internal

#endif
