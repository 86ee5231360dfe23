// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_RANDOM_PARTS_SOLID_H
#define CCSWEEP_TEST_RANDOM_PARTS_SOLID_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

// Straight multi-sweep parts from the column picture. A plan says how high the material begins and ends over each
// point of the plane. All outlines are overlaid in exact arithmetic; over each cell of the overlay stand columns of
// material.
namespace random_parts {

using Outline = std::vector<std::array<double, 2>>;

/// A region painted over what was there before.
struct Paint {
  Outline area;
  double height = 0;
  bool split = false;  ///< a patch of its own even beside another of the same height
};

struct Material {
  Outline area;
  bool solid = true;  ///< false: a through-hole
};

/// Air over a region, strictly inside its columns.
struct Window {
  Outline area;
  double low = 0, high = 0;
};

struct Plan {
  std::vector<Material> material;
  double bottom = 0, top = 1;
  std::vector<Paint> bottoms, tops;
  std::vector<Window> windows;
};

/// Material over a triangle of the plane, of one sub-volume.
struct Prism {
  std::array<std::array<double, 2>, 3> base;
  double low = 0, high = 0;
  int target = -1;
};

/// A part as a triangle mesh, with its known answer for a sweep along +z.
struct Part {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<int> patch;  ///< of each triangle

  double volume = 0;
  std::map<int, double> sub_volumes;  ///< by target patch
  std::vector<Prism> prisms;          ///< of which the sub-volumes are made
  std::set<int> sources;
  std::set<int> curved;  ///< the patches that are not flat
  std::size_t sets = 0;
  bool touches_itself = false;  ///< along an edge or in a vertex
};

namespace solid {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face_base =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Overlay = CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>, CGAL::Exact_intersections_tag>>;

inline constexpr double smooth_turn = 30;  ///< degrees; outlines that turn less at a node are arcs there

inline std::vector<Point> exact(const Outline& outline) {
  std::vector<Point> result;
  for (const auto& p : outline) result.emplace_back(p[0], p[1]);
  return result;
}

inline double turn(const Vector& a, const Vector& b) {
  const double ax = CGAL::to_double(a.x()), ay = CGAL::to_double(a.y()), bx = CGAL::to_double(b.x()),
               by = CGAL::to_double(b.y());
  return std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by)) * 180 / std::acos(-1.0);
}

class Groups {
 public:
  explicit Groups(std::size_t n = 0) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(int i, int j) {
    i = find(i), j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<int> parent_;
};

/// A stretch of material over a cell, between two heights, with the labels of its two caps.
struct Column {
  int low, high;  ///< indices of heights
  int low_label, high_label;
  int low_patch = -1, high_patch = -1;
};

/// The overlay of all outlines of a plan, with the columns over each cell. Cell 0 is everything outside.
class Columns {
 public:
  explicit Columns(const Plan& plan) {
    valid_ = find_heights(plan) && insert_outlines(plan) && fill(plan) && is_clear();
  }

  bool is_valid() const { return valid_; }
  const Overlay& overlay() const { return overlay_; }
  const std::vector<double>& heights() const { return heights_; }
  std::size_t number_of_cells() const { return columns_.size(); }
  const std::vector<Column>& of(int cell) const { return columns_[cell]; }
  std::vector<Column>& of(int cell) { return columns_[cell]; }
  const Point& point(int vertex) const { return points_[vertex]; }
  const Kernel::FT& area(int cell) const { return areas_[cell]; }

  /// The column of a cell in the slab above height `k`, if there is material.
  const Column* at(int cell, int k) const {
    for (const Column& c : columns_[cell])
      if (c.low <= k && k < c.high) return &c;
    return nullptr;
  }

 private:
  bool find_heights(const Plan& plan) {
    heights_ = {plan.bottom, plan.top};
    for (const auto* paints : {&plan.bottoms, &plan.tops})
      for (const Paint& p : *paints) heights_.push_back(p.height);
    for (const Window& w : plan.windows) heights_.push_back(w.low), heights_.push_back(w.high);
    std::sort(heights_.begin(), heights_.end());
    heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
    return true;
  }

  bool insert_outlines(const Plan& plan) {
    std::vector<const Outline*> outlines;
    for (const Material& m : plan.material) outlines.push_back(&m.area);
    for (const auto* paints : {&plan.bottoms, &plan.tops})
      for (const Paint& p : *paints) outlines.push_back(&p.area);
    for (const Window& w : plan.windows) outlines.push_back(&w.area);
    for (const Outline* outline : outlines) {
      const std::vector<Point> points = exact(*outline);
      for (std::size_t i = 0; i < points.size(); ++i)
        overlay_.insert_constraint(points[i], points[(i + 1) % points.size()]);
    }
    for (auto v : overlay_.finite_vertex_handles()) {
      v->info() = static_cast<int>(points_.size());
      points_.push_back(v->point());
    }
    for (auto f : overlay_.all_face_handles()) f->info() = 0;
    columns_.resize(1), areas_.resize(1);
    return true;
  }

  int height(double h) const {
    return static_cast<int>(std::lower_bound(heights_.begin(), heights_.end(), h) - heights_.begin());
  }

  static bool covers(const Outline& outline, const Point& p) {
    const std::vector<Point> points = exact(outline);
    return CGAL::bounded_side_2(points.begin(), points.end(), p, Kernel()) == CGAL::ON_BOUNDED_SIDE;
  }

  static std::pair<double, int> painted(const std::vector<Paint>& paints, double ground, const Point& p) {
    for (std::size_t i = paints.size(); i-- > 0;)
      if (covers(paints[i].area, p)) return {paints[i].height, paints[i].split ? static_cast<int>(i) : -1};
    return {ground, -1};
  }

  bool fill(const Plan& plan) {
    for (auto f : overlay_.finite_face_handles()) {
      const auto t = overlay_.triangle(f);
      const Point p = CGAL::centroid(t);
      bool solid = false;
      for (const Material& m : plan.material)
        if (covers(m.area, p)) solid = m.solid;
      if (!solid) continue;
      const auto [low, low_label] = painted(plan.bottoms, plan.bottom, p);
      const auto [high, high_label] = painted(plan.tops, plan.top, p);
      if (low >= high) return false;
      std::vector<Column> columns{{height(low), height(high), low_label, high_label}};
      for (const Window& w : plan.windows) {
        if (!covers(w.area, p)) continue;
        if (columns.size() != 1 || w.low <= low || w.high >= high) return false;
        const Column whole = columns[0];
        columns = {{whole.low, height(w.low), whole.low_label, -1}, {height(w.high), whole.high, -1, whole.high_label}};
      }
      f->info() = static_cast<int>(columns_.size());
      columns_.push_back(std::move(columns));
      areas_.push_back(CGAL::abs(t.area()));
    }
    return columns_.size() > 1;
  }

  /// A node of an arc and of nothing else.
  bool is_smooth(Overlay::Vertex_handle v) const {
    std::vector<Vector> directions;
    auto e = overlay_.incident_edges(v), end = e;
    do {
      if (overlay_.is_infinite(*e) || !overlay_.is_constrained(*e)) continue;
      auto other = e->first->vertex(Overlay::cw(e->second));
      if (other == v) other = e->first->vertex(Overlay::ccw(e->second));
      directions.push_back(other->point() - v->point());
    } while (++e != end);
    return directions.size() == 2 && turn(directions[0], -directions[1]) < smooth_turn;
  }

  /// No two features are so close that an imprint with a tolerance might take them for one.
  bool is_clear() const {
    double size = 0;
    for (const Point& p : points_)
      size = std::max({size, std::abs(CGAL::to_double(p.x())), std::abs(CGAL::to_double(p.y()))});
    const double gap = 0.01 * size;
    for (auto e : overlay_.finite_edges()) {
      auto u = e.first->vertex(Overlay::cw(e.second)), v = e.first->vertex(Overlay::ccw(e.second));
      if (CGAL::to_double(CGAL::squared_distance(u->point(), v->point())) > gap * gap) continue;
      if (!overlay_.is_constrained(e) || (!is_smooth(u) && !is_smooth(v))) return false;
    }
    for (auto f : overlay_.finite_face_handles())
      for (int i = 0; i < 3; ++i) {
        if (!f->is_constrained(i)) continue;
        const Point &p = f->vertex(i)->point(), &a = f->vertex(Overlay::ccw(i))->point(),
                    &b = f->vertex(Overlay::cw(i))->point();
        if (CGAL::angle(p, a, b) != CGAL::ACUTE || CGAL::angle(p, b, a) != CGAL::ACUTE) continue;
        if (CGAL::to_double(CGAL::squared_distance(p, Kernel::Line_2(a, b))) < gap * gap) return false;
      }
    return true;
  }

  bool valid_ = false;
  Overlay overlay_;
  std::vector<double> heights_;
  std::vector<Point> points_;
  std::vector<Kernel::FT> areas_;
  std::vector<std::vector<Column>> columns_;
};

}  // namespace solid
}  // namespace random_parts

#endif
