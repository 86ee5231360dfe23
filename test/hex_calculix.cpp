// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The patch test: a mesh whose boundary is displaced linearly is strained constantly, as CalculiX finds it. A mesh with
// a gap between its sub-volumes, or an element that is turned inside out, would not be.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/write_inp.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include "hex_checks.h"

namespace {

namespace fs = std::filesystem;
using CCSweep::Hex_mesh;

#ifdef CCSWEEP_CCX
constexpr const char* ccx = CCSWEEP_CCX;
#else
constexpr const char* ccx = "";
#endif
constexpr bool has_ccx = ccx[0] != 0;

constexpr double gradient[3][3] = {{1e-3, 2e-4, -1e-4}, {3e-4, -5e-4, 2e-4}, {1e-4, -3e-4, 7e-4}};

double displacement(const Hex_mesh::Point& p, int x) {
  double u = 0;
  for (int y = 0; y < 3; ++y) u += gradient[x][y] * p[y];
  return u;
}

// What turns the mesh into a problem of statics.
std::string problem(const Hex_mesh& mesh) {
  std::ostringstream out;
  out.precision(13);  // CalculiX reads no more than 20 characters
  out << "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000., 0.3\n";
  for (std::size_t v = 0; v < mesh.targets.size(); ++v)
    out << "*SOLID SECTION, ELSET=VOLUME_" << v << ", MATERIAL=STEEL\n";
  out << "*STEP\n*STATIC\n*BOUNDARY\n";
  std::set<std::uint32_t> nodes;
  for (const auto& quad : mesh.boundary) nodes.insert(quad.nodes.begin(), quad.nodes.end());
  for (std::uint32_t n : nodes)
    for (int x = 0; x < 3; ++x)
      out << n + 1 << ", " << x + 1 << ", " << x + 1 << ", " << displacement(mesh.points[n], x) << '\n';
  for (std::size_t v = 0; v < mesh.targets.size(); ++v) out << "*EL PRINT, ELSET=VOLUME_" << v << "\nE\n";
  out << "*END STEP\n";
  return out.str();
}

struct Strains {
  std::size_t points = 0;
  double worst = 0;  // how far any component is from what it should be
};

Strains read_strains(const fs::path& file) {
  constexpr int pairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  Strains strains;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    std::istringstream values(line);
    std::size_t element = 0, point = 0;
    std::array<double, 6> strain;
    if (!(values >> element >> point)) continue;
    for (double& e : strain) values >> e;
    if (!values) continue;
    ++strains.points;
    for (int i = 0; i < 6; ++i) {
      const auto& [x, y] = pairs[i];
      strains.worst = std::max(strains.worst, std::abs(strain[i] - (gradient[x][y] + gradient[y][x]) / 2));
    }
  }
  return strains;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hex_calculix)

BOOST_AUTO_TEST_CASE(a_linear_displacement_strains_constantly, *boost::unit_test::enable_if<has_ccx>()) {
  const std::string path = std::string(CCSWEEP_TEST_DATA "/parallel_barrels");
  const auto part =
      CCSweep::read_part<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>(path + ".ply").value();
  const auto direction =
      nlohmann::json::parse(std::ifstream(path + ".json"))["sweep_direction"].get<std::array<double, 3>>();
  const Hex_mesh mesh = hex_checks::mesh(part.mesh, direction, 6).value();
  BOOST_TEST(mesh.targets.size() > 1);

  const fs::path folder = fs::temp_directory_path() / ("ccsweep_ccx_" + std::to_string(std::random_device()()));
  fs::create_directories(folder);
  BOOST_TEST(CCSweep::write_inp(mesh, folder / "part.inp").ok());
  std::ofstream(folder / "part.inp", std::ios::app) << problem(mesh);
  const std::string command = "cd " + folder.string() + " && " + ccx + " part > log.txt 2>&1";
  BOOST_TEST(std::system(command.c_str()) == 0);
  const Strains strains = read_strains(folder / "part.dat");
  BOOST_TEST(strains.points == 8 * mesh.hexes.size());
  BOOST_TEST(strains.worst < 1e-6 * gradient[0][0]);
  fs::remove_all(folder);
}

BOOST_AUTO_TEST_SUITE_END()
