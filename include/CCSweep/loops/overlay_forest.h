// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_FOREST_H
#define CCSWEEP_LOOPS_OVERLAY_FOREST_H

#include <CCSweep/loops/overlay_chains.h>
#include <CCSweep/loops/overlay_near.h>
#include <CCSweep/loops/overlay_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace CCSweep::internal {

// A straight piece between two nodes.
struct Piece {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  Node_index a, b;                          // a < b
  std::uint32_t first_part = 0, parts = 0;  // the pieces it was split into, in the order from a to b
  std::uint32_t twin = none;                // a piece with the same ends that stands for this one
  std::int8_t tested_in = 0;                // the round that tests it against all that are near
  std::int8_t split_in = -1;
  bool fixed = false;
  bool clear = true;  // all its crossings are
};

// Pieces that follow one another.
struct Piece_range {
  std::uint32_t first, last;
};

// The pieces of a layer, and the pieces they were split into.
template <class Traits>
class Piece_forest {
 public:
  // A piece for each step of the chains, which are fixed as `fixed` tells; `twins` as `first_twins` tells, or empty.
  template <class Fixed>
  Piece_forest(const Layer_nodes<Traits>& nodes, const Node_chains& chains, const std::vector<Step>& steps,
               const Fixed& fixed, const std::vector<std::uint32_t>& twins)
      : nodes_(nodes), chains_(chains), drawn_(static_cast<std::uint32_t>(steps.size())) {
    pieces_.reserve(2 * steps.size());
    for (const auto [a, b] : steps) add(a, b, false, 0);
    for (std::size_t c = 0; c < chains.size(); ++c) {
      if (!fixed(c)) continue;
      for (std::size_t i = chains.steps_before(c); i < chains.steps_before(c + 1); ++i) pieces_[i].fixed = true;
    }
    for (std::uint32_t i = 0; i < twins.size(); ++i) {
      if (twins[i] != i) make_twin(i, twins[i]);
    }
  }

  std::size_t size() const { return pieces_.size(); }
  // The number of pieces before any was split.
  std::uint32_t number_drawn() const { return drawn_; }
  const Piece& operator[](std::uint32_t i) const { return pieces_[i]; }
  Piece& operator[](std::uint32_t i) { return pieces_[i]; }

  void add(Node_index a, Node_index b, bool fixed, int tested_in) {
    Piece& piece = pieces_.emplace_back();
    piece.a = std::min(a, b);
    piece.b = std::max(a, b);
    piece.fixed = fixed;
    piece.clear = has_plain_coordinates<Traits>;
    piece.tested_in = static_cast<std::int8_t>(tested_in);
  }

  // The parts of a piece are the next ones that are added.
  void begin_parts(std::uint32_t i, std::size_t parts) {
    pieces_[i].first_part = static_cast<std::uint32_t>(pieces_.size());
    pieces_[i].parts = static_cast<std::uint32_t>(parts);
  }

  void make_twin(std::uint32_t i, std::uint32_t first) {
    pieces_[i].twin = first;
    if (pieces_[i].fixed) pieces_[first].fixed = true;
  }

  bool has_twin(std::uint32_t i) const { return pieces_[i].twin != Piece::none; }
  // Calls f for those of the neighbours of a piece in the drawing that begin or end at its own ends.
  template <class Function>
  void for_each_neighbour(std::uint32_t i, const Function& f) const {
    if (i >= drawn_) return;
    if (i > 0 && have_common_end(i, i - 1)) f(i - 1);
    if (i + 1 < drawn_ && have_common_end(i, i + 1)) f(i + 1);
  }

  bool have_common_end(std::uint32_t i, std::uint32_t j) const {
    const Piece &p = pieces_[i], &q = pieces_[j];
    return p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b;
  }

  // The node next to an end of a piece.
  Node_index arm(std::uint32_t i, Node_index end) const {
    const Piece_range parts = all_parts(i);
    const Piece& part = pieces_[end == pieces_[i].a ? parts.first : parts.last - 1];
    return part.a == end ? part.b : part.a;
  }

  // What stands for a piece after it was split, or itself.
  Piece_range all_parts(std::uint32_t i) const {
    const Piece& piece = pieces_[i];
    return piece.parts == 0 ? Piece_range{i, i + 1} : Piece_range{piece.first_part, piece.first_part + piece.parts};
  }

  Step ends(std::uint32_t i) const { return {pieces_[i].a, pieces_[i].b}; }
  Flat_box box(std::uint32_t i, double inflated_by) const {
    return flat_box(nodes_.box(pieces_[i].a, pieces_[i].b)).inflated(inflated_by);
  }

  // The parts of a piece that may be near a box: they follow one another along the axis that the piece is longer in.
  Piece_range parts_near(std::uint32_t i, const Flat_box& near, double inflated_by) const {
    const Piece_range all = all_parts(i);
    if (all.last - all.first <= 4) return all;
    const Place_2 a = nodes_.place(pieces_[i].a), b = nodes_.place(pieces_[i].b);
    const bool by_x = std::fabs(b[0] - a[0]) >= std::fabs(b[1] - a[1]);
    const bool ascending = by_x ? a[0] < b[0] : a[1] < b[1];
    const auto before = [&](std::uint32_t x, bool strictly_behind) {
      const Flat_box part = box(x, inflated_by);
      const double low = by_x ? part.xmin : part.ymin, high = by_x ? part.xmax : part.ymax;
      const double from = by_x ? near.xmin : near.ymin, to = by_x ? near.xmax : near.ymax;
      if (strictly_behind) return ascending ? low <= to : high >= from;
      return ascending ? high < from : low > to;
    };
    const auto bound = [&](bool behind) {
      std::uint32_t first = all.first, size = all.last - all.first;
      while (size > 0) {
        const std::uint32_t half = size / 2;
        if (before(first + half, behind)) {
          first += half + 1;
          size -= half + 1;
        } else {
          size = half;
        }
      }
      return first;
    };
    return {bound(false), bound(true)};
  }

  // The chains after splitting.
  Node_chains expanded() const {
    Node_chains result;
    result.reserve(chains_.size(), chains_.number_of_nodes() + pieces_.size() - drawn_);
    std::size_t copied = 0, c = 0;
    for (std::size_t piece = 0; piece < drawn_; ++piece) {
      if (is_whole(piece)) continue;
      while (chains_.steps_before(c + 1) <= piece) ++c;
      result.append(chains_, copied, c);
      append_expanded(c, result);
      copied = c + 1;
      piece = chains_.steps_before(c + 1) - 1;
    }
    result.append(chains_, copied, chains_.size());
    return result;
  }

 private:
  static constexpr int maximal_depth = 60;

  bool is_whole(std::size_t i) const {
    const Piece& piece = pieces_[i];
    return (piece.twin == Piece::none ? piece : pieces_[piece.twin]).parts == 0;
  }

  void append_expanded(std::size_t number, Node_chains& result) const {
    const std::span<const Node_index> chain = chains_[number];
    const std::uint32_t first = static_cast<std::uint32_t>(chains_.steps_before(number));
    result.push_back(chain.front());
    for (std::uint32_t i = 1; i < chain.size(); ++i) expand(first + i - 1, chain[i - 1], 0, result);
    result.close();
  }

  // Appends the nodes after `from` of a piece that begins or ends there.
  void expand(std::uint32_t number, Node_index from, int depth, Node_chains& result) const {
    if (depth > maximal_depth) fail_imprint(nodes_, from, "a crossing can't be placed at this precision");
    if (has_twin(number)) number = pieces_[number].twin;
    const Piece& piece = pieces_[number];
    const bool forward = from == piece.a;
    if (piece.parts == 0) return result.push_back(forward ? piece.b : piece.a);
    for (std::uint32_t i = 0; i < piece.parts; ++i) {
      const std::uint32_t part = piece.first_part + (forward ? i : piece.parts - 1 - i);
      expand(part, from, depth + 1, result);
      from = from == pieces_[part].a ? pieces_[part].b : pieces_[part].a;
    }
  }

  const Layer_nodes<Traits>& nodes_;
  const Node_chains& chains_;
  std::uint32_t drawn_;
  std::vector<Piece> pieces_;
};

}  // namespace CCSweep::internal

#endif
