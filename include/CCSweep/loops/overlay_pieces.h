// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_PIECES_H
#define CCSWEEP_LOOPS_OVERLAY_PIECES_H

#include <CCSweep/loops/overlay_chains.h>
#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_near.h>
#include <CCSweep/loops/overlay_nodes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Step 2 of the outline in section 2.7, *intersect boundaries*: straight pieces between nodes, split until any two
// of them meet in common end nodes only. All decisions are exact predicates; rounded crossings move the pieces around
// them a little, and these are tested again.
//
// What moves moves by less than `slack`, so all that will ever meet is near from the beginning: the index is asked
// once, and later rounds go from near pairs of pieces to near pairs of their parts.
template <class Traits>
class Overlay_pieces {
 public:
  // What rounding may do to the layer, all rounds together.
  static double slack(double rounding) { return 8 * maximal_rounds * rounding; }

  // `chains` in the nodes, a piece for each step; `fixed` for each chain; `near` are all pairs of pieces that may come
  // within the slack and twice the tolerance of each other, except that of neighbours which run on.
  template <class Fixed>
  Overlay_pieces(Layer_nodes<Traits>& nodes, const Node_chains& chains, const Fixed& fixed, std::vector<Near_pair> near,
                 double tolerance, double rounding)
      : nodes_(nodes), chains_(chains), pool_(nodes, tolerance, rounding), near_(std::move(near)), rounding_(rounding) {
    pieces_.reserve(2 * (chains.number_of_nodes() - chains.size()));
    for (std::size_t c = 0; c < chains.size(); ++c) {
      const std::span<const Node_index> chain = chains[c];
      for (std::size_t i = 1; i < chain.size(); ++i) add(chain[i - 1], chain[i], fixed(c), 0);
    }
    drawn_ = static_cast<std::uint32_t>(pieces_.size());
    is_known_.resize(nodes.points.size(), false);
  }

  // O((n + c) log n) for n near pairs and c crossings.
  void split_all() {
    for (round_ = 0;; ++round_) {
      find_twins();
      find_splits();
      if (splits_.empty()) return;
      if (round_ == maximal_rounds) {
        fail_imprint(nodes_, splits_.front().node, "crossings keep moving under rounding; use an exact kernel");
      }
      if (!apply_splits()) return;
      descend();
    }
  }

  // The chains after splitting.
  Node_chains expanded() const {
    Node_chains result;
    result.reserve(chains_.size(), chains_.number_of_nodes() + pieces_.size() - drawn_);
    std::size_t copied = 0;
    std::uint32_t piece = 0;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const std::span<const Node_index> chain = chains_[c];
      const std::uint32_t first = piece;
      piece += static_cast<std::uint32_t>(chain.size() - 1);
      if (are_whole(first, piece)) continue;
      result.append(chains_, copied, c);
      result.push_back(chain.front());
      for (std::uint32_t i = first; i < piece; ++i) expand(i, chain[i - first], 0, result);
      result.close();
      copied = c + 1;
    }
    result.append(chains_, copied, chains_.size());
    return result;
  }

 private:
  static constexpr int maximal_rounds = 30;
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  struct Piece {
    Node_index a, b;  // a < b
    std::uint32_t first_part = 0, parts = 0;  // the pieces it was split into, in the order from a to b
    std::uint32_t twin = none;                // a piece with the same ends that stands for this one
    std::int8_t tested_in = 0;                // the round that tests it against all that are near
    std::int8_t split_in = -1;
    bool fixed = false;
  };
  struct Split {
    std::uint32_t piece;
    Node_index node;
    bool exact;  // the node lies exactly on the piece
    auto operator<=>(const Split&) const = default;
  };
  struct Range {
    std::uint32_t first, last;
  };

  void add(Node_index a, Node_index b, bool fixed, int tested_in) {
    pieces_.push_back({std::min(a, b), std::max(a, b)});
    pieces_.back().fixed = fixed;
    pieces_.back().tested_in = static_cast<std::int8_t>(tested_in);
  }

  bool is_new(std::uint32_t i) const { return pieces_[i].tested_in == round_; }
  bool has_twin(std::uint32_t i) const { return pieces_[i].twin != none; }
  const typename Traits::Point_2& point(Node_index n) const { return nodes_.point(n); }

  bool are_whole(std::uint32_t first, std::uint32_t last) const {
    for (std::uint32_t i = first; i < last; ++i) {
      if (pieces_[has_twin(i) ? pieces_[i].twin : i].parts > 0) return false;
    }
    return true;
  }

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

  // Of pieces with the same ends the first stands for all.
  void find_twins() {
    std::vector<std::uint32_t> twins;
    for (const auto& [i, j] : near_) {
      if (pieces_[i].a != pieces_[j].a || pieces_[i].b != pieces_[j].b || i == j) continue;
      const std::uint32_t second = std::max(i, j);
      if (!has_twin(second)) twins.push_back(second);
      pieces_[second].twin = std::min(pieces_[second].twin, std::min(i, j));
    }
    for (std::uint32_t i : twins) {
      Piece& piece = pieces_[i];
      while (has_twin(piece.twin)) piece.twin = pieces_[piece.twin].twin;
      if (piece.fixed) pieces_[piece.twin].fixed = true;
    }
  }

  void find_splits() {
    splits_.clear();
    std::vector<Near_pair> crossings;
    for (const auto& [i, j] : near_) {
      if ((!is_new(i) && !is_new(j)) || has_twin(i) || has_twin(j)) continue;
      if (meet(i, j)) crossings.emplace_back(std::minmax(i, j));
    }
    if (crossings.empty()) return;
    std::sort(crossings.begin(), crossings.end());
    const std::vector<char> crowded = are_crowded(crossings);
    remember_nodes(crossings, crowded);
    for (std::size_t c = 0; c < crossings.size(); ++c) cross(crossings[c].first, crossings[c].second, crowded[c]);
  }

  // Whether anything but the two pieces may be near their crossing, so that it has to give way to another node. What
  // has an end in common with one of them is near the other as well, if it is near the crossing.
  std::vector<char> are_crowded(const std::vector<Near_pair>& crossings) const {
    std::vector<std::uint32_t> number_near(pieces_.size(), 0);
    for (const auto& [i, j] : near_) {
      if (has_twin(i) || has_twin(j) || have_common_end(i, j)) continue;
      ++number_near[i];
      ++number_near[j];
    }
    std::vector<char> result;
    result.reserve(crossings.size());
    for (const auto& [i, j] : crossings) result.push_back(number_near[i] > 1 || number_near[j] > 1);
    return result;
  }

  // Tells the pool of the nodes near crowded crossings. Nodes made here it knows.
  void remember_nodes(const std::vector<Near_pair>& crossings, const std::vector<char>& crowded) {
    std::vector<bool> crosses;
    const auto remember = [this](std::uint32_t i) {
      for (Node_index n : {pieces_[i].a, pieces_[i].b}) {
        if (n.value() >= is_known_.size() || is_known_[n.value()]) continue;
        is_known_[n.value()] = true;
        pool_.remember(n);
      }
    };
    for (std::size_t c = 0; c < crossings.size(); ++c) {
      if (!crowded[c]) continue;
      if (crosses.empty()) crosses.resize(pieces_.size(), false);
      for (std::uint32_t i : {crossings[c].first, crossings[c].second}) {
        crosses[i] = true;
        for_each_neighbour(i, remember);
      }
    }
    if (crosses.empty()) return;
    for (const auto& [i, j] : near_) {
      if (!crosses[i] && !crosses[j]) continue;
      remember(i);
      remember(j);
    }
  }

  // Splits pieces at nodes of each other. Whether they cross in a point inside both.
  bool meet(std::uint32_t i, std::uint32_t j) {
    const Piece &p = pieces_[i], &q = pieces_[j];
    if (p.a == q.a) return meet_in(p.a, i, p.b, j, q.b);
    if (p.a == q.b) return meet_in(p.a, i, p.b, j, q.a);
    if (p.b == q.a) return meet_in(p.b, i, p.a, j, q.b);
    if (p.b == q.b) return meet_in(p.b, i, p.a, j, q.a);
    const std::array<CGAL::Orientation, 2> of_q{turn_at(p, q.a), turn_at(p, q.b)};
    if (of_q[0] == of_q[1] && of_q[0] != CGAL::COLLINEAR) return false;
    const std::array<CGAL::Orientation, 2> of_p{turn_at(q, p.a), turn_at(q, p.b)};
    if (of_p[0] == of_p[1] && of_p[0] != CGAL::COLLINEAR) return false;
    touch(i, q.a, of_q[0]);
    touch(i, q.b, of_q[1]);
    touch(j, p.a, of_p[0]);
    touch(j, p.b, of_p[1]);
    return of_q[0] * of_q[1] * of_p[0] * of_p[1] != 0;
  }

  // The same where they have a node in common and run to u and v: of those in one direction the shorter is part of
  // the longer.
  bool meet_in(Node_index common, std::uint32_t i, Node_index u, std::uint32_t j, Node_index v) {
    if (u == v) return false;
    const bool ascending = is_less_xy<Traits>(point(common), point(u));
    if (ascending != is_less_xy<Traits>(point(common), point(v))) return false;
    if (turn<Traits>(point(common), point(u), point(v)) != CGAL::COLLINEAR) return false;
    const CGAL::Comparison_result order = Traits().compare_xy_2_object()(point(u), point(v));
    if (order == CGAL::EQUAL) return false;
    if ((order == CGAL::SMALLER) == ascending) {
      split(j, u, true);
    } else {
      split(i, v, true);
    }
    return false;
  }

  CGAL::Orientation turn_at(const Piece& piece, Node_index n) const {
    return turn<Traits>(point(piece.a), point(piece.b), point(n));
  }

  void touch(std::uint32_t i, Node_index n, CGAL::Orientation side) {
    if (side != CGAL::COLLINEAR) return;
    const auto &a = point(pieces_[i].a), &b = point(pieces_[i].b), &p = point(n);
    if (is_less_xy<Traits>(a, p) == is_less_xy<Traits>(p, b) && !is_equal<Traits>(a, p) && !is_equal<Traits>(p, b)) {
      split(i, n, true);
    }
  }

  void cross(std::uint32_t i, std::uint32_t j, bool is_crowded) {
    const Piece &p = pieces_[i], &q = pieces_[j];
    const bool fixed = p.fixed || q.fixed;
    const std::array<Node_index, 4> ends{p.a, p.b, q.a, q.b};
    const Crossing crossing =
        is_crowded ? pool_.crossing(ends, fixed, round_ == 0 && !fixed) : pool_.lonely_crossing(ends, fixed);
    split(i, crossing.node, crossing.exact);
    split(j, crossing.node, crossing.exact);
  }

  void split(std::uint32_t piece, Node_index node, bool exact) {
    if (node == pieces_[piece].a || node == pieces_[piece].b) return;
    splits_.push_back({piece, node, exact});
    if (pieces_[piece].fixed) nodes_.fixed[node.value()] = true;
  }

  // Whether anything has moved.
  bool apply_splits() {
    std::sort(splits_.begin(), splits_.end());
    bool any_moved = false;
    std::vector<Node_index> inner;
    for (auto first = splits_.begin(); first != splits_.end();) {
      const std::uint32_t piece = first->piece;
      inner.clear();
      bool exact = true;
      for (; first != splits_.end() && first->piece == piece; ++first) {
        if (inner.empty() || inner.back() != first->node) inner.push_back(first->node);
        exact = exact && first->exact;
      }
      split_piece(piece, inner, exact);
      any_moved = any_moved || !exact;
    }
    return any_moved;
  }

  void split_piece(std::uint32_t number, std::vector<Node_index>& inner, bool exact) {
    const Piece piece = pieces_[number];
    if (inner.size() > 1) {
      const Along<Traits> along(point(piece.a), point(piece.b));
      std::sort(inner.begin(), inner.end(), [&](Node_index n, Node_index m) {
        const auto order = along(point(n), point(m));
        return order == CGAL::SMALLER || (order == CGAL::EQUAL && n < m);
      });
    }
    pieces_[number].first_part = static_cast<std::uint32_t>(pieces_.size());
    pieces_[number].parts = static_cast<std::uint32_t>(inner.size() + 1);
    pieces_[number].split_in = static_cast<std::int8_t>(round_);
    const int tested_in = exact ? -1 : round_ + 1;
    Node_index last = piece.a;
    for (Node_index n : inner) {
      add(last, n, piece.fixed, tested_in);
      last = n;
    }
    add(last, piece.b, piece.fixed, tested_in);
  }

  // From near pairs of pieces to near pairs of their parts.
  void descend() {
    std::vector<Near_pair> next;
    next.reserve(near_.size() + 8 * splits_.size());
    for (const auto& [i, j] : near_) descend(i, j, next);
    std::uint32_t last = none;
    for (const Split& split : splits_) {
      if (split.piece == last) continue;
      last = split.piece;
      descend_from_neighbours(last, next);
      const Range parts = all_parts(last);
      for (std::uint32_t x = parts.first; x < parts.last; ++x) {
        for (std::uint32_t y = x + 1; y < parts.last && boxes_meet(box(x), box(y)); ++y) next.emplace_back(x, y);
      }
    }
    near_ = std::move(next);
  }

  void descend(std::uint32_t i, std::uint32_t j, std::vector<Near_pair>& result) const {
    if (has_twin(i) || has_twin(j)) return;
    if (pieces_[i].parts == 0 && pieces_[j].parts == 0) {
      result.emplace_back(i, j);
      return;
    }
    const Range xs = parts_near(i, box(j));
    for (std::uint32_t x = xs.first; x < xs.last; ++x) add_near(x, parts_near(j, box(x)), result);
  }

  // Neighbours that run on were no near pair before one of them was split.
  void descend_from_neighbours(std::uint32_t i, std::vector<Near_pair>& result) const {
    for_each_neighbour(i, [&](std::uint32_t j) {
      const bool with_this = pieces_[j].split_in == round_;
      if ((pieces_[j].parts == 0 || with_this) && (i < j || !with_this)) descend(i, j, result);
    });
  }

  void add_near(std::uint32_t x, Range ys, std::vector<Near_pair>& result) const {
    const Flat_box here = box(x);
    for (std::uint32_t y = ys.first; y < ys.last; ++y) {
      if (boxes_meet(here, box(y)) && !are_apart(nodes_, ends(x), ends(y), 2 * remaining_slack())) {
        result.emplace_back(x, y);
      }
    }
  }

  Flat_box box(std::uint32_t i) const {
    return flat_box(nodes_.box(pieces_[i].a, pieces_[i].b), remaining_slack());
  }
  std::array<Node_index, 2> ends(std::uint32_t i) const { return {pieces_[i].a, pieces_[i].b}; }
  // What rounding may still do after this round.
  double remaining_slack() const { return slack(rounding_) * (maximal_rounds - round_) / maximal_rounds; }

  Range all_parts(std::uint32_t i) const {
    const Piece& piece = pieces_[i];
    return piece.parts == 0 ? Range{i, i + 1} : Range{piece.first_part, piece.first_part + piece.parts};
  }

  // The parts of a piece that may be near a box: they follow one another along the axis that the piece is longer in.
  Range parts_near(std::uint32_t i, const Flat_box& near) const {
    const Range all = all_parts(i);
    if (all.last - all.first <= 4) return all;
    const Place_2 a = nodes_.place(pieces_[i].a), b = nodes_.place(pieces_[i].b);
    const bool by_x = std::fabs(b[0] - a[0]) >= std::fabs(b[1] - a[1]);
    const bool ascending = by_x ? a[0] < b[0] : a[1] < b[1];
    const auto before = [&](std::uint32_t x, bool strictly_behind) {
      const Flat_box part = box(x);
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

  // Appends the nodes after `from` of a piece that begins or ends there.
  void expand(std::uint32_t number, Node_index from, int depth, Node_chains& result) const {
    if (depth > 2 * maximal_rounds) fail_imprint(nodes_, from, "a crossing can't be placed at this precision");
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

  Layer_nodes<Traits>& nodes_;
  const Node_chains& chains_;
  Crossing_pool<Traits> pool_;
  std::vector<Near_pair> near_;
  double rounding_;
  int round_ = 0;
  std::uint32_t drawn_ = 0;  // the number of pieces before any was split
  std::vector<Piece> pieces_;
  std::vector<Split> splits_;
  std::vector<bool> is_known_;
};

}  // namespace CCSweep::internal

#endif
