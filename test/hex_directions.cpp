// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Sub-volumes that are swept in a direction of their own inside the mesh of the whole part.
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/quality.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "hex_checks.h"

namespace {

using CCSweep::Hex_mesh;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Direction = std::array<double, 3>;

// A corner of an outline, and the patch over the edge that starts there.
struct Corner {
  double x, z;
  int patch;
};
using Outline = std::vector<Corner>;

constexpr double length = 3;

// A low box beside a taller one that reaches down deeper, seen from the front, counterclockwise.
Outline low_box_beside_tall_one() {
  return {{2, 0, 10}, {2, -1, 11}, {4, -1, 12}, {4, 3.5, 13}, {2, 3.5, 14}, {2, 1, 15}, {0, 1, 16}, {0, 0, 17}};
}

// The same with an arched roof on the low box, which meets its walls steeply: at an angle in degrees above the
// horizontal.
Outline arched_box_beside_tall_one(double steepness, bool is_mirrored) {
  Outline outline = low_box_beside_tall_one(), arch;
  constexpr int facets = 24;
  const double half = steepness * std::numbers::pi / 180, radius = 1 / std::sin(half);
  for (int i = 1; i < facets; ++i) {
    const double angle = half * (1 - 2.0 * i / facets);
    arch.push_back({1 + radius * std::sin(angle), 1 + radius * (std::cos(angle) - std::cos(half)), 15});
  }
  outline.insert(outline.begin() + 6, arch.begin(), arch.end());
  if (is_mirrored) {
    for (Corner& corner : outline) corner.x = -corner.x;
    std::reverse(outline.begin(), outline.end());
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) std::swap(outline[i].patch, outline[i + 1].patch);
  }
  return outline;
}

Mesh prism(const Outline& outline) {
  Mesh mesh;
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch_id", -1).first;
  std::vector<Mesh::Vertex_index> front, back;
  for (const Corner& corner : outline) {
    front.push_back(mesh.add_vertex({corner.x, 0, corner.z}));
    back.push_back(mesh.add_vertex({corner.x, length, corner.z}));
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    patch[mesh.add_face(front[i], back[i], back[j], front[j])] = outline[i].patch;
  }
  patch[mesh.add_face(front)] = 0;
  patch[mesh.add_face(std::vector(back.rbegin(), back.rend()))] = 1;
  return mesh;
}

double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &p = outline[i], &q = outline[(i + 1) % outline.size()];
    sum += (p.x * q.z - p.z * q.x) / 2;
  }
  return sum;
}

bool is_along_y(const Direction& d) { return std::abs(d[1]) > 1 - 1e-9; }

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_directions)

// Swept upward, the hexahedra under a steep roof are as flat as it; along the arch they can be good. The whole stays
// conformal.
BOOST_AUTO_TEST_CASE(a_box_under_an_arch_is_swept_along_it) {
  for (double steepness : {40.0, 50.0, 57.0})
    for (bool is_mirrored : {false, true})
      for (double size : {0.5, 0.25})
        BOOST_TEST_CONTEXT(steepness << " degrees, mirrored " << is_mirrored << ", size " << size) {
          const Outline outline = arched_box_beside_tall_one(steepness, is_mirrored);
          const auto found = hex_checks::mesh(prism(outline), Direction{0, 0, 1}, size);
          hex_checks::expect_sound(found, length * area(outline), 0.02);
          const Hex_mesh& mesh = found.value();
          BOOST_TEST_REQUIRE(mesh.directions.size() == 2);
          BOOST_TEST(std::count_if(mesh.directions.begin(), mesh.directions.end(), is_along_y) == 1);
          const std::vector<double> quality = CCSweep::scaled_jacobians(mesh);
          BOOST_TEST(*std::min_element(quality.begin(), quality.end()) > std::cos(steepness * std::numbers::pi / 180));
        }
}

// Where one sweep suits all, it is that of all.
BOOST_AUTO_TEST_CASE(boxes_are_swept_together) {
  const Outline outline = low_box_beside_tall_one();
  const auto found = hex_checks::mesh(prism(outline), Direction{0, 0, 1}, 0.5);
  hex_checks::expect_sound(found, length * area(outline), 1e-9);
  BOOST_TEST(std::count_if(found.value().directions.begin(), found.value().directions.end(), is_along_y) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
