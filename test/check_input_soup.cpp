// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/part/check_soup.h>

#include <boost/test/unit_test.hpp>
#include <limits>

#include "io_shapes.h"

using CCSweep::check_soup;
using CCSweep::Status_code;
using namespace shapes;

BOOST_AUTO_TEST_SUITE(check_input_soup)

BOOST_AUTO_TEST_CASE(sound_soups_pass) {
  BOOST_TEST(check_soup(cube()).ok());
  BOOST_TEST(check_soup(triangulated(cube())).ok());
  BOOST_TEST(check_soup(inside_out(cube())).ok());  // for check_input() to tell
  BOOST_TEST(check_soup(bosses_that_touch()).ok());
  BOOST_TEST(check_soup(both(cube(), box({1, 1, 0}, {2, 2, 1}))).ok());
  auto lonely = cube();
  lonely.points.push_back({5, 5, 5});
  BOOST_TEST(check_soup(lonely).ok());
}

BOOST_AUTO_TEST_CASE(nothing_is_empty) { BOOST_TEST(check_soup({}).code == Status_code::empty_mesh); }

BOOST_AUTO_TEST_CASE(coordinates_are_finite) {
  for (double wild : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    auto soup = cube();
    soup.points[6][2] = wild;
    BOOST_TEST(check_soup(soup).code == Status_code::non_finite_coordinate);
  }
}

BOOST_AUTO_TEST_CASE(facets_have_an_area) {
  auto twice = cube();
  twice.corners[1] = twice.corners[0];
  BOOST_TEST(check_soup(twice).code == Status_code::degenerate_facet);
  auto two_corners = cube();
  add_polygon(two_corners, {0, 1}, 3);
  BOOST_TEST(check_soup(two_corners).code == Status_code::degenerate_facet);
  auto flat = triangulated(cube());
  flat.points[flat.corners[1]] = flat.points[flat.corners[0]];
  const auto status = check_soup(flat);
  BOOST_TEST(status.code == Status_code::degenerate_facet);
  BOOST_TEST(status.patches.size() == 1u);
  BOOST_TEST(status.place.has_value());
}

BOOST_AUTO_TEST_CASE(edges_have_two_facets_that_agree) {
  auto flipped = cube();
  std::reverse(flipped.corners.begin(), flipped.corners.begin() + 4);
  BOOST_TEST(check_soup(flipped).code == Status_code::not_oriented);
  BOOST_TEST(check_soup(flipped).patches.size() == 2u);
  auto twice = cube();
  add_polygon(twice, {2, 3, 1, 0}, 7);
  BOOST_TEST(check_soup(twice).code == Status_code::not_manifold);
  BOOST_TEST(check_soup(twice).reason.find("the same corners") != std::string::npos);
  const auto edge = merged(both(cube(), box({1, 1, 0}, {2, 2, 1})));
  BOOST_TEST(check_soup(edge).code == Status_code::not_manifold);
  BOOST_TEST((*check_soup(edge).place == Xyz{1, 1, 0.5}));
}

BOOST_AUTO_TEST_CASE(vertices_have_one_fan) {
  const auto touching = merged(both(cube(), box({1, 1, 1}, {2, 2, 2})));
  const auto status = check_soup(touching);
  BOOST_TEST(status.code == Status_code::not_manifold);
  BOOST_TEST((*status.place == Xyz{1, 1, 1}));
}

BOOST_AUTO_TEST_CASE(the_surface_is_closed) {
  auto open = cube();
  open.corners.resize(20);
  open.offsets.pop_back();
  open.patch_ids.pop_back();
  BOOST_TEST(check_soup(open).code == Status_code::not_closed);
}

BOOST_AUTO_TEST_SUITE_END()
