// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_PRISMS_H
#define CCSWEEP_TEST_PRISMS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

// Prisms along y, of few large facets: the outline is seen from the front, in x and z, counterclockwise.
namespace prisms {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// A corner of an outline, and the patch over the edge that starts there.
struct Corner {
  double x, z;
  int patch;
};
using Outline = std::vector<Corner>;

inline constexpr double length = 3;

/// A low box beside a taller one that reaches down deeper.
/// \param roof of the low box, from (2, 1) to (0, 1) or wherever its other wall ends
inline Outline low_box_beside_tall_one(const Outline& roof = {{2, 1, 15}, {0, 1, 16}}) {
  Outline outline{{2, 0, 10}, {2, -1, 11}, {4, -1, 12}, {4, 3.5, 13}, {2, 3.5, 14}};
  outline.insert(outline.end(), roof.begin(), roof.end());
  outline.push_back({0, 0, 17});
  return outline;
}

/// A part with the face property `f:patch_id`: 0 in front, 1 at the back.
/// \param shear how far it leans to the side, for each unit along y
inline Mesh prism(const Outline& outline, double shear = 0) {
  Mesh mesh;
  auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch_id", -1).first;
  std::vector<Mesh::Vertex_index> front, back;
  for (const Corner& corner : outline) {
    front.push_back(mesh.add_vertex({corner.x, 0, corner.z}));
    back.push_back(mesh.add_vertex({corner.x + shear * length, length, corner.z}));
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t j = (i + 1) % outline.size();
    patch[mesh.add_face(front[i], back[i], back[j], front[j])] = outline[i].patch;
  }
  patch[mesh.add_face(front)] = 0;
  patch[mesh.add_face(std::vector(back.rbegin(), back.rend()))] = 1;
  return mesh;
}

inline double volume(const Outline& outline) {
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto &p = outline[i], &q = outline[(i + 1) % outline.size()];
    area += (p.x * q.z - p.z * q.x) / 2;
  }
  return length * area;
}

}  // namespace prisms

#endif
