// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_SWEEP_LAYERS_H
#define CCSWEEP_LOOPS_SWEEP_LAYERS_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/Key_map.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Layering.h>
#include <CCSweep/linking/Wall_sections.h>
#include <CCSweep/loops/Drawn_layer.h>
#include <CCSweep/loops/Imprinted_layer.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/loops/Slab_transport.h>
#include <CCSweep/loops/imprint.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/visitor.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

template <class Traits, class SegmentIndex, class PointIndex, class Visitor>
class Layer_sweeper {
  static_assert(SweepVisitorOf<Visitor, Layer_drawing<Traits>, Loop_face_graph<Traits>>);

 public:
  Layer_sweeper(const Part<Traits>& part, const Roles& roles, const Layering& layering, const Wall_sections& sections,
                double tolerance, double reach, std::size_t neighbours, Visitor& visitor)
      : part_(part),
        roles_(roles),
        layering_(layering),
        sections_(sections),
        tolerance_(tolerance),
        neighbours_(neighbours),
        visitor_(visitor) {
    loops_.reach = reach;
    loops_.is_upright = all_walls_upright();
  }

  Layered_loops<Traits> run() {
    const std::size_t n = layering_.number_of_layers();
    for (std::size_t k = 0; k < n; ++k) loops_.up.push_back(direction_at(k));
    loops_.segments.resize(n);
    loops_.cuts.resize(n);
    loops_.wall_columns.resize(n);
    loops_.rings.resize(n);
    visitor_.begin(Stage::imprint, n);
    for (std::size_t k = 0; k < n; ++k) {
      if (visitor_.cancel()) fail(Status_code::cancelled, Stage::imprint, "cancelled");
      process_layer(Layer_index(k));
      visitor_.step(Stage::imprint);
    }
    visitor_.end(Stage::imprint);
    return std::move(loops_);
  }

 private:
  // The facets of a cylinder lean by a chord error when top and foot have different nodes, to all sides alike, and all
  // inward where the top has fewer. A draft shows in their mean, a leaning cylinder in the correlation of lean and
  // facing.
  bool all_walls_upright() const {
    if (!roles_.is_straight()) return false;
    for (std::size_t p = 0; p < part_.number_of_patches(); ++p) {
      if (roles_.of_patch[p] != Role::linking) continue;
      double area = 0, lean = 0;
      Vec3 facing{};
      for (auto f : part_.facing(Patch_index(p))) {
        const double c = dot(part_.normal[f], roles_.direction);
        area += part_.area[f];
        lean += part_.area[f] * c;
        facing = facing + part_.area[f] * c * (part_.normal[f] - c * roles_.direction);
      }
      const double most = std::max(1e-9, part_.planar[p] ? 0 : lean_of_facets(p));
      if (std::abs(lean) > most * area || norm(facing) > most * area) return false;
    }
    return true;
  }

  // How much a patch along the sweep may lean as its upper and lower curves have other nodes: by their chord errors
  // over its height.
  double lean_of_facets(std::size_t patch) const {
    const auto& mesh = part_.mesh;
    double chord_error = 0, low = std::numeric_limits<double>::infinity(), high = -low;
    for (auto f : part_.faces[patch])
      for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
        const double height = dot(part_.coordinates(mesh.target(h)), roles_.direction);
        low = std::min(low, height);
        high = std::max(high, height);
        chord_error = std::max(chord_error, part_.chord_error[mesh.edge(h)]);
      }
    return chord_error / (high - low);
  }

  // Across a bent sweep a layer faces where its loops do: along the sum of their pseudo-areas.
  std::array<double, 3> direction_at(std::size_t layer) const {
    if (roles_.is_straight()) return roles_.direction;
    Vec3 sum{};
    for (const auto* loops : {&sections_.arriving[layer], &sections_.leaving[layer]})
      for (const Wall_loop& loop : *loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
          sum = sum + cross(coordinates(part_, loop.nodes[i]), coordinates(part_, loop.nodes[(i + 1) % loop.size()]));
    return unit(sum);
  }

  // Step 5 of the outline in section 2, for one layer.
  void process_layer(Layer_index layer) {
    const Layer_chart<Traits> chart(loops_.up[layer.value()]);
    Drawn_layer<Traits> drawn(part_, chart, loops_);
    draw_arriving_loops(layer, drawn);
    draw_projected_cuts(drawn);
    draw_caps(layer, drawn);
    visitor_.drawn(layer.value(), drawn.drawing(), part_.patch_id);
    Result<Imprint<Traits>> imprint = imprint_layer<Traits, SegmentIndex>(drawn.drawing(), tolerance_);
    if (!imprint) fail_on_part(imprint.status(), layer, drawn);
    if (layering_.level(layer).is_valid()) visitor_.imprinted(layer.value(), imprint.value().graph);
    note(layer, imprint.value());
    Imprinted_layer<Traits> imprinted(part_, chart, drawn, imprint.value(), loops_);
    imprinted.check_sources(layering_.value(layer));
    record(layer, drawn, imprinted);
    if (layer.value() + 1 < layering_.number_of_layers()) transport_to_next(layer, drawn, imprinted);
  }

  void draw_arriving_loops(Layer_index layer, Drawn_layer<Traits>& drawn) {
    if (layer.value() == 0) return;
    arriving_.clear();
    const auto& loops = sections_.arriving[layer.value()];
    for (std::size_t i = 0; i < loops.size(); ++i)
      arriving_.push_back(transport_->arriving_loop(i, drawn));
    transport_->project_interior(drawn);
    for (auto& loop : arriving_)
      for (std::size_t i = 0; i < loop.nodes.size(); ++i) {
        const Node_index a = loop.nodes[i], b = loop.nodes[(i + 1) % loop.nodes.size()];
        loop.segments.push_back(
            drawn.draw_row_piece(loop.carriers[i], a, b, target_label(loop.targets[i]), Loop_label()));
        if (loop.carriers[i].is_edge)
          loops_.wall_labels.push_back({a, b, loop.carriers[i].index, false, loop.targets[i]});
      }
  }

  void draw_projected_cuts(Drawn_layer<Traits>& drawn) {
    if (!transport_) return;
    for (std::size_t c = 0; c < transport_->cuts().size(); ++c) {
      const auto& cut = transport_->cuts()[c];
      drawn.draw_free(c, transport_->image(cut.barrel, cut.a), transport_->image(cut.barrel, cut.b),
                      target_label(cut.left), target_label(cut.right), cut.chord_error);
    }
  }

  // Targets turn counter-clockwise in the chart; sources are reversed to turn the same way (section 2.5).
  void draw_caps(Layer_index layer, Drawn_layer<Traits>& drawn) {
    const Level_index level = layering_.level(layer);
    if (!level.is_valid()) return;
    const auto& mesh = part_.mesh;
    for (Patch_index cap : layering_.caps[level.value()]) {
      const bool is_source = roles_.of_patch[cap.value()] == Role::source;
      Loop_label label;
      (is_source ? label.source : label.target) = static_cast<int>(cap.value());
      for (auto f : part_.facing(cap))
        if (dot(part_.normal[f], is_source ? loops_.up[layer.value()] : reversed(loops_.up[layer.value()])) <= 0)
          fail(Status_code::chart_not_injective, Stage::loop_faces,
               "patch " + std::to_string(part_.id(cap)) + " turns away from the sweep", {part_.id(cap)},
               part_.coordinates(mesh.target(mesh.halfedge(f))));
      for (auto h : part_.border[cap.value()]) {
        const auto e = mesh.edge(h);
        const Node_index a = drawn.node_at(Surface_location::vertex(mesh.source(h)));
        const Node_index b = drawn.node_at(Surface_location::vertex(mesh.target(h)));
        const auto chain = drawn.nodes_along({true, e}, is_source ? a : b, is_source ? b : a);
        drawn.draw_along({true, e}, chain, label, Loop_label());
      }
    }
  }

  static Loop_label target_label(Patch_index target) {
    Loop_label label;
    if (target.is_valid()) label.target = static_cast<int>(target.value());
    return label;
  }

  void record(Layer_index layer, Drawn_layer<Traits>& drawn, const Imprinted_layer<Traits>& imprinted) {
    loops_.segments[layer.value()] = imprinted.segments();
    if (layer.value() == 0) return;
    auto& cuts = loops_.cuts[layer.value() - 1];
    cuts.resize(transport_->cuts().size());
    for (std::size_t s = 0; s < drawn.drawing().segments.size(); ++s) {
      const std::size_t cut = drawn.origin(s).cut;
      if (cut == Drawn_layer<Traits>::no_cut) continue;
      const auto chain = imprinted.chain(s);
      cuts[cut] = {transport_->cuts()[cut].segment, {chain.begin(), chain.end()}, transport_->projected(cut)};
    }
    auto& columns = loops_.wall_columns[layer.value() - 1];
    for (const auto& column : transport_->wall_columns())
      columns.push_back({column.bottom, imprinted.final_node(column.top)});
    for (const Wall_strip& strip : sections_.strips[layer.value() - 1])
      loops_.rings[layer.value() - 1].push_back(ring(strip, layer, drawn, imprinted));
  }

  // A strip of the linking mesh, in the nodes of the two layers after their imprints.
  typename Layered_loops<Traits>::Wall_ring ring(const Wall_strip& strip, Layer_index above,
                                                 Drawn_layer<Traits>& drawn,
                                                 const Imprinted_layer<Traits>& imprinted) const {
    typename Layered_loops<Traits>::Wall_ring ring;
    const Leaving_loop& bottom = transport_->leaving_loop(strip.bottom);
    ring.bottom = bottom.nodes;
    ring.barrel = bottom.barrels.front();
    for (const auto& carrier : bottom.carriers)
      ring.patch.push_back(linking_patch_above(carrier, layering_.layers[above.value() - 1]));
    constexpr std::size_t nowhere = std::size_t(-1);
    Key_map<std::size_t> position(nowhere);
    for (std::size_t s : arriving_[strip.top].segments)
      for (Node_index n : imprinted.chain(s))
        if (ring.top.empty() || ring.top.back() != n) {
          if (std::size_t& at = position[n.value()]; at == nowhere) at = ring.top.size();
          ring.top.push_back(n);
        }
    if (ring.top.size() > 1 && ring.top.front() == ring.top.back()) ring.top.pop_back();
    const auto& row = sections_.arriving[above.value()][strip.top];
    for (const auto& rail : strip.rails) {
      const Node_index node = imprinted.final_node(drawn.node_at(row.nodes[rail.top]));
      if (const std::size_t top = std::as_const(position)[node.value()]; top != nowhere)
        ring.rails.push_back({bottom.position[rail.bottom], top});
    }
    return ring;
  }

  // A row runs along an edge where it meets facets in their corners; the wall goes on in the one that rises from it.
  Patch_index linking_patch_above(const Wall_loop::Carrier& carrier, double value) const {
    if (!carrier.is_edge) return part_.patch(typename Part<Traits>::Face(carrier.index));
    const auto h = part_.first_halfedge(typename Part<Traits>::Edge(carrier.index));
    for (auto side : {h, part_.mesh.opposite(h)}) {
      const Patch_index patch = part_.patch(part_.mesh.face(side));
      const auto tip = part_.mesh.target(part_.mesh.next(side));
      if (roles_.of_patch[patch.value()] == Role::linking && layering_.parameter[tip] > value) return patch;
    }
    return Patch_index();
  }

  void transport_to_next(Layer_index layer, Drawn_layer<Traits>& drawn, const Imprinted_layer<Traits>& imprinted) {
    auto leaving = imprinted.leaving_loops(sections_.leaving[layer.value()], drawn, layering_.value(layer));
    for (const auto& loop : leaving)
      for (std::size_t i = 0; i < loop.nodes.size(); ++i)
        if (loop.carriers[i].is_edge)
          loops_.wall_labels.push_back({loop.nodes[i], loop.nodes[(i + 1) % loop.nodes.size()],
                                        loop.carriers[i].index, true, loop.targets[i]});
    transport_.emplace(part_, loops_.up[layer.value()], roles_.is_straight(), loops_.is_upright,
                       sections_.arriving[layer.value() + 1], sections_.strips[layer.value()], std::move(leaving),
                       imprinted, tolerance_, neighbours_, loops_);
  }

  void note(Layer_index layer, const Imprint<Traits>& imprint) {
    const std::string where = "layer " + std::to_string(layer.value()) + ": ";
    for (const std::string& text : imprint.notes) loops_.notes.push_back(where + text);
    for (int patch : imprint.lost)
      loops_.notes.push_back(where + "nothing is left of patch " + std::to_string(part_.patch_id[patch]));
  }

  // The labels of a layer are patch indices, and a place on it is one of its chart; users know patch ids and space.
  [[noreturn]] void fail_on_part(Status status, Layer_index layer, const Drawn_layer<Traits>& drawn) const {
    for (int& p : status.patches) p = part_.patch_id[p];
    if (status.place && !drawn.nodes().empty()) status.place = nearest_node(drawn, *status.place);
    status.reason = "layer " + std::to_string(layer.value()) + " at " + std::to_string(layering_.value(layer)) + ": " +
                    status.reason;
    throw Failure{std::move(status)};
  }

  static Vec3 nearest_node(const Drawn_layer<Traits>& drawn, const Vec3& on_chart) {
    const auto& nodes = drawn.drawing().nodes;
    const auto distance = [&](const auto& node) {
      return std::hypot(CGAL::to_double(node.point.x()) - on_chart[0], CGAL::to_double(node.point.y()) - on_chart[1]);
    };
    const auto nearest = std::min_element(nodes.begin(), nodes.end(),
                                          [&](const auto& l, const auto& r) { return distance(l) < distance(r); });
    return drawn.coordinates(drawn.nodes()[nearest - nodes.begin()]);
  }

  const Part<Traits>& part_;
  const Roles& roles_;
  const Layering& layering_;
  const Wall_sections& sections_;
  double tolerance_;
  std::size_t neighbours_;
  Visitor& visitor_;
  Layered_loops<Traits> loops_;
  std::optional<Slab_transport<Traits, PointIndex>> transport_;
  std::vector<Arriving_loop> arriving_;
};

}  // namespace internal

/// Pushes the targets through the layers like cookie cutters (section 2, step 5): on every layer draws the loops of
/// the linking mesh, the LoopFaces projected from below and the caps, imprints and merges them (2.7), lets what lies
/// under sources end there, and projects the rest to the next layer (2.6).
///
/// \tparam SegmentIndex a model of `SegmentIndex_2`
/// \tparam PointIndex a model of `PointIndex_3`
/// \param tolerance, reach how far nodes snap to one another, and what was carried up to the surface, if that is more
/// \return the imprinted layers; or the layer, the patches and the place where the imprint or the projection failed.
/// Complexity: O(n log n) in the nodes and crossings of all layers.
template <class Traits, class SegmentIndex, class PointIndex, class Visitor>
Result<Layered_loops<Traits>> sweep_layers(const Part<Traits>& part, const Roles& roles, const Layering& layering,
                                           const Wall_sections& sections, double tolerance, std::size_t neighbours,
                                           Visitor& visitor, double reach = 0) {
  return internal::guarded([&] {
    return internal::Layer_sweeper<Traits, SegmentIndex, PointIndex, Visitor>(part, roles, layering, sections,
                                                                              tolerance, reach, neighbours, visitor)
        .run();
  });
}

}  // namespace CCSweep

#endif
