// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_WALL_EDGES_H
#define CCSWEEP_PART_WALL_EDGES_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

namespace CCSweep::internal {

/// How the edges of linking faces lie to a straight sweep.
template <class Traits>
class Wall_edges {
  using Part_type = Part<Traits>;

 public:
  using Halfedge = typename Part_type::Halfedge;

  static constexpr double level = 0.1;  ///< sine of the angle up to which a direction neither rises nor falls

  Wall_edges(const Part_type& part, const Roles& roles) : part_(part), roles_(roles) {}

  bool is_wall(Halfedge h) const { return roles_.of_patch[patch(h).value()] == Role::linking; }
  Patch_index patch(Halfedge h) const { return part_.patch(part_.mesh.face(h)); }

  /// A wall that is cut into patches goes on beyond the edge between them.
  bool is_edge_of_walls(Halfedge h) const {
    constexpr double smooth = 30 * 3.14159265358979323846 / 180;
    const Halfedge back = part_.mesh.opposite(h);
    return is_wall(h) && is_wall(back) &&
           angle(part_.normal[part_.mesh.face(h)], part_.normal[part_.mesh.face(back)]) > smooth;
  }

  double rise(Halfedge h) const { return dot(unit(along(h)), roles_.direction); }
  /// The rise within the face of a halfedge, away from it.
  double rise_inward(Halfedge h) const {
    return dot(unit(cross(part_.normal[part_.mesh.face(h)], along(h))), roles_.direction);
  }

 private:
  Vec3 along(Halfedge h) const {
    return part_.coordinates(part_.mesh.target(h)) - part_.coordinates(part_.mesh.source(h));
  }

  const Part_type& part_;
  const Roles& roles_;
};

}  // namespace CCSweep::internal

#endif
