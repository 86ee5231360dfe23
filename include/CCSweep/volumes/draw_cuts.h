// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_DRAW_CUTS_H
#define CCSWEEP_VOLUMES_DRAW_CUTS_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/volumes/Cut_rows.h>
#include <CCSweep/volumes/Cut_surface.h>
#include <CCSweep/volumes/Curve_walk.h>
#include <CCSweep/volumes/Surface_cutter.h>
#include <CCSweep/volumes/follow_walls.h>

#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

template <class Traits>
class Cut_drawer {
  using Loops = Layered_loops<Traits>;
  using Vertex = typename Cut_surface<Traits>::Vertex;

 public:
  Cut_drawer(const Part<Traits>& part, const Roles& roles, const Loops& loops, const std::vector<Cut_row>& rows)
      : part_(part), roles_(roles), loops_(loops), rows_(rows), cutter_(part, loops.nodes.size()),
        vertex_(loops.nodes.size(), Cut_surface<Traits>::none) {}

  Cut_surface<Traits> run() {
    // Nodes first, so that traced curves meet them where they cross an edge in the same place.
    for (const Cut_row& row : rows_)
      for (const auto* nodes : {&row.bottom, &row.top})
        for (Node_index n : *nodes) place(n);
    for (const auto& layer : loops_.segments)
      for (const auto& segment : layer) draw_imprint(segment);
    for (const auto& columns : loops_.wall_columns)
      for (const auto& column : columns) draw_column(column);
    Cut_surface<Traits> surface = cutter_.run();
    name_feature_vertices();
    surface.vertex_of_node = std::move(vertex_);
    return surface;
  }

 private:
  Vertex place(Node_index n) {
    Vertex& v = vertex_[n.value()];
    if (v != Cut_surface<Traits>::none) return v;
    const auto& node = loops_.node(n);
    v = node.where.on_surface() ? cutter_.place(node.where, node.point) : cutter_.place_inside(node.point);
    return v;
  }

  // Nodes at vertices of the part need no place of their own to be found by.
  void name_feature_vertices() {
    for (std::size_t n = 0; n < vertex_.size(); ++n)
      if (loops_.nodes[n].where.kind == Surface_location::Kind::vertex) vertex_[n] = loops_.nodes[n].where.index;
  }

  // Where a cut ends inside a source.
  void draw_imprint(const typename Loops::Segment& s) {
    const Patch_index source = s.left.source;
    if (!source.is_valid() || s.right.source != source || s.left.target == s.right.target) return;
    const Vertex v = place(s.a), w = place(s.b);
    if (part_.planar[source.value()]) {
      cutter_.draw_in_plane(v, w, source);
      return;
    }
    auto is_on_source = [&](auto f) { return part_.patch(f) == source; };
    const Vec3 normal =
        normal_at(loops_.node(s.a).where, is_on_source) + normal_at(loops_.node(s.b).where, is_on_source);
    const bool drawn = cutter_.draw(v, w, roles_.is_straight() ? roles_.direction : unit(normal), is_on_source);
    if (!drawn)
      fail(Status_code::cut_failed, Stage::sub_volumes,
           "a cut can't be drawn on source " + std::to_string(part_.id(source)), {part_.id(source)},
           Part<Traits>::coordinates(loops_.node(s.a).point));
  }

  // Where a cut meets the linking faces.
  void draw_column(const typename Loops::Wall_column& column) {
    const auto &a = loops_.node(column.bottom), &b = loops_.node(column.top);
    if (const auto between = Curve_walk<Traits>::between(part_, roles_, a.where, b.where))
      return cutter_.draw_along_edges(place(column.bottom), place(column.top), *between);
    auto is_on_wall = [&](auto f) { return is_wall(f); };
    const Vec3 normal = unit(normal_at(a.where, is_on_wall) + normal_at(b.where, is_on_wall));
    const bool drawn = cutter_.draw(place(column.bottom), place(column.top), normal, is_on_wall);
    if (!drawn) {
      const auto faces = faces_at(part_, a.where);
      const int id = part_.id(part_.patch(faces.front()));
      fail(Status_code::cut_failed, Stage::sub_volumes,
           "a column can't be drawn on the linking faces near patch " + std::to_string(id), {id},
           Part<Traits>::coordinates(a.point));
    }
  }

  bool is_wall(typename Part<Traits>::Face f) const {
    return roles_.of_patch[part_.patch(f).value()] == Role::linking;
  }

  template <class Predicate>
  Vec3 normal_at(const Surface_location& where, const Predicate& counts) const {
    Vec3 sum{};
    for (auto f : faces_at(part_, where))
      if (counts(f)) sum = sum + part_.normal[f];
    return unit(sum);
  }

  const Part<Traits>& part_;
  const Roles& roles_;
  const Loops& loops_;
  const std::vector<Cut_row>& rows_;
  Surface_cutter<Traits> cutter_;
  std::vector<Vertex> vertex_;
};

}  // namespace internal

/// Draws on the part's surface the curves along which the cuts meet it: imprints on sources, columns on linking faces,
/// and new nodes on the curves between patches (section 2.8).
/// \param follows_walls whether inner columns get vertices at the heights where the wall beside them bends
/// \return `cut_failed` with the patch and the place where a curve leaves the surface or curves cross.
/// Complexity: O(n log n) in the nodes of the cuts and the facets they cross.
template <class Traits>
Result<Cut_surface<Traits>> draw_cuts(const Part<Traits>& part, const Roles& roles, const Layered_loops<Traits>& loops,
                                      const std::vector<Cut_row>& rows, bool follows_walls = false) {
  return internal::guarded([&] {
    Cut_surface<Traits> surface = internal::Cut_drawer<Traits>(part, roles, loops, rows).run();
    if (follows_walls) internal::Wall_follower<Traits>(loops, rows, surface).run();
    return surface;
  });
}

}  // namespace CCSweep

#endif
