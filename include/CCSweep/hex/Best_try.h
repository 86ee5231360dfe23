// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_BEST_TRY_H
#define CCSWEEP_HEX_BEST_TRY_H

#include <CCSweep/hex/Cell_outlines.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/angle_bound.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// How well cells are meshed.
struct Cell_qualities {
  std::vector<Angle_bound> bounds;      ///< by cell: the tightest on the outlines of its caps
  std::vector<double> scaled_jacobian;  ///< by cell: the least; -2 where there is no mesh

  double worst() const { return *std::min_element(scaled_jacobian.begin(), scaled_jacobian.end()); }

  /// Whether a cell lacks the quality wanted, and its angles allow for more.
  bool falls_short(std::size_t cell, double wanted) const {
    return !(scaled_jacobian[cell] > 0) || scaled_jacobian[cell] < attainable(bounds[cell], wanted);
  }
  bool falls_short(double wanted) const {
    for (std::size_t c = 0; c < scaled_jacobian.size(); ++c)
      if (falls_short(c, wanted)) return true;
    return false;
  }
};

/// A mesh of all cells at some numbers of intervals.
struct Hex_try {
  Cell_outlines outlines;
  Hex_mesh mesh;
  Cell_qualities qualities;
};

/// Keeps the mesh with the best worst hexahedron.
class Best_try {
 public:
  /// Takes the mesh of a try if it is better than the one kept.
  /// \param gain how much better it must be, as long as no hexahedron of the one kept is folded
  /// \param wanted the quality that makes further tries needless, where the angles allow for it
  /// \return whether they are
  bool show(Hex_try& shown, double gain, double wanted) {
    constexpr std::size_t growth = 4;  // of the number of hexahedra from the first mesh
    const double worst = shown.qualities.worst();
    size_ = shown.mesh.hexes.size();
    if (most_ == 0 && worst > -2) most_ = growth * size_;
    if (worst > quality_ + (quality_ > 0 ? gain : 0)) {
      quality_ = worst;
      mesh_ = std::move(shown.mesh);
      qualities_ = shown.qualities;
    }
    return !empty() && !qualities_.falls_short(wanted);
  }

  bool empty() const { return quality_ == -2; }
  /// Whether the mesh shown last had so many hexahedra that more of them are not worth it.
  bool has_grown() const { return most_ > 0 && size_ > most_; }
  Hex_mesh take() { return std::move(mesh_); }

 private:
  Hex_mesh mesh_;
  double quality_ = -2;
  Cell_qualities qualities_;
  std::size_t size_ = 0, most_ = 0;  // hexahedra; 0 before there is a mesh
};

}  // namespace CCSweep::internal

#endif
