// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CELL_MESHER_H
#define CCSWEEP_HEX_CELL_MESHER_H

#include <CCSweep/hex/Cell_outlines.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/Cell_sweeper.h>
#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/mesh_quads.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The mesh of one cell: quads, and their nodes on each layer. Empty where there is none.
struct Cell_mesh {
  Quad_mesh quads;
  Cell_nodes nodes;
  double quality = -2;  ///< the least scaled Jacobian

  bool empty() const { return nodes.empty(); }
};

/// Meshes a section of a cell with quads and sweeps these through the cell.
class Cell_mesher {
 public:
  using Drop = std::function<Vec3(const Vec3&)>;

  Cell_mesher(const Cell_stack& stack, std::size_t cell, const Cell_outlines& outlines, Drop to_target, Drop to_source)
      : cell_(cell), bottom_(stack.cells[cell].bottom), outlines_(outlines), to_target_(std::move(to_target)),
        to_source_(std::move(to_source)) {
    for (std::size_t k = bottom_; k <= stack.cells[cell].top; ++k) {
      places_.push_back(outlines.places(cell, k));
      heights_.push_back(stack.layers.layers[k].value);
    }
  }

  /// \param mesh_quads a `QuadMesher`; whatever it can't do is subdivided
  /// \param acceptable with less, smaller quads are tried inside, where the edges of the outline may be long beside its
  /// width
  /// \param smallest share of the size of quads that may be tried
  template <QuadMesher Quads>
  Cell_mesh run(const Quads& mesh_quads, double size, double acceptable, double smallest) const {
    Cell_mesh best;
    for (double share = 1; best.quality < acceptable && share >= smallest; share /= 2)
      mesh_with(mesh_quads, share * size, best);
    if (best.empty()) mesh_with(Subdivided_quads(), size, best);
    return best;
  }

 private:
  // The layer on which the section is meshed matters where the cell widens or bends.
  template <QuadMesher Quads>
  void mesh_with(const Quads& mesh_quads, double size, Cell_mesh& best) const {
    constexpr double good = 0.4;
    for (std::size_t k : {places_.size() - 1, std::size_t(0), places_.size() / 2}) {
      auto quads = mesh_quads(outlines_.region(cell_, bottom_ + k, places_[k]), size);
      if (!quads) continue;
      Cell_nodes nodes = sweep_cell(*quads, places_, heights_, to_target_, to_source_);
      const double quality = worst_quality(*quads, nodes);
      if (quality <= best.quality) continue;
      best = {std::move(*quads), std::move(nodes), quality};
      if (quality >= good) break;
    }
  }

  std::size_t cell_, bottom_;
  const Cell_outlines& outlines_;
  Drop to_target_, to_source_;
  std::vector<std::vector<Vec3>> places_;  // by layer: around the cell
  std::vector<double> heights_;            // by layer
};

}  // namespace CCSweep::internal

#endif
