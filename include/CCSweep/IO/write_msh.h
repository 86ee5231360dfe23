// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_WRITE_MSH_H
#define CCSWEEP_IO_WRITE_MSH_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/IO/internal/encoded_file.h>
#include <CCSweep/Status.h>
#include <CCSweep/hex/Hex_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace CCSweep {

/// The versions of Gmsh's format.
enum class Msh_version { v2_2, v4_1 };

namespace internal {

// Gmsh's text format. Tags there are positive, patch ids need not be: groups are numbered from 1 and named after ids.
class Msh_encoder {
 public:
  explicit Msh_encoder(const Hex_mesh& mesh) : mesh_(mesh), hexes_of_(mesh.targets.size()) {
    for (const auto& quad : mesh.boundary) quads_of_[quad.patch_id].push_back(&quad);
    for (std::size_t h = 0; h < mesh.hexes.size(); ++h) hexes_of_[mesh.volume[h]].push_back(h);
  }

  std::string encode_4_1() {
    out_ = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    add_names();
    add_entities();
    add_nodes_4_1();
    const std::size_t blocks = quads_of_.size() + hexes_of_.size(), count = number_of_elements();
    out_ += "$Elements\n";
    add_line(blocks, count, 1, count);
    std::size_t tag = 0, group = 0;
    for (const auto& [patch, quads] : quads_of_) {
      add_line(2, ++group, quad_type, quads.size());
      for (const auto* quad : quads) add_element(quad->nodes, ++tag);
    }
    for (std::size_t v = 0; v < hexes_of_.size(); ++v) {
      add_line(3, v + 1, hex_type, hexes_of_[v].size());
      for (std::size_t h : hexes_of_[v]) add_element(mesh_.hexes[h], ++tag);
    }
    return std::move(out_) + "$EndElements\n";
  }

  std::string encode_2_2() {
    out_ = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    add_names();
    out_ += "$Nodes\n";
    add_line(mesh_.points.size());
    for (std::size_t n = 0; n < mesh_.points.size(); ++n) {
      append_text(out_, n + 1);
      add_coordinates(n);
    }
    out_ += "$EndNodes\n$Elements\n";
    add_line(number_of_elements());
    std::size_t tag = 0, group = 0;
    for (const auto& [patch, quads] : quads_of_) {
      ++group;
      for (const auto* quad : quads) add_element(quad->nodes, ++tag, quad_type, std::size_t{2}, group, group);
    }
    for (std::size_t v = 0; v < hexes_of_.size(); ++v)
      for (std::size_t h : hexes_of_[v]) add_element(mesh_.hexes[h], ++tag, hex_type, std::size_t{2}, v + 1, v + 1);
    return std::move(out_) + "$EndElements\n";
  }

 private:
  static constexpr std::size_t quad_type = 3, hex_type = 5;

  std::size_t number_of_elements() const { return mesh_.boundary.size() + mesh_.hexes.size(); }

  template <class... T>
  void add_line(T... values) {
    ((append_text(out_, values), out_ += ' '), ...);
    out_.back() = '\n';
  }

  template <std::size_t n, class... T>
  void add_element(const std::array<std::uint32_t, n>& nodes, T... before) {
    ((append_text(out_, before), out_ += ' '), ...);
    for (std::uint32_t node : nodes) {
      append_text(out_, node + 1);
      out_ += ' ';
    }
    out_.back() = '\n';
  }

  void add_coordinates(std::size_t n) {
    for (double x : mesh_.points[n]) {
      out_ += ' ';
      append_text(out_, x + 0.0);
    }
    out_ += '\n';
  }

  void add_names() {
    out_ += "$PhysicalNames\n";
    add_line(quads_of_.size() + hexes_of_.size());
    std::size_t group = 0;
    for (const auto& [patch, quads] : quads_of_)
      out_ += "2 " + std::to_string(++group) + " \"patch_" + std::to_string(patch) + "\"\n";
    for (std::size_t v = 0; v < hexes_of_.size(); ++v)
      out_ += "3 " + std::to_string(v + 1) + " \"volume_" + std::to_string(v) + "\"\n";
    out_ += "$EndPhysicalNames\n";
  }

  // All entities get the box of the whole, which Gmsh does not look at.
  void add_entities() {
    std::string box;
    for (bool high : {false, true})
      for (std::size_t x = 0; x < 3; ++x) {
        double end = mesh_.points.empty() ? 0 : mesh_.points[0][x];
        for (const auto& p : mesh_.points) end = high ? std::max(end, p[x]) : std::min(end, p[x]);
        append_text(box, end + 0.0);
        box += ' ';
      }
    out_ += "$Entities\n";
    add_line(0, 0, quads_of_.size(), hexes_of_.size());
    for (std::size_t group = 1; group <= quads_of_.size() + hexes_of_.size(); ++group) {
      const std::size_t tag = group <= quads_of_.size() ? group : group - quads_of_.size();
      out_ += std::to_string(tag) + ' ' + box + "1 " + std::to_string(tag) + " 0\n";
    }
    out_ += "$EndEntities\n";
  }

  void add_nodes_4_1() {
    const std::size_t n = mesh_.points.size();
    out_ += "$Nodes\n";
    add_line(1, n, 1, n);
    add_line(3, 1, 0, n);
    for (std::size_t i = 1; i <= n; ++i) add_line(i);
    for (std::size_t i = 0; i < n; ++i) {
      add_coordinates(i);
    }
    out_ += "$EndNodes\n";
  }

  const Hex_mesh& mesh_;
  std::map<int, std::vector<const Hex_mesh::Boundary_quad*>> quads_of_;  // by patch id
  std::vector<std::vector<std::size_t>> hexes_of_;                       // by sub-volume
  std::string out_;
};

inline Encoded_file encoded_msh(const Hex_mesh& mesh, const std::filesystem::path& file, Msh_version version) {
  Msh_encoder encoder(mesh);
  return {file, {{file.filename().string(),
                  version == Msh_version::v4_1 ? encoder.encode_4_1() : encoder.encode_2_2()}}};
}

}  // namespace internal

/// Writes a mesh in Gmsh's text format, with a physical group for each sub-volume and each patch.
/// \return `write_failed` where that is not possible; no half-written file is left then.
inline Status write_msh(const Hex_mesh& mesh, const std::string& file, Msh_version version = Msh_version::v4_1) {
  return internal::write_encoded({internal::encoded_msh(mesh, file, version)});
}

}  // namespace CCSweep

#endif
