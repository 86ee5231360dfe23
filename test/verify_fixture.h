// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_VERIFY_FIXTURE_H
#define CCSWEEP_TEST_VERIFY_FIXTURE_H

#include <CCSweep/volumes/Decomposition.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace verify_fixture {

/// Triangles as a list, which can be damaged in ways that a halfedge structure would refuse.
template <class Point>
struct Soup {
  using Mesh = CGAL::Surface_mesh<Point>;
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> patch, role;

  std::size_t vertex(double x, double y, double z) {
    const Point p(x, y, z);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i] == p) return i;
    points.push_back(p);
    return points.size() - 1;
  }

  void triangle(std::array<std::size_t, 3> t, int patch_id, CCSweep::Role r) {
    triangles.push_back(t);
    patch.push_back(patch_id);
    role.push_back(static_cast<int>(r));
  }

  /// A convex polygon as a fan, counter-clockwise from outside.
  void polygon(const std::vector<std::array<double, 3>>& corners, int patch_id,
               CCSweep::Role r = CCSweep::Role::linking) {
    std::vector<std::size_t> v;
    for (const auto& c : corners) v.push_back(vertex(c[0], c[1], c[2]));
    for (std::size_t i = 2; i < v.size(); ++i) triangle({v[0], v[i - 1], v[i]}, patch_id, r);
  }

  /// A triangle that does not fit gets vertices of its own.
  Mesh mesh() const {
    Mesh result;
    auto ids = result.template add_property_map<typename Mesh::Face_index, int>("f:patch_id", -1).first;
    auto roles = result.template add_property_map<typename Mesh::Face_index, int>("f:role", 0).first;
    std::vector<typename Mesh::Vertex_index> v;
    for (const Point& p : points) v.push_back(result.add_vertex(p));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const auto& t = triangles[i];
      auto f = result.add_face(v[t[0]], v[t[1]], v[t[2]]);
      if (f == Mesh::null_face())
        f = result.add_face(result.add_vertex(points[t[0]]), result.add_vertex(points[t[1]]),
                            result.add_vertex(points[t[2]]));
      ids[f] = patch[i];
      roles[f] = role[i];
    }
    return result;
  }
};

/// A step and its decomposition: a tall box (x from 0 to 1, z from 0 to 2, target 0) beside a short one (x from 1 to
/// 2, z from 1 to 2, target 1) under one common source (patch 2), cut at x = 1 (id 8).
template <class Point>
struct Step {
  using Role = CCSweep::Role;
  Soup<Point> input;
  std::array<Soup<Point>, 2> volumes;
  CCSweep::Decomposition<Point> result;  ///< without the meshes

  Step() {
    make_input();
    make_tall();
    make_short();
    for (int i : {0, 1}) {
      result.volumes.emplace_back();
      result.volumes[i].target = i;
      result.volumes[i].sources = {2};
    }
    result.sets = {{8, {0, 1}, 2}};
    result.roles = {{0, Role::target},  {1, Role::target},  {2, Role::source},  {3, Role::linking},
                    {4, Role::linking}, {5, Role::linking}, {6, Role::linking}, {7, Role::linking}};
    result.direction = {0, 0, 1};
  }

  CCSweep::Decomposition<Point> decomposition() const {
    CCSweep::Decomposition<Point> d = result;
    for (std::size_t i = 0; i < 2 && i < d.volumes.size(); ++i) d.volumes[i].mesh = volumes[i].mesh();
    return d;
  }

 private:
  void make_input() {
    input.polygon({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, 0, Role::target);
    input.polygon({{1, 0, 1}, {1, 1, 1}, {2, 1, 1}, {2, 0, 1}}, 1, Role::target);
    input.polygon({{0, 0, 2}, {2, 0, 2}, {2, 1, 2}, {0, 1, 2}}, 2, Role::source);
    input.polygon({{0, 0, 0}, {0, 0, 2}, {0, 1, 2}, {0, 1, 0}}, 3);
    input.polygon({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, 4);
    input.polygon({{2, 0, 1}, {2, 1, 1}, {2, 1, 2}, {2, 0, 2}}, 5);
    input.polygon({{1, 0, 1}, {2, 0, 1}, {2, 0, 2}, {0, 0, 2}, {0, 0, 0}, {1, 0, 0}}, 6);
    input.polygon({{1, 1, 1}, {1, 1, 0}, {0, 1, 0}, {0, 1, 2}, {2, 1, 2}, {2, 1, 1}}, 7);
  }

  void make_tall() {
    Soup<Point>& v = volumes[0];
    v.polygon({{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}}, 0, Role::target);
    v.polygon({{0, 0, 2}, {1, 0, 2}, {1, 1, 2}, {0, 1, 2}}, 2, Role::source);
    v.polygon({{0, 0, 0}, {0, 0, 2}, {0, 1, 2}, {0, 1, 0}}, 3);
    v.polygon({{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, 4);
    v.polygon({{1, 0, 1}, {1, 1, 1}, {1, 1, 2}, {1, 0, 2}}, 8, Role::cut);
    v.polygon({{1, 0, 1}, {1, 0, 2}, {0, 0, 2}, {0, 0, 0}, {1, 0, 0}}, 6);
    v.polygon({{1, 1, 1}, {1, 1, 0}, {0, 1, 0}, {0, 1, 2}, {1, 1, 2}}, 7);
  }

  void make_short() {
    Soup<Point>& v = volumes[1];
    v.polygon({{1, 0, 1}, {1, 1, 1}, {2, 1, 1}, {2, 0, 1}}, 1, Role::target);
    v.polygon({{1, 0, 2}, {2, 0, 2}, {2, 1, 2}, {1, 1, 2}}, 2, Role::source);
    v.polygon({{2, 0, 1}, {2, 1, 1}, {2, 1, 2}, {2, 0, 2}}, 5);
    v.polygon({{1, 0, 1}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}}, 6);
    v.polygon({{1, 1, 1}, {1, 1, 2}, {2, 1, 2}, {2, 1, 1}}, 7);
    v.triangle({v.vertex(1, 0, 1), v.vertex(1, 1, 2), v.vertex(1, 1, 1)}, 8, Role::cut);
    v.triangle({v.vertex(1, 0, 1), v.vertex(1, 0, 2), v.vertex(1, 1, 2)}, 8, Role::cut);
  }
};

}  // namespace verify_fixture

#endif
