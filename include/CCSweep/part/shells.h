// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_SHELLS_H
#define CCSWEEP_PART_SHELLS_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

// Six times the signed volume that triangles enclose, in the number type NT. Taken from one of their corners, so that
// a part far from the origin does not lose its digits.
template <class NT, class Triangles, class Convert>
NT sixfold_volume(const Triangles& triangles, const Convert& convert) {
  const auto vector_to = [&, o = triangles.front()[0]](const auto& p) {
    return std::array<NT, 3>{convert(p.x()) - convert(o.x()), convert(p.y()) - convert(o.y()),
                             convert(p.z()) - convert(o.z())};
  };
  NT sum(0);
  for (const auto& triangle : triangles) {
    const auto a = vector_to(triangle[0]), b = vector_to(triangle[1]), c = vector_to(triangle[2]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

// The sign of that volume, for certain: by intervals if they tell, exactly otherwise.
template <class Kernel>
CGAL::Sign sign_of_volume(const std::vector<typename Kernel::Triangle_3>& triangles) {
  using FT = typename Kernel::FT;
  {
    using Interval = CGAL::Interval_nt_advanced;
    const Interval::Protector rounding;
    const auto volume = sixfold_volume<Interval>(triangles, [](const FT& x) { return Interval(CGAL::to_interval(x)); });
    if (volume.inf() > 0) return CGAL::POSITIVE;
    if (volume.sup() < 0) return CGAL::NEGATIVE;
  }
  if constexpr (CGAL::Algebraic_structure_traits<FT>::Is_exact::value)
    return CGAL::sign(sixfold_volume<FT>(triangles, [](const FT& x) { return x; }));
  else
    return CGAL::sign(sixfold_volume<CGAL::Exact_rational>(
        triangles, [](const FT& x) { return CGAL::Exact_rational(CGAL::to_double(x)); }));
}

// One connected surface of a part's boundary.
template <class Kernel>
class Shell {
 public:
  using Triangles = std::vector<typename Kernel::Triangle_3>;

  explicit Shell(Triangles triangles) : triangles_(std::move(triangles)) {
    for (const auto& triangle : triangles_) box_ += triangle.bbox();
  }

  CGAL::Sign orientation() const { return sign_of_volume<Kernel>(triangles_); }

  // Whether the other shell lies within this one. They do not cross, but may touch in vertices and edges.
  bool contains(const Shell& other) const {
    for (int i = 0; i < 3; ++i)
      if (other.box_.min(i) < box_.min(i) || other.box_.max(i) > box_.max(i)) return false;
    if (!tree_) build_tree();
    const Side side(*tree_);
    for (const auto& triangle : other.triangles_) {
      const CGAL::Bounded_side corner = side(triangle[0]);
      if (corner != CGAL::ON_BOUNDARY) return corner == CGAL::ON_BOUNDED_SIDE;
    }
    // All corners are common to both: the inside of a facet is not.
    return side(CGAL::centroid(other.triangles_.front())) == CGAL::ON_BOUNDED_SIDE;
  }

 private:
  using Mesh = CGAL::Surface_mesh<typename Kernel::Point_3>;
  using Side = CGAL::Side_of_triangle_mesh<Mesh, Kernel>;
  using Tree = typename Side::AABB_tree;

  // Most parts have one shell, which no other asks.
  void build_tree() const {
    mesh_ = std::make_unique<Mesh>();
    for (const auto& triangle : triangles_)
      mesh_->add_face(mesh_->add_vertex(triangle[0]), mesh_->add_vertex(triangle[1]), mesh_->add_vertex(triangle[2]));
    tree_ = std::make_unique<Tree>(faces(*mesh_).begin(), faces(*mesh_).end(), *mesh_);
  }

  Triangles triangles_;
  CGAL::Bbox_3 box_;
  mutable std::unique_ptr<Mesh> mesh_;  // the triangles, each by itself
  mutable std::unique_ptr<Tree> tree_;
};

}  // namespace internal
}  // namespace CCSweep

#endif
