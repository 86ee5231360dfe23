// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of intervals and plane quad meshes, each by itself.
#include <CCSweep/hex/Interval_problem.h>
#include <CCSweep/hex/Parity_intervals.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex/plane.h>
#include <CCSweep/hex/sizing.h>
#ifdef CGAL_USE_GLPK
#include <CCSweep/hex/Glpk_intervals.h>
#endif

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace {

using CCSweep::Interval_problem;
using CCSweep::Intervals;
using CCSweep::Quad_mesh;
using CCSweep::Quad_region;
using Point = Quad_region::Point;

static_assert(CCSweep::IntervalSolver<CCSweep::Parity_intervals>);
static_assert(CCSweep::QuadMesher<CCSweep::Best_quads>);
static_assert(CCSweep::SizingField<CCSweep::Patch_sizes>);

// The cheapest solution with no number above a bound, by looking at all.
std::optional<double> least_cost(const Interval_problem& problem, std::size_t bound) {
  std::optional<double> best;
  Intervals now(problem.least);
  for (std::size_t i = 0; i < now.size();) {
    if (CCSweep::is_solution(problem, now))
      if (const double c = CCSweep::cost(problem, now); !best || c < *best) best = c;
    for (i = 0; i < now.size() && ++now[i] > bound; ++i) now[i] = problem.least[i];
  }
  return best;
}

// A few curves with sides that must agree and outlines that must be even; the number of one may be given.
Interval_problem random_problem(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](std::uint32_t n) { return random() % n; };
  Interval_problem problem;
  for (std::size_t i = 0; i < 6; ++i) {
    problem.wanted.push_back(0.5 + below(60) / 10.0);
    problem.least.push_back(1 + below(2));
  }
  for (std::uint32_t row = 0, rows = below(3); row < rows; ++row)
    problem.equal.push_back({{row, 1}, {row + 2, -1}, {row + 3, below(2) == 0 ? 1 : -1}});
  for (std::size_t row = 0; row < 3; ++row) {
    Interval_problem::Row terms;
    for (std::size_t i = 0; i < 6; ++i)
      if (below(2) == 0) terms.push_back({i, 1});
    problem.even.push_back(terms);
  }
  if (const std::uint32_t i = below(12); i < 6) {
    problem.given.assign(6, false);
    problem.given[i] = true;
    problem.wanted[i] = std::round(problem.wanted[i]) + 1;
  }
  return problem;
}

template <class Solver>
void expect_best(const Solver& solver) {
  constexpr std::size_t bound = 12;
  for (std::uint32_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed) {
      const Interval_problem problem = random_problem(seed);
      const auto best = least_cost(problem, bound);
      if (!best) continue;
      const auto found = solver(problem);
      BOOST_TEST(found.has_value());
      if (!found) continue;
      BOOST_TEST(CCSweep::is_solution(problem, *found));
      BOOST_TEST(CCSweep::cost(problem, *found) < *best + 1e-6);
    }
}

// A polygon with nodes at a distance along its sides.
Quad_region::Loop polygon(const std::vector<Point>& corners, double step) {
  Quad_region::Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const int n = std::max(1, static_cast<int>(std::lround(std::hypot(b[0] - a[0], b[1] - a[1]) / step)));
    for (int k = 0; k < n; ++k)
      loop.nodes.push_back({a[0] + (b[0] - a[0]) * k / n, a[1] + (b[1] - a[1]) * k / n});
  }
  return loop;
}

std::vector<Point> circle(double radius, int n, bool clockwise) {
  std::vector<Point> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n * (clockwise ? -1 : 1);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return corners;
}

// Quads only that turn one way, cover the region, and have its loops as their border.
void expect_covers(const Quad_region& region, const std::optional<Quad_mesh>& mesh, double least = 0) {
  BOOST_TEST_REQUIRE(mesh.has_value());
  double area = 0, wanted = 0;
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& quad : mesh->quads) {
    std::vector<Point> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      corners.push_back(mesh->points[quad[i]]);
      BOOST_TEST((++sides[{quad[i], quad[(i + 1) % 4]}] == 1));
    }
    area += CCSweep::internal::signed_area(corners);
  }
  for (const auto& loop : region.loops) wanted += CCSweep::internal::signed_area(loop.nodes);
  BOOST_TEST(std::abs(area - wanted) < 1e-9 * wanted);
  BOOST_TEST(CCSweep::worst_quality(*mesh) > least);
  std::size_t border = 0;
  for (const auto& [side, count] : sides) border += sides.count({side[1], side[0]}) == 0;
  BOOST_TEST(border == CCSweep::number_of_nodes(region));
  std::size_t n = 0;
  for (const auto& loop : region.loops)
    for (const Point& p : loop.nodes) BOOST_TEST((mesh->points[n++] == p));
}

Quad_region plate_with_hole() {
  Quad_region region;
  region.loops = {polygon({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, 1), polygon(circle(2, 14, true), 2)};
  return region;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_quads)

BOOST_AUTO_TEST_CASE(intervals_are_the_best_for_few_curves) { expect_best(CCSweep::Parity_intervals()); }

#ifdef CGAL_USE_GLPK
BOOST_AUTO_TEST_CASE(intervals_by_glpk_are_the_best) { expect_best(CCSweep::Glpk_intervals()); }
#endif

BOOST_AUTO_TEST_CASE(contradicting_intervals_have_no_solution) {
  // a = b and a = 2 b.
  const Interval_problem problem{{3, 3}, {1, 1}, {{{0, 1}, {1, -1}}, {{0, 1}, {1, -2}}}, {}};
  BOOST_TEST(!CCSweep::Parity_intervals()(problem).has_value());
}

BOOST_AUTO_TEST_CASE(many_intervals_hold_all_rows) {
  // A long row of quadrangles: each shares a side with the next one.
  Interval_problem problem;
  constexpr std::size_t count = 200;
  for (std::size_t i = 0; i < 3 * count; ++i) {
    problem.wanted.push_back(1 + double(i * 7 % 11));
    problem.least.push_back(1);
  }
  for (std::size_t i = 0; i + 1 < count; ++i) {
    problem.equal.push_back({{3 * i, 1}, {3 * i + 3, -1}});
    problem.even.push_back({{3 * i + 1, 1}, {3 * i + 2, 1}});
  }
  const auto found = CCSweep::Parity_intervals()(problem);
  BOOST_TEST_REQUIRE(found.has_value());
  BOOST_TEST(CCSweep::is_solution(problem, *found));
}

BOOST_AUTO_TEST_CASE(a_plate_with_a_hole) {
  const Quad_region region = plate_with_hole();
  expect_covers(region, CCSweep::Matched_quads()(region, 1), 0.3);
  expect_covers(region, CCSweep::Subdivided_quads()(region, 1), 0.2);
  expect_covers(region, CCSweep::Best_quads()(region, 1), 0.3);
  BOOST_TEST(!CCSweep::Structured_quads()(region, 1).has_value());
}

BOOST_AUTO_TEST_CASE(an_l_is_structured) {
  Quad_region region;
  region.loops = {polygon({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 5}, {0, 5}}, 0.5)};
  region.loops[0].corners = {0, 8, 12, 22, 26};
  region.loops[0].reflex = {16};
  const auto mesh = CCSweep::Structured_quads()(region, 0.5);
  expect_covers(region, mesh, 0.7);
  BOOST_TEST(mesh->quads.size() == 56);
}

BOOST_AUTO_TEST_CASE(an_outline_that_does_not_close_on_the_grid_is_not_structured) {
  Quad_region region;
  region.loops = {polygon({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 5}, {0, 5}}, 0.5)};
  region.loops[0].nodes.erase(region.loops[0].nodes.begin() + 1);
  region.loops[0].corners = {0, 7, 11, 21, 25};
  region.loops[0].reflex = {15};
  BOOST_TEST(!CCSweep::Structured_quads()(region, 0.5).has_value());
}

BOOST_AUTO_TEST_CASE(a_loop_of_odd_nodes_can_be_matched_with_another) {
  Quad_region region;
  region.loops = {polygon(circle(5, 25, false), 10), polygon(circle(2, 11, true), 10)};
  expect_covers(region, CCSweep::Matched_quads()(region, 1.2), 0.2);
  BOOST_TEST(!CCSweep::Subdivided_quads()(region, 1.2).has_value());
}

// A triangle that is left over stays so however often it is split itself.
BOOST_AUTO_TEST_CASE(triangles_left_over_get_partners) {
  for (const auto& [outer, inner] : {std::pair(25, 11), std::pair(19, 7), std::pair(34, 10)}) {
    Quad_region region;
    region.loops = {polygon(circle(5, outer, false), 10), polygon(circle(2, inner, true), 10)};
    expect_covers(region, CCSweep::Matched_quads()(region, 1.2));
  }
}

BOOST_AUTO_TEST_CASE(outlines_that_cross_themselves_are_refused) {
  Quad_region region;
  region.loops = {polygon({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, 1)};
  BOOST_TEST(!CCSweep::Best_quads()(region, 1).has_value());
}

BOOST_AUTO_TEST_CASE(the_smallest_size_counts) {
  CCSweep::Patch_sizes sizes(4);
  sizes.patch(7, 2).curve(7, 3, 0.5);
  BOOST_TEST(CCSweep::size_between(sizes, {3}) == 4);
  BOOST_TEST(CCSweep::size_between(sizes, {7}) == 2);
  BOOST_TEST(CCSweep::size_between(sizes, {3, 7}) == 0.5);
  BOOST_TEST(CCSweep::size_between(sizes, {1, 7}) == 2);
  BOOST_TEST(sizes.are_valid());
  BOOST_TEST(!sizes.patch(1, std::numeric_limits<double>::quiet_NaN()).are_valid());
}

BOOST_AUTO_TEST_SUITE_END()
