// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_TRACE_PATH_H
#define CCSWEEP_VOLUMES_TRACE_PATH_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Surface_location.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CCSweep::internal {

/// Walks over the facets from one place of the surface to another, in the plane through both that holds `normal`.
/// Vertices that the plane all but meets are taken as on it, so that paths along edges follow the edges.
template <class Traits>
class Path_tracer {
  using Part_type = Part<Traits>;
  using Face = typename Part_type::Face;
  using Edge = typename Part_type::Edge;
  using Vertex = typename Part_type::Vertex;
  using Halfedge = typename Part_type::Halfedge;
  using Kind = Surface_location::Kind;

 public:
  /// \param is_allowed tells of a face whether the path may run on it
  template <class Predicate>
  static std::optional<std::vector<Surface_location>> trace(const Part_type& part, const Surface_location& from,
                                                            const Vec3& start, const Surface_location& to,
                                                            const Vec3& end, const Vec3& normal,
                                                            const Predicate& is_allowed) {
    Path_tracer tracer(part, start, end, normal);
    std::vector<Surface_location> path{from};
    // A place in a facet may lie a rounding error behind the edge that the path leaves by.
    double progress = -tracer.near_ * norm(tracer.along_);
    for (std::size_t steps = 0; steps <= 4 * part.mesh.number_of_faces(); ++steps) {
      std::optional<Step> best;
      for (Face f : faces_at(part, path.back())) {
        if (!is_allowed(f)) continue;
        if (tracer.is_at(to, f)) {
          path.push_back(to);
          return path;
        }
        tracer.step_across(f, path.back(), progress, best);
      }
      if (!best) return std::nullopt;
      path.push_back(best->to);
      progress = best->progress;
    }
    return std::nullopt;
  }

 private:
  struct Step {
    Surface_location to;
    double progress;
  };

  Path_tracer(const Part_type& part, const Vec3& start, const Vec3& end, const Vec3& normal)
      : part_(part), start_(start), along_(end - start), plane_(unit(cross(end - start, normal))) {
    along_ = (1 / std::max(dot(along_, along_), 1e-300)) * along_;
    near_ = 1e-10 * part.diagonal + 4e-15 * part.largest_coordinate;
  }

  bool is_at(const Surface_location& where, Face f) const {
    const auto faces = faces_at(part_, where);
    return std::find(faces.begin(), faces.end(), f) != faces.end();
  }

  double height(Vertex v) const {
    const double h = dot(plane_, part_.coordinates(v) - start_);
    return std::abs(h) <= near_ ? 0 : h;
  }

  // The furthest place ahead where the plane leaves face f.
  void step_across(Face f, const Surface_location& here, double progress, std::optional<Step>& best) const {
    const auto& mesh = part_.mesh;
    auto offer = [&](const Surface_location& to, const Vec3& p) {
      if (to.same_place(here)) return;
      const double ahead = dot(along_, p - start_);
      if (ahead > progress && (!best || ahead > best->progress)) best = Step{to, ahead};
    };
    for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Vertex v = mesh.source(h), w = mesh.target(h);
      const double a = height(v), b = height(w);
      if (a == 0) offer(Surface_location::vertex(v), part_.coordinates(v));
      if (a * b >= 0) continue;
      const Edge e = mesh.edge(h);
      const bool forward = part_.first_halfedge(e) == h;
      const double t = forward ? a / (a - b) : b / (b - a);
      const Vec3 p = part_.coordinates(v), q = part_.coordinates(w);
      offer(Surface_location::edge(e, t), p + (a / (a - b)) * (q - p));
    }
  }

  const Part_type& part_;
  Vec3 start_, along_, plane_;
  double near_ = 0;
};

}  // namespace CCSweep::internal

#endif
