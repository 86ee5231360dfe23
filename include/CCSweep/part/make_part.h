// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_MAKE_PART_H
#define CCSWEEP_PART_MAKE_PART_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Part.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace CCSweep {
namespace internal {

// Copies the input in canonical order. Vertices at the same place (solids that touch in an edge or a vertex) are told
// apart by the coordinates of their neighbours.
template <class Traits, class FaceGraph, class VertexPointMap, class FacePatchMap>
void copy_in_canonical_order(const FaceGraph& input, VertexPointMap point_of, FacePatchMap patch_of, Part<Traits>& part,
                             std::vector<int>& id_of_face) {
  using Graph_traits = boost::graph_traits<FaceGraph>;
  using Point_3 = typename Traits::Point_3;
  std::vector<typename Graph_traits::vertex_descriptor> order(vertices(input).begin(), vertices(input).end());
  auto neighbours = [&](auto v) {
    std::vector<Point_3> points;
    for (auto h : CGAL::halfedges_around_target(v, input)) points.push_back(get(point_of, source(h, input)));
    std::sort(points.begin(), points.end());
    return points;
  };
  std::sort(order.begin(), order.end(), [&](auto v, auto w) {
    const Point_3 &p = get(point_of, v), &q = get(point_of, w);
    if (p != q || v == w) return p < q;
    return neighbours(v) < neighbours(w);
  });
  std::unordered_map<typename Graph_traits::vertex_descriptor, std::size_t> rank;
  part.mesh.reserve(order.size(), 3 * order.size(), 2 * order.size());
  for (auto v : order) {
    rank[v] = part.mesh.number_of_vertices();
    part.mesh.add_vertex(get(point_of, v));
  }
  struct Facet {
    std::array<std::size_t, 3> v;
    int id;
    auto operator<=>(const Facet&) const = default;
  };
  std::vector<Facet> facets;
  for (auto f : faces(input)) {
    auto h = halfedge(f, input);
    std::array<std::size_t, 3> v{rank[source(h, input)], rank[target(h, input)], rank[target(next(h, input), input)]};
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    facets.push_back({v, static_cast<int>(get(patch_of, f))});
  }
  std::sort(facets.begin(), facets.end());
  using Vertex = typename Part<Traits>::Vertex;
  for (const Facet& f : facets) {
    using Size = typename Part<Traits>::Mesh::size_type;
    part.mesh.add_face(Vertex(Size(f.v[0])), Vertex(Size(f.v[1])), Vertex(Size(f.v[2])));
    id_of_face.push_back(f.id);
  }
}

template <class Traits>
void measure(Part<Traits>& part) {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (auto v : part.mesh.vertices()) {
    const Vec3 p = part.coordinates(v);
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
      part.largest_coordinate = std::max(part.largest_coordinate, std::abs(p[i]));
    }
  }
  part.diagonal = norm(high - low);
  for (auto f : part.mesh.faces()) {
    auto h = part.mesh.halfedge(f);
    const Vec3 a = part.coordinates(part.mesh.source(h)), b = part.coordinates(part.mesh.target(h)),
               c = part.coordinates(part.mesh.target(part.mesh.next(h)));
    const Vec3 n = cross(b - a, c - a);
    part.area.push_back(norm(n) / 2);
    part.normal.push_back(unit(n));
  }
}

// A patch id may name several connected pieces; each is a patch of its own inside.
template <class Traits>
void find_patches(Part<Traits>& part, const std::vector<int>& id_of_face) {
  using Face = typename Part<Traits>::Face;
  const auto& mesh = part.mesh;
  part.patch_of_face.assign(mesh.number_of_faces(), Patch_index());
  std::vector<Face> by_id(mesh.faces().begin(), mesh.faces().end());
  std::stable_sort(by_id.begin(), by_id.end(), [&](Face f, Face g) { return id_of_face[f] < id_of_face[g]; });
  for (Face seed : by_id) {
    if (part.patch_of_face[seed].is_valid()) continue;
    const Patch_index patch(part.patch_id.size());
    part.patch_id.push_back(id_of_face[seed]);
    part.patch_of_face[seed] = patch;
    std::vector<Face> stack{seed}, found;
    while (!stack.empty()) {
      const Face f = stack.back();
      stack.pop_back();
      found.push_back(f);
      for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        const Face g = mesh.face(mesh.opposite(h));
        if (part.patch_of_face[g].is_valid() || id_of_face[g] != id_of_face[f]) continue;
        part.patch_of_face[g] = patch;
        stack.push_back(g);
      }
    }
    std::sort(found.begin(), found.end());
    part.largest_face.push_back(*std::max_element(
        found.begin(), found.end(), [&](Face f, Face g) { return part.area[f] < part.area[g]; }));
    part.faces.push_back(std::move(found));
  }
}

// With an exact number type a patch is planar when the predicate says so, otherwise within 1e-12 of the size (and
// what the coordinates themselves can tell).
template <class Traits>
bool is_planar(const Part<Traits>& part, Patch_index patch) {
  const auto& faces = part.faces[patch.value()];
  const auto largest = part.largest_face[patch.value()];
  auto h = part.mesh.halfedge(largest);
  const auto &a = part.point(part.mesh.source(h)), &b = part.point(part.mesh.target(h)),
             &c = part.point(part.mesh.target(part.mesh.next(h)));
  constexpr bool exact = CGAL::Algebraic_structure_traits<typename Traits::FT>::Is_exact::value;
  const Vec3 origin = part.coordinates(a), n = part.normal[largest];
  const double bound = 1e-12 * part.diagonal + 4e-16 * part.largest_coordinate;
  for (auto f : faces)
    for (auto v : part.mesh.vertices_around_face(part.mesh.halfedge(f))) {
      if (exact ? !CGAL::coplanar(a, b, c, part.point(v))
                : std::abs(dot(n, part.coordinates(v) - origin)) > bound)
        return false;
    }
  return true;
}

template <class Traits>
void find_features(Part<Traits>& part) {
  const auto& mesh = part.mesh;
  part.feature.assign(mesh.number_of_edges(), false);
  std::vector<int> degree(mesh.number_of_vertices(), 0);
  for (auto e : mesh.edges()) {
    auto h = mesh.halfedge(e);
    if (part.patch(mesh.face(h)) == part.patch(mesh.face(mesh.opposite(h)))) continue;
    part.feature[e] = true;
    ++degree[mesh.source(h)];
    ++degree[mesh.target(h)];
  }
  part.corner.assign(mesh.number_of_vertices(), false);
  for (auto v : mesh.vertices()) part.corner[v] = degree[v] != 0 && degree[v] != 2;
}

// The two feature edges at a vertex inside a feature curve, pointing to it.
template <class Traits>
std::optional<std::array<typename Part<Traits>::Halfedge, 2>> feature_edges_at(const Part<Traits>& part,
                                                                               typename Part<Traits>::Vertex v) {
  if (part.corner[v]) return std::nullopt;
  std::vector<typename Part<Traits>::Halfedge> incoming;
  for (auto h : part.mesh.halfedges_around_target(part.mesh.halfedge(v)))
    if (part.feature[part.mesh.edge(h)]) incoming.push_back(h);
  if (incoming.size() != 2) return std::nullopt;
  return std::array{incoming[0], incoming[1]};
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
void estimate_chord_errors(Part<Traits>& part) {
  const auto& mesh = part.mesh;
  // A regular 12-gon still is an arc.
  constexpr double polygon = 30.5 * 3.14159265358979323846 / 180, straight = 1e-6;
  part.chord_error.assign(mesh.number_of_edges(), 0);
  for (auto v : mesh.vertices()) {
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
    std::vector<int> id_of_face;
    internal::copy_in_canonical_order(input, point_of, patch_of, part, id_of_face);
    internal::measure(part);
    internal::find_patches(part, id_of_face);
    for (std::size_t p = 0; p < part.number_of_patches(); ++p)
      part.planar.push_back(internal::is_planar(part, Patch_index(p)));
    internal::find_features(part);
    internal::estimate_chord_errors(part);
    return part;
  });
}

}  // namespace CCSweep

#endif
