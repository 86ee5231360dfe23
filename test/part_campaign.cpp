// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Random parts of every family in every shape, checked against how they were made. CCSWEEP_CAMPAIGN says how many, a
// sample if it is not set. What fails is written to part_failure_*.ply, which `ccsweep` reads.
#include <CCSweep/IO/read_part.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "curved_parts.h"
#include "decompose_runs.h"

namespace {

using namespace curved_parts;
using namespace decompose_runs;
using random_parts::Family;

constexpr std::size_t sample = 180;
constexpr std::size_t campaign = 1000;  // fewer tell a percentage only roughly

std::size_t number_of_parts() {
  const char* const number = std::getenv("CCSWEEP_CAMPAIGN");
  return number == nullptr ? sample : std::strtoul(number, nullptr, 10);
}

// Where the layers are flat and stay what they were, so do the volumes; elsewhere they depend on how a cut is carried
// between bent walls.
bool is_straight(Shape shape) {
  return shape == Shape::straight || shape == Shape::placed || shape == Shape::slender || shape == Shape::faceted;
}

// Where the cuts run inside is free within bounds; what runs along the sweep of the construction is one choice.
double volume_tolerance(Shape shape) {
  if (shape == Shape::faceted) return 0.03;
  if (is_straight(shape)) return 1e-8;
  return shape == Shape::fan || shape == Shape::bent || shape == Shape::u_bend || shape == Shape::bent_bar ? 0.1 : 0.03;
}

// Where the caps bend or the sweep does, levels that were equal need not be, and a set may reach another corner.
bool has_known_sets(Shape shape) { return is_straight(shape) || shape == Shape::leaning || shape == Shape::tapered; }

struct Trial {
  Shape shape;
  std::size_t family;
  std::uint32_t seed;
  std::string name() const {
    return std::string(curved_parts::name(shape)) + "_" + std::to_string(family) + "_" + std::to_string(seed);
  }
};

// Families change faster than shapes, so that a sample meets all of both.
Trial trial(std::size_t i) {
  const std::size_t n = random_parts::all_families.size();
  return {shapes[i / n % shapes.size()], i % n, static_cast<std::uint32_t>(i / n / shapes.size())};
}

// A cap that the bend has turned far may pass for a leaning wall of a straight sweep, and at a U-bend both ends look
// down: the caps are named.
Outcome run(const Swept_part& swept, const Mesh& mesh) {
  const auto& sources = swept.part.sources;
  std::vector<int> targets;
  for (const auto& [target, volume] : swept.part.sub_volumes) targets.push_back(target);
  constexpr int layers = 1;
  constexpr double spanning_angle = 7.5;  // the default of the library
  return decompose(mesh, {swept.direction, {sources.begin(), sources.end()}, targets, layers, spanning_angle});
}

// What is wrong with a result that was reported as a success; nothing if it is right.
std::string defect(const Trial& trial, const Swept_part& swept, const Mesh& mesh, const Decomposition& found) {
  const Part& part = swept.part;
  const double tolerance = volume_tolerance(trial.shape);
  const Answer answer = decompose_runs::answer(found);
  std::ostringstream text;
  if (found.volumes.size() != part.sub_volumes.size())
    text << found.volumes.size() << " sub-volumes instead of " << part.sub_volumes.size() << "; ";
  for (const auto& [target, expected] : part.sub_volumes) {
    const auto known = answer.volumes.find(target);
    if (known == answer.volumes.end() || std::abs(known->second - expected) > tolerance * part.volume)
      text << "not the volume of target " << target << "; ";
  }
  for (const auto& [id, role] : answer.roles)
    if ((role == CCSweep::Role::source) != (part.sources.count(id) > 0)) text << "role of patch " << id << "; ";
  const double whole = volume(mesh);
  if (std::abs(total(answer.volumes) - whole) > 1e-8 * whole) text << "the volumes do not add up; ";
  return text.str();
}

class Table {
 public:
  void add(const Trial& trial, const std::string& status) { ++counts_[trial.shape][status]; }

  double share(bool straight, const std::string& status) const {
    std::size_t found = 0, all = 0;
    for (const auto& [shape, counts] : counts_)
      for (const auto& [s, n] : counts)
        if (is_straight(shape) == straight) {
          all += n;
          found += s == status ? n : 0;
        }
    return all == 0 ? 1 : double(found) / double(all);
  }

  std::string text() const {
    std::ostringstream out;
    for (const auto& [shape, counts] : counts_) {
      out << std::left << std::setw(10) << name(shape);
      for (const auto& [status, n] : counts) out << "  " << status << ' ' << n;
      out << '\n';
    }
    return out.str();
  }

 private:
  std::map<Shape, std::map<std::string, std::size_t>> counts_;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(part_campaign)

BOOST_AUTO_TEST_CASE(random_parts_of_all_families_and_shapes) {
  Table table;
  for (std::size_t i = 0; i < number_of_parts(); ++i) {
    const Trial t = trial(i);
    const Swept_part swept = make(t.shape, random_parts::all_families[t.family], t.seed);
    const Mesh mesh = random_parts::mesh<Kernel::Point_3>(swept.part);
    // The generator is an oracle, so its parts must be sound, and what it says of them must fit.
    BOOST_TEST((mesh.number_of_faces() == swept.part.triangles.size() && CGAL::is_closed(mesh)), t.name());
    BOOST_TEST(std::abs(volume(mesh) / swept.part.volume - 1) < 0.03, t.name());
    const Outcome outcome = run(swept, mesh);
    const std::string file = "part_failure_" + t.name() + ".ply";
    if (!outcome.ok()) {
      table.add(t, CCSweep::name(outcome.status().code));
      random_parts::write_ply(swept.part, file);
      BOOST_TEST_MESSAGE(t.name() << ": " << outcome.status().reason);
      continue;
    }
    const std::string wrong = defect(t, swept, mesh, outcome.value());
    const std::size_t sets = outcome.value().sets.size();
    const bool has_other_sets = has_known_sets(t.shape) && sets != swept.part.sets;
    table.add(t, !wrong.empty() ? "wrong" : has_other_sets ? "other_sets" : "decomposed");
    if (wrong.empty() && !has_other_sets) continue;
    random_parts::write_ply(swept.part, file);
    if (has_other_sets) BOOST_TEST_MESSAGE(t.name() << ": " << sets << " sets instead of " << swept.part.sets);
    if (!wrong.empty()) BOOST_ERROR(t.name() << ": " << wrong << "see " << file);
  }
  BOOST_TEST_MESSAGE(table.text());
  const bool is_long = number_of_parts() >= campaign;
  BOOST_TEST(table.share(true, "decomposed") >= (is_long ? 0.99 : 0.95));
  BOOST_TEST(table.share(false, "decomposed") >= (is_long ? 0.95 : 0.9));
}

// Each of them failed once, for a reason of its own.
BOOST_AUTO_TEST_CASE(parts_that_failed) {
  for (const Trial& t : {
           Trial{Shape::slanted, 0, 6},  // caps that meet in a point only
           Trial{Shape::saddle, 9, 0},   // levels all but on top of each other
           Trial{Shape::slanted, 5, 1},  // a low step beside long walls whose lengths differ by more
           Trial{Shape::fan, 0, 3},      // bent so little that it passes for straight
           Trial{Shape::faceted, 6, 0},  // upright walls whose facets all lean inward
           Trial{Shape::barrel, 1, 2},   // corners of walls that bend between two layers
           Trial{Shape::fan, 6, 1},      // caps beside one another, at distances that the fan makes differ
           Trial{Shape::twisted, 9, 0},  // cuts along walls that bend between two layers
           Trial{Shape::slanted, 9, 32},  // no cap across the sweep, but upright walls
           Trial{Shape::domed, 8, 6},     // a round pocket, higher in the mean than the dome around it
           Trial{Shape::domed, 0, 8},     // caps that no curve ties but a wall does
           Trial{Shape::twisted, 9, 8},   // cuts that miss the wall by more than the tolerance
           Trial{Shape::bent, 0, 4},      // a column that misses the corner of a cap
       })
    BOOST_TEST_CONTEXT(t.name()) {
      const Swept_part swept = make(t.shape, random_parts::all_families[t.family], t.seed);
      const Mesh mesh = random_parts::mesh<Kernel::Point_3>(swept.part);
      const Outcome outcome = run(swept, mesh);
      expect_ok(outcome);
      if (!outcome.ok()) continue;
      BOOST_TEST(defect(t, swept, mesh, outcome.value()) == "");
      if (has_known_sets(t.shape)) BOOST_TEST(outcome.value().sets.size() == swept.part.sets);
    }
}

BOOST_AUTO_TEST_CASE(a_part_that_was_written_is_read_again) {
  const Swept_part swept = make(Shape::twisted, Family::grids, 2);
  const std::string file = (std::filesystem::temp_directory_path() / "ccsweep_part_campaign.ply").string();
  BOOST_TEST_REQUIRE(random_parts::write_ply(swept.part, file));
  const auto again = CCSweep::read_part<Kernel::Point_3>(file);
  std::filesystem::remove(file);
  BOOST_TEST_REQUIRE(again.ok());
  const Soup soup = mesh_changes::soup(again.value().mesh);
  auto sorted = [](auto values) {
    std::sort(values.begin(), values.end());
    return values;
  };
  BOOST_TEST((sorted(soup.points) == sorted(swept.part.points)));
  BOOST_TEST((sorted(soup.patch) == sorted(swept.part.patch)));
}

BOOST_AUTO_TEST_SUITE_END()
