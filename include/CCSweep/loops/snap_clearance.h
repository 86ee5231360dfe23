// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_SNAP_CLEARANCE_H
#define CCSWEEP_LOOPS_SNAP_CLEARANCE_H

#include <CCSweep/loops/box_runs.h>
#include <CCSweep/loops/overlay_nodes.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CCSweep::internal {

// A fixed segment, or a fixed node (both ends the same).
struct Fixed_feature {
  Node_index a, b;
};

// Says how far snapping may reach: never more than a third of the distance to the nearest fixed feature that is not
// incident to what is snapped, so that a real ledge is not closed. Features that hang together with an incident one
// nearby are incident too: the next facets of the same wall are no ledge.
template <class Traits, class SegmentIndex>
class Snap_clearance {
 public:
  Snap_clearance(const Layer_nodes<Traits>& nodes, std::vector<Fixed_feature> features)
      : nodes_(nodes), features_(std::move(features)), index_(boxes()) {}

  const std::vector<Fixed_feature>& features() const { return features_; }

  // Whether a node at `place` may move or attract by `reach`, where `incident` are the nodes of what it snaps to.
  bool allows(Place_2 place, double reach, const std::vector<Node_index>& incident) const {
    const double radius = 3 * reach;
    std::vector<std::size_t> near;
    const CGAL::Bbox_2 here(place[0], place[1], place[0], place[1]);
    index_.find(inflated(here, radius), near);
    std::erase_if(near, [&](std::size_t f) { return distance_to(f, place) >= radius; });
    if (near.empty()) return true;
    std::vector<bool> reached(near.size(), false);
    std::vector<Node_index> front = incident;
    std::vector<std::pair<Node_index, std::size_t>> ends;
    for (std::size_t i = 0; i < near.size(); ++i) {
      ends.emplace_back(features_[near[i]].a, i);
      ends.emplace_back(features_[near[i]].b, i);
    }
    std::sort(ends.begin(), ends.end());
    while (!front.empty()) {
      const Node_index n = front.back();
      front.pop_back();
      for (auto e = std::lower_bound(ends.begin(), ends.end(), std::pair(n, std::size_t{0}));
           e != ends.end() && e->first == n; ++e) {
        if (reached[e->second]) continue;
        reached[e->second] = true;
        for (Node_index end : {features_[near[e->second]].a, features_[near[e->second]].b}) {
          if (distance(nodes_.place(end), place) < radius) front.push_back(end);
        }
      }
    }
    return std::find(reached.begin(), reached.end(), false) == reached.end();
  }

 private:
  double distance_to(std::size_t feature, Place_2 place) const {
    return closest(place, nodes_.place(features_[feature].a), nodes_.place(features_[feature].b)).distance;
  }

  std::vector<Flat_box> boxes() const {
    std::vector<Flat_box> result;
    result.reserve(features_.size());
    for (const Fixed_feature& feature : features_) result.push_back(flat_box(nodes_.box(feature.a, feature.b)));
    return result;
  }

  const Layer_nodes<Traits>& nodes_;
  std::vector<Fixed_feature> features_;
  Run_search<SegmentIndex> index_;
};

}  // namespace CCSweep::internal

#endif
