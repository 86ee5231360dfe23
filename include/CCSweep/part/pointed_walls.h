// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_POINTED_WALLS_H
#define CCSWEEP_PART_POINTED_WALLS_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/Wall_edges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CCSweep::internal {

/// Finds linking faces that narrow to a point along a straight sweep, as the side of a gusset does where its slope runs
/// into the plate below or into the wall behind: rows of quadrilaterals on such a face end in nothing.
template <class Traits>
class Pointed_wall_search {
  using Edges = Wall_edges<Traits>;
  using Halfedge = typename Edges::Halfedge;

 public:
  /// A wall, and two caps whose edges meet in its point.
  using At_caps = std::array<Patch_index, 3>;

  Pointed_wall_search(const Part<Traits>& part, const Roles& roles) : part_(part), edges_(part, roles) {}

  /// Whether one lies between other walls.
  bool between_walls() const {
    for (std::size_t p = 0; p < part_.number_of_patches(); ++p)
      for (Halfedge h : part_.border[p])
        if (ends_in_point(h)) return true;
    return false;
  }

  /// Those between caps, that meet in no edge that rises: each wall once.
  std::vector<At_caps> between_caps() const {
    std::vector<At_caps> found;
    for (std::size_t p = 0; p < part_.number_of_patches(); ++p)
      for (Halfedge h : part_.border[p])
        if (const Halfedge next = next_on_border(h); is_between_caps(h, next)) {
          found.push_back({Patch_index(p), beyond(h), beyond(next)});
          break;
        }
    return found;
  }

 private:
  Patch_index beyond(Halfedge h) const { return edges_.patch(part_.mesh.opposite(h)); }
  bool is_edge_of_cap(Halfedge h) const { return edges_.is_wall(h) && !edges_.is_wall(part_.mesh.opposite(h)); }

  Halfedge next_on_border(Halfedge h) const {
    Halfedge next = part_.mesh.next(h);
    while (!part_.feature[part_.mesh.edge(next)]) next = part_.mesh.next(part_.mesh.opposite(next));
    return next;
  }

  // Whether all edges of the patch at the target of h, from h to the next one on its border, come from one side.
  bool ends_in_point(Halfedge h) const {
    const double up = edges_.rise(h);
    if (!(up > Edges::level || up < -Edges::level) || !edges_.is_edge_of_walls(h)) return false;
    for (Halfedge next = part_.mesh.next(h);; next = part_.mesh.next(part_.mesh.opposite(next))) {
      if (!(up > 0 ? edges_.rise(next) < -Edges::level : edges_.rise(next) > Edges::level)) return false;
      if (part_.feature[part_.mesh.edge(next)]) return edges_.is_edge_of_walls(next);
    }
  }

  // Whether the patch lies above one edge and below the other.
  bool is_between_caps(Halfedge h, Halfedge next) const {
    if (!is_edge_of_cap(h) || !is_edge_of_cap(next)) return false;
    const double here = edges_.rise_inward(h), there = edges_.rise_inward(next);
    return std::min(here, there) < -Edges::level && std::max(here, there) > Edges::level;
  }

  const Part<Traits>& part_;
  const Edges edges_;
};

}  // namespace CCSweep::internal

#endif
