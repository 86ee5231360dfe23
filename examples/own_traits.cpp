// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Traits of one's own: they count how often the imprint of two faces asks for the turn of three points.
#include <CCSweep/concepts.h>
#include <CCSweep/loops/imprint.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <iostream>
#include <vector>

//! [traits]
class Counting_traits {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

 public:
  using FT = Kernel::FT;
  using Point_2 = Kernel::Point_2;
  using Segment_2 = Kernel::Segment_2;
  using Point_3 = Kernel::Point_3;
  using Vector_3 = Kernel::Vector_3;

  static inline std::size_t turns = 0;
  struct Orientation_2 {
    CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const {
      ++turns;
      return Kernel().orientation_2_object()(p, q, r);
    }
  };

  Orientation_2 orientation_2_object() const { return {}; }
  Kernel::Compare_xy_2 compare_xy_2_object() const { return Kernel().compare_xy_2_object(); }
  Kernel::Collinear_are_ordered_along_line_2 collinear_are_ordered_along_line_2_object() const { return {}; }
  Kernel::Do_intersect_2 do_intersect_2_object() const { return {}; }
  Kernel::Intersect_2 intersect_2_object() const { return {}; }
  Kernel::Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }
  Kernel::Orientation_3 orientation_3_object() const { return {}; }
  Kernel::Collinear_3 collinear_3_object() const { return {}; }
  Kernel::Compare_xyz_3 compare_xyz_3_object() const { return {}; }
  Kernel::Construct_cross_product_vector_3 construct_cross_product_vector_3_object() const { return {}; }
};
static_assert(CCSweep::SweepTraits<Counting_traits>);
//! [traits]

int main() {
  using Point = Counting_traits::Point_2;
  const std::vector<Point> source{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, target{{2, 2}, {6, 2}, {6, 6}, {2, 6}};
  const auto imprint = CCSweep::imprint_faces<Counting_traits>({source}, {target}, 0);
  if (!imprint) {
    std::cerr << imprint.status().reason << '\n';
    return 1;
  }
  std::cout << imprint.value().overlaps().size() << " face in both, " << imprint.value().source_only().size()
            << " in the source only, " << imprint.value().target_only().size() << " in the target only; "
            << Counting_traits::turns << " turns asked for\n";
}
