// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/hex/smooth_hexes.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

// Moving the nodes of bad hexahedra.
namespace {

using CCSweep::Hex_mesh;
using CCSweep::Patch_index;
using CCSweep::Role;
using CCSweep::internal::Vec3;

constexpr std::uint32_t width = 4, nodes_across = width + 1;

std::uint32_t node(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  return i + nodes_across * (j + nodes_across * k);
}

/// Four by four by four hexahedra between a floor, patch 0, a ceiling, patch 1, and four walls.
struct Block {
  Hex_mesh mesh;
  std::vector<Patch_index> patch;

  /// \param heights of the layers of nodes
  explicit Block(const std::array<double, nodes_across>& heights) {
    for (std::uint32_t k = 0; k <= width; ++k)
      for (std::uint32_t j = 0; j <= width; ++j)
        for (std::uint32_t i = 0; i <= width; ++i) mesh.points.push_back({double(i), double(j), heights[k]});
    for (std::uint32_t k = 0; k < width; ++k)
      for (std::uint32_t j = 0; j < width; ++j)
        for (std::uint32_t i = 0; i < width; ++i)
          mesh.hexes.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                                node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                                node(i, j + 1, k + 1)});
    for (std::uint32_t a = 0; a < width; ++a)
      for (std::uint32_t b = 0; b < width; ++b) {
        add({node(0, a, b), node(0, a, b + 1), node(0, a + 1, b + 1), node(0, a + 1, b)}, 2, Role::linking);
        add({node(width, a, b), node(width, a + 1, b), node(width, a + 1, b + 1), node(width, a, b + 1)}, 3,
            Role::linking);
        add({node(a, 0, b), node(a + 1, 0, b), node(a + 1, 0, b + 1), node(a, 0, b + 1)}, 4, Role::linking);
        add({node(a, width, b), node(a, width, b + 1), node(a + 1, width, b + 1), node(a + 1, width, b)}, 5,
            Role::linking);
      }
    for (std::uint32_t a = 0; a < width; ++a)
      for (std::uint32_t b = 0; b < width; ++b) {
        add({node(a, b, 0), node(a, b + 1, 0), node(a + 1, b + 1, 0), node(a + 1, b, 0)}, 0, Role::target);
        add({node(a, b, width), node(a + 1, b, width), node(a + 1, b + 1, width), node(a, b + 1, width)}, 1,
            Role::source);
      }
  }

  void add(const std::array<std::uint32_t, 4>& nodes, std::size_t p, Role role) {
    mesh.boundary.push_back({nodes, static_cast<int>(p), role, 0});
    patch.push_back(Patch_index(p));
  }

  void smooth() {
    const double floor = mesh.points.front()[2], ceiling = mesh.points.back()[2];
    const auto drop = [&](Patch_index cap, Vec3 p) {
      p[2] = cap == Patch_index(0) ? floor : ceiling;
      return p;
    };
    CCSweep::internal::Hex_smoother(mesh, patch, drop).run(0.5);
  }
};

double least_distance(const Hex_mesh& mesh) {
  using namespace CCSweep::internal;
  double least = 1e300;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      least = std::min(least, norm(mesh.points[i] - mesh.points[j]));
  return least;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_smoother)

BOOST_AUTO_TEST_CASE(nodes_where_caps_meet_walls_stay) {
  Block block({0, 1, 2, 3, 4});
  for (std::uint32_t k = 0; k <= width; ++k) block.mesh.points[node(1, 0, k)] = {0.3, 0.9, double(k)};
  const auto before = block.mesh.points;
  block.smooth();
  for (std::uint32_t k = 0; k <= width; ++k)
    for (std::uint32_t j = 0; j <= width; ++j)
      for (std::uint32_t i = 0; i <= width; ++i)
        if (i == 0 || i == width || j == 0 || j == width)
          BOOST_TEST((before[node(i, j, k)] == block.mesh.points[node(i, j, k)]));
}

BOOST_AUTO_TEST_CASE(no_node_runs_into_its_neighbour) {
  std::mt19937 random(1);
  const auto shift = [&] { return 0.6 * (double(random()) / double(std::mt19937::max()) - 0.5); };
  for (int i = 0; i < 20; ++i) {
    Block block({0, 0.01, 0.02, 1, 1.01});
    for (auto& p : block.mesh.points)
      for (int axis : {0, 1}) p[axis] += shift();
    const double before = least_distance(block.mesh);
    block.smooth();
    BOOST_TEST(least_distance(block.mesh) > before / 16);
  }
}

BOOST_AUTO_TEST_SUITE_END()
