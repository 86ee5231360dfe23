// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_QUAD_LAPLACIAN_H
#define CCSWEEP_HEX_QUAD_LAPLACIAN_H

#include <CCSweep/hex/Quad_region.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CCSweep::internal {

/// Spreads values from the outline of a quad mesh into it, so that every inner node has the mean of its neighbours.
class Quad_laplacian {
 public:
  Quad_laplacian(const Quad_mesh& mesh, std::size_t fixed) {
    const auto inner = static_cast<Eigen::Index>(mesh.points.size() - fixed);
    std::vector<Eigen::Triplet<double>> among, to_outline;
    for (const auto& quad : mesh.quads)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t other : {(k + 1) % 4, (k + 3) % 4}) {
          if (quad[k] < fixed) continue;
          const auto i = static_cast<Eigen::Index>(quad[k] - fixed);
          among.emplace_back(i, i, 1);
          if (quad[other] < fixed)
            to_outline.emplace_back(i, quad[other], 1);
          else
            among.emplace_back(i, static_cast<Eigen::Index>(quad[other] - fixed), -1);
        }
    Eigen::SparseMatrix<double> matrix(inner, inner);
    matrix.setFromTriplets(among.begin(), among.end());
    to_outline_.resize(inner, static_cast<Eigen::Index>(fixed));
    to_outline_.setFromTriplets(to_outline.begin(), to_outline.end());
    if (inner > 0) solver_.compute(matrix);
  }

  using Values = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// The values of the inner nodes, a row each, from those of the outline's. All columns go through the factor at once,
  /// which is what takes the time, so many are hardly dearer than one.
  Values operator()(const Values& on_outline) const {
    if (to_outline_.rows() == 0) return Values(0, on_outline.cols());
    Values x = solver_.permutationP() * Values(to_outline_ * on_outline);
    const auto& factor = solver_.matrixL().nestedExpression();
    using Entry = typename std::decay_t<decltype(factor)>::InnerIterator;
    const Eigen::Index n = x.rows();
    for (Eigen::Index j = 0; j < n; ++j)
      for (Entry e(factor, j); e; ++e)
        if (e.row() > j) x.row(e.row()) -= e.value() * x.row(j);
    x.array().colwise() /= solver_.vectorD().array();
    for (Eigen::Index j = n; j-- > 0;)
      for (Entry e(factor, j); e; ++e)
        if (e.row() > j) x.row(j) -= e.value() * x.row(e.row());
    return solver_.permutationPinv() * x;
  }

 private:
  Eigen::SparseMatrix<double> to_outline_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace CCSweep::internal

#endif
