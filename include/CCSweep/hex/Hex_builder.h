// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_HEX_BUILDER_H
#define CCSWEEP_HEX_HEX_BUILDER_H

#include <CCSweep/hex/Cell_mesher.h>
#include <CCSweep/hex/Cell_outlines.h>
#include <CCSweep/hex/Cell_stack.h>
#include <CCSweep/hex/Hex_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CCSweep::internal {

/// Makes room for further elements: for no more than these where that is much, so that a large cell fills no more
/// memory than it needs, but for many small cells at once.
template <class T>
void reserve_more(std::vector<T>& list, std::size_t count) {
  const std::size_t wanted = list.size() + count;
  if (wanted > list.capacity()) list.reserve(std::max(wanted, list.size() + list.size() / 2));
}

/// Joins the meshes of cells to one, whose first points are the nodes of the outlines.
class Hex_builder {
 public:
  Hex_builder(const Cell_stack& stack, const Cell_outlines& outlines, Hex_mesh& mesh, std::vector<Patch_index>& patch)
      : stack_(stack), outlines_(outlines), mesh_(mesh), patch_(patch) {}

  void add(std::size_t c, const Cell_mesh& made) {
    const Cell& cell = stack_.cells[c];
    volume_ = stack_.volume_of(cell);
    const Layers number = number_nodes(outlines_.around(c), made.nodes);
    add_hexes(number, made.quads);
    for (const auto& [a, b, d, e] : made.quads.quads) {
      const auto &low = number.front(), &high = number.back();
      add_quad({low[a], low[e], low[d], low[b]}, cell.target, Role::target);
      add_quad({high[a], high[b], high[d], high[e]}, cell.source, Role::source);
    }
    add_walls(cell, outlines_.around(c));
  }

 private:
  using Layers = std::vector<Cell_outlines::Numbers>;

  Layers number_nodes(Layers number, const Cell_nodes& nodes) {
    reserve_more(mesh_.points, nodes.size() * (nodes[0].size() - number[0].size()));
    for (std::size_t k = 0; k < nodes.size(); ++k)
      for (std::size_t i = number[k].size(); i < nodes[k].size(); ++i) {
        number[k].push_back(static_cast<std::uint32_t>(mesh_.points.size()));
        mesh_.points.push_back(nodes[k][i]);
      }
    return number;
  }

  void add_hexes(const Layers& number, const Quad_mesh& quads) {
    reserve_more(mesh_.hexes, (number.size() - 1) * quads.quads.size());
    reserve_more(mesh_.volume, (number.size() - 1) * quads.quads.size());
    for (std::size_t k = 0; k + 1 < number.size(); ++k)
      for (const auto& [a, b, d, e] : quads.quads) {
        const auto &low = number[k], &high = number[k + 1];
        mesh_.hexes.push_back({low[a], low[b], low[d], low[e], high[a], high[b], high[d], high[e]});
        mesh_.volume.push_back(volume_);
      }
  }

  void add_walls(const Cell& cell, const Layers& outlines) {
    for (std::size_t k = cell.bottom + 1; k <= cell.top; ++k) {
      const auto &low = outlines[k - 1 - cell.bottom], &high = outlines[k - cell.bottom];
      std::size_t first = 0;
      for (const Cell::Loop& loop : cell.loops[cell.top - k]) {
        const std::size_t length = outlines_.length(k, loop);
        std::size_t at = 0;
        for (auto h : loop) {
          const Patch_index wall = stack_.arcs.arc(k, h).wall[h % 2];
          for (std::size_t i = 0; i < outlines_.intervals(k, h); ++i, ++at)
            if (const std::size_t a = first + at, b = first + (at + 1) % length; wall.is_valid())
              add_quad({low[a], low[b], high[b], high[a]}, wall, Role::linking);
        }
        first += length;
      }
    }
  }

  void add_quad(const std::array<std::uint32_t, 4>& quad, Patch_index patch, Role role) {
    mesh_.boundary.push_back({quad, stack_.id(patch), role, volume_});
    patch_.push_back(patch);
  }

  const Cell_stack& stack_;
  const Cell_outlines& outlines_;
  Hex_mesh& mesh_;
  std::vector<Patch_index>& patch_;  // by boundary quad
  int volume_ = 0;                   // of the cell at hand
};

}  // namespace CCSweep::internal

#endif
