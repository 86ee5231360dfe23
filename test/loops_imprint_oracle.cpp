// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/test/unit_test.hpp>
#include <random>
#include <string>
#include <vector>

#include "loops_drawings.h"
#include "loops_oracle.h"
#include "loops_scene.h"

namespace {

using namespace loops_test;

void compare(const Scene& scene) {
  BOOST_TEST_CONTEXT(scene.name) {
    const auto expected = Oracle::of(scene);
    const auto exact = CCSweep::imprint_layer(drawn<Exact>(scene), 0);
    BOOST_REQUIRE_MESSAGE(exact.ok(), exact.status().reason);
    BOOST_TEST(is_valid(exact.value().graph, exact.value().points));
    BOOST_TEST(are_equal(tally(exact.value()), expected));
    const auto inexact = CCSweep::imprint_layer(drawn<Inexact>(scene), 1e-9);
    BOOST_REQUIRE_MESSAGE(inexact.ok(), inexact.status().reason);
    BOOST_TEST(is_valid(inexact.value().graph, inexact.value().points));
    const auto rounded = tally(inexact.value());
    BOOST_TEST(rounded.size() == expected.size());
    for (const auto& [label, entry] : expected) {
      BOOST_REQUIRE(rounded.count(label));
      BOOST_TEST(rounded.at(label).faces == entry.faces);
      BOOST_TEST(std::fabs(rounded.at(label).area - CGAL::to_double(entry.area)) < 1e-6);
    }
    BOOST_TEST(CCSweep::imprint_layer(drawn<Inexact>(scene), 0).ok());
  }
}

std::vector<Piece> grid(int n, double x, double y, double width) {
  std::vector<Piece> result;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j)
      result.push_back({10 + (2 * i + j) % 5, rectangle(x + i * width, y + j * width, width, width)});
  }
  return result;
}

std::vector<Piece> rings(int n, double x, double width) {
  std::vector<Piece> result;
  for (int i = 0; i < n; ++i) {
    const double outer = width * (2 * n - 2 * i), inner = outer - width;
    result.push_back({20 + i,
                      rectangle(x - outer, -outer, 2 * outer, 2 * outer),
                      {rectangle(x - inner, -inner, 2 * inner, 2 * inner)}});
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loops_imprint_oracle)

BOOST_AUTO_TEST_CASE(random_stars) {
  std::mt19937 random(7);
  for (int i = 0; i < 25; ++i) {
    const std::size_t n = 5 + random() % 30, m = 5 + random() % 30;
    compare({"stars " + std::to_string(i), {{1, star(random, n, 0, 0)}}, {{2, star(random, m, 0.3, 0.1)}}});
  }
}

BOOST_AUTO_TEST_CASE(random_stars_with_holes_and_islands) {
  std::mt19937 random(8);
  for (int i = 0; i < 10; ++i) {
    Piece frame{1, rectangle(-3, -3, 6, 6), {star(random, 17, -1.2, 0), star(random, 12, 1.2, 0.5)}};
    compare({"frames " + std::to_string(i), {frame}, {{2, star(random, 20, -1, 0)}, {3, star(random, 9, 1.1, 0.4)}}});
  }
}

BOOST_AUTO_TEST_CASE(grids_with_massive_coincidence) {
  compare({"same grid", grid(4, 0, 0, 1), grid(4, 0, 0, 1)});
  compare({"half cell", grid(4, 0, 0, 1), grid(4, 0.5, 0.5, 1)});
  compare({"one row on", grid(4, 0, 0, 1), grid(3, 1, 0, 1)});
  compare({"finer", grid(3, 0, 0, 1), grid(6, 0, 0, 0.5)});
}

BOOST_AUTO_TEST_CASE(nested_rings) {
  compare({"same", rings(5, 0, 1), rings(5, 0, 1)});
  compare({"shifted", rings(4, 0, 1), rings(4, 0.5, 1)});
  compare({"other width", rings(6, 0, 1), rings(3, 0, 1.5)});
}

BOOST_AUTO_TEST_CASE(polygons_in_one_circle) {
  for (std::size_t n = 3; n < 20; n += 4) {
    for (std::size_t m : {n, n + 1, 2 * n}) {
      compare({std::to_string(n) + " and " + std::to_string(m), {{1, regular(n, 1)}}, {{2, regular(m, 1)}}});
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
