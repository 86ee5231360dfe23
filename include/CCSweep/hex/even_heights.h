// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_EVEN_HEIGHTS_H
#define CCSWEEP_HEX_EVEN_HEIGHTS_H

#include <CCSweep/hex/Arc_nodes.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Makes the heights of the nodes inside the material of a straight sweep even: where caps bulge between their walls, a
/// row that only the walls have shaped may pierce them. The ends of an arc may stand on walls, which have rows of their
/// own; what these stray from even heights fades along the arc.
template <class CapDrop>
class Even_heights {
  using Half_arc = Arc_stack::Half_arc;
  using Column = std::vector<std::uint32_t>;  // nodes above one another, from the top

 public:
  Even_heights(const Layer_stack& stack, const Arc_stack& arcs, Arc_nodes<CapDrop>& nodes)
      : stack_(stack), arcs_(arcs), nodes_(nodes), up_(stack.layers[0].up) {}

  void run() {
    std::vector<Chain> chains;
    for (std::size_t k = arcs_.arcs.size(); k-- > 1;)
      for (std::size_t a = 0; a < arcs_.arcs[k].size(); ++a)
        if (const auto h = static_cast<Half_arc>(2 * a); nodes_.is_used(k, h) && !is_inside(k, h))
          if (Chain chain = chain_below(k, h); chain.halves.size() > 2) chains.push_back(std::move(chain));
    mark_surface();
    for (const Chain& chain : chains)
      for (bool at_end : {false, true}) even_out_junctions(chain, column_of_end(chain, at_end));
    for (const Chain& chain : chains) even_out(chain);
  }

 private:
  struct Chain {
    std::size_t top;
    std::vector<Half_arc> halves;  // from the top layer down
    std::size_t layer(std::size_t i) const { return top - i; }
  };

  // Material on all four sides: left and right, above and below.
  bool is_inside(std::size_t k, Half_arc h) const {
    for (const auto* side : {&arcs_.side(k, h), &arcs_.side(k, Arc_stack::opposite(h))})
      if (!Layer_stack::is_above(*side) || !stack_.is_below(*side, k)) return false;
    return true;
  }

  // Down to where the arc lies on the surface again.
  Chain chain_below(std::size_t k, Half_arc h) const {
    Chain chain{k, {h}};
    for (;; --k) {
      const Half_arc below = arcs_.below(k, h), other = arcs_.below(k, Arc_stack::opposite(h));
      if (below == Arc_stack::none || other != Arc_stack::opposite(below) || !nodes_.is_used(k - 1, below)) break;
      chain.halves.push_back(h = below);
      if (!is_inside(k - 1, h)) break;
    }
    return chain;
  }

  void mark_surface() {
    on_surface_.assign(nodes_.points.size(), false);
    for (std::size_t k = 0; k < arcs_.arcs.size(); ++k)
      for (std::size_t a = 0; a < arcs_.arcs[k].size(); ++a)
        if (const auto h = static_cast<Half_arc>(2 * a); nodes_.is_used(k, h) && !is_inside(k, h))
          for (std::uint32_t n : nodes_.on(k, h)) on_surface_[n] = true;
  }

  Column column_of_end(const Chain& chain, bool at_end) const {
    Column column;
    for (std::size_t i = 0; i < chain.halves.size(); ++i) {
      const Half_arc h = at_end ? Arc_stack::opposite(chain.halves[i]) : chain.halves[i];
      column.push_back(nodes_.around(chain.layer(i), {h})[0]);
    }
    return column;
  }

  double value(const Chain& chain, std::size_t i) const { return stack_.layers[chain.layer(i)].value; }
  double height(std::uint32_t n) const { return dot(up_, nodes_.points[n]); }
  void set_height(std::uint32_t n, double h) { nodes_.points[n] = nodes_.points[n] + (h - height(n)) * up_; }

  // The height at entry i of a column that is even between its entries a and b.
  double even(const Chain& chain, const Column& column, std::size_t a, std::size_t b, std::size_t i) const {
    const double t = (value(chain, i) - value(chain, a)) / (value(chain, b) - value(chain, a));
    return (1 - t) * height(column[a]) + t * height(column[b]);
  }

  void even_out_junctions(const Chain& chain, const Column& column) {
    for (std::size_t a = 0, b = 1; b < column.size(); ++b) {
      if (!on_surface_[column[b]]) continue;
      for (std::size_t i = a + 1; i < b; ++i) set_height(column[i], even(chain, column, a, b, i));
      a = b;
    }
  }

  void even_out(const Chain& chain) {
    const std::size_t n = chain.halves.size();
    std::vector<std::vector<std::uint32_t>> rows;
    for (std::size_t i = 0; i < n; ++i) rows.push_back(nodes_.on(chain.layer(i), chain.halves[i]));
    const Column first = column_of_end(chain, false), last = column_of_end(chain, true);
    for (std::size_t p = 1; p + 1 < rows[0].size(); ++p) {
      const double s = double(p) / double(rows[0].size() - 1);
      Column column;
      for (const auto& row : rows) column.push_back(row[p]);
      for (std::size_t i = 1; i + 1 < n; ++i) {
        const double bend_first = height(first[i]) - even(chain, first, 0, n - 1, i);
        const double bend_last = height(last[i]) - even(chain, last, 0, n - 1, i);
        set_height(column[i], even(chain, column, 0, n - 1, i) + (1 - s) * bend_first + s * bend_last);
      }
    }
  }

  const Layer_stack& stack_;
  const Arc_stack& arcs_;
  Arc_nodes<CapDrop>& nodes_;
  Vec3 up_;
  std::vector<bool> on_surface_;
};

}  // namespace CCSweep::internal

#endif
