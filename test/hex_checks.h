// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_HEX_CHECKS_H
#define CCSWEEP_TEST_HEX_CHECKS_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/quality.h>
#include <CCSweep/volumes/Decomposition.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

// What must hold for every hexahedral mesh, seen from outside.
namespace hex_checks {

using CCSweep::Hex_mesh;
using Quad = std::array<std::uint32_t, 4>;

inline constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

inline Quad sorted(Quad q) {
  std::sort(q.begin(), q.end());
  return q;
}

/// The faces of all hexahedra, turning outward, by their nodes in order.
inline std::map<Quad, std::vector<Quad>> faces_of(const Hex_mesh& mesh) {
  std::map<Quad, std::vector<Quad>> result;
  for (const auto& hex : mesh.hexes)
    for (const auto& face : faces) {
      const Quad quad{hex[face[0]], hex[face[1]], hex[face[2]], hex[face[3]]};
      result[sorted(quad)].push_back(quad);
    }
  return result;
}

/// The volume within quads that turn outward: of the two ways to split a warped one the mean.
inline double volume(const Hex_mesh& mesh) {
  using namespace CCSweep::internal;
  const Vec3 apex = mesh.points[0];
  double sum = 0;
  for (const auto& quad : mesh.boundary) {
    const auto p = [&](int i) { return mesh.points[quad.nodes[i]] - apex; };
    const auto tetrahedron = [&](int i, int j, int k) { return dot(p(i), cross(p(j), p(k))) / 6; };
    sum += (tetrahedron(0, 1, 2) + tetrahedron(0, 2, 3) + tetrahedron(0, 1, 3) + tetrahedron(1, 2, 3)) / 2;
  }
  return sum;
}

/// What is wrong with a mesh; empty if nothing is.
inline std::string defects(const Hex_mesh& mesh) {
  std::string found;
  if (mesh.hexes.empty()) found += "no hexahedra; ";
  if (std::set<Hex_mesh::Point>(mesh.points.begin(), mesh.points.end()).size() != mesh.points.size())
    found += "coincident nodes; ";
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h)
    if (!CCSweep::is_positive(CCSweep::internal::corners_of(mesh, h))) {
      found += "a folded hexahedron; ";
      break;
    }
  std::set<Quad> boundary;
  for (const auto& quad : mesh.boundary) boundary.insert(sorted(quad.nodes));
  if (boundary.size() != mesh.boundary.size()) found += "a boundary quad twice; ";
  std::map<std::array<std::uint32_t, 2>, int> turns;
  for (const auto& [key, quads] : faces_of(mesh)) {
    if (quads.size() > 2) found += "a face in more than two hexahedra; ";
    if ((quads.size() == 1) != (boundary.count(key) == 1)) {
      found += "the boundary quads are not the faces used once; ";
      break;
    }
  }
  for (const auto& quad : mesh.boundary)
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t a = quad.nodes[i], b = quad.nodes[(i + 1) % 4];
      turns[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  for (const auto& [edge, sum] : turns)
    if (sum != 0) {
      found += "the boundary is not closed; ";
      break;
    }
  return found;
}

/// The volume within a closed triangle mesh.
template <class Mesh>
double volume_within(const Mesh& mesh) {
  const auto& apex = mesh.point(*mesh.vertices().begin());
  double sum = 0;
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += CGAL::to_double(CGAL::volume(apex, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                        mesh.point(mesh.target(mesh.next(h)))));
  }
  return sum;
}

using Part_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

/// Meshes a part with the face property `f:patch_id`; the direction of nothing lets the part choose its own. In a file
/// of its own, so that the library is compiled once.
CCSweep::Result<Hex_mesh> mesh(const Part_mesh& part, const std::array<double, 3>& direction, double size);

/// Meshes a sub-volume by itself.
CCSweep::Result<Hex_mesh> mesh(const CCSweep::Sub_volume<Part_mesh::Point>& volume, double size);

/// Expects a mesh without defects, the volume of which is right but for a share.
inline void expect_sound(const CCSweep::Result<Hex_mesh>& result, double volume_expected, double share) {
  BOOST_TEST(result.ok(), name(result.status().code) << ": " << result.status().reason);
  if (!result.ok()) return;
  BOOST_TEST(defects(result.value()) == "");
  BOOST_TEST(std::abs(volume(result.value()) - volume_expected) < share * volume_expected);
}

}  // namespace hex_checks

#endif
