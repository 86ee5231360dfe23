// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels and mesh types: exact constructions lose no volume, and any halfedge structure will do.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>
#include <CCSweep/verify.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "array_mesh.h"
#include "mesh_changes.h"
#include "random_parts.h"

namespace {

namespace P = CCSweep::parameters;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using mesh_changes::Soup;

constexpr std::array<double, 3> up{0, 0, 1};

Soup model(const std::string& name) {
  return mesh_changes::soup(CCSweep::read_part<Inexact::Point_3>(CCSWEEP_TEST_DATA "/" + name + ".ply").value().mesh);
}

Soup random_part(random_parts::Family family, std::uint32_t seed) {
  const random_parts::Part part = random_parts::make(family, seed);
  return {part.points, part.triangles, part.patch};
}

template <class Mesh>
typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::FT volume(const Mesh& mesh) {
  typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::FT sum = 0;
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += CGAL::volume(typename Mesh::Point(0, 0, 0), mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
  }
  return sum;
}

template <class Outcome>
void require_ok(const Outcome& outcome) {
  BOOST_TEST_REQUIRE(outcome.ok(), name(outcome.status().code) << " in stage " << name(outcome.status().stage) << ": "
                                                               << outcome.status().reason);
}

// No volume is lost, not the smallest number.
void expect_exact(const Soup& soup, std::size_t volumes, std::size_t sets) {
  const auto mesh = mesh_changes::mesh<Exact::Point_3>(soup);
  const auto patch = mesh.property_map<CGAL::SM_Face_index, int>("f:patch_id").first;
  const auto outcome = CCSweep::decompose(mesh, P::direction(up).face_patch_map(patch));
  require_ok(outcome);
  BOOST_TEST(outcome.value().volumes.size() == volumes);
  BOOST_TEST(outcome.value().sets.size() == sets);
  Exact::FT sum = 0;
  for (const auto& v : outcome.value().volumes) sum += volume(v.mesh);
  BOOST_TEST((sum == volume(mesh)));
  const CCSweep::Status status = CCSweep::verify(mesh, patch, outcome.value());
  BOOST_TEST(status.ok(), status.reason);
}

// A box of quads with a step at half its length: targets 0 and 1, source 2; the long walls are hexagons.
struct Polygons {
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<int> patch;
};

Polygons step() {
  return {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {2, 1, 1}, {2, 0, 1}, {0, 0, 2},
           {2, 0, 2}, {2, 1, 2}, {0, 1, 2}},
          {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {0, 8, 11, 1}, {3, 2, 5, 4}, {7, 6, 10, 9}, {0, 3, 4, 7, 9, 8},
           {11, 10, 6, 5, 2, 1}},
          {0, 1, 2, 3, 4, 5, 6, 7}};
}

template <class Outcome>
void expect_step(const Outcome& outcome) {
  require_ok(outcome);
  const auto& found = outcome.value();
  BOOST_TEST_REQUIRE(found.volumes.size() == 2u);
  BOOST_TEST(found.sets.size() == 1u);
  BOOST_TEST(found.volumes[0].target == 0);
  BOOST_TEST(found.volumes[1].target == 1);
  BOOST_TEST((found.volumes[0].sources == std::vector{2}));
  BOOST_TEST((found.volumes[1].sources == std::vector{2}));
  BOOST_TEST(CGAL::to_double(volume(found.volumes[0].mesh)) == 2);
  BOOST_TEST(CGAL::to_double(volume(found.volumes[1].mesh)) == 1);
}

template <class Point>
CGAL::Surface_mesh<Point> polygon_mesh(const Polygons& polygons) {
  CGAL::Surface_mesh<Point> mesh;
  auto patch = mesh.template add_property_map<CGAL::SM_Face_index, int>("f:patch_id", -1).first;
  std::vector<CGAL::SM_Vertex_index> v;
  for (const auto& p : polygons.points) v.push_back(mesh.add_vertex(Point(p[0], p[1], p[2])));
  for (std::size_t i = 0; i < polygons.faces.size(); ++i) {
    std::vector<CGAL::SM_Vertex_index> corners;
    for (std::size_t k : polygons.faces[i]) corners.push_back(v[k]);
    patch[mesh.add_face(corners)] = polygons.patch[i];
  }
  return mesh;
}

template <class Point>
std::vector<Point> points_of(const Polygons& polygons) {
  std::vector<Point> points;
  for (const auto& p : polygons.points) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

Polygons polygons_of(const Soup& soup) {
  Polygons result{soup.points, {}, soup.patch};
  for (const auto& t : soup.triangles) result.faces.push_back({t[0], t[1], t[2]});
  return result;
}

auto decompose_array_mesh(const Polygons& polygons) {
  const array_mesh::Array_mesh mesh(polygons.points.size(), polygons.faces);
  const auto points = points_of<Inexact::Point_3>(polygons);
  const array_mesh::Table_map<array_mesh::Vertex, Inexact::Point_3> point_of{&points};
  const array_mesh::Table_map<array_mesh::Face, int> patch_of{&polygons.patch};
  return CCSweep::decompose(
      mesh, P::direction(up).vertex_point_map(point_of).face_patch_map(patch_of).geom_traits(Inexact()));
}

auto decompose_polyhedron(const Polygons& polygons) {
  using Polyhedron = CGAL::Polyhedron_3<Inexact>;
  using Face = boost::graph_traits<Polyhedron>::face_descriptor;
  const auto mesh = polygon_mesh<Inexact::Point_3>(polygons);
  const auto patch = mesh.property_map<CGAL::SM_Face_index, int>("f:patch_id").first;
  Polyhedron polyhedron;
  std::map<CGAL::SM_Face_index, Face> copies;
  CGAL::copy_face_graph(mesh, polyhedron,
                        CGAL::parameters::face_to_face_map(boost::make_assoc_property_map(copies)));
  std::map<Face, int> ids;
  for (const auto& [original, copy] : copies) ids[copy] = patch[original];
  return CCSweep::decompose(polyhedron, P::direction(up).face_patch_map(boost::make_assoc_property_map(ids)));
}

auto decompose_surface_mesh(const Polygons& polygons) {
  const auto mesh = polygon_mesh<Inexact::Point_3>(polygons);
  return CCSweep::decompose(
      mesh, P::direction(up).face_patch_map(mesh.property_map<CGAL::SM_Face_index, int>("f:patch_id").first));
}

template <class Decomposition>
void expect_same_bytes(const Decomposition& a, const Decomposition& b) {
  BOOST_TEST_REQUIRE(a.volumes.size() == b.volumes.size());
  BOOST_TEST(a.sets.size() == b.sets.size());
  for (std::size_t i = 0; i < a.volumes.size(); ++i) {
    const Soup s = mesh_changes::soup(a.volumes[i].mesh), t = mesh_changes::soup(b.volumes[i].mesh);
    BOOST_TEST((s.points == t.points));
    BOOST_TEST((s.triangles == t.triangles));
    BOOST_TEST((s.patch == t.patch));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(decompose_kernels)

BOOST_AUTO_TEST_CASE(exact_volumes_add_up_to_the_last_digit) {
  BOOST_TEST_CONTEXT("stepped_many_to_many") expect_exact(model("stepped_many_to_many"), 3, 4);
  BOOST_TEST_CONTEXT("parallel_barrels") expect_exact(model("parallel_barrels"), 5, 18);
  using random_parts::Family;
  for (Family family : {Family::grids, Family::polygons, Family::circles, Family::windows})
    BOOST_TEST_CONTEXT("family " << static_cast<int>(family)) {
      const random_parts::Part part = random_parts::make(family, 600);
      expect_exact({part.points, part.triangles, part.patch}, part.sub_volumes.size(), part.sets);
    }
}

BOOST_AUTO_TEST_CASE(an_exact_part_of_polygons_is_decomposed) {
  const auto mesh = polygon_mesh<Exact::Point_3>(step());
  expect_step(CCSweep::decompose(
      mesh, P::direction(up).face_patch_map(mesh.property_map<CGAL::SM_Face_index, int>("f:patch_id").first)));
}

BOOST_AUTO_TEST_CASE(polygons_are_triangulated_in_every_mesh_type) {
  BOOST_TEST_CONTEXT("Surface_mesh") expect_step(decompose_surface_mesh(step()));
  BOOST_TEST_CONTEXT("Polyhedron_3") expect_step(decompose_polyhedron(step()));
  BOOST_TEST_CONTEXT("Array_mesh") expect_step(decompose_array_mesh(step()));
}

BOOST_AUTO_TEST_CASE(the_mesh_type_does_not_change_a_byte) {
  for (const Soup& soup : {model("parallel_barrels"), random_part(random_parts::Family::mixed, 600)}) {
    const Polygons part = polygons_of(soup);
    const auto expected = decompose_surface_mesh(part);
    require_ok(expected);
    const auto polyhedron = decompose_polyhedron(part);
    require_ok(polyhedron);
    expect_same_bytes(polyhedron.value(), expected.value());
    const auto arrays = decompose_array_mesh(part);
    require_ok(arrays);
    expect_same_bytes(arrays.value(), expected.value());
  }
}

BOOST_AUTO_TEST_CASE(a_mesh_without_patches_is_refused) {
  const auto mesh = polygon_mesh<Inexact::Point_3>(step());
  const auto status = CCSweep::decompose(mesh, P::direction(up)).status();
  BOOST_TEST((status.code == CCSweep::Status_code::missing_patch_ids));
}

BOOST_AUTO_TEST_SUITE_END()
