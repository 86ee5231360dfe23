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
#include <limits>
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
      : mesh_(mesh),
        drop_(std::move(drop)),
        place_(mesh.points.size(), Place::free),
        cap_(mesh.points.size()),
        room_(mesh.points.size(), 0.0) {
    for (std::size_t q = 0; q < patch.size(); ++q)
      for (std::uint32_t n : mesh.boundary[q].nodes) {
        const bool agrees = place_[n] == Place::free || (place_[n] == Place::on_cap && cap_[n] == patch[q]);
        place_[n] = agrees && mesh.boundary[q].role != Role::linking ? Place::on_cap : Place::fixed;
        cap_[n] = patch[q];
      }
  }

  /// Works on hexahedra of less than a quality.
  /// \return the scaled Jacobians afterwards; -1 where the determinant is not positive all over a hexahedron
  std::vector<double> run(double good) {
    good_ = good;
    quality_ = scaled_jacobians(mesh_);
    if (std::all_of(quality_.begin(), quality_.end(), [&](double q) { return q >= good; })) return std::move(quality_);
    find_hexes_around();
    for (Aim aim : {Aim::all_better, Aim::worst_better}) {
      constexpr int rounds = 12;
      aim_ = aim;
      may_gain_.assign(mesh_.points.size(), true);
      for (int i = 0; i < rounds; ++i)
        if (!improve()) break;
    }
    for (std::uint32_t h = 0; h < quality_.size(); ++h)
      if (quality_[h] < good && !is_positive(corners_of(mesh_, h))) quality_[h] = std::min(quality_[h], -1.0);
    return std::move(quality_);
  }

 private:
  enum class Place : unsigned char { free, on_cap, fixed };
  // What a node's move is for: that all bad corners around it get better in sum, which varies smoothly and so leads
  // out of where no single move helps the worst; or that the worst one does.
  enum class Aim { all_better, worst_better };

  void find_hexes_around() {
    first_.assign(mesh_.points.size() + 1, 0);
    for (const auto& hex : mesh_.hexes)
      for (std::uint32_t n : hex) ++first_[n + 1];
    for (std::size_t n = 0; n < mesh_.points.size(); ++n) first_[n + 1] += first_[n];
    around_.resize(8 * mesh_.hexes.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t h = 0; h < mesh_.hexes.size(); ++h)
      for (std::uint32_t n : mesh_.hexes[h]) around_[next[n]++] = h;
  }

  // One round over the bad hexahedra, the worst first.
  bool improve() {
    std::vector<std::uint32_t> bad;
    for (std::uint32_t h = 0; h < quality_.size(); ++h)
      if (quality_[h] < good_) bad.push_back(h);
    std::stable_sort(bad.begin(), bad.end(), [&](auto a, auto b) { return quality_[a] < quality_[b]; });
    bool moved = false;
    for (std::uint32_t h : bad)
      for (std::uint32_t n : mesh_.hexes[h])
        if (place_[n] != Place::fixed && may_gain_[n]) moved |= search(n);
    return moved;
  }

  double badness_around(std::uint32_t n, double bound) const {
    return aim_ == Aim::all_better ? sum_around(n, bound) : -worst_around(n, -bound);
  }

  // Once a bound is passed, the rest does not matter any more.
  double worst_around(std::uint32_t n, double bound) const {
    double worst = 1;
    for (std::uint32_t i = first_[n]; i < first_[n + 1] && worst >= bound; ++i)
      worst = std::min(worst, scaled_jacobian(corners_of(mesh_, around_[i])));
    return worst;
  }

  // What folds weighs more than all else.
  double sum_around(std::uint32_t n, double bound) const {
    constexpr double folded = 100;
    double sum = 0;
    for (std::uint32_t i = first_[n]; i < first_[n + 1] && sum <= bound; ++i) {
      const Hex_corners p = corners_of(mesh_, around_[i]);
      for (int c = 0; c < 8; ++c) {
        const auto& m = hex_neighbours[c];
        const double q = scaled_determinant(p[m[0]] - p[c], p[m[1]] - p[c], p[m[2]] - p[c]);
        const double lack = std::max(0.0, 1 - q / good_);
        sum += lack * lack * lack * lack + (q < 0 ? folded - q : 0);
      }
    }
    return sum;
  }

  // Along the axes and to the middle of the neighbours, in smaller and smaller steps.
  bool search(std::uint32_t n) {
    constexpr int halvings = 5;
    double longest = 0, shortest = std::numeric_limits<double>::infinity();
    Vec3 middle{};
    for (std::uint32_t i = first_[n]; i < first_[n + 1]; ++i)
      for (std::uint32_t m : mesh_.hexes[around_[i]]) {
        const double length = norm(mesh_.points[m] - mesh_.points[n]);
        longest = std::max(longest, length);
        if (m != n) shortest = std::min(shortest, length);
        middle = middle + (1.0 / (8.0 * (first_[n + 1] - first_[n]))) * mesh_.points[m];
      }
    if (room_[n] == 0) room_[n] = shortest / 4;
    double best = badness_around(n, std::numeric_limits<double>::infinity());
    bool moved = try_place(n, middle, best);
    double step = std::min(longest / 4, 4 * shortest);
    for (int i = 0; i < halvings; ++i) {
      bool better = false;
      for (int axis = 0; axis < 3; ++axis)
        for (double sign : {-1.0, 1.0}) {
          Vec3 p = mesh_.points[n];
          p[axis] += sign * step;
          better |= try_place(n, p, best);
        }
      moved |= better;
      if (!better) step /= 2;
    }
    may_gain_[n] = moved;
    if (!moved) return false;
    for (std::uint32_t i = first_[n]; i < first_[n + 1]; ++i) {
      quality_[around_[i]] = scaled_jacobian(corners_of(mesh_, around_[i]));
      for (std::uint32_t m : mesh_.hexes[around_[i]]) may_gain_[m] = true;
    }
    return true;
  }

  bool try_place(std::uint32_t n, const Vec3& p, double& best) {
    const Vec3 old = mesh_.points[n];
    mesh_.points[n] = place_[n] == Place::free ? p : drop_(cap_[n], p);
    const double wanted = aim_ == Aim::all_better ? 0.99 * best : best - 1e-3;
    if (has_room(n)) {
      if (const double now = badness_around(n, wanted); now < wanted) {
        best = now;
        return true;
      }
    }
    mesh_.points[n] = old;
    return false;
  }

  // A scaled Jacobian does not see lengths: for the better direction of an edge a node would run into its neighbour.
  bool has_room(std::uint32_t n) const {
    for (std::uint32_t i = first_[n]; i < first_[n + 1]; ++i)
      for (std::uint32_t m : mesh_.hexes[around_[i]])
        if (m != n && !(norm(mesh_.points[m] - mesh_.points[n]) >= room_[n])) return false;
    return true;
  }

  Hex_mesh& mesh_;
  Drop drop_;
  std::vector<Place> place_;       // by node
  std::vector<Patch_index> cap_;   // by node that is on one
  std::vector<double> room_;       // by node that may move: how near it may come to its neighbours
  std::vector<std::uint32_t> first_, around_;  // hexahedra by node
  std::vector<double> quality_;                // by hexahedron
  std::vector<bool> may_gain_;                 // by node: something around it has moved since it was tried in vain
  double good_ = 0;
  Aim aim_ = Aim::all_better;
};

}  // namespace CCSweep::internal

#endif
