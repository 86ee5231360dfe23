// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Sub-volumes that are swept in a direction of their own inside the mesh of the whole part.
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Best_mesh.h>
#include <CCSweep/hex/Cap_drop.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/make_arc_stack.h>
#include <CCSweep/hex/make_hex_mesh.h>
#include <CCSweep/hex/sizing.h>
#include <CCSweep/internal/Input.h>
#include <CCSweep/internal/Pipeline.h>
#include <CCSweep/loops/point_index.h>
#include <CCSweep/loops/segment_index.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/assign_roles.h>
#include <CCSweep/visitor.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "hex_checks.h"
#include "prisms.h"

namespace {

using CCSweep::Hex_mesh;
using prisms::Corner;
using prisms::Kernel;
using prisms::low_box_beside_tall_one;
using prisms::Mesh;
using prisms::Outline;
using prisms::prism;
using Direction = std::array<double, 3>;

constexpr Direction upward{0, 0, 1};

// The places of a roof between its eaves at (2, 1) and (0, 1), from the one to the other.
using Roof = std::vector<std::array<double, 2>>;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

// An arch that meets the walls at an angle in degrees above the horizontal.
Roof arch(double steepness) {
  constexpr int facets = 24;
  const double half = radians(steepness), radius = 1 / std::sin(half);
  Roof roof;
  for (int i = 1; i < facets; ++i) {
    const double angle = half * (1 - 2.0 * i / facets);
    roof.push_back({1 + radius * std::sin(angle), 1 + radius * (std::cos(angle) - std::cos(half))});
  }
  return roof;
}

// Two slopes with a flat ridge between them.
Roof gable(double steepness, double ridge) {
  const double height = 1 + (1 - ridge / 2) * std::tan(radians(steepness));
  return {{1 + ridge / 2, height}, {1 - ridge / 2, height}};
}

// The boxes with a roof on the low one.
Outline roofed(const Roof& roof, bool is_mirrored) {
  Outline outline = low_box_beside_tall_one();
  for (std::size_t i = 0; i < roof.size(); ++i)
    outline.insert(outline.begin() + 6 + static_cast<std::ptrdiff_t>(i),
                   {roof[i][0], roof[i][1], roof.size() == 2 ? 20 + static_cast<int>(i) : 15});
  if (is_mirrored) {
    for (Corner& corner : outline) corner.x = -corner.x;
    std::reverse(outline.begin(), outline.end());
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) std::swap(outline[i].patch, outline[i + 1].patch);
  }
  return outline;
}

// Swept upward as a whole, by the stages themselves.
Hex_mesh swept_together(const Mesh& mesh, double size) {
  using namespace CCSweep;
  const auto patch = mesh.property_map<Mesh::Face_index, int>("f:patch_id").first;
  const auto part = internal::read_input<Kernel>(mesh, mesh.points(), patch);
  const Roles roles = assign_roles(part, {upward, {}, {}}).value().front();
  const double tolerance = 1e-5 * part.diagonal;
  Visitor_base visitor;
  internal::Stage_runner run(visitor);
  const auto swept = internal::sweep<Kernel, Rtree_segment_index_2<Kernel>, Rtree_point_index_3>(
      part, roles, {.spacing = size}, tolerance, 0, 10, visitor, run);
  const Layer_stack layers = make_layer_stack(swept.layering, swept.loops, roles.is_straight(), tolerance);
  const Cap_drop<Kernel> drop(part);
  const Arc_stack arcs = make_arc_stack(layers, drop);
  return make_hex_mesh(layers, arcs, part.patch_id, drop, Patch_sizes(size));
}

bool is_along_y(const Direction& d) { return std::abs(d[1]) > 1 - 1e-9; }

// Expects the low box to be swept along its roof, the tall one as before, and the hexahedra to gain by it.
void expect_own_direction(const Outline& outline, double shear, double size) {
  const Mesh part = prism(outline, shear);
  const auto found = hex_checks::mesh(part, upward, size);
  hex_checks::expect_sound(found, prisms::volume(outline), 0.02);
  const Hex_mesh &mesh = found.value(), common = swept_together(part, size);
  BOOST_TEST(mesh.targets == common.targets);
  BOOST_TEST_REQUIRE(mesh.directions.size() == 2);
  BOOST_TEST(std::count_if(mesh.directions.begin(), mesh.directions.end(), is_along_y) == 1);
  const auto now = CCSweep::internal::least_by_volume(mesh), before = CCSweep::internal::least_by_volume(common);
  for (std::size_t v = 0; v < 2; ++v)
    if (is_along_y(mesh.directions[v]))
      BOOST_TEST(now[v] > before[v] + 0.01);
    else
      BOOST_TEST(now[v] == before[v]);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_directions)

// Swept upward, the hexahedra under a steep roof are as flat as it; along the roof they can be better. The whole stays
// conformal.
BOOST_AUTO_TEST_CASE(a_box_under_an_arch_is_swept_along_it) {
  for (double steepness : {48.0, 50.0, 52.0})
    for (bool is_mirrored : {false, true})
      BOOST_TEST_CONTEXT(steepness << " degrees, mirrored " << is_mirrored)
        expect_own_direction(roofed(arch(steepness), is_mirrored), 0, 0.5);
}

BOOST_AUTO_TEST_CASE(a_box_under_a_gable_is_swept_along_it) {
  for (double shear : {0.0, 0.3})
    for (bool is_mirrored : {false, true})
      for (double size : {0.5, 0.25})
        BOOST_TEST_CONTEXT("shear " << shear << ", mirrored " << is_mirrored << ", size " << size)
          expect_own_direction(roofed(gable(38, 0.6), is_mirrored), shear, size);
}

// Where one sweep suits all, it is that of all.
BOOST_AUTO_TEST_CASE(boxes_are_swept_together) {
  const Outline outline = low_box_beside_tall_one();
  const auto found = hex_checks::mesh(prism(outline, 0), upward, 0.5);
  hex_checks::expect_sound(found, prisms::volume(outline), 1e-9);
  BOOST_TEST(std::count_if(found.value().directions.begin(), found.value().directions.end(), is_along_y) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
