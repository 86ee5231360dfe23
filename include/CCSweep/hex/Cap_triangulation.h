// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CAP_TRIANGULATION_H
#define CCSWEEP_HEX_CAP_TRIANGULATION_H

#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/quad_quality.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Triangles over the nodes of a region's loops and points inside, to be paired to quads; or of twice the size, over
/// every second node of the loops, to be paired and subdivided.
class Cap_triangulation {
 public:
  using Triangle = std::array<std::uint32_t, 3>;
  struct Edge {
    std::uint32_t a, b;  // nodes of the region, neighbours or two apart
  };

  /// \param stride 1 for all nodes of the loops, 2 for every second one
  Cap_triangulation(const Quad_region& region, double size, std::uint32_t stride) : size_(stride * size) {
    std::uint32_t first = 0;
    std::map<Point2, std::uint32_t> node_at;  // an outline may touch itself in a node, which then is one
    for (const auto& loop : region.loops) {
      const auto n = static_cast<std::uint32_t>(loop.nodes.size());
      for (std::uint32_t i = 0; i < n; i += stride) {
        const std::uint32_t j = (i + stride) % n;
        const std::uint32_t a = node_at.try_emplace(loop.nodes[i], first + i).first->second;
        const std::uint32_t b = node_at.try_emplace(loop.nodes[j], first + j).first->second;
        edges_.push_back({a, b});
        ends_.push_back({loop.nodes[i], loop.nodes[j]});
        // A short edge between long ones asks for no small quads around it.
        const Point2 &before = loop.nodes[(i + n - stride) % n], &after = loop.nodes[(j + stride) % n];
        length_.push_back(std::max({length_between(loop.nodes[i], loop.nodes[j]), length_between(before, loop.nodes[i]),
                                    length_between(loop.nodes[j], after)}));
        if (stride == 2) middle_[{a, b}] = first + i + 1;
      }
      points.insert(points.end(), loop.nodes.begin(), loop.nodes.end());
      first += n;
    }
    number_on_loops = points.size();
    std::vector<std::pair<Segment, std::size_t>> boxes;
    for (std::size_t e = 0; e < ends_.size(); ++e)
      boxes.push_back({{{ends_[e].first[0], ends_[e].first[1]}, {ends_[e].second[0], ends_[e].second[1]}}, e});
    near_ = decltype(near_)(boxes);
  }

  /// False where the loops cross themselves or each other, be it in a node: the boundary needs more nodes.
  bool run() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      try {  // a node may be in the way of an edge as well
        const auto a = vertex(edges_[e].a), b = vertex(edges_[e].b);
        if (a == b || a == nullptr || b == nullptr) return false;
        mesh_.insert_constraint(a, b);
      } catch (const Cdt::Intersection_of_constraints_exception&) {
        return false;
      }
    }
    mark_inside();
    for (const Edge& e : edges_)
      if (!is_inside_on_left(handles_.at(e.a), handles_.at(e.b))) return false;
    insert_lattice();
    refine();
    open_flat_corners();
    collect();
    return !triangles.empty();
  }

  /// Puts a point inside each of some triangles, and triangulates anew.
  void split(const std::vector<std::size_t>& which) {
    for (std::size_t t : which) {
      const auto& [a, b, c] = triangles[t];
      insert({(points[a][0] + points[b][0] + points[c][0]) / 3, (points[a][1] + points[b][1] + points[c][1]) / 3});
    }
    mark_inside();
    collect();
  }

  /// In which direction the side from a to b sets out: on the boundary to the node between.
  const Point2& towards(std::uint32_t a, std::uint32_t b) const {
    for (const auto& edge : {std::pair(a, b), std::pair(b, a)})
      if (const auto found = middle_.find(edge); found != middle_.end()) return points[found->second];
    return points[b];
  }

  /// The nodes that were left out, between the ends of the edges on the loops, which have the region on their left.
  const std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& middles() const { return middle_; }

  std::vector<Point2> points;        ///< the region's nodes, then the points inside
  std::size_t number_on_loops;       ///< how many of them are the region's nodes
  std::vector<Triangle> triangles;   ///< counter-clockwise

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  enum class Side : unsigned char { unknown, inside, outside };
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel,
      CGAL::Triangulation_data_structure_2<
          CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>,
          CGAL::Triangulation_face_base_with_info_2<Side, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>>,
      CGAL::No_constraint_intersection_tag>;
  using Handle = Cdt::Vertex_handle;
  using Plane_point = boost::geometry::model::d2::point_xy<double>;
  using Segment = boost::geometry::model::segment<Plane_point>;

  static Kernel::Point_2 point(const Point2& p) { return {p[0], p[1]}; }

  Handle vertex(std::uint32_t n) {
    if (handles_.size() < points.size()) handles_.resize(points.size());
    if (handles_[n] == nullptr) {
      const std::size_t before = mesh_.number_of_vertices();
      const Handle v = mesh_.insert(point(points[n]));
      if (mesh_.number_of_vertices() == before) return nullptr;
      v->info() = n;
      handles_[n] = v;
    }
    return handles_[n];
  }

  // Whether two vertices are joined by an edge with the region on its left.
  bool is_inside_on_left(Handle a, Handle b) const {
    Cdt::Face_handle f;
    int i = 0;
    if (!mesh_.is_edge(a, b, f, i)) return false;
    const auto left = f->vertex(Cdt::ccw(i)) == a ? f : f->neighbor(i);
    return left->info() == Side::inside;
  }

  // Faces to which an odd number of constraints leads from outside.
  void mark_inside() {
    for (auto f : mesh_.all_face_handles()) f->info() = Side::unknown;
    std::vector<Cdt::Face_handle> found{mesh_.infinite_face()};
    found.back()->info() = Side::outside;
    while (!found.empty()) {
      const auto f = found.back();
      found.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto g = f->neighbor(i);
        if (g->info() != Side::unknown) continue;
        const bool is_inside = (f->info() == Side::inside) != mesh_.is_constrained({f, i});
        g->info() = is_inside ? Side::inside : Side::outside;
        found.push_back(g);
      }
    }
  }

  // The distance from the loops, and the size wanted there: it grows from the boundary's inwards. A few of the nearest
  // edges tell it.
  std::pair<double, double> distance_and_size(const Point2& p) const {
    constexpr unsigned few = 12;
    constexpr double growth = 0.4;
    double nearest = 1e300, wanted = size_;
    for (auto at = near_.qbegin(boost::geometry::index::nearest(Plane_point(p[0], p[1]), few)); at != near_.qend();
         ++at) {
      const auto& [a, b] = ends_[at->second];
      const double wx = b[0] - a[0], wy = b[1] - a[1], l2 = wx * wx + wy * wy;
      const double t = std::clamp(((p[0] - a[0]) * wx + (p[1] - a[1]) * wy) / l2, 0.0, 1.0);
      const double d = length_between(p, {a[0] + t * wx, a[1] + t * wy});
      nearest = std::min(nearest, d);
      if (growth * d >= wanted) break;  // those that follow are no nearer
      wanted = std::min(wanted, length_[at->second] + growth * d);
    }
    return {nearest, wanted};
  }

  bool is_inside(const Point2& p) const {
    Cdt::Locate_type type;
    int i;
    hint_ = mesh_.locate(point(p), type, i, hint_);
    return type == Cdt::FACE && hint_->info() == Side::inside;
  }

  // A square lattice in the direction of most of the boundary: triangles on it pair to squares.
  void insert_lattice() {
    double cosine = 0, sine = 0;
    Point2 low = points[0], high = points[0];
    for (const auto& [a, b] : ends_) {
      const double angle = 4 * std::atan2(b[1] - a[1], b[0] - a[0]), length = length_between(a, b);
      cosine += length * std::cos(angle);
      sine += length * std::sin(angle);
      for (int x : {0, 1}) {
        low[x] = std::min(low[x], a[x]);
        high[x] = std::max(high[x], a[x]);
      }
    }
    const double angle = std::atan2(sine, cosine) / 4, c = std::cos(angle), s = std::sin(angle);
    const Point2 middle{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
    const int reach = static_cast<int>(std::ceil(length_between(low, high) / size_ / 2)) + 1;
    std::vector<Point2> found;
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const double u = i * size_, v = j * size_;
        const Point2 p{middle[0] + c * u - s * v, middle[1] + s * u + c * v};
        if (!is_inside(p)) continue;
        const auto [d, wanted] = distance_and_size(p);
        if (d > 0.7 * size_ && wanted > 0.8 * size_) found.push_back(p);
      }
    for (const Point2& p : found) insert(p);
  }

  // Leaves out what falls on the outline, which keeps its nodes.
  void insert(const Point2& p) {
    const std::size_t before = mesh_.number_of_vertices();
    Cdt::Locate_type type;
    int i;
    const auto f = mesh_.locate(point(p), type, i, hint_);
    if (type == Cdt::EDGE && mesh_.is_constrained({f, i})) return;
    const Handle v = mesh_.insert(point(p), type, f, i);
    if (mesh_.number_of_vertices() == before) return;
    hint_ = v->face();
    v->info() = static_cast<std::uint32_t>(points.size());
    points.push_back(p);
  }

  // A place for a further point, the size wanted there, and by how much the circle around it is larger.
  struct Centre {
    double excess, wanted;
    Point2 place;
  };

  // Puts points in the centres of circles that are too large, not near the boundary.
  void refine() {
    const std::size_t most = 20 * (points.size() + 100);
    for (bool changed = true; changed && points.size() < most;) {
      mark_inside();
      std::vector<Centre> centres = centres_of_large_circles();
      std::stable_sort(centres.begin(), centres.end(),
                       [](const Centre& a, const Centre& b) { return a.excess > b.excess; });
      changed = insert_apart(centres);
    }
    mark_inside();
  }

  std::vector<Centre> centres_of_large_circles() {
    constexpr double large = 0.85;
    const double least_wanted = std::min(size_, *std::min_element(length_.begin(), length_.end()));
    std::vector<Centre> centres;
    for (auto f : mesh_.finite_face_handles()) {
      if (f->info() != Side::inside) continue;
      const auto c = mesh_.circumcenter(f);
      const Point2 p{c.x(), c.y()};
      const double radius = std::sqrt(CGAL::squared_distance(c, f->vertex(0)->point()));
      if (radius <= large * least_wanted) continue;
      hint_ = f;
      if (!is_inside(p)) continue;
      const auto [d, wanted] = distance_and_size(p);
      if (d > 0.6 * wanted && radius > large * wanted) centres.push_back({radius / wanted, wanted, p});
    }
    return centres;
  }

  bool insert_apart(const std::vector<Centre>& centres) {
    bool changed = false;
    for (const auto& [excess, wanted, p] : centres) {
      if (squared_distance_to_vertices(p) < 0.5 * wanted * wanted) continue;
      insert(p);
      changed = true;
    }
    return changed;
  }

  // To those of the triangle around p and of its neighbours.
  double squared_distance_to_vertices(const Point2& p) const {
    const auto f = hint_ = mesh_.locate(point(p), hint_);
    double least = 1e300;
    for (int i = 0; i < 3; ++i)
      for (const auto& v : {f->vertex(i), f->neighbor(i)->vertex(f->neighbor(i)->index(f))})
        if (!mesh_.is_infinite(v)) least = std::min(least, CGAL::squared_distance(v->point(), point(p)));
    return least;
  }

  // A triangle with two sides on the boundary, where this hardly turns, would get a flat corner.
  void open_flat_corners() {
    constexpr double flat = 0.35;
    std::vector<Point2> centres;
    for (auto f : mesh_.finite_face_handles()) {
      if (f->info() != Side::inside) continue;
      for (int i = 0; i < 3; ++i) {
        if (!mesh_.is_constrained({f, mesh_.cw(i)}) || !mesh_.is_constrained({f, mesh_.ccw(i)})) continue;
        const std::uint32_t n = f->vertex(i)->info();
        const Point2 &here = points[n], &a = towards(n, f->vertex(mesh_.ccw(i))->info()),
                     &b = towards(n, f->vertex(mesh_.cw(i))->info());
        const double along = (a[0] - here[0]) * (b[0] - here[0]) + (a[1] - here[1]) * (b[1] - here[1]);
        if (along > 0 || turn(here, a, b) > flat * length_between(here, a) * length_between(here, b)) continue;
        const auto c = CGAL::centroid(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
        centres.push_back({c.x(), c.y()});
      }
    }
    for (const Point2& p : centres) insert(p);
    mark_inside();
  }

  void collect() {
    triangles.clear();
    for (auto f : mesh_.finite_face_handles()) {
      if (f->info() != Side::inside) continue;
      triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    }
  }

  double size_;
  std::vector<Edge> edges_;
  std::vector<std::pair<Point2, Point2>> ends_;
  std::vector<double> length_;  // by edge: of it and its neighbours the greatest
  boost::geometry::index::rtree<std::pair<Segment, std::size_t>, boost::geometry::index::quadratic<8>> near_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle_;  // node between the ends of an edge
  std::vector<Handle> handles_;
  Cdt mesh_;
  mutable Cdt::Face_handle hint_;  // where the last point was found; the next one is near
};

}  // namespace CCSweep::internal

#endif
