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
/// the residuals of the outline's nodes, which spread into the mesh harmonically. The harmonic spread bends nothing
/// over that the outline does not, where weights by distance may.
class Quad_carrier {
 public:
  Quad_carrier(const Quad_mesh& mesh, std::size_t fixed) : mesh_(mesh), fixed_(fixed), spread_(mesh, fixed) {
    for (std::size_t i = 0; i < fixed; ++i) centre_ += place(i) / double(fixed);
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < fixed; ++i) moments += (place(i) - centre_) * (place(i) - centre_).transpose();
    inverse_ = moments.inverse();
  }

  /// The nodes of the mesh for some outlines, each a layer: first those of the outline, then the inner ones.
  std::vector<std::vector<Vec3>> operator()(const std::vector<std::vector<Vec3>>& outlines) const {
    constexpr std::size_t at_once = 8;
    std::vector<std::vector<Vec3>> layers;
    for (std::size_t first = 0; first < outlines.size(); first += at_once) {
      std::vector<Fit> fits;
      for (std::size_t k = first; k < std::min(first + at_once, outlines.size()); ++k) fits.push_back(fit(outlines[k]));
      const auto n = static_cast<Eigen::Index>(fits.size());
      Quad_laplacian::Values residuals(static_cast<Eigen::Index>(fixed_), 3 * n);
      for (Eigen::Index k = 0; k < n; ++k) residuals.middleCols(3 * k, 3) = residuals_of(fits[k], outlines[first + k]);
      const Quad_laplacian::Values spread = spread_(residuals);
      for (Eigen::Index k = 0; k < n; ++k) {
        auto& layer = layers.emplace_back(outlines[first + k]);
        layer.reserve(mesh_.points.size());
        for (std::size_t i = fixed_; i < mesh_.points.size(); ++i) {
          const auto row = static_cast<Eigen::Index>(i - fixed_);
          const Eigen::RowVector3d p = mapped(fits[k], i) + spread.block<1, 3>(row, 3 * k);
          layer.push_back({p[0], p[1], p[2]});
        }
      }
    }
    return layers;
  }

 private:
  // The affine map that fits an outline best.
  struct Fit {
    Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
    Eigen::Matrix<double, 2, 3> map = Eigen::Matrix<double, 2, 3>::Zero();
  };

  Fit fit(const std::vector<Vec3>& outline) const {
    Fit fit;
    for (std::size_t i = 0; i < fixed_; ++i) fit.centre += row(outline[i]) / double(fixed_);
    for (std::size_t i = 0; i < fixed_; ++i) fit.map += (place(i) - centre_) * (row(outline[i]) - fit.centre);
    fit.map = (inverse_ * fit.map).eval();
    return fit;
  }

  Eigen::RowVector3d mapped(const Fit& fit, std::size_t i) const {
    return fit.centre + (place(i) - centre_).transpose() * fit.map;
  }

  Eigen::Matrix<double, Eigen::Dynamic, 3> residuals_of(const Fit& fit, const std::vector<Vec3>& outline) const {
    Eigen::Matrix<double, Eigen::Dynamic, 3> residuals(static_cast<Eigen::Index>(fixed_), 3);
    for (std::size_t i = 0; i < fixed_; ++i)
      residuals.row(static_cast<Eigen::Index>(i)) = row(outline[i]) - mapped(fit, i);
    return residuals;
  }

  static Eigen::RowVector3d row(const Vec3& p) { return {p[0], p[1], p[2]}; }
  Eigen::Vector2d place(std::size_t i) const { return {mesh_.points[i][0], mesh_.points[i][1]}; }

  const Quad_mesh& mesh_;
  std::size_t fixed_;
  Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d inverse_;
  Quad_laplacian spread_;
};

/// The nodes of a cell, by layer from the bottom up; on each first those of the outline.
using Cell_nodes = std::vector<std::vector<Vec3>>;

/// The least scaled Jacobian of a cell's hexahedra, on some of the layers where these are many.
inline double worst_quality(const Quad_mesh& mesh, const Cell_nodes& nodes) {
  constexpr std::size_t some = 8;
  double worst = 1;
  const std::size_t slabs = nodes.size() - 1, step = (slabs + some - 1) / some;
  for (std::size_t k = 0; k < slabs; k = k + 1 < slabs ? std::min(k + step, slabs - 1) : slabs)
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
  Cell_nodes layers = carry(outlines);
  const std::size_t n = layers.size();
  for (std::size_t i = fixed; i < layers[0].size(); ++i) {
    const Vec3 at_bottom = drop_to_target(layers[0][i]) - layers[0][i];
    const Vec3 at_top = drop_to_source(layers[n - 1][i]) - layers[n - 1][i];
    for (std::size_t k = 0; k < n; ++k) {
      const double t = (heights[k] - heights[0]) / (heights[n - 1] - heights[0]);
      layers[k][i] = layers[k][i] + ((1 - t) * at_bottom + t * at_top);
    }
  }
  return layers;
}

}  // namespace CCSweep::internal

#endif
