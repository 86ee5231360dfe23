// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_WRITE_INP_H
#define CCSWEEP_IO_WRITE_INP_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/IO/internal/encoded_file.h>
#include <CCSweep/Status.h>
#include <CCSweep/hex/Hex_mesh.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

// Abaqus numbers the faces of a C3D8 so.
inline constexpr int abaqus_faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                           {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};

// By patch id: hexahedron and number of the face (from 1) of each quad on it.
inline std::map<int, std::vector<std::pair<std::size_t, int>>> faces_on_patches(const Hex_mesh& mesh) {
  using Key = std::array<std::uint32_t, 4>;
  std::map<Key, int> patch_of;
  for (const auto& quad : mesh.boundary) {
    Key key = quad.nodes;
    std::sort(key.begin(), key.end());
    patch_of[key] = quad.patch_id;
  }
  std::map<int, std::vector<std::pair<std::size_t, int>>> result;
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h)
    for (int f = 0; f < 6; ++f) {
      Key key;
      for (int i = 0; i < 4; ++i) key[i] = mesh.hexes[h][abaqus_faces[f][i]];
      std::sort(key.begin(), key.end());
      if (const auto found = patch_of.find(key); found != patch_of.end()) result[found->second].push_back({h, f + 1});
    }
  return result;
}

// A number in no more than the 20 characters that the format allows.
inline void append_number(std::string& out, double x) {
  constexpr std::size_t most = 20;
  constexpr int digits = 13;
  const std::size_t before = out.size();
  append_text(out, x);
  if (out.size() - before <= most) return;
  out.resize(before);
  char text[2 * most];
  out.append(text, std::to_chars(text, text + sizeof text, x, std::chars_format::general, digits).ptr);
}

inline std::string encode_inp(const Hex_mesh& mesh) {
  std::string out = "*HEADING\nhexahedral mesh\n*NODE\n";
  for (std::size_t n = 0; n < mesh.points.size(); ++n) {
    append_text(out, n + 1);
    for (double x : mesh.points[n]) {
      out += ", ";
      append_number(out, x + 0.0);
    }
    out += '\n';
  }
  for (std::size_t v = 0; v < mesh.targets.size(); ++v) {
    out += "*ELEMENT, TYPE=C3D8, ELSET=VOLUME_" + std::to_string(v) + '\n';
    for (std::size_t h = 0; h < mesh.hexes.size(); ++h) {
      if (mesh.volume[h] != static_cast<int>(v)) continue;
      append_text(out, h + 1);
      for (std::uint32_t n : mesh.hexes[h]) {
        out += ", ";
        append_text(out, n + 1);
      }
      out += '\n';
    }
  }
  std::map<int, std::set<std::uint32_t>> nodes_of;
  for (const auto& quad : mesh.boundary) nodes_of[quad.patch_id].insert(quad.nodes.begin(), quad.nodes.end());
  for (const auto& [patch, nodes] : nodes_of) {
    out += "*NSET, NSET=PATCH_" + std::to_string(patch) + '\n';
    for (std::uint32_t n : nodes) out += std::to_string(n + 1) + ",\n";
  }
  for (const auto& [patch, faces] : faces_on_patches(mesh)) {
    out += "*SURFACE, NAME=SURFACE_" + std::to_string(patch) + ", TYPE=ELEMENT\n";
    for (const auto& [h, f] : faces) out += std::to_string(h + 1) + ", S" + std::to_string(f) + '\n';
  }
  return out;
}

inline Encoded_file encoded_inp(const Hex_mesh& mesh, const std::filesystem::path& file) {
  return {file, {{file.filename().string(), encode_inp(mesh)}}};
}

}  // namespace internal

/// Writes a mesh as Abaqus input: elements C3D8 with an ELSET `VOLUME_i` for each sub-volume, and for each patch the
/// NSET `PATCH_id` of its nodes and the SURFACE `SURFACE_id` of its element faces.
/// \return `write_failed` where that is not possible; no half-written file is left then.
inline Status write_inp(const Hex_mesh& mesh, const std::string& file) {
  return internal::write_encoded({internal::encoded_inp(mesh, file)});
}

}  // namespace CCSweep

#endif
