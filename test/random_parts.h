// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_RANDOM_PARTS_H
#define CCSWEEP_TEST_RANDOM_PARTS_H

#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <string>

#include "random_parts_answer.h"
#include "random_plans.h"

// A seeded generator of straight multi-sweep parts with a known answer; see `Family`, `Plan`, `Part` and `build()`.
namespace random_parts {

/// The part of a seed: the first plan from there on that makes a sound one.
inline Part make(Family family, std::uint32_t seed, bool may_touch_itself = false) {
  Generator generator(family, seed);
  for (;;)
    if (std::optional<Part> part = build(generator.plan()); part && (may_touch_itself || !part->touches_itself))
      return *part;
}

/// The part moved by `f`, which takes and returns a point.
template <class Function>
Part moved(Part part, Function f) {
  for (auto& p : part.points) p = f(p);
  return part;
}

/// Turned about two axes, scaled, then shifted. The sweep then runs along `turned({0, 0, 1})`.
inline std::array<double, 3> turned(const std::array<double, 3>& p) {
  const std::array<double, 3> q{0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2]};
  return {q[0], 5.0 / 13 * q[1] - 12.0 / 13 * q[2], 12.0 / 13 * q[1] + 5.0 / 13 * q[2]};
}

inline Part placed(const Part& part, bool turn, double scale, const std::array<double, 3>& shift) {
  Part result = moved(part, [&](std::array<double, 3> p) {
    if (turn) p = turned(p);
    for (int k = 0; k < 3; ++k) p[k] = scale * p[k] + shift[k];
    return p;
  });
  const double factor = scale * scale * scale;
  result.volume *= factor;
  for (auto& [target, volume] : result.sub_volumes) volume *= factor;
  return result;
}

/// The part as a mesh with the face property `f:patch_id`.
template <class Point>
CGAL::Surface_mesh<Point> mesh(const Part& part) {
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh result;
  auto patch = result.template add_property_map<typename Mesh::Face_index, int>("f:patch_id", -1).first;
  std::vector<typename Mesh::Vertex_index> v;
  for (const auto& p : part.points) v.push_back(result.add_vertex(Point(p[0], p[1], p[2])));
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const auto& t = part.triangles[i];
    patch[result.add_face(v[t[0]], v[t[1]], v[t[2]])] = part.patch[i];
  }
  return result;
}

/// Writes the part as ascii PLY with the face property `patch_id`.
inline void write_ply(const Part& part, std::ostream& out) {
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "ply\nformat ascii 1.0\nelement vertex " << part.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << part.triangles.size()
      << "\nproperty list uchar int vertex_indices\nproperty int patch_id\nend_header\n";
  for (const auto& p : part.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (std::size_t i = 0; i < part.triangles.size(); ++i)
    out << "3 " << part.triangles[i][0] << ' ' << part.triangles[i][1] << ' ' << part.triangles[i][2] << ' '
        << part.patch[i] << '\n';
}

/// The same into a file; false when it can't be written.
inline bool write_ply(const Part& part, const std::string& file) {
  std::ofstream out(file);
  write_ply(part, out);
  return static_cast<bool>(out.flush());
}

}  // namespace random_parts

#endif
