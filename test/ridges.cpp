// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Roofs, keels and grooves whose slopes are too steep for caps by themselves, on walls of few large facets.
#include <CCSweep/linking/Layering.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "decompose_runs.h"
#include "hex_checks.h"
#include "prisms.h"

namespace {

using prisms::low_box_beside_tall_one;
using prisms::Outline;

double slope(double degrees) { return std::tan(degrees * std::numbers::pi / 180); }

struct Case {
  std::string name;
  Outline outline;
  std::size_t targets;
};
std::vector<Case> parts(double degrees) {
  const double rise = slope(degrees);
  return {{"gable", low_box_beside_tall_one({{2, 1, 15}, {1, 1 + rise, 20}, {0, 1, 16}}), 2},
          {"flat top", low_box_beside_tall_one(
                           {{2, 1, 15}, {1.3, 1 + 0.7 * rise, 20}, {0.7, 1 + 0.7 * rise, 21}, {0, 1, 16}}), 2},
          {"shed", low_box_beside_tall_one({{2, 1, 15}, {0, 1 + 2 * rise, 16}}), 2},
          {"keel", {{2, 0, 10}, {2, -1, 11}, {3, -1 - rise, 18}, {4, -1, 12}, {4, 3.5, 13}, {2, 3.5, 14}, {2, 1, 15},
                    {0, 1, 16}, {0, 0, 17}}, 3}};
}

template <class Outcome>
void expect_whole(const Outcome& found, std::size_t count, double volume) {
  BOOST_TEST_REQUIRE(found.ok(), name(found.status().code) << ": " << found.status().reason);
  BOOST_TEST(found.value().volumes.size() == count);
  double sum = 0;
  for (const auto& v : found.value().volumes) sum += CGAL::to_double(CGAL::Polygon_mesh_processing::volume(v.mesh));
  BOOST_TEST(std::abs(sum - volume) < 1e-9 * volume);
}

auto decomposed(const prisms::Mesh& mesh) {
  return decompose_runs::decompose(
      mesh, {.direction = {0, 0, 1}, .spanning_angle = CCSweep::Layering_options().spanning_angle});
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ridges)

BOOST_AUTO_TEST_CASE(slopes_that_meet_in_a_ridge_are_caps) {
  for (double degrees : {20.0, 30.0, 40.0, 45.0, 50.0, 57.0})
    for (const auto& [name, outline, targets] : parts(degrees))
      BOOST_TEST_CONTEXT(name << " of " << degrees << " degrees") {
        const double volume = prisms::volume(outline);
        expect_whole(decomposed(prisms::prism(outline)), targets, volume);
        const auto meshed = hex_checks::mesh(prisms::prism(outline), {0, 0, 1}, 0.25);
        hex_checks::expect_sound(meshed, volume, 0.02);
      }
}

// One facet may fill a whole gable, all corners of which lie on the roof.
BOOST_AUTO_TEST_CASE(a_house_of_few_facets) {
  for (double degrees : {20.0, 45.0, 57.0})
    BOOST_TEST_CONTEXT(degrees << " degrees") {
      const Outline house{{0, 0, 10}, {2, 0, 11}, {2, 1, 12}, {1, 1 + slope(degrees), 13}, {0, 1, 14}};
      expect_whole(decomposed(prisms::prism(house)), 1, prisms::volume(house));
      hex_checks::expect_sound(hex_checks::mesh(prisms::prism(house), {0, 0, 1}, 0.2), prisms::volume(house), 0.02);
    }
}

// A groove of 90 degrees, as of a V-block, is swept from below as well as along.
BOOST_AUTO_TEST_CASE(a_groove_in_a_block_with_a_step_below) {
  const Outline block{{0, 0, 10}, {2, 0, 11}, {2, -1, 12}, {4, -1, 13}, {4, 2, 14}, {3, 2, 15}, {2, 1, 16}, {1, 2, 17},
                      {0, 2, 18}};
  expect_whole(decomposed(prisms::prism(block)), 2, prisms::volume(block));
  hex_checks::expect_sound(hex_checks::mesh(prisms::prism(block), {0, 0, 1}, 0.25), prisms::volume(block), 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
