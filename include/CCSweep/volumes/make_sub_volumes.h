// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_MAKE_SUB_VOLUMES_H
#define CCSWEEP_VOLUMES_MAKE_SUB_VOLUMES_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/connect_triangles.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Layering.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/volumes/Cut_rows.h>
#include <CCSweep/volumes/Cut_surface.h>
#include <CCSweep/volumes/Cut_triangles.h>
#include <CCSweep/volumes/Decomposition.h>
#include <CCSweep/volumes/Triangle_sides.h>
#include <CCSweep/volumes/separate_fans.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

// Tells of every triangle of the cut surface which target's sub-volume it bounds: labels known from the layers are
// flooded up to the edges that the cuts meet. Labels that disagree are the sign of a leak.
template <class Traits>
class Surface_labels {
  using Side = typename Layered_loops<Traits>::Side;

 public:
  Surface_labels(const Part<Traits>& part, const Roles& roles, const Layered_loops<Traits>& loops,
                 const Cut_surface<Traits>& surface, const Cut_triangles& cuts)
      : part_(part), roles_(roles), loops_(loops), surface_(surface), cuts_(cuts), label_(surface.triangles.size()),
        sides_(surface.triangles, surface.points.size()), is_barrier_(3 * surface.triangles.size()) {
    for (const Triangle& t : cuts.triangles) add_barriers(t);
    for (const auto& [t, target] : cuts.on_surface) add_barriers(surface.triangles[t]);
  }

  std::vector<Patch_index> run() {
    label_targets();
    label_sources();
    label_walls();
    flood();
    for (const auto& [t, target] : cuts_.on_surface) label_[t] = target;
    check_all_labelled();
    return std::move(label_);
  }

 private:
  void add_barriers(const Triangle& t) {
    const auto close = [this](std::uint32_t side) { is_barrier_[side] = true; };
    for (int k = 0; k < 3; ++k) {
      sides_.for_each(t[k], t[(k + 1) % 3], close);
      sides_.for_each(t[(k + 1) % 3], t[k], close);
    }
  }

  void set_label(std::size_t t, Patch_index target) {
    if (label_[t] == target) return;
    if (label_[t].is_valid()) {
      const int id = part_.id(surface_.patch[t]);
      fail(Status_code::sub_volume_not_closed, Stage::sub_volumes,
           "on patch " + std::to_string(id) + " the sub-volumes of targets " + std::to_string(part_.id(label_[t])) +
               " and " + std::to_string(part_.id(target)) + " run into each other",
           {id, part_.id(label_[t]), part_.id(target)},
           Part<Traits>::coordinates(surface_.points[surface_.triangles[t][0]]));
    }
    label_[t] = target;
    stack_.push_back(static_cast<std::uint32_t>(t));
  }

  void label_targets() {
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      if (roles_.of_patch[surface_.patch[t].value()] == Role::target) set_label(t, surface_.patch[t]);
  }

  // The triangle to the left of the first piece of a drawn segment, when seen from outside.
  void label_left_of(Node_index a, Node_index b, Patch_index patch, Patch_index target) {
    const auto v = surface_.vertex_of_node[a.value()], w = surface_.vertex_of_node[b.value()];
    if (v == Cut_surface<Traits>::none || w == Cut_surface<Traits>::none) return;
    const auto path = surface_.path(v, w);
    sides_.for_each(path[0], path[1], [&](std::uint32_t side) {
      if (!patch.is_valid() || surface_.patch[side / 3] == patch) set_label(side / 3, target);
    });
  }

  void label_sources() {
    for (const auto& layer : loops_.segments)
      for (const auto& s : layer) {
        if (s.left.source.is_valid()) label_left_of(s.a, s.b, s.left.source, s.left.target);
        if (s.right.source.is_valid()) label_left_of(s.b, s.a, s.right.source, s.right.target);
      }
  }

  void label_walls() {
    for (const auto& w : loops_.wall_labels)
      w.above ? label_left_of(w.a, w.b, Patch_index(), w.target) : label_left_of(w.b, w.a, Patch_index(), w.target);
  }

  void flood() {
    while (!stack_.empty()) {
      const std::uint32_t t = stack_.back();
      stack_.pop_back();
      const Triangle& v = surface_.triangles[t];
      for (std::uint32_t k = 0; k < 3; ++k)
        if (!is_barrier_[3 * t + k])
          sides_.for_each(v[(k + 1) % 3], v[k],
                          [&](std::uint32_t opposite) { set_label(opposite / 3, label_[t]); });
    }
  }

  void check_all_labelled() const {
    for (std::size_t t = 0; t < label_.size(); ++t)
      if (!label_[t].is_valid()) {
        const int id = part_.id(surface_.patch[t]);
        fail(Status_code::sub_volume_not_closed, Stage::sub_volumes,
             "a piece of patch " + std::to_string(id) + " belongs to no sub-volume", {id},
             Part<Traits>::coordinates(surface_.points[surface_.triangles[t][0]]));
      }
  }

  const Part<Traits>& part_;
  const Roles& roles_;
  const Layered_loops<Traits>& loops_;
  const Cut_surface<Traits>& surface_;
  const Cut_triangles& cuts_;
  std::vector<Patch_index> label_;
  Triangle_sides sides_;
  std::vector<bool> is_barrier_;  // by side: whether a cut meets the surface there
  std::vector<std::uint32_t> stack_;
};

template <class Traits>
class Sub_volume_builder {
  using Point_3 = typename Traits::Point_3;

 public:
  Sub_volume_builder(const Part<Traits>& part, const Roles& roles, const Cut_surface<Traits>& surface,
                     const std::vector<Patch_index>& label, const Cut_triangles& cuts)
      : part_(part), roles_(roles), surface_(surface), cuts_(cuts) {
    first_cut_id_ = *std::max_element(part.patch_id.begin(), part.patch_id.end()) + 1;
    reserve_pieces(label);
    std::vector<Piece>* pieces = nullptr;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const Patch_index patch = surface.patch[t];
      if (t == 0 || label[t] != label[t - 1]) pieces = &pieces_[label[t]];
      pieces->push_back({surface.triangles[t], part.id(patch), roles.of_patch[patch.value()]});
    }
    for (std::size_t t = 0; t < cuts.triangles.size(); ++t) {
      const Triangle& v = cuts.triangles[t];
      const int id = first_cut_id_ + static_cast<int>(cuts.set[t]);
      pieces_[cuts.left[t]].push_back({v, id, Role::cut});
      pieces_[cuts.right[t]].push_back({{v[0], v[2], v[1]}, id, Role::cut});
    }
  }

  void run(Decomposition<Point_3>& result) const {
    std::map<Patch_index, int> volume_of;
    for (const auto& [target, pieces] : pieces_) {
      volume_of[target] = static_cast<int>(result.volumes.size());
      result.volumes.push_back(make_volume(target, pieces));
    }
    result.sets.resize(cuts_.number_of_sets);
    for (std::size_t t = 0; t < cuts_.triangles.size(); ++t) {
      Decomposition_set& set = result.sets[cuts_.set[t]];
      set.id = first_cut_id_ + static_cast<int>(cuts_.set[t]);
      const auto [i, j] = std::minmax(volume_of.at(cuts_.left[t]), volume_of.at(cuts_.right[t]));
      set.volumes = {i, j};
      ++set.triangles;
    }
  }

 private:
  struct Piece {
    Triangle vertices;
    int patch_id;
    Role role;
  };

  using Mesh = typename Sub_volume<Point_3>::Mesh;

  void reserve_pieces(const std::vector<Patch_index>& label) {
    std::vector<std::size_t> count(part_.number_of_patches(), 0);
    for (const auto* labels : {&label, &cuts_.left, &cuts_.right})
      for (Patch_index target : *labels) ++count[target.value()];
    for (std::size_t p = 0; p < count.size(); ++p)
      if (count[p] > 0) pieces_[Patch_index(p)].reserve(count[p]);
  }

  Sub_volume<Point_3> make_volume(Patch_index target, const std::vector<Piece>& pieces) const {
    Sub_volume<Point_3> volume;
    volume.target = part_.id(target);
    auto& mesh = volume.mesh;
    // Few touch themselves and need their fans told apart.
    if (!connect_vertices(pieces, mesh)) {
      mesh.clear();
      connect_fans(target, pieces, mesh);
    }
    auto patch_id = mesh.template add_property_map<CGAL::SM_Face_index, int>(Sub_volume<Point_3>::patch_id_map, -1);
    auto role = mesh.template add_property_map<CGAL::SM_Face_index, int>(Sub_volume<Point_3>::role_map, 0);
    for (auto f : mesh.faces()) {
      patch_id.first[f] = pieces[f].patch_id;
      role.first[f] = static_cast<int>(pieces[f].role);
    }
    volume.sources = sources(pieces);
    return volume;
  }

  static std::vector<int> sources(const std::vector<Piece>& pieces) {
    std::set<int> ids;
    for (std::size_t t = 0; t < pieces.size(); ++t)
      if (pieces[t].role == Role::source && (t == 0 || pieces[t].patch_id != pieces[t - 1].patch_id))
        ids.insert(pieces[t].patch_id);
    return {ids.begin(), ids.end()};
  }

  // Makes the mesh over the vertices of the surface. Returns whether it is a closed 2-manifold.
  bool connect_vertices(const std::vector<Piece>& pieces, Mesh& mesh) const {
    std::uint32_t least = static_cast<std::uint32_t>(-1), most = 0;
    for (const Piece& p : pieces) {
      least = std::min({least, p.vertices[0], p.vertices[1], p.vertices[2]});
      most = std::max({most, p.vertices[0], p.vertices[1], p.vertices[2]});
    }
    std::vector<std::uint32_t> number(most + 1 - least, 0), vertex_of(number.size());
    for (const Piece& p : pieces)
      for (std::uint32_t v : p.vertices) number[v - least] = 1;
    std::uint32_t used = 0;
    for (std::uint32_t i = 0; i < number.size(); ++i) {  // without branches, as which vertices are used has no pattern
      vertex_of[used] = least + i;
      used += std::exchange(number[i], used);
    }
    vertex_of.resize(used);
    add_vertices(vertex_of, mesh);
    const auto corners = [&](const Piece& p) {
      return Triangle{number[p.vertices[0] - least], number[p.vertices[1] - least], number[p.vertices[2] - least]};
    };
    return Triangle_connector<Point_3>::run(pieces, corners, mesh) && has_single_fans(mesh);
  }

  // Makes the mesh with a vertex for each fan of triangles.
  void connect_fans(Patch_index target, const std::vector<Piece>& pieces, Mesh& mesh) const {
    std::vector<Triangle> triangles;
    for (const Piece& p : pieces) triangles.push_back(p.vertices);
    const auto fans = Fan_separator::run(
        triangles, [&](std::uint32_t v) { return Part<Traits>::coordinates(surface_.points[v]); });
    if (!fans) report_open(target, triangles);
    std::vector<std::uint32_t> vertex_of;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t fan = (*fans)[t][k];
        vertex_of.resize(std::max(vertex_of.size(), fan + 1));
        vertex_of[fan] = triangles[t][k];
      }
    add_vertices(vertex_of, mesh);
    const auto corners = [](const std::array<std::size_t, 3>& f) {
      return Triangle{static_cast<std::uint32_t>(f[0]), static_cast<std::uint32_t>(f[1]),
                      static_cast<std::uint32_t>(f[2])};
    };
    if (!Triangle_connector<Point_3>::run(*fans, corners, mesh)) report_open(target, triangles);
  }

  void add_vertices(const std::vector<std::uint32_t>& vertex_of, Mesh& mesh) const {
    mesh.resize(static_cast<std::uint32_t>(vertex_of.size()), 0, 0);
    for (auto v : mesh.vertices()) mesh.point(v) = surface_.points[vertex_of[v]];
  }

  // The place is the first edge that does not run as often forth as back.
  [[noreturn]] void report_open(Patch_index target, const std::vector<Triangle>& triangles) const {
    std::map<Vertex_pair, int> balance;
    for (const Triangle& t : triangles)
      for (int k = 0; k < 3; ++k) {
        const auto a = t[k], b = t[(k + 1) % 3];
        balance[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    const auto open = std::find_if(balance.begin(), balance.end(), [](const auto& e) { return e.second != 0; });
    std::optional<std::array<double, 3>> place;
    if (open != balance.end()) place = Part<Traits>::coordinates(surface_.points[open->first.first]);
    fail(Status_code::sub_volume_not_closed, Stage::sub_volumes,
         "the cuts do not close the sub-volume of target " + std::to_string(part_.id(target)), {part_.id(target)},
         place);
  }

  const Part<Traits>& part_;
  const Roles& roles_;
  const Cut_surface<Traits>& surface_;
  const Cut_triangles& cuts_;
  int first_cut_id_ = 0;
  std::map<Patch_index, std::vector<Piece>> pieces_;
};

// What the stages found out of the part, by the ids of its patches.
template <class Traits>
void describe(const Part<Traits>& part, const Roles& roles, const Layering& layering,
              Decomposition<typename Traits::Point_3>& result) {
  result.direction = roles.direction;
  for (std::size_t p = 0; p < part.number_of_patches(); ++p) result.roles[part.patch_id[p]] = roles.of_patch[p];
  for (const auto& caps : layering.caps) {
    std::vector<int> ids;
    for (Patch_index p : caps) ids.push_back(part.id(p));
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    result.levels.push_back(std::move(ids));
  }
  result.layers = layering.number_of_layers();
  result.sweep_parameters = layering.layers;
}

}  // namespace internal

/// Builds the sub-volumes (section 2.8): triangulates the cuts, gathers them into decomposition sets, tells of every
/// piece of the cut surface which target's sub-volume it bounds, and joins both to closed meshes.
///
/// \return the decomposition, without its tolerance and times; `sub_volume_not_closed` with the patches and the place
/// where sub-volumes run into each other, `cut_failed` where a cut folds onto itself.
/// Complexity: O(n log n) in the triangles.
template <class Traits>
Result<Decomposition<typename Traits::Point_3>> make_sub_volumes(const Part<Traits>& part, const Roles& roles,
                                                                 const Layering& layering,
                                                                 const Layered_loops<Traits>& loops,
                                                                 const std::vector<Cut_row>& rows,
                                                                 const Cut_surface<Traits>& surface) {
  return internal::guarded([&] {
    using namespace internal;
    Decomposition<typename Traits::Point_3> result;
    describe(part, roles, layering, result);
    result.notes = loops.notes;
    const Cut_triangles cuts = Cut_triangulator<Traits>(loops, rows, surface).run();
    const auto labels = Surface_labels<Traits>(part, roles, loops, surface, cuts).run();
    Sub_volume_builder<Traits>(part, roles, surface, labels, cuts).run(result);
    return result;
  });
}

}  // namespace CCSweep

#endif
