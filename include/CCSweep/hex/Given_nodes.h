// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_GIVEN_NODES_H
#define CCSWEEP_HEX_GIVEN_NODES_H

#include <CCSweep/part/Part.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Whether a quad lies between two rows across a direction.
inline bool is_between_rows(const std::array<Vec3, 4>& quad, const Vec3& direction, double tolerance) {
  std::array<double, 4> height;
  std::transform(quad.begin(), quad.end(), height.begin(), [&](const Vec3& p) { return dot(direction, p); });
  std::sort(height.begin(), height.end());
  return height[1] - height[0] <= tolerance && height[2] - height[1] > tolerance && height[3] - height[2] <= tolerance;
}

/// Nodes that a mesh is to have on some patches of a part, as that of its neighbour has them already. The part is swept
/// straight, and the nodes stand in rows across the sweep.
class Given_nodes {
 public:
  /// There are none.
  Given_nodes() = default;

  /// \param patches ids of the patches on which there are these nodes and no others
  /// \param tolerance how far a node may be from its row and from an arc
  Given_nodes(const std::vector<Vec3>& nodes, std::set<int> patches, const Vec3& direction, double tolerance)
      : patches_(std::move(patches)), direction_(direction), tolerance_(tolerance) {
    for (const Vec3& p : nodes) by_height_.emplace_back(dot(direction, p), p);
    std::sort(by_height_.begin(), by_height_.end());
  }

  bool are_on(int patch) const { return patches_.count(patch) > 0; }

  /// The heights of the rows, ascending.
  std::vector<double> heights() const {
    std::vector<double> rows;
    for (const auto& [height, p] : by_height_)
      if (rows.empty() || height - rows.back() > tolerance_) rows.push_back(height);
    return rows;
  }

  /// The nodes on a polyline within one layer, in its sense.
  std::vector<Vec3> along(const std::vector<Vec3>& line) const {
    const double height = dot(direction_, line[0]);
    std::vector<std::pair<double, Vec3>> found;
    const auto first = std::lower_bound(by_height_.begin(), by_height_.end(), std::pair(height - tolerance_, Vec3{}));
    for (auto at = first; at != by_height_.end() && at->first <= height + tolerance_; ++at)
      if (const auto [distance, length] = project(at->second, line); distance <= tolerance_)
        found.emplace_back(length, at->second);
    std::sort(found.begin(), found.end());
    std::vector<Vec3> nodes;
    for (const auto& [length, p] : found) nodes.push_back(p);
    return nodes;
  }

 private:
  // How far a place is from a polyline, and the length along it up to there.
  static std::pair<double, double> project(const Vec3& p, const std::vector<Vec3>& line) {
    std::pair<double, double> nearest{norm(p - line[0]), 0};
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec3 w = line[i + 1] - line[i];
      const double of_edge = norm(w);
      if (of_edge == 0) continue;
      const double t = std::clamp(dot(p - line[i], w) / (of_edge * of_edge), 0.0, 1.0);
      nearest = std::min(nearest, {norm(p - (line[i] + t * w)), length + t * of_edge});
      length += of_edge;
    }
    return nearest;
  }

  std::set<int> patches_;
  Vec3 direction_{};
  double tolerance_ = 0;
  std::vector<std::pair<double, Vec3>> by_height_;
};

}  // namespace CCSweep::internal

#endif
