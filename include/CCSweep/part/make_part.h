// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_MAKE_PART_H
#define CCSWEEP_PART_MAKE_PART_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/Union_find.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/canonical_copy.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

template <class Traits>
void measure(Part<Traits>& part) {
  const auto& mesh = part.mesh;
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (auto v : mesh.vertices()) {
    const Vec3 p = part.coordinates(v);
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
      part.largest_coordinate = std::max(part.largest_coordinate, std::abs(p[i]));
    }
  }
  part.diagonal = norm(high - low);
  part.area.resize(mesh.number_of_faces());
  part.normal.resize(mesh.number_of_faces());
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const Vec3 a = part.coordinates(mesh.source(h)), b = part.coordinates(mesh.target(h)),
               c = part.coordinates(mesh.target(mesh.next(h)));
    const Vec3 n = cross(b - a, c - a);
    const double twice = norm(n);
    part.area[f] = twice / 2;
    part.normal[f] = twice > 0 ? (1 / twice) * n : n;
  }
}

// A patch id may name several connected pieces; each is a patch of its own inside. Patches come by their ids, and those
// of one id by their first faces.
template <class Traits>
void find_patches(Part<Traits>& part, const std::vector<int>& id_of_face) {
  const auto& mesh = part.mesh;
  Union_find pieces(mesh.number_of_faces());
  for (auto e : mesh.edges()) {
    const auto f = mesh.face(mesh.halfedge(e)), g = mesh.face(mesh.opposite(mesh.halfedge(e)));
    if (id_of_face[f] == id_of_face[g]) pieces.join(f, g);
  }
  std::vector<std::size_t> roots;
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    if (pieces.root(f) == f) roots.push_back(f);
  std::stable_sort(roots.begin(), roots.end(),
                   [&](std::size_t f, std::size_t g) { return id_of_face[f] < id_of_face[g]; });
  part.patch_of_face.resize(mesh.number_of_faces());
  for (std::size_t root : roots) {
    part.patch_of_face[root] = Patch_index(part.patch_id.size());
    part.patch_id.push_back(id_of_face[root]);
  }
  part.faces.resize(roots.size());
  part.area_of_patch.resize(roots.size(), 0);
  for (std::size_t root : roots) part.largest_face.emplace_back(root);
  for (auto f : mesh.faces()) {
    const Patch_index patch = part.patch_of_face[pieces.root(f)];
    part.patch_of_face[f] = patch;
    part.faces[patch.value()].push_back(f);
    part.area_of_patch[patch.value()] += part.area[f];
    auto& largest = part.largest_face[patch.value()];
    if (part.area[f] > part.area[largest]) largest = f;
  }
}

struct Vertex_features {
  std::vector<std::uint32_t> degree;  // per vertex: the number of feature edges at it
  std::vector<Patch_index> patch;     // per vertex: one that it is on
};

// Finds the feature edges and the corners.
template <class Traits>
Vertex_features find_features(Part<Traits>& part) {
  const auto& mesh = part.mesh;
  part.feature.assign(mesh.number_of_edges(), false);
  part.border.resize(part.number_of_patches());
  Vertex_features result{std::vector<std::uint32_t>(mesh.number_of_vertices(), 0),
                         std::vector<Patch_index>(mesh.number_of_vertices())};
  auto& degree = result.degree;
  for (auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e), o = mesh.opposite(h);
    const Patch_index p = part.patch(mesh.face(h)), q = part.patch(mesh.face(o));
    result.patch[mesh.source(h)] = result.patch[mesh.target(h)] = p;
    if (p == q) continue;
    part.feature[e] = true;
    part.border[p.value()].push_back(h);
    part.border[q.value()].push_back(o);
    ++degree[mesh.source(h)];
    ++degree[mesh.target(h)];
  }
  part.corner.assign(mesh.number_of_vertices(), false);
  for (auto v : mesh.vertices()) part.corner[v] = degree[v] != 0 && degree[v] != 2;
  return result;
}

// Face by face, and in the sense around each.
template <class Traits>
void sort_borders(Part<Traits>& part) {
  const auto& mesh = part.mesh;
  auto rank = [&](auto h) {
    const auto f = mesh.face(h);
    return std::pair(f, h == mesh.halfedge(f) ? 0 : mesh.prev(h) == mesh.halfedge(f) ? 1 : 2);
  };
  for (auto& border : part.border)
    std::sort(border.begin(), border.end(), [&](auto g, auto h) { return rank(g) < rank(h); });
}

// The plane of a patch's largest face. With an exact number type a point is on it when the predicate says so, otherwise
// within 1e-12 of the size (and what the coordinates themselves can tell).
template <class Traits>
class Patch_plane {
 public:
  Patch_plane(const Part<Traits>& part, Patch_index patch)
      : part_(part), normal_(part.normal[face(patch)]),
        bound_(1e-12 * part.diagonal + 4e-16 * part.largest_coordinate) {
    const auto h = part.mesh.halfedge(face(patch));
    corners_ = {part.mesh.source(h), part.mesh.target(h), part.mesh.target(part.mesh.next(h))};
    origin_ = part.coordinates(corners_[0]);
  }

  bool has_on(typename Part<Traits>::Vertex v) const {
    if constexpr (CGAL::Algebraic_structure_traits<typename Traits::FT>::Is_exact::value) {
      return CGAL::coplanar(part_.point(corners_[0]), part_.point(corners_[1]), part_.point(corners_[2]),
                            part_.point(v));
    } else {
      return std::abs(dot(normal_, part_.coordinates(v) - origin_)) <= bound_;
    }
  }

 private:
  typename Part<Traits>::Face face(Patch_index patch) const { return part_.largest_face[patch.value()]; }

  const Part<Traits>& part_;
  Vec3 normal_, origin_;
  double bound_;
  std::array<typename Part<Traits>::Vertex, 3> corners_;
};

// A patch is planar where its border and the vertices inside it, which have no feature edge, are.
template <class Traits>
void find_planar_patches(Part<Traits>& part, const Vertex_features& features) {
  const auto& mesh = part.mesh;
  std::vector<Patch_plane<Traits>> planes;
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) {
    planes.emplace_back(part, Patch_index(p));
    part.planar.push_back(std::all_of(part.border[p].begin(), part.border[p].end(),
                                      [&](auto h) { return planes[p].has_on(mesh.target(h)); }));
  }
  for (auto v : mesh.vertices()) {
    if (features.degree[v] != 0) continue;
    const std::size_t p = features.patch[v].value();
    if (part.planar[p] && !planes[p].has_on(v)) part.planar[p] = false;
  }
}

// The two feature edges at a vertex inside a feature curve, pointing to it.
template <class Traits>
std::optional<std::array<typename Part<Traits>::Halfedge, 2>> feature_edges_at(const Part<Traits>& part,
                                                                               typename Part<Traits>::Vertex v) {
  if (part.corner[v]) return std::nullopt;
  std::array<typename Part<Traits>::Halfedge, 2> incoming;
  std::size_t number = 0;
  for (auto h : part.mesh.halfedges_around_target(part.mesh.halfedge(v)))
    if (part.feature[part.mesh.edge(h)]) incoming[number++] = h;  // as v is no corner, it has two or none
  if (number != 2) return std::nullopt;
  return incoming;
}

// How far a feature curve that runs along two edges which meet in a vertex turns there.
template <class Traits>
double turn_between(const Part<Traits>& part, typename Part<Traits>::Halfedge in,
                    typename Part<Traits>::Halfedge other) {
  const Vec3 p = part.coordinates(part.mesh.target(in));
  return angle(p - part.coordinates(part.mesh.source(in)), part.coordinates(part.mesh.source(other)) - p);
}

// The edges of the straight run of a feature curve that ends with a halfedge: vertices on a chord don't make it finer.
template <class Traits>
std::vector<typename Part<Traits>::Halfedge> chord_ending_with(const Part<Traits>& part,
                                                               typename Part<Traits>::Halfedge last) {
  constexpr double straight = 1e-6;
  std::vector<typename Part<Traits>::Halfedge> chord{last};
  for (;;) {
    const auto edges = feature_edges_at(part, part.mesh.source(chord.back()));
    if (!edges) return chord;
    const auto onward = part.mesh.opposite(chord.back()) == (*edges)[0] ? (*edges)[1] : (*edges)[0];
    if (onward == last || turn_between(part, part.mesh.opposite(chord.back()), onward) > straight) return chord;
    chord.push_back(onward);
  }
}

// Where a feature curve turns by less than 30 degrees inside, it stands for an arc: a chord of length l under the
// angle a of the arc bulges by l/2 tan(a/4). The arc's angle is shared out between neighbours by length; neighbours
// of very different length are a straight edge that ends in an arc. A tenth more makes up for the estimate.
template <class Traits>
void estimate_chord_errors(Part<Traits>& part, const std::vector<std::uint32_t>& degree) {
  const auto& mesh = part.mesh;
  // A regular 12-gon still is an arc.
  constexpr double polygon = 30.5 * 3.14159265358979323846 / 180, straight = 1e-6;
  part.chord_error.assign(mesh.number_of_edges(), 0);
  for (auto v : mesh.vertices()) {
    if (degree[v] != 2) continue;
    const auto edges = feature_edges_at(part, v);
    if (!edges) continue;
    const double turn = turn_between(part, (*edges)[0], (*edges)[1]);
    if (turn > polygon || turn <= straight) continue;
    const auto left = chord_ending_with(part, (*edges)[0]), right = chord_ending_with(part, (*edges)[1]);
    auto length = [&](const auto& chord) {
      return norm(part.coordinates(mesh.target(chord.front())) - part.coordinates(mesh.source(chord.back())));
    };
    const double la = length(left), lb = length(right);
    if (la > 3 * lb || lb > 3 * la) continue;
    auto raise = [&](const auto& chord, double l, double other) {
      for (auto h : chord) {
        double& error = part.chord_error[mesh.edge(h)];
        error = std::max(error, 1.1 * l / 2 * std::tan(turn * l / (l + other) / 2));
      }
    };
    raise(left, la, lb);
    raise(right, lb, la);
  }
}

}  // namespace internal

/// Copies a closed triangle mesh into canonical order and finds its patches, feature curves and corners.
///
/// \tparam Traits a model of `SweepTraits`
/// \tparam FaceGraph a model of `SweepMesh`, closed and triangulated
/// \tparam VertexPointMap a readable property map from vertices to `Traits::Point_3`
/// \tparam FacePatchMap a readable property map from faces to an integer, the patch id
/// \return the part; its `Patch_index`es are ordered by patch id.
/// Complexity: O(n log n) in the number of vertices and faces.
template <class Traits, class FaceGraph, class VertexPointMap, class FacePatchMap>
Result<Part<Traits>> make_part(const FaceGraph& input, VertexPointMap point_of, FacePatchMap patch_of) {
  return internal::guarded([&] {
    Part<Traits> part;
    const std::vector<int> id_of_face = internal::copy_in_canonical_order(input, point_of, patch_of, part.mesh);
    internal::measure(part);
    internal::find_patches(part, id_of_face);
    const internal::Vertex_features features = internal::find_features(part);
    internal::sort_borders(part);
    internal::find_planar_patches(part, features);
    internal::estimate_chord_errors(part, features.degree);
    return part;
  });
}

}  // namespace CCSweep

#endif
