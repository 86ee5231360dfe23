// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CELL_SWEEPER_H
#define CCSWEEP_HEX_CELL_SWEEPER_H

#include <CCSweep/hex/Quad_laplacian.h>
#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/quality.h>
#include <CCSweep/part/Part.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Carries a plane quad mesh to the layers of a cell: by the affine map that fits its outline on the layer best, and
/// the residuals of the outline's nodes, which spread into the mesh harmonically. The harmonic spread bends nothing over
/// that the outline does not, where weights by distance may.
class Quad_carrier {
 public:
  Quad_carrier(const Quad_mesh& mesh, std::size_t fixed) : mesh_(mesh), fixed_(fixed), spread_(mesh, fixed) {
    for (std::size_t i = 0; i < fixed; ++i) centre_ += place(i) / double(fixed);
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < fixed; ++i) moments += (place(i) - centre_) * (place(i) - centre_).transpose();
    inverse_ = moments.inverse();
  }

  /// The inner nodes of the mesh for an outline on a layer.
  std::vector<Vec3> operator()(const std::vector<Vec3>& outline) const {
    const Eigen::Index n = static_cast<Eigen::Index>(fixed_);
    Eigen::MatrixXd points(n, 3);
    for (Eigen::Index i = 0; i < n; ++i)
      for (int x = 0; x < 3; ++x) points(i, x) = outline[i][x];
    const Eigen::RowVector3d centre = points.colwise().mean();
    Eigen::Matrix<double, 2, 3> fit = Eigen::Matrix<double, 2, 3>::Zero();
    for (Eigen::Index i = 0; i < n; ++i) fit += (place(i) - centre_) * (points.row(i) - centre);
    fit = (inverse_ * fit).eval();
    for (Eigen::Index i = 0; i < n; ++i) points.row(i) -= centre + (place(i) - centre_).transpose() * fit;
    std::vector<Vec3> inner(mesh_.points.size() - fixed_);
    if (inner.empty()) return inner;
    const Eigen::MatrixXd spread = spread_(points);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const Eigen::RowVector3d p = centre + (place(fixed_ + i) - centre_).transpose() * fit + spread.row(i);
      inner[i] = {p[0], p[1], p[2]};
    }
    return inner;
  }

 private:
  Eigen::Vector2d place(std::size_t i) const { return {mesh_.points[i][0], mesh_.points[i][1]}; }

  const Quad_mesh& mesh_;
  std::size_t fixed_;
  Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d inverse_;
  Quad_laplacian spread_;
};

/// The nodes of a cell, by layer from the bottom up; on each first those of the outline.
using Cell_nodes = std::vector<std::vector<Vec3>>;

/// The least scaled Jacobian of a cell's hexahedra.
inline double worst_quality(const Quad_mesh& mesh, const Cell_nodes& nodes) {
  double worst = 1;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k)
    for (const auto& quad : mesh.quads) {
      Hex_corners corners;
      for (int i = 0; i < 4; ++i) {
        corners[i] = nodes[k][quad[i]];
        corners[i + 4] = nodes[k + 1][quad[i]];
      }
      worst = std::min(worst, scaled_jacobian(corners));
    }
  return worst;
}

/// Sweeps a quad mesh through a cell. The inner nodes on its two caps are put on these, and what that moves them is
/// blended into the layers between.
/// \param outlines by layer from the bottom up
/// \param heights the sweep parameter of these layers
template <class Drop>
Cell_nodes sweep_cell(const Quad_mesh& mesh, const std::vector<std::vector<Vec3>>& outlines,
                      const std::vector<double>& heights, const Drop& drop_to_target, const Drop& drop_to_source) {
  const std::size_t fixed = outlines[0].size();
  const Quad_carrier carry(mesh, fixed);
  Cell_nodes layers;
  for (const auto& outline : outlines) layers.push_back(carry(outline));
  const std::size_t n = layers.size();
  for (std::size_t i = 0; i < layers[0].size(); ++i) {
    const Vec3 at_bottom = drop_to_target(layers[0][i]) - layers[0][i];
    const Vec3 at_top = drop_to_source(layers[n - 1][i]) - layers[n - 1][i];
    for (std::size_t k = 0; k < n; ++k) {
      const double t = (heights[k] - heights[0]) / (heights[n - 1] - heights[0]);
      layers[k][i] = layers[k][i] + ((1 - t) * at_bottom + t * at_top);
    }
  }
  for (std::size_t k = 0; k < n; ++k) layers[k].insert(layers[k].begin(), outlines[k].begin(), outlines[k].end());
  return layers;
}

}  // namespace CCSweep::internal

#endif
