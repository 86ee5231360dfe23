// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_INTERVAL_PROBLEM_H
#define CCSWEEP_HEX_INTERVAL_PROBLEM_H

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {

/// How many intervals a number of curves should have, and what must hold between these numbers.
///
/// The numbers are to be as near to those wanted as can be: the sum over the curves of the difference over the number
/// wanted is to be least.
struct Interval_problem {
  using Row = std::vector<std::pair<std::size_t, int>>;  ///< curve and coefficient; each curve once

  std::vector<double> wanted;       ///< by curve, above 0
  std::vector<std::size_t> least;   ///< by curve, at least 1
  std::vector<Row> equal;           ///< sums that must vanish: the opposite sides of a structured mesh
  std::vector<Row> even;            ///< sums that must be even: the outline of an all-quad mesh
  std::vector<bool> given = {};     ///< by curve: only the number wanted, a whole one, will do; empty if all are free

  bool is_given(std::size_t curve) const { return !given.empty() && given[curve]; }
};

/// The numbers of a solution, by curve.
using Intervals = std::vector<std::size_t>;

/// How far a solution is from what was wanted.
inline double cost(const Interval_problem& problem, const Intervals& intervals) {
  double sum = 0;
  for (std::size_t i = 0; i < intervals.size(); ++i)
    sum += std::abs(double(intervals[i]) - problem.wanted[i]) / std::max(problem.wanted[i], 1.0);
  return sum;
}

/// Whether all that must hold does.
inline bool is_solution(const Interval_problem& problem, const Intervals& intervals) {
  const auto sum = [&](const Interval_problem::Row& row) {
    long s = 0;
    for (const auto& [i, c] : row) s += c * static_cast<long>(intervals[i]);
    return s;
  };
  for (std::size_t i = 0; i < intervals.size(); ++i)
    if (intervals[i] < problem.least[i] || (problem.is_given(i) && double(intervals[i]) != problem.wanted[i]))
      return false;
  return std::all_of(problem.equal.begin(), problem.equal.end(), [&](const auto& row) { return sum(row) == 0; }) &&
         std::all_of(problem.even.begin(), problem.even.end(), [&](const auto& row) { return sum(row) % 2 == 0; });
}

/// What solves interval problems; nothing where there is no solution, or none was found.
template <class Solver>
concept IntervalSolver = std::copy_constructible<Solver> && requires(const Solver& solver, const Interval_problem& p) {
  { solver(p) } -> std::same_as<std::optional<Intervals>>;
};

}  // namespace CCSweep

#endif
