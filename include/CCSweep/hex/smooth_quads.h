// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_SMOOTH_QUADS_H
#define CCSWEEP_HEX_SMOOTH_QUADS_H

#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/quad_quality.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace CCSweep {
namespace internal {

/// What smoothing aims at: quads of this shape and better are good.
inline constexpr double good_quad_shape = 0.6;

/// Moves the inner nodes of a quad mesh, one after another, where that makes the worst quad around them better.
class Quad_smoother {
 public:
  Quad_smoother(Quad_mesh& mesh, std::size_t fixed) : mesh_(mesh), fixed_(fixed), first_(mesh.points.size() + 1, 0) {
    for (const auto& quad : mesh.quads)
      for (std::uint32_t n : quad) ++first_[n + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    quads_.resize(first_.back());
    for (std::uint32_t q = 0; q < mesh.quads.size(); ++q)
      for (std::uint32_t n : mesh.quads[q]) quads_[next[n]++] = q;
  }

  void run() {
    constexpr int rounds = 30, searches = 15;
    repeat(rounds, [&](std::size_t n) { return relax(n); });
    repeat(searches, [&](std::size_t n) { return quality_around(n) < good_quad_shape && search(n); });
  }

 private:
  // Does the same to all inner nodes, some rounds long; but leaves out those where nothing has moved since the last.
  template <class Move>
  void repeat(int rounds, const Move& move) {
    std::vector<bool> is_settled(mesh_.points.size(), false);
    bool moved = true;
    for (int i = 0; i < rounds && moved; ++i) {
      moved = false;
      for (std::size_t n = fixed_; n < mesh_.points.size(); ++n) {
        if (is_settled[n]) continue;
        is_settled[n] = true;
        if (!move(n)) continue;
        moved = true;
        for (std::uint32_t q : quads_around(n))
          for (std::uint32_t m : mesh_.quads[q]) is_settled[m] = false;
      }
    }
  }

  std::span<const std::uint32_t> quads_around(std::size_t n) const {
    return {quads_.data() + first_[n], quads_.data() + first_[n + 1]};
  }

  // Of the worst quad around a node, or of any that is worse than asked for.
  double quality_around(std::size_t n, double wanted = -2) const {
    double worst = 1;
    for (std::uint32_t q : quads_around(n)) {
      if (worst < wanted) break;
      const auto& [a, b, c, d] = mesh_.quads[q];
      worst = std::min(worst, quad_shape(mesh_.points[a], mesh_.points[b], mesh_.points[c], mesh_.points[d]));
    }
    return worst;
  }

  // To the mean of the neighbours, if that is not where it is, and no good angle is lost for it.
  bool relax(std::size_t n) {
    constexpr double near = 0.002;
    Point2 sum{};
    double size = 0;
    for (std::uint32_t q : quads_around(n)) {
      const auto& quad = mesh_.quads[q];
      const std::size_t i = std::find(quad.begin(), quad.end(), n) - quad.begin();
      for (std::size_t k : {(i + 1) % 4, (i + 3) % 4})
        for (int x : {0, 1}) sum[x] += mesh_.points[quad[k]][x];
      size = std::max(size, squared_length(mesh_.points[n], mesh_.points[quad[(i + 2) % 4]]));
    }
    const double count = 2.0 * static_cast<double>(quads_around(n).size());
    const Point2 mean{sum[0] / count, sum[1] / count};
    return squared_length(mesh_.points[n], mean) > near * near * size &&
           try_place(n, mean, std::min(quality_around(n), good_quad_shape));
  }

  // Looks about for a better place, in smaller and smaller steps.
  bool search(std::size_t n) {
    double step = 0;
    for (std::uint32_t q : quads_around(n))
      step = std::max(step, length_between(mesh_.points[mesh_.quads[q][0]], mesh_.points[mesh_.quads[q][2]]));
    constexpr int halvings = 7;
    constexpr double gain = 1e-4, slant = std::numbers::sqrt2 / 2;
    constexpr Point2 ways[8] = {{1, 0}, {slant, slant}, {0, 1}, {-slant, slant},
                                {-1, 0}, {-slant, -slant}, {0, -1}, {slant, -slant}};
    step /= 3;
    double best = quality_around(n);
    bool moved = false;
    for (int i = 0; i < halvings; ++i, step /= 2)
      for (const Point2& way : ways) {
        const Point2 p = mesh_.points[n];
        if (!try_place(n, {p[0] + step * way[0], p[1] + step * way[1]}, best + gain)) continue;
        best = quality_around(n);
        moved = true;
      }
    return moved;
  }

  bool try_place(std::size_t n, const Point2& p, double wanted) {
    const Point2 old = mesh_.points[n];
    mesh_.points[n] = p;
    if (quality_around(n, wanted) >= wanted) return true;
    mesh_.points[n] = old;
    return false;
  }

  Quad_mesh& mesh_;
  std::size_t fixed_;
  std::vector<std::uint32_t> first_, quads_;  // quads by node
};

}  // namespace internal

/// Smooths a quad mesh whose first `fixed` nodes stay where they are: each of the others moves to the mean of its
/// neighbours where no angle suffers, and where angles are bad, to the best place near by.
/// Complexity: linear in the quads.
inline void smooth_quads(Quad_mesh& mesh, std::size_t fixed) { internal::Quad_smoother(mesh, fixed).run(); }

}  // namespace CCSweep

#endif
