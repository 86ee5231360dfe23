// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_REPLACE_VOLUME_H
#define CCSWEEP_HEX_REPLACE_VOLUME_H

#include <CCSweep/hex/Hex_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// A face of a hexahedron, by its nodes.
using Hex_face = std::array<std::uint32_t, 4>;

/// Which nodes make the faces of a hexahedron.
inline constexpr std::array<Hex_face, 6> hex_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// The faces between the hexahedra of one sub-volume and those of others, each with its nodes ascending.
inline std::vector<Hex_face> shared_faces(const Hex_mesh& mesh, int volume) {
  const auto sorted = [](Hex_face face) {
    std::sort(face.begin(), face.end());
    return face;
  };
  std::vector<Hex_face> all, boundary, shared;
  for (std::size_t h = 0; h < mesh.hexes.size(); ++h)
    if (mesh.volume[h] == volume)
      for (const auto& [a, b, c, d] : hex_faces)
        all.push_back(sorted({mesh.hexes[h][a], mesh.hexes[h][b], mesh.hexes[h][c], mesh.hexes[h][d]}));
  for (const auto& quad : mesh.boundary)
    if (quad.volume == volume) boundary.push_back(sorted(quad.nodes));
  std::sort(all.begin(), all.end());
  std::sort(boundary.begin(), boundary.end());
  std::vector<Hex_face> single;
  for (auto at = all.begin(); at != all.end();) {
    const auto end = std::upper_bound(at, all.end(), *at);
    if (end - at == 1) single.push_back(*at);
    at = end;
  }
  std::set_difference(single.begin(), single.end(), boundary.begin(), boundary.end(), std::back_inserter(shared));
  return shared;
}

/// Puts another mesh of one sub-volume into the mesh of a whole part.
class Volume_replacer {
  using Point = Hex_mesh::Point;

 public:
  /// \param shared the faces it has in common with others, as of `shared_faces()`
  Volume_replacer(const Hex_mesh& whole, int volume, const std::vector<Hex_face>& shared)
      : whole_(whole), volume_(volume) {
    for (Hex_face face : shared) {
      for (std::uint32_t n : face) node_at_.emplace(whole.points[n], n);
      std::sort(face.begin(), face.end());
      shared_.insert(face);
    }
  }

  /// Whether a mesh has just these faces on the cuts, with nodes at the very same places.
  bool fits(const Hex_mesh& part, const std::set<int>& cuts) const {
    std::size_t count = 0;
    for (const auto& quad : part.boundary) {
      if (cuts.count(quad.patch_id) == 0) continue;
      Hex_face face;
      for (std::size_t i = 0; i < 4; ++i) {
        const auto found = node_at_.find(part.points[quad.nodes[i]]);
        if (found == node_at_.end()) return false;
        face[i] = found->second;
      }
      std::sort(face.begin(), face.end());
      if (shared_.count(face) == 0) return false;
      ++count;
    }
    return count == shared_.size();
  }

  /// The whole with another mesh of the sub-volume.
  /// \param part a mesh that fits, all sub-volumes of which are taken as one
  Hex_mesh with(const Hex_mesh& part, const std::set<int>& cuts) const {
    Hex_mesh made;
    made.targets = whole_.targets;
    made.directions = whole_.directions;
    made.bounds = whole_.bounds;
    made.directions[volume_] = part.directions[0];
    made.bounds[volume_] = tightest_bound(part);
    std::vector<std::uint32_t> number(whole_.points.size(), none);
    add(whole_, made, number, [&](int v) { return v == volume_ ? -1 : v; }, [](int) { return true; });
    std::vector<std::uint32_t> of_part(part.points.size(), none);
    for (std::size_t n = 0; n < part.points.size(); ++n)
      if (const auto found = node_at_.find(part.points[n]); found != node_at_.end()) of_part[n] = number[found->second];
    add(part, made, of_part, [&](int) { return volume_; }, [&](int patch) { return cuts.count(patch) == 0; });
    return made;
  }

 private:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  // Adds the hexahedra whose sub-volume has a new number, and their boundary on the patches that stay one.
  template <class Renumber, class IsBoundary>
  static void add(const Hex_mesh& from, Hex_mesh& to, std::vector<std::uint32_t>& number, const Renumber& renumber,
                  const IsBoundary& is_boundary) {
    const auto renumber_nodes = [&](auto nodes) {
      for (std::uint32_t& n : nodes) {
        if (number[n] == none) {
          number[n] = static_cast<std::uint32_t>(to.points.size());
          to.points.push_back(from.points[n]);
        }
        n = number[n];
      }
      return nodes;
    };
    for (std::size_t h = 0; h < from.hexes.size(); ++h)
      if (const int volume = renumber(from.volume[h]); volume != -1) {
        to.hexes.push_back(renumber_nodes(from.hexes[h]));
        to.volume.push_back(volume);
      }
    for (const auto& quad : from.boundary)
      if (const int volume = renumber(quad.volume); volume != -1 && is_boundary(quad.patch_id))
        to.boundary.push_back({renumber_nodes(quad.nodes), quad.patch_id, quad.role, volume});
  }

  const Hex_mesh& whole_;
  int volume_;
  std::map<Point, std::uint32_t> node_at_;  // on the cuts
  std::set<Hex_face> shared_;
};

}  // namespace CCSweep::internal

#endif
