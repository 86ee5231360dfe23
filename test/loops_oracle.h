// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_LOOPS_ORACLE_H
#define CCSWEEP_TEST_LOOPS_ORACLE_H

#include <CGAL/Arr_default_overlay_traits.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "loops_scene.h"

namespace loops_test {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
template <class FT>
using Tallies = std::map<Loop_label, Tally<FT>>;

// The oracle: two arrangements whose faces carry labels, overlaid by CGAL. All of it is exact.
class Oracle {
 public:
  // Faces that differ only by an edge between equal labels do not occur: every edge of a scene has different labels on
  // its sides.
  static Tallies<Exact::FT> of(const Scene& scene) {
    const Arrangement sources = arrangement(scene.sources, true), targets = arrangement(scene.targets, false);
    Arrangement both;
    CGAL::Arr_face_overlay_traits<Arrangement, Arrangement, Arrangement, Merge> traits;
    CGAL::overlay(sources, targets, both, traits);
    Tallies<Exact::FT> result;
    for (auto f = both.faces_begin(); f != both.faces_end(); ++f) {
      if (f->is_unbounded() || f->data().empty()) continue;
      auto& entry = result[f->data()];
      ++entry.faces;
      entry.area += signed_area(f->outer_ccb());
      for (auto hole = f->inner_ccbs_begin(); hole != f->inner_ccbs_end(); ++hole) entry.area += signed_area(*hole);
    }
    return result;
  }

 private:
  using Traits = CGAL::Arr_segment_traits_2<Exact>;
  using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, Loop_label>>;
  using Point = Exact::Point_2;
  struct Merge {
    Loop_label operator()(const Loop_label& a, const Loop_label& b) const { return {a.source, b.target}; }
  };

  static Arrangement arrangement(const std::vector<Piece>& pieces, bool is_source) {
    Arrangement result;
    std::vector<Traits::Curve_2> curves;
    const auto add = [&](const Loop& loop) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto &p = loop[i], &q = loop[(i + 1) % loop.size()];
        if (p != q) curves.emplace_back(Point(p[0], p[1]), Point(q[0], q[1]));
      }
    };
    for (const Piece& piece : pieces) {
      add(piece.outer);
      for (const Loop& hole : piece.holes) add(hole);
    }
    CGAL::insert(result, curves.begin(), curves.end());
    for (auto f = result.faces_begin(); f != result.faces_end(); ++f) {
      f->set_data({});
      if (f->is_unbounded()) continue;
      const Point place = point_inside(result, f->outer_ccb());
      for (const Piece& piece : pieces) {
        bool in = encloses(piece.outer, place);
        for (const Loop& hole : piece.holes) in = in && !encloses(hole, place);
        if (in) f->set_data(is_source ? Loop_label{piece.label, -1} : Loop_label{-1, piece.label});
      }
    }
    return result;
  }

  // From the middle of an edge half the way to the next edge on its left.
  template <class Halfedge>
  static Point point_inside(const Arrangement& arrangement, Halfedge h) {
    const Point a = h->source()->point(), b = h->target()->point(), m = CGAL::midpoint(a, b);
    const Exact::Vector_2 n = (b - a).perpendicular(CGAL::LEFT_TURN);
    bool is_first = true;
    Exact::FT nearest = 0;
    for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e) {
      const Exact::Vector_2 p = e->source()->point() - m, q = e->target()->point() - m;
      const Exact::FT of_p = CGAL::determinant(n, p), of_q = CGAL::determinant(n, q);
      if (of_p == of_q || CGAL::sign(of_p) * CGAL::sign(of_q) > 0) continue;
      const Exact::Vector_2 hit = p + (q - p) * (of_p / (of_p - of_q));
      const Exact::FT t = (hit * n) / (n * n);
      if (t > 0 && (is_first || t < nearest)) nearest = t;
      is_first = is_first && !(t > 0);
    }
    return m + n * (nearest / 2);
  }

  static bool encloses(const Loop& loop, const Point& p) {
    bool in = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &a = loop[i], &b = loop[(i + 1) % loop.size()];
      if ((p.y() < a[1]) == (p.y() < b[1])) continue;
      const Point lower(a[0], a[1]), upper(b[0], b[1]);
      if ((CGAL::orientation(lower, upper, p) == CGAL::LEFT_TURN) == (a[1] < b[1])) in = !in;
    }
    return in;
  }

  template <class Circulator>
  static Exact::FT signed_area(Circulator first) {
    Exact::FT twice(0);
    Circulator h = first;
    do {
      const auto &p = h->source()->point(), &q = h->target()->point();
      twice += p.x() * q.y() - q.x() * p.y();
    } while (++h != first);
    return twice / 2;
  }
};

template <class FT>
std::string told(const Tallies<FT>& tallies) {
  std::ostringstream out;
  for (const auto& [label, entry] : tallies) {
    out << " (" << label.source << ", " << label.target << "): " << entry.faces << " of "
        << CGAL::to_double(entry.area);
  }
  return out.str();
}

template <class FT>
bool are_equal(const Tallies<FT>& a, const Tallies<FT>& b, const FT& scale = FT(1)) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [&](const auto& s, const auto& t) {
    return s.first == t.first && s.second.faces == t.second.faces && s.second.area * scale == t.second.area;
  });
}

// Whether no two segments of an imprint meet anywhere but in a common node. By brute force.
template <class K>
bool meet_in_nodes_only(const CCSweep::Imprint<K>& imprint) {
  const auto point = [&](CCSweep::Node_index n) -> const auto& { return imprint.points[n.value()]; };
  const auto meet = [&](const auto& s, const auto& t) {
    for (const auto& [common, u] : {std::pair(s.source, s.target), std::pair(s.target, s.source)}) {
      if (common != t.source && common != t.target) continue;
      const auto &c = point(common), &p = point(u), &q = point(common == t.source ? t.target : t.source);
      return CGAL::collinear(c, p, q) && !CGAL::collinear_are_strictly_ordered_along_line(p, c, q);
    }
    using Segment = typename K::Segment_2;
    return CGAL::do_intersect(Segment(point(s.source), point(s.target)), Segment(point(t.source), point(t.target)));
  };
  const auto segments = imprint.segments();
  std::vector<CGAL::Bbox_2> boxes;
  for (const auto& s : segments) boxes.push_back(point(s.source).bbox() + point(s.target).bbox());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (CGAL::do_overlap(boxes[i], boxes[j]) && meet(segments[i], segments[j])) return false;
    }
  }
  return true;
}

// What is wrong with the imprint of a scene; nothing if it is right. With exact constructions it is that of the oracle;
// else a valid graph whose edges meet in nodes only, with the same areas up to rounding.
inline std::string difference(const Scene& scene) {
  const Tallies<Exact::FT> expected = Oracle::of(scene);
  const auto exact = CCSweep::imprint_layer(drawn<Exact>(scene), 0);
  if (!exact.ok()) return exact.status().reason;
  if (!is_valid(exact.value().graph, exact.value().points)) return "the graph is not valid";
  const auto found = tally(exact.value());
  if (!are_equal(found, expected)) return "found" + told(found) + ", not" + told(expected);
  for (const double tolerance : {0., 1e-9}) {
    const auto inexact = CCSweep::imprint_layer(drawn<Inexact>(scene), tolerance);
    if (!inexact.ok()) return "rounded: " + inexact.status().reason;
    if (!is_valid(inexact.value().graph, inexact.value().points)) return "the rounded graph is not valid";
    if (!meet_in_nodes_only(inexact.value())) return "rounded edges meet";
    const auto rounded = tally(inexact.value());
    Tallies<double> all = rounded;
    for (const auto& [label, entry] : expected) all[label].area -= CGAL::to_double(entry.area);
    for (const auto& [label, entry] : all) {
      if (std::fabs(entry.area) > 1e-6) return "rounded: found" + told(rounded) + ", not" + told(expected);
    }
  }
  return {};
}

}  // namespace loops_test

#endif
