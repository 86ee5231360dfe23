// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_EXAMPLES_CCSWEEP_RUN_H
#define CCSWEEP_EXAMPLES_CCSWEEP_RUN_H

// What the command line program does with a part, for any kernel. Each kernel is compiled by itself, as that is most
// of the program's build time.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/round_to_double.h>
#include <CCSweep/IO/write_layer.h>
#include <CCSweep/IO/write_report.h>
#include <CCSweep/IO/write_volumes.h>
#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>
#include <CCSweep/verify.h>
#include <CCSweep/visitor.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

using CCSweep::Result;
using CCSweep::Role;
using CCSweep::Stage;
using CCSweep::Status;
using CCSweep::Status_code;

struct Options {
  bool inspects = false, meshes = false;  // or decomposes
  std::string part, folder, report, dump;
  std::vector<std::string> files;  // of the hexahedral mesh
  double size = 0;                 // of the hexahedra
  std::map<int, double> patch_sizes;
  std::map<std::pair<int, int>, double> curve_sizes;
  std::string msh_version = "4.1";
  std::array<double, 3> direction{};  // zero: the algorithm chooses
  std::vector<int> sources, targets;  // empty: the algorithm chooses
  double tolerance = 1e-5, spanning_angle = 7.5, angle = 30;
  int layers = 1;
  std::string kernel = "inexact";
  bool is_quiet = false;
};

// Shows the running stage in one line of a terminal. Remembers it for the report of a failure nobody foresaw, and how
// to write the layer that the first attempt drew last, which is the one that failed: later attempts are not told of.
class Progress : public CCSweep::Visitor_base {
 public:
  Progress(bool is_shown, bool keeps_layers) : is_shown_(is_shown), keeps_layers_(keeps_layers) {}

  void begin(Stage stage, std::size_t total) {
    if (stage == Stage::linking_mesh && write_last_layer_) keeps_layers_ = false;
    stage_ = stage;
    total_ = total;
    done_ = 0;
    show();
  }

  void step(Stage) {
    ++done_;
    show();
  }

  void end(Stage) { clear(); }

  void clear() const {
    if (is_shown_) std::fputs("\r\033[K", stderr);
  }

  template <class LayerDrawing>
  void drawn(std::size_t layer, const LayerDrawing& drawing, const std::vector<int>& patch_id) {
    if (!keeps_layers_) return;
    write_last_layer_ = [=](const std::string& folder) {
      return CCSweep::write_layer(layer, drawing, patch_id, folder);
    };
  }

  Status write_last_layer(const std::string& folder) const {
    return write_last_layer_ ? write_last_layer_(folder) : Status{};
  }

  Stage stage() const { return stage_; }

 private:
  void show() const {
    if (!is_shown_) return;
    clear();
    std::fputs(name(stage_), stderr);
    if (total_ > 0) std::fprintf(stderr, " %zu/%zu", done_, total_);
    std::fflush(stderr);
  }

  bool is_shown_, keeps_layers_;
  std::function<Status(const std::string&)> write_last_layer_;
  Stage stage_ = Stage::input;
  std::size_t done_ = 0, total_ = 0;
};

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class PatchMap>
auto parameters_of(const Options& options, PatchMap patches, Progress& progress) {
  return CCSweep::parameters::direction(options.direction)
      .sources(options.sources)
      .targets(options.targets)
      .tolerance(options.tolerance)
      .spanning_angle(options.spanning_angle)
      .layers(options.layers)
      .face_patch_map(patches)
      .visitor(std::ref(progress));
}

// The decomposition in doubles, verified in doubles, whatever the kernel it was made with.
template <class Point>
Result<CCSweep::Decomposition<CCSweep::Double_point>> decompose(const CCSweep::Tagged_mesh<Point>& part,
                                                                const Options& options, Progress& progress) {
  auto result = CCSweep::decompose(part.mesh, parameters_of(options, part.patch_ids(), progress));
  if constexpr (std::is_same_v<Point, CCSweep::Double_point>) {
    return result;
  } else {
    if (!result) return result.status();
    auto rounded = CCSweep::round_to_double(result.value());
    const auto rounded_part = CCSweep::round_to_double(part);
    Status status = CCSweep::verify(rounded_part.mesh, rounded_part.patch_ids(), rounded);
    if (status.ok()) return rounded;
    status.reason = "rounded to the doubles of a file, the exact result does not hold: " + status.reason;
    return status;
  }
}

inline std::string list(const std::vector<int>& ids) {
  std::string text;
  for (int id : ids) text += (text.empty() ? "" : " ") + std::to_string(id);
  return text;
}

inline void print_caps(const std::map<int, Role>& roles, const std::array<double, 3>& direction,
                const std::vector<std::vector<int>>& levels) {
  std::map<Role, std::vector<int>> patches;
  for (const auto& [patch, role] : roles) patches[role].push_back(patch);
  std::cout << "direction  " << direction[0] << ' ' << direction[1] << ' ' << direction[2] << '\n'
            << "targets    " << list(patches[Role::target]) << '\n'
            << "sources    " << list(patches[Role::source]) << '\n'
            << "linking    " << list(patches[Role::linking]) << '\n';
  for (std::size_t i = 0; i < levels.size(); ++i) std::cout << "level " << i << "    " << list(levels[i]) << '\n';
}

inline void print(const CCSweep::Decomposition<CCSweep::Double_point>& result, const std::string& folder) {
  print_caps(result.roles, result.direction, result.levels);
  std::cout << "layers     " << result.layers << '\n';
  for (std::size_t i = 0; i < result.volumes.size(); ++i) {
    const auto& volume = result.volumes[i];
    std::cout << CCSweep::volume_file_name(i) << "  target " << volume.target << ", sources " << list(volume.sources)
              << ", " << volume.mesh.number_of_faces() << " triangles\n";
  }
  std::cout << result.volumes.size() << (result.volumes.size() == 1 ? " sub-volume, " : " sub-volumes, ")
            << result.sets.size() << (result.sets.size() == 1 ? " decomposition set\n" : " decomposition sets\n");
  for (const std::string& note : result.notes) std::cout << "note: " << note << '\n';
  std::cout << "The files are in " << folder << '\n';
}

inline Status write_reports(const CCSweep::Report& report, const Options& options) {
  if (!options.folder.empty())
    if (Status status = CCSweep::write_report(report, options.folder + "/report.json"); !status.ok()) return status;
  return options.report.empty() ? Status{} : CCSweep::write_report(report, options.report);
}

template <class Point>
Status inspect(const CCSweep::Tagged_mesh<Point>& part, const Options& options, Progress& progress) {
  const auto plan = CCSweep::inspect(part.mesh, parameters_of(options, part.patch_ids(), progress));
  progress.clear();
  if (!plan) return plan.status();
  CCSweep::Report report;
  report["status"] = name(Status_code::ok);
  report["direction"] = plan.value().direction;
  report["roles"] = CCSweep::internal::roles_report(plan.value().roles);
  report["levels"] = plan.value().levels;
  if (!options.is_quiet) print_caps(plan.value().roles, plan.value().direction, plan.value().levels);
  return write_reports(report, options);
}

template <class Kernel>
Status run(const Options& options, Progress& progress) {
  const Stopwatch reading;
  const auto part = CCSweep::read_part<typename Kernel::Point_3>(options.part, {true, options.angle});
  if (!part) return part.status();
  const double seconds_of_reading = reading.seconds();
  if (options.inspects) return inspect(part.value(), options, progress);

  auto result = decompose(part.value(), options, progress);
  progress.clear();
  if (!result) return result.status();
  result.value().seconds[name(Stage::input)] += seconds_of_reading;
  const Stopwatch writing;
  if (Status status = CCSweep::write_volumes(result.value(), options.folder); !status.ok()) return status;
  result.value().seconds[name(Stage::output)] += writing.seconds();
  if (Status status = write_reports(CCSweep::make_report(result.value()), options); !status.ok()) return status;
  if (!options.is_quiet) print(result.value(), options.folder);
  return {};
}

}  // namespace program

#endif
