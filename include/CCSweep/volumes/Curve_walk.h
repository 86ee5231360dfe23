// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_CURVE_WALK_H
#define CCSWEEP_VOLUMES_CURVE_WALK_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/part/Surface_location.h>

#include <optional>
#include <vector>

namespace CCSweep::internal {

/// Walks from one place to another along the curves between linking faces: where such a curve bends between two
/// layers, a column that begins and ends on it must not cut the corner.
template <class Traits>
class Curve_walk {
  using Part_type = Part<Traits>;
  using Vertex = typename Part_type::Vertex;
  using Halfedge = typename Part_type::Halfedge;
  using Kind = Surface_location::Kind;

 public:
  /// The vertices passed between the two places; nothing where no curve leads from one to the other.
  static std::optional<std::vector<Vertex>> between(const Part_type& part, const Roles& roles,
                                                    const Surface_location& from, const Surface_location& to) {
    if (!is_on_curve(from) || !is_on_curve(to)) return std::nullopt;
    const Curve_walk walk(part, roles, coordinates(part, from), coordinates(part, to));
    std::vector<Vertex> passed;
    for (Surface_location at = from; !walk.leads_to(at, to);) {
      const Halfedge h = walk.onward(at);
      if (!h.is_valid()) return std::nullopt;
      passed.push_back(part.mesh.target(h));
      at = Surface_location::vertex(passed.back());
    }
    return passed;
  }

 private:
  Curve_walk(const Part_type& part, const Roles& roles, const Vec3& start, const Vec3& end)
      : part_(part), roles_(roles), end_(end), along_(unit(end - start)) {}

  static bool is_on_curve(const Surface_location& where) {
    return where.kind == Kind::vertex || where.kind == Kind::edge;
  }

  bool is_curve(Halfedge h) const {
    const auto is_wall = [this](Halfedge side) {
      return roles_.of_patch[part_.patch(part_.mesh.face(side)).value()] == Role::linking;
    };
    return part_.feature[part_.mesh.edge(h)] && is_wall(h) && is_wall(part_.mesh.opposite(h));
  }

  bool leads_to(const Surface_location& at, const Surface_location& to) const {
    if (at.kind == Kind::vertex && at.same_place(to)) return true;
    const auto e = common_edge(part_, at, to);
    return e.is_valid() && is_curve(part_.mesh.halfedge(e));
  }

  // The halfedge of a curve that gets ahead most steeply, and not past the end.
  Halfedge onward(const Surface_location& at) const {
    const auto& mesh = part_.mesh;
    Halfedge best;
    double steepest = 0;
    const auto offer = [&](Halfedge h, const Vec3& from) {
      const Vec3 to = part_.coordinates(mesh.target(h));
      const double slope = dot(along_, unit(to - from));
      if (!is_curve(h) || slope <= steepest || dot(along_, end_ - to) < 0) return;
      steepest = slope;
      best = h;
    };
    if (at.kind == Kind::edge) {
      const Halfedge h = mesh.halfedge(typename Part_type::Edge(at.index));
      for (Halfedge side : {h, mesh.opposite(h)}) offer(side, coordinates(part_, at));
    } else {
      for (Halfedge in : mesh.halfedges_around_target(mesh.halfedge(Vertex(at.index))))
        offer(mesh.opposite(in), part_.coordinates(Vertex(at.index)));
    }
    return best;
  }

  const Part_type& part_;
  const Roles& roles_;
  Vec3 end_, along_;
};

}  // namespace CCSweep::internal

#endif
