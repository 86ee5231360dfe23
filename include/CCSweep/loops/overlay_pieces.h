// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_PIECES_H
#define CCSWEEP_LOOPS_OVERLAY_PIECES_H

#include <CCSweep/internal/bucket_sort.h>
#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_forest.h>
#include <CCSweep/loops/overlay_near.h>
#include <CCSweep/loops/overlay_nodes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
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

  // `chains` in the nodes, a piece for each of their `steps`; `fixed` for each chain; `twins` as `first_twins` tells,
  // or empty; `near` are all pairs of pieces that may come within the slack and twice the tolerance of each other,
  // except those of neighbours which run on.
  template <class Fixed>
  Overlay_pieces(Layer_nodes<Traits>& nodes, const Node_chains& chains, const std::vector<Step>& steps,
                 const Fixed& fixed, const std::vector<std::uint32_t>& twins, std::vector<Near_pair> near,
                 double tolerance, double rounding)
      : nodes_(nodes),
        forest_(nodes, chains, steps, fixed, twins),
        pool_(nodes, tolerance, rounding),
        near_(std::move(near)),
        rounding_(rounding),
        is_known_(nodes.points.size(), false) {}

  // O((n + c) log n) for n near pairs and c crossings.
  void split_all() {
    for (round_ = 0;; ++round_) {
      find_twins();
      find_splits();
      if (splits_.empty()) return;
      if (round_ == maximal_rounds || (round_ > 0 && forest_.size() > maximal_growth * first_size_)) {
        fail_imprint(nodes_, splits_.front().node, "crossings keep moving under rounding; use an exact kernel");
      }
      if (!apply_splits()) return;
      if (round_ == 0) first_size_ = forest_.size();
      descend();
    }
  }

  // The chains after splitting.
  Node_chains expanded() const { return forest_.expanded(); }

 private:
  static constexpr int maximal_rounds = 30;
  static constexpr std::size_t maximal_growth = 8;  // of the number of pieces, after the first round
  static constexpr std::uint32_t none = Piece::none;

  struct Split {
    std::uint32_t piece;
    Node_index node;
    std::uint32_t other;  // the piece that it crosses there, if it does
    bool exact;           // the node lies exactly on the piece
    auto operator<=>(const Split&) const = default;
  };

  bool is_new(std::uint32_t i) const { return forest_[i].tested_in == round_; }
  const typename Traits::Point_2& point(Node_index n) const { return nodes_.point(n); }

  // Of pieces with the same ends the first stands for all, and nothing more need be known of the others.
  void find_twins() {
    std::vector<std::uint32_t> twins;
    for (const auto& [i, j] : near_) {
      if (forest_[i].a != forest_[j].a || forest_[i].b != forest_[j].b || i == j) continue;
      const std::uint32_t second = std::max(i, j);
      if (!forest_.has_twin(second)) twins.push_back(second);
      forest_[second].twin = std::min(forest_[second].twin, std::min(i, j));
    }
    if (twins.empty()) return;
    for (std::uint32_t i : twins) {
      std::uint32_t first = forest_[i].twin;
      while (forest_.has_twin(first)) first = forest_[first].twin;
      forest_.make_twin(i, first);
    }
    std::erase_if(near_,
                  [this](const Near_pair& p) { return forest_.has_twin(p.first) || forest_.has_twin(p.second); });
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
    bucket_sort(
        crossings, forest_.size(), [](const Near_pair& c) { return c.first; }, std::less<>());
    const std::vector<char> crowded = are_crowded(crossings);
    remember_nodes(crossings, crowded);
    for (std::size_t c = 0; c < crossings.size(); ++c) cross(crossings[c].first, crossings[c].second, crowded[c]);
  }

  // Whether anything but the two pieces may be near their crossing, so that it has to give way to another node. What
  // has an end in common with one of them is near the other as well, if it is near the crossing.
  std::vector<char> are_crowded(const std::vector<Near_pair>& crossings) const {
    std::vector<std::uint32_t> number_near(forest_.size(), 0);
    for (const auto& [i, j] : near_) {
      if (forest_.have_common_end(i, j)) continue;
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
      for (Node_index n : {forest_[i].a, forest_[i].b}) {
        if (n.value() >= is_known_.size() || is_known_[n.value()]) continue;
        is_known_[n.value()] = true;
        pool_.remember(n);
      }
    };
    for (std::size_t c = 0; c < crossings.size(); ++c) {
      if (!crowded[c]) continue;
      if (crosses.empty()) crosses.resize(forest_.size(), false);
      for (std::uint32_t i : {crossings[c].first, crossings[c].second}) {
        crosses[i] = true;
        forest_.for_each_neighbour(i, remember);
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
    const Piece &p = forest_[i], &q = forest_[j];
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
    const auto &a = point(forest_[i].a), &b = point(forest_[i].b), &p = point(n);
    if (is_less_xy<Traits>(a, p) == is_less_xy<Traits>(p, b) && !is_equal<Traits>(a, p) && !is_equal<Traits>(p, b)) {
      split_at(i, n);
    }
  }

  void cross(std::uint32_t i, std::uint32_t j, bool is_crowded) {
    const Piece &p = forest_[i], &q = forest_[j];
    const bool fixed = p.fixed || q.fixed;
    const std::array<Node_index, 4> ends{p.a, p.b, q.a, q.b};
    const std::size_t first_new = nodes_.points.size();
    const auto [node, exact] =
        is_crowded ? pool_.crossing(ends, fixed, round_ == 0 && !fixed) : pool_.lonely_crossing(ends, fixed);
    if (node.value() < first_new) forest_[i].clear = forest_[j].clear = false;
    split({i, node, j, exact});
    split({j, node, i, exact});
  }

  // Splits a piece at a node that lies on it.
  void split_at(std::uint32_t piece, Node_index node) {
    forest_[piece].clear = false;
    split({piece, node, none, true});
  }

  void split(const Split& split) {
    const Piece& piece = forest_[split.piece];
    if (split.node == piece.a || split.node == piece.b) return;
    splits_.push_back(split);
    if (piece.fixed) nodes_.fixed[split.node.value()] = true;
  }

  // Whether anything has moved.
  bool apply_splits() {
    bucket_sort(
        splits_, forest_.size(), [](const Split& split) { return split.piece; }, std::less<>());
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
          forest_[piece].clear = false;
        }
      }
      split_piece(piece, inner, exact);
      any_moved = any_moved || !exact;
    }
    return any_moved;
  }

  void split_piece(std::uint32_t number, std::vector<Split>& inner, bool exact) {
    const Piece piece = forest_[number];
    if (inner.size() > 1) {
      const Along<Traits> along(point(piece.a), point(piece.b));
      std::sort(inner.begin(), inner.end(), [&](const Split& s, const Split& t) {
        const auto order = along(point(s.node), point(t.node));
        return order == CGAL::SMALLER || (order == CGAL::EQUAL && s.node < t.node);
      });
    }
    forest_.begin_parts(number, inner.size() + 1);
    forest_[number].split_in = static_cast<std::int8_t>(round_);
    const int tested_in = exact ? -1 : round_ + 1;
    Node_index last = piece.a;
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const Node_index next = i + 1 < inner.size() ? inner[i + 1].node : piece.b;
      if (forest_[number].clear && !is_clear(inner[i], last, next)) forest_[number].clear = false;
      forest_.add(last, inner[i].node, piece.fixed, tested_in);
      last = inner[i].node;
    }
    forest_.add(last, piece.b, piece.fixed, tested_in);
  }

  // Whether the arms of a piece, from its crossing with another to the nodes before and after, leave that one for good.
  bool is_clear(const Split& crossing, Node_index before, Node_index after) const {
    const Place_2 a = nodes_.place(forest_[crossing.other].a), b = nodes_.place(forest_[crossing.other].b);
    const double reach = slack(rounding_);
    return clear_side(a, b, nodes_.place(before), reach) * clear_side(a, b, nodes_.place(after), reach) < 0;
  }

  // The same for two pieces and their common end.
  bool is_clear_at_end(std::uint32_t i, std::uint32_t j) const {
    const Piece &p = forest_[i], &q = forest_[j];
    if (!forest_.have_common_end(i, j)) return false;
    const Node_index common = p.a == q.a || p.a == q.b ? p.a : p.b;
    return are_spread(common, forest_.arm(i, common), forest_.arm(j, common));
  }

  bool are_spread(Node_index common, Node_index u, Node_index v) const {
    return has_plain_coordinates<Traits> &&
           internal::are_spread(nodes_.place(common), nodes_.place(u), nodes_.place(v), slack(rounding_));
  }

  // From near pairs of pieces to near pairs of their parts.
  void descend() {
    std::vector<Near_pair> next;
    if (round_ > 0) bring_back(next);
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const auto [i, j] = near_[k];
      if (round_ == 0 && forest_[i].clear && forest_[j].clear && (crosses_[k] || is_clear_at_end(i, j))) {
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
  bool is_aside(std::uint32_t i) const { return forest_[i].clear && forest_[i].split_in == 0; }

  void bring_back(std::vector<Near_pair>& result) {
    for (const auto& [i, j] : aside_) descend(i, j, result);
    aside_.clear();
    for (std::uint32_t i = 0; i < forest_.number_drawn(); ++i) {
      if (is_aside(i)) descend_around(i, result);
    }
    for (std::uint32_t i = 0; i < forest_.number_drawn(); ++i) forest_[i].clear = false;
  }

  void descend(std::uint32_t i, std::uint32_t j, std::vector<Near_pair>& result) const {
    if (forest_.has_twin(i) || forest_.has_twin(j)) return;
    if (forest_[i].parts == 0 && forest_[j].parts == 0) {
      result.emplace_back(i, j);
      return;
    }
    const Piece_range xs = parts_near(i, j);
    for (std::uint32_t x = xs.first; x < xs.last; ++x) add_near(x, parts_near(j, x), result);
  }

  // The parts of a split piece near each other and near those of its neighbours: neighbours that run on were no near
  // pair before one of them was split.
  void descend_around(std::uint32_t i, std::vector<Near_pair>& result) const {
    forest_.for_each_neighbour(i, [&](std::uint32_t j) {
      const bool is_whole = forest_[j].parts == 0, together = forest_[j].split_in == forest_[i].split_in;
      const bool is_mine = is_aside(i) == is_aside(j) ? i < j : is_aside(j);
      if (is_whole || (together ? is_mine : is_aside(i))) descend(i, j, result);
    });
    const Piece_range parts = forest_.all_parts(i);
    for (std::uint32_t x = parts.first; x < parts.last; ++x) {
      for (std::uint32_t y = x + 1; y < parts.last && boxes_meet(box(x), box(y)); ++y) descend(x, y, result);
    }
  }

  void add_near(std::uint32_t x, Piece_range ys, std::vector<Near_pair>& result) const {
    const Flat_box here = box(x);
    for (std::uint32_t y = ys.first; y < ys.last; ++y) {
      if (boxes_meet(here, box(y)) && !are_apart(nodes_, forest_.ends(x), forest_.ends(y), 2 * remaining_slack())) {
        descend(x, y, result);
      }
    }
  }

  // The parts of a piece that may be near another one.
  Piece_range parts_near(std::uint32_t i, std::uint32_t j) const {
    return forest_.parts_near(i, box(j), remaining_slack());
  }
  Flat_box box(std::uint32_t i) const { return forest_.box(i, remaining_slack()); }
  // What rounding may still do after this round.
  double remaining_slack() const { return slack(rounding_) * (maximal_rounds - round_) / maximal_rounds; }

  Layer_nodes<Traits>& nodes_;
  Piece_forest<Traits> forest_;
  Crossing_pool<Traits> pool_;
  std::vector<Near_pair> near_, aside_;
  std::vector<char> crosses_;  // per near pair
  double rounding_;
  int round_ = 0;
  std::size_t first_size_ = 0;  // the number of pieces after the first round
  std::vector<Split> splits_;
  std::vector<bool> is_known_;
};

}  // namespace CCSweep::internal

#endif
