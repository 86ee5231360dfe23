// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The models and a few random parts: what their facts say, and what must not change when the part is told otherwise.
#include <CCSweep/IO/read_part.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "decompose_runs.h"
#include "mesh_changes.h"
#include "random_parts.h"

namespace {

namespace fs = std::filesystem;
namespace bdata = boost::unit_test::data;
using namespace decompose_runs;
using CCSweep::Role;
using CCSweep::Stage;
using CCSweep::Status_code;
using Json = nlohmann::json;

Json facts(const std::string& model) { return Json::parse(std::ifstream(CCSWEEP_TEST_DATA "/" + model + ".json")); }

Soup model_soup(const std::string& model) {
  return mesh_changes::soup(
      CCSweep::read_part<Kernel::Point_3>(CCSWEEP_TEST_DATA "/" + model + ".ply").value().mesh);
}

std::vector<std::string> models(bool sweepable) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(CCSWEEP_TEST_DATA)) {
    const std::string name = entry.path().stem();
    if (entry.path().extension() == ".json" && facts(name)["sweepable"] == sweepable) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

// A part with the direction it is swept along.
struct Example {
  Soup soup;
  Coordinates direction;
  bool planar_layers = true;  // the sub-volumes are the same to rounding wherever the layers are

  double tolerance() const { return planar_layers ? 1e-9 : 1e-2; }
};

const std::map<std::string, random_parts::Family>& families() {
  using random_parts::Family;
  static const std::map<std::string, Family> map{
      {"random_grids", Family::grids},       {"random_barrels", Family::barrels}, {"random_circles", Family::circles},
      {"random_polygons", Family::polygons}, {"random_split", Family::split},     {"random_windows", Family::windows}};
  return map;
}

std::vector<std::string> examples() {
  std::vector<std::string> names = models(true);
  for (const auto& [name, family] : families()) names.push_back(name);
  return names;
}

Example make_example(const std::string& name) {
  if (const auto family = families().find(name); family != families().end()) {
    const random_parts::Part part = random_parts::make(family->second, 500);
    return {{part.points, part.triangles, part.patch}, {0, 0, 1}, true};
  }
  const Json known = facts(name);
  return {model_soup(name), known["sweep_direction"].get<Coordinates>(), known["planar_layers"].get<bool>()};
}

// The example and its decomposition, made once.
struct Reference {
  Example example;
  Outcome outcome;
  Answer answer;
};

const Reference& reference(const std::string& name) {
  static std::map<std::string, Reference> known;
  auto found = known.find(name);
  if (found == known.end()) {
    Example example = make_example(name);
    Outcome outcome = decompose(example.soup, {example.direction});
    Answer answer;
    if (outcome.ok()) answer = decompose_runs::answer(outcome.value());
    found = known.emplace(name, Reference{std::move(example), std::move(outcome), std::move(answer)}).first;
  }
  BOOST_TEST_REQUIRE(found->second.outcome.ok(), found->second.outcome.status().reason);
  return found->second;
}

Coordinates opposite(const Coordinates& d) { return mesh_changes::scaled(d, -1); }

std::vector<int> ids(const Answer& answer, Role role) {
  std::vector<int> result;
  for (const auto& [id, r] : answer.roles)
    if (r == role) result.push_back(id);
  return result;
}

void expect_sets(std::size_t found, const Json& known) {
  if (known.value("expected_sets_certain", true)) {
    if (known.contains("expected_sets") && !known["expected_sets"].is_null())
      BOOST_TEST(found == known["expected_sets"].get<std::size_t>());
  } else {
    BOOST_TEST(found >= known["expected_sets_range"][0].get<std::size_t>());
    BOOST_TEST(found <= known["expected_sets_range"][1].get<std::size_t>());
  }
}

// The facts hold for the exact solid; chords make the mesh, and more so its small round pieces, differ from it.
double chord_error(const Json& known) {
  const double whole = known["volume"].get<double>(), of_mesh = known["mesh_volume"].get<double>();
  return known["planar_only"].get<bool>() ? 1e-9 : 5e-3 + 3 * std::abs(of_mesh / whole - 1);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(decompose_models)

BOOST_DATA_TEST_CASE(the_facts_of_the_models_hold, bdata::make(models(true)), model) {
  const Json known = facts(model);
  const Reference& of_model = reference(model);
  const Answer& found = of_model.answer;
  BOOST_TEST(found.volumes.size() == known["expected_volumes"].get<std::size_t>());
  expect_sets(found.sets.size(), known);
  BOOST_TEST((ids(found, Role::source) == known["sources"].get<std::vector<int>>()));
  BOOST_TEST((ids(found, Role::target) == known["targets"].get<std::vector<int>>()));
  BOOST_TEST((ids(found, Role::linking) == known["linking"].get<std::vector<int>>()));
  BOOST_TEST(std::abs(total(found.volumes) / known["mesh_volume"].get<double>() - 1) < 1e-12);
  if (!known.contains("subvolumes") || known["subvolumes"].is_null()) return;
  for (const Json& expected : known["subvolumes"]) {
    const int target = expected["target"].get<int>();
    BOOST_TEST_CONTEXT("target " << target) {
      BOOST_TEST_REQUIRE(found.volumes.count(target) == 1u);
      BOOST_TEST(std::abs(found.volumes.at(target) / expected["volume"].get<double>() - 1) < chord_error(known),
                 found.volumes.at(target) << " instead of " << expected["volume"]);
      if (expected.contains("sources")) {
        std::vector<int> sources = expected["sources"].get<std::vector<int>>();
        std::sort(sources.begin(), sources.end());
        BOOST_TEST((found.sources.at(target) == sources));
      }
    }
  }
}

BOOST_DATA_TEST_CASE(sources_and_targets_may_change_places, bdata::make(models(true)), model) {
  const Json known = facts(model);
  const Example& example = reference(model).example;
  const Outcome outcome = decompose(example.soup, {opposite(example.direction)});
  expect_ok(outcome);
  if (!outcome.ok()) return;
  const Answer found = answer(outcome.value());
  BOOST_TEST(found.volumes.size() == known["reversed"]["expected_volumes"].get<std::size_t>());
  if (known["expected_sets_certain"].get<bool>()) expect_sets(found.sets.size(), known["reversed"]);
  BOOST_TEST((ids(found, Role::target) == known["sources"].get<std::vector<int>>()));
  BOOST_TEST((ids(found, Role::source) == known["targets"].get<std::vector<int>>()));
}

BOOST_DATA_TEST_CASE(what_can_not_be_swept_is_refused_by_name, bdata::make(models(false)), model) {
  const Soup soup = model_soup(model);
  const Mesh mesh = mesh_changes::mesh<Kernel::Point_3>(soup), before = mesh;
  const Outcome outcome = decompose(mesh, {});
  const CCSweep::Status status = outcome.status();
  BOOST_TEST((status.code == Status_code::not_sweepable));
  BOOST_TEST((status.stage == Stage::roles));
  BOOST_TEST(!status.reason.empty());
  BOOST_TEST(!status.patches.empty());
  for (int id : status.patches) BOOST_TEST(std::count(soup.patch.begin(), soup.patch.end(), id) > 0);
  BOOST_TEST(is_same_mesh(before, mesh, [](const Coordinates& p) { return p; }));
}

#ifdef NDEBUG
BOOST_DATA_TEST_CASE(a_model_takes_less_than_a_second, bdata::make(models(true)), model) {
  const Example& example = reference(model).example;
  const std::clock_t start = std::clock();  // of the processor, whatever else the machine does
  decompose(example.soup, {example.direction});
  BOOST_TEST(double(std::clock() - start) / CLOCKS_PER_SEC < 1);
}
#endif

BOOST_DATA_TEST_CASE(layers_do_not_change_the_answer, bdata::make(examples()), name) {
  const Reference& known = reference(name);
  for (int layers : {2, 5}) BOOST_TEST_CONTEXT(layers << " layers")
  expect_same(known.example.soup, {known.example.direction, {}, {}, layers}, known.answer, known.example.tolerance());
  for (double angle : {10., 35., 180.}) BOOST_TEST_CONTEXT("spanning angle " << angle)
  expect_same(known.example.soup, {known.example.direction, {}, {}, 1, angle}, known.answer,
              known.example.tolerance());
}

BOOST_DATA_TEST_CASE(the_order_of_the_input_does_not_change_a_byte, bdata::make(examples()), name) {
  const Reference& known = reference(name);
  for (std::uint32_t seed : {1u, 2u, 3u}) {
    const Outcome outcome = decompose(mesh_changes::shuffled(known.example.soup, seed), {known.example.direction});
    expect_ok(outcome);
    if (outcome.ok())
      expect_same_bytes(known.outcome.value(), outcome.value(), [](const Coordinates& p) { return p; });
  }
}

BOOST_DATA_TEST_CASE(a_scale_by_a_power_of_two_scales_every_bit, bdata::make(examples()), name) {
  const Reference& known = reference(name);
  for (double factor : {1. / 1024, 2., 65536.}) BOOST_TEST_CONTEXT("factor " << factor) {
    auto scale = [&](const Coordinates& p) { return mesh_changes::scaled(p, factor); };
    const Outcome outcome = decompose(mesh_changes::moved(known.example.soup, scale), {known.example.direction});
    expect_ok(outcome);
    if (outcome.ok()) expect_same_bytes(known.outcome.value(), outcome.value(), scale);
  }
}

BOOST_DATA_TEST_CASE(the_place_of_the_part_does_not_change_the_answer, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  const double rounding = std::max(example.tolerance(), 1e-7);
  BOOST_TEST_CONTEXT("mirrored")
  expect_same(mesh_changes::mirrored(example.soup), {mesh_changes::mirrored(example.direction)}, expected, rounding);
  for (double angle : {0.3, 1.1, 2.9}) BOOST_TEST_CONTEXT("turned by " << angle) {
    auto turn = [&](const Coordinates& p) { return mesh_changes::turned(p, angle); };
    expect_same(mesh_changes::moved(example.soup, turn), {turn(example.direction)}, expected, rounding);
  }
  BOOST_TEST_CONTEXT("a thousandth")
  expect_same(mesh_changes::moved(example.soup, [](const Coordinates& p) { return mesh_changes::scaled(p, 1e-3); }),
              {example.direction}, expected, rounding, 1e-9);
  BOOST_TEST_CONTEXT("far away")
  expect_same(mesh_changes::moved(example.soup,
                                  [](const Coordinates& p) {
                                    return Coordinates{p[0] + 1e6, p[1] - 1e6, p[2] + 1e6};
                                  }),
              {example.direction}, expected, rounding);
}

BOOST_DATA_TEST_CASE(finer_facets_do_not_change_the_answer, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  expect_same(mesh_changes::with_split_facets(example.soup), {example.direction}, expected, example.tolerance());
}

BOOST_DATA_TEST_CASE(finer_edges_do_not_change_the_answer, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  expect_same(mesh_changes::with_split_edges(example.soup), {example.direction}, expected, example.tolerance());
}

BOOST_DATA_TEST_CASE(a_patch_in_two_is_the_same_surface, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  const int new_id = 1 + *std::max_element(example.soup.patch.begin(), example.soup.patch.end());
  for (Role role : {Role::linking, Role::source, Role::target}) {
    int tried = 0;
    for (int id : ids(expected, role)) {
      const auto soup = mesh_changes::with_split_patch(example.soup, id, new_id);
      if (!soup || ++tried > 2) continue;
      BOOST_TEST_CONTEXT(CCSweep::name(role) << ' ' << id) {
        const Outcome again = decompose(*soup, {example.direction});
        expect_ok(again);
        if (!again.ok()) continue;
        Answer found = answer(again.value());
        BOOST_TEST((found.roles.at(new_id) == role));
        BOOST_TEST((found.roles.at(id) == role));
        BOOST_TEST(found.sets.size() >= expected.sets.size());
        if (role == Role::target) {  // a sub-volume for each
          BOOST_TEST(found.volumes.count(new_id) == 1u);
          found.volumes[id] += found.volumes[new_id];
          found.volumes.erase(new_id);
        }
        expect_same_volumes(found, expected, example.tolerance());
      }
    }
  }
}

BOOST_DATA_TEST_CASE(caps_may_be_named_instead_of_the_direction, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  const std::vector<int> sources = ids(expected, Role::source), targets = ids(expected, Role::target);
  BOOST_TEST_CONTEXT("both lists")
  expect_same(example.soup, {{}, sources, targets}, expected, example.tolerance());
  BOOST_TEST_CONTEXT("targets")
  expect_same(example.soup, {{}, {}, targets}, expected, example.tolerance());
  BOOST_TEST_CONTEXT("sources")
  expect_same(example.soup, {{}, sources, {}}, expected, example.tolerance());
  BOOST_TEST_CONTEXT("lists and direction")
  expect_same(example.soup, {example.direction, sources, targets}, expected, example.tolerance());
}

BOOST_DATA_TEST_CASE(wrong_lists_of_caps_are_refused, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  const std::vector<int> sources = ids(expected, Role::source), targets = ids(expected, Role::target);
  const int linking = ids(expected, Role::linking).front();
  auto expect_refused = [&, &soup = example.soup](const Request& request, Status_code code, int patch) {
    const CCSweep::Status status = decompose(soup, request).status();
    BOOST_TEST((status.code == code), CCSweep::name(status.code) << ": " << status.reason);
    BOOST_TEST((status.stage == Stage::roles));
    BOOST_TEST(std::count(status.patches.begin(), status.patches.end(), patch) == 1);
    BOOST_TEST(!status.reason.empty());
  };
  BOOST_TEST_CONTEXT("no such patch") expect_refused({{}, {}, {12345}}, Status_code::invalid_parameter, 12345);
  BOOST_TEST_CONTEXT("source and target")
  expect_refused({{}, {sources[0]}, {sources[0]}}, Status_code::invalid_parameter, sources[0]);
  std::vector<int> with_linking = targets;
  with_linking.push_back(linking);
  BOOST_TEST_CONTEXT("linking face as target")
  expect_refused({example.direction, {}, with_linking}, Status_code::not_sweepable, linking);
  BOOST_TEST_CONTEXT("senses mixed")
  expect_refused({example.direction, targets, sources}, Status_code::not_sweepable, targets[0]);
  if (sources.size() > 1)
    BOOST_TEST_CONTEXT("a source not listed")
  expect_refused({example.direction, {sources.begin() + 1, sources.end()}, {}}, Status_code::not_sweepable, sources[0]);
}

// A counterbore whose circle crosses the outer circle of a ring below in two shallow arcs, with chords nearly as far
// apart as their chord errors: where they merge depends on the layers, but a cut must not fold over another there.
BOOST_DATA_TEST_CASE(arcs_that_cross_at_a_small_angle, bdata::make({1, 2, 5}), layers) {
  const Soup soup = model_soup("counterbore_over_ring");
  for (double sense : {-1., 1.}) BOOST_TEST_CONTEXT("sense " << sense) {
    for (const Soup& part : {soup, mesh_changes::with_split_edges(soup), mesh_changes::with_split_facets(soup)}) {
      const Outcome outcome = decompose(part, {{0, 0, sense}, {}, {}, layers});
      expect_ok(outcome);
      if (outcome.ok()) BOOST_TEST(outcome.value().volumes.size() == 3u);
    }
  }
}

BOOST_DATA_TEST_CASE(options_out_of_range_are_refused, bdata::make({"cylinder"}), name) {
  const auto& [example, outcome, expected] = reference(name);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Request& request :
       {Request{example.direction, {}, {}, 0}, Request{example.direction, {}, {}, -3},
        Request{example.direction, {}, {}, 1, 0}, Request{example.direction, {}, {}, 1, 181},
        Request{example.direction, {}, {}, 1, nan}, Request{{nan, 0, 1}}}) {
    const CCSweep::Status status = decompose(example.soup, request).status();
    BOOST_TEST((status.code == Status_code::invalid_parameter), CCSweep::name(status.code) << ": " << status.reason);
  }
}

BOOST_DATA_TEST_CASE(a_sub_volume_is_its_own_decomposition, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  for (const auto& sub_volume : outcome.value().volumes) BOOST_TEST_CONTEXT("target " << sub_volume.target) {
    const Outcome again = decompose(sub_volume.mesh, {outcome.value().direction});
    expect_ok(again);
    if (!again.ok()) continue;
    BOOST_TEST(again.value().volumes.size() == 1u);
    BOOST_TEST(again.value().sets.empty());
    BOOST_TEST(again.value().volumes[0].target == sub_volume.target);
    BOOST_TEST((again.value().volumes[0].sources == sub_volume.sources));
    BOOST_TEST(std::abs(volume(again.value().volumes[0].mesh) / volume(sub_volume.mesh) - 1) < 1e-12);
  }
}

BOOST_DATA_TEST_CASE(a_visitor_stops_at_each_of_its_questions, bdata::make({"cylinder", "random_windows"}), name) {
  const auto& [example, outcome, expected] = reference(name);
  const Mesh mesh = mesh_changes::mesh<Kernel::Point_3>(example.soup), before = mesh;
  Recorder all;
  decompose(mesh, {example.direction}, all);
  BOOST_TEST(all.questions > 0u);
  for (std::size_t i = 1; i <= all.questions; ++i) BOOST_TEST_CONTEXT("question " << i) {
    Recorder recorder;
    recorder.refused_question = i;
    const Outcome stopped = decompose(mesh, {example.direction}, recorder);
    BOOST_TEST((stopped.status().code == Status_code::cancelled));
    BOOST_TEST(recorder.questions == i);
    BOOST_TEST((recorder.calls.back().kind == Recorder::Kind::cancel));
    BOOST_TEST(is_same_mesh(before, mesh, [](const Coordinates& p) { return p; }));
  }
}

BOOST_DATA_TEST_CASE(a_visitor_is_called_as_often_as_promised, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  for (int layers : {1, 3}) BOOST_TEST_CONTEXT(layers << " layers") {
    Recorder recorder;
    const Outcome watched =
        decompose(mesh_changes::mesh<Kernel::Point_3>(example.soup), {example.direction, {}, {}, layers}, recorder);
    BOOST_TEST_REQUIRE(watched.ok());
    using Kind = Recorder::Kind;
    std::size_t steps = 0;
    for (const auto& call : recorder.calls) {
      if (call.kind != Kind::begin) continue;
      BOOST_TEST_CONTEXT("stage " << CCSweep::name(call.stage)) {
        BOOST_TEST(recorder.count(Kind::begin, call.stage) == recorder.count(Kind::end, call.stage));
        BOOST_TEST(recorder.count(Kind::step, call.stage) == call.number);
      }
      steps += call.number;
    }
    BOOST_TEST(recorder.count(Kind::step) == steps);
    BOOST_TEST(recorder.questions >= steps);
    BOOST_TEST(recorder.count(Kind::drawn) == watched.value().layers);
    BOOST_TEST(recorder.count(Kind::imprinted) == watched.value().levels.size());
  }
}

BOOST_DATA_TEST_CASE(a_stage_begins_once, bdata::make(examples()), name) {
  const auto& [example, outcome, expected] = reference(name);
  Recorder recorder;
  decompose(mesh_changes::mesh<Kernel::Point_3>(example.soup), {example.direction}, recorder);
  for (Stage stage : {Stage::roles, Stage::layers, Stage::linking_mesh, Stage::imprint, Stage::decomposition_sets,
                      Stage::sub_volumes, Stage::verification})
    BOOST_TEST_CONTEXT("stage " << CCSweep::name(stage))
  BOOST_TEST(recorder.count(Recorder::Kind::begin, stage) == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
