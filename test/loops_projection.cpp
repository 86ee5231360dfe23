// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CCSweep/loops/projection.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace {

using namespace CCSweep;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Projection = Layer_projection<Kernel>;
using Point = std::array<double, 3>;
using Map = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

// A ring with a hole: the outer loop counterclockwise, the inner one clockwise.
struct Control {
  std::vector<Point> nodes;
  std::vector<std::vector<std::size_t>> loops{{}, {}};
};

Control ring(double waviness) {
  Control result;
  for (int i = 0; i < 24; ++i) {
    const double t = 2 * M_PI * i / 24;
    result.loops[0].push_back(result.nodes.size());
    result.nodes.push_back({2 * std::cos(t), 1.5 * std::sin(t), waviness * std::sin(3 * t)});
  }
  for (int i = 0; i < 12; ++i) {
    const double t = -2 * M_PI * i / 12;
    result.loops[1].push_back(result.nodes.size());
    result.nodes.push_back({0.5 * std::cos(t) + 0.3, 0.5 * std::sin(t), waviness * std::cos(2 * t)});
  }
  return result;
}

std::vector<Point> mapped(const std::vector<Point>& points, const Map& map) {
  std::vector<Point> result;
  for (const Point& p : points) result.push_back(internal::array(map(internal::vector(p))));
  return result;
}

void check_reproduces(const Control& control, const Map& map, double across) {
  const Result<Projection> projection = Projection::make(control.nodes, mapped(control.nodes, map), control.loops);
  BOOST_REQUIRE_MESSAGE(projection.ok(), projection.status().reason);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int i = 0; i < 200; ++i) {
    const Point p{coordinate(random), coordinate(random), across * coordinate(random)};
    const Eigen::Vector3d found = internal::vector(projection.value()(p));
    BOOST_TEST((found - map(internal::vector(p))).norm() < 1e-12);
  }
  for (std::size_t i = 0; i < control.nodes.size(); ++i) {
    BOOST_TEST((projection.value()(control.nodes[i]) == internal::array(map(internal::vector(control.nodes[i])))));
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loops_projection)

BOOST_AUTO_TEST_CASE(translation_is_reproduced) {
  for (double waviness : {0.0, 0.3}) {
    check_reproduces(
        ring(waviness), [](const Eigen::Vector3d& x) { return (x + Eigen::Vector3d(0.5, -0.25, 2)).eval(); }, 1);
  }
}

BOOST_AUTO_TEST_CASE(similarity_is_reproduced) {
  const Eigen::Matrix3d a = 1.25 * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  for (double waviness : {0.0, 0.3}) {
    check_reproduces(
        ring(waviness), [a](const Eigen::Vector3d& x) { return (a * x + Eigen::Vector3d(1, 0, 3)).eval(); }, 1);
  }
}

BOOST_AUTO_TEST_CASE(affine_map_of_a_planar_layer_is_reproduced) {
  Eigen::Matrix3d a;
  a << 1.2, 0.3, 0, -0.1, 0.8, 0, 0.2, 0.1, 1;
  check_reproduces(
      ring(0), [a](const Eigen::Vector3d& x) { return (a * x + Eigen::Vector3d(0, 0, 1)).eval(); }, 0);
}

BOOST_AUTO_TEST_CASE(quarter_turn_has_no_skew) {
  // The offset between the layers lies in the plane of the second one; Knupp's fit is singular or shears here.
  const Eigen::Matrix3d a = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  check_reproduces(
      ring(0), [a](const Eigen::Vector3d& x) { return (a * (x + Eigen::Vector3d(5, 0, 0))).eval(); }, 1);
}

BOOST_AUTO_TEST_CASE(residuals_bring_the_point_along) {
  // A translated ring whose hole is shifted: points near the hole follow it, by eqs. (2)-(5).
  const Control control = ring(0);
  std::vector<Point> to = control.nodes;
  for (std::size_t i : control.loops[1]) to[i][0] += 0.2;
  const Projection projection = Projection::make(control.nodes, to, control.loops).value();
  const Point at_hole = projection({0.3, 0.505, 0});
  BOOST_TEST(at_hole[0] > 0.3 + 0.19);
  const Point at_rim = projection({-1.99, 0, 0});
  BOOST_TEST(std::fabs(at_rim[0] + 1.99) < 0.01);

  // The same by hand, over all nodes.
  const Projection all = Projection::make(control.nodes, to, control.loops, control.nodes.size()).value();
  const Point p{0.9, 0.7, 0};
  const Eigen::Vector3d origin =
      internal::vector(to[0]) - internal::vector(all.residual(0)) - all.matrix() * internal::vector(control.nodes[0]);
  const auto affine = [&](const Point& q) { return (origin + all.matrix() * internal::vector(q)).eval(); };
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const double weight = 1 / (affine(p) - affine(control.nodes[i])).squaredNorm();
    sum += weight * (internal::vector(to[i]) - affine(control.nodes[i]));
    total += weight;
  }
  BOOST_TEST((internal::vector(all(p)) - affine(p) - sum / total).norm() < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_walk_leads_to_the_same_places) {
  const Control control = ring(0.2);
  std::vector<Point> to = control.nodes;
  for (std::size_t i = 0; i < to.size(); ++i) to[i][0] += 0.1 * std::sin(double(i));
  const Projection projection = Projection::make(control.nodes, to, control.loops).value();
  Projection::Walk walk = projection.walk();
  for (int i = 0; i < 500; ++i) {
    const Point p{1.2 * std::cos(0.02 * i), 1.1 * std::sin(0.02 * i), 0.1};
    BOOST_TEST((walk(p) == projection(p)));
    if (i % 50 == 0) BOOST_TEST((walk(control.nodes[0]) == projection(control.nodes[0])));
  }
}

BOOST_AUTO_TEST_CASE(few_or_degenerate_nodes) {
  const std::vector<Point> one{{1, 2, 3}}, there{{2, 2, 3}};
  BOOST_TEST((Projection::make(one, there).value()({0, 0, 0}) == Point{1, 0, 0}));
  const std::vector<Point> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, lifted{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}};
  const Point p = Projection::make(line, lifted).value()({0.5, 1, 0});
  BOOST_TEST(internal::squared_distance(p, {0.5, 1, 1}) < 1e-24);
}

BOOST_AUTO_TEST_CASE(failures) {
  BOOST_TEST((Projection::make({}, {}).status().code == Status_code::invalid_parameter));
  BOOST_TEST((Projection::make({{0, 0, 0}}, {}).status().code == Status_code::invalid_parameter));
  BOOST_TEST((Projection::make({{0, 0, 0}}, {{0, 0, 1}}, {{0, 1}}).status().code == Status_code::invalid_parameter));
  // A box mirrored in place.
  std::vector<Point> box, mirrored;
  for (int i = 0; i < 8; ++i) {
    box.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
    mirrored.push_back({1 - box.back()[0], box.back()[1], box.back()[2]});
  }
  BOOST_TEST((Projection::make(box, mirrored).status().code == Status_code::projection_folded));
}

BOOST_AUTO_TEST_SUITE_END()
