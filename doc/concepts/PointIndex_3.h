// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// A spatial index over points in space, built once for each control loop that is projected and asked for the nearest
/// of them: the wall nodes whose residuals correct the projection of an interior node, equation (4) of the paper.
///
/// The answer is fully determined, ties included, so the choice of an index never changes a result.
///
/// Checked at compile time by `CCSweep::PointIndex_3`.
///
/// Models: `CCSweep::Rtree_point_index_3` (the default), `CCSweep::Kd_tree_point_index_3` over CGAL's kd-tree,
/// `CCSweep::Brute_force_point_index_3` (the oracle).
class PointIndex_3 {
 public:
  /// Takes all points. The number of a point is its place in `points`.
  explicit PointIndex_3(const std::vector<std::array<double, 3>>& points);

  /// The numbers of the `k` points nearest to `place`, nearest first, of equally near ones the lower number first; all
  /// points if there are fewer. Called once for each interior node of a layer, and less often by a
  /// `CCSweep::Neighbour_walk`, which uses what it knows from the node before.
  std::vector<std::size_t> nearest(const std::array<double, 3>& place, std::size_t k) const;
};
