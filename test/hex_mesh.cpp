// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hexahedral meshes of the models and of random parts: what must hold for each of them.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/write_inp.h>
#include <CCSweep/IO/write_msh.h>
#include <CCSweep/IO/write_vtu.h>
#include <CCSweep/decompose.h>
#include <CCSweep/hex_mesh.h>
#include <CCSweep/parameters.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "hex_checks.h"
#include "random_parts.h"

namespace {

namespace fs = std::filesystem;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using CCSweep::Hex_mesh;
using CCSweep::Status_code;
using Direction = std::array<double, 3>;

struct Model {
  CCSweep::Tagged_mesh<Kernel::Point_3> part;
  Direction direction{};
  double extent = 0, volume = 0;
};

double volume_of(const Mesh& mesh) {
  const auto& apex = mesh.point(*mesh.vertices().begin());
  double sum = 0;
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += CGAL::volume(apex, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
  }
  return sum;
}

Model load(const std::string& name) {
  const std::string path = std::string(CCSWEEP_TEST_DATA "/") + name;
  Model model{CCSweep::read_part<Kernel::Point_3>(path + ".ply").value()};
  model.direction = nlohmann::json::parse(std::ifstream(path + ".json"))["sweep_direction"].get<Direction>();
  const auto& mesh = model.part.mesh;
  for (int x = 0; x < 3; ++x) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (auto v : mesh.vertices()) {
      low = std::min(low, mesh.point(v)[x]);
      high = std::max(high, mesh.point(v)[x]);
    }
    model.extent = std::max(model.extent, high - low);
  }
  model.volume = volume_of(mesh);
  return model;
}

std::vector<std::string> sweepable_models() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(CCSWEEP_TEST_DATA))
    if (entry.path().extension() == ".json" &&
        nlohmann::json::parse(std::ifstream(entry.path()))["sweepable"] == true)
      names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

CCSweep::Result<Hex_mesh> mesh(const Mesh& part, const Direction& direction, double size) {
  const auto patch = part.property_map<Mesh::Face_index, int>("f:patch_id").first;
  return CCSweep::hex_mesh(part, CCSweep::parameters::direction(direction).size(size).face_patch_map(patch));
}

void expect_sound(const CCSweep::Result<Hex_mesh>& result, double volume, double share) {
  BOOST_TEST(result.ok(), name(result.status().code) << ": " << result.status().reason);
  if (!result.ok()) return;
  BOOST_TEST(hex_checks::defects(result.value()) == "");
  BOOST_TEST(std::abs(hex_checks::volume(result.value()) - volume) < share * volume);
}

void expect_family_meshed(random_parts::Family family) {
  constexpr std::uint32_t seeds = 10;
  for (std::uint32_t seed = 0; seed < seeds; ++seed)
    BOOST_TEST_CONTEXT("family " << static_cast<int>(family) << " seed " << seed) {
      const auto part = random_parts::make(family, seed);
      expect_sound(mesh(random_parts::mesh<Kernel::Point_3>(part), {0, 0, 1}, 2), part.volume, 0.03);
    }
}

Hex_mesh small_mesh() {
  const Model model = load("parallel_barrels");
  return mesh(model.part.mesh, model.direction, model.extent / 10).value();
}

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

struct Scratch {
  fs::path folder = fs::temp_directory_path() / ("ccsweep_hex_" + std::to_string(std::random_device()()));
  Scratch() { fs::create_directories(folder); }
  ~Scratch() { fs::remove_all(folder); }
};

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_mesh)

BOOST_AUTO_TEST_CASE(every_model_at_three_sizes) {
  for (const std::string& name : sweepable_models())
    for (int parts : {10, 20, 40})
      BOOST_TEST_CONTEXT(name << " at extent/" << parts) {
        const Model model = load(name);
        expect_sound(mesh(model.part.mesh, model.direction, model.extent / parts), model.volume,
                     parts == 40 ? 0.01 : 0.03);
      }
}

BOOST_AUTO_TEST_CASE(one_volume_for_each_target) {
  const Model model = load("parallel_barrels");
  const auto patch = model.part.patch_ids();
  const auto decomposition = CCSweep::decompose(
      model.part.mesh, CCSweep::parameters::direction(model.direction).face_patch_map(patch));
  const Hex_mesh found = small_mesh();
  BOOST_TEST(found.targets.size() == decomposition.value().volumes.size());
  for (std::size_t i = 0; i < found.targets.size(); ++i)
    BOOST_TEST(found.targets[i] == decomposition.value().volumes[i].target);
}

BOOST_AUTO_TEST_CASE(a_decomposition_is_meshed_as_its_part) {
  const Model model = load("tapered_protrusion");
  const auto patch = model.part.patch_ids();
  const auto decomposition = CCSweep::decompose(
      model.part.mesh, CCSweep::parameters::direction(model.direction).face_patch_map(patch));
  expect_sound(CCSweep::hex_mesh(decomposition.value(), CCSweep::parameters::size(model.extent / 20)), model.volume,
               1e-3);
}

BOOST_AUTO_TEST_CASE(the_same_part_gives_the_same_mesh) {
  BOOST_TEST((small_mesh().points == small_mesh().points));
  BOOST_TEST((small_mesh().hexes == small_mesh().hexes));
}

BOOST_AUTO_TEST_CASE(bad_sizes_are_refused) {
  const Model model = load("one_to_one");
  for (double size : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e-9})
    BOOST_TEST(
        (mesh(model.part.mesh, model.direction, size).status().code == Status_code::invalid_parameter));
}

BOOST_AUTO_TEST_CASE(grids) { expect_family_meshed(random_parts::Family::grids); }
BOOST_AUTO_TEST_CASE(barrels) { expect_family_meshed(random_parts::Family::barrels); }
BOOST_AUTO_TEST_CASE(polygons) { expect_family_meshed(random_parts::Family::polygons); }
BOOST_AUTO_TEST_CASE(circles) { expect_family_meshed(random_parts::Family::circles); }
BOOST_AUTO_TEST_CASE(mixed) { expect_family_meshed(random_parts::Family::mixed); }
BOOST_AUTO_TEST_CASE(split) { expect_family_meshed(random_parts::Family::split); }
BOOST_AUTO_TEST_CASE(windows) { expect_family_meshed(random_parts::Family::windows); }

BOOST_AUTO_TEST_CASE(quality_of_a_brick_and_of_a_folded_one) {
  CCSweep::Hex_corners brick{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 3}, {2, 0, 3}, {2, 1, 3}, {0, 1, 3}}};
  BOOST_TEST(std::abs(CCSweep::scaled_jacobian(brick) - 1) < 1e-14);
  BOOST_TEST(CCSweep::is_positive(brick));
  std::swap(brick[0], brick[4]);
  BOOST_TEST(CCSweep::scaled_jacobian(brick) < 0);
  BOOST_TEST(!CCSweep::is_positive(brick));
}

BOOST_AUTO_TEST_CASE(gmsh_files_hold_all_elements) {
  const Scratch scratch;
  const Hex_mesh written = small_mesh();
  const std::string new_file = scratch.folder / "a.msh", old_file = scratch.folder / "b.msh";
  BOOST_TEST(CCSweep::write_msh(written, new_file).ok());
  BOOST_TEST(CCSweep::write_msh(written, old_file, CCSweep::Msh_version::v2_2).ok());
  std::istringstream text(read(old_file));
  std::string line;
  while (line != "$Nodes") std::getline(text, line);
  std::size_t count = 0, tag = 0;
  text >> count;
  BOOST_TEST(count == written.points.size());
  for (std::size_t n = 0; n < count; ++n) {
    Hex_mesh::Point p;
    text >> tag >> p[0] >> p[1] >> p[2];
    BOOST_TEST((p == written.points[n]));
  }
  while (line != "$Elements") std::getline(text, line);
  text >> count;
  BOOST_TEST(count == written.hexes.size() + written.boundary.size());
  std::size_t hexes = 0;
  for (std::size_t e = 0; e < count; ++e) {
    std::size_t type = 0, tags = 0, group = 0, entity = 0, node = 0;
    text >> tag >> type >> tags >> group >> entity;
    hexes += type == 5;
    for (int i = 0; i < (type == 5 ? 8 : 4); ++i) {
      text >> node;
      BOOST_TEST((node >= 1 && node <= written.points.size()));
    }
  }
  BOOST_TEST(hexes == written.hexes.size());
  BOOST_TEST(read(new_file).starts_with("$MeshFormat\n4.1 0 8\n"));
}

BOOST_AUTO_TEST_CASE(abaqus_surfaces_are_the_boundary) {
  const Scratch scratch;
  const Hex_mesh written = small_mesh();
  const auto faces = CCSweep::internal::faces_on_patches(written);
  std::size_t count = 0;
  for (const auto& [patch, sides] : faces) count += sides.size();
  BOOST_TEST(count == written.boundary.size());
  BOOST_TEST(CCSweep::write_inp(written, scratch.folder / "a.inp").ok());
  const std::string text = read(scratch.folder / "a.inp");
  for (std::size_t v = 0; v < written.targets.size(); ++v)
    BOOST_TEST(text.find("ELSET=VOLUME_" + std::to_string(v) + "\n") != std::string::npos);
  for (const auto& [patch, sides] : faces)
    BOOST_TEST(text.find("NSET=PATCH_" + std::to_string(patch) + "\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(vtu_files_come_in_pairs_or_not_at_all) {
  const Scratch scratch;
  BOOST_TEST(CCSweep::write_vtu(small_mesh(), scratch.folder / "a.vtu").ok());
  BOOST_TEST(fs::exists(scratch.folder / "a.vtu"));
  BOOST_TEST(fs::exists(scratch.folder / "a_boundary.vtu"));
  fs::create_directories(scratch.folder / "b_boundary.vtu");
  BOOST_TEST((CCSweep::write_vtu(small_mesh(), scratch.folder / "b.vtu").code == Status_code::write_failed));
  BOOST_TEST(!fs::exists(scratch.folder / "b.vtu"));
}

BOOST_AUTO_TEST_SUITE_END()
