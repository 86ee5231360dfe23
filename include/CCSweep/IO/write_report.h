// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_WRITE_REPORT_H
#define CCSWEEP_IO_WRITE_REPORT_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/IO/internal/staged_files.h>
#include <CCSweep/IO/write_volumes.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/volumes/Decomposition.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace CCSweep {

/// A report, its members in the order they were added.
using Report = nlohmann::ordered_json;

namespace internal {

template <class Point>
std::set<int> patches_of(const Sub_volume<Point>& volume) {
  const auto patch = int_map(volume.mesh, Sub_volume<Point>::patch_id_map);
  std::set<int> ids;
  for (auto f : volume.mesh.faces()) ids.insert(patch[f]);
  return ids;
}

// The volume within a mesh, summed from one of its vertices, so that its distance from the origin does not matter.
template <class Mesh>
double size_of_volume(const Mesh& mesh) {
  std::array<double, 3> origin{};
  if (mesh.number_of_vertices() > 0) origin = file_point(mesh.point(*mesh.vertices().begin()));
  double sum = 0;
  for (auto f : mesh.faces()) {
    std::array<std::array<double, 3>, 3> p{};
    std::size_t i = 0;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh)) {
      p[i] = file_point(mesh.point(v));
      for (std::size_t k = 0; k < 3; ++k) p[i][k] -= origin[k];
      ++i;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
      sum += p[0][k] * (p[1][x] * p[2][y] - p[1][y] * p[2][x]);
    }
  }
  return sum / 6;
}

// The diagonal of the box around all sub-volumes, which is that of the part.
template <class Point>
double diagonal(const Decomposition<Point>& decomposition) {
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const auto& volume : decomposition.volumes)
    for (auto v : volume.mesh.vertices()) {
      const auto p = file_point(volume.mesh.point(v));
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    }
  return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

inline Report roles_report(const std::map<int, Role>& roles) {
  Report report = Report::object();
  for (const auto& [patch, role] : roles) report[std::to_string(patch)] = name(role);
  return report;
}

}  // namespace internal

/// What `report.json` tells of a decomposition: `status`, `direction`, `roles`, `levels`, `layers`,
/// `sweep_parameters`, `volumes`, `decomposition_sets`, `tolerance` (absolute) and `relative_tolerance`, `notes`, and
/// `seconds` by stage.
template <class Point>
Report make_report(const Decomposition<Point>& decomposition) {
  Report report;
  report["status"] = name(Status_code::ok);
  report["direction"] = decomposition.direction;
  report["roles"] = internal::roles_report(decomposition.roles);
  report["levels"] = decomposition.levels;
  report["layers"] = decomposition.layers;
  report["sweep_parameters"] = decomposition.sweep_parameters;
  report["volumes"] = Report::array();
  for (std::size_t i = 0; i < decomposition.volumes.size(); ++i) {
    const auto& volume = decomposition.volumes[i];
    Report entry;
    entry["file"] = volume_file_name(i);
    entry["target"] = volume.target;
    entry["sources"] = volume.sources;
    entry["volume"] = internal::size_of_volume(volume.mesh);
    entry["patches"] = internal::patches_of(volume);
    report["volumes"].push_back(std::move(entry));
  }
  report["decomposition_sets"] = Report::array();
  for (const Decomposition_set& set : decomposition.sets) {
    Report entry;
    entry["id"] = set.id;
    entry["volumes"] = set.volumes;
    entry["triangles"] = set.triangles;
    report["decomposition_sets"].push_back(std::move(entry));
  }
  report["tolerance"] = decomposition.tolerance;
  report["relative_tolerance"] = decomposition.tolerance / internal::diagonal(decomposition);
  report["notes"] = decomposition.notes;
  report["seconds"] = decomposition.seconds;
  return report;
}

/// What `report.json` tells of a failure: `status`, `stage`, `patches`, `reason` and `place` (null if there is none).
inline Report make_report(const Status& status) {
  Report report;
  report["status"] = name(status.code);
  report["stage"] = name(status.stage);
  report["patches"] = status.patches;
  report["reason"] = status.reason;
  report["place"] = status.place ? Report(*status.place) : Report();
  return report;
}

/// Writes a report to a file; its folder is made if need be. Returns `Status_code::write_failed` on failure.
inline Status write_report(const Report& report, const std::string& path) {
  return internal::guarded([&] {
           std::error_code error;
           const std::filesystem::path file = std::filesystem::absolute(path, error);
           internal::Staged_files files(file.parent_path());
           // File names need not be UTF-8, but JSON is.
           files.add(file.filename().string(), report.dump(2, ' ', false, Report::error_handler_t::replace) + "\n");
           files.commit();
           return true;
         })
      .status();
}

}  // namespace CCSweep

#endif
