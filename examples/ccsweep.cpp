// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The command line program: reads a part, decomposes it, writes the sub-volumes and a report; or meshes it.
#include "ccsweep_run.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <exception>
#include <limits>

#ifndef CCSWEEP_VERSION
#define CCSWEEP_VERSION "unknown"
#endif

using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Inexact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
extern template CCSweep::Status program::run<Exact_kernel>(const program::Options&, program::Progress&);
namespace program {
CCSweep::Status mesh(const Options& options, Progress& progress);
}

namespace {

using namespace program;

int exit_status(Status_code code) {
  switch (code) {
    case Status_code::ok:
      return 0;
    case Status_code::invalid_parameter:
      return 2;
    case Status_code::unreadable_file:
    case Status_code::write_failed:
    case Status_code::empty_mesh:
    case Status_code::missing_patch_ids:
    case Status_code::non_finite_coordinate:
    case Status_code::degenerate_facet:
    case Status_code::not_manifold:
    case Status_code::not_closed:
    case Status_code::not_oriented:
    case Status_code::self_intersecting:
    case Status_code::disjoint_solids:
      return 3;
    case Status_code::not_sweepable:
    case Status_code::linking_face_not_mappable:
    case Status_code::inconsistent_levels:
      return 4;
    case Status_code::cancelled:
    case Status_code::chart_not_injective:
    case Status_code::projection_folded:
    case Status_code::imprint_failed:
    case Status_code::cut_failed:
    case Status_code::sub_volume_not_closed:
    case Status_code::verification_failed:
    case Status_code::hex_mesh_failed:
      return 5;
  }
  return 5;
}

// What nobody foresaw is a failure like any other: it has a stage and a report.
Status run_guarded(const Options& options, Progress& progress) {
  try {
    if (options.meshes) return mesh(options, progress);
    if (options.kernel == "exact") return run<Exact_kernel>(options, progress);
    return run<Inexact_kernel>(options, progress);
  } catch (const std::exception& error) {
    progress.clear();
    return {Status_code::verification_failed, progress.stage(), {}, {}, std::string("unexpected: ") + error.what()};
  }
}

// Tells of a failure on stderr and in the reports. Where an earlier run left a result in the folder, that goes: the
// report no longer speaks of it.
int finish(const Status& status, const Options& options, const Progress& progress) {
  const int exit = exit_status(status.code);
  if (exit == 0) return exit;
  std::cerr << "ccsweep: " << name(status.code) << ": " << status.reason;
  if (!status.patches.empty()) std::cerr << " (patches " << list(status.patches) << ')';
  if (status.place) {
    const auto& [x, y, z] = *status.place;
    std::cerr << " near (" << x << ", " << y << ", " << z << ')';
  }
  std::cerr << '\n';
  if (exit == 2) return exit;
  if (!options.folder.empty())
    if (const Status removed = CCSweep::remove_volumes(options.folder); !removed.ok())
      std::cerr << "ccsweep: " << removed.reason << '\n';
  if (const Status written = write_reports(CCSweep::make_report(status), options); !written.ok())
    std::cerr << "ccsweep: " << written.reason << '\n';
  if (!options.dump.empty())
    if (const Status written = progress.write_last_layer(options.dump); !written.ok())
      std::cerr << "ccsweep: " << written.reason << '\n';
  return exit;
}

template <class T>
std::vector<T> parse_list(const std::string& text) {
  std::vector<T> values;
  for (const std::string& item : CLI::detail::split(text, ',')) {
    T value{};
    if (item.empty() || !CLI::detail::lexical_cast(item, value))
      throw CLI::ValidationError("'" + text + "' is no list of numbers with commas between");
    values.push_back(value);
  }
  return values;
}

std::array<double, 3> parse_direction(const std::string& text) {
  const std::vector<double> values = parse_list<double>(text);
  double size = 0;
  for (double value : values) size = std::hypot(size, value);
  if (values.size() != 3 || !std::isfinite(size) || size == 0)
    throw CLI::ValidationError("--direction takes three numbers x,y,z that are not all 0");
  return {values[0], values[1], values[2]};
}

// The size on a patch, or on the curves between two.
void add_size(const std::string& text, Options& options) {
  const std::size_t equals = text.find('=');
  const std::vector<int> patches = parse_list<int>(text.substr(0, equals));
  double size = 0;
  if (equals == std::string::npos || patches.size() > 2 || !CLI::detail::lexical_cast(text.substr(equals + 1), size) ||
      !std::isfinite(size) || !(size > 0))
    throw CLI::ValidationError("--size-on takes ID=H or ID,ID=H with a number H above 0, not '" + text + "'");
  if (patches.size() == 1)
    options.patch_sizes[patches[0]] = size;
  else
    options.curve_sizes[{patches[0], patches[1]}] = size;
}

// Not CLI::Range, which lets NaN pass.
CLI::Validator between(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double value = 0;
        const bool fits = CLI::detail::lexical_cast(text, value) && value > low && value <= high;
        return fits ? std::string()
                    : text + " is not a number above " + CLI::detail::to_string(low) + " and up to " +
                          CLI::detail::to_string(high);
      },
      "");
}

void add_options(CLI::App& command, Options& options) {
  command.add_option("PART", options.part, "the part: .ply with the face property patch_id, or .ply, .off, .stl")
      ->required();
  command.add_option_function<std::string>(
      "--direction", [&](const std::string& text) { options.direction = parse_direction(text); },
      "x,y,z: the sense of the sweep at the targets, from targets to sources");
  command.add_option_function<std::string>(
      "--sources", [&](const std::string& text) { options.sources = parse_list<int>(text); },
      "patch ids of all sources, with commas between");
  command.add_option_function<std::string>(
      "--targets", [&](const std::string& text) { options.targets = parse_list<int>(text); },
      "patch ids of all targets, with commas between");
  command.add_option("--tolerance", options.tolerance, "merging distance, relative to the size of the part")
      ->check(between(0, 1))
      ->capture_default_str();
  command
      .add_option("--spanning-angle", options.spanning_angle,
                  "how far a bent sweep may turn from layer to layer, degrees")
      ->check(between(0, 180))
      ->capture_default_str();
  command.add_option("--layers", options.layers, "at least so many layers")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      .add_option("--angle", options.angle, "patches of a part without patch ids end where it turns by more, degrees")
      ->check(between(0, 179))
      ->capture_default_str();
  command.add_option("--dump", options.dump, "on failure, draw the layer that failed in this folder (SVG and VTP)");
  command.add_option("--report", options.report, "write a report in JSON to this file");
  command.add_flag("--quiet", options.is_quiet, "print nothing but the reason of a failure");
}

void add_kernel_option(CLI::App& command, Options& options) {
  command.add_option("--kernel", options.kernel, "arithmetic of constructed points: inexact or exact")
      ->check(CLI::IsMember({"inexact", "exact"}))
      ->capture_default_str();
}

void add_mesh_options(CLI::App& command, Options& options) {
  const CLI::Validator mesh_file(
      [](const std::string& file) {
        for (const char* kind : {".vtu", ".msh", ".inp"})
          if (file.ends_with(kind)) return std::string();
        return file + " ends with none of .vtu, .msh, .inp";
      },
      "");
  command.add_option("--size", options.size, "edge length of the hexahedra")
      ->required()
      ->check(between(0, std::numeric_limits<double>::max()));
  command.add_option_function<std::vector<std::string>>(
      "--size-on",
      [&](const std::vector<std::string>& texts) {
        for (const auto& text : texts) add_size(text, options);
      },
      "ID=H or ID,ID=H: the edge length on a patch, or on the curves between two; may be given several times");
  command.add_option("--out", options.files, "file of the mesh: .vtu, .msh or .inp; may be given several times")
      ->required()
      ->check(mesh_file);
  command.add_option("--msh-version", options.msh_version, "version of Gmsh's format")
      ->check(CLI::IsMember({"4.1", "2.2"}))
      ->capture_default_str();
}

}  // namespace

int main(int argc, char* argv[]) {
  Options options;
  CLI::App app("Decomposes a multi-sweep part into sub-volumes that a many-to-one sweeper can mesh.", "ccsweep");
  app.set_version_flag("--version", std::string("ccsweep " CCSWEEP_VERSION));
  app.require_subcommand(1);
  app.footer("Exit status: 0 done, 2 wrong use, 3 unreadable or invalid input, 4 not sweepable, 5 gave up.");
  CLI::App* inspect_command =
      app.add_subcommand("inspect", "Show the roles and levels of a part's patches, or why it can't be swept");
  add_options(*inspect_command, options);
  add_kernel_option(*inspect_command, options);
  CLI::App* decompose_command = app.add_subcommand("decompose", "Write the sub-volumes of a part and a report");
  add_options(*decompose_command, options);
  add_kernel_option(*decompose_command, options);
  decompose_command->add_option("--out", options.folder, "folder for volume_NNN.ply, decomposition.vtp and report.json")
      ->required();
  CLI::App* mesh_command = app.add_subcommand(
      "mesh", "Write a conformal hexahedral mesh of a part, of a decomposition's folder or of one volume_NNN.ply");
  add_options(*mesh_command, options);
  add_mesh_options(*mesh_command, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  options.inspects = inspect_command->parsed();
  options.meshes = mesh_command->parsed();
  Progress progress(!options.is_quiet && isatty(STDERR_FILENO) == 1, !options.dump.empty());
  return finish(run_guarded(options, progress), options, progress);
}
