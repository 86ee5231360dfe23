// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_COVERAGE_H
#define CCSWEEP_INTERNAL_VERIFY_COVERAGE_H

#include <CCSweep/internal/verify_known.h>
#include <CCSweep/internal/verify_partition.h>
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <iterator>

namespace CCSweep::internal::verification {

/// A directed edge between two points, by its smaller point first.
struct Edge {
  std::uint32_t low, high;
  bool forward;
  auto operator<=>(const Edge&) const = default;
};

/// The edges of oriented triangles that are left when opposite ones cancel.
inline std::vector<Edge> boundary_of(const std::vector<Triple>& triangles) {
  std::vector<Edge> edges, boundary;
  for (const Triple& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    std::ptrdiff_t sum = 0;
    for (; j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high; ++j)
      sum += edges[j].forward ? 1 : -1;
    for (; sum != 0; sum += sum > 0 ? -1 : 1) boundary.push_back({edges[i].low, edges[i].high, sum > 0});
  }
  return boundary;
}

/// The outer triangles against the input: each lies on the patch it names, turned the same way, and each connected
/// piece of a patch keeps its area. As the outer triangles close (see `check_curves()`) and none is turned over,
/// they cover a piece the same number of times everywhere; by its area, once. Most triangles are those of the input and
/// need no look.
///
/// On a flat patch it is enough that the triangles lie in its plane and their boundary on its boundary. That saves
/// the search among the long thin facets of a flat patch, which is slow.
template <class Kernel>
class Coverage {
  using Double = CGAL::Simple_cartesian<double>;
  template <class Primitive>
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Double, Primitive>>;
  using Segments = std::vector<Double::Segment_3>;
  using Segment_tree = Tree<CGAL::AABB_segment_primitive<Double, Segments::const_iterator>>;
  using Triangles = std::vector<Double::Triangle_3>;
  using Triangle_tree = Tree<CGAL::AABB_triangle_primitive<Double, Triangles::const_iterator>>;

  struct Patch {
    int id = -1;
    std::vector<std::uint32_t> facets;  ///< of the input
    std::vector<Triple> outer;          ///< triangles of the sub-volumes that carry its id and are none of the input
    bool is_flat = false;
    Place normal{}, middle{};           ///< unit normal and a point of its plane, if it is flat
  };

 public:
  Coverage(const Scene<Kernel>& scene, const Place& direction)
      : scene_(scene),
        frame_(direction),
        tolerance_(1e-9 * scene.diagonal + 1e-14 * scene.extent),
        pieces_(scene.input.points.size()),
        is_kept_(scene.input.points.size(), false),
        covered_(scene.input.points.size()) {
    const Surface& input = scene.input;
    for (std::uint32_t h = 0; h < input.opposite.size(); ++h)
      if (input.patch[h / 3] == input.patch[input.opposite[h] / 3]) pieces_.unite(h / 3, input.opposite[h] / 3);
  }

  void check() {
    std::map<int, Patch> patches;
    for (std::uint32_t t = 0; t < scene_.input.patch.size(); ++t) patches[scene_.input.patch[t]].facets.push_back(t);
    for (auto& [id, patch] : patches) {
      patch.id = id;
      patch.is_flat = is_flat(patch);
      if (!patch.is_flat) continue;
      for (std::uint32_t t : patch.facets) pieces_.unite(patch.facets.front(), t);
    }
    distribute(patches);
    for (const auto& [id, patch] : patches)
      if (!patch.outer.empty()) patch.is_flat ? check_flat(patch) : check_curved(patch);
    check_areas();
  }

 private:
  void distribute(std::map<int, Patch>& patches) {
    const Known_triangles known(scene_.input, scene_.points.size());
    for (const Surface& volume : scene_.volumes)
      for (std::size_t t = 0; t < volume.patch.size(); ++t) {
        if (!scene_.is_input_patch(volume.patch[t])) continue;
        const Triple& p = volume.points[t];
        if (const auto kept = known.find(p, volume.patch[t])) {
          is_kept_[*kept] = true;
          covered_[pieces_.find(*kept)] += length(vector_area(scene_, p));
        } else {
          patches[volume.patch[t]].outer.push_back(p);
        }
      }
  }

  /// Finds the plane of a patch. None of its facets may be turned over in it.
  bool is_flat(Patch& patch) const {
    Place sum{};
    for (std::uint32_t t : patch.facets) {
      const Place n = vector_area(scene_, scene_.input.points[t]);
      for (int k = 0; k < 3; ++k) sum[k] += n[k];
    }
    const double size = length(sum);
    if (!(size > 0)) return false;
    for (int k = 0; k < 3; ++k) patch.normal[k] = sum[k] / size;
    patch.middle = scene_.near[scene_.input.points[patch.facets.front()][0]];
    return std::all_of(patch.facets.begin(), patch.facets.end(), [&](std::uint32_t t) {
      const Triple& p = scene_.input.points[t];
      return dot(vector_area(scene_, p), patch.normal) > 0 &&
             std::all_of(p.begin(), p.end(), [&](std::uint32_t v) { return is_in_plane(patch, v); });
    });
  }

  bool is_in_plane(const Patch& patch, std::uint32_t v) const {
    return std::abs(dot(patch.normal, minus(scene_.near[v], patch.middle))) <= tolerance_;
  }

  /// Where the triangles that are none of the input have to lie.
  std::vector<std::uint32_t> replaced_facets(const Patch& patch) const {
    std::vector<std::uint32_t> result;
    std::copy_if(patch.facets.begin(), patch.facets.end(), std::back_inserter(result),
                 [this](std::uint32_t t) { return !is_kept_[t]; });
    if (result.empty()) refuse_off(patch, scene_.place(patch.outer.front()));
    return result;
  }

  void check_flat(const Patch& patch) {
    double& covered = covered_[pieces_.find(patch.facets.front())];
    for (const Triple& p : patch.outer) {
      for (std::uint32_t v : p)
        if (!is_in_plane(patch, v)) refuse_off(patch, scene_.place(v));
      check_side(patch, p, patch.normal);
      covered += length(vector_area(scene_, p));
    }
    std::vector<Triple> facets;
    for (std::uint32_t t : replaced_facets(patch)) facets.push_back(scene_.input.points[t]);
    const std::vector<Edge> before = boundary_of(facets), after = boundary_of(patch.outer);
    Segments segments;
    for (const Edge& e : before) segments.emplace_back(at(e.low), at(e.high));
    const Segment_tree tree(segments.cbegin(), segments.cend());
    for (const Edge& e : after) {
      if (std::binary_search(before.begin(), before.end(), e)) continue;
      for (const Double::Point_3& p : {at(e.low), at(e.high), CGAL::midpoint(at(e.low), at(e.high))})
        if (tree.squared_distance(p) > tolerance_ * tolerance_) refuse_off(patch, scene_.place(e.low));
    }
  }

  void check_curved(const Patch& patch) {
    const std::vector<std::uint32_t> facets = replaced_facets(patch);
    Triangles triangles;
    std::vector<std::uint32_t> known, used;
    for (std::uint32_t t : facets) {
      const Triple& p = scene_.input.points[t];
      triangles.emplace_back(at(p[0]), at(p[1]), at(p[2]));
      known.insert(known.end(), p.begin(), p.end());
    }
    const Triangle_tree tree(triangles.cbegin(), triangles.cend());
    for (const Triple& p : patch.outer) {
      const std::uint32_t facet = facets[facet_under(patch, p, tree) - triangles.cbegin()];
      used.insert(used.end(), p.begin(), p.end());
      check_side(patch, p, vector_area(scene_, scene_.input.points[facet]));
      covered_[pieces_.find(facet)] += length(vector_area(scene_, p));
    }
    tidy(known);
    tidy(used);
    for (std::uint32_t v : used)  // vertices of the patch itself need no search
      if (!std::binary_search(known.begin(), known.end(), v) && tree.squared_distance(at(v)) > tolerance_ * tolerance_)
        refuse_off(patch, scene_.place(v));
  }

  /// The facet of the input under the centroid of a triangle.
  auto facet_under(const Patch& patch, const Triple& p, const Triangle_tree& tree) const {
    const Double::Point_3 centroid = CGAL::centroid(at(p[0]), at(p[1]), at(p[2]));
    const auto [closest, facet] = tree.closest_point_and_primitive(centroid);
    if (CGAL::squared_distance(closest, centroid) > tolerance_ * tolerance_) refuse_off(patch, scene_.place(p));
    return facet;
  }

  [[noreturn]] static void refuse_off(const Patch& patch, const Place& place) {
    reject("a triangle named after patch " + std::to_string(patch.id) + " does not lie on it", {patch.id}, place);
  }

  void check_side(const Patch& patch, const Triple& p, const Place& normal) const {
    const Place n = vector_area(scene_, p);
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, length(minus(scene_.near[p[k]], scene_.near[p[(k + 1) % 3]])));
    if (2 * length(n) <= tolerance_ * longest) return;  // a needle: where it looks is a matter of rounding
    if (!(dot(n, normal) > 0))
      reject("a triangle on patch " + std::to_string(patch.id) + " is turned over", {patch.id}, scene_.place(p));
  }

  void check_areas() {
    const Surface& input = scene_.input;
    std::vector<double> expected(input.points.size()), rim(input.points.size());
    for (std::uint32_t t = 0; t < input.points.size(); ++t) {
      const Triple& p = input.points[t];
      const std::uint32_t piece = pieces_.find(t);
      expected[piece] += length(vector_area(scene_, p));
      for (int k = 0; k < 3; ++k) rim[piece] += length(minus(scene_.near[p[k]], scene_.near[p[(k + 1) % 3]]));
    }
    for (std::uint32_t t = 0; t < input.points.size(); ++t) {
      const double error = covered_[t] - expected[t];
      if (std::abs(error) <= 1e-9 * expected[t] + 1e-14 * scene_.extent * rim[t]) continue;
      reject("patch " + std::to_string(input.patch[t]) +
                 (error < 0 ? " is not covered: a part of it is lost" : " is covered more than once"),
             {input.patch[t]}, scene_.place(input.points[t]));
    }
  }

  Double::Point_3 at(std::uint32_t v) const {
    const Place p = frame_(scene_.near[v]);
    return {p[0], p[1], p[2]};
  }

  static void tidy(std::vector<std::uint32_t>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  const Scene<Kernel>& scene_;
  Sweep_frame frame_;
  double tolerance_;
  Groups pieces_;
  std::vector<char> is_kept_;    ///< of the input's facets
  std::vector<double> covered_;  ///< area by the leading facet of a piece
};

}  // namespace CCSweep::internal::verification

#endif
