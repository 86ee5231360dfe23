// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_SCENE_H
#define CCSWEEP_INTERNAL_VERIFY_SCENE_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/volumes/Decomposition.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The check of a finished decomposition shares no code with the stages that make it. It reads the input and the
// sub-volumes into plain arrays and gives equal points equal numbers; all checks but the distances to the input
// patches are decided on these numbers or by exact predicates.
namespace CCSweep::internal::verification {

using Triple = std::array<std::uint32_t, 3>;
using Place = std::array<double, 3>;

[[noreturn]] inline void reject(std::string reason, std::vector<int> patches = {},
                                std::optional<Place> place = std::nullopt) {
  std::sort(patches.begin(), patches.end());
  patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
  fail(Status_code::verification_failed, Stage::verification, std::move(reason), std::move(patches), place);
}

/// A kernel with exact predicates over the points of a result: doubles are exact numbers whatever kernel they
/// came with, any other number type is taken to be exact itself.
template <class Point>
struct Exact_kernel {
  using Given = typename CGAL::Kernel_traits<Point>::Kernel;
  static constexpr bool rounded = std::is_floating_point_v<typename Given::FT>;
  using type = std::conditional_t<rounded, CGAL::Exact_predicates_inexact_constructions_kernel, Given>;
};

/// A triangle mesh as arrays.
struct Surface {
  std::string title;                    ///< how the status speaks of it
  std::vector<Triple> vertices;         ///< the triangles, as the mesh indexes them
  std::vector<Triple> points;           ///< the same, by the numbers of the distinct points
  std::vector<int> patch;               ///< of each triangle
  std::vector<int> role;                ///< of each triangle; empty for the input
  std::vector<std::uint32_t> opposite;  ///< of each halfedge 3 t + k, which leads from corner k to corner k + 1
  std::size_t number_of_vertices = 0;
};

/// The input and the sub-volumes over one list of distinct points.
template <class Kernel>
struct Scene {
  using Point_3 = typename Kernel::Point_3;

  std::vector<Point_3> points;  ///< distinct, in lexicographic order
  std::vector<Place> near;      ///< the same rounded, relative to `centre`
  std::vector<char> two_zeros;  ///< whether the point is written with both -0 and +0 in the result
  Surface input;
  std::vector<Surface> volumes;
  std::vector<int> patches;  ///< the ids of the input patches, ascending
  Place centre{};
  double diagonal = 0;  ///< of the bounding box
  double extent = 0;    ///< the largest absolute coordinate
  bool exact = false;   ///< whether the coordinates carry no rounding at all

  bool is_input_patch(int patch) const { return std::binary_search(patches.begin(), patches.end(), patch); }

  Place place(std::uint32_t point) const {
    return {near[point][0] + centre[0], near[point][1] + centre[1], near[point][2] + centre[2]};
  }

  Place place(const Triple& t) const {
    Place sum{};
    for (int i = 0; i < 3; ++i) sum[i] = (near[t[0]][i] + near[t[1]][i] + near[t[2]][i]) / 3 + centre[i];
    return sum;
  }
};

inline Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Place& a, const Place& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Place& a) { return std::sqrt(dot(a, a)); }
inline Place cross(const Place& a, const Place& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The vector area of a triangle, rounded.
template <class Kernel>
Place vector_area(const Scene<Kernel>& scene, const Triple& t) {
  const Place& origin = scene.near[t[0]];
  Place n = cross(minus(scene.near[t[1]], origin), minus(scene.near[t[2]], origin));
  return {n[0] / 2, n[1] / 2, n[2] / 2};
}

/// A frame along the sweep: there walls stand upright and caps lie flat, so that few bounding boxes overlap however
/// the part is turned.
class Sweep_frame {
 public:
  explicit Sweep_frame(const Place& direction) {
    const double l = length(direction);
    const Place d = l > 0 ? Place{direction[0] / l, direction[1] / l, direction[2] / l} : Place{0, 0, 1};
    int smallest = 0;
    for (int k = 1; k < 3; ++k)
      if (std::abs(d[k]) < std::abs(d[smallest])) smallest = k;
    Place helper{};
    helper[smallest] = 1;
    Place u = cross(d, helper);
    const double m = length(u);
    for (double& x : u) x /= m;
    axes_ = {u, cross(d, u), d};
  }

  Place operator()(const Place& p) const { return {dot(axes_[0], p), dot(axes_[1], p), dot(axes_[2], p)}; }

 private:
  std::array<Place, 3> axes_;
};

/// Union-find over 0 ... n-1.
class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // The smaller index leads, so that the leader of a group does not depend on the order of the unions.
  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    if (i != j) parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

template <class Kernel, class Point>
typename Kernel::Point_3 to_point(const Point& p) {
  if constexpr (std::is_same_v<Point, typename Kernel::Point_3>) {
    return p;
  } else {
    using FT = typename Kernel::FT;
    return typename Kernel::Point_3(FT(p.x()), FT(p.y()), FT(p.z()));
  }
}

/// Reads a mesh; its points are appended to `points`, its `points` member is filled later.
template <class Kernel, class FaceGraph, class PointMap, class PatchMap>
Surface read_surface(const FaceGraph& mesh, PointMap point_of, PatchMap patch_of, std::string title,
                     std::vector<typename Kernel::Point_3>& points) {
  Surface surface;
  surface.title = std::move(title);
  if (!CGAL::is_valid_polygon_mesh(mesh)) reject(surface.title + " is not a valid halfedge structure");
  auto number = get(CGAL::dynamic_vertex_property_t<std::uint32_t>(), mesh);
  for (auto v : CGAL::make_range(vertices(mesh))) {
    const typename Kernel::Point_3 p = to_point<Kernel>(get(point_of, v));
    if (!CGAL::is_finite(p.x()) || !CGAL::is_finite(p.y()) || !CGAL::is_finite(p.z()))
      reject(surface.title + " has a coordinate that is not finite");
    points.push_back(p);
    put(number, v, static_cast<std::uint32_t>(surface.number_of_vertices++));
  }
  for (auto f : CGAL::make_range(faces(mesh))) {
    auto h = halfedge(f, mesh);
    if (!CGAL::is_triangle(h, mesh)) reject(surface.title + " has a face that is no triangle", {get(patch_of, f)});
    surface.vertices.push_back(
        {get(number, source(h, mesh)), get(number, target(h, mesh)), get(number, target(next(h, mesh), mesh))});
    surface.patch.push_back(get(patch_of, f));
  }
  if (surface.vertices.empty()) reject(surface.title + " has no triangles");
  return surface;
}

/// Gives equal points equal numbers, in lexicographic order, and tells which points are written with both zeros.
template <class Kernel>
std::vector<std::uint32_t> number_points(const std::vector<typename Kernel::Point_3>& all, std::size_t result_begin,
                                         Scene<Kernel>& scene) {
  std::vector<std::uint32_t> order(all.size()), number(all.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto &p = all[a], &q = all[b];
    return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : p.z() != q.z() ? p.z() < q.z() : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || all[order[i - 1]] != all[order[i]]) {
      scene.points.push_back(all[order[i]]);
      scene.two_zeros.push_back(false);
    } else if (std::is_floating_point_v<typename Kernel::FT> && order[i - 1] >= result_begin) {
      for (int k = 0; k < 3; ++k)
        if (std::signbit(CGAL::to_double(all[order[i]][k])) != std::signbit(CGAL::to_double(all[order[i - 1]][k])))
          scene.two_zeros.back() = true;
    }
    number[order[i]] = static_cast<std::uint32_t>(scene.points.size() - 1);
  }
  return number;
}

/// Measures of the input, and all points relative to the middle of its bounding box.
template <class Kernel>
void measure(Scene<Kernel>& scene) {
  std::vector<Place> rounded;
  for (const auto& p : scene.points)
    rounded.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  const double huge = std::numeric_limits<double>::infinity();
  Place low{huge, huge, huge}, high{-huge, -huge, -huge};
  for (const Triple& t : scene.input.points)
    for (std::uint32_t v : t)
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], rounded[v][k]);
        high[k] = std::max(high[k], rounded[v][k]);
      }
  for (int k = 0; k < 3; ++k) {
    scene.centre[k] = low[k] + (high[k] - low[k]) / 2;
    scene.extent = std::max({scene.extent, std::abs(low[k]), std::abs(high[k])});
  }
  scene.diagonal = length(minus(high, low));
  for (const Place& p : rounded) scene.near.push_back(minus(p, scene.centre));
}

template <class Point>
std::string title(const Decomposition<Point>& result, std::size_t volume) {
  return "sub-volume " + std::to_string(volume) + " (target " + std::to_string(result.volumes[volume].target) + ")";
}

/// Reads sub-volume `i` with the ids and the roles of its faces.
template <class Kernel, class Point>
Surface read_volume(const Decomposition<Point>& result, std::size_t i, std::vector<typename Kernel::Point_3>& points) {
  using Volume = Sub_volume<Point>;
  using Face = typename Volume::Mesh::Face_index;
  const auto& mesh = result.volumes[i].mesh;
  auto [patch_of, has_patches] = mesh.template property_map<Face, int>(Volume::patch_id_map);
  auto [role_of, has_roles] = mesh.template property_map<Face, int>(Volume::role_map);
  if (!has_patches || !has_roles)
    reject(title(result, i) + " lacks the face properties that hold patch ids and roles", {result.volumes[i].target});
  Surface surface = read_surface<Kernel>(mesh, mesh.points(), patch_of, title(result, i), points);
  for (Face f : mesh.faces()) surface.role.push_back(role_of[f]);
  return surface;
}

/// Reads the input and the result.
template <class Kernel, class FaceGraph, class PointMap, class PatchMap, class Point>
Scene<Kernel> read_scene(const FaceGraph& input, PointMap point_of, PatchMap patch_of,
                         const Decomposition<Point>& result) {
  Scene<Kernel> scene;
  scene.exact = !std::is_floating_point_v<typename Kernel::FT>;
  std::vector<typename Kernel::Point_3> all;
  scene.input = read_surface<Kernel>(input, point_of, patch_of, "the input", all);
  const std::size_t result_begin = all.size();
  for (std::size_t i = 0; i < result.volumes.size(); ++i) scene.volumes.push_back(read_volume<Kernel>(result, i, all));

  const std::vector<std::uint32_t> number = number_points(all, result_begin, scene);
  std::size_t offset = 0;
  auto fill = [&](Surface& surface) {
    for (const Triple& t : surface.vertices)
      surface.points.push_back({number[offset + t[0]], number[offset + t[1]], number[offset + t[2]]});
    offset += surface.number_of_vertices;
  };
  fill(scene.input);
  for (Surface& volume : scene.volumes) fill(volume);

  scene.patches = scene.input.patch;
  std::sort(scene.patches.begin(), scene.patches.end());
  scene.patches.erase(std::unique(scene.patches.begin(), scene.patches.end()), scene.patches.end());
  measure(scene);
  return scene;
}

}  // namespace CCSweep::internal::verification

#endif
