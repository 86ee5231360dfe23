// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CCSweep/concepts.h>
#include <CCSweep/loops/imprint.h>
#include <CCSweep/loops/projection.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>
#include <map>
#include <random>

#include "loops_drawings.h"

namespace {

using namespace CCSweep;
using namespace loops_test;

// The least that models SweepTraits, with nothing extra: points that can be made, copied and asked for coordinates.
template <class Kernel>
class Traits_archetype {
 public:
  using FT = typename Kernel::FT;

  class Point_2 {
   public:
    Point_2(const FT& x, const FT& y) : point_(x, y) {}
    FT x() const { return point_.x(); }
    FT y() const { return point_.y(); }

   private:
    friend class Traits_archetype;
    typename Kernel::Point_2 point_;
  };
  class Segment_2 {
   public:
    Segment_2(const Point_2& p, const Point_2& q) : p_(p), q_(q) {}

   private:
    Point_2 p_, q_;
  };
  using Point_3 = typename Kernel::Point_3;
  using Vector_3 = typename Kernel::Vector_3;

  auto orientation_2_object() const {
    return [](const Point_2& p, const Point_2& q, const Point_2& r) {
      return Kernel().orientation_2_object()(p.point_, q.point_, r.point_);
    };
  }
  auto compare_xy_2_object() const {
    return [](const Point_2& p, const Point_2& q) { return Kernel().compare_xy_2_object()(p.point_, q.point_); };
  }
  auto collinear_are_ordered_along_line_2_object() const {
    return [](const Point_2&, const Point_2&, const Point_2&) { return false; };
  }
  auto do_intersect_2_object() const {
    return [](const Segment_2&, const Segment_2&) { return false; };
  }
  auto intersect_2_object() const {
    return [](const Segment_2&, const Segment_2&) {};
  }
  auto side_of_oriented_circle_2_object() const {
    return [](const Point_2&, const Point_2&, const Point_2&, const Point_2&) { return CGAL::ON_ORIENTED_BOUNDARY; };
  }
  auto orientation_3_object() const { return Kernel().orientation_3_object(); }
  auto collinear_3_object() const { return Kernel().collinear_3_object(); }
  auto compare_xyz_3_object() const { return Kernel().compare_xyz_3_object(); }
  auto construct_cross_product_vector_3_object() const { return Kernel().construct_cross_product_vector_3_object(); }
};

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

static_assert(SweepTraits<Traits_archetype<Inexact>>);
static_assert(SweepTraits<Traits_archetype<Rational>>);
static_assert(SweepTraits<Inexact> && SweepTraits<Exact> && SweepTraits<Rational>);

template <class K>
Imprint<K> imprinted(double tolerance) {
  std::mt19937 random(12);
  Layer_drawing<K> drawing;
  draw(drawing, star(random, 40, 0, 0), Loop_label{1, -1}, {.fixed = true});
  draw(drawing, star(random, 40, 0.2, 0.1), Loop_label{-1, 2}, {.chord_error = 1e-4});
  draw(drawing, rectangle(-3, -3, 1, 1), Loop_label{-1, 3});
  draw(drawing, rectangle(-2, -3 + 1e-10, 1, 1), Loop_label{-1, 4});
  return imprint_layer(drawing, tolerance).value();
}

template <class K>
void check_as_in_doubles(double tolerance) {
  const auto expected = imprinted<Inexact>(tolerance);
  const auto found = imprinted<K>(tolerance);
  BOOST_TEST(is_valid(found.graph, found.points));
  BOOST_TEST(found.graph.number_of_loop_faces() == expected.graph.number_of_loop_faces());
  BOOST_TEST((found.chains == expected.chains));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loops_traits)

BOOST_AUTO_TEST_CASE(the_archetype_is_enough) {
  for (double tolerance : {0., 1e-9}) {
    check_as_in_doubles<Traits_archetype<Inexact>>(tolerance);
    check_as_in_doubles<Traits_archetype<Rational>>(tolerance);
  }
}

BOOST_AUTO_TEST_CASE(kernels_agree) {
  for (double tolerance : {0., 1e-9}) {
    check_as_in_doubles<Exact>(tolerance);
    check_as_in_doubles<Rational>(tolerance);
  }
}

BOOST_AUTO_TEST_SUITE_END()
