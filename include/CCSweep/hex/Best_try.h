// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_BEST_TRY_H
#define CCSWEEP_HEX_BEST_TRY_H

#include <CCSweep/hex/Cell_outlines.h>
#include <CCSweep/hex/Hex_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// A mesh of all cells at some numbers of intervals.
struct Hex_try {
  Cell_outlines outlines;
  Hex_mesh mesh;
  std::vector<double> quality;  ///< by cell: its least scaled Jacobian; -2 where there is no mesh

  double worst() const { return *std::min_element(quality.begin(), quality.end()); }
};

/// Keeps the mesh with the best worst hexahedron.
class Best_try {
 public:
  /// Takes the mesh of a try if it is better than the one kept.
  /// \param gain how much better it must be, as long as no hexahedron of the one kept is folded
  /// \return whether further tries are needless: the best mesh is good
  bool show(Hex_try& shown, double gain, double good) {
    constexpr std::size_t growth = 4;  // of the number of hexahedra from the first mesh
    const double worst = shown.worst();
    size_ = shown.mesh.hexes.size();
    if (most_ == 0 && worst > -2) most_ = growth * size_;
    if (worst > quality_ + (quality_ > 0 ? gain : 0)) {
      quality_ = worst;
      mesh_ = std::move(shown.mesh);
    }
    return quality_ >= good;
  }

  bool empty() const { return quality_ == -2; }
  /// Whether the mesh shown last had so many hexahedra that more of them are not worth it.
  bool has_grown() const { return most_ > 0 && size_ > most_; }
  Hex_mesh take() { return std::move(mesh_); }

 private:
  Hex_mesh mesh_;
  double quality_ = -2;
  std::size_t size_ = 0, most_ = 0;  // hexahedra; 0 before there is a mesh
};

}  // namespace CCSweep::internal

#endif
