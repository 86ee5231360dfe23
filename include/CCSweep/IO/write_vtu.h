// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_WRITE_VTU_H
#define CCSWEEP_IO_WRITE_VTU_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/IO/internal/encoded_file.h>
#include <CCSweep/Status.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/quality.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace CCSweep {
namespace internal {

// VTK's XML unstructured grid with its arrays in one binary block at the end.
class Vtu_encoder {
 public:
  Vtu_encoder(std::size_t points, std::size_t cells) {
    header_ =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" ";
    header_ += "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" + std::to_string(points);
    header_ += "\" NumberOfCells=\"" + std::to_string(cells) + "\">\n";
  }

  void open(const std::string& section) { header_ += "<" + section + ">\n"; }
  void close(const std::string& section) { header_ += "</" + section + ">\n"; }

  template <class T>
  void array(const std::string& type, const std::string& name, int components, const std::vector<T>& values) {
    header_ += "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
               std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(data_.size()) +
               "\"/>\n";
    append_little_endian(data_, static_cast<std::uint64_t>(values.size() * sizeof(T)));
    for (const T& value : values) append_little_endian(data_, value);
  }

  std::string encode() && {
    header_ += "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
    return std::move(header_) + data_ + "\n</AppendedData>\n</VTKFile>\n";
  }

 private:
  std::string header_, data_;
};

inline std::vector<double> flat(const std::vector<Hex_mesh::Point>& points) {
  std::vector<double> result;
  for (const auto& p : points)
    for (double x : p) result.push_back(x + 0.0);
  return result;
}

// Cells of n nodes each, of one type.
template <std::size_t n>
void encode_cells(Vtu_encoder& vtu, const std::vector<std::array<std::uint32_t, n>>& cells, std::uint8_t type) {
  std::vector<std::int64_t> nodes, offsets;
  for (const auto& cell : cells) {
    nodes.insert(nodes.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<std::int64_t>(nodes.size()));
  }
  vtu.open("Cells");
  vtu.array("Int64", "connectivity", 1, nodes);
  vtu.array("Int64", "offsets", 1, offsets);
  vtu.array("UInt8", "types", 1, std::vector<std::uint8_t>(cells.size(), type));
  vtu.close("Cells");
}

inline void encode_points(Vtu_encoder& vtu, const std::vector<Hex_mesh::Point>& points) {
  vtu.open("Points");
  vtu.array("Float64", "Points", 3, flat(points));
  vtu.close("Points");
}

inline std::string encode_vtu(const Hex_mesh& mesh) {
  constexpr std::uint8_t hexahedron = 12;
  Vtu_encoder vtu(mesh.points.size(), mesh.hexes.size());
  vtu.open("CellData");
  vtu.array("Int32", "volume_id", 1, mesh.volume);
  vtu.array("Float64", "scaled_jacobian", 1, scaled_jacobians(mesh));
  vtu.close("CellData");
  encode_points(vtu, mesh.points);
  encode_cells(vtu, mesh.hexes, hexahedron);
  return std::move(vtu).encode();
}

// The quads on the boundary with the nodes they use.
inline std::string encode_boundary_vtu(const Hex_mesh& mesh) {
  constexpr std::uint8_t quad = 9;
  std::vector<std::uint32_t> number(mesh.points.size(), std::uint32_t(-1));
  std::vector<Hex_mesh::Point> points;
  std::vector<std::array<std::uint32_t, 4>> quads;
  std::vector<std::int32_t> patch, role, volume;
  for (const auto& q : mesh.boundary) {
    auto& nodes = quads.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      auto& n = number[q.nodes[i]];
      if (n == std::uint32_t(-1)) {
        n = static_cast<std::uint32_t>(points.size());
        points.push_back(mesh.points[q.nodes[i]]);
      }
      nodes[i] = n;
    }
    patch.push_back(q.patch_id);
    role.push_back(static_cast<std::int32_t>(q.role));
    volume.push_back(q.volume);
  }
  Vtu_encoder vtu(points.size(), quads.size());
  vtu.open("CellData");
  vtu.array("Int32", "patch_id", 1, patch);
  vtu.array("Int32", "role", 1, role);
  vtu.array("Int32", "volume_id", 1, volume);
  vtu.close("CellData");
  encode_points(vtu, points);
  encode_cells(vtu, quads, quad);
  return std::move(vtu).encode();
}

inline Encoded_file encoded_vtu(const Hex_mesh& mesh, const std::filesystem::path& file) {
  return {file, {{file.filename().string(), encode_vtu(mesh)},
                 {file.stem().string() + "_boundary.vtu", encode_boundary_vtu(mesh)}}};
}

}  // namespace internal

/// Writes a mesh as VTK's XML unstructured grid, with the cell data `volume_id` and `scaled_jacobian`; and beside it,
/// as NAME_boundary.vtu, the quads of its boundary with the cell data `patch_id`, `role` and `volume_id`.
/// \return `write_failed` where that is not possible; no half-written file is left then.
inline Status write_vtu(const Hex_mesh& mesh, const std::string& file) {
  return internal::write_encoded({internal::encoded_vtu(mesh, file)});
}

}  // namespace CCSweep

#endif
