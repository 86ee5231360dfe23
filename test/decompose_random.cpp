// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Random parts whose answer is known from the column picture: all are decomposed, and none is wrong.
#include <CCSweep/linking/Layering.h>
#include <CCSweep/verify.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/test/unit_test.hpp>

#include "bent_parts.h"
#include "decompose_runs.h"
#include "random_parts.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using random_parts::Family;
using random_parts::Part;

constexpr std::uint32_t seeds = 40;  // of each family
constexpr std::uint32_t seeds_moved = 5;

// As for a user who names nothing but the direction.
auto decomposed(const Mesh& mesh, const std::array<double, 3>& direction) {
  return decompose_runs::decompose(
      mesh, {.direction = direction, .spanning_angle = CCSweep::Layering_options().spanning_angle});
}

void expect_decomposed(const Part& part, const std::array<double, 3>& direction) {
  const Mesh mesh = random_parts::mesh<Kernel::Point_3>(part);
  const auto patch = mesh.property_map<Mesh::Face_index, int>("f:patch_id").first;
  const auto result = decomposed(mesh, direction);
  BOOST_TEST(result.ok(), name(result.status().code) << ": " << result.status().reason);
  if (!result.ok()) return;
  const auto& found = result.value();
  BOOST_TEST(found.volumes.size() == part.sub_volumes.size());
  BOOST_TEST(found.sets.size() == part.sets);
  for (const auto& volume : found.volumes) {
    const auto expected = part.sub_volumes.find(volume.target);
    BOOST_TEST((expected != part.sub_volumes.end()));
    if (expected == part.sub_volumes.end()) continue;
    BOOST_TEST(std::abs(decompose_runs::volume(volume.mesh) - expected->second) < 1e-8 * part.volume);
  }
  for (const auto& [id, role] : found.roles)
    BOOST_TEST((role == CCSweep::Role::source) == static_cast<bool>(part.sources.count(id)));
  const CCSweep::Status status = CCSweep::verify(mesh, patch, found);
  BOOST_TEST(status.ok(), status.reason);
}

void expect_family_decomposed(Family family) {
  for (std::uint32_t seed = 0; seed < seeds; ++seed)
    BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed)
  expect_decomposed(random_parts::make(family, seed), {0, 0, 1});
}

// Volumes change under most maps; how many there are, and how many sets, must not.
void expect_counts(const Part& part, std::size_t volumes, std::size_t sets, const std::array<double, 3>& direction) {
  const Mesh mesh = random_parts::mesh<Kernel::Point_3>(part);
  const auto result = decomposed(mesh, direction);
  BOOST_TEST(result.ok(), name(result.status().code) << ": " << result.status().reason);
  if (!result.ok()) return;
  BOOST_TEST(result.value().volumes.size() == volumes);
  BOOST_TEST(result.value().sets.size() == sets);
}

template <class Check>
void for_each_part(const Check& check) {
  for (Family family : random_parts::families)
    for (std::uint32_t seed = 0; seed < seeds_moved; ++seed)
      BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed)
    check(random_parts::make(family, seed));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(decompose_random)

BOOST_AUTO_TEST_CASE(leaning_walls_carry_targets_along) {
  for_each_part([](const Part& part) {
    expect_decomposed(random_parts::moved(part,
                                          [](std::array<double, 3> p) {
                                            return std::array<double, 3>{p[0] + 0.3 * p[2], p[1] - 0.2 * p[2], p[2]};
                                          }),
                      {0, 0, 1});
  });
}

BOOST_AUTO_TEST_CASE(tapered_walls_match_through_the_affine_map) {
  for_each_part([](const Part& part) {
    const Part tapered = random_parts::moved(part, [](std::array<double, 3> p) {
      const double k = 1 - 0.02 * p[2];
      return std::array<double, 3>{12 + (p[0] - 12) * k, 12 + (p[1] - 12) * k, p[2]};
    });
    expect_counts(tapered, part.sub_volumes.size(), part.sets, {0, 0, 1});
  });
}

BOOST_AUTO_TEST_CASE(caps_at_a_slant) {
  for_each_part([](const Part& part) {
    const Part slanted = random_parts::moved(part, [](std::array<double, 3> p) {
      return std::array<double, 3>{p[0], p[1], p[2] + 0.2 * p[0] + 0.1 * p[1]};
    });
    expect_counts(slanted, part.sub_volumes.size(), part.sets, {0, 0, 1});
  });
}

BOOST_AUTO_TEST_CASE(rods_that_bend) {
  constexpr double degree = 3.14159265358979323846 / 180;
  for (double angle : {90., 270.})
    BOOST_TEST_CONTEXT("bent by " << angle)
  expect_counts(bent_parts::rod(angle * degree, 24, 1), 2, 2, {0, 1, 0});
}

BOOST_AUTO_TEST_CASE(grids) { expect_family_decomposed(Family::grids); }
BOOST_AUTO_TEST_CASE(barrels) { expect_family_decomposed(Family::barrels); }
BOOST_AUTO_TEST_CASE(polygons) { expect_family_decomposed(Family::polygons); }
BOOST_AUTO_TEST_CASE(circles) { expect_family_decomposed(Family::circles); }
BOOST_AUTO_TEST_CASE(mixed) { expect_family_decomposed(Family::mixed); }
BOOST_AUTO_TEST_CASE(split) { expect_family_decomposed(Family::split); }
BOOST_AUTO_TEST_CASE(windows) { expect_family_decomposed(Family::windows); }

BOOST_AUTO_TEST_CASE(grids_that_touch_themselves) {
  for (std::uint32_t seed = 200; seed < 200 + seeds; ++seed) BOOST_TEST_CONTEXT("seed " << seed)
  expect_decomposed(random_parts::make(Family::grids, seed, true), {0, 0, 1});
}

BOOST_AUTO_TEST_CASE(turned_tiny_and_far_parts) {
  for (Family family : random_parts::families)
    for (std::uint32_t seed = 100; seed < 100 + seeds_moved; ++seed) {
      const Part part = random_parts::make(family, seed);
      BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed << " turned")
      expect_decomposed(random_parts::placed(part, true, 1, {1, 2, 3}), random_parts::turned({0, 0, 1}));
      BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed << " tiny")
      expect_decomposed(random_parts::placed(part, false, 1e-3 / 24, {0, 0, 0}), {0, 0, 1});
      BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed << " far")
      expect_decomposed(random_parts::placed(part, false, 1, {1e6, -1e6, 1e6}), {0, 0, 1});
    }
}

BOOST_AUTO_TEST_SUITE_END()
