// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_STATUS_H
#define CCSWEEP_STATUS_H

#include <array>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CCSweep {

/// What became of a call. Every code but `ok` comes with the stage, the patches and the place at fault.
enum class Status_code {
  ok,
  cancelled,                 ///< the visitor asked to stop
  invalid_parameter,         ///< an option is out of range or names a patch that does not exist
  unreadable_file,           ///< missing, truncated, lying counts, or of an unknown format
  write_failed,              ///< the output could not be written
  empty_mesh,                ///< no facets
  missing_patch_ids,         ///< no patch map, and none could be made from the dihedral angles
  non_finite_coordinate,     ///< NaN or infinity
  degenerate_facet,          ///< a facet without area
  not_manifold,              ///< an edge with more than two facets, or a vertex with more than one fan
  not_closed,                ///< a border edge
  not_oriented,              ///< neighbouring facets disagree, or the surface is inside out
  self_intersecting,         ///< facets meet elsewhere than in common vertices and edges
  disjoint_solids,           ///< several solids in one input: they are separate jobs
  not_sweepable,             ///< no axis makes every patch a source, a target or a linking face
  linking_face_not_mappable, ///< a linking face carries no structured mesh
  inconsistent_levels,       ///< two caps are tied to contradictory levels
  chart_not_injective,       ///< a level's caps are no graph over their chart
  projection_folded,         ///< the map between two layers is not orientation preserving
  imprint_failed,            ///< sources and targets of a layer can't be overlaid
  cut_failed,                ///< a curve could not be drawn on the input surface
  sub_volume_not_closed,     ///< the cut surfaces do not separate the sub-volumes
  verification_failed,       ///< a finished result failed the independent check
  hex_mesh_failed,           ///< hexahedra would fold, or a cap can't be meshed at the size asked for
};

/// The stage of the pipeline that a status speaks of, in the order of the paper's outline (section 2).
enum class Stage {
  input,
  part,
  roles,
  linking_mesh,
  layers,
  control_loops,
  loop_faces,
  projection,
  imprint,
  decomposition_sets,
  sub_volumes,
  verification,
  hex_mesh,
  output,
};

/// The outcome of a stage in words a CAD user understands.
struct Status {
  Status_code code = Status_code::ok;
  Stage stage = Stage::input;
  std::vector<int> patches;                    ///< patch ids of the input that are at fault
  std::optional<std::array<double, 3>> place;  ///< a point near the defect, where there is one
  std::string reason;

  bool ok() const { return code == Status_code::ok; }
};

/// The exception of `Result::value()`, for those who prefer exceptions to asking for the status.
class Bad_result : public std::exception {
 public:
  explicit Bad_result(Status status) : status_(std::move(status)) {}
  const Status& status() const { return status_; }
  const char* what() const noexcept override { return status_.reason.c_str(); }

 private:
  Status status_;
};

/// A value, or the status that tells why there is none.
template <class T>
class Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Status failure) : content_(std::move(failure)) {}

  bool ok() const { return content_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// The status; its code is `ok` exactly when there is a value.
  Status status() const { return ok() ? Status{} : std::get<1>(content_); }

  /// The value. Throws `Bad_result` when there is none.
  const T& value() const& { check(); return std::get<0>(content_); }
  T& value() & { check(); return std::get<0>(content_); }
  T&& value() && { check(); return std::get<0>(std::move(content_)); }

 private:
  void check() const {
    if (!ok()) throw Bad_result(std::get<1>(content_));
  }

  std::variant<T, Status> content_;
};

/// The name of a code as it stands in `report.json`.
inline const char* name(Status_code code) {
  switch (code) {
    case Status_code::ok: return "ok";
    case Status_code::cancelled: return "cancelled";
    case Status_code::invalid_parameter: return "invalid_parameter";
    case Status_code::unreadable_file: return "unreadable_file";
    case Status_code::write_failed: return "write_failed";
    case Status_code::empty_mesh: return "empty_mesh";
    case Status_code::missing_patch_ids: return "missing_patch_ids";
    case Status_code::non_finite_coordinate: return "non_finite_coordinate";
    case Status_code::degenerate_facet: return "degenerate_facet";
    case Status_code::not_manifold: return "not_manifold";
    case Status_code::not_closed: return "not_closed";
    case Status_code::not_oriented: return "not_oriented";
    case Status_code::self_intersecting: return "self_intersecting";
    case Status_code::disjoint_solids: return "disjoint_solids";
    case Status_code::not_sweepable: return "not_sweepable";
    case Status_code::linking_face_not_mappable: return "linking_face_not_mappable";
    case Status_code::inconsistent_levels: return "inconsistent_levels";
    case Status_code::chart_not_injective: return "chart_not_injective";
    case Status_code::projection_folded: return "projection_folded";
    case Status_code::imprint_failed: return "imprint_failed";
    case Status_code::cut_failed: return "cut_failed";
    case Status_code::sub_volume_not_closed: return "sub_volume_not_closed";
    case Status_code::verification_failed: return "verification_failed";
    case Status_code::hex_mesh_failed: return "hex_mesh_failed";
  }
  return "unknown";
}

/// The name of a stage as it stands in `report.json`.
inline const char* name(Stage stage) {
  switch (stage) {
    case Stage::input: return "input";
    case Stage::part: return "part";
    case Stage::roles: return "roles";
    case Stage::linking_mesh: return "linking_mesh";
    case Stage::layers: return "layers";
    case Stage::control_loops: return "control_loops";
    case Stage::loop_faces: return "loop_faces";
    case Stage::projection: return "projection";
    case Stage::imprint: return "imprint";
    case Stage::decomposition_sets: return "decomposition_sets";
    case Stage::sub_volumes: return "sub_volumes";
    case Stage::verification: return "verification";
    case Stage::hex_mesh: return "hex_mesh";
    case Stage::output: return "output";
  }
  return "unknown";
}

}  // namespace CCSweep

#endif
