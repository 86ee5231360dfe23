// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_DECOMPOSITION_H
#define CCSWEEP_VOLUMES_DECOMPOSITION_H

#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CCSweep {

/// What a face is to the sweep. The numbers are those of the face property `role` in files.
enum class Role : int { linking = 0, source = 1, target = 2, cut = 3 };

inline const char* name(Role role) {
  switch (role) {
    case Role::linking: return "linking";
    case Role::source: return "source";
    case Role::target: return "target";
    case Role::cut: return "cut";
  }
  return "unknown";
}

/// One many-to-one sweepable sub-volume (section 2.8): a closed, outward oriented triangle mesh whose faces carry
/// the id of the input patch they lie on, or of the cut, and their role.
template <class Point>
struct Sub_volume {
  using Mesh = CGAL::Surface_mesh<Point>;
  static constexpr const char* patch_id_map = "f:patch_id";  ///< face property of type int
  static constexpr const char* role_map = "f:role";          ///< face property of type int, a `Role`

  Mesh mesh;
  int target = -1;           ///< id of its one target patch
  std::vector<int> sources;  ///< ids of its source patches, ascending
};

/// One decomposition set (section 2.8): the cut that follows from one LoopEdge between two sub-volumes.
struct Decomposition_set {
  int id = -1;                  ///< the patch id its triangles carry in both sub-volumes
  std::array<int, 2> volumes{}; ///< indices into `Decomposition::volumes`, ascending
  std::size_t triangles = 0;
};

/// The result of `decompose()`.
template <class Point>
struct Decomposition {
  std::vector<Sub_volume<Point>> volumes;    ///< ascending by target patch id
  std::vector<Decomposition_set> sets;       ///< ascending by id
  std::map<int, Role> roles;                 ///< role of each input patch
  std::array<double, 3> direction{};         ///< unit vector from targets to sources, at the targets
  std::vector<std::vector<int>> levels;      ///< the caps (patch ids) of each level, from the lowest
  std::size_t layers = 0;                    ///< number of layers, levels included
  std::vector<double> sweep_parameters;      ///< value of the sweep parameter of each layer, ascending
  double tolerance = 0;                      ///< absolute tolerance of the imprint
  std::vector<std::string> notes;            ///< what a user should know: candidates tried, faces merged away
  std::map<std::string, double> seconds;     ///< wall-clock time by stage
};

}  // namespace CCSweep

#endif
