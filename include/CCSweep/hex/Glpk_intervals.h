// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_GLPK_INTERVALS_H
#define CCSWEEP_HEX_GLPK_INTERVALS_H

#include <CCSweep/hex/Interval_problem.h>

#include <CGAL/GLPK_mixed_integer_program_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CCSweep {

/// Solves interval problems as mixed integer programs, exactly, with any of the solvers behind CGAL's
/// `MixedIntegerProgramTraits`. The part that a number strays from what is wanted is a variable of its own, and an even
/// sum is twice a whole number. No number may be much larger than what is wanted, so that the search has an end.
/// \tparam ProgramTraits a model of CGAL's `MixedIntegerProgramTraits`
template <class ProgramTraits>
class Program_intervals {
 public:
  std::optional<Intervals> operator()(const Interval_problem& problem) const {
    using Variable = typename ProgramTraits::Variable;
    ProgramTraits program;
    const std::size_t n = problem.wanted.size();
    std::vector<Variable*> count;
    for (std::size_t i = 0; i < n; ++i) {
      const bool is_given = problem.is_given(i);
      const double least = is_given ? problem.wanted[i] : double(problem.least[i]);
      const double most_of_it = is_given ? least : 10 + std::ceil(3 * std::max(least, problem.wanted[i]));
      count.push_back(program.create_variable(Variable::INTEGER, least, most_of_it, name("n", i)));
      Variable* stray = program.create_variable(Variable::CONTINUOUS, 0, most, name("d", i));
      for (double sign : {1.0, -1.0}) {  // stray >= sign * (count - wanted)
        auto* row = program.create_constraint(-sign * problem.wanted[i], most);
        row->add_coefficient(stray, 1);
        row->add_coefficient(count[i], -sign);
      }
      program.objective()->add_coefficient(stray, 1 / std::max(problem.wanted[i], 1.0));
    }
    for (const auto& row : problem.equal) add_row(*program.create_constraint(0, 0), count, row);
    for (const auto& row : problem.even) {
      auto* sum = program.create_constraint(0, 0);
      add_row(*sum, count, row);
      sum->add_coefficient(program.create_variable(Variable::INTEGER, 0, most, ""), -2);
    }
    program.objective()->set_sense(ProgramTraits::Linear_objective::MINIMIZE);
    if (n == 0) return Intervals();
    if (!program.solve()) return std::nullopt;
    Intervals intervals;
    for (std::size_t i = 0; i < n; ++i)
      intervals.push_back(static_cast<std::size_t>(std::lround(std::max(0.0, program.solution()[count[i]->index()]))));
    return is_solution(problem, intervals) ? std::optional(intervals) : std::nullopt;
  }

 private:
  static constexpr double most = 1e20;  // infinity for CGAL

  static std::string name(const char* kind, std::size_t i) { return kind + std::to_string(i); }

  template <class Constraint, class Variable>
  static void add_row(Constraint& constraint, const std::vector<Variable*>& count, const Interval_problem::Row& row) {
    for (const auto& [i, c] : row) constraint.add_coefficient(count[i], c);
  }
};

/// Solves interval problems with GLPK.
using Glpk_intervals = Program_intervals<CGAL::GLPK_mixed_integer_program_traits<double>>;

}  // namespace CCSweep

#endif
