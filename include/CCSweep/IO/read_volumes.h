// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_READ_VOLUMES_H
#define CCSWEEP_IO_READ_VOLUMES_H

#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/read_ply.h>
#include <CCSweep/IO/write_volumes.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/volumes/Decomposition.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace CCSweep {

/// Reads a sub-volume that `write_volumes()` wrote. Files of parts, which have no roles, give one without target.
/// \return the codes of `read_part()`
template <class Point>
Result<Sub_volume<Point>> read_volume(const std::string& path) {
  return internal::guarded([&] {
    using Volume = Sub_volume<Point>;
    using Face = typename Volume::Mesh::Face_index;
    const Polygon_soup soup = internal::take(read_ply(path), path);
    internal::require(check_soup(soup), path);
    Tagged_mesh<Point> part = internal::make_mesh<Point>(soup);
    Volume volume;
    volume.mesh = std::move(part.mesh);
    auto role = volume.mesh.template add_property_map<Face, int>(Volume::role_map, 0).first;
    if (soup.roles.empty()) return volume;
    for (std::size_t f = 0; f < soup.number_of_polygons(); ++f) {
      role[Face(static_cast<typename Face::size_type>(f))] = soup.roles[f];
      if (soup.roles[f] == static_cast<int>(Role::target)) volume.target = soup.patch_ids[f];
      if (soup.roles[f] == static_cast<int>(Role::source)) volume.sources.push_back(soup.patch_ids[f]);
    }
    std::sort(volume.sources.begin(), volume.sources.end());
    volume.sources.erase(std::unique(volume.sources.begin(), volume.sources.end()), volume.sources.end());
    return volume;
  });
}

/// Reads the sub-volumes of a folder that `ccsweep decompose` wrote, with the direction and the roles of its report.
/// \return `unreadable_file` where the report or a sub-volume is missing; the codes of `read_part()`
template <class Point>
Result<Decomposition<Point>> read_volumes(const std::string& folder) {
  return internal::guarded([&] {
    const std::string path = (std::filesystem::path(folder) / "report.json").string();
    Decomposition<Point> result;
    try {
      std::ifstream in(path);
      const auto report = nlohmann::json::parse(in);
      result.direction = report.at("direction").template get<std::array<double, 3>>();
      for (const auto& [patch, role] : report.at("roles").items())
        for (Role r : {Role::linking, Role::source, Role::target})
          if (role.template get<std::string>() == name(r)) result.roles[std::stoi(patch)] = r;
      for (std::size_t i = 0; i < report.at("volumes").size(); ++i)
        result.volumes.push_back(internal::value_or_fail(
            read_volume<Point>((std::filesystem::path(folder) / volume_file_name(i)).string())));
    } catch (const std::exception& error) {
      internal::fail(Status_code::unreadable_file, Stage::input,
                     path + ": no report of a decomposition: " + error.what());
    }
    return result;
  });
}

}  // namespace CCSweep

#endif
