// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/part/check_input.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "io_shapes.h"

using CCSweep::check_input;
using CCSweep::Status;
using CCSweep::Status_code;
using namespace shapes;

namespace {

using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;

Part mesh_of(const Polygon_soup& soup) {
  return CCSweep::internal::make_mesh<CCSweep::Double_point>(triangulated(soup));
}

Status status_of(const Polygon_soup& soup) {
  const Part part = mesh_of(soup);
  return check_input(part.mesh, part.mesh.points(), part.patch_ids());
}

// A tetrahedron; seen from its tip, a, b, c turn counter-clockwise.
Polygon_soup tetrahedron(const Xyz& a, const Xyz& b, const Xyz& c, const Xyz& tip) {
  Polygon_soup soup;
  soup.points = {a, b, c, tip};
  add_polygon(soup, {0, 2, 1}, 0);
  add_polygon(soup, {0, 1, 3}, 1);
  add_polygon(soup, {1, 2, 3}, 2);
  add_polygon(soup, {2, 0, 3}, 3);
  return soup;
}

// Every triangle becomes four.
Polygon_soup refined(Polygon_soup soup) {
  soup = triangulated(soup);
  std::map<std::pair<Vertex, Vertex>, Vertex> middles;
  const auto middle = [&](Vertex a, Vertex b) {
    const auto [known, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<Vertex>(soup.points.size()));
    if (is_new) {
      Xyz m;
      for (int k = 0; k < 3; ++k) m[k] = (soup.points[a][k] + soup.points[b][k]) / 2;
      soup.points.push_back(m);
    }
    return known->second;
  };
  Polygon_soup result;
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    const auto t = soup.polygon(f);
    const Vertex p = middle(t[0], t[1]), q = middle(t[1], t[2]), r = middle(t[2], t[0]);
    for (const auto& [a, b, c] : std::initializer_list<std::array<Vertex, 3>>{
             {t[0], p, r}, {p, t[1], q}, {r, q, t[2]}, {p, q, r}})
      add_polygon(result, {a, b, c}, soup.patch_ids[f]);
  }
  result.points = std::move(soup.points);
  return result;
}

// A bar of 16 by 1 by 0.2 whose length winds about the z axis, each radian farther out and higher up.
Polygon_soup coil(double outward, double upward) {
  Polygon_soup bar = refined(refined(refined(refined(box({0, 0, 0}, {16, 1, 0.2})))));
  for (Xyz& p : bar.points) {
    const double radius = 2 + outward * p[0] + p[1];
    p = {radius * std::cos(p[0]), radius * std::sin(p[0]), p[2] + upward * p[0]};
  }
  return inside_out(bar);
}

using Double_kernel = CGAL::Kernel_traits<CCSweep::Double_point>::Kernel;

CCSweep::internal::Triangle_surface<Double_kernel> surface_of(const Polygon_soup& soup) {
  CCSweep::internal::Triangle_surface<Double_kernel> result;
  std::map<std::pair<Vertex, Vertex>, std::uint32_t> edges;
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    const auto t = soup.polygon(f);
    const auto point = [&](int i) {
      const Xyz& p = soup.points[t[i]];
      return CCSweep::Double_point(p[0], p[1], p[2]);
    };
    result.triangles.push_back({point(0), point(1), point(2)});
    result.corners.push_back({t[0], t[1], t[2]});
    result.patch.push_back(soup.patch_ids[f]);
    for (int i = 0; i < 3; ++i) edges[{t[i], t[(i + 1) % 3]}] = static_cast<std::uint32_t>(3 * f + i);
  }
  for (const auto& [a, b, c] : result.corners)
    for (const auto& edge : {std::pair(b, a), std::pair(c, b), std::pair(a, c)})
      result.opposite.push_back(edges.at(edge));
  return result;
}

// By a look at every pair.
bool has_forbidden_contact(const Polygon_soup& soup) {
  const CCSweep::internal::Forbidden_contact<Double_kernel> is_forbidden;
  const auto triangles = surface_of(soup).triangles;
  std::vector<CGAL::Bbox_3> boxes;
  for (const auto& [p, q, r] : triangles) boxes.push_back(p.bbox() + q.bbox() + r.bbox());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = i + 1; j < triangles.size(); ++j)
      if (CGAL::do_overlap(boxes[i], boxes[j]) && is_forbidden(triangles[i], triangles[j])) return true;
  return false;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(check_input_mesh)

BOOST_AUTO_TEST_CASE(one_solid_passes) {
  BOOST_TEST(status_of(cube()).ok());
  BOOST_TEST(status_of(box({1e6, 1e6, 1e6}, {1e6 + 1e-3, 1e6 + 1e-3, 1e6 + 1e-3})).ok());
  BOOST_TEST(status_of(box({0, 0, 0}, {1e-9, 1, 1e9})).ok());
}

BOOST_AUTO_TEST_CASE(a_cavity_is_legal_and_what_is_in_it_is_another_solid) {
  const auto cavity = inside_out(box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}));
  const auto hollow = both(cube(), cavity);
  BOOST_TEST(status_of(hollow).ok());
  BOOST_TEST(status_of(both(hollow, box({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}))).code == Status_code::disjoint_solids);
  BOOST_TEST(status_of(both(cube(), inside_out(cavity))).code == Status_code::not_oriented);
  BOOST_TEST(status_of(inside_out(hollow)).code == Status_code::not_oriented);
}

BOOST_AUTO_TEST_CASE(a_cavity_may_touch_the_outside_in_its_corners) {
  // All corners of the cavity are corners of the cube, and its edges run along the diagonals of the faces.
  Polygon_soup soup;
  soup.points = cube().points;
  for (const auto& [a, b, c, d] : std::initializer_list<std::array<Vertex, 4>>{
           {0, 2, 3, 1}, {5, 7, 6, 4}, {0, 1, 5, 4}, {6, 7, 3, 2}, {0, 4, 6, 2}, {3, 7, 5, 1}}) {
    add_polygon(soup, {a, b, c}, 0);
    add_polygon(soup, {a, c, d}, 0);
  }
  const auto& p = soup.points;
  const auto cavity = inside_out(tetrahedron(p[0], p[3], p[6], p[5]));
  BOOST_TEST(status_of(soup).ok());
  const Status status = status_of(both(soup, cavity));
  BOOST_TEST(status.ok(), status.reason);
  BOOST_TEST(status_of(both(soup, inside_out(cavity))).code == Status_code::not_oriented);
}

BOOST_AUTO_TEST_CASE(several_solids_are_refused) {
  const auto status = status_of(both(cube(), box({3, 0, 0}, {4, 1, 1})));
  BOOST_TEST(status.code == Status_code::disjoint_solids);
  BOOST_REQUIRE(status.place.has_value());
  BOOST_TEST((*status.place)[0] >= 3.0);
}

BOOST_AUTO_TEST_CASE(inside_out_is_refused) {
  BOOST_TEST(status_of(inside_out(cube())).code == Status_code::not_oriented);
}

BOOST_AUTO_TEST_CASE(contact_in_equal_edges_and_vertices_is_legal) {
  BOOST_TEST(status_of(bosses_that_touch()).ok());
  // Two solids that touch so are not entangled, but still two.
  BOOST_TEST(status_of(both(cube(), box({1, 1, 0}, {2, 2, 1}))).code == Status_code::disjoint_solids);
  BOOST_TEST(status_of(both(cube(), box({1, 1, 1}, {2, 2, 2}))).code == Status_code::disjoint_solids);
}

BOOST_AUTO_TEST_CASE(any_other_contact_is_not) {
  const auto code = [](const Polygon_soup& other) {
    const Status_code coarse = status_of(both(cube(), other)).code;
    const Status fine = status_of(both(refined(refined(cube())), refined(refined(other))));
    BOOST_TEST(fine.code == coarse, fine.reason);
    return coarse;
  };
  BOOST_TEST(code(box({0.5, 0.5, 0.5}, {2, 2, 2})) == Status_code::self_intersecting);        // through each other
  BOOST_TEST(code(box({1, 0, 0}, {2, 1, 1})) == Status_code::self_intersecting);              // face on face
  BOOST_TEST(code(box({1, 0.25, 0.25}, {2, 0.75, 0.75})) == Status_code::self_intersecting);  // in a face
  BOOST_TEST(code(box({1, 1, 0.25}, {2, 2, 0.75})) == Status_code::self_intersecting);        // in a part of an edge
  BOOST_TEST(code(cube()) == Status_code::self_intersecting);                                 // twice the same
  BOOST_TEST(code(inside_out(cube())) == Status_code::self_intersecting);
  // A tip on a face, and a tip through a face.
  const Xyz a = {0.25, 0.25, 3}, b = {0.25, 0.75, 3}, c = {0.75, 0.5, 3};
  BOOST_TEST(code(tetrahedron(a, b, c, {0.375, 0.5, 1})) == Status_code::self_intersecting);
  BOOST_TEST(code(tetrahedron(a, b, c, {0.375, 0.5, 0.5})) == Status_code::self_intersecting);
}

BOOST_AUTO_TEST_CASE(facets_that_share_a_vertex_may_cross) {
  auto soup = triangulated(cube());
  soup.points[7] = {0.3, 0.4, -0.5};  // a corner pushed through the bottom
  const auto status = status_of(soup);
  BOOST_TEST(status.code == Status_code::self_intersecting);
  BOOST_TEST(status.patches.size() >= 1u);
}

BOOST_AUTO_TEST_CASE(facets_folded_onto_each_other_cross) {
  // The two sides of one sheet: closed, oriented, and without volume.
  Polygon_soup sheet;
  sheet.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  add_polygon(sheet, {0, 1, 2}, 0);
  add_polygon(sheet, {0, 2, 1}, 1);
  BOOST_TEST(status_of(sheet).code == Status_code::self_intersecting);
}

BOOST_AUTO_TEST_CASE(a_surface_above_itself_is_judged_as_by_a_look_at_every_pair) {
  std::size_t refused = 0, passed = 0;
  for (const double outward : {0.0, 0.01, 0.1, 0.5})
    for (const double upward : {-0.1, -0.01, 0.0, 0.03, 0.2}) {
      const Polygon_soup soup = coil(outward, upward);
      const Status status = status_of(soup);
      const bool is_wrong = has_forbidden_contact(soup);
      BOOST_TEST((status.code == Status_code::self_intersecting) == is_wrong, outward << " " << upward);
      BOOST_TEST(status.ok() == !is_wrong, status.reason);
      ++(is_wrong ? refused : passed);
    }
  BOOST_TEST(refused > 3u);
  BOOST_TEST(passed > 3u);
}

BOOST_AUTO_TEST_CASE(a_chart_is_not_above_itself) {
  using Charts = CCSweep::internal::Surface_charts<Double_kernel>;
  const auto chart_of_top = [](const Polygon_soup& soup) {
    const std::vector<std::uint32_t> charts = Charts::of(surface_of(soup));
    std::set<std::uint32_t> result;
    for (std::size_t f = 0; f < charts.size(); ++f)
      if (soup.patch_ids[f] == 1) result.insert(charts[f]);
    BOOST_TEST(result.size() == 1u);
    return *result.begin();
  };
  BOOST_TEST(chart_of_top(coil(0, 0.1)) == Charts::none);    // turn above turn
  BOOST_TEST(chart_of_top(coil(0.1, 0.1)) == Charts::none);  // by part of the width
  BOOST_TEST(chart_of_top(coil(0.5, 0.1)) != Charts::none);  // beside one another
}

BOOST_AUTO_TEST_CASE(a_surface_wound_around_a_vertex_is_refused) {
  // A bar that goes around the z axis twice, its inner side drawn together.
  Polygon_soup soup = refined(refined(refined(box({0, 0, 0}, {16, 1, 0.2}))));
  for (Xyz& p : soup.points) {
    const double angle = p[0] * 0.75, radius = p[1];
    p = {radius * std::cos(angle), radius * std::sin(angle), p[2] + 0.001 * p[0] * p[1]};
  }
  std::map<Xyz, Vertex> known;
  std::vector<Vertex> kept;
  for (Vertex v = 0; v < soup.points.size(); ++v) kept.push_back(known.try_emplace(soup.points[v], v).first->second);
  Polygon_soup joined;
  joined.points = soup.points;
  for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
    const auto t = soup.polygon(f);
    const Vertex a = kept[t[0]], b = kept[t[1]], c = kept[t[2]];
    if (a != b && b != c && c != a) add_polygon(joined, {a, b, c}, soup.patch_ids[f]);
  }
  BOOST_REQUIRE(has_forbidden_contact(joined));
  BOOST_TEST(!status_of(joined).ok());
}

BOOST_AUTO_TEST_CASE(what_a_face_graph_can_hold_wrong_is_found) {
  CGAL::Surface_mesh<CCSweep::Double_point> empty;
  BOOST_TEST(check_input(empty, empty.points()).code == Status_code::empty_mesh);

  Part open = mesh_of(cube());
  CGAL::Euler::remove_face(halfedge(*faces(open.mesh).begin(), open.mesh), open.mesh);
  BOOST_TEST(check_input(open.mesh, open.mesh.points()).code == Status_code::not_closed);

  Part flat = mesh_of(cube());
  auto at = vertices(flat.mesh).begin();
  const auto first = *at++;
  flat.mesh.point(first) = flat.mesh.point(*at);
  const Status status = check_input(flat.mesh, flat.mesh.points(), flat.patch_ids());
  BOOST_TEST(status.code == Status_code::degenerate_facet);
  BOOST_TEST(status.patches.size() == 1u);

  Part wild = mesh_of(cube());
  wild.mesh.point(first) = {0, std::numeric_limits<double>::quiet_NaN(), 0};
  BOOST_TEST(check_input(wild.mesh, wild.mesh.points()).code == Status_code::non_finite_coordinate);

  CGAL::Surface_mesh<CCSweep::Double_point> quads;
  CGAL::make_hexahedron(CCSweep::Double_point(0, 0, 0), CCSweep::Double_point(1, 0, 0), CCSweep::Double_point(1, 1, 0),
                        CCSweep::Double_point(0, 1, 0), CCSweep::Double_point(0, 1, 1), CCSweep::Double_point(0, 0, 1),
                        CCSweep::Double_point(1, 0, 1), CCSweep::Double_point(1, 1, 1), quads);
  BOOST_TEST(check_input(quads, quads.points()).code == Status_code::invalid_parameter);
}

BOOST_AUTO_TEST_CASE(a_vertex_with_two_fans_is_found) {
  Part part = mesh_of(both(cube(), box({1, 1, 1}, {2, 2, 2})));
  const auto find = [&](std::size_t nth) {
    for (auto v : part.mesh.vertices())
      if (part.mesh.point(v) == CCSweep::Double_point(1, 1, 1) && nth-- == 0) return v;
    return part.mesh.null_vertex();
  };
  const auto kept = find(0), dropped = find(1);
  BOOST_TEST(check_input(part.mesh, part.mesh.points()).code == Status_code::disjoint_solids);
  for (auto h : part.mesh.halfedges())
    if (target(h, part.mesh) == dropped) set_target(h, kept, part.mesh);
  BOOST_TEST(check_input(part.mesh, part.mesh.points()).code == Status_code::not_manifold);
}

BOOST_AUTO_TEST_CASE(any_face_graph_and_any_kernel_will_do) {
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
  const Part hollow = mesh_of(both(cube(), inside_out(box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}))));
  Polyhedron polyhedron;
  CGAL::copy_face_graph(hollow.mesh, polyhedron);
  BOOST_TEST(check_input(polyhedron, get(CGAL::vertex_point, polyhedron)).ok());

  const auto exact = CCSweep::internal::make_mesh<Exact_point>(triangulated(bosses_that_touch()));
  BOOST_TEST(check_input(exact.mesh, exact.mesh.points(), exact.patch_ids()).ok());
}

BOOST_AUTO_TEST_SUITE_END()
