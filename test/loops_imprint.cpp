// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>
#include <random>
#include <set>
#include <vector>

#include "loops_drawings.h"

namespace {

using namespace CCSweep;
using namespace loops_test;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;

const Loop_label source_1{1, -1}, target_2{-1, 2}, target_3{-1, 3};

template <class K>
Imprint<K> done(const Layer_drawing<K>& drawing, double tolerance) {
  auto result = imprint_layer(drawing, tolerance);
  BOOST_REQUIRE_MESSAGE(result.ok(), result.status().reason);
  Imprint<K> imprint = std::move(result).value();
  BOOST_TEST(is_valid(imprint.graph, imprint.points));
  BOOST_TEST(imprint.representative.size() == drawing.nodes.size());
  BOOST_REQUIRE(imprint.chains.size() == drawing.segments.size());
  for (std::size_t s = 0; s < imprint.chains.size(); ++s) {
    const auto& chain = imprint.chains[s];
    BOOST_TEST((chain.front() == imprint.representative[drawing.segments[s].source.value()]));
    BOOST_TEST((chain.back() == imprint.representative[drawing.segments[s].target.value()]));
    for (Node_index n : chain) {
      BOOST_TEST((n.value() >= imprint.representative.size() || imprint.representative[n.value()] == n));
    }
  }
  for (std::size_t n = 0; n < drawing.nodes.size(); ++n) {
    if (drawing.nodes[n].fixed) BOOST_TEST((imprint.points[n] == drawing.nodes[n].point));
  }
  for (const auto& segment : imprint.segments()) {
    BOOST_TEST((imprint.graph.loop_face(segment.coedge) == segment.left_face));
    BOOST_TEST((segment.left != segment.right));
  }
  return imprint;
}

std::size_t nodes_in_use(const Imprint<Kernel>& imprint) {
  std::set<Node_index> used;
  for (const auto& segment : imprint.segments()) used.insert({segment.source, segment.target});
  return used.size();
}

std::vector<Node_index> first_nodes(std::size_t n) {
  std::vector<Node_index> result;
  for (std::size_t i = 0; i < n; ++i) result.emplace_back(i);
  return result;
}

template <class K>
std::vector<std::vector<typename K::Point_2>> loops(const std::vector<Loop>& input) {
  std::vector<std::vector<typename K::Point_2>> result;
  for (const Loop& loop : input) {
    result.emplace_back();
    for (const auto& p : loop) result.back().emplace_back(p[0], p[1]);
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loops_imprint)

BOOST_AUTO_TEST_CASE(two_squares_overlap) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 2, 2), source_1, {.corners = true});
  draw(drawing, rectangle(1, 1, 2, 2), target_2, {.corners = true});
  const auto imprint = done(drawing, 1e-6);
  BOOST_TEST(imprint.overlaps().size() == 1u);
  BOOST_TEST(imprint.source_only().size() == 1u);
  BOOST_TEST(imprint.target_only().size() == 1u);
  BOOST_TEST(num_vertices(imprint.graph) == 10u);
  BOOST_TEST(num_edges(imprint.graph) == 12u);
  BOOST_TEST(tally(imprint).at({1, 2}).area == 1);
}

BOOST_AUTO_TEST_CASE(edges_end_at_corners_and_junctions_only) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 2, 2), source_1);
  draw(drawing, rectangle(1, 1, 2, 2), target_2);
  const auto imprint = done(drawing, 0);
  BOOST_TEST(num_vertices(imprint.graph) == 2u);
  BOOST_TEST(num_edges(imprint.graph) == 4u);
  BOOST_TEST(imprint.segments().size() == 12u);

  Layer_drawing<Kernel> alone;
  draw(alone, regular(7, 1), target_2);
  BOOST_TEST(num_vertices(done(alone, 0).graph) == 2u);
  alone.nodes[3].corner = true;
  BOOST_TEST(num_vertices(done(alone, 0).graph) == 2u);
  alone.nodes[4].corner = alone.nodes[5].corner = true;
  BOOST_TEST(num_vertices(done(alone, 0).graph) == 3u);
}

BOOST_AUTO_TEST_CASE(identical_faces_become_one) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, regular(9, 1), source_1, {.fixed = true});
  draw(drawing, regular(9, 1), target_2);
  const auto imprint = done(drawing, 0);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 1u);
  BOOST_TEST(imprint.overlaps().size() == 1u);
  BOOST_TEST(imprint.segments().size() == 9u);
  for (std::size_t i = 9; i < 18; ++i) BOOST_TEST((imprint.representative[i] == Node_index(i - 9)));
}

BOOST_AUTO_TEST_CASE(neighbours_share_an_edge_and_siblings_cancel) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 1, 1), target_2);
  draw(drawing, rectangle(1, 0, 1, 1), target_3);
  draw(drawing, rectangle(2, 0, 1, 1), target_3);
  const auto imprint = done(drawing, 0);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 2u);
  BOOST_TEST(tally(imprint).at(target_3).area == 2);
}

BOOST_AUTO_TEST_CASE(node_on_an_edge) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 2, 1), target_2, {.fixed = true});
  draw(drawing, {{1, 1}, {2, 2}, {0, 2}}, target_3);
  const auto imprint = done(drawing, 0);
  BOOST_TEST(imprint.chains[2].size() == 3u);
  BOOST_TEST(imprint.fixed[4]);  // it lies on a fixed segment now
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 2u);
}

BOOST_AUTO_TEST_CASE(matching_squares_with_different_nodes) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, source_1, {.fixed = true});
  Loop projected{{0, 0}, {.5, 0}, {1, 0}, {1, .5}, {1, 1}, {.5, 1}, {0, 1}, {0, .5}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-1e-7, 1e-7);
  for (auto& p : projected) p = {p[0] + noise(random), p[1] + noise(random)};
  draw(drawing, projected, target_2);
  const auto imprint = done(drawing, 1e-6);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 1u);
  BOOST_TEST(imprint.segments().size() == 8u);
  for (std::size_t s = 0; s < 4; ++s) BOOST_TEST(imprint.chains[s].size() == 3u);
}

BOOST_AUTO_TEST_CASE(two_facetings_of_one_circle_become_one) {
  for (const auto& [n, m, phase] :
       {std::tuple{24, 24, 0.1}, {24, 31, 0.0}, {40, 13, 0.05}, {13, 40, 0.3}, {60, 17, 1.0}}) {
    for (double noise : {0.0, 1e-6}) {
      BOOST_TEST_CONTEXT(n << " " << m << " " << noise) {
        std::mt19937 random(9);
        std::uniform_real_distribution<double> off(-noise, noise);
        Layer_drawing<Kernel> drawing;
        draw(drawing, regular(n, 1), source_1, {.fixed = true, .chord_error = 1 - std::cos(M_PI / n)});
        Loop other = regular(m, 1, phase);
        for (auto& p : other) p = {p[0] + off(random), p[1] + off(random)};
        draw(drawing, other, target_2, {.chord_error = 1 - std::cos(M_PI / m)});
        const auto imprint = done(drawing, 1e-5);
        BOOST_TEST(imprint.graph.number_of_loop_faces() == 1u);
        BOOST_TEST(imprint.overlaps().size() == 1u);
        BOOST_TEST(nodes_in_use(imprint) <= std::size_t(n + m));
        BOOST_TEST(nodes_in_use(imprint) >= std::size_t(std::max(n, m)));
        // Free facetings find each other as well.
        for (auto& node : drawing.nodes) node.fixed = false;
        for (auto& segment : drawing.segments) segment.fixed = false;
        BOOST_TEST(done(drawing, 1e-5).graph.number_of_loop_faces() == 1u);
      }
    }
  }
}

template <class K>
void check_facetings() {
  const auto chord = [](int n) { return 1 - std::cos(M_PI / n); };
  Layer_drawing<K> drawing;
  draw(drawing, regular(24, 1), source_1, {.fixed = true, .chord_error = chord(24)});
  draw(drawing, regular(17, 1, 0.1), target_2, {.chord_error = chord(17)});
  const auto imprint = done(drawing, 1e-5);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 1u);
  // With exact constructions the feet lie on the fixed outline, which keeps its area to the last bit.
  BOOST_TEST((tally(imprint).at({1, 2}).area == area<K>(first_nodes(24), imprint.points)));
}

BOOST_AUTO_TEST_CASE(exact_constructions_keep_fixed_outlines) {
  check_facetings<Exact>();
  check_facetings<Rational>();
}

BOOST_AUTO_TEST_CASE(many_segments_through_one_point) {
  for (double x : {0.0, 1e6 / 3}) {
    Layer_drawing<Kernel> drawing;
    for (int i = 0; i < 20; ++i) {
      const Loop around = regular(40, 1, 0.1, x, 0);
      draw(drawing, {{x, 0}, around[2 * i], around[2 * i + 1]}, {i, -1});
    }
    draw(drawing, {{x - 2, -2}, {x + 2, -2}, {x + 2, 2}, {x - 2, 2}}, {-1, 50});
    draw(drawing, reversed({{x - 1.5, -1.5}, {x + 1.5, -1.5}, {x + 1.5, 1.5}, {x - 1.5, 1.5}}), {-1, 50});
    draw(drawing, {{x - 1.5, -1.5}, {x + 1.5, -1.5}, {x + 1.5, 1.5}}, {-1, 51});  // its long side passes the centre
    const auto imprint = done(drawing, 1e-9);
    BOOST_TEST(imprint.source_only().size() >= 9u);
    BOOST_TEST(imprint.source_only().size() + imprint.overlaps().size() >= 20u);
  }
}

BOOST_AUTO_TEST_CASE(order_of_the_drawing_does_not_matter) {
  std::mt19937 random(3);
  for (int i = 0; i < 10; ++i) {
    Layer_drawing<Exact> drawing;
    draw(drawing, star(random, 30, 0, 0), source_1);
    draw(drawing, star(random, 30, 0.2, 0), target_2);
    const auto expected = tally(done(drawing, 0));
    std::shuffle(drawing.segments.begin(), drawing.segments.end(), random);
    for (auto& segment : drawing.segments) {
      if (random() % 2 == 0) continue;
      std::swap(segment.source, segment.target);
      std::swap(segment.left, segment.right);
    }
    for (const auto& [label, entry] : tally(done(drawing, 0))) {
      BOOST_TEST(entry.faces == expected.at(label).faces);
      BOOST_TEST((entry.area == expected.at(label).area));
    }
  }
}

BOOST_AUTO_TEST_CASE(two_hexagons_stay_two) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, regular(6, 1), source_1, {.fixed = true});
  draw(drawing, regular(6, 1 - 1e-3), target_2);
  const auto imprint = done(drawing, 2e-5);
  BOOST_TEST(imprint.overlaps().size() == 1u);
  BOOST_TEST(imprint.source_only().size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_ledge_is_not_closed) {
  // A wall on either side of a gap of half the tolerance: a free outline on one of them stays off the other.
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 1, 1), target_2, {.fixed = true});
  draw(drawing, rectangle(1.005, 0, 1, 1), target_3, {.fixed = true});
  draw(drawing, {{0.2, 0.2}, {1.001, 0.2}, {1.001, 0.7}, {0.2, 0.7}}, source_1);
  const auto imprint = done(drawing, 0.01);
  BOOST_TEST(tally(imprint).at(target_3).area > 0.999);
  BOOST_TEST(tally(imprint).at({1, 2}).area > 0.399);
  BOOST_TEST(imprint.source_only().empty());
}

BOOST_AUTO_TEST_CASE(a_thin_tube_is_not_closed) {
  const auto chord = [](int n) { return 1 - std::cos(M_PI / n); };
  for (double gap : {0.5, 1.2, 2.0, 5.0}) {
    const double outer = 1 + gap * chord(24);
    Layer_drawing<Kernel> drawing;
    draw(drawing, regular(24, outer), source_1, {.fixed = true, .chord_error = chord(24)});
    draw(drawing, reversed(regular(24, 1)), source_1, {.fixed = true, .chord_error = chord(24)});
    draw(drawing, regular(17, 1, 0.05), target_2, {.chord_error = chord(17)});
    const auto imprint = done(drawing, 1e-5);
    double area = 0;
    for (const auto& [label, entry] : tally(imprint)) area += label.source == 1 ? entry.area : 0;
    BOOST_TEST(std::fabs(area / (12 * std::sin(M_PI / 12) * (outer * outer - 1)) - 1) < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(what_was_carried_past_fixed_outlines_reaches_for_them) {
  const auto faces = [](bool fixed, double reach) {
    Layer_drawing<Kernel> drawing;
    draw(drawing, rectangle(0, 0, 1, 1), target_2, {.fixed = fixed});
    const std::size_t first = drawing.nodes.size();
    draw(drawing, {{0.003, -0.002}, {0.5, 0.001}, {1.003, 0.002}, {0.998, 1.003}, {0.002, 0.999}}, source_1);
    for (std::size_t n = first; n < drawing.nodes.size(); ++n) drawing.nodes[n].reach = reach;
    return done(drawing, 1e-6).graph.number_of_loop_faces();
  };
  BOOST_TEST(faces(true, 0.01) == 1u);
  BOOST_TEST(faces(true, 0) > 1u);
  BOOST_TEST(faces(false, 0.01) > 1u);  // it reaches for what is fixed only
}

BOOST_AUTO_TEST_CASE(tolerance_zero_merges_equal_points_only) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 1, 1), source_1);
  draw(drawing, rectangle(1e-12, 0, 1, 1), target_2);
  BOOST_TEST(done(drawing, 0).graph.number_of_loop_faces() == 3u);
  BOOST_TEST(done(drawing, 1e-9).graph.number_of_loop_faces() == 1u);
}

BOOST_AUTO_TEST_CASE(fixed_nodes_take_over_from_those_drawn_before_them) {
  // A node that was merged must not be taken for one that stands when nodes are merged again.
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 1, 1), source_1, {.corners = true});
  draw(drawing, rectangle(0, 0, 1, 1), target_2, {.fixed = true});
  const auto imprint = done(drawing, 1e-6);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 1u);
  BOOST_TEST(nodes_in_use(imprint) == 4u);
}

BOOST_AUTO_TEST_CASE(what_is_smaller_than_the_tolerance_is_reported) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 1, 1), source_1);
  draw(drawing, rectangle(0.5, 0.5, 1e-7, 1e-7), target_2);
  const auto imprint = done(drawing, 1e-6);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 1u);
  BOOST_TEST(imprint.notes.size() == 1u);
  BOOST_TEST(imprint.lost == std::vector<int>{target_2.target}, boost::test_tools::per_element());
  BOOST_TEST(imprint.chains[5].size() == 1u);
}

BOOST_AUTO_TEST_CASE(empty_zero_length_and_repeated_segments) {
  BOOST_TEST(done(Layer_drawing<Kernel>{}, 1e-6).segments().empty());
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 1, 1), source_1);
  drawing.segments.push_back({Node_index(0), Node_index(0), source_1, {}});
  drawing.segments.push_back(drawing.segments[2]);
  drawing.segments.push_back({Node_index(0), Node_index(2), {}, {}});  // says nothing
  const auto imprint = done(drawing, 1e-6);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 1u);
  BOOST_TEST(imprint.segments().size() == 4u);
}

BOOST_AUTO_TEST_CASE(pinched_and_nested_loops) {
  Layer_drawing<Kernel> drawing;
  draw(drawing, rectangle(0, 0, 10, 10), target_2);
  draw(drawing, reversed(rectangle(2, 2, 2, 2)), target_2);
  draw(drawing, reversed(rectangle(4, 4, 2, 2)), target_2);      // touches the last one in a vertex
  draw(drawing, reversed({{0, 10}, {4, 8}, {4, 9}}), target_2);  // touches the outline in a vertex
  draw(drawing, rectangle(2.5, 2.5, 1, 1), target_3);            // an island in the first
  const auto imprint = done(drawing, 0);
  BOOST_TEST(imprint.graph.number_of_loop_faces() == 2u);
  BOOST_TEST(tally(imprint).at(target_2).area == 90);
}

BOOST_AUTO_TEST_CASE(contradictions_are_refused) {
  Layer_drawing<Kernel> overlapping;
  draw(overlapping, rectangle(0, 0, 2, 2), target_2);
  draw(overlapping, rectangle(1, 1, 2, 2), target_3);
  Status status = imprint_layer(overlapping, 0).status();
  BOOST_TEST((status.code == Status_code::imprint_failed));
  BOOST_TEST((status.patches == std::vector<int>{2, 3}));
  BOOST_TEST(status.place.has_value());

  Layer_drawing<Kernel> open;
  draw(open, rectangle(0, 0, 2, 2), source_1);
  open.segments.pop_back();
  status = imprint_layer(open, 0).status();
  BOOST_TEST((status.code == Status_code::imprint_failed));
  BOOST_TEST((status.patches == std::vector<int>{1}));

  Layer_drawing<Kernel> along_an_edge;
  draw(along_an_edge, rectangle(0, 0, 1, 1), target_2);
  draw(along_an_edge, rectangle(0, 0, 1, 1), target_3);
  status = imprint_layer(along_an_edge, 0).status();
  BOOST_TEST((status.code == Status_code::imprint_failed));
  BOOST_TEST((status.patches == std::vector<int>{2, 3}));

  BOOST_TEST((imprint_layer(open, -1).status().code == Status_code::invalid_parameter));
  open.segments.push_back({Node_index(0), Node_index(77), {}, {}});
  BOOST_TEST((imprint_layer(open, 0).status().code == Status_code::invalid_parameter));
  open.segments.pop_back();
  open.nodes[2].point = Kernel::Point_2(0, std::nan(""));
  BOOST_TEST((imprint_layer(open, 0).status().code == Status_code::invalid_parameter));
}

BOOST_AUTO_TEST_CASE(areas_of_the_three_results_add_up) {
  std::mt19937 random(21);
  for (int i = 0; i < 10; ++i) {
    const Loop s = star(random, 20, 0, 0), t = star(random, 20, 0.2, 0.1);
    const auto imprint = imprint_faces<Rational>(loops<Rational>({s}), loops<Rational>({t}), 0).value();
    Rational::FT in_s = 0, in_t = 0;
    for (const auto& [label, entry] : tally(imprint)) {
      if (label.source == 0) in_s += entry.area;
      if (label.target == 0) in_t += entry.area;
    }
    std::vector<Node_index> second;
    for (std::size_t n = 20; n < 40; ++n) second.emplace_back(n);
    BOOST_TEST((in_s == area<Rational>(first_nodes(20), imprint.points)));
    BOOST_TEST((in_t == area<Rational>(second, imprint.points)));
  }
}

BOOST_AUTO_TEST_CASE(fuzz_with_rounding) {
  // Many segments of few directions through few points: everything coincides, and nothing exactly.
  std::mt19937 random(33);
  std::uniform_real_distribution<double> angle(0, 6.28);
  for (int i = 0; i < 60; ++i) {
    const double a = angle(random), c = std::cos(a), s = std::sin(a);
    Layer_drawing<Kernel> drawing;
    int label = 0;
    for (int x = 0; x < 5; ++x) {
      for (int y = 0; y < 5; ++y) {
        for (bool is_source : {true, false}) {
          Loop cell = rectangle(x + (is_source ? 0 : 0.5), y, 1, 1);
          if (random() % 4 == 0) continue;
          for (auto& p : cell) p = {c * p[0] - s * p[1], s * p[0] + c * p[1]};
          draw(drawing, cell, is_source ? Loop_label{label++, -1} : Loop_label{-1, label++},
               {.fixed = random() % 2 == 0});
        }
      }
    }
    for (double tolerance : {1e-12, 1e-9, 1e-5}) {
      const auto imprint = done(drawing, tolerance);
      for (const auto& [l, entry] : tally(imprint))
        BOOST_TEST(std::fabs(entry.area - std::round(2 * entry.area) / 2) < 1e-4);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
