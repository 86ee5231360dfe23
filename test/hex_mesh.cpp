// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Hexahedral meshes of the models, the sizes and policies that make them, and the files they are written to.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/write_hex_mesh.h>
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
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "hex_checks.h"

namespace {

namespace fs = std::filesystem;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using CCSweep::Hex_mesh;
using hex_checks::expect_sound;
using hex_checks::mesh;
using CCSweep::Status_code;
using Direction = std::array<double, 3>;

struct Model {
  CCSweep::Tagged_mesh<Kernel::Point_3> part;
  Direction direction{};
  double extent = 0, volume = 0;
};

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
  model.volume = hex_checks::volume_within(mesh);
  return model;
}

double least_quality(const Hex_mesh& mesh) {
  const auto quality = CCSweep::scaled_jacobians(mesh);
  return *std::min_element(quality.begin(), quality.end());
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
        for (const auto& direction : {model.direction, Direction{}}) {  // as it is known, and as it is chosen
          const auto found = mesh(model.part.mesh, direction, model.extent / parts);
          expect_sound(found, model.volume, parts == 40 ? 0.01 : 0.03);
          // The angles of the models are in the way of none.
          BOOST_TEST(tightest_bound(found.value()).scaled_jacobian > 0.8);
          BOOST_TEST(least_quality(found.value()) > (parts == 20 ? 0.3 : 0.2));
        }
      }
}

// A circle's centre may fall on an edge of a cap's outline, which gets no other nodes.
BOOST_AUTO_TEST_CASE(points_inside_do_not_fall_on_the_outline) {
  const auto part = CCSweep::read_part<Kernel::Point_3>(std::string(CCSWEEP_TEST_DATA) + "/leaning_holes.ply").value();
  expect_sound(mesh(part.mesh, Direction{}, 2), hex_checks::volume_within(part.mesh), 0.03);
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

BOOST_AUTO_TEST_CASE(quality_of_a_brick_and_of_a_folded_one) {
  CCSweep::Hex_corners brick{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {0, 0, 3}, {2, 0, 3}, {2, 1, 3}, {0, 1, 3}}};
  BOOST_TEST(std::abs(CCSweep::scaled_jacobian(brick) - 1) < 1e-14);
  BOOST_TEST(CCSweep::is_positive(brick));
  std::swap(brick[0], brick[4]);
  BOOST_TEST(CCSweep::scaled_jacobian(brick) < 0);
  BOOST_TEST(!CCSweep::is_positive(brick));
}

BOOST_AUTO_TEST_CASE(sizes_on_a_patch_refine_its_curves) {
  const Model model = load("one_to_one");
  const auto patch = model.part.patch_ids();
  const double size = model.extent / 10;
  const auto coarse = mesh(model.part.mesh, model.direction, size);
  const int target = coarse.value().targets[0];
  const auto meshed = [&](const CCSweep::Patch_sizes& sizes) {
    return CCSweep::hex_mesh(model.part.mesh, CCSweep::parameters::direction(model.direction)
                                                  .size(sizes)
                                                  .face_patch_map(patch));
  };
  const auto fine = meshed(CCSweep::Patch_sizes(size).patch(target, size / 3));
  expect_sound(fine, model.volume, 0.03);
  BOOST_TEST(fine.value().hexes.size() > 2 * coarse.value().hexes.size());
  BOOST_TEST((meshed(CCSweep::Patch_sizes(size).patch(target, -1)).status().code == Status_code::invalid_parameter));
}

BOOST_AUTO_TEST_CASE(quads_can_be_made_by_a_policy) {
  const Model model = load("cylinder");
  const auto patch = model.part.patch_ids();
  const auto np = CCSweep::parameters::direction(model.direction).size(model.extent / 10).face_patch_map(patch);
  expect_sound(CCSweep::hex_mesh(model.part.mesh, np.quad_mesher(CCSweep::Matched_quads())), model.volume, 0.03);
}

// What a reader finds in a file: nodes, hexahedra, and quads with the number of their patch's group.
struct Read_mesh {
  std::vector<Hex_mesh::Point> points;
  std::vector<std::array<std::uint32_t, 8>> hexes;
  std::vector<std::array<std::uint32_t, 4>> quads;
};

void expect_same(const Read_mesh& found, const Hex_mesh& written, double tolerance = 0) {
  BOOST_TEST_REQUIRE(found.points.size() == written.points.size());
  for (std::size_t n = 0; n < found.points.size(); ++n)
    for (std::size_t x = 0; x < 3; ++x)
      BOOST_TEST(std::abs(found.points[n][x] - written.points[n][x]) <= tolerance);
  auto hexes = written.hexes, found_hexes = found.hexes;
  std::sort(hexes.begin(), hexes.end());
  std::sort(found_hexes.begin(), found_hexes.end());
  BOOST_TEST((found_hexes == hexes));
  for (const auto& hex : found.hexes) {
    CCSweep::Hex_corners corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = found.points[hex[i]];
    BOOST_TEST(CCSweep::scaled_jacobian(corners) > 0);
  }
  std::set<std::array<std::uint32_t, 4>> quads;
  for (const auto& quad : written.boundary) quads.insert(quad.nodes);
  BOOST_TEST((std::set(found.quads.begin(), found.quads.end()) == quads));
}

template <std::size_t n>
std::array<std::uint32_t, n> read_nodes(std::istream& in) {
  std::array<std::uint32_t, n> nodes;
  for (auto& node : nodes) {
    in >> node;
    --node;
  }
  return nodes;
}

void skip_to(std::istream& in, const std::string& section) {
  for (std::string line; line != section && std::getline(in, line);) continue;
}

Read_mesh read_msh_2_2(std::istream& in) {
  Read_mesh mesh;
  std::size_t count = 0, tag = 0;
  skip_to(in, "$Nodes");
  in >> count;
  for (std::size_t n = 0; n < count; ++n) {
    auto& p = mesh.points.emplace_back();
    in >> tag >> p[0] >> p[1] >> p[2];
  }
  skip_to(in, "$Elements");
  in >> count;
  for (std::size_t e = 0; e < count; ++e) {
    int type = 0, tags = 0, group = 0, entity = 0;
    in >> tag >> type >> tags >> group >> entity;
    if (type == 5) mesh.hexes.push_back(read_nodes<8>(in));
    if (type == 3) mesh.quads.push_back(read_nodes<4>(in));
  }
  return mesh;
}

Read_mesh read_msh_4_1(std::istream& in) {
  Read_mesh mesh;
  std::size_t blocks = 0, count = 0, low = 0, high = 0, tag = 0;
  skip_to(in, "$Nodes");
  in >> blocks >> count >> low >> high;
  for (std::size_t b = 0; b < blocks; ++b) {
    int dimension = 0, entity = 0, parametric = 0;
    in >> dimension >> entity >> parametric >> count;
    for (std::size_t n = 0; n < count; ++n) in >> tag;
    for (std::size_t n = 0; n < count; ++n) {
      auto& p = mesh.points.emplace_back();
      in >> p[0] >> p[1] >> p[2];
    }
  }
  skip_to(in, "$Elements");
  in >> blocks >> count >> low >> high;
  for (std::size_t b = 0; b < blocks; ++b) {
    int dimension = 0, entity = 0, type = 0;
    in >> dimension >> entity >> type >> count;
    for (std::size_t e = 0; e < count; ++e) {
      in >> tag;
      if (type == 5) mesh.hexes.push_back(read_nodes<8>(in));
      if (type == 3) mesh.quads.push_back(read_nodes<4>(in));
    }
  }
  return mesh;
}

BOOST_AUTO_TEST_CASE(gmsh_files_read_again_are_the_mesh) {
  const Scratch scratch;
  const Hex_mesh written = small_mesh();
  const std::string new_file = scratch.folder / "a.msh", old_file = scratch.folder / "b.msh";
  BOOST_TEST(CCSweep::write_msh(written, new_file).ok());
  BOOST_TEST(CCSweep::write_msh(written, old_file, CCSweep::Msh_version::v2_2).ok());
  std::istringstream new_text(read(new_file)), old_text(read(old_file));
  expect_same(read_msh_4_1(new_text), written);
  expect_same(read_msh_2_2(old_text), written);
}

// An array of a VTU file, found by its name.
template <class T>
std::vector<T> vtu_array(const std::string& text, const std::string& name) {
  const std::size_t tag = text.find("Name=\"" + name + "\"");
  const std::size_t offset = text.find("offset=\"", tag) + 8;
  const char* data = text.data() + text.find("_", text.find("<AppendedData")) + 1 + std::stoul(text.substr(offset));
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, data, sizeof bytes);
  std::vector<T> values(bytes / sizeof(T));
  std::memcpy(values.data(), data + sizeof bytes, bytes);
  return values;
}

BOOST_AUTO_TEST_CASE(vtu_files_read_again_are_the_mesh) {
  const Scratch scratch;
  const Hex_mesh written = small_mesh();
  BOOST_TEST(CCSweep::write_vtu(written, scratch.folder / "a.vtu").ok());
  const std::string text = read(scratch.folder / "a.vtu"), border = read(scratch.folder / "a_boundary.vtu");
  Read_mesh found;
  const auto points_of = [](const std::string& file) {
    const auto flat = vtu_array<double>(file, "Points");
    std::vector<Hex_mesh::Point> points;
    for (std::size_t i = 0; i < flat.size(); i += 3) points.push_back({flat[i], flat[i + 1], flat[i + 2]});
    return points;
  };
  found.points = points_of(text);
  const auto nodes = vtu_array<std::int64_t>(text, "connectivity");
  for (std::size_t i = 0; i < nodes.size(); i += 8) {
    auto& hex = found.hexes.emplace_back();
    for (std::size_t k = 0; k < 8; ++k) hex[k] = static_cast<std::uint32_t>(nodes[i + k]);
  }
  BOOST_TEST((vtu_array<std::int32_t>(text, "volume_id") == written.volume));
  BOOST_TEST((vtu_array<double>(text, "scaled_jacobian") == CCSweep::scaled_jacobians(written)));
  std::map<Hex_mesh::Point, std::uint32_t> number;
  for (std::uint32_t n = 0; n < found.points.size(); ++n) number[found.points[n]] = n;
  const auto border_points = points_of(border);
  const auto corners = vtu_array<std::int64_t>(border, "connectivity");
  for (std::size_t i = 0; i < corners.size(); i += 4) {
    auto& quad = found.quads.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) quad[k] = number.at(border_points[corners[i + k]]);
  }
  expect_same(found, written);
}

Read_mesh read_inp(std::istream& in) {
  Read_mesh mesh;
  std::map<std::size_t, std::array<std::uint32_t, 8>> hexes;
  std::string line, keyword;
  while (std::getline(in, line)) {
    if (line[0] == '*') {
      keyword = line.substr(0, line.find(','));
      continue;
    }
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream values(line);
    std::size_t tag = 0;
    std::string side;
    values >> tag;
    if (keyword == "*NODE") {
      auto& p = mesh.points.emplace_back();
      values >> p[0] >> p[1] >> p[2];
    } else if (keyword == "*ELEMENT") {
      mesh.hexes.push_back(hexes[tag] = read_nodes<8>(values));
    } else if (keyword == "*SURFACE") {
      values >> side;
      // The faces of a C3D8 as its manual lists them, turned outward.
      constexpr std::size_t faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                           {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
      auto& quad = mesh.quads.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) quad[k] = hexes.at(tag)[faces[side[1] - '1'][k]];
    }
  }
  return mesh;
}

// So that the lowest node comes first, which turns no quad over.
std::array<std::uint32_t, 4> rotated(std::array<std::uint32_t, 4> quad) {
  std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
  return quad;
}

BOOST_AUTO_TEST_CASE(abaqus_files_read_again_are_the_mesh) {
  const Scratch scratch;
  Hex_mesh written = small_mesh();
  BOOST_TEST(CCSweep::write_inp(written, scratch.folder / "a.inp").ok());
  std::istringstream text(read(scratch.folder / "a.inp"));
  Read_mesh found = read_inp(text);
  for (auto& quad : found.quads) quad = rotated(quad);
  for (auto& quad : written.boundary) quad.nodes = rotated(quad.nodes);
  expect_same(found, written, 1e-10);  // a number has no more than 20 characters there
}

BOOST_AUTO_TEST_CASE(several_files_are_written_or_none) {
  const Scratch scratch;
  const Hex_mesh written = small_mesh();
  const auto file = [&](const char* name) { return (scratch.folder / name).string(); };
  BOOST_TEST(CCSweep::write_hex_mesh(written, {file("a.vtu"), file("a.msh"), file("a.inp")}).ok());
  fs::create_directories(scratch.folder / "b.inp");
  BOOST_TEST((CCSweep::write_hex_mesh(written, {file("b.msh"), file("b.inp")}).code == Status_code::write_failed));
  BOOST_TEST(!fs::exists(file("b.msh")));
  BOOST_TEST((CCSweep::write_hex_mesh(written, {file("c.msh"), file("c.obj")}).code == Status_code::invalid_parameter));
  BOOST_TEST(!fs::exists(file("c.msh")));
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
