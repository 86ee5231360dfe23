// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_POINTED_WALLS_H
#define CCSWEEP_PART_POINTED_WALLS_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <cstddef>

namespace CCSweep::internal {

/// Finds linking faces that narrow to a point along a straight sweep, as the side of a gusset does where its slope runs
/// into the wall behind: rows of quadrilaterals on such a face end in nothing.
template <class Traits>
class Pointed_wall_search {
  using Part_type = Part<Traits>;
  using Halfedge = typename Part_type::Halfedge;

 public:
  Pointed_wall_search(const Part_type& part, const Roles& roles) : part_(part), roles_(roles) {}

  bool run() const {
    for (std::size_t p = 0; p < part_.number_of_patches(); ++p) {
      if (roles_.of_patch[p] != Role::linking) continue;
      for (Halfedge h : part_.border[p])
        if (ends_in_point(h)) return true;
    }
    return false;
  }

 private:
  static constexpr double level = 0.1;  // sine of the angle up to which an edge neither rises nor falls
  static constexpr double smooth = 30 * 3.14159265358979323846 / 180;

  double rise(Halfedge h) const {
    return dot(unit(part_.coordinates(part_.mesh.target(h)) - part_.coordinates(part_.mesh.source(h))),
               roles_.direction);
  }

  bool is_wall(Halfedge h) const {
    return roles_.of_patch[part_.patch(part_.mesh.face(h)).value()] == Role::linking;
  }

  // A wall that is cut into patches goes on beyond the edge between them.
  bool is_edge_of_walls(Halfedge h) const {
    const Halfedge back = part_.mesh.opposite(h);
    return is_wall(h) && is_wall(back) &&
           angle(part_.normal[part_.mesh.face(h)], part_.normal[part_.mesh.face(back)]) > smooth;
  }

  // Whether all edges of the patch at the target of h, from h to the next one on its border, come from one side.
  bool ends_in_point(Halfedge h) const {
    const double up = rise(h);
    if (!(up > level || up < -level) || !is_edge_of_walls(h)) return false;
    for (Halfedge next = part_.mesh.next(h);; next = part_.mesh.next(part_.mesh.opposite(next))) {
      if (!(up > 0 ? rise(next) < -level : rise(next) > level)) return false;
      if (part_.feature[part_.mesh.edge(next)]) return is_edge_of_walls(next);
    }
  }

  const Part_type& part_;
  const Roles& roles_;
};

template <class Traits>
bool has_pointed_wall(const Part<Traits>& part, const Roles& roles) {
  return Pointed_wall_search<Traits>(part, roles).run();
}

}  // namespace CCSweep::internal

#endif
