// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_MAKE_WALL_SECTIONS_H
#define CCSWEEP_LINKING_MAKE_WALL_SECTIONS_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/Key_map.h>
#include <CCSweep/internal/Union_find.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Layering.h>
#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

template <class Traits>
class Wall_tracer {
  using Part_type = Part<Traits>;
  using Face = typename Part_type::Face;
  using Halfedge = typename Part_type::Halfedge;
  using Vertex = typename Part_type::Vertex;

 public:
  Wall_tracer(const Part_type& part, const Roles& roles, const Layering& layering)
      : part_(part), roles_(roles), layering_(layering), bottom_of_(part.mesh.number_of_faces(), none),
        is_done_(part.mesh.number_of_faces(), false), pieces_(part.mesh.number_of_vertices()),
        loop_at_(part.mesh.number_of_vertices(), none) {
    place_vertices();
    distribute_faces();
    find_sharp_edges();
    join_vertices();
  }

  Wall_sections run() {
    Wall_sections sections;
    const std::size_t n = layering_.number_of_layers();
    sections.arriving.resize(n);
    sections.leaving.resize(n);
    sections.strips.resize(n);
    std::vector<std::vector<Face>> faces_of_leaving, faces_of_arriving;
    for (std::size_t k = 0; k + 1 < n; ++k) {
      sections.leaving[k] = trace_loops(leaving_[k], k, +1, faces_of_leaving);
      sections.arriving[k + 1] = trace_loops(arriving_[k + 1], k + 1, -1, faces_of_arriving);
      sections.strips[k] = pair_loops(k, faces_of_leaving, faces_of_arriving);
      for (Wall_strip& strip : sections.strips[k])
        find_rails(sections.leaving[k][strip.bottom], sections.arriving[k + 1][strip.top], k, strip);
    }
    return sections;
  }

 private:
  // Where the region on one side of a layer's value meets that value inside a face, in the sense of the section.
  struct Row_piece {
    Surface_location from, to;
    Halfedge way_out;  // the halfedge to cross to get to the next piece
    Wall_loop::Carrier carrier;
    bool is_point = false;
  };

  static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);

  double parameter(Vertex v) const { return layering_.parameter[v]; }
  bool is_wall(Face f) const { return roles_.of_patch[part_.patch(f).value()] == Role::linking; }

  // Where layer k stands among the layers and the gaps between them, and so does what lies on it; what lies above it
  // and below the next one stands one higher.
  static int position(std::size_t layer) { return 2 * static_cast<int>(layer); }
  bool is_between_layers(int place) const {
    return place % 2 == 1 && place < position(layering_.number_of_layers() - 1);
  }

  void place_vertices() {
    const auto& layers = layering_.layers;
    position_.reserve(part_.mesh.number_of_vertices());
    for (Vertex v : part_.mesh.vertices()) {
      const auto above = std::lower_bound(layers.begin(), layers.end(), parameter(v));
      const int next = position(above - layers.begin());
      position_.push_back(above != layers.end() && *above == parameter(v) ? next : next - 1);
    }
  }

  // The faces of the linking patches by the layers that they reach up from and up to.
  void distribute_faces() {
    const std::size_t n = layering_.number_of_layers();
    const auto& mesh = part_.mesh;
    leaving_.resize(n);
    arriving_.resize(n);
    for (Face f : mesh.faces()) {
      if (!is_wall(f)) continue;
      const Halfedge h = mesh.halfedge(f);
      const Vertex u = mesh.target(h), v = mesh.target(mesh.next(h)), w = mesh.target(mesh.prev(h));
      const auto [low, high] = std::minmax({position_[u], position_[v], position_[w]});
      if (low < 0 || high > position(n - 1))
        fail(Status_code::inconsistent_levels, Stage::linking_mesh,
             "linking patch " + std::to_string(part_.id(part_.patch(f))) + " reaches beyond the last source or target",
             {part_.id(part_.patch(f))}, place_of(f));
      if (parameter(u) == parameter(v) && parameter(v) == parameter(w))
        fail(Status_code::linking_face_not_mappable, Stage::linking_mesh,
             "linking patch " + std::to_string(part_.id(part_.patch(f))) + " has a facet across the sweep",
             {part_.id(part_.patch(f))}, place_of(f));
      for (std::size_t k = low / 2; k + 1 < n && position(k) < high; ++k) {
        if (low <= position(k)) leaving_[k].push_back(f);
        if (high >= position(k + 1)) arriving_[k + 1].push_back(f);
      }
    }
  }

  void find_sharp_edges() {
    constexpr double smooth = 20 * 3.14159265358979323846 / 180;
    sharp_.assign(part_.mesh.number_of_edges(), false);
    for (const auto& border : part_.border)
      for (Halfedge h : border) {
        const Face f = part_.mesh.face(h), g = part_.mesh.face(part_.mesh.opposite(h));
        sharp_[part_.mesh.edge(h)] = is_wall(f) && is_wall(g) && angle(part_.normal[f], part_.normal[g]) > smooth;
      }
  }

  std::array<double, 3> place_of(Face f) const {
    return part_.coordinates(part_.mesh.target(part_.mesh.halfedge(f)));
  }

  Surface_location crossing(Halfedge h, double value) const {
    const auto e = part_.mesh.edge(h);
    const Halfedge first = part_.first_halfedge(e);
    const double a = parameter(part_.mesh.source(first)), b = parameter(part_.mesh.target(first));
    return Surface_location::edge(e, (value - a) / (b - a));
  }

  // side +1: the region above the layer, whose row leaves upwards; -1: the one below, whose row arrives.
  std::optional<Row_piece> row_piece(Face f, std::size_t layer, int side) const {
    const auto& mesh = part_.mesh;
    const Halfedge first = mesh.halfedge(f);
    const std::array<Halfedge, 3> sides{first, mesh.next(first), mesh.prev(first)};
    std::array<bool, 3> ends_inside;
    for (std::size_t k = 0; k < 3; ++k)
      ends_inside[k] = side * (position_[mesh.target(sides[k])] - position(layer)) > 0;
    Halfedge out, in;  // the region's border turns onto the row at `out` and leaves it at `in`
    for (std::size_t k = 0; k < 3; ++k)
      if (const bool begins_inside = ends_inside[(k + 2) % 3]; begins_inside != ends_inside[k])
        (begins_inside ? out : in) = sides[k];
    if (!out.is_valid() || !in.is_valid()) return std::nullopt;
    Row_piece piece;
    const Vertex v = mesh.target(out), w = mesh.source(in);
    const bool from_vertex = position_[v] == position(layer), to_vertex = position_[w] == position(layer);
    const double value = layering_.layers[layer];
    piece.from = from_vertex ? Surface_location::vertex(v) : crossing(out, value);
    piece.to = to_vertex ? Surface_location::vertex(w) : crossing(in, value);
    piece.way_out = in;
    piece.is_point = piece.from.same_place(piece.to);
    piece.carrier = {false, static_cast<std::uint32_t>(f)};
    if (from_vertex && to_vertex && v != w)
      piece.carrier = {true, static_cast<std::uint32_t>(mesh.edge(mesh.next(out)))};
    if (side < 0) {  // below a row the same turn runs the other way
      std::swap(piece.from, piece.to);
      piece.way_out = out;
    }
    return piece;
  }

  std::vector<Wall_loop> trace_loops(const std::vector<Face>& starts, std::size_t layer, int side,
                                     std::vector<std::vector<Face>>& faces) {
    std::vector<Wall_loop> loops;
    faces.clear();
    for (Face start : starts) {
      if (is_done_[start]) continue;
      const auto piece = row_piece(start, layer, side);
      if (!piece || piece->is_point) continue;
      loops.push_back(trace_loop(start, layer, side, faces.emplace_back()));
    }
    for (const auto& passed : faces)
      for (Face f : passed) is_done_[f] = false;
    return loops;
  }

  // The loop, and all faces that it passes, also those that it meets in a vertex only.
  Wall_loop trace_loop(Face start, std::size_t layer, int side, std::vector<Face>& passed) {
    Wall_loop loop;
    Face f = start;
    do {
      const auto piece = row_piece(f, layer, side);
      if (!is_wall(f) || !piece)
        fail(Status_code::inconsistent_levels, Stage::linking_mesh,
             "the row of the linking mesh at " + std::to_string(layering_.layers[layer]) + " runs into patch " +
                 std::to_string(part_.id(part_.patch(f))),
             {part_.id(part_.patch(f))}, place_of(f));
      if (!piece->is_point) {
        loop.nodes.push_back(piece->from);
        loop.carriers.push_back(piece->carrier);
        is_done_[f] = true;
      }
      passed.push_back(f);
      f = part_.mesh.face(part_.mesh.opposite(piece->way_out));
    } while (f != start);
    return loop;
  }

  // Vertices between the same two layers that edges join lie on one piece of the surface between these.
  void join_vertices() {
    const auto& mesh = part_.mesh;
    for (auto e : mesh.edges()) {
      const Halfedge h = mesh.halfedge(e);
      const Vertex v = mesh.source(h), w = mesh.target(h);
      if (position_[v] == position_[w] && is_between_layers(position_[v])) pieces_.join(v, w);
    }
  }

  // Two loops belong together when the linking faces join them between the two layers: over the vertices between, or
  // in a face that reaches from one to the other.
  std::vector<Wall_strip> pair_loops(std::size_t slab, const std::vector<std::vector<Face>>& bottoms,
                                     const std::vector<std::vector<Face>>& tops) {
    Union_find loops(bottoms.size() + tops.size());
    std::vector<std::size_t> met;
    const auto join_over_vertices = [&](const std::vector<Face>& faces, std::size_t loop) {
      for (Face f : faces)
        for (Vertex v : part_.mesh.vertices_around_face(part_.mesh.halfedge(f))) {
          if (position_[v] != position(slab) + 1) continue;
          const std::size_t piece = pieces_.root(v);
          if (loop_at_[piece] == none) {
            loop_at_[piece] = static_cast<std::uint32_t>(loop);
            met.push_back(piece);
          }
          loops.join(loop, loop_at_[piece]);
        }
    };
    for (std::size_t i = 0; i < bottoms.size(); ++i) {
      join_over_vertices(bottoms[i], i);
      for (Face f : bottoms[i]) bottom_of_[f] = static_cast<std::uint32_t>(i);
    }
    for (std::size_t j = 0; j < tops.size(); ++j) {
      join_over_vertices(tops[j], bottoms.size() + j);
      for (Face f : tops[j])
        if (bottom_of_[f] != none) loops.join(bottoms.size() + j, bottom_of_[f]);
    }
    for (std::size_t piece : met) loop_at_[piece] = none;
    for (const auto& faces : bottoms)
      for (Face f : faces) bottom_of_[f] = none;
    return strips_of(slab, bottoms, tops, loops);
  }

  // One loop below and one above each; the lowest number stands for those that are joined.
  std::vector<Wall_strip> strips_of(std::size_t slab, const std::vector<std::vector<Face>>& bottoms,
                                    const std::vector<std::vector<Face>>& tops, Union_find& loops) const {
    std::vector<Wall_strip> strips(bottoms.size());
    std::vector<bool> paired(bottoms.size(), false);
    for (std::size_t i = 0; i < bottoms.size(); ++i)
      if (loops.root(i) != i) report_unpaired(slab, bottoms[i].front());
    for (std::size_t j = 0; j < tops.size(); ++j) {
      const std::size_t bottom = loops.root(bottoms.size() + j);
      if (bottom >= bottoms.size() || paired[bottom]) report_unpaired(slab, tops[j].front());
      paired[bottom] = true;
      strips[bottom] = {bottom, j, {}};
    }
    for (std::size_t i = 0; i < bottoms.size(); ++i)
      if (!paired[i]) report_unpaired(slab, bottoms[i].front());
    return strips;
  }

  [[noreturn]] void report_unpaired(std::size_t slab, Face f) const {
    fail(Status_code::inconsistent_levels, Stage::linking_mesh,
         "between the layers at " + std::to_string(layering_.layers[slab]) + " and " +
             std::to_string(layering_.layers[slab + 1]) + " the linking faces about patch " +
             std::to_string(part_.id(part_.patch(f))) + " do not run from one loop to one loop",
         {part_.id(part_.patch(f))}, place_of(f));
  }

  void find_rails(const Wall_loop& bottom, const Wall_loop& top, std::size_t slab, Wall_strip& strip) const {
    constexpr std::size_t nowhere = std::size_t(-1);
    Key_map<std::size_t> position(nowhere);
    for (std::size_t i = 0; i < top.size(); ++i)
      if (std::size_t& at = position[top.nodes[i].key()]; at == nowhere) at = i;
    for (std::size_t i = 0; i < bottom.size(); ++i) {
      const auto end = climb(bottom.nodes[i], layering_.layers[slab + 1]);
      if (!end) continue;
      const std::size_t found = std::as_const(position)[end->key()];
      if (found != nowhere) strip.rails.push_back({i, found});
    }
    // Rails that change their order about the ring are no columns.
    std::size_t turns = 0;
    for (std::size_t i = 0; i < strip.rails.size(); ++i)
      turns += strip.rails[(i + 1) % strip.rails.size()].top <= strip.rails[i].top;
    if (turns > 1) strip.rails.clear();
  }

  // Follows sharp edges upwards from a node to the value of the next layer.
  std::optional<Surface_location> climb(Surface_location at, double value) const {
    const auto& mesh = part_.mesh;
    Vertex v;
    if (at.kind == Surface_location::Kind::edge) {
      const typename Part_type::Edge e(at.index);
      if (!sharp_[e]) return std::nullopt;
      Halfedge h = mesh.halfedge(e);
      if (parameter(mesh.target(h)) < parameter(mesh.source(h))) h = mesh.opposite(h);
      if (parameter(mesh.target(h)) > value) return crossing(h, value);
      v = mesh.target(h);
    } else {
      v = Vertex(at.index);
    }
    Vec3 heading{};
    while (parameter(v) < value) {
      const Halfedge h = steepest_sharp_edge(v, heading);
      if (!h.is_valid()) return std::nullopt;
      if (parameter(mesh.target(h)) > value) return crossing(h, value);
      heading = unit(part_.coordinates(mesh.target(h)) - part_.coordinates(v));
      v = mesh.target(h);
    }
    return Surface_location::vertex(v);
  }

  // Of the sharp edges that rise from a vertex the one that goes on straightest.
  Halfedge steepest_sharp_edge(Vertex v, const Vec3& heading) const {
    const auto& mesh = part_.mesh;
    Halfedge best;
    double best_score = -2;
    for (Halfedge in : mesh.halfedges_around_target(mesh.halfedge(v))) {
      const Halfedge h = mesh.opposite(in);
      if (!sharp_[mesh.edge(h)] || !(parameter(mesh.target(h)) > parameter(v))) continue;
      const double score = dot(heading, unit(part_.coordinates(mesh.target(h)) - part_.coordinates(v)));
      if (score <= best_score) continue;
      best_score = score;
      best = h;
    }
    return best;
  }

  const Part_type& part_;
  const Roles& roles_;
  const Layering& layering_;
  std::vector<std::vector<Face>> leaving_, arriving_;  // by layer
  std::vector<bool> sharp_;
  std::vector<std::uint32_t> bottom_of_;  // per face: the loop at the bottom of the slab at hand that passes it
  std::vector<bool> is_done_;             // per face, for the layer at hand
  std::vector<int> position_;             // per vertex, among the layers
  Union_find pieces_;                     // of the vertices between two layers
  std::vector<std::uint32_t> loop_at_;    // per piece: a loop that meets it, in the slab at hand
};

}  // namespace internal

/// Meshes the linking faces by rows: traces, on every layer, the closed loops in which the linking faces meet it, and
/// pairs the loops of neighbouring layers over the ring of linking faces between them (sections 2.2 and 2.4).
///
/// Rows sit where the sweep parameter says. Walls with windows, C-shaped walls and walls without a seam need nothing
/// of their own, as between two layers every wall is a ring.
/// \return `inconsistent_levels` or `linking_face_not_mappable` with the patch and the place where the linking faces
/// form no such rings.
/// Complexity: O(n log n) in the faces, each counted once for every layer it reaches across.
template <class Traits>
Result<Wall_sections> make_wall_sections(const Part<Traits>& part, const Roles& roles, const Layering& layering) {
  return internal::guarded([&] { return internal::Wall_tracer<Traits>(part, roles, layering).run(); });
}

}  // namespace CCSweep

#endif
