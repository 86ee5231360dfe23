// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the angles of a part allow its hexahedra, and directions that suit a part or a sub-volume better than the first.
#include <CCSweep/hex/angle_bound.h>
#include <CCSweep/hex/quality.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "hex_checks.h"

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using CCSweep::Hex_mesh;
using CCSweep::internal::Vec3;
using hex_checks::expect_sound;

constexpr double degree = std::numbers::pi / 180;

double least_quality(const Hex_mesh& mesh) {
  const auto quality = CCSweep::scaled_jacobians(mesh);
  return *std::min_element(quality.begin(), quality.end());
}

// At the corner of a flat target, of an angle, with a wall over its first edge at a slope.
CCSweep::Angle_bound bound_of(double angle, double slope) {
  const CCSweep::internal::Outline_corner corner{
      {0, 0, 0},
      {2 * std::cos(angle * degree), 2 * std::sin(angle * degree), 0},
      {1, 0, 0},
      Vec3{0, std::cos(slope * degree), std::sin(slope * degree)}};
  const auto stay = [](const Vec3& p) { return p; };
  return CCSweep::internal::angle_bound(corner, CCSweep::internal::Plane_chart({0, 0, 1}), stay, false);
}

Mesh mesh_with_patches() {
  Mesh mesh;
  mesh.add_property_map<Mesh::Face_index, int>("f:patch_id", -1);
  return mesh;
}

void add_triangle(Mesh& mesh, Mesh::Vertex_index a, Mesh::Vertex_index b, Mesh::Vertex_index c, int patch) {
  mesh.property_map<Mesh::Face_index, int>("f:patch_id").first[mesh.add_face(a, b, c)] = patch;
}

// A prism of height 2 over a convex polygon.
Mesh prism(const std::vector<std::array<double, 2>>& outline) {
  Mesh mesh = mesh_with_patches();
  std::vector<Mesh::Vertex_index> low, high;
  for (const auto& [x, y] : outline) {
    low.push_back(mesh.add_vertex({x, y, 0}));
    high.push_back(mesh.add_vertex({x, y, 2}));
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    const int wall = static_cast<int>(i) + 2;
    add_triangle(mesh, low[i], low[j], high[j], wall);
    add_triangle(mesh, low[i], high[j], high[i], wall);
    if (i == 0 || j == 0) continue;
    add_triangle(mesh, low[0], low[j], low[i], 0);
    add_triangle(mesh, high[0], high[i], high[j], 1);
  }
  return mesh;
}

// Blocks on a grid of planes: those that are filled, with a patch for each plane and sense.
struct Blocks {
  std::array<std::vector<double>, 3> planes;
  std::function<bool(std::array<double, 3>)> is_filled;  // at a place inside a block
  std::map<std::array<double, 3>, int> patch;            // by axis, sense and plane

  Mesh mesh() {
    Mesh result = mesh_with_patches();
    std::map<std::array<double, 3>, Mesh::Vertex_index> vertex;
    const auto at = [&](const std::array<double, 3>& p) {
      const auto [found, is_new] = vertex.try_emplace(p);
      if (is_new) found->second = result.add_vertex({p[0], p[1], p[2]});
      return found->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (std::size_t i = 0; i < planes[axis].size(); ++i)
        for (std::size_t j = 0; j + 1 < planes[u].size(); ++j)
          for (std::size_t k = 0; k + 1 < planes[v].size(); ++k) {
            const bool below = filled(axis, double(i) - 0.5, j, k), above = filled(axis, double(i) + 0.5, j, k);
            if (below == above) continue;
            const auto corner = [&](std::size_t a, std::size_t b) {
              std::array<double, 3> p{};
              p[axis] = planes[axis][i];
              p[u] = planes[u][a];
              p[v] = planes[v][b];
              return at(p);
            };
            auto a = corner(j, k), b = corner(j + 1, k), c = corner(j + 1, k + 1), d = corner(j, k + 1);
            if (above) std::swap(b, d);
            const std::array<double, 3> key{double(axis), above ? -1.0 : 1.0, planes[axis][i]};
            const int id = patch.try_emplace(key, static_cast<int>(patch.size())).first->second;
            add_triangle(result, a, b, c, id);
            add_triangle(result, a, c, d, id);
          }
    }
    return result;
  }

 private:
  bool filled(std::size_t axis, double i, std::size_t j, std::size_t k) const {
    if (i < 0 || i > double(planes[axis].size() - 1)) return false;
    const auto middle = [&](std::size_t a, std::size_t n) { return (planes[a][n] + planes[a][n + 1]) / 2; };
    std::array<double, 3> p{};
    p[axis] = middle(axis, static_cast<std::size_t>(i));
    p[(axis + 1) % 3] = middle((axis + 1) % 3, j);
    p[(axis + 2) % 3] = middle((axis + 2) % 3, k);
    return is_filled(p);
  }
};

bool is_within(double x, double low, double high) { return low < x && x < high; }

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_angles)

BOOST_AUTO_TEST_CASE(hexahedra_share_the_angle_of_a_corner) {
  const std::map<double, double> allowed{{9, std::sin(9 * degree)},    {90, 1},  {120, std::sin(60 * degree)},
                                         {150, std::sin(75 * degree)}, {180, 1}, {270, 1}, {359.9, 1}};
  for (const auto& [angle, most] : allowed) {
    BOOST_TEST(std::abs(bound_of(angle, 90).scaled_jacobian - most) < 1e-6, "at " << angle << " degrees");
    BOOST_TEST(std::abs(bound_of(angle, 90).angle - angle) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(walls_that_lean_allow_no_more_than_the_sine_of_their_slope) {
  for (double slope : {10.0, 45.0, 80.0, 100.0})
    for (double angle : {90.0, 180.0}) {
      const CCSweep::Angle_bound bound = bound_of(angle, slope);
      BOOST_TEST(std::abs(bound.scaled_jacobian - std::sin(slope * degree)) < 1e-9);
      BOOST_TEST(std::abs(std::sin(bound.slope * degree) - std::sin(slope * degree)) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_sharp_corner_is_named_and_used_up) {
  const double tip = 9 * degree, x = 10 * std::cos(tip / 2), y = 10 * std::sin(tip / 2);
  const Mesh part = prism({{0, 0}, {x, -y}, {x + 1, 0}, {x, y}});
  const auto found = hex_checks::mesh(part, {0, 0, 1}, 0.5);
  expect_sound(found, hex_checks::volume_within(part), 1e-6);
  const CCSweep::Angle_bound bound = tightest_bound(found.value());
  BOOST_TEST(std::abs(bound.scaled_jacobian - std::sin(tip)) < 1e-9);
  BOOST_TEST(std::abs(bound.angle - 9) < 1e-9);
  BOOST_TEST(bound.place[0] == 0);
  BOOST_TEST((bound.patch_id == 0 || bound.patch_id == 1));
  BOOST_TEST(least_quality(found.value()) <= bound.scaled_jacobian + 1e-9);
  BOOST_TEST(least_quality(found.value()) > 0.9 * bound.scaled_jacobian);
}

BOOST_AUTO_TEST_CASE(nothing_is_in_the_way_of_a_brick) {
  const auto found = hex_checks::mesh(prism({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), {0, 0, 1}, 1);
  BOOST_TEST(tightest_bound(found.value()).scaled_jacobian > 1 - 1e-9);
}

// Bosses above and below whose outlines lie 0.02 apart: swept along the bosses, edges of 2 stand beside edges of 0.02.
BOOST_AUTO_TEST_CASE(a_part_is_swept_in_another_direction_where_the_first_gives_bad_hexahedra) {
  const std::vector<double> across{0, 5, 5.02, 15, 15.02, 20};
  Blocks blocks{{across, across, {-4, 0, 5, 9}}, [](const auto& p) {
                  const bool above = is_within(p[0], 5, 15) && is_within(p[1], 5, 15);
                  const bool below = is_within(p[0], 5.02, 15.02) && is_within(p[1], 5.02, 15.02);
                  return is_within(p[2], 0, 5) || (p[2] > 0 ? above : below);
                },
                {}};
  const Mesh part = blocks.mesh();
  const auto along_bosses = hex_checks::mesh(part, {0, 0, 1}, 2);
  const auto found = hex_checks::mesh(part, {}, 2);
  expect_sound(found, hex_checks::volume_within(part), 1e-6);
  BOOST_TEST(least_quality(found.value()) > 0.2);
  if (along_bosses) BOOST_TEST(least_quality(found.value()) > least_quality(along_bosses.value()));
}

// A boss on a boss, 0.02 smaller on two sides: one target, three sources.
BOOST_AUTO_TEST_CASE(a_sub_volume_is_swept_in_the_direction_that_suits_it) {
  const std::vector<double> across{0, 5, 5.02, 15, 20};
  Blocks blocks{{across, across, {0, 5, 9, 12}}, [](const auto& p) {
                  const double low = p[2] > 9 ? 5.02 : 5;
                  return p[2] < 5 || (is_within(p[0], low, 15) && is_within(p[1], low, 15));
                },
                {}};
  CCSweep::Sub_volume<Point> volume{blocks.mesh(), -1, {}};
  const auto cap = [&](double sense, double height) { return blocks.patch.at({2, sense, height}); };
  volume.target = cap(-1, 0);
  for (double height : {5, 9, 12}) volume.sources.push_back(cap(1, height));
  std::sort(volume.sources.begin(), volume.sources.end());
  auto role = volume.mesh.add_property_map<Mesh::Face_index, int>("f:role", 0).first;
  const auto patch = volume.mesh.property_map<Mesh::Face_index, int>("f:patch_id").first;
  for (auto f : volume.mesh.faces()) role[f] = static_cast<int>(patch[f] == volume.target ? CCSweep::Role::target
                                                                                           : CCSweep::Role::linking);
  const auto own = hex_checks::mesh(volume.mesh, {0, 0, 1}, 2);
  const auto found = hex_checks::mesh(volume, 2);
  expect_sound(found, hex_checks::volume_within(volume.mesh), 1e-6);
  BOOST_TEST(least_quality(found.value()) > 0.2);
  if (own) BOOST_TEST(least_quality(found.value()) > least_quality(own.value()));
}

BOOST_AUTO_TEST_SUITE_END()
