// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_PROJECTION_H
#define CCSWEEP_LOOPS_PROJECTION_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/loops/overlay_affine_fit.h>
#include <CCSweep/loops/point_index.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CCSweep {

/// The map from one layer to the next (section 2.6): the affine map [T] that fits the control loops best, corrected
/// by the residuals of the control nodes nearby, weighted by their inverse squared distance.
///
/// @tparam Traits the kernel of the sweep; the map itself is computed in `double`
/// @tparam PointIndex a model of `PointIndex_3`
template <class Traits, PointIndex_3 PointIndex = Rtree_point_index_3>
class Layer_projection {
 public:
  using Point = std::array<double, 3>;
  /// A closed control loop, as numbers of control nodes in order.
  using Loop = std::vector<std::size_t>;

  /// The map that takes the control nodes `from` to `to`. The loops' pseudo-normals hold the direction across the
  /// layer, which nodes in one plane leave open; give inner loops in the opposite sense of outer ones. Without loops,
  /// or where they enclose nothing, the offset between the layers takes their place.
  ///
  /// @param direction of the sweep through both layers, where it is straight and known; it maps to itself then, and
  /// the pseudo-normals, which lean with bent loops, are not asked
  /// @param neighbours how many control nodes correct a point; the paper takes 10
  /// @return `projection_folded` if the fit is not orientation preserving; `invalid_parameter` for no nodes, unequal
  /// counts, loops of nodes that do not exist, or no neighbours.
  ///
  /// Linear, and the time the index takes to be built.
  static Result<Layer_projection> make(const std::vector<Point>& from, const std::vector<Point>& to,
                                       const std::vector<Loop>& loops = {}, std::size_t neighbours = 10,
                                       const std::optional<Point>& direction = std::nullopt) {
    return internal::guarded([&] {
      check(from, to, loops, neighbours);
      return Layer_projection(internal::Affine_fit(from, to, loops, direction), from, to, neighbours);
    });
  }

  /// The image of a point; that of a control node is exactly its partner. One query of the index.
  Point operator()(const Point& point) const {
    const Eigen::Vector3d mapped = fit_(internal::vector(point));
    const Point place = internal::array(mapped);
    std::vector<Neighbour> near;
    for (std::size_t k : index_.nearest(place, neighbours_)) {
      near.push_back({internal::squared_distance(mapped_[k], place), k});
    }
    return corrected(mapped, near);
  }

  /// Maps points that come one after another, as nodes in the order of their loops do: the neighbours of one point
  /// bound the search for the next. The images are those of the projection, to the last bit; it must outlive the walk.
  class Walk {
   public:
    explicit Walk(const Layer_projection& projection)
        : projection_(&projection), nearest_(projection.index_, projection.mapped_, projection.neighbours_) {}

    Point operator()(const Point& point) {
      const Eigen::Vector3d mapped = projection_->fit_(internal::vector(point));
      return projection_->corrected(mapped, nearest_(internal::array(mapped)));
    }

   private:
    const Layer_projection* projection_;
    Neighbour_walk<PointIndex> nearest_;
  };

  Walk walk() const { return Walk(*this); }

  /// The residual (1) of a control node.
  Point residual(std::size_t node) const {
    return internal::array(internal::vector(to_[node]) - internal::vector(mapped_[node]));
  }

  /// The linear part of [T].
  const Eigen::Matrix3d& matrix() const { return fit_.matrix(); }

 private:
  Layer_projection(internal::Affine_fit fit, const std::vector<Point>& from, std::vector<Point> to,
                   std::size_t neighbours)
      : fit_(std::move(fit)),
        to_(std::move(to)),
        mapped_(images(fit_, from)),
        index_(mapped_),
        neighbours_(neighbours) {}

  // The image of s_i from [T] s_i and the control nodes nearest to it.
  Point corrected(const Eigen::Vector3d& mapped, std::span<const Neighbour> near) const {
    const double smallest = near.front().squared_distance;
    if (smallest == 0) return to_[near.front().number];
    // Eqs. (2)-(4). The weights are relative to the nearest node's, so that none overflows.
    Eigen::Vector3d correction = Eigen::Vector3d::Zero();
    double total = 0;
    for (const auto& [squared_distance, k] : near) {
      const double weight = smallest / squared_distance;
      correction += weight * (internal::vector(to_[k]) - internal::vector(mapped_[k]));
      total += weight;
    }
    return internal::array(mapped + correction / total);  // Eq. (5)
  }

  static void check(const std::vector<Point>& from, const std::vector<Point>& to, const std::vector<Loop>& loops,
                    std::size_t neighbours) {
    bool valid = !from.empty() && from.size() == to.size() && neighbours > 0;
    for (const Loop& loop : loops) {
      for (std::size_t n : loop) valid = valid && n < from.size();
    }
    if (!valid) {
      internal::fail(Status_code::invalid_parameter, Stage::projection,
                     "a projection needs pairs of control nodes, loops of these, and at least one neighbour");
    }
  }

  static std::vector<Point> images(const internal::Affine_fit& fit, const std::vector<Point>& points) {
    std::vector<Point> result;
    for (const Point& p : points) result.push_back(internal::array(fit(internal::vector(p))));
    return result;
  }

  internal::Affine_fit fit_;
  std::vector<Point> to_, mapped_;
  PointIndex index_;
  std::size_t neighbours_;
};

}  // namespace CCSweep

#endif
