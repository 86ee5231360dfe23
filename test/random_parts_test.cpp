// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The generator of random parts is the oracle of other tests, so it is tested itself: its meshes are sound, and its
// answers are those counted by hand.
#include "random_parts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <boost/test/unit_test.hpp>
#include <sstream>

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using random_parts::Family;
using random_parts::Outline;
using random_parts::Part;
using random_parts::Plan;

constexpr double pi = 3.14159265358979323846;

Outline rectangle(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Outline circle(double x, double y, double radius, int n) {
  Outline result;
  for (int i = 0; i < n; ++i)
    result.push_back({x + radius * std::cos(2 * pi * (i + 0.5) / n), y + radius * std::sin(2 * pi * (i + 0.5) / n)});
  return result;
}

Plan slab() {
  Plan plan;
  plan.material = {{rectangle(0, 0, 20, 20)}};
  plan.bottom = 4;
  plan.top = 8;
  return plan;
}

void expect(const Plan& plan, std::size_t volumes, std::size_t sources, std::size_t sets) {
  const auto part = random_parts::build(plan);
  BOOST_REQUIRE(part.has_value());
  BOOST_TEST(part->sub_volumes.size() == volumes);
  BOOST_TEST(part->sources.size() == sources);
  BOOST_TEST(part->sets == sets);
}

// All faces of the part find their place, so the surface is a manifold; it is closed and encloses the volume.
Mesh sound_mesh(const Part& part) {
  const Mesh m = random_parts::mesh<Point>(part);
  BOOST_TEST(m.number_of_faces() == part.triangles.size());
  BOOST_TEST(CGAL::is_closed(m));
  BOOST_TEST(CGAL::Polygon_mesh_processing::volume(m) == part.volume, boost::test_tools::tolerance(1e-12));
  double sum = 0;
  for (const auto& [target, volume] : part.sub_volumes) sum += volume;
  BOOST_TEST(sum == part.volume, boost::test_tools::tolerance(1e-12));
  return m;
}

void expect_sound_patches(const Part& part, const Mesh& m) {
  std::map<int, Mesh::Face_index> first;
  for (std::size_t i = 0; i < part.triangles.size(); ++i) first.emplace(part.patch[i], Mesh::Face_index(i));
  for (const auto& [patch, start] : first) {
    std::set<Mesh::Face_index> reached{start};
    std::vector<Mesh::Face_index> todo{start};
    bool flat = true;
    const auto normal = CGAL::Polygon_mesh_processing::compute_face_normal(start, m);
    while (!todo.empty()) {
      const Mesh::Face_index f = todo.back();
      todo.pop_back();
      const auto n = CGAL::Polygon_mesh_processing::compute_face_normal(f, m);
      flat = flat && (n - normal).squared_length() < 1e-20;
      for (Mesh::Face_index g : faces_around_face(m.halfedge(f), m))
        if (part.patch[g] == patch && reached.insert(g).second) todo.push_back(g);
    }
    BOOST_TEST(flat != static_cast<bool>(part.curved.count(patch)));
    BOOST_TEST(reached.size() == static_cast<std::size_t>(std::count(part.patch.begin(), part.patch.end(), patch)));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(random_parts_test)

BOOST_AUTO_TEST_CASE(meshes_are_sound) {
  for (Family family : random_parts::families)
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
      const Part part = random_parts::make(family, seed);
      BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed) {
        const Mesh m = sound_mesh(part);
        BOOST_TEST(!CGAL::Polygon_mesh_processing::does_self_intersect(m));
        expect_sound_patches(part, m);
      }
    }
}

BOOST_AUTO_TEST_CASE(a_part_that_touches_itself_is_welded_by_fans) {
  Plan posts = slab();  // two posts that share an upright edge
  posts.tops = {{rectangle(4, 4, 8, 8), 12}, {rectangle(8, 8, 12, 12), 10}};
  const auto part = random_parts::build(posts);
  BOOST_REQUIRE(part.has_value());
  BOOST_TEST(part->touches_itself);
  sound_mesh(*part);
  // The lower post ends within the edge of the higher one, which has a vertex there too.
  const std::array<double, 3> contact{8, 8, 10};
  BOOST_TEST(std::count(part->points.begin(), part->points.end(), contact) == 2);
}

BOOST_AUTO_TEST_CASE(the_same_seed_gives_the_same_part) {
  const Part a = random_parts::make(Family::mixed, 5), b = random_parts::make(Family::mixed, 5);
  BOOST_TEST((a.points == b.points && a.triangles == b.triangles && a.patch == b.patch));
  BOOST_TEST((a.points != random_parts::make(Family::mixed, 6).points));
}

BOOST_AUTO_TEST_CASE(sets_of_simple_parts_are_those_counted_by_hand) {
  expect(slab(), 1, 1, 0);

  Plan leg = slab();
  leg.bottoms = {{rectangle(5, 5, 9, 9), 0}};
  expect(leg, 2, 1, 4);
  leg.tops = {{rectangle(5, 5, 9, 9), 12}};  // a post of the same outline
  expect(leg, 2, 2, 4);
  leg.tops = {{rectangle(5, 5, 13, 13), 12}};  // one that shares two sides and goes on beyond them
  expect(leg, 2, 2, 4);
  leg.tops = {{rectangle(7, 7, 13, 13), 12}};  // one over a corner: it crosses two sides
  expect(leg, 2, 2, 6);
  leg.tops = {{rectangle(0, 0, 7, 20), 12}};  // a step across
  expect(leg, 2, 2, 6);

  Plan corner = slab();
  corner.bottoms = {{rectangle(0, 0, 9, 9), 0}};
  expect(corner, 2, 1, 2);
}

BOOST_AUTO_TEST_CASE(closed_curves_count_once) {
  Plan round = slab();
  round.bottoms = {{circle(8, 8, 5, 40), 0}};
  expect(round, 2, 1, 1);
  round.tops = {{circle(9, 8, 2.5, 24), 12}};  // does not touch it
  expect(round, 2, 2, 1);
  round.tops = {{rectangle(0, 0, 8.25, 20), 12}};  // cuts it in two
  expect(round, 2, 2, 2);
  round.material.push_back({circle(8, 8, 3, 32), false});  // a ring
  expect(round, 2, 2, 2);
}

BOOST_AUTO_TEST_CASE(look_alikes_of_known_parts_have_their_counts) {
  Plan cylinder;  // split along x below and along y above
  cylinder.material = {{circle(0, 0, 5, 32)}};
  cylinder.bottom = 0;
  cylinder.top = 10;
  cylinder.bottoms = {{rectangle(-10, -10, 10, 0), 0, true}};
  cylinder.tops = {{rectangle(-10, -10, 0, 10), 10, true}};
  expect(cylinder, 2, 2, 2);

  Plan steps = slab();  // three below along x, two halves above, one of them in two levels along y
  steps.bottoms = {{rectangle(0, 0, 7, 20), 2}, {rectangle(7, 0, 13, 20), 3}};
  steps.tops = {{rectangle(0, 0, 20, 11), 10}, {rectangle(10, 0, 20, 11), 9}};
  expect(steps, 3, 3, 4);
}

BOOST_AUTO_TEST_CASE(what_does_not_meet_a_set_does_not_divide_it) {
  Plan window = slab();  // two strips below a window; the steps above the window are no matter of theirs
  window.bottoms = {{rectangle(0, 0, 9, 20), 3}};
  window.tops = {{rectangle(0, 0, 20, 9), 9}};
  expect(window, 2, 2, 2);
  window.windows = {{rectangle(4, 0, 16, 20), 5, 7}};
  // Below the window one; beside it the strips go up, each against the ceiling's sub-volume, divided by the step.
  expect(window, 3, 3, 1 + 4);
}

BOOST_AUTO_TEST_CASE(unsound_plans_are_refused) {
  Plan through = slab();
  through.bottoms = {{rectangle(4, 4, 8, 8), 9}};
  BOOST_TEST(!random_parts::build(through).has_value());
  Plan two = slab();
  two.material.push_back({rectangle(30, 0, 40, 10)});
  BOOST_TEST(!random_parts::build(two).has_value());
  Plan close = slab();
  close.bottoms = {{rectangle(4, 4, 8, 8), 2}};
  close.tops = {{rectangle(4.001, 4, 8, 8), 12}};
  BOOST_TEST(!random_parts::build(close).has_value());
}

BOOST_AUTO_TEST_CASE(a_written_part_has_all_its_lines) {
  const Part part = random_parts::make(Family::circles, 1);
  std::ostringstream out;
  random_parts::write_ply(part, out);
  const std::string text = out.str();
  BOOST_TEST(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) ==
             10 + part.points.size() + part.triangles.size());
}

BOOST_AUTO_TEST_SUITE_END()
