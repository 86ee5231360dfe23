// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_CARRIED_COLUMNS_H
#define CCSWEEP_HEX_CARRIED_COLUMNS_H

#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>

#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The junctions and arcs that were carried down through the material, and the correction they get once they have
/// arrived: the walls around do not know how the caps bulge between them. On a straight sweep the height of a column
/// over its target therefore grows evenly with the sweep parameter; on a bent one the step onto the target is shared
/// out.
class Carried_columns {
  using Node = Arc_stack::Node;

 public:
  using Drop = std::function<Vec3(Patch_index, const Vec3&, const Vec3&)>;

  Carried_columns(const Layer_stack& stack, Arc_stack& arcs, Drop drop)
      : stack_(stack), arcs_(arcs), drop_(std::move(drop)) {}

  void add_junction(std::size_t lower_layer, Node upper, Node lower, Patch_index target) {
    upper_node_[lower] = upper;
    if (stack_.layer_of_cap[target.value()] == lower_layer) arrived_nodes_.push_back({lower, target});
  }

  void add_arc(std::size_t lower_layer, std::size_t upper, std::size_t lower, Patch_index target) {
    upper_arc_[{lower_layer, lower}] = upper;
    if (stack_.layer_of_cap[target.value()] == lower_layer) arrived_arcs_.push_back({lower, target});
  }

  void correct() {
    for (const auto& [node, target] : arrived_nodes_) correct_junction(node, target);
    for (const auto& [arc, target] : arrived_arcs_) correct_arc(arc, target);
  }

 private:
  double share(std::size_t bottom, std::size_t layer, std::size_t top) const {
    const auto value = [&](std::size_t k) { return stack_.layers[k].value; };
    return (value(layer) - value(bottom)) / (value(top) - value(bottom));
  }

  // The places of one column, from the bottom layer up; `bend` tells by how much the heights are to stray from even.
  template <class Bend>
  void correct_column(const std::vector<Vec3*>& column, Patch_index target, const Bend& bend) const {
    const std::size_t bottom = stack_.layer_of_cap[target.value()], top = bottom + column.size() - 1;
    const Vec3& up = stack_.layers[bottom].up;
    const Vec3 on_target = drop_(target, *column[0], up), step = on_target - *column[0];
    const double low = dot(up, on_target), high = dot(up, *column.back());
    for (std::size_t i = 0; i + 1 < column.size(); ++i) {
      const double t = share(bottom, bottom + i, top);
      const double height = low + t * (high - low) + (i == 0 ? 0 : bend(i));
      *column[i] = *column[i] + (stack_.is_straight ? (height - dot(up, *column[i])) * up : (1 - t) * step);
    }
  }

  void correct_junction(Node node, Patch_index target) {
    std::vector<Vec3*> column{&arcs_.points[node]};
    for (auto above = upper_node_.find(node); above != upper_node_.end(); above = upper_node_.find(above->second))
      column.push_back(&arcs_.points[above->second]);
    correct_column(column, target, [](std::size_t) { return 0.0; });
  }

  void correct_arc(std::size_t arc, Patch_index target) {
    const std::size_t bottom = stack_.layer_of_cap[target.value()];
    std::vector<Arc_stack::Arc*> arcs{&arcs_.arcs[bottom][arc]};
    for (auto above = upper_arc_.find({bottom, arc}); above != upper_arc_.end();
         above = upper_arc_.find({bottom + arcs.size() - 1, above->second}))
      arcs.push_back(&arcs_.arcs[bottom + arcs.size()][above->second]);
    for (Arc_stack::Arc* a : arcs) {
      a->line.front() = arcs_.points[a->from];
      a->line.back() = arcs_.points[a->to];
    }
    const std::size_t n = arcs[0]->line.size();
    for (std::size_t p = 1; p + 1 < n; ++p) {
      std::vector<Vec3*> column;
      for (Arc_stack::Arc* a : arcs) column.push_back(&a->line[p]);
      const double s = double(p) / double(n - 1);
      correct_column(column, target, [&](std::size_t i) {
        return (1 - s) * unevenness(arcs, i, false) + s * unevenness(arcs, i, true);
      });
    }
  }

  // How far an end of an arc, on a wall perhaps, strays from an even height.
  double unevenness(const std::vector<Arc_stack::Arc*>& arcs, std::size_t i, bool at_end) const {
    const auto end = [&](const Arc_stack::Arc* a) { return at_end ? a->line.back() : a->line.front(); };
    const std::size_t bottom = stack_.layer_of_cap[arcs[0]->left.target.value()];
    const Vec3& up = stack_.layers[bottom].up;
    const double low = dot(up, end(arcs[0])), high = dot(up, end(arcs.back()));
    return dot(up, end(arcs[i])) - low - share(bottom, bottom + i, bottom + arcs.size() - 1) * (high - low);
  }

  const Layer_stack& stack_;
  Arc_stack& arcs_;
  Drop drop_;
  std::map<Node, Node> upper_node_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> upper_arc_;  // by layer and arc
  std::vector<std::pair<Node, Patch_index>> arrived_nodes_;
  std::vector<std::pair<std::size_t, Patch_index>> arrived_arcs_;
};

}  // namespace CCSweep::internal

#endif
