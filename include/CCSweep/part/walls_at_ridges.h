// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_WALLS_AT_RIDGES_H
#define CCSWEEP_PART_WALLS_AT_RIDGES_H

#include <CCSweep/indices.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CCSweep::internal {

/// Finds linking faces that close a part or open it along an edge across a straight sweep: both faces at a ridge lie
/// below it, both at the bottom of a groove above. No column can go on there, so one of the two must be a cap.
template <class Traits>
class Ridge_search {
  using Part_type = Part<Traits>;
  using Halfedge = typename Part_type::Halfedge;

 public:
  Ridge_search(const Part_type& part, const Roles& roles) : part_(part), roles_(roles) {}

  std::vector<Patch_index> run() const {
    std::vector<Patch_index> found;
    for (std::size_t p = 0; p < part_.number_of_patches(); ++p)
      for (Halfedge h : part_.border[p])
        if (is_ridge(h)) {
          found.emplace_back(p);
          break;
        }
    return found;
  }

 private:
  static constexpr double level = 0.1;  // sine of the angle up to which a direction neither rises nor falls

  bool is_ridge(Halfedge h) const {
    const Halfedge back = part_.mesh.opposite(h);
    if (!is_wall(h) || !is_wall(back) || std::abs(rise(unit(along(h)))) > level) return false;
    const double here = rise(inward(h)), beyond = rise(inward(back));
    return (here > level && beyond > level) || (here < -level && beyond < -level);
  }

  bool is_wall(Halfedge h) const {
    return roles_.of_patch[part_.patch(part_.mesh.face(h)).value()] == Role::linking;
  }
  Vec3 along(Halfedge h) const {
    return part_.coordinates(part_.mesh.target(h)) - part_.coordinates(part_.mesh.source(h));
  }
  // Within the face of a halfedge, away from it.
  Vec3 inward(Halfedge h) const { return unit(cross(part_.normal[part_.mesh.face(h)], along(h))); }
  double rise(const Vec3& v) const { return dot(v, roles_.direction); }

  const Part_type& part_;
  const Roles& roles_;
};

template <class Traits>
std::vector<Patch_index> walls_at_ridges(const Part<Traits>& part, const Roles& roles) {
  return Ridge_search<Traits>(part, roles).run();
}

}  // namespace CCSweep::internal

#endif
