// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_WRITE_VOLUMES_H
#define CCSWEEP_IO_WRITE_VOLUMES_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/IO/internal/staged_files.h>
#include <CCSweep/IO/internal/vtp_array.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/volumes/Decomposition.h>
#include <CGAL/boost/graph/iterator.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CCSweep {

/// The name of the file of a sub-volume: `volume_000.ply`, `volume_001.ply`, ...
inline std::string volume_file_name(std::size_t i) {
  std::string number = std::to_string(i);
  number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
  return "volume_" + number + ".ply";
}

namespace internal {

// The sub-volume whose file has that name, if it is one of ours.
inline std::optional<std::size_t> volume_of_file(const std::string& name) {
  constexpr std::string_view prefix = "volume_";
  std::size_t i = 0;
  if (name.size() <= prefix.size()) return std::nullopt;
  const auto error = std::from_chars(name.data() + prefix.size(), name.data() + name.size(), i).ec;
  if (error != std::errc() || name != volume_file_name(i)) return std::nullopt;
  return i;
}

inline void remove_volume_files(const std::filesystem::path& folder, std::size_t first) {
  std::error_code error;
  std::vector<std::filesystem::path> stale;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const auto i = volume_of_file(it->path().filename().string());
    if (i && *i >= first && it->is_regular_file(error)) stale.push_back(it->path());
  }
  for (const auto& path : stale)
    if (!std::filesystem::remove(path, error))
      fail(Status_code::write_failed, Stage::output, "can't remove " + path.string() + " of an earlier run");
}

template <class Mesh>
auto int_map(const Mesh& mesh, const char* name) {
  const auto [map, found] = mesh.template property_map<typename Mesh::Face_index, int>(name);
  if (!found)
    fail(Status_code::invalid_parameter, Stage::output, std::string("a sub-volume has no face property ") + name);
  return map;
}

// Numbers the vertices from 0, also where the mesh has holes of removed ones.
template <class Mesh>
std::vector<std::uint32_t> vertex_numbers(const Mesh& mesh) {
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices());
  std::uint32_t next = 0;
  for (auto v : mesh.vertices()) number[v] = next++;
  return number;
}

template <class Point>
std::string encode_ply(const Sub_volume<Point>& volume) {
  const auto& mesh = volume.mesh;
  const auto patch = int_map(mesh, Sub_volume<Point>::patch_id_map), role = int_map(mesh, Sub_volume<Point>::role_map);
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  out += std::to_string(mesh.number_of_vertices());
  out += "\nproperty double x\nproperty double y\nproperty double z\nelement face ";
  out += std::to_string(mesh.number_of_faces());
  out += "\nproperty list uchar int vertex_indices\nproperty int patch_id\nproperty int role\nend_header\n";
  for (auto v : mesh.vertices())
    for (double x : file_point(mesh.point(v))) append_little_endian(out, x);
  const auto number = vertex_numbers(mesh);
  for (auto f : mesh.faces()) {
    append_little_endian(out, std::uint8_t{3});
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      append_little_endian(out, static_cast<std::int32_t>(number[v]));
    append_little_endian(out, static_cast<std::int32_t>(patch[f]));
    append_little_endian(out, static_cast<std::int32_t>(role[f]));
  }
  return out;
}

// VTK's XML PolyData, in text: all sub-volumes one after the other, with cell data.
template <class Point>
class Vtp_encoder {
 public:
  explicit Vtp_encoder(const Decomposition<Point>& decomposition) {
    for (std::size_t i = 0; i < decomposition.volumes.size(); ++i) add(decomposition.volumes[i], i);
  }

  std::string encode() const {
    std::string out = vtp_head("NumberOfPoints=\"" + std::to_string(number_of_points_) +
                               "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
                               std::to_string(number_of_cells_) + "\"");
    out += "<CellData Scalars=\"volume\">\n";
    out += vtp_array("Int32", "volume", volume_) + vtp_array("Int32", "patch_id", patch_);
    out += vtp_array("Int32", "role", role_);
    out += "</CellData>\n<Points>\n" + vtp_array("Float64", "Points", points_, " NumberOfComponents=\"3\"");
    out += "</Points>\n<Polys>\n" + vtp_array("Int32", "connectivity", corners_);
    out += vtp_array("Int32", "offsets", offsets_);
    return out + "</Polys>\n" + vtp_tail();
  }

 private:
  void add(const Sub_volume<Point>& volume, std::size_t index) {
    const auto& mesh = volume.mesh;
    const auto patch = int_map(mesh, Sub_volume<Point>::patch_id_map),
               role = int_map(mesh, Sub_volume<Point>::role_map);
    for (auto v : mesh.vertices()) {
      for (double x : file_point(mesh.point(v))) put(points_, x, ' ');
      points_.back() = '\n';
    }
    const auto number = vertex_numbers(mesh);
    for (auto f : mesh.faces()) {
      for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        put(corners_, number_of_points_ + number[v], ' ');
      corners_.back() = '\n';
      put(offsets_, 3 * ++number_of_cells_, '\n');
      put(volume_, index, '\n');
      put(patch_, patch[f], '\n');
      put(role_, role[f], '\n');
    }
    number_of_points_ += mesh.number_of_vertices();
  }

  template <class T>
  static void put(std::string& out, T value, char separator) {
    append_text(out, value);
    out += separator;
  }

  std::string points_, corners_, offsets_, volume_, patch_, role_;
  std::size_t number_of_points_ = 0, number_of_cells_ = 0;
};

inline constexpr const char* vtp_file_name = "decomposition.vtp";

}  // namespace internal

/// Writes the sub-volumes of a decomposition into a folder, which is made if need be:
/// - `volume_000.ply`, `volume_001.ply`, ...: binary little endian PLY, double coordinates, the face properties
///   `int patch_id` and `int role` (see `Role`);
/// - `decomposition.vtp`: all of them in one VTK PolyData file with the cell data `volume`, `patch_id` and `role`.
///
/// Files of these names are replaced, and `volume_NNN.ply` of an earlier result with more sub-volumes are removed;
/// no other file is touched. The files get their names only after all of them have been written. Coordinates of an
/// exact kernel are rounded, equal ones to equal doubles: what is promised of the result has to be verified again for
/// the rounded one, see `round_to_double()`.
///
/// Returns `Status_code::write_failed` with the path when a file can't be written.
template <class Point>
Status write_volumes(const Decomposition<Point>& decomposition, const std::string& folder) {
  return internal::guarded([&] {
           internal::Staged_files files(folder);
           for (std::size_t i = 0; i < decomposition.volumes.size(); ++i)
             files.add(volume_file_name(i), internal::encode_ply(decomposition.volumes[i]));
           files.add(internal::vtp_file_name, internal::Vtp_encoder<Point>(decomposition).encode());
           files.commit();
           internal::remove_volume_files(folder, decomposition.volumes.size());
           return true;
         })
      .status();
}

/// Removes what `write_volumes()` wrote into a folder before, so that nobody takes it for the result of a later run
/// that failed. A folder that does not exist is left so.
///
/// Returns `Status_code::write_failed` with the path when a file can't be removed.
inline Status remove_volumes(const std::string& folder) {
  return internal::guarded([&] {
           internal::remove_volume_files(folder, 0);
           std::error_code error;
           std::filesystem::remove(std::filesystem::path(folder) / internal::vtp_file_name, error);
           return true;
         })
      .status();
}

}  // namespace CCSweep

#endif
