// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_PARITY_INTERVALS_H
#define CCSWEEP_HEX_PARITY_INTERVALS_H

#include <CCSweep/hex/Interval_problem.h>

#include <boost/dynamic_bitset.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// Chooses which numbers of a problem are odd, so that all its sums are even: by elimination modulo 2, in which the
/// numbers that bear a change worst are left free, and the others adjust; those that are given do so last, where there
/// is no solution.
class Parity_choice {
 public:
  explicit Parity_choice(const Interval_problem& problem) : n_(problem.wanted.size()), order_(n_) {
    std::iota(order_.begin(), order_.end(), std::size_t(0));
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(problem.is_given(b), problem.wanted[a]) > std::pair(problem.is_given(a), problem.wanted[b]);
    });
    for (const auto* rows : {&problem.equal, &problem.even})
      for (const Interval_problem::Row& row : *rows) {
        auto& bits = rows_.emplace_back(n_);
        for (const auto& [i, c] : row) bits[i] = c % 2 != 0;
      }
  }

  boost::dynamic_bitset<> run(boost::dynamic_bitset<> odd) {
    std::vector<std::pair<std::size_t, std::size_t>> pivots;  // row, number
    std::size_t done = 0;
    for (std::size_t i : order_) {
      std::size_t r = done;
      while (r < rows_.size() && !rows_[r][i]) ++r;
      if (r == rows_.size()) continue;
      std::swap(rows_[r], rows_[done]);
      for (std::size_t s = 0; s < rows_.size(); ++s)
        if (s != done && rows_[s][i]) rows_[s] ^= rows_[done];
      pivots.push_back({done++, i});
    }
    for (const auto& [row, i] : pivots) {
      odd[i] = false;
      odd[i] = (rows_[row] & odd).count() % 2 != 0;
    }
    return odd;
  }

 private:
  std::size_t n_;
  std::vector<std::size_t> order_;
  std::vector<boost::dynamic_bitset<>> rows_;
};

/// Looks for the best solution near a first one by branch and bound, one number after another, as long as its patience
/// lasts.
class Interval_search {
 public:
  Interval_search(const Interval_problem& problem, Intervals first)
      : problem_(problem), now_(problem.wanted.size()), best_(std::move(first)), best_cost_(cost(problem, best_)),
        rows_of_(now_.size()) {
    for (const auto& row : problem.equal) add_row(row, false);
    for (const auto& row : problem.even) add_row(row, true);
  }

  Intervals run() {
    branch(0, 0);
    return best_;
  }

 private:
  struct Row {
    bool is_parity;
    std::size_t last;  // the number that completes it
    const Interval_problem::Row* terms;
  };

  void add_row(const Interval_problem::Row& terms, bool is_parity) {
    if (terms.empty()) return;
    std::size_t last = 0;
    for (const auto& [i, c] : terms) last = std::max(last, i);
    rows_of_[last].push_back({is_parity, last, &terms});
  }

  bool holds(const Row& row) const {
    long sum = 0;
    for (const auto& [i, c] : *row.terms) sum += c * static_cast<long>(now_[i]);
    return row.is_parity ? sum % 2 == 0 : sum == 0;
  }

  // Tries the values of one number, the nearest to the one wanted first.
  void branch(std::size_t i, double spent) {
    if (i == now_.size()) {
      best_ = now_;
      best_cost_ = spent;
      return;
    }
    const auto nearest = static_cast<long>(std::lround(problem_.wanted[i]));
    const long most = problem_.is_given(i) ? 1 : std::numeric_limits<long>::max();  // of steps
    for (long step = 0; patience_ > 0 && step < most; ++step) {
      double least_of_step = std::numeric_limits<double>::infinity();
      for (long value : {nearest - step, nearest + step}) {
        const double price = std::abs(double(value) - problem_.wanted[i]) / std::max(problem_.wanted[i], 1.0);
        least_of_step = std::min(least_of_step, spent + price);
        if (value < static_cast<long>(problem_.least[i]) || spent + price >= best_cost_ - 1e-9) continue;
        if (--patience_ == 0) return;
        now_[i] = static_cast<std::size_t>(value);
        if (std::all_of(rows_of_[i].begin(), rows_of_[i].end(), [&](const Row& r) { return holds(r); }))
          branch(i + 1, spent + price);
        if (step == 0) break;
      }
      if (least_of_step >= best_cost_ - 1e-9) return;
    }
  }

  const Interval_problem& problem_;
  Intervals now_, best_;
  double best_cost_;
  std::vector<std::vector<Row>> rows_of_;  // by the number that completes them
  long patience_ = 20000;
};

}  // namespace internal

/// Solves interval problems without a library: chooses the parities so that all sums are even, takes the nearest
/// numbers of these parities, evens out the sums that must vanish by steps of two, and then improves what it has by
/// branch and bound. The answer is exact for about a dozen numbers, as the search then comes to its end.
/// Complexity: O(r^2 n / 64) for r rows and n numbers, and a bounded search.
class Parity_intervals {
 public:
  std::optional<Intervals> operator()(const Interval_problem& problem) const {
    const std::size_t n = problem.wanted.size();
    boost::dynamic_bitset<> odd(n);
    for (std::size_t i = 0; i < n; ++i) odd[i] = nearest(problem, i) % 2 != 0;
    odd = internal::Parity_choice(problem).run(std::move(odd));
    Intervals intervals(n);
    for (std::size_t i = 0; i < n; ++i) intervals[i] = nearest(problem, i, odd[i]);
    if (!even_out(problem, intervals)) return std::nullopt;
    return internal::Interval_search(problem, std::move(intervals)).run();
  }

 private:
  static std::size_t nearest(const Interval_problem& problem, std::size_t i) {
    return std::max(problem.least[i], static_cast<std::size_t>(std::max(1.0, std::round(problem.wanted[i]))));
  }

  static std::size_t nearest(const Interval_problem& problem, std::size_t i, bool is_odd) {
    const std::size_t k = nearest(problem, i);
    if ((k % 2 != 0) == is_odd) return k;
    return k - 1 >= problem.least[i] && double(k) > problem.wanted[i] ? k - 1 : k + 1;
  }

  // The side that is too short grows, at its longest curve; if all its curves are given, the other one shrinks. A
  // change in one row reaches others, so this goes on till nothing changes, boundedly.
  static bool even_out(const Interval_problem& problem, Intervals& intervals) {
    constexpr int passes = 40;
    for (int pass = 0; pass < passes; ++pass) {
      bool changed = false;
      for (const auto& row : problem.equal) {
        long sum = 0;
        for (const auto& [i, c] : row) sum += c * static_cast<long>(intervals[i]);
        if (sum == 0) continue;
        if (!grow(problem, row, sum, intervals) && !shrink(problem, row, sum, intervals)) return false;
        changed = true;
      }
      if (!changed) return is_solution(problem, intervals);
    }
    return false;
  }

  static bool grow(const Interval_problem& problem, const Interval_problem::Row& row, long sum, Intervals& intervals) {
    std::size_t longest = intervals.size();
    for (const auto& [i, c] : row)
      if (std::abs(c) == 1 && (c < 0) == (sum > 0) && !problem.is_given(i) &&
          (longest == intervals.size() || problem.wanted[i] > problem.wanted[longest]))
        longest = i;
    if (longest == intervals.size()) return false;
    intervals[longest] += static_cast<std::size_t>(std::abs(sum));
    return true;
  }

  // By an even number, as sums that must be even are so already.
  static bool shrink(const Interval_problem& problem, const Interval_problem::Row& row, long sum,
                     Intervals& intervals) {
    std::size_t most_to_spare = intervals.size();
    const auto spare = [&](std::size_t i) { return (intervals[i] - problem.least[i]) / 2 * 2; };
    for (const auto& [i, c] : row)
      if (std::abs(c) == 1 && (c > 0) == (sum > 0) && !problem.is_given(i) &&
          (most_to_spare == intervals.size() || spare(i) > spare(most_to_spare)))
        most_to_spare = i;
    if (most_to_spare == intervals.size() || spare(most_to_spare) == 0) return false;
    intervals[most_to_spare] -= std::min(spare(most_to_spare), static_cast<std::size_t>(std::abs(sum)));
    return true;
  }
};

}  // namespace CCSweep

#endif
