// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random layers against CGAL's overlay. CCSWEEP_CAMPAIGN says how many, a thousand if it is not set. What fails is cut
// down and written to imprint_failure_*.txt; CCSWEEP_IMPRINT_CASE names such a file to be run again.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "loops_generators.h"
#include "loops_oracle.h"
#include "loops_scene.h"

namespace {

using namespace loops_test;

unsigned number_of_scenes() {
  const char* const number = std::getenv("CCSWEEP_CAMPAIGN");
  return number == nullptr ? 1000 : static_cast<unsigned>(std::strtoul(number, nullptr, 10));
}

void keep(const Scene& scene, const std::string& what) {
  const auto fails = [](const Scene& smaller) { return !difference(smaller).empty(); };
  const Scene small = Minimiser(scene, fails).run();
  std::string name = "imprint_failure_" + scene.name + ".txt";
  std::replace(name.begin(), name.end(), ' ', '_');
  std::ofstream file(name);
  write(file, small);
  BOOST_ERROR(scene.name << ": " << what << "; see " << name);
}

template <class K>
typename K::FT area(const std::vector<Piece>& pieces) {
  typename K::FT sum(0);
  const auto add = [&](const Loop& loop, int sign) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto &p = loop[i], &q = loop[(i + 1) % loop.size()];
      using FT = typename K::FT;
      sum += FT(sign) * (FT(p[0]) * FT(q[1]) - FT(q[0]) * FT(p[1])) / FT(2);
    }
  };
  for (const Piece& piece : pieces) {
    add(piece.outer, 1);
    for (const Loop& hole : piece.holes) add(hole, -1);
  }
  return sum;
}

template <class K>
Tallies<typename K::FT> tallied(const CCSweep::Layer_drawing<K>& drawing) {
  const auto imprint = CCSweep::imprint_layer(drawing, 0);
  BOOST_REQUIRE_MESSAGE(imprint.ok(), imprint.status().reason);
  return tally(imprint.value());
}

template <class Function>
Scene mapped(Scene scene, bool turns_over, const Function& f) {
  const auto map = [&](Loop& loop) {
    for (auto& p : loop) p = f(p);
    if (turns_over) loop = reversed(loop);
  };
  for (auto* set : {&scene.sources, &scene.targets}) {
    for (Piece& piece : *set) {
      map(piece.outer);
      for (Loop& hole : piece.holes) map(hole);
    }
  }
  return scene;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loops_campaign)

BOOST_AUTO_TEST_CASE(random_layers_against_the_overlay) {
  for (unsigned i = 0; i < number_of_scenes(); ++i) {
    const Scene scene = Generator::make(static_cast<int>(i) % Generator::kinds, i / Generator::kinds);
    const std::string wrong = difference(scene);
    if (wrong.empty()) continue;
    keep(scene, wrong);
  }
}

BOOST_AUTO_TEST_CASE(kept_cases) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(CCSWEEP_TEST_DATA)) {
    if (entry.path().filename().string().starts_with("loops_")) files.push_back(entry.path());
  }
  if (const char* const name = std::getenv("CCSWEEP_IMPRINT_CASE")) files.emplace_back(name);
  BOOST_TEST(!files.empty());
  for (const auto& path : files) {
    std::ifstream file(path);
    const Scene scene = read(file);
    BOOST_TEST(!(scene.sources.empty() && scene.targets.empty()), path);
    const std::string wrong = difference(scene);
    BOOST_TEST(wrong.empty(), path << ": " << wrong);
  }
}

BOOST_AUTO_TEST_CASE(areas_add_up_in_rationals) {
  using Rational = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  for (unsigned i = 0; i < 60; ++i) {
    const Scene scene = Generator::make(static_cast<int>(i) % Generator::kinds, 1000 + i);
    Rational::FT in_s(0), in_t(0);
    for (const auto& [label, entry] : tallied(drawn<Rational>(scene))) {
      if (label.source != Loop_label::none) in_s += entry.area;
      if (label.target != Loop_label::none) in_t += entry.area;
    }
    BOOST_TEST((in_s == area<Rational>(scene.sources)), scene.name);
    BOOST_TEST((in_t == area<Rational>(scene.targets)), scene.name);
  }
}

BOOST_AUTO_TEST_CASE(relations) {
  std::mt19937 random(5);
  for (unsigned i = 0; i < 60; ++i) {
    const Scene scene = Generator::make(static_cast<int>(i) % Generator::kinds, 2000 + i);
    BOOST_TEST_CONTEXT(scene.name) {
      const auto drawing = drawn<Exact>(scene);
      const auto expected = tallied(drawing);
      const auto turned = mapped(scene, false, [](const auto& p) { return std::array{-p[1], p[0]}; });
      BOOST_TEST(are_equal(expected, tallied(drawn<Exact>(turned))));
      const auto mirrored = mapped(scene, true, [](const auto& p) { return std::array{-p[0], p[1]}; });
      BOOST_TEST(are_equal(expected, tallied(drawn<Exact>(mirrored))));
      const auto scaled = mapped(scene, false, [](const auto& p) { return std::array{p[0] / 8, p[1] / 8}; });
      BOOST_TEST(are_equal(expected, tallied(drawn<Exact>(scaled)), Exact::FT(1) / 64));

      Tallies<Exact::FT> swapped;
      for (const auto& [label, entry] : tallied(drawn<Exact>({scene.name, scene.targets, scene.sources}))) {
        swapped[{label.target, label.source}] = entry;
      }
      BOOST_TEST(are_equal(expected, swapped));

      auto shuffled = drawing;
      std::shuffle(shuffled.segments.begin(), shuffled.segments.end(), random);
      BOOST_TEST(are_equal(expected, tallied(shuffled)));

      auto split = drawing;
      for (std::size_t s = 0; s < drawing.segments.size(); s += 2) {
        const auto &p = drawing.nodes[drawing.segments[s].source.value()].point,
                   &q = drawing.nodes[drawing.segments[s].target.value()].point;
        split.segments.push_back(drawing.segments[s]);
        split.segments[s].target = split.segments.back().source = Node_index(split.nodes.size());
        split.nodes.push_back({CGAL::midpoint(p, q)});
      }
      BOOST_TEST(are_equal(expected, tallied(split)));
    }
  }
}

BOOST_AUTO_TEST_CASE(scenes_are_read_as_they_were_written) {
  for (unsigned i = 0; i < 40; ++i) {
    const Scene scene = Generator::make(static_cast<int>(i) % Generator::kinds, 3000 + i);
    std::stringstream file;
    write(file, scene);
    const Scene again = read(file);
    BOOST_TEST(again.name == scene.name);
    BOOST_TEST((again.sources == scene.sources && again.targets == scene.targets));
  }
}

BOOST_AUTO_TEST_CASE(minimiser_keeps_what_fails) {
  // As if two faces with more than half of the first in the second were a failure.
  const Scene scene = Generator::make(1, 4);
  const auto fails = [](const Scene& s) {
    if (s.sources.empty() || s.targets.empty()) return false;
    return area<Inexact>(s.sources) > 8 && area<Inexact>(s.targets) > 8;
  };
  BOOST_REQUIRE(fails(scene));
  const Scene small = Minimiser(scene, fails).run();
  BOOST_TEST(fails(small));
  BOOST_TEST(small.sources.size() == 1u);
  BOOST_TEST(small.sources[0].holes.empty());
  BOOST_TEST(small.sources[0].outer.size() == 3u);
  BOOST_TEST(small.targets[0].outer.size() == 3u);
}

BOOST_AUTO_TEST_SUITE_END()
