// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Each stage by itself, on parts small enough to know what it must hand on.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/internal/connect_triangles.h>
#include <CCSweep/linking/Column_map.h>
#include <CCSweep/linking/make_layering.h>
#include <CCSweep/linking/make_wall_sections.h>
#include <CCSweep/loops/point_index.h>
#include <CCSweep/loops/segment_index.h>
#include <CCSweep/loops/sweep_layers.h>
#include <CCSweep/part/assign_roles.h>
#include <CCSweep/part/make_part.h>
#include <CCSweep/visitor.h>
#include <CCSweep/volumes/draw_cuts.h>
#include <CCSweep/volumes/follow_walls.h>
#include <CCSweep/volumes/make_cut_rows.h>
#include <CCSweep/volumes/make_sub_volumes.h>
#include <CCSweep/volumes/separate_fans.h>
#include <CCSweep/volumes/triangulate_plane.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mesh_changes.h"
#include "random_parts.h"

namespace {

using namespace CCSweep;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Part_type = Part<Kernel>;
using Point = std::array<double, 3>;
using Kind = Surface_location::Kind;
using mesh_changes::Soup;

constexpr double pi = 3.14159265358979323846;

Part_type part_of(const Soup& soup) {
  const auto mesh = mesh_changes::mesh<Kernel::Point_3>(soup);
  const auto patch_id = mesh.property_map<CGAL::SM_Face_index, int>("f:patch_id").first;
  return make_part<Kernel>(mesh, mesh.points(), patch_id).value();
}

Soup soup_of(const random_parts::Plan& plan) {
  const random_parts::Part part = random_parts::build(plan).value();
  return {part.points, part.triangles, part.patch};
}

random_parts::Outline rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

random_parts::Outline circle(double x, double y, double radius, int n) {
  random_parts::Outline result;
  for (int i = 0; i < n; ++i)
    result.push_back({x + radius * std::cos(2 * pi * i / n), y + radius * std::sin(2 * pi * i / n)});
  return result;
}

// A block, 8 by 8 by 4, with what is painted on it.
random_parts::Plan block() {
  random_parts::Plan plan;
  plan.material.push_back({rectangle(0, 0, 8, 8)});
  plan.bottom = 0;
  plan.top = 4;
  return plan;
}

// The block hangs lower on one side.
random_parts::Plan step() {
  random_parts::Plan plan = block();
  plan.bottoms.push_back({rectangle(0, 0, 4, 8), -2});
  return plan;
}

random_parts::Plan block_with_window() {
  random_parts::Plan plan = block();
  plan.windows.push_back({rectangle(3, 0, 5, 8), 1, 3});
  return plan;
}

random_parts::Plan block_with_hole() {
  random_parts::Plan plan = block();
  plan.material.push_back({circle(4, 4, 2, 16), false});
  return plan;
}

// A prism over a polygon in the xz plane, from y = 0 to y = 1: patch i is the wall over edge i, then the two ends.
Soup prism(const std::vector<std::array<double, 2>>& outline) {
  Soup soup;
  const std::size_t n = outline.size();
  for (double y : {0., 1.})
    for (const auto& [x, z] : outline) soup.points.push_back({x, y, z});
  auto add = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t patch) {
    soup.triangles.push_back({a, b, c});
    soup.patch.push_back(static_cast<int>(patch));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    add(j, i, n + i, i);
    add(j, n + i, n + j, i);
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    add(0, i, i + 1, n);
    add(n, n + i + 1, n + i, n + 1);
  }
  return soup;
}

Roles roles_along(const Part_type& part, const Point& direction) {
  return assign_roles(part, Role_request{direction, {}, {}}).value().front();
}

std::size_t count(const Roles& roles, Role role) {
  return std::count(roles.of_patch.begin(), roles.of_patch.end(), role);
}

// All stages up to the cut surface, for tests that look at one of them.
struct Run {
  Part_type part;
  Roles roles;
  Layering layering;
  Wall_sections sections;
  Layered_loops<Kernel> loops;
  std::vector<Cut_row> rows;
  Cut_surface<Kernel> surface;

  explicit Run(const Soup& soup, int slabs = 1) : part(part_of(soup)), roles(roles_along(part, {0, 0, 1})) {
    layering = make_layering(part, roles, {60, slabs}).value();
    sections = make_wall_sections(part, roles, layering).value();
    loops = sweep().value();
    rows = make_cut_rows(part, layering, loops).value();
    surface = draw_cuts(part, roles, loops, rows).value();
  }

  Result<Layered_loops<Kernel>> sweep() const { return sweep(roles); }
  Result<Layered_loops<Kernel>> sweep(const Roles& as_if) const {
    Visitor_base nobody;
    return sweep_layers<Kernel, Rtree_segment_index_2<Kernel>, Rtree_point_index_3>(
        part, as_if, layering, sections, 1e-5 * part.diagonal, 10, nobody);
  }
};

Point coordinates(const Part_type& part, const Surface_location& where) {
  if (where.kind == Kind::vertex) return part.coordinates(Part_type::Vertex(where.index));
  return Part_type::coordinates(internal::point_on_edge(part, Part_type::Edge(where.index), where.t));
}

// Twice the area that a row encloses when seen against the sweep.
double turning(const Part_type& part, const Wall_loop& row) {
  double sum = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const Point a = coordinates(part, row.nodes[i]), b = coordinates(part, row.nodes[(i + 1) % row.size()]);
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

template <class Triangles>
bool is_closed(const Triangles& triangles) {
  std::map<std::pair<std::size_t, std::size_t>, int> sides;
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) {
      ++sides[{t[k], t[(k + 1) % 3]}];
      --sides[{t[(k + 1) % 3], t[k]}];
    }
  return std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 0; });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(stages)

BOOST_AUTO_TEST_CASE(a_part_knows_its_patches_curves_and_corners) {
  const Part_type part = part_of(soup_of(block()));
  BOOST_TEST(part.number_of_patches() == 6u);
  BOOST_TEST(std::count(part.corner.begin(), part.corner.end(), true) == 8);
  BOOST_TEST(std::count(part.feature.begin(), part.feature.end(), true) == 12);
  BOOST_TEST(std::count(part.planar.begin(), part.planar.end(), true) == 6);
  BOOST_TEST(part.diagonal == 12);
  BOOST_TEST(std::is_sorted(part.patch_id.begin(), part.patch_id.end()));
  for (Part_type::Face f : part.mesh.faces()) {
    const auto& faces = part.faces[part.patch(f).value()];
    BOOST_TEST(std::count(faces.begin(), faces.end(), f) == 1);
  }
  for (double error : part.chord_error) BOOST_TEST(error == 0);
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    BOOST_TEST(part.border[p].size() == 4u);
    for (Part_type::Halfedge h : part.border[p]) {
      BOOST_TEST(part.feature[part.mesh.edge(h)]);
      BOOST_TEST((part.patch(part.mesh.face(h)) == Patch_index(p)));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_closed_curve_has_no_corner_and_is_known_for_an_arc) {
  const Part_type part = part_of(soup_of(block_with_hole()));
  BOOST_TEST(part.number_of_patches() == 7u);
  BOOST_TEST(std::count(part.corner.begin(), part.corner.end(), true) == 8);
  BOOST_TEST(std::count(part.planar.begin(), part.planar.end(), false) == 1);
  const double sagitta = 2 * (1 - std::cos(pi / 16));  // radius 2, 16 chords
  std::size_t arcs = 0;
  for (double error : part.chord_error) {
    if (error == 0) continue;
    ++arcs;
    BOOST_TEST(error >= sagitta);
    BOOST_TEST(error < 1.2 * sagitta);
  }
  BOOST_TEST(arcs == 32u);
}

BOOST_AUTO_TEST_CASE(an_arc_bulges_the_same_however_its_chords_are_divided) {
  const Part_type part = part_of(soup_of(block_with_hole())),
                  fine = part_of(mesh_changes::with_split_edges(soup_of(block_with_hole())));
  const double error = *std::max_element(part.chord_error.begin(), part.chord_error.end());
  std::size_t arcs = 0;
  for (double e : fine.chord_error) {
    if (e == 0) continue;
    ++arcs;
    BOOST_TEST(e == error, boost::test_tools::tolerance(1e-9));
  }
  BOOST_TEST(arcs == 64u);
}

BOOST_AUTO_TEST_CASE(a_patch_in_several_pieces_is_several_patches_of_one_id) {
  Soup soup = soup_of(block());
  const Part_type whole = part_of(soup);
  const Roles roles = roles_along(whole, {0, 0, 1});
  for (int& id : soup.patch)  // all walls get one id, bottom and top another
    id = roles.of_patch[std::find(whole.patch_id.begin(), whole.patch_id.end(), id) - whole.patch_id.begin()] ==
                 Role::linking
             ? 7
             : 9;
  const Part_type part = part_of(soup);
  BOOST_TEST((part.patch_id == std::vector{7, 9, 9}));
  BOOST_TEST(std::count(part.corner.begin(), part.corner.end(), true) == 0);
}

BOOST_AUTO_TEST_CASE(a_part_forgets_the_order_of_its_input) {
  const Soup soup = soup_of(block_with_hole());
  const Part_type a = part_of(soup), b = part_of(mesh_changes::shuffled(soup, 5));
  for (Part_type::Vertex v : a.mesh.vertices()) BOOST_TEST((a.point(v) == b.point(v)));
  for (Part_type::Halfedge h : a.mesh.halfedges()) BOOST_TEST((a.mesh.target(h) == b.mesh.target(h)));
  BOOST_TEST((a.patch_of_face == b.patch_of_face));
}

// The mesh of triangles over vertices without places.
struct Connected {
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  bool is_manifold = false;

  explicit Connected(const std::vector<internal::Triangle>& triangles) {
    for (const auto& t : triangles)
      for (std::uint32_t v : t)
        while (mesh.number_of_vertices() <= v) mesh.add_vertex(Kernel::Point_3(0, 0, 0));
    const auto corners = [](const internal::Triangle& t) { return t; };
    is_manifold = internal::Triangle_connector<Kernel::Point_3>::run(triangles, corners, mesh) &&
                  internal::has_single_fans(mesh);
  }
};

BOOST_AUTO_TEST_CASE(triangles_are_connected_as_if_added_one_by_one) {
  const Soup soup = mesh_changes::shuffled(soup_of(block_with_hole()), 5);
  const auto mesh = mesh_changes::mesh<Kernel::Point_3>(soup);
  std::vector<internal::Triangle> triangles;
  for (const auto& t : soup.triangles)
    triangles.push_back({std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2])});
  const Connected connected(triangles);
  BOOST_TEST_REQUIRE(connected.is_manifold);
  BOOST_TEST_REQUIRE(connected.mesh.is_valid());
  for (auto h : mesh.halfedges()) {
    BOOST_TEST((connected.mesh.target(h) == mesh.target(h)));
    BOOST_TEST((connected.mesh.next(h) == mesh.next(h)));
    BOOST_TEST((connected.mesh.face(h) == mesh.face(h)));
  }
  for (auto v : mesh.vertices()) BOOST_TEST((connected.mesh.halfedge(v) == mesh.halfedge(v)));
  for (auto f : mesh.faces()) BOOST_TEST((connected.mesh.halfedge(f) == mesh.halfedge(f)));
}

BOOST_AUTO_TEST_CASE(triangles_of_no_closed_manifold_are_not_connected) {
  const std::vector<internal::Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  BOOST_TEST(Connected(tetrahedron).is_manifold);
  auto open = tetrahedron, turned = tetrahedron, twice = tetrahedron, flat = tetrahedron, touching = tetrahedron;
  open.pop_back();
  std::swap(turned[3][0], turned[3][1]);
  twice.insert(twice.end(), tetrahedron.begin(), tetrahedron.end());
  flat.insert(flat.end(), {{0, 0, 1}, {0, 1, 0}});
  touching.insert(touching.end(), {{0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {5, 0, 6}});
  for (const auto& triangles : {open, turned, twice, flat, touching}) BOOST_TEST(!Connected(triangles).is_manifold);
}

BOOST_AUTO_TEST_CASE(caps_are_told_from_walls_and_fewest_targets_come_first) {
  const Part_type part = part_of(soup_of(step()));
  const Roles roles = roles_along(part, {0, 0, 1});
  BOOST_TEST(count(roles, Role::target) == 2u);
  BOOST_TEST(count(roles, Role::source) == 1u);
  const auto all = assign_roles(part, {}).value();
  BOOST_TEST(all.size() == 6u);  // an L can be swept along every axis, both ways
  for (std::size_t i = 1; i < all.size(); ++i)
    BOOST_TEST(count(all[i - 1], Role::target) <= count(all[i], Role::target));
}

BOOST_AUTO_TEST_CASE(an_axis_is_found_where_no_cap_and_no_cylinder_tells_it) {
  // Twelve planar walls about a round hole, the facets of which lean as its ends are turned against each other; both
  // caps bend.
  constexpr std::size_t n = 12;
  Soup soup;
  const auto add_ring = [&](double radius, double height, double turned) {
    for (std::size_t i = 0; i < n; ++i) {
      const double t = 2 * pi * (double(i) + turned) / n, x = radius * std::cos(t);
      soup.points.push_back({x, radius * std::sin(t), height + 0.03 * x * x});
    }
  };
  const auto add_strip = [&](std::size_t from, std::size_t to, const auto& patch_of) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      soup.triangles.push_back({from * n + i, from * n + j, to * n + j});
      soup.triangles.push_back({from * n + i, to * n + j, to * n + i});
      soup.patch.insert(soup.patch.end(), 2, patch_of(i));
    }
  };
  const auto one = [](int patch) { return [patch](std::size_t) { return patch; }; };
  add_ring(6, 0, 0);
  add_ring(6, 1, 0);
  add_ring(3, 1, 0.5);
  add_ring(3, 0, 0);
  add_strip(0, 1, [](std::size_t i) { return static_cast<int>(i); });
  add_strip(1, 2, one(12));
  add_strip(2, 3, one(13));
  add_strip(3, 0, one(14));
  const auto all = assign_roles(part_of(soup), {}).value();
  BOOST_TEST(all.size() == 2u);
  for (const Roles& roles : all) {
    BOOST_TEST(std::abs(roles.direction[2]) == 1., boost::test_tools::tolerance(1e-9));
    BOOST_TEST(count(roles, Role::linking) == 13u);
  }
}

BOOST_AUTO_TEST_CASE(walls_that_narrow_to_a_point_are_no_first_choice) {
  // A gusset between a plate and a wall: up the wall there is one target only, but the gusset's sides end in nothing.
  const auto file = read_part<Kernel::Point_3>(CCSWEEP_TEST_DATA "/gusset.ply");
  BOOST_TEST_REQUIRE(file.ok());
  const auto& mesh = file.value().mesh;
  const auto all = assign_roles(make_part<Kernel>(mesh, mesh.points(), file.value().patch_ids()).value(), {}).value();
  const auto last_along = [&](int axis) {
    std::size_t last = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (std::abs(all[i].direction[axis]) == 1) last = i;
    return last;
  };
  BOOST_TEST(last_along(1) < last_along(2));
}

BOOST_AUTO_TEST_CASE(a_straight_sweep_is_refused_where_a_wall_narrows_to_a_point_between_caps) {
  // The gusset with a slope flat enough for a cap: beside it a wall ends where the slope meets the plate.
  const auto file = read_part<Kernel::Point_3>(CCSWEEP_TEST_DATA "/gusset.ply");
  BOOST_TEST_REQUIRE(file.ok());
  auto mesh = file.value().mesh;
  for (auto v : mesh.vertices())
    if (Kernel::Point_3& p = mesh.point(v); p.x() == 4 && p.z() > 20 && p.z() < 25) p = {4, p.y(), 7};
  const Part_type part = make_part<Kernel>(mesh, mesh.points(), file.value().patch_ids()).value();
  for (double sense : {-1., 1.}) {
    const auto objections = internal::try_axis(part, {0, 0, sense}).objections;
    BOOST_TEST_REQUIRE(objections.size() == 2u);
    for (std::size_t i : {0, 1}) {
      const std::set<int> patches(objections[i].patches.begin(), objections[i].patches.end());
      BOOST_TEST((patches == std::set{i == 0 ? 8 : 10, 6, 9}));
      BOOST_TEST((objections[i].reason.find("narrows to a point") != std::string::npos));
    }
  }
  const auto all = assign_roles(part, {}).value();
  for (const Roles& roles : all) BOOST_TEST(std::abs(roles.direction[2]) < 1);
  BOOST_TEST(assign_roles(part, Role_request{{0, 1, 0}, {}, {}}).ok());
}

BOOST_AUTO_TEST_CASE(a_knife_edge_is_refused_by_name) {
  // A wedge whose floor meets its roof: along z there is no wall between them.
  const Part_type part = part_of(prism({{0, 0}, {4, 0}, {4, 1}}));
  const Status status = assign_roles(part, Role_request{{0, 0, 1}, {}, {}}).status();
  BOOST_TEST((status.code == Status_code::not_sweepable));
  BOOST_TEST((status.patches == std::vector{0, 2}));
  BOOST_TEST((status.reason.find("knife edge") != std::string::npos));
  BOOST_TEST(assign_roles(part, Role_request{{0, 1, 0}, {}, {}}).ok());
}

BOOST_AUTO_TEST_CASE(a_fillet_between_cap_and_wall_is_refused_by_name) {
  std::vector<std::array<double, 2>> outline{{0, 0}, {4, 0}};
  for (int i = 0; i <= 6; ++i) outline.push_back({3 + std::cos(pi / 12 * i), 3 + std::sin(pi / 12 * i)});
  outline.push_back({0, 4});
  Soup soup = prism(outline);
  for (int& id : soup.patch)
    if (id > 2 && id < 8) id = 2;  // the fillet is one face
  const Part_type part = part_of(soup);
  const Status status = assign_roles(part, Role_request{{0, 0, 1}, {}, {}}).status();
  BOOST_TEST((status.code == Status_code::not_sweepable));
  BOOST_TEST((status.stage == Stage::roles));
  BOOST_TEST((status.patches == std::vector{2}));
  BOOST_TEST(assign_roles(part, Role_request{{0, 1, 0}, {}, {}}).ok());
}

BOOST_AUTO_TEST_CASE(slivers_do_not_make_a_wall_a_cap) {
  // A cylinder with nodes on its wall just below the edges of its upper circle: that far out, they make facets as flat
  // as a cap.
  constexpr std::size_t n = 24;
  Soup soup;
  for (const auto& [z, turn] : {std::array{0., 0.}, {1.998, 0.5}, {2., 0.}})
    for (std::size_t i = 0; i < n; ++i)
      soup.points.push_back(
          {std::cos(2 * pi * (double(i) + turn) / n), std::sin(2 * pi * (double(i) + turn) / n), z});
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c, int patch) {
    soup.triangles.push_back({a, b, c});
    soup.patch.push_back(patch);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    add(i, j, n + i, 0);
    add(j, n + j, n + i, 0);
    add(n + i, 2 * n + j, 2 * n + i, 0);
    add(n + i, n + j, 2 * n + j, 0);
    if (i == 0 || j == 0) continue;
    add(0, j, i, 1);
    add(2 * n, 2 * n + i, 2 * n + j, 2);
  }
  const Roles roles = roles_along(part_of(soup), {0, 0, 1});
  BOOST_TEST((roles.of_patch == std::vector{Role::linking, Role::target, Role::source}));
  BOOST_TEST(!roles.is_doubtful);
}

BOOST_AUTO_TEST_CASE(a_chamfer_of_coarse_facets_is_a_wall) {
  // A cylinder whose upper edge is cut off at 45 degrees; the circles at the two ends of the cone have different nodes.
  constexpr std::size_t n = 12;
  Soup soup;
  for (const auto& [radius, z, turn] : {std::array{6., 0., 0.}, {6., 3., 0.}, {5., 4., 0.5}})
    for (std::size_t i = 0; i < n; ++i)
      soup.points.push_back({radius * std::cos(2 * pi * (double(i) + turn) / n),
                             radius * std::sin(2 * pi * (double(i) + turn) / n), z});
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c, int patch) {
    soup.triangles.push_back({a, b, c});
    soup.patch.push_back(patch);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    for (std::size_t ring : {0, 1}) {
      add(ring * n + i, ring * n + j, (ring + 1) * n + i, static_cast<int>(ring));
      add(ring * n + j, (ring + 1) * n + j, (ring + 1) * n + i, static_cast<int>(ring));
    }
    if (i == 0 || j == 0) continue;
    add(0, j, i, 2);
    add(2 * n, 2 * n + i, 2 * n + j, 3);
  }
  const Roles roles = roles_along(part_of(soup), {0, 0, 1});
  BOOST_TEST(count(roles, Role::linking) == 2u);
}

BOOST_AUTO_TEST_CASE(forced_caps_decide_the_axis) {
  const Part_type part = part_of(soup_of(block()));
  for (int target : part.patch_id) {
    const auto roles = assign_roles(part, Role_request{{}, {}, {target}});
    BOOST_TEST_REQUIRE(roles.ok());
    BOOST_TEST(roles.value().size() == 1u);
    BOOST_TEST((roles.value()[0].of_patch[target - part.patch_id[0]] == Role::target));
  }
  BOOST_TEST((assign_roles(part, Role_request{{}, {}, {99}}).status().code == Status_code::invalid_parameter));
}

BOOST_AUTO_TEST_CASE(levels_rank_all_caps_whether_a_wall_ties_them_or_not) {
  random_parts::Plan plan = step();
  plan.tops.push_back({rectangle(5, 5, 7, 7), 2});  // a blind pocket
  const Part_type part = part_of(soup_of(plan));
  const Roles roles = roles_along(part, {0, 0, 1});
  const Layering layering = make_layering(part, roles, {60, 1}).value();
  BOOST_TEST((layering.layers == std::vector<double>{-2, 0, 2, 4}));
  for (const auto& caps : layering.caps) BOOST_TEST(caps.size() == 1u);
  for (Part_type::Vertex v : part.mesh.vertices()) BOOST_TEST(layering.parameter[v] == part.coordinates(v)[2]);
  for (std::size_t p = 0; p < part.number_of_patches(); ++p)
    BOOST_TEST(layering.level_of_patch[p].is_valid() == (roles.of_patch[p] != Role::linking));
}

BOOST_AUTO_TEST_CASE(further_layers_lie_evenly_between_the_levels) {
  const Part_type part = part_of(soup_of(step()));
  const Roles roles = roles_along(part, {0, 0, 1});
  const Layering layering = make_layering(part, roles, {60, 4}).value();
  BOOST_TEST((layering.layers == std::vector<double>{-2, -1.5, -1, -0.5, 0, 1, 2, 3, 4}));
  for (std::size_t k = 0; k < layering.layers.size(); ++k)
    BOOST_TEST(layering.level_of_layer[k].is_valid() == (k % 4 == 0));
  for (int slabs : {0, -1, 10001})
    BOOST_TEST((make_layering(part, roles, {60, slabs}).status().code == Status_code::invalid_parameter));
  for (double angle : {0., -5., 181.})
    BOOST_TEST((make_layering(part, roles, {angle, 1}).status().code == Status_code::invalid_parameter));
}

BOOST_AUTO_TEST_CASE(rows_are_closed_rings_with_the_material_on_their_left) {
  const Run run(soup_of(block_with_hole()), 3);
  for (std::size_t k = 0; k + 1 < run.layering.number_of_layers(); ++k) {
    BOOST_TEST(run.sections.strips[k].size() == 2u);
    for (const auto& strip : run.sections.strips[k]) {
      const Wall_loop &low = run.sections.leaving[k][strip.bottom], &high = run.sections.arriving[k + 1][strip.top];
      BOOST_TEST((turning(run.part, low) > 0) == (turning(run.part, high) > 0));
      // The outer ring has four sharp edges, which are its rails; the round one has none.
      BOOST_TEST(strip.rails.size() == (turning(run.part, low) > 0 ? 4u : 0u));
    }
    double area = 0;
    for (const Wall_loop& row : run.sections.leaving[k]) area += turning(run.part, row) / 2;
    BOOST_TEST(area == 64 - 8 * 4 * std::sin(pi / 8), boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(rows_sit_at_the_parameter) {
  const Run run(soup_of(block_with_window()), 3);
  for (std::size_t k = 0; k < run.layering.number_of_layers(); ++k)
    for (const auto* rows : {&run.sections.leaving[k], &run.sections.arriving[k]})
      for (const Wall_loop& row : *rows)
        for (const Surface_location& node : row.nodes)
          BOOST_TEST(coordinates(run.part, node)[2] == run.layering.layers[k], boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_window_parts_the_rows_of_its_height) {
  const Run run(soup_of(block_with_window()));
  BOOST_TEST((run.layering.layers == std::vector<double>{0, 1, 3, 4}));
  const std::vector<std::size_t> expected{1, 2, 1};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    BOOST_TEST(run.sections.leaving[k].size() == expected[k]);
    BOOST_TEST(run.sections.arriving[k + 1].size() == expected[k]);
    BOOST_TEST(run.sections.strips[k].size() == expected[k]);
  }
}

BOOST_AUTO_TEST_CASE(a_column_of_a_straight_wall_stands_upright) {
  const std::vector<Point> square{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  const std::vector<Point> finer{{0, 0, 5}, {1, 0, 5}, {2, 0, 5}, {2, 0.25, 5}, {2, 1, 5}, {0, 1, 5}};
  const Column_map map(square, finer, {{0, 0}, {1, 2}, {2, 4}, {3, 5}}, {0, 0, 1});
  for (std::size_t i = 0; i < square.size(); ++i)
    BOOST_TEST((map.point_above(i) == Point{square[i][0], square[i][1], 5}));
  for (std::size_t i = 0; i < finer.size(); ++i)
    BOOST_TEST((map.point_below(i) == Point{finer[i][0], finer[i][1], 0}));
  BOOST_TEST(map.below(1).index == 0u);
  BOOST_TEST(map.below(1).fraction == 0.5);
  BOOST_TEST(map.below(3).index == 1u);
  BOOST_TEST(map.below(3).fraction == 0.25);
}

BOOST_AUTO_TEST_CASE(columns_without_rails_start_at_the_nearest_place) {
  auto ring = [](int n, double start, double z) {
    std::vector<Point> points;
    for (int i = 0; i < n; ++i)
      points.push_back({3 + std::cos(start + 2 * pi * i / n), 5 + std::sin(start + 2 * pi * i / n), z});
    return points;
  };
  const auto bottom = ring(24, 0, 0), top = ring(36, 1, 7);
  const Column_map map(bottom, top, {}, {0, 0, 1});
  for (std::size_t i = 0; i < bottom.size(); ++i) {
    const Point above = map.point_above(i);
    BOOST_TEST(std::hypot(above[0] - bottom[i][0], above[1] - bottom[i][1]) < 0.01);
    BOOST_TEST(above[2] == 7);
  }
  std::set<std::size_t> met;
  for (std::size_t i = 0; i < top.size(); ++i) met.insert(map.below(i).index);
  BOOST_TEST(met.size() == bottom.size());  // once around
}

BOOST_AUTO_TEST_CASE(targets_are_carried_up_and_end_under_sources) {
  const Run run(soup_of(step()));
  const auto& top = run.loops.segments.back();
  std::map<int, std::set<int>> source_over;
  for (const auto& segment : top)
    for (const auto& side : {segment.left, segment.right}) {
      BOOST_TEST(!side.material_above());
      BOOST_TEST(side.source.is_valid() == side.target.is_valid());
      if (side.source.is_valid()) source_over[run.part.id(side.target)].insert(run.part.id(side.source));
    }
  BOOST_TEST(source_over.size() == 2u);
  for (const auto& [target, sources] : source_over) BOOST_TEST(sources.size() == 1u);
  std::size_t cuts = 0;
  for (const auto& of_layer : run.loops.cuts) cuts += of_layer.size();
  BOOST_TEST(cuts == 1u);
}

BOOST_AUTO_TEST_CASE(a_target_taken_for_a_source_is_named) {
  const Run run(soup_of(step()));
  Roles wrong = run.roles;
  const std::size_t patch = run.layering.caps[1].front().value();
  wrong.of_patch[patch] = Role::source;
  const Status status = run.sweep(wrong).status();
  BOOST_TEST((status.code == Status_code::chart_not_injective), name(status.code) << ": " << status.reason);
  BOOST_TEST((status.patches == std::vector{run.part.patch_id[patch]}));
  BOOST_TEST(status.place.has_value());
}

BOOST_AUTO_TEST_CASE(walls_over_no_target_are_named) {
  Run run(soup_of(step()));
  run.layering.caps[0].clear();
  const Status status = run.sweep().status();
  BOOST_TEST((status.code == Status_code::inconsistent_levels), name(status.code) << ": " << status.reason);
  BOOST_TEST_REQUIRE(!status.patches.empty());
  for (int id : status.patches) {
    const auto patch = std::find(run.part.patch_id.begin(), run.part.patch_id.end(), id) - run.part.patch_id.begin();
    BOOST_TEST((run.roles.of_patch[patch] != Role::source));
  }
}

BOOST_AUTO_TEST_CASE(every_cut_has_a_row_on_each_layer_it_passes) {
  for (int slabs : {1, 3}) {
    const Run run(soup_of(step()), slabs);
    BOOST_TEST(run.rows.size() == std::size_t(slabs));  // from the higher target to the source
    for (const Cut_row& row : run.rows) {
      BOOST_TEST(row.bottom.size() == row.top.size());
      BOOST_TEST(row.left != row.right);
      for (std::size_t i = 0; i < row.bottom.size(); ++i) {
        const auto &low = run.loops.node(row.bottom[i]).point, &high = run.loops.node(row.top[i]).point;
        BOOST_TEST(low.x() == 4);
        BOOST_TEST(high.x() == 4);
        BOOST_TEST(low.y() == high.y());
        BOOST_TEST(low.z() < high.z());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(new_nodes_of_an_imprint_are_copied_down) {
  random_parts::Plan plan = step();
  plan.tops.push_back({rectangle(2, 3, 6, 5), 5});  // a boss over the step
  const Run run(soup_of(plan));
  std::set<double> on_target;
  for (const Cut_row& row : run.rows)
    if (run.layering.value(row.layer) == 0)
      for (Node_index n : row.bottom) on_target.insert(run.loops.node(n).point.y());
  BOOST_TEST((on_target == std::set<double>{0, 3, 5, 8}));
}

BOOST_AUTO_TEST_CASE(the_cut_surface_is_the_part_with_the_cuts_drawn_on_it) {
  for (const auto& plan : {step(), block_with_hole(), block_with_window()}) {
    const Run run(soup_of(plan), 2);
    BOOST_TEST(is_closed(run.surface.triangles));
    double area = 0, expected = 0;
    for (const auto& t : run.surface.triangles) {
      const auto &a = run.surface.points[t[0]], &b = run.surface.points[t[1]], &c = run.surface.points[t[2]];
      area += std::sqrt(CGAL::squared_area(a, b, c));
    }
    for (double a : run.part.area) expected += a;
    BOOST_TEST(area == expected, boost::test_tools::tolerance(1e-12));
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : run.surface.triangles)
      for (int k = 0; k < 3; ++k) edges.insert({t[k], t[(k + 1) % 3]});
    for (const auto& columns : run.loops.wall_columns)
      for (const auto& column : columns) {
        const auto path = run.surface.path(run.surface.vertex_of_node[column.bottom.value()],
                                           run.surface.vertex_of_node[column.top.value()]);
        for (std::size_t i = 0; i + 1 < path.size(); ++i) BOOST_TEST(edges.count({path[i], path[i + 1]}) == 1u);
      }
  }
}

// A column on a wall from node 0 to 1, an inner one beside it from node 2 to 3, and the vertices between on the wall.
struct Two_columns {
  Layered_loops<Kernel> loops;
  Cut_surface<Kernel> surface;
  std::vector<Cut_row> rows;

  explicit Two_columns(const std::vector<Kernel::Point_3>& between) {
    const Surface_location inside, wall = Surface_location::vertex(0);
    surface.points = {{0, 0, 0}, {0, 0, 4}, {1, 0, 0}, {1, 0, 4}};
    surface.vertex_of_node = {0, 1, 2, 3};
    for (std::size_t n = 0; n < 4; ++n) loops.nodes.push_back({surface.points[n], n < 2 ? wall : inside, false});
    std::vector<std::uint32_t> path{0};
    for (const auto& p : between) {
      path.push_back(static_cast<std::uint32_t>(surface.points.size()));
      surface.points.push_back(p);
    }
    path.push_back(1);
    surface.path_between[{0, 1}] = path;
    rows.push_back({Layer_index(0), {Node_index(0), Node_index(2)}, {Node_index(1), Node_index(3)}, {}, {}, {}});
    internal::Wall_follower<Kernel>(loops, rows, surface).run();
  }
};

BOOST_AUTO_TEST_CASE(a_column_has_vertices_where_the_wall_beside_it_bends) {
  // It bends at height 1, and from there leads straight over 2 to the top.
  const Two_columns bent({{0.3, 0.1, 1}, {0.2, 0.1 * 2 / 3, 2}});
  const auto path = bent.surface.path(2, 3);
  BOOST_TEST_REQUIRE(path.size() == 3u);
  BOOST_TEST((bent.surface.points[path[1]] == Kernel::Point_3(1, 0, 1)));
  BOOST_TEST(Two_columns({{0, 0, 1}, {0, 0, 2}}).surface.path(2, 3).size() == 2u);
}

BOOST_AUTO_TEST_CASE(sub_volumes_close_over_their_cuts) {
  const Run run(soup_of(step()));
  const auto result = make_sub_volumes(run.part, run.roles, run.layering, run.loops, run.rows, run.surface).value();
  BOOST_TEST_REQUIRE(result.volumes.size() == 2u);
  BOOST_TEST_REQUIRE(result.sets.size() == 1u);
  BOOST_TEST((result.sets[0].volumes == std::array{0, 1}));
  for (const auto& volume : result.volumes) {
    BOOST_TEST(CGAL::is_closed(volume.mesh));
    const auto role = volume.mesh.property_map<CGAL::SM_Face_index, int>("f:role").first;
    const auto id = volume.mesh.property_map<CGAL::SM_Face_index, int>("f:patch_id").first;
    std::size_t cut = 0;
    for (auto f : volume.mesh.faces()) {
      cut += role[f] == static_cast<int>(Role::cut);
      BOOST_TEST((role[f] == static_cast<int>(Role::cut)) == (id[f] == result.sets[0].id));
    }
    BOOST_TEST(cut == result.sets[0].triangles);
  }
}

BOOST_AUTO_TEST_CASE(without_cuts_the_sub_volume_is_the_part) {
  const Run run(soup_of(block_with_hole()));
  const auto result = make_sub_volumes(run.part, run.roles, run.layering, run.loops, run.rows, run.surface).value();
  BOOST_TEST_REQUIRE(result.volumes.size() == 1u);
  BOOST_TEST(result.sets.empty());
  BOOST_TEST(result.volumes[0].mesh.number_of_faces() == run.part.mesh.number_of_faces());
  BOOST_TEST(result.volumes[0].mesh.number_of_vertices() == run.part.mesh.number_of_vertices());
}

// Two upright boxes that touch along an edge (or only in a vertex, when the second is lifted) share its vertices.
struct Touching_boxes {
  std::vector<Point> points;
  std::vector<internal::Triangle> triangles;

  explicit Touching_boxes(double lift) {
    add_box(0, 0, 0);
    add_box(1, 1, lift);
  }

  void add_box(double x, double y, double z) {
    std::array<std::uint32_t, 8> v;
    for (int i = 0; i < 8; ++i) v[i] = vertex({x + (i & 1), y + ((i >> 1) & 1), z + ((i >> 2) & 1)});
    const std::array<std::array<int, 4>, 6> sides{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& [a, b, c, d] : sides) {
      triangles.push_back({v[a], v[b], v[c]});
      triangles.push_back({v[a], v[c], v[d]});
    }
  }

  std::uint32_t vertex(const Point& p) {
    const auto found = std::find(points.begin(), points.end(), p);
    const auto number = static_cast<std::uint32_t>(found - points.begin());
    if (found == points.end()) points.push_back(p);
    return number;
  }

  auto fans() const {
    return internal::Fan_separator::run(triangles, [&](std::uint32_t v) { return points[v]; });
  }
};

BOOST_AUTO_TEST_CASE(solids_that_touch_get_vertices_of_their_own) {
  for (double lift : {0., 1.}) {
    const Touching_boxes boxes(lift);
    BOOST_TEST(boxes.points.size() == (lift == 0 ? 14u : 15u));
    const auto fans = boxes.fans();
    BOOST_TEST_REQUIRE(fans.has_value());
    BOOST_TEST(is_closed(*fans));
    std::array<std::set<std::size_t>, 2> of_box;
    for (std::size_t t = 0; t < fans->size(); ++t) of_box[t / 12].insert((*fans)[t].begin(), (*fans)[t].end());
    for (const auto& vertices : of_box) BOOST_TEST(vertices.size() == 8u);
    for (std::size_t v : of_box[0]) BOOST_TEST(of_box[1].count(v) == 0u);
  }
}

BOOST_AUTO_TEST_CASE(an_open_surface_has_no_fans) {
  Touching_boxes boxes(0);
  boxes.triangles.pop_back();
  BOOST_TEST(!boxes.fans().has_value());
}

BOOST_AUTO_TEST_CASE(curves_that_cross_in_a_plane_are_told_with_their_place) {
  internal::Planar_region<Kernel> region;
  region.points = {{1, {0, 0}}, {2, {4, 0}}, {3, {4, 4}}, {4, {0, 4}}, {5, {1, 1}}, {6, {3, 3}}};
  region.boundary = {{1, 2}, {2, 3}, {3, 4}, {4, 1}};
  region.curves = {{5, 6}};
  using Triangulation = internal::Region_triangulation<Kernel>;
  std::uint32_t fault = 0;
  BOOST_TEST(Triangulation::run(region, &fault)->size() == 6u);
  region.points.insert(region.points.end(), {{7, {1, 3}}, {8, {3, 1}}});
  region.curves.push_back({7, 8});
  BOOST_TEST(!Triangulation::run(region, &fault));
  BOOST_TEST(fault == 7u);
}

BOOST_AUTO_TEST_SUITE_END()
