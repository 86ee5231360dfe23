// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_CHAINS_H
#define CCSWEEP_LOOPS_OVERLAY_CHAINS_H

#include <CCSweep/indices.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CCSweep {

/// A sequence of chains of nodes, which stand one after another in memory: a chain for itself would cost more than its
/// two or three nodes.
class Node_chains {
 public:
  Node_chains() = default;
  /// Chains of all their nodes and the number of nodes up to the end of each.
  Node_chains(std::vector<Node_index> nodes, std::vector<std::uint32_t> ends)
      : nodes_(std::move(nodes)), ends_(std::move(ends)) {}

  std::size_t size() const { return ends_.size(); }
  bool empty() const { return ends_.empty(); }
  /// The nodes of a chain; they stay where they are until the next change.
  std::span<const Node_index> operator[](std::size_t chain) const {
    return {nodes_.data() + nodes_before(chain), nodes_.data() + ends_[chain]};
  }
  friend bool operator==(const Node_chains&, const Node_chains&) = default;

  /// The number of nodes of all chains.
  std::size_t number_of_nodes() const { return nodes_.size(); }
  /// The number of nodes of the chains before one.
  std::size_t nodes_before(std::size_t chain) const { return chain == 0 ? 0 : ends_[chain - 1]; }
  /// The same of the steps from one node of a chain to the next; no chain is empty.
  std::size_t steps_before(std::size_t chain) const { return nodes_before(chain) - chain; }

  void reserve(std::size_t chains, std::size_t nodes) {
    ends_.reserve(chains);
    nodes_.reserve(nodes);
  }
  /// Adds a node to the chain that `close()` will end.
  void push_back(Node_index node) { nodes_.push_back(node); }
  /// Adds chains `first` to `last`, the latter not included, of another sequence.
  void append(const Node_chains& other, std::size_t first, std::size_t last) {
    if (first == last) return;
    const std::uint32_t from = static_cast<std::uint32_t>(other.nodes_before(first));
    const std::uint32_t size = static_cast<std::uint32_t>(nodes_.size());
    nodes_.insert(nodes_.end(), other.nodes_.begin() + from, other.nodes_.begin() + other.ends_[last - 1]);
    for (std::size_t c = first; c < last; ++c) ends_.push_back(other.ends_[c] - from + size);
  }
  void close() { ends_.push_back(static_cast<std::uint32_t>(nodes_.size())); }

 private:
  std::vector<Node_index> nodes_;
  std::vector<std::uint32_t> ends_;
};

}  // namespace CCSweep

#endif
