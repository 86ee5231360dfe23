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
/// arrived: the walls around do not know how the caps bulge between them. The step onto the target is shared out over
/// the layers of the column.
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

  // The places of one column, from the bottom layer up.
  void correct_column(const std::vector<Vec3*>& column, Patch_index target) const {
    const std::size_t bottom = stack_.layer_of_cap[target.value()], top = bottom + column.size() - 1;
    const Vec3 step = drop_(target, *column[0], stack_.layers[bottom].up) - *column[0];
    for (std::size_t i = 0; i + 1 < column.size(); ++i)
      *column[i] = *column[i] + (1 - share(bottom, bottom + i, top)) * step;
  }

  void correct_junction(Node node, Patch_index target) {
    std::vector<Vec3*> column{&arcs_.points[node]};
    for (auto above = upper_node_.find(node); above != upper_node_.end(); above = upper_node_.find(above->second))
      column.push_back(&arcs_.points[above->second]);
    correct_column(column, target);
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
      correct_column(column, target);
    }
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
