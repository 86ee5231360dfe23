// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_RANDOM_PARTS_SURFACE_H
#define CCSWEEP_TEST_RANDOM_PARTS_SURFACE_H

#include "random_parts_solid.h"

// The surface of the union of all columns: it is gathered from elementary faces (cells, and cell edges times the slabs
// between all heights), merged into flat pieces, and each piece is triangulated anew from its own corners, so that the
// mesh shows nothing of the overlay.
namespace random_parts::solid {

/// A place of the overlay at a height.
struct Node {
  int vertex, height;
  auto operator<=>(const Node&) const = default;
};

/// An elementary face, its corners counter-clockwise from outside.
struct Face {
  enum Kind { bottom, top, wall } kind;
  int cell;   ///< on whose material it lies
  int slab;   ///< the slab of that material
  int label;  ///< of a cap
  std::vector<Node> corners;
  int column = 0;  ///< of the cell
};

/// The surface of the columns.
class Surface {
 public:
  explicit Surface(Columns& columns) : columns_(columns) {
    add_caps();
    add_walls();
    pair_edges();
    group();
  }

  /// The mesh with its patches; nothing where two sheets of one flat piece would have to be told apart, or where the
  /// solid touches itself inside one.
  std::optional<Part> part();

 private:
  struct Edge {
    int face, corner;  ///< from that corner to the next
  };

  void add_caps();
  void add_walls();
  void pair_edges();
  void pair(const std::vector<Edge>& edges);
  int wedge(const Edge& edge, const Node& a, const Node& b) const;
  void group();
  void keep_contacts(const std::vector<std::vector<Node>>& ends);
  bool is_flat_across(const Face& f, const Face& g) const;
  bool triangulate(const std::vector<int>& faces, Part& part, std::map<int, std::size_t>& used) const;
  std::map<int, int> outline(const std::vector<int>& faces) const;
  Point flat(const Face& face, const Node& node) const;

  Vector direction(const Face& wall) const {
    return columns_.point(wall.corners[1].vertex) - columns_.point(wall.corners[0].vertex);
  }
  int corner_class(int face, int corner) const {
    return classes_.find(first_corner_[face] + corner % static_cast<int>(faces_[face].corners.size()));
  }
  int next(const Edge& e) const { return (e.corner + 1) % static_cast<int>(faces_[e.face].corners.size()); }

  Columns& columns_;
  std::vector<Face> faces_;
  std::vector<int> first_corner_;
  std::vector<std::pair<Edge, Edge>> pairs_;
  mutable Groups classes_, pieces_, patches_;  ///< of corners: vertices; of faces: flat pieces and patches
  std::vector<char> kept_;                     ///< by the leader of a corner class
  std::vector<Node> place_;                    ///< of a corner
  bool touches_ = false;
  bool is_sound_ = true;
};

inline void Surface::add_caps() {
  for (auto f : columns_.overlay().finite_face_handles()) {
    const auto& stack = columns_.of(f->info());
    const int v[3] = {f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()};
    for (int i = 0; i < static_cast<int>(stack.size()); ++i) {
      const Column& c = stack[i];
      faces_.push_back({Face::bottom, f->info(), c.low, c.low_label, {{v[0], c.low}, {v[2], c.low}, {v[1], c.low}}, i});
      faces_.push_back(
          {Face::top, f->info(), c.high - 1, c.high_label, {{v[0], c.high}, {v[1], c.high}, {v[2], c.high}}, i});
    }
  }
}

inline void Surface::add_walls() {
  for (auto f : columns_.overlay().finite_face_handles())
    for (int i = 0; i < 3; ++i) {
      const int a = f->vertex(Overlay::ccw(i))->info(), b = f->vertex(Overlay::cw(i))->info();
      const int beside = f->neighbor(i)->info();
      for (int k = 0; k + 1 < static_cast<int>(columns_.heights().size()); ++k)
        if (columns_.at(f->info(), k) && !columns_.at(beside, k))
          faces_.push_back({Face::wall, f->info(), k, -1, {{a, k}, {b, k}, {b, k + 1}, {a, k + 1}}});
    }
}

/// Which faces belong together where more than two meet: those on the same material.
inline int Surface::wedge(const Edge& edge, const Node& a, const Node& b) const {
  const Face& face = faces_[edge.face];
  if (a.vertex != b.vertex)  // a level edge: the cell on the upper or the lower side
    return 1000 * face.cell + face.slab;
  const Overlay& overlay = columns_.overlay();
  auto v = std::find_if(overlay.finite_vertex_handles().begin(), overlay.finite_vertex_handles().end(),
                        [&](auto handle) { return handle->info() == a.vertex; });
  auto f = overlay.incident_faces(*v);
  while (f->info() != face.cell) ++f;
  while (columns_.at(f->info(), face.slab)) --f;  // to the air before this material, which exists on an edge of air
  return (++f)->info();
}

inline void Surface::pair(const std::vector<Edge>& edges) {
  if (edges.size() == 2) {
    pairs_.emplace_back(edges[0], edges[1]);
    return;
  }
  touches_ = true;
  std::map<int, std::vector<Edge>> wedges;
  for (const Edge& e : edges) {
    const Face& face = faces_[e.face];
    wedges[wedge(e, face.corners[e.corner], face.corners[next(e)])].push_back(e);
  }
  for (const auto& [id, two] : wedges) pairs_.emplace_back(two.at(0), two.at(1));
}

inline void Surface::pair_edges() {
  std::map<std::pair<Node, Node>, std::vector<Edge>> edges;
  for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
    first_corner_.push_back(static_cast<int>(place_.size()));
    for (int k = 0; k < static_cast<int>(faces_[f].corners.size()); ++k) {
      place_.push_back(faces_[f].corners[k]);
      edges[std::minmax(faces_[f].corners[k], faces_[f].corners[next({f, k})])].push_back({f, k});
    }
  }
  for (const auto& [nodes, incident] : edges) pair(incident);
  classes_ = Groups(place_.size());
  for (const auto& [e, g] : pairs_) {
    classes_.unite(first_corner_[e.face] + e.corner, first_corner_[g.face] + next(g));
    classes_.unite(first_corner_[e.face] + next(e), first_corner_[g.face] + g.corner);
  }
}

inline bool Surface::is_flat_across(const Face& f, const Face& g) const {
  if (f.kind != g.kind) return false;
  if (f.kind != Face::wall) return f.corners[0].height == g.corners[0].height && f.label == g.label;
  const Vector a = direction(f), b = direction(g);
  return CGAL::determinant(a, b) == 0 && a * b > 0;
}

/// Flat pieces, patches, and the vertices that the mesh keeps: those where three pieces meet or an outline bends.
inline void Surface::group() {
  pieces_ = patches_ = Groups(faces_.size());
  for (const auto& [e, g] : pairs_) {
    const Face &f = faces_[e.face], &h = faces_[g.face];
    const bool flat = is_flat_across(f, h);
    if (flat) pieces_.unite(e.face, g.face);
    const bool upright = f.corners[e.corner].vertex == f.corners[next(e)].vertex;
    if (flat ||
        (upright && f.kind == Face::wall && h.kind == Face::wall && turn(direction(f), direction(h)) < smooth_turn))
      patches_.unite(e.face, g.face);
  }
  std::vector<std::set<int>> around(place_.size());
  std::vector<std::vector<Node>> ends(place_.size());
  for (const auto& [e, g] : pairs_) {
    if (pieces_.find(e.face) == pieces_.find(g.face)) continue;
    const int a = corner_class(e.face, e.corner), b = corner_class(e.face, e.corner + 1);
    for (int c : {a, b}) around[c].insert({pieces_.find(e.face), pieces_.find(g.face)});
    ends[a].push_back(place_[b]);
    ends[b].push_back(place_[a]);
  }
  kept_.resize(place_.size());
  for (std::size_t c = 0; c < place_.size(); ++c) {
    if (ends[c].empty()) continue;
    kept_[c] = around[c].size() > 2 || ends[c].size() != 2 ||
               (ends[c][0].height == ends[c][1].height &&
                !CGAL::collinear(columns_.point(ends[c][0].vertex), columns_.point(place_[c].vertex),
                                 columns_.point(ends[c][1].vertex)));
  }
  keep_contacts(ends);
}

/// Where the solid touches itself, both sides keep the same vertices, so that they meet in whole edges. That can't
/// be where one side is the inside of a flat piece.
inline void Surface::keep_contacts(const std::vector<std::vector<Node>>& ends) {
  std::set<Node> kept_places;
  for (std::size_t c = 0; c < place_.size(); ++c)
    if (kept_[c]) kept_places.insert(place_[c]);
  for (std::size_t c = 0; c < place_.size(); ++c) {
    if (classes_.find(static_cast<int>(c)) != static_cast<int>(c) || kept_[c] || !kept_places.count(place_[c]))
      continue;
    if (ends[c].empty())
      is_sound_ = false;
    else
      kept_[c] = true;
  }
}

/// The boundary of a flat piece: from each vertex that is kept to the next, as seen by outgoing edges. A vertex that
/// the boundary passes twice has several; the pairs are returned by edge number, which is all the triangulation needs.
inline std::map<int, int> Surface::outline(const std::vector<int>& faces) const {
  std::map<int, int> successor, result;  // of corners, then of kept corners
  std::set<std::pair<int, int>> inner;
  for (int f : faces)
    for (int k = 0; k < static_cast<int>(faces_[f].corners.size()); ++k)
      inner.insert({corner_class(f, k), corner_class(f, k + 1)});
  for (int f : faces)
    for (int k = 0; k < static_cast<int>(faces_[f].corners.size()); ++k) {
      const int a = corner_class(f, k), b = corner_class(f, k + 1);
      if (inner.count({b, a})) continue;
      if (kept_[a])
        result[first_corner_[f] + k] = b;
      else
        successor[a] = b;
    }
  for (auto& [from, to] : result)
    while (!kept_[to]) to = successor.at(to);
  return result;
}

inline Point Surface::flat(const Face& face, const Node& node) const {
  const Point& p = columns_.point(node.vertex);
  if (face.kind == Face::top) return p;
  if (face.kind == Face::bottom) return {-p.x(), p.y()};
  const Vector d = direction(face);
  const bool along_x = CGAL::abs(d.x()) > CGAL::abs(d.y());
  const Kernel::FT s = along_x ? p.x() : p.y();
  return {(along_x ? d.x() : d.y()) > 0 ? s : Kernel::FT(-s), Kernel::FT(columns_.heights()[node.height])};
}

inline bool Surface::triangulate(const std::vector<int>& faces, Part& part, std::map<int, std::size_t>& used) const {
  Overlay piece;
  for (const auto& [corner, to] : outline(faces)) {
    const int from = classes_.find(corner);
    std::array<Overlay::Vertex_handle, 2> ends;
    for (int i : {0, 1}) {
      const int id = i == 0 ? from : to;
      const std::size_t before = piece.number_of_vertices();
      ends[i] = piece.insert(flat(faces_[faces[0]], place_[id]));
      if (piece.number_of_vertices() > before) ends[i]->info() = id;
      if (ends[i]->info() != id) return false;  // two vertices of one piece at one place
    }
    piece.insert_constraint(ends[0], ends[1]);
  }
  for (auto f : piece.all_face_handles()) f->info() = -1;
  std::vector<Overlay::Face_handle> todo{piece.infinite_face()}, later;
  for (int level = 0; !todo.empty(); ++level, todo.swap(later), later.clear())
    while (!todo.empty()) {
      auto f = todo.back();
      todo.pop_back();
      if (f->info() != -1) continue;
      f->info() = level;
      for (int i = 0; i < 3; ++i) (f->is_constrained(i) ? later : todo).push_back(f->neighbor(i));
    }
  for (auto f : piece.finite_face_handles()) {
    if (f->info() % 2 == 0) continue;
    std::array<std::size_t, 3> t;
    for (int i = 0; i < 3; ++i) {
      const int id = f->vertex(i)->info();
      t[i] = used.try_emplace(id, used.size()).first->second;
      if (t[i] == part.points.size()) {
        const Point& p = columns_.point(place_[id].vertex);
        part.points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), columns_.heights()[place_[id].height]});
      }
    }
    part.triangles.push_back(t);
  }
  return true;
}

inline std::optional<Part> Surface::part() {
  if (!is_sound_) return std::nullopt;
  Part part;
  std::map<int, std::vector<int>> pieces;
  std::map<int, int> id;  // by the leading face of a patch
  for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
    pieces[pieces_.find(f)].push_back(f);
    id.try_emplace(patches_.find(f), static_cast<int>(id.size()));
    if (pieces_.find(f) != patches_.find(f)) part.curved.insert(id[patches_.find(f)]);
  }
  std::map<int, std::size_t> used;
  for (const auto& [leader, faces] : pieces) {
    if (!triangulate(faces, part, used)) return std::nullopt;
    part.patch.resize(part.triangles.size(), id[patches_.find(leader)]);
  }
  for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
    const Face& face = faces_[f];
    Column* column = face.kind == Face::wall ? nullptr : &columns_.of(face.cell)[face.column];
    if (face.kind == Face::bottom) column->low_patch = id[patches_.find(f)];
    if (face.kind == Face::top) column->high_patch = id[patches_.find(f)];
  }
  part.touches_itself = touches_;
  return part;
}

}  // namespace random_parts::solid

#endif
