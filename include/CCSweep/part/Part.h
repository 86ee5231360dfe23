// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_PART_H
#define CCSWEEP_PART_PART_H

#include <CCSweep/indices.h>

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace CCSweep {

/// The input seen as patches, feature curves and corners.
///
/// The mesh is a copy of the input in canonical order (vertices by coordinates, faces by vertices), so that all that
/// follows is the same however the input was ordered. A *patch* is a connected piece of the faces of one patch id; a
/// *feature edge* lies between two patches; a *corner* is a vertex where feature curves end or more than two meet.
template <class Traits>
struct Part {
  using Point_3 = typename Traits::Point_3;
  using Mesh = CGAL::Surface_mesh<Point_3>;
  using Vertex = typename Mesh::Vertex_index;
  using Halfedge = typename Mesh::Halfedge_index;
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;
  using Vector = std::array<double, 3>;

  Mesh mesh;
  std::vector<Patch_index> patch_of_face;       ///< by face
  std::vector<int> patch_id;                    ///< by patch: the id of the input
  std::vector<std::vector<Face>> faces;         ///< by patch
  std::vector<std::vector<Halfedge>> border;    ///< by patch: the sides of its faces along feature edges
  std::vector<Face> largest_face;               ///< by patch
  std::vector<double> area_of_patch;            ///< by patch
  std::vector<bool> planar;                     ///< by patch: all its vertices lie in one plane
  std::vector<Vector> normal;                   ///< by face: unit normal
  std::vector<double> area;                     ///< by face
  std::vector<bool> feature;                    ///< by edge
  std::vector<bool> corner;                     ///< by vertex
  std::vector<double> chord_error;              ///< by edge: how far the arc it stands for may bulge from it
  double diagonal = 0;                          ///< of the bounding box
  double largest_coordinate = 0;                ///< in absolute value

  std::size_t number_of_patches() const { return patch_id.size(); }
  Patch_index patch(Face f) const { return patch_of_face[f]; }
  int id(Patch_index p) const { return patch_id[p.value()]; }
  const Point_3& point(Vertex v) const { return mesh.point(v); }

  /// The faces that tell all normals of a patch: of a planar one the largest, as the normal of a needle is noise.
  std::span<const Face> facing(Patch_index p) const {
    if (planar[p.value()]) return {&largest_face[p.value()], 1};
    return faces[p.value()];
  }

  /// The halfedge that fractions along an edge are counted from. An edge made from a halfedge gives that one back, so
  /// asking the mesh would depend on who asks.
  Halfedge first_halfedge(Edge e) const {
    return Halfedge(2 * static_cast<typename Mesh::size_type>(e));
  }

  Vector coordinates(Vertex v) const { return coordinates(mesh.point(v)); }
  static Vector coordinates(const Point_3& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }
};

/// Small vector algebra in double for measures and heuristics; decisions on topology use the traits' predicates.
namespace internal {

using Vec3 = std::array<double, 3>;

inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
/// The opposite vector, without negative zeros.
inline Vec3 reversed(Vec3 a) {
  for (double& x : a) x = x == 0 ? 0 : -x;
  return a;
}
inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline Vec3 unit(const Vec3& a) {
  const double n = norm(a);
  return n > 0 ? (1 / n) * a : a;
}
/// Two unit vectors that span the plane across `up` and turn counter-clockwise about it: the coordinate axis that is
/// most across, brought into the plane, and its cross product.
inline std::array<Vec3, 2> axes_across(const Vec3& up) {
  int least = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(up[i]) < std::abs(up[least])) least = i;
  Vec3 axis{};
  axis[least] = 1;
  const Vec3 x = unit(axis - dot(axis, up) * up);
  return {x, cross(up, x)};
}
/// The angle between two vectors in radians, also where it is tiny.
inline double angle(const Vec3& a, const Vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

}  // namespace internal
}  // namespace CCSweep

#endif
