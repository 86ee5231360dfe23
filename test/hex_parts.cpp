// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hexahedral meshes of parts that are hard to mesh, and of random ones: what must hold for each of them.
#include <CCSweep/IO/read_part.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include "hex_checks.h"
#include "mesh_changes.h"
#include "random_parts.h"

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using hex_checks::expect_sound;

Mesh load(const std::string& name) {
  return CCSweep::read_part<Point>(CCSWEEP_TEST_DATA "/" + name + ".ply").value().mesh;
}

void expect_family_meshed(random_parts::Family family) {
  constexpr std::uint32_t seeds = 43;  // 301 parts in 7 families
  for (std::uint32_t seed = 0; seed < seeds; ++seed)
    BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed) {
      const auto part = random_parts::make(family, seed);
      expect_sound(hex_checks::mesh(random_parts::mesh<Point>(part), {0, 0, 1}, 2), part.volume, 0.03);
    }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_parts)

// A hole and the bore around it touch, and columns on their walls, of other facets each, miss one another by less than
// a chord strays from its arc.
BOOST_AUTO_TEST_CASE(circles_that_touch_from_inside) {
  const Mesh part = load("touching_circles");
  for (int parts : {10, 20, 40})
    BOOST_TEST_CONTEXT("at extent/" << parts)
    expect_sound(hex_checks::mesh(part, {0, 0, 1}, 30. / parts), hex_checks::volume_within(part), 0.03);
}

// The circles cross at a small angle, and the imprint moves what columns carry to nodes of the walls near by.
BOOST_AUTO_TEST_CASE(arcs_that_cross_at_a_small_angle) {
  const Mesh part = load("counterbore_over_ring");
  const Mesh finer = mesh_changes::mesh<Point>(mesh_changes::with_split_edges(mesh_changes::soup(part)));
  for (const Mesh& m : {part, finer})
    for (int parts : {10, 20, 40})
      BOOST_TEST_CONTEXT("at extent/" << parts)
      expect_sound(hex_checks::mesh(m, {}, 34. / parts), hex_checks::volume_within(part), 0.03);
}

// The edge of a step cuts a thin segment off the circle of a boss below: no quads fit its outline at the size wanted, and
// beside it the angles are so small that no mesh can be good.
BOOST_AUTO_TEST_CASE(thin_segments_of_circles) {
  constexpr double radius = 3, depth = 0.04;
  for (int n : {24, 40})
    BOOST_TEST_CONTEXT(n << " edges") {
      random_parts::Plan plan;
      plan.material.push_back({{{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}});
      plan.bottom = 0;
      plan.top = 2;
      random_parts::Outline circle;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        circle.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
      plan.bottoms.push_back({circle, -1});
      plan.tops.push_back({{{-4, -4}, {radius - depth, -4}, {radius - depth, 4}, {-4, 4}}, 3, true});
      const auto part = random_parts::build(plan);
      BOOST_TEST_REQUIRE(part.has_value());
      expect_sound(hex_checks::mesh(random_parts::mesh<Point>(*part), {0, 0, 1}, 0.5), part->volume, 0.03);
    }
}

// A stepped cavity over a ledge: at one of these sizes the layers that it asks for lose an outline, though the part
// can be decomposed.
BOOST_AUTO_TEST_CASE(layers_that_lose_an_outline) {
  const Mesh part = load("cavity_beside_ledge");
  const std::array<double, 3> up{0.5387347350777414, 0.5060131487456709, 0.6735841287598805};
  for (int parts : {10, 20})
    BOOST_TEST_CONTEXT("at extent/" << parts)
    expect_sound(hex_checks::mesh(part, up, 20. / parts), hex_checks::volume_within(part), 0.03);
}

BOOST_AUTO_TEST_CASE(grids) { expect_family_meshed(random_parts::Family::grids); }
BOOST_AUTO_TEST_CASE(barrels) { expect_family_meshed(random_parts::Family::barrels); }
BOOST_AUTO_TEST_CASE(polygons) { expect_family_meshed(random_parts::Family::polygons); }
BOOST_AUTO_TEST_CASE(circles) { expect_family_meshed(random_parts::Family::circles); }
BOOST_AUTO_TEST_CASE(mixed) { expect_family_meshed(random_parts::Family::mixed); }
BOOST_AUTO_TEST_CASE(split) { expect_family_meshed(random_parts::Family::split); }
BOOST_AUTO_TEST_CASE(windows) { expect_family_meshed(random_parts::Family::windows); }

BOOST_AUTO_TEST_SUITE_END()
