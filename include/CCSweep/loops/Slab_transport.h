// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_SLAB_TRANSPORT_H
#define CCSWEEP_LOOPS_SLAB_TRANSPORT_H

#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Column_map.h>
#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/loops/Drawn_layer.h>
#include <CCSweep/loops/Imprinted_layer.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/loops/projection.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// A loop of the section as it arrives on the next layer, with the targets its pieces came from.
struct Arriving_loop {
  std::vector<Node_index> nodes;
  std::vector<Wall_loop::Carrier> carriers;
  std::vector<Patch_index> targets;
  std::vector<std::size_t> segments;  ///< of the drawing, by piece
};

/// Carries what goes on above a layer to the next one: wall nodes up their columns, the other nodes by the affine map
/// and the residuals of their barrel's control loops (section 2.6).
template <class Traits, class PointIndex>
class Slab_transport {
 public:
  /// A LoopEdge segment between two targets, at the lower layer.
  struct Cut {
    std::size_t segment;  // of the lower layer
    Node_index a, b;
    Patch_index left, right;
    std::size_t barrel;
    double chord_error;
  };
  using Wall_column = typename Layered_loops<Traits>::Wall_column;

  /// \param is_straight the sweep leads along `up` everywhere
  /// \param is_upright all linking faces stand along it as well, but for the facets of their arcs
  Slab_transport(const Part<Traits>& part, const Vec3& up, bool is_straight, bool is_upright,
                 const std::vector<Wall_loop>& arriving, const std::vector<Wall_strip>& strips,
                 std::vector<Leaving_loop> leaving, const Imprinted_layer<Traits>& imprinted, double tolerance,
                 std::size_t neighbours, Layered_loops<Traits>& loops)
      : part_(part),
        up_(up),
        is_straight_(is_straight),
        is_upright_(is_upright),
        arriving_(arriving),
        leaving_(std::move(leaving)),
        tolerance_(tolerance),
        neighbours_(neighbours),
        loops_(loops) {
    collect_cuts(imprinted);
    for (const Wall_strip& strip : strips) add_columns(strip);
  }

  const std::vector<Cut>& cuts() const { return cuts_; }
  const std::vector<Wall_column>& wall_columns() const { return wall_columns_; }

  /// The node above a node of a barrel.
  Node_index image(std::size_t barrel, Node_index node) const { return image_.at({barrel, node}); }

  /// Makes the nodes of the loop that arrives as number i on the next layer.
  Arriving_loop arriving_loop(std::size_t i, Drawn_layer<Traits>& drawn) {
    const Column_map& map = columns_.at(i);
    const Wall_loop& top = arriving_[i];
    const Leaving_loop& bottom = leaving_[bottom_of_.at(i)];
    std::vector<Node_index> nodes;
    for (const Surface_location& where : top.nodes) nodes.push_back(drawn.node_at(where));
    std::vector<std::vector<std::pair<double, Node_index>>> inserted(top.size());
    std::vector<std::pair<std::size_t, Node_index>> junctions;  // where in the bottom loop, and the node above
    for (std::size_t j : junctions_of(bottom)) {
      const Node_index node = node_on_row(map.above(j), top, nodes, drawn, inserted);
      loops_.nodes[node.value()].loop_vertex |= loops_.node(bottom.nodes[j]).loop_vertex;
      image_.try_emplace({bottom.barrels[j], bottom.nodes[j]}, node);
      wall_columns_.push_back({bottom.nodes[j], node});
      junctions.emplace_back(j, node);
    }
    // Of several junctions that meet in one node the last one about the loop tells what follows it.
    std::map<Node_index, Patch_index> wall_from;
    auto first = std::adjacent_find(junctions.begin(), junctions.end(),
                                    [](const auto& l, const auto& r) { return l.second != r.second; });
    if (first != junctions.end()) std::rotate(junctions.begin(), first + 1, junctions.end());
    for (const auto& [j, node] : junctions) wall_from[node] = bottom.targets[j];
    return label_loop(top, nodes, inserted, wall_from, bottom.targets.front());
  }

  /// Where the images of a cut's ends lie before the imprint moves them.
  const std::array<Vec3, 2>& projected(std::size_t cut) const { return projected_[cut]; }

  /// The loop below an arriving one.
  std::size_t bottom_of(std::size_t arriving) const { return bottom_of_.at(arriving); }
  const Leaving_loop& leaving_loop(std::size_t i) const { return leaving_[i]; }

  /// Makes the nodes above those that lie on no wall.
  void project_interior(Drawn_layer<Traits>& drawn) {
    std::map<std::size_t, Lift> lifts;
    for (const Cut& cut : cuts_)
      for (Node_index node : {cut.a, cut.b}) {
        auto [found, is_new] = image_.try_emplace({cut.barrel, node}, Node_index());
        if (!is_new) continue;
        auto lift = lifts.find(cut.barrel);
        if (lift == lifts.end()) lift = lifts.emplace(cut.barrel, make_lift(cut)).first;
        const Vec3 p = lifted(drawn.coordinates(node), lift->second);
        found->second = drawn.add_node(typename Traits::Point_3(p[0], p[1], p[2]), Surface_location(),
                                       loops_.node(node).loop_vertex);
      }
    for (const Cut& cut : cuts_)
      projected_.push_back({drawn.coordinates(image(cut.barrel, cut.a)), drawn.coordinates(image(cut.barrel, cut.b))});
  }

 private:
  // The control nodes of one barrel on both layers, eq. (1).
  struct Control {
    std::vector<Vec3> from, to;
    std::vector<std::vector<std::size_t>> loops;
  };

  // What takes the nodes of one barrel to the next layer.
  struct Lift {
    std::optional<double> rise;  // of all control nodes along `up`, between upright walls
    std::optional<Layer_projection<Traits, PointIndex>> projection;
  };

  Lift make_lift(const Cut& cut) const {
    const Control& control = control_of(cut);
    Lift lift{common_rise(control), std::nullopt};
    if (!lift.rise) lift.projection = make_projection(control);
    return lift;
  }

  // Where the control nodes all rise alike the affine map says nothing else, and leaves no residuals along `up`.
  std::optional<double> common_rise(const Control& control) const {
    if (!is_upright_) return std::nullopt;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < control.from.size(); ++i) {
      const double rise = dot(up_, control.to[i] - control.from[i]);
      low = std::min(low, rise);
      high = std::max(high, rise);
    }
    if (high - low > 1e-12 * part_.diagonal) return std::nullopt;
    return low + (high - low) / 2;
  }

  // Between upright walls the residuals are but chord errors, which must not move nodes sideways.
  Vec3 lifted(const Vec3& p, const Lift& lift) const {
    if (lift.rise) return p + *lift.rise * up_;
    const Vec3 image = (*lift.projection)(p);
    return is_upright_ ? p + dot(up_, image - p) * up_ : image;
  }

  void collect_cuts(const Imprinted_layer<Traits>& imprinted) {
    for (std::size_t s = 0; s < imprinted.segments().size(); ++s) {
      if (!imprinted.is_cut(s)) continue;
      const auto& segment = imprinted.segments()[s];
      cuts_.push_back({s, segment.a, segment.b, segment.left.target, segment.right.target, imprinted.barrel(s),
                       imprinted.chord_error(s)});
      cut_ends_.insert({cuts_.back().barrel, segment.a});
      cut_ends_.insert({cuts_.back().barrel, segment.b});
    }
  }

  void add_columns(const Wall_strip& strip) {
    const Leaving_loop& bottom = leaving_[strip.bottom];
    std::vector<Vec3> low, high;
    for (Node_index n : bottom.nodes) low.push_back(Part<Traits>::coordinates(loops_.node(n).point));
    for (const Surface_location& where : arriving_[strip.top].nodes) high.push_back(coordinates(part_, where));
    std::vector<Wall_strip::Rail> rails;
    for (const auto& rail : strip.rails) rails.push_back({bottom.position[rail.bottom], rail.top});
    Column_map map(low, high, rails, up_);
    Control& control = controls_[bottom.barrels.front()];
    control.loops.emplace_back();
    for (std::size_t i = 0; i < low.size(); ++i) {
      control.loops.back().push_back(control.from.size());
      control.from.push_back(low[i]);
      control.to.push_back(map.point_above(i));
    }
    for (std::size_t i = 0; i < high.size(); ++i) {
      control.from.push_back(map.point_below(i));
      control.to.push_back(high[i]);
    }
    bottom_of_[strip.top] = strip.bottom;
    columns_.emplace(strip.top, std::move(map));
  }

  // Where along a loop the target below changes, or a cut meets the wall.
  std::vector<std::size_t> junctions_of(const Leaving_loop& loop) const {
    std::vector<std::size_t> result;
    const std::size_t n = loop.nodes.size();
    for (std::size_t j = 0; j < n; ++j)
      if (loop.targets[(j + n - 1) % n] != loop.targets[j] || cut_ends_.count({loop.barrels[j], loop.nodes[j]}))
        result.push_back(j);
    return result;
  }

  // The node at a place of a row: one of its own where that is within the tolerance or the reach, else a new
  // one.
  Node_index node_on_row(const Loop_place& place, const Wall_loop& row, const std::vector<Node_index>& nodes,
                         Drawn_layer<Traits>& drawn,
                         std::vector<std::vector<std::pair<double, Node_index>>>& inserted) {
    const Node_index a = nodes[place.index], b = nodes[(place.index + 1) % nodes.size()];
    const double length = norm(drawn.coordinates(b) - drawn.coordinates(a));
    const double near = std::min(std::max(tolerance_, loops_.reach), length / 3);
    if (place.fraction * length <= near) return a;
    if ((1 - place.fraction) * length <= near) return b;
    for (const auto& [fraction, node] : inserted[place.index])
      if (std::abs(fraction - place.fraction) * length <= near) return node;
    const Wall_loop::Carrier& carrier = row.carriers[place.index];
    Surface_location where = Surface_location::face(carrier.index);
    auto point = point_between(loops_.node(a).point, loops_.node(b).point, place.fraction);
    if (carrier.is_edge) {
      const typename Part<Traits>::Edge e(carrier.index);
      const bool forward = fraction_on_edge(part_, e, loops_.node(a).where) == 0;
      where = Surface_location::edge(carrier.index, forward ? place.fraction : 1 - place.fraction);
      point = point_on_edge(part_, e, where.t);
    }
    const Node_index node = drawn.add_node(point, where, false);
    inserted[place.index].push_back({place.fraction, node});
    drawn.insert_on_carrier(carrier, node);
    return node;
  }

  static Arriving_loop label_loop(const Wall_loop& row, const std::vector<Node_index>& nodes,
                                  std::vector<std::vector<std::pair<double, Node_index>>>& inserted,
                                  const std::map<Node_index, Patch_index>& wall_from, Patch_index only) {
    Arriving_loop loop;
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::sort(inserted[i].begin(), inserted[i].end());
      loop.nodes.push_back(nodes[i]);
      for (const auto& [fraction, node] : inserted[i]) loop.nodes.push_back(node);
      loop.carriers.resize(loop.nodes.size(), row.carriers[i]);
    }
    const std::size_t n = loop.nodes.size();
    loop.targets.assign(n, only);
    if (wall_from.empty()) return loop;
    std::size_t first = 0;
    while (!wall_from.count(loop.nodes[first])) ++first;
    Patch_index target;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (first + k) % n;
      if (auto found = wall_from.find(loop.nodes[i]); found != wall_from.end()) target = found->second;
      loop.targets[i] = target;
    }
    return loop;
  }

  const Control& control_of(const Cut& cut) const {
    const auto found = controls_.find(cut.barrel);
    if (found == controls_.end()) {
      const int id = part_.id(cut.left);
      fail(Status_code::inconsistent_levels, Stage::control_loops,
           "a piece of the section above target " + std::to_string(id) + " is bounded by no linking face", {id},
           Part<Traits>::coordinates(loops_.node(cut.a).point));
    }
    return found->second;
  }

  Layer_projection<Traits, PointIndex> make_projection(const Control& control) const {
    std::optional<Vec3> direction;  // a straight sweep has one, and the loops of bent caps would lean it
    if (is_straight_) direction = up_;
    auto projection = Layer_projection<Traits, PointIndex>::make(control.from, control.to, control.loops, neighbours_,
                                                                 direction);
    if (!projection) throw Failure{projection.status()};
    return std::move(projection).value();
  }

  const Part<Traits>& part_;
  Vec3 up_;
  bool is_straight_, is_upright_;
  const std::vector<Wall_loop>& arriving_;
  std::vector<Leaving_loop> leaving_;
  double tolerance_;
  std::size_t neighbours_;
  Layered_loops<Traits>& loops_;
  std::vector<Cut> cuts_;
  std::vector<std::array<Vec3, 2>> projected_;  // by cut
  std::set<std::pair<std::size_t, Node_index>> cut_ends_;
  std::map<std::size_t, Column_map> columns_;         // by arriving loop
  std::map<std::size_t, std::size_t> bottom_of_;      // by arriving loop
  std::map<std::size_t, Control> controls_;           // by barrel
  std::map<std::pair<std::size_t, Node_index>, Node_index> image_;
  std::vector<Wall_column> wall_columns_;
};

}  // namespace CCSweep::internal

#endif
