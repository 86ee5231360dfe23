// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_PIECES_H
#define CCSWEEP_LOOPS_OVERLAY_PIECES_H

#include <CCSweep/loops/overlay_chains.h>
#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_near.h>
#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/overlay_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
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
// once, and later rounds go from near pairs of pieces to near pairs of their parts. Most crossings are clear: their
// arms end so far from each other that rounding can't have brought their pieces together anywhere else. Pairs that meet
// in such a crossing are set aside, and looked at again only if later rounds move anything.
template <class Traits>
class Overlay_pieces {
 public:
  // What rounding may do to the layer, all rounds together.
  static double slack(double rounding) { return 8 * maximal_rounds * rounding; }

  // `chains` in the nodes, a piece for each step; `fixed` for each chain; `twins` as `first_twins` tells, or empty;
  // `near` are all pairs of pieces that may come within the slack and twice the tolerance of each other, except that
  // of neighbours which run on.
  template <class Fixed>
  Overlay_pieces(Layer_nodes<Traits>& nodes, const Node_chains& chains, const Fixed& fixed,
                 const std::vector<std::uint32_t>& twins, std::vector<Near_pair> near, double tolerance,
                 double rounding)
      : nodes_(nodes), chains_(chains), pool_(nodes, tolerance, rounding), near_(std::move(near)), rounding_(rounding) {
    pieces_.reserve(2 * (chains.number_of_nodes() - chains.size()));
    for (std::size_t c = 0; c < chains.size(); ++c) {
      const std::span<const Node_index> chain = chains[c];
      for (std::size_t i = 1; i < chain.size(); ++i) add(chain[i - 1], chain[i], fixed(c), 0);
    }
    drawn_ = static_cast<std::uint32_t>(pieces_.size());
    for (std::uint32_t i = 0; i < twins.size(); ++i) {
      if (twins[i] != i) make_twin(i, twins[i]);
    }
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
    bool clear = true;  // all its crossings are
  };
  struct Split {
    std::uint32_t piece;
    Node_index node;
    std::uint32_t other;  // the piece that it crosses there, if it does
    bool exact;           // the node lies exactly on the piece
    auto operator<=>(const Split&) const = default;
  };
  struct Range {
    std::uint32_t first, last;
  };

  void add(Node_index a, Node_index b, bool fixed, int tested_in) {
    pieces_.push_back({std::min(a, b), std::max(a, b)});
    pieces_.back().fixed = fixed;
    pieces_.back().clear = has_plain_coordinates<Traits>;
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

  // Of pieces with the same ends the first stands for all, and nothing more need be known of the others.
  void find_twins() {
    std::vector<std::uint32_t> twins;
    for (const auto& [i, j] : near_) {
      if (pieces_[i].a != pieces_[j].a || pieces_[i].b != pieces_[j].b || i == j) continue;
      const std::uint32_t second = std::max(i, j);
      if (!has_twin(second)) twins.push_back(second);
      pieces_[second].twin = std::min(pieces_[second].twin, std::min(i, j));
    }
    if (twins.empty()) return;
    for (std::uint32_t i : twins) {
      std::uint32_t first = pieces_[i].twin;
      while (has_twin(first)) first = pieces_[first].twin;
      make_twin(i, first);
    }
    std::erase_if(near_, [this](const Near_pair& p) { return has_twin(p.first) || has_twin(p.second); });
  }

  void make_twin(std::uint32_t i, std::uint32_t first) {
    pieces_[i].twin = first;
    if (pieces_[i].fixed) pieces_[first].fixed = true;
  }

  void find_splits() {
    splits_.clear();
    std::vector<Near_pair> crossings;
    crosses_.assign(near_.size(), false);
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const auto [i, j] = near_[k];
      if ((!is_new(i) && !is_new(j)) || !meet(i, j)) continue;
      crosses_[k] = true;
      crossings.emplace_back(std::minmax(i, j));
    }
    if (crossings.empty()) return;
    bucket_sort(crossings, pieces_.size(), [](const Near_pair& c) { return c.first; }, std::less<>());
    const std::vector<char> crowded = are_crowded(crossings);
    remember_nodes(crossings, crowded);
    for (std::size_t c = 0; c < crossings.size(); ++c) cross(crossings[c].first, crossings[c].second, crowded[c]);
  }

  // Whether anything but the two pieces may be near their crossing, so that it has to give way to another node. What
  // has an end in common with one of them is near the other as well, if it is near the crossing.
  std::vector<char> are_crowded(const std::vector<Near_pair>& crossings) const {
    std::vector<std::uint32_t> number_near(pieces_.size(), 0);
    for (const auto& [i, j] : near_) {
      if (have_common_end(i, j)) continue;
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
    if (u == v || are_spread(common, u, v)) return false;
    const bool ascending = is_less_xy<Traits>(point(common), point(u));
    if (ascending != is_less_xy<Traits>(point(common), point(v))) return false;
    if (turn<Traits>(point(common), point(u), point(v)) != CGAL::COLLINEAR) return false;
    const CGAL::Comparison_result order = Traits().compare_xy_2_object()(point(u), point(v));
    if (order == CGAL::EQUAL) return false;
    if ((order == CGAL::SMALLER) == ascending) {
      split_at(j, u);
    } else {
      split_at(i, v);
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
      split_at(i, n);
    }
  }

  void cross(std::uint32_t i, std::uint32_t j, bool is_crowded) {
    const Piece &p = pieces_[i], &q = pieces_[j];
    const bool fixed = p.fixed || q.fixed;
    const std::array<Node_index, 4> ends{p.a, p.b, q.a, q.b};
    const std::size_t first_new = nodes_.points.size();
    const auto [node, exact] =
        is_crowded ? pool_.crossing(ends, fixed, round_ == 0 && !fixed) : pool_.lonely_crossing(ends, fixed);
    if (node.value() < first_new) pieces_[i].clear = pieces_[j].clear = false;
    split({i, node, j, exact});
    split({j, node, i, exact});
  }

  // Splits a piece at a node that lies on it.
  void split_at(std::uint32_t piece, Node_index node) {
    pieces_[piece].clear = false;
    split({piece, node, none, true});
  }

  void split(const Split& split) {
    const Piece& piece = pieces_[split.piece];
    if (split.node == piece.a || split.node == piece.b) return;
    splits_.push_back(split);
    if (piece.fixed) nodes_.fixed[split.node.value()] = true;
  }

  // Whether anything has moved.
  bool apply_splits() {
    bucket_sort(splits_, pieces_.size(), [](const Split& split) { return split.piece; }, std::less<>());
    bool any_moved = false;
    std::vector<Split> inner;
    for (auto first = splits_.begin(); first != splits_.end();) {
      const std::uint32_t piece = first->piece;
      inner.clear();
      bool exact = true;
      for (; first != splits_.end() && first->piece == piece; ++first) {
        exact = exact && first->exact;
        if (inner.empty() || inner.back().node != first->node) {
          inner.push_back(*first);
        } else {
          pieces_[piece].clear = false;
        }
      }
      split_piece(piece, inner, exact);
      any_moved = any_moved || !exact;
    }
    return any_moved;
  }

  void split_piece(std::uint32_t number, std::vector<Split>& inner, bool exact) {
    const Piece piece = pieces_[number];
    if (inner.size() > 1) {
      const Along<Traits> along(point(piece.a), point(piece.b));
      std::sort(inner.begin(), inner.end(), [&](const Split& s, const Split& t) {
        const auto order = along(point(s.node), point(t.node));
        return order == CGAL::SMALLER || (order == CGAL::EQUAL && s.node < t.node);
      });
    }
    pieces_[number].first_part = static_cast<std::uint32_t>(pieces_.size());
    pieces_[number].parts = static_cast<std::uint32_t>(inner.size() + 1);
    pieces_[number].split_in = static_cast<std::int8_t>(round_);
    const int tested_in = exact ? -1 : round_ + 1;
    Node_index last = piece.a;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const Node_index next = i + 1 < inner.size() ? inner[i + 1].node : piece.b;
      if (pieces_[number].clear && !is_clear(inner[i], last, next)) pieces_[number].clear = false;
      add(last, inner[i].node, piece.fixed, tested_in);
      last = inner[i].node;
    }
    add(last, piece.b, piece.fixed, tested_in);
  }

  // Whether the arms of a piece, from its crossing with another to the nodes before and after, leave that one for good.
  bool is_clear(const Split& crossing, Node_index before, Node_index after) const {
    const Place_2 a = nodes_.place(pieces_[crossing.other].a), b = nodes_.place(pieces_[crossing.other].b);
    const double reach = slack(rounding_);
    return clear_side(a, b, nodes_.place(before), reach) * clear_side(a, b, nodes_.place(after), reach) < 0;
  }

  // The same for two pieces and their common end.
  bool is_clear_at_end(std::uint32_t i, std::uint32_t j) const {
    const Piece &p = pieces_[i], &q = pieces_[j];
    if (!have_common_end(i, j)) return false;
    const Node_index common = p.a == q.a || p.a == q.b ? p.a : p.b;
    return are_spread(common, arm(i, common), arm(j, common));
  }

  bool are_spread(Node_index common, Node_index u, Node_index v) const {
    return has_plain_coordinates<Traits> &&
           internal::are_spread(nodes_.place(common), nodes_.place(u), nodes_.place(v), slack(rounding_));
  }

  // The node next to an end of a piece.
  Node_index arm(std::uint32_t i, Node_index end) const {
    const Range parts = all_parts(i);
    const Piece& part = pieces_[end == pieces_[i].a ? parts.first : parts.last - 1];
    return part.a == end ? part.b : part.a;
  }

  // From near pairs of pieces to near pairs of their parts.
  void descend() {
    std::vector<Near_pair> next;
    if (round_ > 0) bring_back(next);
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const auto [i, j] = near_[k];
      if (round_ == 0 && pieces_[i].clear && pieces_[j].clear && (crosses_[k] || is_clear_at_end(i, j))) {
        aside_.push_back(near_[k]);
      } else {
        descend(i, j, next);
      }
    }
    std::uint32_t last = none;
    for (const Split& split : splits_) {
      if (split.piece == last) continue;
      last = split.piece;
      if (!is_aside(last)) descend_around(last, next);
    }
    near_ = std::move(next);
  }

  // Whether all that meets the piece was set aside.
  bool is_aside(std::uint32_t i) const { return pieces_[i].clear && pieces_[i].split_in == 0; }

  void bring_back(std::vector<Near_pair>& result) {
    for (const auto& [i, j] : aside_) descend(i, j, result);
    if (aside_.empty()) return;
    aside_.clear();
    for (std::uint32_t i = 0; i < drawn_; ++i) {
      if (is_aside(i)) descend_around(i, result);
    }
    for (std::uint32_t i = 0; i < drawn_; ++i) pieces_[i].clear = false;
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

  // The parts of a split piece near each other and near those of its neighbours: neighbours that run on were no near
  // pair before one of them was split.
  void descend_around(std::uint32_t i, std::vector<Near_pair>& result) const {
    for_each_neighbour(i, [&](std::uint32_t j) {
      const bool is_whole = pieces_[j].parts == 0, together = pieces_[j].split_in == pieces_[i].split_in;
      const bool is_mine = is_aside(i) == is_aside(j) ? i < j : is_aside(j);
      if (is_whole || (together ? is_mine : is_aside(i))) descend(i, j, result);
    });
    const Range parts = all_parts(i);
    for (std::uint32_t x = parts.first; x < parts.last; ++x) {
      for (std::uint32_t y = x + 1; y < parts.last && boxes_meet(box(x), box(y)); ++y) descend(x, y, result);
    }
  }

  void add_near(std::uint32_t x, Range ys, std::vector<Near_pair>& result) const {
    const Flat_box here = box(x);
    for (std::uint32_t y = ys.first; y < ys.last; ++y) {
      if (boxes_meet(here, box(y)) && !are_apart(nodes_, ends(x), ends(y), 2 * remaining_slack())) {
        descend(x, y, result);
      }
    }
  }

  Flat_box box(std::uint32_t i) const {
    return flat_box(nodes_.box(pieces_[i].a, pieces_[i].b), remaining_slack());
  }
  Step ends(std::uint32_t i) const { return {pieces_[i].a, pieces_[i].b}; }
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
  std::vector<Near_pair> near_, aside_;
  std::vector<char> crosses_;  // per near pair
  double rounding_;
  int round_ = 0;
  std::uint32_t drawn_ = 0;  // the number of pieces before any was split
  std::vector<Piece> pieces_;
  std::vector<Split> splits_;
  std::vector<bool> is_known_;
};

}  // namespace CCSweep::internal

#endif
