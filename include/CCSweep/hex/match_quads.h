// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MATCH_QUADS_H
#define CCSWEEP_HEX_MATCH_QUADS_H

#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/Cap_triangulation.h>
#include <CCSweep/hex/pair_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace CCSweep {
namespace internal {

/// Joins the two quads at an inner node of two sides into one, till there is no such node, and drops the nodes that are
/// not used. Such a node can't be smoothed: one of its two angles is flat or worse.
class Doublet_remover {
 public:
  Doublet_remover(Quad_mesh& mesh, std::size_t fixed) : mesh_(mesh), fixed_(fixed), quads_of_(mesh.points.size()) {
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q)
      for (std::uint32_t n : mesh.quads[q]) quads_of_[n].insert(q);
  }

  void run() {
    std::set<std::uint32_t> dead;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t n = fixed_; n < quads_of_.size(); ++n)
        if (quads_of_[n].size() == 2) changed |= join(static_cast<std::uint32_t>(n), dead);
    }
    compact(dead);
  }

 private:
  static std::size_t place(const std::array<std::uint32_t, 4>& quad, std::uint32_t n) {
    return static_cast<std::size_t>(std::find(quad.begin(), quad.end(), n) - quad.begin());
  }

  // The corner opposite to the node in the one quad takes its place in the other.
  bool join(std::uint32_t n, std::set<std::uint32_t>& dead) {
    const std::uint32_t keep = *quads_of_[n].begin(), lose = *std::next(quads_of_[n].begin());
    auto& quad = mesh_.quads[keep];
    const std::uint32_t opposite = mesh_.quads[lose][(place(mesh_.quads[lose], n) + 2) % 4];
    if (std::find(quad.begin(), quad.end(), opposite) != quad.end()) return false;
    quad[place(quad, n)] = opposite;
    for (std::uint32_t m : mesh_.quads[lose]) quads_of_[m].erase(lose);
    quads_of_[n].clear();
    quads_of_[opposite].insert(keep);
    dead.insert(lose);
    return true;
  }

  void compact(const std::set<std::uint32_t>& dead) {
    Quad_mesh kept;
    std::vector<std::uint32_t> number(mesh_.points.size());
    for (std::size_t n = 0; n < number.size(); ++n) {
      number[n] = static_cast<std::uint32_t>(kept.points.size());
      if (n < fixed_ || !quads_of_[n].empty()) kept.points.push_back(mesh_.points[n]);
    }
    for (std::uint32_t q = 0; q < mesh_.quads.size(); ++q) {
      if (dead.count(q)) continue;
      kept.quads.push_back(mesh_.quads[q]);
      for (std::uint32_t& n : kept.quads.back()) n = number[n];
    }
    mesh_ = std::move(kept);
  }

  Quad_mesh& mesh_;
  std::size_t fixed_;
  std::vector<std::set<std::uint32_t>> quads_of_;
};

}  // namespace internal

/// An unstructured mesh of a region: its triangles of the size wanted, matched two and two to quads, as many and as
/// good ones as there can be (Remacle et al., Blossom-Quad, 2012).
/// Neighbours of triangles left over are split, and all are matched anew, a few times.
/// \return nothing where a triangle is left over then, or the loops cross each other.
/// Complexity: O(n log n), and O(n) for each pair that the best ones leave out.
inline std::optional<Quad_mesh> match_quads(const Quad_region& region, double size) {
  constexpr int tries = 6;
  internal::Cap_triangulation mesh(region, size, 1);
  if (!mesh.run() || mesh.triangles.size() % 2 != 0) return std::nullopt;
  std::vector<internal::Triangle_pair> pairs;
  std::vector<std::size_t> chosen;
  for (int i = 0; i < tries; ++i) {
    // Smoothing opens flat corners, and those turned in a little.
    pairs = internal::pairs_of_triangles(mesh, -0.9);
    chosen = internal::choose_pairs(pairs, mesh.triangles.size(), true);
    if (2 * chosen.size() == mesh.triangles.size()) break;
    mesh.split(internal::partners_of(internal::left_over(pairs, chosen, mesh.triangles.size()), pairs));
  }
  if (2 * chosen.size() != mesh.triangles.size()) return std::nullopt;
  Quad_mesh result;
  result.points = mesh.points;
  for (std::size_t i : chosen) result.quads.push_back(pairs[i].quad);
  internal::Doublet_remover(result, number_of_nodes(region)).run();
  return result;
}

}  // namespace CCSweep

#endif
