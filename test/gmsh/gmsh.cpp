// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What needs Gmsh: it opens the files that are written and finds the same mesh, and it meshes caps.
#define BOOST_TEST_MODULE ccsweep_gmsh
#include <boost/test/unit_test.hpp>

#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/write_msh.h>
#include <CCSweep/hex/Gmsh_quads.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex_mesh.h>
#include <CCSweep/parameters.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "hex_checks.h"

namespace {

namespace fs = std::filesystem;
using CCSweep::Hex_mesh;
using Part = CCSweep::Tagged_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

static_assert(CCSweep::QuadMesher<CCSweep::Gmsh_quads>);

Part load(const std::string& name) {
  return CCSweep::read_part<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>(
             std::string(CCSWEEP_TEST_DATA "/") + name + ".ply")
      .value();
}

// The elements of each physical group of a dimension, by the group's name.
std::map<std::string, std::size_t> groups(int dimension, int type) {
  std::map<std::string, std::size_t> result;
  gmsh::vectorpair found;
  gmsh::model::getPhysicalGroups(found, dimension);
  for (const auto& [d, tag] : found) {
    std::string name;
    gmsh::model::getPhysicalName(d, tag, name);
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(d, tag, entities);
    for (const int entity : entities) {
      std::vector<std::size_t> elements, nodes;
      gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
      result[name] += elements.size();
    }
  }
  return result;
}

void expect_opened(const std::string& file, const Hex_mesh& written) {
  constexpr int quad = 3, hexahedron = 5;
  gmsh::open(file);
  std::vector<std::size_t> nodes;
  std::vector<double> places, parameters;
  gmsh::model::mesh::getNodes(nodes, places, parameters);
  BOOST_TEST(nodes.size() == written.points.size());
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 3);
  BOOST_TEST((types == std::vector<int>{hexahedron}));

  std::map<std::string, std::size_t> volumes, patches;
  for (const int v : written.volume) ++volumes["volume_" + std::to_string(v)];
  for (const auto& q : written.boundary) ++patches["patch_" + std::to_string(q.patch_id)];
  BOOST_TEST((groups(3, hexahedron) == volumes));
  BOOST_TEST((groups(2, quad) == patches));

  std::vector<double> corners, jacobians, determinants, at;
  for (int i = 0; i < 8; ++i)
    for (int x = 0; x < 3; ++x) corners.push_back((i >> x & 1) * 2 - 1);
  gmsh::model::mesh::getJacobians(hexahedron, corners, jacobians, determinants, at);
  BOOST_TEST(determinants.size() == 8 * written.hexes.size());
  BOOST_TEST(*std::min_element(determinants.begin(), determinants.end()) > 0);
  gmsh::clear();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(gmsh_tests)

BOOST_AUTO_TEST_CASE(written_files_are_opened) {
  const Part part = load("parallel_barrels");
  const Hex_mesh mesh = hex_checks::mesh(part.mesh, {0, 0, 1}, 6).value();
  BOOST_TEST(mesh.targets.size() > 1);
  const fs::path folder = fs::temp_directory_path() / ("ccsweep_gmsh_" + std::to_string(std::random_device()()));
  fs::create_directories(folder);
  const auto session = CCSweep::internal::Gmsh_session::share();
  for (const auto version : {CCSweep::Msh_version::v4_1, CCSweep::Msh_version::v2_2}) {
    const std::string file = folder / (version == CCSweep::Msh_version::v4_1 ? "4_1.msh" : "2_2.msh");
    BOOST_TEST_REQUIRE(CCSweep::write_msh(mesh, file, version).ok());
    BOOST_TEST_CONTEXT(file) expect_opened(file, mesh);
  }
  fs::remove_all(folder);
}

BOOST_AUTO_TEST_CASE(caps_are_meshed) {
  for (const std::string name : {"cylinder", "tapered_protrusion", "parallel_barrels"}) {
    const Part part = load(name);
    const double volume = hex_checks::volume_within(part.mesh);
    const auto np = CCSweep::parameters::direction(std::array<double, 3>{0, 0, 1})
                        .size(std::cbrt(volume) / 10)
                        .face_patch_map(part.patch_ids());
    BOOST_TEST_CONTEXT(name)
    hex_checks::expect_sound(CCSweep::hex_mesh(part.mesh, np.quad_mesher(CCSweep::Gmsh_quads())), volume, 0.03);
  }
}

// The nodes of the loops come first and stay where they are.
BOOST_AUTO_TEST_CASE(the_outline_is_kept) {
  CCSweep::Quad_region region;
  region.loops.resize(2);
  for (int i = 0; i < 24; ++i) {
    const double angle = i * std::acos(-1.0) / 12;
    region.loops[0].nodes.push_back({3 * std::cos(angle), 3 * std::sin(angle)});
    if (i % 2 == 0) region.loops[1].nodes.push_back({std::cos(angle), -std::sin(angle)});
  }
  const auto mesh = CCSweep::Gmsh_quads()(region, 0.7);
  BOOST_TEST_REQUIRE(mesh.has_value());
  BOOST_TEST(CCSweep::worst_quality(*mesh) > 0.3);
  std::size_t n = 0;
  for (const auto& loop : region.loops)
    for (const auto& p : loop.nodes) BOOST_TEST((mesh->points[n++] == p));
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& quad : mesh->quads)
    for (std::size_t i = 0; i < 4; ++i) ++uses[std::minmax(quad[i], quad[(i + 1) % 4])];
  BOOST_TEST(std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second == 1; }) == 36);
}

BOOST_AUTO_TEST_SUITE_END()
