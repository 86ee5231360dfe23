// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CCSweep/loops/imprint.h>
#include <CCSweep/loops/point_index.h>
#include <CCSweep/loops/projection.h>
#include <CCSweep/loops/segment_index.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cstdint>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include "loops_drawings.h"

namespace {

using namespace CCSweep;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = std::array<double, 3>;

// The least that models the concepts, with nothing extra: no copies, no default.
class Segment_index_archetype {
 public:
  explicit Segment_index_archetype(const std::vector<CGAL::Bbox_2>& boxes) : size_(boxes.size()) {}
  Segment_index_archetype(const Segment_index_archetype&) = delete;
  template <class OutputIterator>
  OutputIterator candidates(const CGAL::Bbox_2&, OutputIterator out) const {
    for (std::size_t i = size_; i-- > 0;) *out++ = i;  // all of them, and from behind
    return out;
  }

 private:
  std::size_t size_;
};

class Point_index_archetype {
 public:
  explicit Point_index_archetype(const std::vector<Point>& points) : oracle_(points) {}
  Point_index_archetype(const Point_index_archetype&) = delete;
  Point_index_archetype(Point_index_archetype&&) = default;
  std::vector<std::size_t> nearest(const Point& place, std::size_t k) const { return oracle_.nearest(place, k); }

 private:
  Brute_force_point_index_3 oracle_;
};

static_assert(SegmentIndex_2<Rtree_segment_index_2<Kernel>>);
static_assert(SegmentIndex_2<Run_segment_index_2<Kernel>>);
static_assert(SegmentIndex_2<Brute_force_segment_index_2<Kernel>>);
static_assert(SegmentIndex_2<Segment_index_archetype>);
static_assert(SelfJoiningSegmentIndex_2<Run_segment_index_2<Kernel>>);
static_assert(!SelfJoiningSegmentIndex_2<Segment_index_archetype>);
static_assert(PointIndex_3<Rtree_point_index_3>);
static_assert(PointIndex_3<Brute_force_point_index_3>);
static_assert(PointIndex_3<Kd_tree_point_index_3>);
static_assert(PointIndex_3<Point_index_archetype>);

std::vector<Point> random_points(std::mt19937& random, std::size_t n, bool on_a_grid) {
  std::uniform_real_distribution<double> coordinate(0, 4);
  std::vector<Point> result(n);
  for (Point& p : result) {
    for (double& x : p) x = on_a_grid ? std::floor(coordinate(random)) : coordinate(random);
  }
  return result;
}

template <class Index>
void check_segments(const std::vector<CGAL::Bbox_2>& boxes) {
  const Index index(boxes);
  const Brute_force_segment_index_2<Kernel> oracle(boxes);
  for (const CGAL::Bbox_2& box : boxes) {
    std::vector<std::size_t> found, expected;
    index.candidates(box, std::back_inserter(found));
    oracle.candidates(box, std::back_inserter(expected));
    std::sort(found.begin(), found.end());
    BOOST_TEST((found == expected));
  }
  std::vector<std::size_t> none;
  index.candidates({100, 100, 101, 101}, std::back_inserter(none));
  BOOST_TEST(none.empty());
}

void check_pairs(const std::vector<CGAL::Bbox_2>& boxes) {
  using Pair = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<Pair> found, expected;
  Run_segment_index_2<Kernel>(boxes).pairs(std::back_inserter(found));
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (CGAL::do_overlap(boxes[i], boxes[j])) expected.emplace_back(i, j);
    }
  }
  std::sort(found.begin(), found.end());
  BOOST_TEST((found == expected));
}

template <class Index>
void check_points(const std::vector<Point>& points, const std::vector<Point>& places) {
  const Index index(points);
  const Brute_force_point_index_3 oracle(points);
  for (const Point& place : places) {
    for (std::size_t k : {1, 2, 10, 1000}) BOOST_TEST((index.nearest(place, k) == oracle.nearest(place, k)));
  }
}

Layer_drawing<Kernel> two_stars() {
  std::mt19937 random(11);
  Layer_drawing<Kernel> drawing;
  loops_test::draw(drawing, loops_test::star(random, 30, 0, 0), Loop_label{1, -1});
  loops_test::draw(drawing, loops_test::star(random, 30, 0.1, 0.2), Loop_label{-1, 2});
  return drawing;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loops_indices)

BOOST_AUTO_TEST_CASE(segments_against_brute_force) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1), size(0, 0.2);
  std::vector<CGAL::Bbox_2> boxes;
  for (int i = 0; i < 500; ++i) {
    const double x = coordinate(random), y = coordinate(random);
    boxes.emplace_back(x, y, x + size(random), y + (i % 3 == 0 ? 0 : size(random)));
  }
  check_segments<Rtree_segment_index_2<Kernel>>(boxes);
  check_segments<Run_segment_index_2<Kernel>>(boxes);
  check_pairs(boxes);
  for (std::size_t size : {0, 1, 4, 5, 17}) {
    const std::vector<CGAL::Bbox_2> some(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(size));
    check_segments<Run_segment_index_2<Kernel>>(some);
    check_pairs(some);
  }
}

BOOST_AUTO_TEST_CASE(points_against_brute_force) {
  std::mt19937 random(2);
  for (bool on_a_grid : {false, true}) {
    const std::vector<Point> points = random_points(random, 300, on_a_grid),
                             places = random_points(random, 40, on_a_grid);
    check_points<Rtree_point_index_3>(points, places);
    check_points<Kd_tree_point_index_3>(points, places);
    check_points<Rtree_point_index_3>({}, places);
    check_points<Kd_tree_point_index_3>({}, places);
  }
}

template <class Index>
void check_walk(const std::vector<Point>& points, std::size_t k, double step) {
  const Index index(points);
  const Brute_force_point_index_3 oracle(points);
  Neighbour_walk<Index> walk(index, points, k);
  for (int i = 0; i < 300; ++i) {
    const Point place{2 + 2 * std::cos(step * i), 2 + 2 * std::sin(step * i), std::floor(0.01 * i)};
    std::vector<std::size_t> found;
    for (const Neighbour& n : walk(place)) found.push_back(n.number);
    BOOST_TEST((found == oracle.nearest(place, k)));
  }
}

BOOST_AUTO_TEST_CASE(walk_against_brute_force) {
  std::mt19937 random(6);
  for (bool on_a_grid : {false, true}) {
    const std::vector<Point> points = random_points(random, 400, on_a_grid);
    for (double step : {0., 1e-3, 0.05, 1.}) {
      check_walk<Rtree_point_index_3>(points, 10, step);
      check_walk<Kd_tree_point_index_3>(points, 3, step);
    }
    check_walk<Rtree_point_index_3>({points.begin(), points.begin() + 7}, 10, 0.1);
  }
}

BOOST_AUTO_TEST_CASE(imprint_does_not_depend_on_the_index) {
  const Layer_drawing<Kernel> drawing = two_stars();
  const auto expected = imprint_layer(drawing, 1e-6).value();
  const auto same = [&](const auto& other) {
    BOOST_TEST((other.points == expected.points));
    BOOST_TEST((other.chains == expected.chains));
    BOOST_TEST(num_edges(other.graph) == num_edges(expected.graph));
  };
  same((imprint_layer<Kernel, Run_segment_index_2<Kernel>>(drawing, 1e-6).value()));
  same((imprint_layer<Kernel, Brute_force_segment_index_2<Kernel>>(drawing, 1e-6).value()));
  same((imprint_layer<Kernel, Segment_index_archetype>(drawing, 1e-6).value()));
}

template <class PointIndex>
Point projected(const std::vector<Point>& from, const std::vector<Point>& to) {
  return Layer_projection<Kernel, PointIndex>::make(from, to).value()({1.1, 1.2, 1.3});
}

BOOST_AUTO_TEST_CASE(projection_does_not_depend_on_the_index) {
  std::mt19937 random(4);
  const std::vector<Point> from = random_points(random, 50, true);
  std::vector<Point> to = from;
  for (Point& p : to) p = {p[0] + 0.1 * std::sin(p[1]), p[1], p[2] + 1};
  const Point expected = projected<Brute_force_point_index_3>(from, to);
  BOOST_TEST((projected<Rtree_point_index_3>(from, to) == expected));
  BOOST_TEST((projected<Kd_tree_point_index_3>(from, to) == expected));
  BOOST_TEST((projected<Point_index_archetype>(from, to) == expected));
}

BOOST_AUTO_TEST_SUITE_END()
