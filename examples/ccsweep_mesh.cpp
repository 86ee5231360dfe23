// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The command line program's hexahedral meshes: of a part, of a decomposition in a folder, or of one sub-volume.
#include "ccsweep_run.h"

#include <CCSweep/IO/read_volumes.h>
#include <CCSweep/IO/write_hex_mesh.h>
#include <CCSweep/hex_mesh.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace program {
namespace {

using Point = CCSweep::Double_point;
using CCSweep::Hex_mesh;

constexpr int bars = 10;

// How many hexahedra have a scaled Jacobian in each tenth from 0 to 1.
std::vector<std::size_t> histogram(const std::vector<double>& qualities) {
  std::vector<std::size_t> counts(bars, 0);
  for (double q : qualities) ++counts[static_cast<std::size_t>(std::clamp(q * bars, 0.0, bars - 0.5))];
  return counts;
}

CCSweep::Patch_sizes sizes(const Options& options) {
  CCSweep::Patch_sizes sizes(options.size);
  for (const auto& [patch, size] : options.patch_sizes) sizes.patch(patch, size);
  for (const auto& [patches, size] : options.curve_sizes) sizes.curve(patches.first, patches.second, size);
  return sizes;
}

// A size for a patch that is not there would be lost without a word.
Status check_sizes(const Options& options, const std::set<int>& known) {
  std::vector<int> named;
  for (const auto& size : options.patch_sizes) named.push_back(size.first);
  for (const auto& size : options.curve_sizes) named.insert(named.end(), {size.first.first, size.first.second});
  for (int id : named)
    if (known.count(id) == 0)
      return {Status_code::invalid_parameter, Stage::hex_mesh, {id}, {},
              "--size-on: there is no patch " + std::to_string(id)};
  return {};
}

// What holds whatever the roles.
auto mesh_parameters(const Options& options, Progress& progress) {
  return CCSweep::parameters::tolerance(options.tolerance)
      .spanning_angle(options.spanning_angle)
      .layers(options.layers)
      .visitor(std::ref(progress))
      .size(sizes(options));
}

Result<Hex_mesh> mesh_part(const Options& options, Progress& progress) {
  const auto part = CCSweep::read_part<Point>(options.part, {true, options.angle});
  if (!part) return part.status();
  std::set<int> known;
  for (auto f : part.value().mesh.faces()) known.insert(get(part.value().patch_ids(), f));
  if (Status status = check_sizes(options, known); !status.ok()) return status;
  // A sub-volume knows its caps and its direction, but may have another one that suits it better.
  const bool is_free =
      options.sources.empty() && options.targets.empty() && options.direction == std::array<double, 3>{};
  if (options.part.ends_with(".ply") && is_free)
    if (const auto volume = CCSweep::read_volume<Point>(options.part); volume && volume.value().target != -1)
      return CCSweep::hex_mesh(volume.value(), mesh_parameters(options, progress));
  return CCSweep::hex_mesh(part.value().mesh,
                           parameters_of(options, part.value().patch_ids(), progress).size(sizes(options)));
}

Result<Hex_mesh> mesh_folder(const Options& options, Progress& progress) {
  const auto decomposition = CCSweep::read_volumes<Point>(options.part);
  if (!decomposition) return decomposition.status();
  std::set<int> known;
  for (const auto& volume : decomposition.value().volumes) {
    const auto patch = volume.mesh.property_map<CGAL::SM_Face_index, int>(volume.patch_id_map).first;
    for (auto f : volume.mesh.faces()) known.insert(patch[f]);
  }
  if (Status status = check_sizes(options, known); !status.ok()) return status;
  return CCSweep::hex_mesh(decomposition.value(), mesh_parameters(options, progress));
}

// The middle of a hexahedron.
std::array<double, 3> place_of(const Hex_mesh& mesh, std::size_t hex) {
  std::array<double, 3> middle{};
  for (std::uint32_t n : mesh.hexes[hex])
    for (std::size_t x = 0; x < 3; ++x) middle[x] += mesh.points[n][x] / 8;
  return middle;
}

CCSweep::Report make_report(const CCSweep::Angle_bound& bound) {
  return {{"maximum", bound.scaled_jacobian},
          {"angle", bound.angle},
          {"slope", bound.slope},
          {"place", bound.place},
          {"patch", bound.patch_id}};
}

CCSweep::Report make_report(const Hex_mesh& mesh, const std::vector<double>& qualities, double seconds) {
  double sum = 0;
  for (double q : qualities) sum += q;
  CCSweep::Report report;
  report["status"] = name(Status_code::ok);
  report["hexahedra"] = mesh.hexes.size();
  report["nodes"] = mesh.points.size();
  report["volumes"] = mesh.targets.size();
  report["directions"] = mesh.directions;
  const auto worst = std::min_element(qualities.begin(), qualities.end());
  report["scaled_jacobian"] = {{"minimum", *worst},
                               {"minimum_place", place_of(mesh, static_cast<std::size_t>(worst - qualities.begin()))},
                               {"mean", sum / static_cast<double>(qualities.size())},
                               {"histogram", histogram(qualities)},
                               {"allowed_by_angles", make_report(tightest_bound(mesh))}};
  report["seconds"] = {{name(Stage::hex_mesh), seconds}};
  return report;
}

void print(const CCSweep::Report& report) {
  const auto& quality = report["scaled_jacobian"];
  std::cout << report["hexahedra"] << " hexahedra, " << report["nodes"] << " nodes in " << report["volumes"]
            << " sub-volumes\nscaled Jacobian: minimum " << quality["minimum"] << ", mean " << quality["mean"] << '\n';
  const auto& allowed = quality["allowed_by_angles"];
  if (allowed["patch"] != -1)
    std::cout << "the angles of part and imprint allow " << allowed["maximum"] << " at the worst corner: "
              << allowed["angle"] << " degrees on patch " << allowed["patch"] << ", columns at " << allowed["slope"]
              << " degrees, at " << allowed["place"] << '\n';
  for (std::size_t i = 0; i < bars; ++i)
    std::cout << "  " << i / double(bars) << " to " << (i + 1) / double(bars) << ": " << quality["histogram"][i]
              << '\n';
}

}  // namespace

Status mesh(const Options& options, Progress& progress) {
  const Stopwatch watch;
  const auto result = std::filesystem::is_directory(options.part) ? mesh_folder(options, progress)
                                                                  : mesh_part(options, progress);
  progress.clear();
  if (!result) return result.status();
  const double seconds = watch.seconds();
  const auto version = options.msh_version == "2.2" ? CCSweep::Msh_version::v2_2 : CCSweep::Msh_version::v4_1;
  if (Status status = CCSweep::write_hex_mesh(result.value(), options.files, version); !status.ok()) return status;
  const CCSweep::Report report = make_report(result.value(), CCSweep::scaled_jacobians(result.value()), seconds);
  if (!options.is_quiet) print(report);
  return write_reports(report, options);
}

}  // namespace program
