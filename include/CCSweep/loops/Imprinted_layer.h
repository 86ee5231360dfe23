// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_IMPRINTED_LAYER_H
#define CCSWEEP_LOOPS_IMPRINTED_LAYER_H

#include <CCSweep/internal/Key_map.h>
#include <CCSweep/internal/Union_find.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/loops/Drawn_layer.h>
#include <CCSweep/loops/Layer_chart.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/loops/imprint.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/drop_to_patch.h>

#include <algorithm>
#include <optional>
#include <ranges>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// A loop of the section that goes on upwards, with the target each piece of it came from.
struct Leaving_loop {
  std::vector<Node_index> nodes;
  std::vector<Wall_loop::Carrier> carriers;  ///< by piece
  std::vector<Patch_index> targets;          ///< by piece: the target below the material on its left
  std::vector<std::size_t> barrels;          ///< by piece
  std::vector<std::size_t> position;         ///< where node i of the linking mesh's loop stands in `nodes`

  void reserve(std::size_t size) {
    nodes.reserve(size);
    carriers.reserve(size);
    targets.reserve(size);
    barrels.reserve(size);
    position.reserve(size);
  }
};

/// A layer after its imprint, in the nodes of the whole sweep.
template <class Traits>
class Imprinted_layer {
 public:
  using Loops = Layered_loops<Traits>;
  using Segment = typename Loops::Segment;
  using Side = typename Loops::Side;
  using Carrier = Wall_loop::Carrier;

  Imprinted_layer(const Part<Traits>& part, const Layer_chart<Traits>& chart, const Drawn_layer<Traits>& drawn,
                  const Imprint<Traits>& imprint, Loops& loops)
      : part_(part), chart_(chart), drawn_(drawn), imprint_(imprint), pieces_(imprint.segments()), loops_(loops) {
    place_nodes_on_carriers();
    make_segments();
    place_nodes_under_sources();
    find_barrels();
    carry_chord_errors();
  }

  const std::vector<Segment>& segments() const { return segments_; }

  /// The nodes that a segment of the drawing passes through after the imprint.
  auto chain(std::size_t drawn_segment) const {
    return std::views::transform(imprint_.chains[drawn_segment], [this](Node_index n) { return node_of_[n.value()]; });
  }

  /// The node that a node of the drawing was merged into.
  Node_index final_node(Node_index node) const {
    return node_of_[imprint_.representative.at(drawn_.drawn_node(node).value()).value()];
  }

  /// Material above on both sides, from different targets: a cut goes up from here.
  bool is_cut(std::size_t segment) const {
    const Segment& s = segments_[segment];
    return s.left.material_above() && s.right.material_above() && s.left.target != s.right.target;
  }
  double chord_error(std::size_t segment) const { return chord_error_[segment]; }
  std::size_t barrel(std::size_t segment) const { return barrel_[segment]; }

  /// Under every source there is material, once all targets have been pushed up; what is left of a source alone is
  /// the earliest sign of a wrong role, level or projection.
  void check_sources(double value) const {
    for (const Segment& s : segments_)
      for (const Side& side : {s.left, s.right}) {
        if (!side.source.is_valid() || side.target.is_valid()) continue;
        const int id = part_.id(side.source);
        fail(Status_code::inconsistent_levels, Stage::imprint,
             "at " + std::to_string(value) + " there is no material under a part of source " + std::to_string(id),
             {id}, drawn_.coordinates(s.a));
      }
  }

  /// The loops of the linking mesh that leave the layer, with the imprint's nodes and labels.
  std::vector<Leaving_loop> leaving_loops(const std::vector<Wall_loop>& rows, Drawn_layer<Traits>& drawn,
                                          double value) const {
    std::vector<Leaving_loop> result;
    std::vector<Node_index> nodes;
    for (const Wall_loop& row : rows) {
      Leaving_loop loop;
      loop.reserve(row.size());
      for (std::size_t i = 0; i < row.size(); ++i) {
        loop.position.push_back(loop.nodes.size());
        add_pieces(row.carriers[i], drawn.node_at(row.nodes[i]), value, nodes, loop);
      }
      result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  // Nodes that the imprint put on fixed segments lie on the part's edges and rows, exactly.
  void place_nodes_on_carriers() {
    node_of_.assign(imprint_.points.size(), Node_index());
    const auto& local = drawn_.nodes();
    for (std::size_t i = 0; i < local.size(); ++i)
      if (imprint_.representative[i] == Node_index(i)) node_of_[i] = local[i];
    for (std::size_t i = 0; i < local.size(); ++i) {
      const Node_index to = node_of_[imprint_.representative[i].value()];
      auto& kept = loops_.nodes[to.value()];
      kept.loop_vertex = kept.loop_vertex || loops_.node(local[i]).loop_vertex;
    }
    const auto& segments = drawn_.drawing().segments;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      if (!segments[s].fixed) continue;
      const auto& chain = imprint_.chains[s];
      for (std::size_t i = 1; i + 1 < chain.size(); ++i) place_between(chain[i], chain.front(), chain.back(), s);
    }
    for (std::size_t i = 0; i < node_of_.size(); ++i)
      if (!node_of_[i].is_valid() && is_representative(i)) node_of_[i] = add_interior_node(i);
  }

  bool is_representative(std::size_t i) const {
    return i >= imprint_.representative.size() || imprint_.representative[i] == Node_index(i);
  }

  Node_index add_interior_node(std::size_t i) const {
    fail(Status_code::imprint_failed, Stage::imprint, "two cuts cross between their targets' boundaries", {},
         std::array<double, 3>{CGAL::to_double(imprint_.points[i].x()), CGAL::to_double(imprint_.points[i].y()), 0});
  }

  void place_between(Node_index n, Node_index from, Node_index to, std::size_t s) {
    Node_index& node = node_of_[n.value()];
    if (node.is_valid() && loops_.node(node).where.on_surface()) return;
    const double f = fraction(imprint_.points[n.value()], imprint_.points[from.value()], imprint_.points[to.value()]);
    const auto &a = loops_.node(node_of_[from.value()]), &b = loops_.node(node_of_[to.value()]);
    const Carrier& carrier = drawn_.origin(s).carrier;
    Surface_location where = Surface_location::face(carrier.index);
    auto point = point_between(a.point, b.point, f);
    if (carrier.is_edge) {
      const typename Part<Traits>::Edge e(carrier.index);
      const double ta = fraction_on_edge(part_, e, a.where), tb = fraction_on_edge(part_, e, b.where);
      where = Surface_location::edge(carrier.index, ta + f * (tb - ta));
      point = point_on_edge(part_, e, where.t);
    }
    if (!node.is_valid()) {
      loops_.nodes.push_back({point, where, true});
      node = Node_index(loops_.nodes.size() - 1);
    } else {
      loops_.nodes[node.value()].point = point;
      loops_.nodes[node.value()].where = where;
    }
  }

  template <class Point_2>
  static double fraction(const Point_2& p, const Point_2& a, const Point_2& b) {
    const double wx = CGAL::to_double(b.x() - a.x()), wy = CGAL::to_double(b.y() - a.y());
    const double f = (CGAL::to_double(p.x() - a.x()) * wx + CGAL::to_double(p.y() - a.y()) * wy) / (wx * wx + wy * wy);
    return std::clamp(f, 0.0, 1.0);
  }

  static Side side(const Loop_label& label) {
    Side s;
    if (label.source != Loop_label::none) s.source = Patch_index(label.source);
    if (label.target != Loop_label::none) s.target = Patch_index(label.target);
    return s;
  }

  void make_segments() {
    std::vector<int> degree(node_of_.size(), 0);
    segments_.reserve(pieces_.size());
    for (const auto& piece : pieces_) {
      const Node_index a = node_of_[piece.source.value()], b = node_of_[piece.target.value()];
      segment_between_[pair_key(a, b)] = segments_.size();
      segments_.push_back({a, b, side(piece.left), side(piece.right)});
      ++degree[piece.source.value()];
      ++degree[piece.target.value()];
    }
    for (std::size_t i = 0; i < degree.size(); ++i)
      if (degree[i] > 2) loops_.nodes[node_of_[i].value()].loop_vertex = true;
  }

  // A node that stops inside a source lies on it from now on.
  void place_nodes_under_sources() {
    for (const Segment& s : segments_) {
      if (!s.left.source.is_valid() || s.left.source != s.right.source) continue;
      for (Node_index n : {s.a, s.b}) {
        auto& node = loops_.nodes[n.value()];
        if (node.where.on_surface()) continue;
        const auto dropped = drop_to_patch(part_, s.left.source, node.point, chart_.up());
        if (!dropped)
          fail(Status_code::cut_failed, Stage::imprint,
               "a node does not come to lie on source " + std::to_string(part_.id(s.left.source)),
               {part_.id(s.left.source)}, drawn_.coordinates(n));
        node.point = dropped->point;
        node.where = dropped->where;
      }
    }
  }

  // LoopFaces that go on upwards and touch along an edge move as one body: a barrel.
  void find_barrels() {
    Union_find faces(imprint_.graph.number_of_loop_faces());
    barrel_.reserve(segments_.size());
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      const auto& piece = pieces_[s];
      if (!segments_[s].left.material_above() || !segments_[s].right.material_above()) continue;
      faces.join(piece.left_face.value(), piece.right_face.value());
    }
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      const auto& piece = pieces_[s];
      barrel_.push_back(segments_[s].left.material_above()    ? faces.root(piece.left_face.value())
                        : segments_[s].right.material_above() ? faces.root(piece.right_face.value())
                                                              : std::size_t(-1));
    }
  }

  void carry_chord_errors() {
    chord_error_.assign(segments_.size(), 0);
    const auto& segments = drawn_.drawing().segments;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      if (segments[s].chord_error == 0) continue;
      const auto nodes = chain(s);
      for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        if (const std::size_t found = segment_between(nodes[i], nodes[i + 1]); found != no_segment)
          chord_error_[found] = std::max(chord_error_[found], segments[s].chord_error);
    }
  }

  static constexpr std::size_t no_segment = std::size_t(-1);
  std::size_t segment_between(Node_index a, Node_index b) const { return segment_between_[pair_key(a, b)]; }

  // `nodes` is room for the nodes along the carrier.
  void add_pieces(const Carrier& carrier, Node_index from, double value, std::vector<Node_index>& nodes,
                  Leaving_loop& loop) const {
    nodes.clear();
    drawn_.for_each_along(carrier, [&](std::size_t s) {
      for (Node_index n : chain(s))
        if (nodes.empty() || nodes.back() != n) nodes.push_back(n);
    });
    if (nodes.empty()) report_loose_wall(carrier, from, value);
    if (nodes.front() != final_node(from)) std::reverse(nodes.begin(), nodes.end());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      const std::size_t found = segment_between(nodes[i], nodes[i + 1]);
      if (found == no_segment) report_loose_wall(carrier, nodes[i], value);
      const Segment& s = segments_[found];
      const Side &inside = s.a == nodes[i] ? s.left : s.right, &outside = s.a == nodes[i] ? s.right : s.left;
      if (!inside.material_above() || outside.material_above()) report_loose_wall(carrier, nodes[i], value);
      loop.nodes.push_back(nodes[i]);
      loop.carriers.push_back(carrier);
      loop.targets.push_back(inside.target);
      loop.barrels.push_back(barrel_[found]);
    }
  }

  [[noreturn]] void report_loose_wall(const Carrier& carrier, Node_index node, double value) const {
    using Face = typename Part<Traits>::Face;
    using Edge = typename Part<Traits>::Edge;
    const auto& mesh = part_.mesh;
    std::set<int> ids;
    if (carrier.is_edge) {
      const auto h = mesh.halfedge(Edge(carrier.index));
      ids = {part_.id(part_.patch(mesh.face(h))), part_.id(part_.patch(mesh.face(mesh.opposite(h))))};
    } else {
      ids = {part_.id(part_.patch(Face(carrier.index)))};
    }
    std::string names;
    for (int id : ids) names += (names.empty() ? "" : " and ") + std::to_string(id);
    fail(Status_code::inconsistent_levels, Stage::control_loops,
         "at " + std::to_string(value) + " the section of the part does not go on along patch " + names,
         {ids.begin(), ids.end()}, drawn_.coordinates(node));
  }

  const Part<Traits>& part_;
  const Layer_chart<Traits>& chart_;
  const Drawn_layer<Traits>& drawn_;
  const Imprint<Traits>& imprint_;
  const std::vector<typename Imprint<Traits>::Segment> pieces_;
  Loops& loops_;
  std::vector<Node_index> node_of_;           // of the sweep, by node of the imprint
  std::vector<Segment> segments_;
  Key_map<std::size_t> segment_between_{no_segment};  // by the key of its ends
  std::vector<std::size_t> barrel_;
  std::vector<double> chord_error_;
};

}  // namespace CCSweep::internal

#endif
