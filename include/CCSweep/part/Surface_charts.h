// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_SURFACE_CHARTS_H
#define CCSWEEP_PART_SURFACE_CHARTS_H

#include <CCSweep/internal/Union_find.h>
#include <CGAL/Segment_2.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/enum.h>
#include <CGAL/intersections.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// A closed surface of triangles. Edge 3 t + i runs from corner i of triangle t to the next one.
template <class Kernel>
struct Triangle_surface {
  std::vector<std::array<typename Kernel::Point_3, 3>> triangles;
  std::vector<std::array<std::uint32_t, 3>> corners;  // the vertex at each corner
  std::vector<std::uint32_t> opposite;                // per edge
  std::vector<int> patch;

  static std::uint32_t next(std::uint32_t edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }
  static std::uint32_t previous(std::uint32_t edge) { return edge % 3 == 0 ? edge + 2 : edge - 1; }
  std::uint32_t source(std::uint32_t edge) const { return corners[edge / 3][edge % 3]; }
  const typename Kernel::Point_3& point(std::uint32_t edge) const { return triangles[edge / 3][edge % 3]; }
};

// Finds the parts of a surface that are plainly free of self-contact: charts, each the graph of a function over a
// coordinate plane. A chart is connected by edges, its triangles turn the same way in the plane, those around a vertex
// go around it once at most, and its boundary meets itself nowhere in the plane. So the boundary has one outer curve
// and the map to the plane is one to one: by the sum of its turns (the boundary of a surface of Euler characteristic X
// turns X times). All decisions are exact. Linear, where boundaries are short.
template <class Kernel>
class Surface_charts {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  // The chart of each triangle, or `none`.
  static std::vector<std::uint32_t> of(const Triangle_surface<Kernel>& surface) {
    Surface_charts charts(surface);
    charts.group();
    charts.drop_small_groups();
    charts.check_inner_vertices();
    charts.check_boundaries();
    std::vector<std::uint32_t> result;
    for (const std::uint32_t chart : charts.chart_) result.push_back(charts.is_bad_[chart] ? none : chart);
    return result;
  }

 private:
  using Point_2 = typename Kernel::Point_2;
  using Segment_2 = typename Kernel::Segment_2;
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::uint32_t,
                                                        CGAL::Box_intersection_d::ID_EXPLICIT>;

  explicit Surface_charts(const Triangle_surface<Kernel>& surface)
      : surface_(surface), is_bad_(surface.triangles.size(), false) {}

  // Where a triangle is seen from: the end of the coordinate axis that it is turned to most.
  static std::int8_t view(const std::array<typename Kernel::Point_3, 3>& triangle) {
    std::array<double, 3> u, v;
    for (int k = 0; k < 3; ++k) {
      const double origin = CGAL::to_double(triangle[0][k]);
      u[k] = CGAL::to_double(triangle[1][k]) - origin;
      v[k] = CGAL::to_double(triangle[2][k]) - origin;
    }
    const std::array<double, 3> normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    int axis = 2;
    for (int k = 0; k < 2; ++k)
      if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
    return static_cast<std::int8_t>(normal[axis] > 0 ? axis : axis + 3);
  }

  // Seen from the positive end of an axis the next two axes turn left; from the negative end they change places.
  Point_2 seen(std::uint32_t edge, std::int8_t view) const {
    const auto& p = surface_.point(edge);
    const int axis = view % 3, first = (axis + 1) % 3, second = (axis + 2) % 3;
    return view < 3 ? Point_2(p[first], p[second]) : Point_2(p[second], p[first]);
  }

  void group() {
    const std::size_t size = surface_.triangles.size();
    Union_find groups(size);
    for (std::uint32_t t = 0; t < size; ++t) {
      view_.push_back(view(surface_.triangles[t]));
      const bool turns_left =
          turn(seen(3 * t, view_[t]), seen(3 * t + 1, view_[t]), seen(3 * t + 2, view_[t])) == CGAL::LEFT_TURN;
      is_bad_[t] = !turns_left;
    }
    for (std::uint32_t edge = 0; edge < surface_.opposite.size(); ++edge) {
      const std::uint32_t t = edge / 3, s = surface_.opposite[edge] / 3;
      if (view_[t] == view_[s] && surface_.patch[t] == surface_.patch[s] && !is_bad_[t] && !is_bad_[s])
        groups.join(t, s);
    }
    for (std::size_t t = 0; t < size; ++t) chart_.push_back(static_cast<std::uint32_t>(groups.root(t)));
  }

  // Those that save no work.
  void drop_small_groups() {
    std::vector<std::uint32_t> size(chart_.size(), 0);
    for (const std::uint32_t chart : chart_) ++size[chart];
    for (std::size_t chart = 0; chart < size.size(); ++chart)
      if (size[chart] < 8) is_bad_[chart] = true;
  }

  bool is_boundary(std::uint32_t edge) const { return chart_[edge / 3] != chart_[surface_.opposite[edge] / 3]; }

  // A chart that goes around a vertex more than once has several triangles in the direction of the first axis.
  void check_inner_vertices() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> east;  // vertex and chart
    for (std::uint32_t edge = 0; edge < surface_.opposite.size(); ++edge)
      if (!is_bad_[chart_[edge / 3]] && is_east(edge)) east.emplace_back(surface_.source(edge), chart_[edge / 3]);
    std::sort(east.begin(), east.end());
    for (std::size_t i = 1; i < east.size(); ++i)
      if (east[i] == east[i - 1]) is_bad_[east[i].second] = true;
  }

  // Whether a triangle is met when going along the first axis from the source of an edge, or just below it.
  bool is_east(std::uint32_t edge) const {
    const std::int8_t view = view_[edge / 3];
    const Point_2 p = seen(edge, view), q = seen(surface_.next(edge), view), r = seen(surface_.previous(edge), view);
    const auto is_upper = [&p](const Point_2& d) { return d.y() > p.y() || (d.y() == p.y() && d.x() > p.x()); };
    return !is_upper(q) && is_upper(r);
  }

  void check_boundaries() {
    std::map<std::uint32_t, std::vector<std::uint32_t>> boundaries;
    for (std::uint32_t edge = 0; edge < surface_.opposite.size(); ++edge)
      if (!is_bad_[chart_[edge / 3]] && is_boundary(edge)) boundaries[chart_[edge / 3]].push_back(edge);
    for (const auto& [chart, edges] : boundaries)
      if (!is_simple(edges)) is_bad_[chart] = true;
  }

  bool is_simple(const std::vector<std::uint32_t>& boundary) const {
    std::vector<std::uint32_t> sources;
    for (const std::uint32_t edge : boundary) {
      if (goes_round(edge)) return false;
      sources.push_back(surface_.source(edge));
    }
    std::sort(sources.begin(), sources.end());
    if (std::adjacent_find(sources.begin(), sources.end()) != sources.end()) return false;
    std::vector<Box> boxes;
    for (const std::uint32_t edge : boundary) boxes.emplace_back(start(edge).bbox() + end(edge).bbox(), edge);
    bool result = true;
    const auto look_at = [&](const Box& a, const Box& b) { result = result && !meet(a.info(), b.info()); };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), look_at);
    return result;
  }

  // Whether the triangles of a chart at the source of a boundary edge go all the way around it.
  bool goes_round(std::uint32_t boundary) const {
    const Point_2 center = start(boundary), first = end(boundary);
    for (std::uint32_t edge = boundary; !is_boundary(surface_.previous(edge));) {
      edge = surface_.opposite[surface_.previous(edge)];
      const Point_2 last = start(surface_.previous(edge));
      if (turn(center, end(edge), first) == CGAL::LEFT_TURN && turn(center, first, last) != CGAL::RIGHT_TURN)
        return true;
    }
    return false;
  }

  // Whether two boundary edges meet elsewhere than where one follows the other.
  bool meet(std::uint32_t edge, std::uint32_t other) const {
    const bool is_followed = target(edge) == surface_.source(other);
    if (is_followed || target(other) == surface_.source(edge)) {
      if (is_followed && target(other) == surface_.source(edge)) return true;
      if (!is_followed) std::swap(edge, other);
      const Point_2 a = start(edge), b = start(other), c = end(other);
      return turn(a, b, c) == CGAL::COLLINEAR && !CGAL::collinear_are_strictly_ordered_along_line(a, b, c);
    }
    return CGAL::do_intersect(Segment_2(start(edge), end(edge)), Segment_2(start(other), end(other)));
  }

  std::uint32_t target(std::uint32_t edge) const { return surface_.source(surface_.next(edge)); }
  Point_2 start(std::uint32_t edge) const { return seen(edge, view_[edge / 3]); }
  Point_2 end(std::uint32_t edge) const { return seen(surface_.next(edge), view_[edge / 3]); }
  static CGAL::Orientation turn(const Point_2& p, const Point_2& q, const Point_2& r) {
    return Kernel().orientation_2_object()(p, q, r);
  }

  const Triangle_surface<Kernel>& surface_;
  std::vector<std::int8_t> view_;     // per triangle
  std::vector<std::uint32_t> chart_;  // per triangle, the first one of its chart
  std::vector<char> is_bad_;          // per chart
};

}  // namespace CCSweep::internal

#endif
