// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PART_WALK_ROLES_H
#define CCSWEEP_PART_WALK_ROLES_H

#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <cmath>
#include <deque>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Finds the roles of a sweep that may bend, by walking from patch to patch (White and Tautges 2000). One cap is given.
/// Every border edge of a linking face gets one of four headings: seen from outside with the sweep upwards, the border
/// runs along the foot (0), up (1), back along the top (2) and down again (3). At a vertex the heading turns by the
/// vertex type: the angle inside the face over 90 degrees. Behind a foot or a top that bends lies a cap: a source over
/// a convex top or a concave foot, else a target. Other edges lead to further linking faces.
template <class Traits>
class Role_walk {
  using Part_type = Part<Traits>;
  using Face = typename Part_type::Face;
  using Halfedge = typename Part_type::Halfedge;

 public:
  /// The roles when `seed` is a target; nothing where the walk contradicts itself or does not reach every patch.
  static std::optional<Roles> run(const Part_type& part, Patch_index seed) {
    Role_walk walk(part);
    walk.set_role(seed, Role::target);
    while (walk.is_sound_ && !walk.queue_.empty()) {
      const Patch_index patch = walk.queue_.front();
      walk.queue_.pop_front();
      if (*walk.role_[patch.value()] == Role::linking)
        walk.leave_wall(patch);
      else
        walk.leave_cap(patch);
    }
    return walk.is_sound_ ? walk.roles(seed) : std::nullopt;
  }

 private:
  static constexpr int none = -1, foot = 0, up = 1, top = 2, down = 3;
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double smooth = 30 * pi / 180;

  explicit Role_walk(const Part_type& part)
      : part_(part),
        role_(part.number_of_patches()),
        heading_(part.mesh.number_of_halfedges(), none),
        along_(part.mesh.number_of_faces(), Vec3{}) {}

  std::optional<Roles> roles(Patch_index seed) const {
    Roles result;
    bool has_source = false, has_linking = false;
    for (const auto& role : role_) {
      if (!role) return std::nullopt;
      has_source = has_source || *role == Role::source;
      has_linking = has_linking || *role == Role::linking;
      result.of_patch.push_back(*role);
    }
    if (!has_source || !has_linking) return std::nullopt;
    result.along_face = along_;
    result.direction = along_[part_.faces[seed.value()].front()];
    return result;
  }

  void set_role(Patch_index patch, Role role) {
    auto& known = role_[patch.value()];
    if (known) {
      is_sound_ = is_sound_ && *known == role;
      return;
    }
    known = role;
    // Caps go first, so that a linking face is entered over all edges of the caps that are known.
    if (role == Role::linking) {
      queue_.push_back(patch);
      return;
    }
    queue_.push_front(patch);
    for (Face f : part_.faces[patch.value()])
      along_[f] = role == Role::source ? part_.normal[f] : reversed(part_.normal[f]);
  }

  void set_heading(Halfedge h, int heading) {
    set_role(part_.patch(part_.mesh.face(h)), Role::linking);
    if (heading_[h] == none) heading_[h] = heading;
    is_sound_ = is_sound_ && heading_[h] == heading;
  }

  bool is_border(Halfedge h) const { return part_.feature[part_.mesh.edge(h)]; }

  Vec3 tangent(Halfedge h) const {
    return unit(part_.coordinates(part_.mesh.target(h)) - part_.coordinates(part_.mesh.source(h)));
  }

  bool is_tangent(Halfedge h) const {
    return angle(part_.normal[part_.mesh.face(h)], part_.normal[part_.mesh.face(part_.mesh.opposite(h))]) < smooth;
  }

  bool is_convex(Halfedge h) const {
    const Vec3 &m = part_.normal[part_.mesh.face(h)], &n = part_.normal[part_.mesh.face(part_.mesh.opposite(h))];
    return dot(cross(m, n), tangent(h)) > 0;
  }

  void leave_cap(Patch_index cap) {
    const bool is_source = *role_[cap.value()] == Role::source;
    for (Halfedge h : part_.border[cap.value()]) {
      const Halfedge back = part_.mesh.opposite(h);
      if (is_tangent(h))
        set_role(part_.patch(part_.mesh.face(back)), *role_[cap.value()]);
      else
        set_heading(back, is_source == is_convex(h) ? top : foot);
    }
  }

  // The next border edge of the same patch, and the quarter turns to it: the vertex type between them.
  std::pair<Halfedge, int> next_border(Halfedge h) const {
    const auto& mesh = part_.mesh;
    double inside = 0;
    Halfedge next = mesh.next(h);
    Vec3 from = -1.0 * tangent(h);
    for (;;) {
      const Vec3 to = tangent(next);
      inside += angle(from, to);
      if (is_border(next)) break;
      from = to;
      next = mesh.next(mesh.opposite(next));
    }
    return {next, static_cast<int>(std::lround(2 * (1 - inside / pi)))};
  }

  // Carries a known heading around its loop. Returns whether the loop has no corner.
  bool follow_loop(Halfedge start) {
    bool is_smooth = true;
    for_each_turn(start, [&](Halfedge h, Halfedge next, int turns) {
      is_smooth = is_smooth && turns == 0;
      set_heading(next, ((heading_[h] + turns) % 4 + 4) % 4);
    });
    return is_smooth;
  }

  template <class Function>
  void for_each_turn(Halfedge start, const Function& function) const {
    Halfedge h = start;
    do {
      const auto [next, turns] = next_border(h);
      function(h, next, turns);
      h = next;
    } while (h != start);
  }

  // A structured mesh needs vertex types that add up to 4 on a disc, and 4 less for every further loop.
  bool is_mappable(const std::vector<Halfedge>& edges) const {
    std::set<Halfedge> seen;
    int sum = 0, loops = 0;
    for (Halfedge start : edges) {
      if (seen.count(start)) continue;
      ++loops;
      for_each_turn(start, [&](Halfedge h, Halfedge, int turns) {
        seen.insert(h);
        sum += turns;
      });
    }
    return sum == 4 - 4 * (loops - 1);
  }

  void leave_wall(Patch_index wall) {
    const std::vector<Halfedge>& edges = part_.border[wall.value()];
    if (!is_mappable(edges)) {
      is_sound_ = false;
      return;
    }
    bool is_ring = true;
    int heading_of_ring = none;
    for (Halfedge h : edges)
      if (heading_[h] != none) {
        is_ring = follow_loop(h) && is_ring;
        heading_of_ring = heading_[h];
      }
    spread_over(wall);
    for (Halfedge h : edges) {
      if (heading_[h] != none || !is_sound_) continue;
      // The other end of a ring; or a hole, which is turned as the face around it.
      const bool is_other_end = is_ring && heading_of_ring % 2 == 0 && is_smooth_loop(h);
      set_heading(h, is_other_end ? (heading_of_ring + 2) % 4 : heading_in_field(h));
      follow_loop(h);
    }
    spread_over(wall);
    for (Halfedge h : edges) cross_border(h);
  }

  bool is_smooth_loop(Halfedge start) const {
    bool is_smooth = true;
    for_each_turn(start, [&](Halfedge, Halfedge, int turns) { is_smooth = is_smooth && turns == 0; });
    return is_smooth;
  }

  void cross_border(Halfedge h) {
    if (!is_sound_) return;
    const Halfedge back = part_.mesh.opposite(h);
    const int heading = heading_[h];
    if (heading % 2 == 1 || is_tangent(h))
      set_heading(back, (heading + 2) % 4);
    else
      set_role(part_.patch(part_.mesh.face(back)), (heading == top) == is_convex(h) ? Role::source : Role::target);
  }

  bool is_known(Face f) const { return dot(along_[f], along_[f]) > 0; }

  // Where the sweep leads at a border edge.
  Vec3 direction_at(Halfedge h) const {
    const Vec3 t = tangent(h), inward = cross(part_.normal[part_.mesh.face(h)], t);
    switch (heading_[h]) {
      case foot: return inward;
      case up: return t;
      case top: return reversed(inward);
      default: return reversed(t);
    }
  }

  int heading_in_field(Halfedge h) const {
    const Vec3 t = tangent(h), inward = cross(part_.normal[part_.mesh.face(h)], t), a = along_[part_.mesh.face(h)];
    if (std::abs(dot(a, t)) > std::abs(dot(a, inward))) return dot(a, t) > 0 ? up : down;
    return dot(a, inward) > 0 ? foot : top;
  }

  // The direction of the sweep on all faces of a linking face, carried inwards from its border as the surface turns.
  void spread_over(Patch_index wall) {
    const auto& mesh = part_.mesh;
    std::deque<Face> front;
    for (Face f : part_.faces[wall.value()]) {
      along_[f] = Vec3{};
      for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f)))
        if (is_border(h) && heading_[h] != none) along_[f] = along_[f] + direction_at(h);
      along_[f] = unit(along_[f]);
      if (is_known(f)) front.push_back(f);
    }
    while (!front.empty()) {
      const Face f = front.front();
      front.pop_front();
      for (Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        const Face g = mesh.face(mesh.opposite(h));
        if (part_.patch(g) != wall || is_known(g)) continue;
        const Vec3 e = tangent(h), t = along_[f];
        along_[g] = dot(t, e) * e + dot(t, cross(part_.normal[f], e)) * cross(part_.normal[g], e);
        front.push_back(g);
      }
    }
  }

  const Part_type& part_;
  std::vector<std::optional<Role>> role_;
  std::vector<int> heading_;  // by halfedge
  std::vector<Vec3> along_;   // by face; zero where the walk has not been
  std::deque<Patch_index> queue_;
  bool is_sound_ = true;
};

}  // namespace CCSweep::internal

#endif
