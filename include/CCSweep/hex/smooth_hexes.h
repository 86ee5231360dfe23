// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_SMOOTH_HEXES_H
#define CCSWEEP_HEX_SMOOTH_HEXES_H

#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/quality.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Moves nodes of bad hexahedra to better places near by, each so that the worst hexahedron around it gets better; this
/// unfolds what the sweep has folded. Inner nodes are free, those inside a cap move on it, those on walls, and where
/// patches meet, stay.
class Hex_smoother {
 public:
  /// Puts a place back on a cap.
  using Drop = std::function<Vec3(Patch_index cap, const Vec3&)>;

  /// \param patch by boundary quad
  Hex_smoother(Hex_mesh& mesh, const std::vector<Patch_index>& patch, Drop drop)
      : mesh_(mesh), drop_(std::move(drop)), place_(mesh.points.size(), Place::free), cap_(mesh.points.size()) {
    for (std::size_t q = 0; q < patch.size(); ++q)
      for (std::uint32_t n : mesh.boundary[q].nodes) {
        const bool agrees = place_[n] == Place::free || cap_[n] == patch[q];
        place_[n] = agrees && mesh.boundary[q].role != Role::linking ? Place::on_cap : Place::fixed;
        cap_[n] = patch[q];
      }
    first_.assign(mesh.points.size() + 1, 0);
    for (const auto& hex : mesh.hexes)
      for (std::uint32_t n : hex) ++first_[n + 1];
    for (std::size_t n = 0; n < mesh.points.size(); ++n) first_[n + 1] += first_[n];
    around_.resize(8 * mesh.hexes.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t h = 0; h < mesh.hexes.size(); ++h)
      for (std::uint32_t n : mesh.hexes[h]) around_[next[n]++] = h;
  }

  /// Works on hexahedra of less than a quality.
  /// \return the scaled Jacobians afterwards
  std::vector<double> run(double good) {
    constexpr int rounds = 12;
    quality_ = scaled_jacobians(mesh_);
    for (int i = 0; i < rounds; ++i) {
      std::vector<std::uint32_t> bad;
      for (std::uint32_t h = 0; h < quality_.size(); ++h)
        if (quality_[h] < good) bad.push_back(h);
      std::stable_sort(bad.begin(), bad.end(), [&](auto a, auto b) { return quality_[a] < quality_[b]; });
      bool moved = false;
      for (std::uint32_t h : bad)
        for (std::uint32_t n : mesh_.hexes[h])
          if (place_[n] != Place::fixed) moved |= search(n);
      if (!moved) break;
    }
    return std::move(quality_);
  }

 private:
  enum class Place : unsigned char { free, on_cap, fixed };

  double worst_around(std::uint32_t n) const {
    double worst = 1;
    for (std::uint32_t i = first_[n]; i < first_[n + 1]; ++i)
      worst = std::min(worst, scaled_jacobian(corners_of(mesh_, around_[i])));
    return worst;
  }

  // Along the axes and to the middle of the neighbours, in smaller and smaller steps.
  bool search(std::uint32_t n) {
    constexpr double gain = 1e-3;
    constexpr int halvings = 5;
    double step = 0;
    Vec3 middle{};
    for (std::uint32_t i = first_[n]; i < first_[n + 1]; ++i)
      for (std::uint32_t m : mesh_.hexes[around_[i]]) {
        step = std::max(step, norm(mesh_.points[m] - mesh_.points[n]));
        middle = middle + (1.0 / (8.0 * (first_[n + 1] - first_[n]))) * mesh_.points[m];
      }
    double best = worst_around(n);
    bool moved = try_place(n, middle, best, gain);
    step /= 4;
    for (int i = 0; i < halvings; ++i) {
      bool better = false;
      for (int axis = 0; axis < 3; ++axis)
        for (double sign : {-1.0, 1.0}) {
          Vec3 p = mesh_.points[n];
          p[axis] += sign * step;
          better |= try_place(n, p, best, gain);
        }
      moved |= better;
      if (!better) step /= 2;
    }
    if (moved)
      for (std::uint32_t i = first_[n]; i < first_[n + 1]; ++i)
        quality_[around_[i]] = scaled_jacobian(corners_of(mesh_, around_[i]));
    return moved;
  }

  bool try_place(std::uint32_t n, const Vec3& p, double& best, double gain) {
    const Vec3 old = mesh_.points[n];
    mesh_.points[n] = place_[n] == Place::free ? p : drop_(cap_[n], p);
    const double now = worst_around(n);
    if (now > best + gain) {
      best = now;
      return true;
    }
    mesh_.points[n] = old;
    return false;
  }

  Hex_mesh& mesh_;
  Drop drop_;
  std::vector<Place> place_;       // by node
  std::vector<Patch_index> cap_;   // by node that is on one
  std::vector<std::uint32_t> first_, around_;  // hexahedra by node
  std::vector<double> quality_;                // by hexahedron
};

}  // namespace CCSweep::internal

#endif
