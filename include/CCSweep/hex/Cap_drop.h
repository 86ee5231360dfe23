// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CAP_DROP_H
#define CCSWEEP_HEX_CAP_DROP_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/drop_to_patch.h>

#include <algorithm>
#include <limits>

namespace CCSweep {

/// Puts points on a cap, along the sweep. Points beside the cap go to the facet they are nearest to.
template <class Traits>
class Cap_drop {
 public:
  using Vec3 = internal::Vec3;

  explicit Cap_drop(const Part<Traits>& part) : part_(part) {}

  Vec3 operator()(Patch_index cap, const Vec3& p, const Vec3& up) const {
    using namespace internal;
    auto face = part_.largest_face[cap.value()];
    if (!part_.planar[cap.value()]) {
      double least = std::numeric_limits<double>::infinity();
      for (auto f : part_.faces[cap.value()]) {
        const double d = distance_outside(part_, f, p, up);
        if (d >= least) continue;
        least = d;
        face = f;
        if (least <= 0) break;
      }
    }
    const Vec3& n = part_.normal[face];
    const Vec3 a = part_.coordinates(part_.mesh.source(part_.mesh.halfedge(face)));
    return p + (dot(a - p, n) / dot(up, n)) * up;
  }

 private:
  const Part<Traits>& part_;
};

}  // namespace CCSweep

#endif
