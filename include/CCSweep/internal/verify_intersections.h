// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_VERIFY_INTERSECTIONS_H
#define CCSWEEP_INTERNAL_VERIFY_INTERSECTIONS_H

#include <CCSweep/internal/verify_manifold.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <unordered_map>
#include <vector>

namespace CCSweep::internal::verification {

/// The parts of a surface that are plainly free of overlap: an edge-connected group of triangles of one patch that
/// are all turned the same way when one coordinate is dropped, and whose boundary does not cross itself there and has
/// one outer curve only, is the graph of a function: how often the group covers a point there is how often its boundary
/// winds around that. Pairs inside it need no test, which matters for planar caps with many nodes, where nearly every
/// pair of long thin triangles has overlapping boxes.
template <class Kernel>
class Graph_regions {
  using Point_2 = typename Kernel::Point_2;
  using Segment_2 = typename Kernel::Segment_2;
  using Box =
      CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::uint32_t, CGAL::Box_intersection_d::ID_EXPLICIT>;

 public:
  Graph_regions(const Scene<Kernel>& scene, const Surface& surface)
      : scene_(scene), surface_(surface), groups_(surface.points.size()), is_graph_(surface.points.size(), true) {
    find_axes();
    std::vector<char> turned_well(surface.points.size());
    for (std::uint32_t t = 0; t < turned_well.size(); ++t) turned_well[t] = is_turned_well(t);
    for (std::uint32_t h = 0; h < surface.opposite.size(); ++h) {
      const std::uint32_t t = h / 3, s = surface.opposite[h] / 3;
      if (surface.patch[t] == surface.patch[s] && axes_[t] == axes_[s] && turned_well[t] && turned_well[s])
        groups_.unite(t, s);
    }
    check_boundaries();
  }

  /// The triangles of each region; all that belong to none come last.
  std::vector<std::vector<std::uint32_t>> regions() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> found;
    std::vector<std::uint32_t> others;
    for (std::uint32_t t = 0; t < surface_.points.size(); ++t) {
      const std::uint32_t leader = groups_.find(t);
      if (is_graph_[leader])
        found[leader].push_back(t);
      else
        others.push_back(t);
    }
    std::vector<std::vector<std::uint32_t>> result;
    for (auto& [leader, triangles] : found) result.push_back(std::move(triangles));
    result.push_back(std::move(others));
    return result;
  }

 private:
  struct Axis {
    int dropped = 2;
    bool positive = true;
    bool operator==(const Axis&) const = default;
  };

  static Axis dominant(const Place& n) {
    int axis = 2;
    for (int k = 0; k < 2; ++k)
      if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
    return {axis, n[axis] > 0};
  }

  /// A patch that is about flat is seen along one axis, any other along several.
  void find_axes() {
    std::unordered_map<int, std::pair<Place, double>> sums;
    for (std::size_t t = 0; t < surface_.points.size(); ++t) {
      const Place n = vector_area(scene_, surface_.points[t]);
      auto& [sum, total] = sums[surface_.patch[t]];
      for (int k = 0; k < 3; ++k) sum[k] += n[k];
      total += length(n);
    }
    for (std::size_t t = 0; t < surface_.points.size(); ++t) {
      const auto& [sum, total] = sums[surface_.patch[t]];
      axes_.push_back(dominant(length(sum) > 0.9 * total ? sum : vector_area(scene_, surface_.points[t])));
    }
  }

  Point_2 projected(std::uint32_t p, const Axis& axis) const {
    return {scene_.points[p][(axis.dropped + 1) % 3], scene_.points[p][(axis.dropped + 2) % 3]};
  }

  bool is_turned_well(std::uint32_t t) const {
    const Triple& p = surface_.points[t];
    return is_turned(p[0], p[1], p[2], axes_[t]);
  }

  bool is_turned(std::uint32_t p, std::uint32_t q, std::uint32_t r, const Axis& axis) const {
    const CGAL::Orientation o = CGAL::orientation(projected(p, axis), projected(q, axis), projected(r, axis));
    return o == (axis.positive ? CGAL::POSITIVE : CGAL::NEGATIVE);
  }

  /// Projected boundaries of a region may meet in common vertices only.
  void check_boundaries() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> boundary;
    for (std::uint32_t h = 0; h < surface_.opposite.size(); ++h) {
      const std::uint32_t leader = groups_.find(h / 3);
      if (leader != groups_.find(surface_.opposite[h] / 3)) boundary[leader].push_back(h);
    }
    for (const auto& [leader, halfedges] : boundary)
      if (halfedges.size() > 3)
        is_graph_[leader] = is_simple(halfedges, axes_[leader]) && has_one_outer_curve(halfedges, axes_[leader]);
  }

  /// For a simple boundary, which is taken apart into closed curves that visit each of their points once.
  bool has_one_outer_curve(const std::vector<std::uint32_t>& halfedges, const Axis& axis) const {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> onward;
    for (std::uint32_t h : halfedges) onward[ends(h).first].push_back(ends(h).second);
    std::size_t outer = 0;
    for (std::uint32_t h : halfedges) {
      std::vector<std::uint32_t> path{ends(h).first};
      std::unordered_map<std::uint32_t, std::size_t> place{{path.front(), 0}};
      while (!onward[path.back()].empty()) {
        std::vector<std::uint32_t>& next = onward[path.back()];
        path.push_back(next.back());
        next.pop_back();
        const auto [at, is_new] = place.try_emplace(path.back(), path.size() - 1);
        if (is_new) continue;
        outer += is_outer({path.begin() + static_cast<std::ptrdiff_t>(at->second), path.end() - 1}, axis);
        for (; path.size() > at->second + 1; path.pop_back())
          if (path.back() != at->first) place.erase(path.back());
      }
    }
    return outer == 1;
  }

  /// Whether a simple closed curve has the region on its inner side: by its turn at an extreme point.
  bool is_outer(const std::vector<std::uint32_t>& curve, const Axis& axis) const {
    const auto extreme = std::min_element(curve.begin(), curve.end(), [&](std::uint32_t p, std::uint32_t q) {
      return CGAL::compare_xy(projected(p, axis), projected(q, axis)) == CGAL::SMALLER;
    });
    const std::uint32_t before = extreme == curve.begin() ? curve.back() : *std::prev(extreme);
    const std::uint32_t after = std::next(extreme) == curve.end() ? curve.front() : *std::next(extreme);
    return is_turned(before, *extreme, after, axis);
  }

  bool is_simple(const std::vector<std::uint32_t>& halfedges, const Axis& axis) const {
    std::vector<Box> boxes;
    for (std::uint32_t h : halfedges) {
      const auto [p, q] = ends(h);
      boxes.emplace_back(projected(p, axis).bbox() + projected(q, axis).bbox(), h);
    }
    bool simple = true;
    auto test = [&](const Box& a, const Box& b) { simple = simple && !meet(ends(a.info()), ends(b.info()), axis); };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), test);
    return simple;
  }

  std::pair<std::uint32_t, std::uint32_t> ends(std::uint32_t h) const {
    return {surface_.points[h / 3][h % 3], surface_.points[h / 3][next_halfedge(h) % 3]};
  }

  bool meet(std::pair<std::uint32_t, std::uint32_t> s, std::pair<std::uint32_t, std::uint32_t> t,
            const Axis& axis) const {
    if (s.first == t.first || s.second == t.second) std::swap(t.first, t.second);
    if (s.first == t.second && s.second == t.first) return true;
    if (s.second == t.first) std::swap(s, t);
    if (s.first == t.second) {  // consecutive, t before s: they overlap when the path turns right back
      const Point_2 a = projected(t.first, axis), b = projected(s.first, axis), c = projected(s.second, axis);
      return CGAL::collinear(a, b, c) && !CGAL::collinear_are_strictly_ordered_along_line(a, b, c);
    }
    return CGAL::do_intersect(Segment_2(projected(s.first, axis), projected(s.second, axis)),
                              Segment_2(projected(t.first, axis), projected(t.second, axis)));
  }

  const Scene<Kernel>& scene_;
  const Surface& surface_;
  Groups groups_;
  std::vector<char> is_graph_;  ///< by the leader of a group
  std::vector<Axis> axes_;      ///< of each triangle
};

/// Whether two triangles meet elsewhere than in common vertices and edges. Vertices are compared by their
/// coordinates, so that contact in separate vertices at the same place is no intersection. Exact.
template <class Kernel>
class Triangles_meet {
  using Point_3 = typename Kernel::Point_3;
  using Segment_3 = typename Kernel::Segment_3;
  using Triangle_3 = typename Kernel::Triangle_3;

 public:
  explicit Triangles_meet(const Scene<Kernel>& scene) : scene_(scene) {}

  bool operator()(Triple s, Triple t) const {
    int common = 0;  // common vertices are moved to the front of both
    for (int i = 0; i < 3; ++i) {
      auto found = std::find(t.begin() + common, t.end(), s[i]);
      if (found == t.end()) continue;
      std::swap(s[i], s[common]);
      std::iter_swap(found, t.begin() + common);
      ++common;
    }
    if (common == 3) return true;
    if (common == 2) return overlap_at_edge(s, t);
    if (is_beside(s, t, common) || is_beside(t, s, common)) return false;
    const Triangle_3 a(at(s[0]), at(s[1]), at(s[2])), b(at(t[0]), at(t[1]), at(t[2]));
    if (common == 0) return CGAL::do_intersect(a, b);
    return CGAL::do_intersect(a, Segment_3(at(t[1]), at(t[2]))) || CGAL::do_intersect(b, Segment_3(at(s[1]), at(s[2])));
  }

 private:
  const Point_3& at(std::uint32_t p) const { return scene_.points[p]; }

  bool overlap_at_edge(const Triple& s, const Triple& t) const {
    return CGAL::coplanar(at(s[0]), at(s[1]), at(s[2]), at(t[2])) &&
           CGAL::coplanar_orientation(at(s[0]), at(s[1]), at(s[2]), at(t[2])) == CGAL::POSITIVE;
  }

  /// Whether all vertices of `t` but the common ones lie strictly on one side of the plane of `s`.
  bool is_beside(const Triple& s, const Triple& t, int common) const {
    CGAL::Orientation side = CGAL::COPLANAR;
    for (int k = common; k < 3; ++k) {
      const CGAL::Orientation o = CGAL::orientation(at(s[0]), at(s[1]), at(s[2]), at(t[k]));
      if (o == CGAL::COPLANAR || (k > common && o != side)) return false;
      side = o;
    }
    return true;
  }

  const Scene<Kernel>& scene_;
};

/// Tests pairs of triangles of different regions. The largest region goes first, against all that are smaller, so
/// that its triangles are not sorted again for each of them.
template <class Kernel>
class Pair_search {
  using Box =
      CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t, CGAL::Box_intersection_d::ID_EXPLICIT>;
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  struct Batch {
    std::vector<Box> boxes;
    CGAL::Bbox_3 hull;
    bool is_graph = true;
  };

 public:
  Pair_search(const Scene<Kernel>& scene, const Surface& surface, const Place& direction)
      : surface_(surface), meet_(scene) {
    const Sweep_frame frame(direction);
    for (const std::vector<std::uint32_t>& region : Graph_regions<Kernel>(scene, surface).regions()) {
      Batch& batch = batches_.emplace_back();
      for (std::uint32_t t : region) add_boxes(scene, frame, surface.points[t], t, batch.boxes);
      for (const Box& box : batch.boxes) batch.hull += box.bbox();
    }
    batches_.back().is_graph = false;
    std::stable_sort(batches_.begin(), batches_.end(),
                     [](const Batch& a, const Batch& b) { return a.boxes.size() > b.boxes.size(); });
  }

  /// The first pair of triangles that meet, whatever the order in which boxes are compared.
  std::optional<Pair> first_pair() {
    auto test = [this](const Box& a, const Box& b) {
      const Pair pair = std::minmax({a.info(), b.info()});
      if (pair.first == pair.second || (first_ && *first_ <= pair)) return;
      if (meet_(surface_.points[pair.first], surface_.points[pair.second])) first_ = pair;
    };
    for (std::size_t i = 0; i < batches_.size(); ++i) {
      Batch& batch = batches_[i];
      if (!batch.is_graph) CGAL::box_self_intersection_d(batch.boxes.begin(), batch.boxes.end(), test);
      std::vector<Box> others;
      for (std::size_t j = i + 1; j < batches_.size(); ++j)
        if (CGAL::do_overlap(batch.hull, batches_[j].hull))
          std::copy_if(batches_[j].boxes.begin(), batches_[j].boxes.end(), std::back_inserter(others),
                       [&](const Box& box) { return CGAL::do_overlap(batch.hull, box.bbox()); });
      CGAL::box_intersection_d(batch.boxes.begin(), batch.boxes.end(), others.begin(), others.end(), test);
    }
    return first_;
  }

 private:
  /// The boxes of a triangle in the frame, widened by the rounding of the turn. A long thin triangle athwart the
  /// axes is sliced, as its box would overlap those of very many triangles far off.
  static void add_boxes(const Scene<Kernel>& scene, const Sweep_frame& frame, const Triple& t, std::uint32_t info,
                        std::vector<Box>& boxes) {
    std::array<Place, 3> p{frame(scene.near[t[0]]), frame(scene.near[t[1]]), frame(scene.near[t[2]])};
    auto shortest_first = [&](const Place& a, const Place& b, const Place& c) {
      return length(minus(a, b)) <= std::min(length(minus(b, c)), length(minus(c, a)));
    };
    while (!shortest_first(p[0], p[1], p[2])) std::rotate(p.begin(), p.begin() + 1, p.end());
    const double slack = 1e-14 * (scene.diagonal + scene.extent);
    auto hull = [&](double from, double to) {  // of the slice between two fractions of the way to the far corner
      CGAL::Bbox_3 box;
      for (int side = 0; side < 2; ++side)
        for (double f : {from, to}) {
          Place q;
          for (int k = 0; k < 3; ++k) q[k] = (1 - f) * p[side][k] + f * p[2][k];
          box += CGAL::Bbox_3(q[0] - slack, q[1] - slack, q[2] - slack, q[0] + slack, q[1] + slack, q[2] + slack);
        }
      return box;
    };
    const int slices = number_of_slices(hull(0, 1), length(vector_area(scene, t)));
    for (int i = 0; i < slices; ++i) boxes.emplace_back(hull(i / double(slices), (i + 1) / double(slices)), info);
  }

  /// By how much the largest face of the box exceeds that of a triangle along the axes.
  static int number_of_slices(const CGAL::Bbox_3& box, double area) {
    std::array<double, 3> size{box.x_span(), box.y_span(), box.z_span()};
    std::sort(size.begin(), size.end());
    const double ratio = size[1] * size[2] / (8 * area);
    return ratio < 16 ? std::max(1, static_cast<int>(ratio)) : 16;  // no less than 16 if the area underflows
  }

  const Surface& surface_;
  Triangles_meet<Kernel> meet_;
  std::vector<Batch> batches_;
  std::optional<Pair> first_;
};

/// No two triangles of the surface meet elsewhere than in common vertices and edges.
template <class Kernel>
void check_intersections(const Scene<Kernel>& scene, const Surface& surface, const Place& direction) {
  if (const auto pair = Pair_search<Kernel>(scene, surface, direction).first_pair())
    reject(surface.title + " intersects itself", {surface.patch[pair->first], surface.patch[pair->second]},
           scene.place(surface.points[pair->first]));
}

}  // namespace CCSweep::internal::verification

#endif
