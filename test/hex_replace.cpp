// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// One sub-volume's mesh put in place of another, and the nodes that both must have.
#include <CCSweep/hex/Given_nodes.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/replace_volume.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/volumes/Decomposition.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "hex_checks.h"

namespace {

using CCSweep::Hex_mesh;
using CCSweep::internal::Given_nodes;
using CCSweep::internal::Vec3;
using CCSweep::internal::Volume_replacer;

constexpr std::uint32_t middle = 2;  // where the two sub-volumes meet
constexpr int cut = 102;            // the patch of a mesh that ends there
const std::set<int> cuts{cut};

// Bricks from one x to another, two abreast, those beyond the middle in a sub-volume of their own. The ends lie on the
// patches 100 + x, the sides on the patch 0.
Hex_mesh bricks(std::uint32_t from, std::uint32_t to) {
  Hex_mesh mesh;
  const auto node = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return ((x - from) * 3 + y) * 2 + z; };
  for (std::uint32_t x = from; x <= to; ++x)
    for (std::uint32_t y : {0, 1, 2})
      for (std::uint32_t z : {0, 1}) mesh.points.push_back({double(x), double(y), double(z)});
  for (std::uint32_t x = from; x < to; ++x)
    for (std::uint32_t y : {0, 1}) {
      mesh.hexes.push_back({node(x, y, 0), node(x + 1, y, 0), node(x + 1, y + 1, 0), node(x, y + 1, 0),
                            node(x, y, 1), node(x + 1, y, 1), node(x + 1, y + 1, 1), node(x, y + 1, 1)});
      mesh.volume.push_back(x < middle ? 0 : 1);
    }
  for (const auto& [key, quads] : hex_checks::faces_of(mesh)) {
    if (quads.size() != 1) continue;
    const auto x_of = [&](std::uint32_t n) { return static_cast<int>(mesh.points[n][0]); };
    const int low = x_of(key[0]), high = x_of(key[3]);
    mesh.boundary.push_back({quads[0], low == high ? 100 + low : 0, CCSweep::Role::linking,
                             high <= static_cast<int>(middle) && low < static_cast<int>(middle) ? 0 : 1});
  }
  mesh.targets = {7, 8};
  mesh.directions.assign(2, {0, 0, 1});
  mesh.bounds.resize(2);
  return mesh;
}

// What the second sub-volume may be replaced by.
Hex_mesh beyond_the_middle() {
  Hex_mesh mesh = bricks(middle, 4);
  mesh.directions.assign(2, {1, 0, 0});
  return mesh;
}

using Places = std::set<std::pair<std::vector<Vec3>, int>>;

// The hexahedra by their corners' places, with the index of their sub-volume.
Places places(const Hex_mesh& mesh) {
  Places found;
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h) {
    std::vector<Vec3> corners;
    for (std::uint32_t n : mesh.hexes[h]) corners.push_back(mesh.points[n]);
    found.emplace(corners, mesh.volume[h]);
  }
  return found;
}

// The boundary likewise, with the patches.
Places boundary_places(const Hex_mesh& mesh) {
  Places found;
  for (const auto& quad : mesh.boundary) {
    std::vector<Vec3> corners;
    for (std::uint32_t n : quad.nodes) corners.push_back(mesh.points[n]);
    std::sort(corners.begin(), corners.end());
    found.emplace(corners, quad.patch_id);
  }
  return found;
}

bool fits(const Hex_mesh& part) {
  const Hex_mesh whole = bricks(0, 4);
  return Volume_replacer(whole, 1, CCSweep::internal::shared_faces(whole, 1)).fits(part, cuts);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_replace)

BOOST_AUTO_TEST_CASE(shared_faces_are_those_on_the_cut) {
  const Hex_mesh whole = bricks(0, 4);
  for (int volume : {0, 1}) {
    const auto shared = CCSweep::internal::shared_faces(whole, volume);
    BOOST_TEST(shared.size() == 2);
    for (const auto& face : shared)
      for (std::uint32_t n : face) BOOST_TEST(whole.points[n][0] == middle);
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_replaces_itself) {
  const Hex_mesh whole = bricks(0, 4), part = beyond_the_middle();
  const Volume_replacer replacer(whole, 1, CCSweep::internal::shared_faces(whole, 1));
  BOOST_TEST_REQUIRE(replacer.fits(part, cuts));
  const Hex_mesh made = replacer.with(part, cuts);
  BOOST_TEST(hex_checks::defects(made) == "");
  BOOST_TEST(hex_checks::volume(made) == hex_checks::volume(whole));
  BOOST_TEST(made.points.size() == whole.points.size());
  BOOST_TEST((places(made) == places(whole)));
  BOOST_TEST((boundary_places(made) == boundary_places(whole)));
  BOOST_TEST(made.targets == whole.targets);
  BOOST_TEST((made.directions[0] == whole.directions[0]));
  BOOST_TEST((made.directions[1] == part.directions[0]));
}

// Away from the cut nothing has to agree.
BOOST_AUTO_TEST_CASE(a_longer_mesh_replaces_a_shorter_one) {
  const Hex_mesh whole = bricks(0, 3), part = beyond_the_middle();
  const Volume_replacer replacer(whole, 1, CCSweep::internal::shared_faces(whole, 1));
  BOOST_TEST_REQUIRE(replacer.fits(part, cuts));
  BOOST_TEST((places(replacer.with(part, cuts)) == places(bricks(0, 4))));
}

BOOST_AUTO_TEST_CASE(a_mesh_with_other_nodes_on_the_cut_does_not_fit) {
  Hex_mesh part = beyond_the_middle();
  BOOST_TEST(fits(part));
  part.points[0][1] = std::nextafter(part.points[0][1], 1);
  BOOST_TEST(!fits(part));
}

BOOST_AUTO_TEST_CASE(a_mesh_with_fewer_faces_on_the_cut_does_not_fit) {
  Hex_mesh part = beyond_the_middle();
  part.boundary.erase(std::find_if(part.boundary.begin(), part.boundary.end(),
                                   [](const auto& quad) { return quad.patch_id == cut; }));
  BOOST_TEST(!fits(part));
}

BOOST_AUTO_TEST_CASE(given_nodes_follow_the_sense_of_a_line) {
  const Given_nodes given({{2, 0, 1}, {0, 0, 1}, {1, 0, 1}, {1, 0, 2}, {1, 0.5, 1}}, {3}, {0, 0, 1}, 1e-6);
  const std::vector<Vec3> line{{0, 0, 1}, {1.5, 0, 1}, {2, 0, 1}}, expected{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}};
  BOOST_TEST((given.along(line) == expected));
  BOOST_TEST((given.along({line.rbegin(), line.rend()}) == std::vector<Vec3>(expected.rbegin(), expected.rend())));
  BOOST_TEST(given.are_on(3));
  BOOST_TEST(!given.are_on(4));
}

BOOST_AUTO_TEST_CASE(given_heights_merge_within_the_tolerance) {
  const Given_nodes given({{0, 0, 2}, {1, 0, 1 + 1e-8}, {0, 0, 1}, {5, 0, 2 - 1e-8}}, {}, {0, 0, 1}, 1e-6);
  BOOST_TEST(given.heights() == std::vector<double>({1, 2 - 1e-8}));
}

BOOST_AUTO_TEST_CASE(quads_between_rows) {
  const auto is_between = [](const Vec3& direction) {
    return CCSweep::internal::is_between_rows({{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}}, direction, 1e-6);
  };
  BOOST_TEST(is_between({0, 0, 1}));
  BOOST_TEST(is_between({1, 0, 0}));
  BOOST_TEST(!is_between({0, 1, 0}));
  BOOST_TEST(!is_between({0.6, 0, 0.8}));
}

BOOST_AUTO_TEST_SUITE_END()
