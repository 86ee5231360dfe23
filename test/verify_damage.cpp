// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every promise is broken in turn, and the check must say which.
#include <CCSweep/verify.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "verify_fixture.h"

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Decomposition = CCSweep::Decomposition<Point>;
using Step = verify_fixture::Step<Point>;
using Soup = verify_fixture::Soup<Point>;
using CCSweep::Role;

CCSweep::Status verified(const Step& step, const Decomposition& result) {
  const Soup::Mesh input = step.input.mesh();
  return CCSweep::verify(input, input.property_map<Soup::Mesh::Face_index, int>("f:patch_id").first, result);
}

void rejected(const CCSweep::Status& status, const std::string& word) {
  BOOST_TEST(!status.ok());
  BOOST_TEST((status.code == CCSweep::Status_code::verification_failed));
  BOOST_TEST((status.stage == CCSweep::Stage::verification));
  BOOST_TEST(status.reason.find(word) != std::string::npos, "'" << status.reason << "' should say '" << word << "'");
}

// Damage to the triangles, then to the rest of the result.
template <class Damage>
void soup_rejected(Damage damage, const std::string& word) {
  Step step;
  damage(step);
  rejected(verified(step, step.decomposition()), word);
}

template <class Damage>
void result_rejected(Damage damage, const std::string& word) {
  Step step;
  Decomposition result = step.decomposition();
  damage(result);
  rejected(verified(step, result), word);
}

std::size_t first_of(const Soup& soup, int patch) {
  for (std::size_t t = 0; t < soup.patch.size(); ++t)
    if (soup.patch[t] == patch) return t;
  return soup.patch.size();
}

void move(Soup& soup, const Point& from, const Point& to) {
  soup.points[soup.vertex(from.x(), from.y(), from.z())] = to;
}

// Replaces the first triangle of a patch by three that meet in a new vertex.
void raise(Soup& soup, int patch, const Point& apex) {
  const std::size_t t = first_of(soup, patch), v = soup.points.size();
  const auto [a, b, c] = soup.triangles[t];
  soup.points.push_back(apex);
  soup.triangles[t] = {a, b, v};
  soup.triangle({b, c, v}, patch, static_cast<Role>(soup.role[t]));
  soup.triangle({c, a, v}, patch, static_cast<Role>(soup.role[t]));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(verify_damage)

BOOST_AUTO_TEST_CASE(the_undamaged_step_is_accepted) {
  const Step step;
  const CCSweep::Status status = verified(step, step.decomposition());
  BOOST_TEST(status.ok(), status.reason);
}

BOOST_AUTO_TEST_CASE(surfaces_must_be_closed_manifolds) {
  soup_rejected([](Step& s) { s.volumes[0].triangles.pop_back(); }, "not closed");
  soup_rejected([](Step& s) { std::swap(s.volumes[1].triangles[0][0], s.volumes[1].triangles[0][1]); }, "not closed");
  soup_rejected(
      [](Step& s) {
        Soup& v = s.volumes[0];
        v.triangle(v.triangles[0], v.patch[0], static_cast<Role>(v.role[0]));
      },
      "not closed");
  soup_rejected([](Step& s) { move(s.volumes[0], Point(0, 0, 0), Point(0, 0, 2)); }, "without area");
  soup_rejected([](Step& s) { s.volumes[1].points[0] = Point(std::nan(""), 0, 0); }, "not finite");
}

BOOST_AUTO_TEST_CASE(a_second_surface_is_refused) {
  soup_rejected(
      [](Step& s) {  // a small tetrahedron beside the sub-volume
        Soup& v = s.volumes[0];
        const std::size_t a = v.points.size();
        for (const Point& p : {Point(5, 0, 0), Point(6, 0, 0), Point(5, 1, 0), Point(5, 0, 1)}) v.points.push_back(p);
        for (std::array<std::size_t, 3> t :
             {std::array<std::size_t, 3>{a, a + 2, a + 1}, {a, a + 1, a + 3}, {a, a + 3, a + 2}, {a + 1, a + 2, a + 3}})
          v.triangle(t, 3, Role::linking);
      },
      "separate surfaces");
}

BOOST_AUTO_TEST_CASE(surfaces_must_look_outward) {
  soup_rejected(
      [](Step& s) {
        for (Soup* v : {&s.volumes[0], &s.volumes[1]})
          for (auto& t : v->triangles) std::swap(t[0], t[1]);
      },
      "inside out");
}

BOOST_AUTO_TEST_CASE(self_intersection_is_found) {
  soup_rejected(
      [](Step& s) {  // the cut is drawn out through the wall at x = 0, on both sides alike
        for (Soup* v : {&s.volumes[0], &s.volumes[1]}) raise(*v, 8, Point(-0.5, 0.5, 1.5));
        s.result.sets[0].triangles = 4;
      },
      "intersects itself");
}

BOOST_AUTO_TEST_CASE(a_curved_cut_is_no_defect) {
  Step step;
  for (Soup* v : {&step.volumes[0], &step.volumes[1]}) raise(*v, 8, Point(0.75, 0.75, 1.5));
  step.result.sets[0].triangles = 4;
  const CCSweep::Status status = verified(step, step.decomposition());
  BOOST_TEST(status.ok(), status.reason);
}

BOOST_AUTO_TEST_CASE(cuts_must_agree_bit_for_bit) {
  const double ulp = std::numeric_limits<double>::epsilon();
  soup_rejected([&](Step& s) { move(s.volumes[0], Point(1, 1, 2), Point(1, 1 - ulp / 2, 2)); }, "no counterpart");
  soup_rejected([](Step& s) { move(s.volumes[1], Point(1, 0, 2), Point(1, -0.0, 2)); }, "-0");
  soup_rejected(
      [](Step& s) {  // the other diagonal on one side
        const std::size_t t = first_of(s.volumes[0], 8);
        auto& list = s.volumes[0].triangles;
        const auto a = list[t], b = list[t + 1];
        list[t] = {a[0], a[1], b[2]};
        list[t + 1] = {a[1], a[2], b[2]};
      },
      "no counterpart");
  soup_rejected([](Step& s) { s.volumes[0].patch[first_of(s.volumes[0], 8)] = 9; }, "different ids");
  soup_rejected(
      [](Step& s) {
        for (Soup& v : s.volumes)
          for (std::size_t t = 0; t < v.patch.size(); ++t)
            if (v.patch[t] == 8) v.patch[t] = 4, v.role[t] = 0;
      },
      "two sub-volumes");
}

BOOST_AUTO_TEST_CASE(ids_must_be_those_of_the_input) {
  soup_rejected([](Step& s) { s.volumes[1].patch[first_of(s.volumes[1], 5)] = 3; }, "patches");
  soup_rejected([](Step& s) { s.volumes[0].patch[first_of(s.volumes[0], 3)] = 77; }, "role");
  soup_rejected(
      [](Step& s) {
        const std::size_t t = first_of(s.volumes[0], 3);
        s.volumes[0].patch[t] = 77, s.volumes[0].role[t] = 3;
      },
      "no counterpart");
  soup_rejected(
      [](Step& s) {  // a patch id exchanged throughout
        for (Soup& v : s.volumes)
          for (int& p : v.patch) p = p == 6 ? 7 : p == 7 ? 6 : p;
      },
      "corner");
}

BOOST_AUTO_TEST_CASE(roles_must_agree) {
  soup_rejected([](Step& s) { s.volumes[0].role[first_of(s.volumes[0], 4)] = 1; }, "role");
  soup_rejected([](Step& s) { s.volumes[0].role[first_of(s.volumes[0], 8)] = 0; }, "'cut'");
  soup_rejected([](Step& s) { s.result.roles[4] = Role::target; }, "role");
  soup_rejected(
      [](Step& s) {  // two targets
        s.result.roles[4] = Role::target;
        for (std::size_t t = 0; t < s.volumes[0].patch.size(); ++t)
          if (s.volumes[0].patch[t] == 4) s.volumes[0].role[t] = 2;
      },
      "2 targets");
  soup_rejected(
      [](Step& s) {  // no source
        s.result.roles[2] = Role::linking;
        for (Soup& v : s.volumes)
          for (int& r : v.role) r = r == 1 ? 0 : r;
      },
      "no source");
  result_rejected([](Decomposition& d) { d.roles.erase(5); }, "no role");
  result_rejected([](Decomposition& d) { d.roles[5] = Role::cut; }, "role");
  result_rejected([](Decomposition& d) { d.roles[50] = Role::linking; }, "no patch of the input");
  result_rejected([](Decomposition& d) { d.volumes[0].target = -3; }, "another target");
  result_rejected([](Decomposition& d) { d.volumes[1].sources = {2, 3}; }, "other sources");
  result_rejected([](Decomposition& d) { d.direction = {0, 0, 0}; }, "unit");
  result_rejected(
      [](Decomposition& d) {
        Soup::Mesh& mesh = d.volumes[0].mesh;
        auto roles = mesh.property_map<Soup::Mesh::Face_index, int>("f:role").first;
        mesh.remove_property_map(roles);
      },
      "lacks");
}

BOOST_AUTO_TEST_CASE(nothing_may_be_missing_or_doubled) {
  result_rejected([](Decomposition& d) { d.volumes.clear(); }, "no sub-volume");
  result_rejected([](Decomposition& d) { d.volumes.pop_back(); }, "no counterpart");
  result_rejected([](Decomposition& d) { d.volumes.push_back(d.volumes.back()); }, "more than two");
  result_rejected([](Decomposition& d) { std::swap(d.volumes[0], d.volumes[1]); }, "order");
  soup_rejected(
      [](Step& s) {  // a part of the input that the result lacks
        move(s.input, Point(2, 0, 1), Point(3, 0, 1));
        move(s.input, Point(2, 1, 1), Point(3, 1, 1));
        move(s.input, Point(2, 0, 2), Point(3, 0, 2));
        move(s.input, Point(2, 1, 2), Point(3, 1, 2));
      },
      "sum up to the input");
}

BOOST_AUTO_TEST_CASE(outer_triangles_must_lie_on_their_patch) {
  soup_rejected([](Step& s) { raise(s.volumes[0], 3, Point(-1e-6, 0.25, 1)); }, "sum up to the input");
  soup_rejected(
      [](Step& s) {  // as much in as out
        raise(s.volumes[0], 3, Point(-1e-6, 0.25, 1));
        raise(s.volumes[1], 5, Point(2 - 2e-6, 0.25, 1.5));
      },
      "does not lie on it");
  soup_rejected([](Step& s) { raise(s.volumes[0], 3, Point(0, 1.5, 1)); }, "turned over");
  soup_rejected([](Step& s) { move(s.volumes[1], Point(2, 0, 2), Point(2 + 1e-6, 0, 2)); }, "");
}

BOOST_AUTO_TEST_CASE(sets_must_be_those_of_the_cuts) {
  result_rejected([](Decomposition& d) { d.sets[0].triangles = 3; }, "triangles");
  result_rejected([](Decomposition& d) { d.sets[0].volumes = {1, 0}; }, "other sub-volumes");
  result_rejected([](Decomposition& d) { d.sets[0].id = 9; }, "no triangle");
  result_rejected([](Decomposition& d) { d.sets.clear(); }, "missing");
  result_rejected([](Decomposition& d) { d.sets.push_back({9, {0, 1}, 1}); }, "no triangle");
  result_rejected([](Decomposition& d) { d.sets.push_back(d.sets[0]); }, "order");
}

BOOST_AUTO_TEST_CASE(curves_between_patches_must_be_kept) {
  soup_rejected(
      [](Step& s) {  // the wall at x = 0 is two patches, divided at another place in the result
        auto divide = [](Soup& soup, double y) {
          const std::size_t t = first_of(soup, 3);
          soup.triangles.erase(soup.triangles.begin() + t, soup.triangles.begin() + t + 2);
          soup.patch.erase(soup.patch.begin() + t, soup.patch.begin() + t + 2);
          soup.role.erase(soup.role.begin() + t, soup.role.begin() + t + 2);
          soup.polygon({{0, 0, 0}, {0, 0, 2}, {0, y, 2}, {0, y, 0}}, 3);
          soup.polygon({{0, y, 0}, {0, y, 2}, {0, 1, 2}, {0, 1, 0}}, 10);
        };
        auto split_edge = [](Soup& soup, int patch, double y, double z) {
          const std::size_t a = soup.vertex(0, 0, z), b = soup.vertex(0, 1, z), m = soup.vertex(0, y, z);
          for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
            auto& corners = soup.triangles[t];
            for (int k = 0; k < 3; ++k) {
              const std::size_t u = corners[k], v = corners[(k + 1) % 3], w = corners[(k + 2) % 3];
              if (soup.patch[t] != patch || std::minmax(u, v) != std::minmax(a, b)) continue;
              corners = {u, m, w};
              soup.triangle({m, v, w}, patch, static_cast<Role>(soup.role[t]));
              return;
            }
          }
        };
        s.result.roles[10] = Role::linking;
        divide(s.input, 0.5);
        divide(s.volumes[0], 0.625);
        for (auto [patch, z] : {std::pair(0, 0.0), std::pair(2, 2.0)}) {
          split_edge(s.input, patch, 0.5, z);
          split_edge(s.volumes[0], patch, 0.625, z);
        }
      },
      "is not kept");
}

BOOST_AUTO_TEST_SUITE_END()
