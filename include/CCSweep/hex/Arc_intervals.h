// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_ARC_INTERVALS_H
#define CCSWEEP_HEX_ARC_INTERVALS_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Interval_problem.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/hex/trace_cells.h>
#include <CCSweep/internal/Union_find.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace CCSweep {

/// How many intervals each arc has. Arcs above one another have equally many; around every cap they sum up to an even
/// number, so that it can be meshed by quads; and the opposite sides of caps that may get a structured mesh agree.
class Arc_intervals {
 public:
  using Half_arc = Arc_stack::Half_arc;

  /// \param size_of callable as `(std::size_t layer, const Arc_stack::Arc&) -> double`: the edge length wanted
  template <class SizeOf>
  Arc_intervals(const Arc_stack& arcs, const SizeOf& size_of) {
    join_columns(arcs);
    wanted_.assign(number_of_classes_, 0);
    least_.assign(number_of_classes_, 1);
    must_be_even_.assign(number_of_classes_, false);
    is_given_.assign(number_of_classes_, false);
    for (std::size_t k = 0; k < arcs.arcs.size(); ++k) {
      std::map<std::pair<Arc_stack::Node, Arc_stack::Node>, std::size_t> between;
      for (const auto& arc : arcs.arcs[k]) ++between[std::minmax(arc.from, arc.to)];
      for (std::size_t a = 0; a < arcs.arcs[k].size(); ++a) {
        const auto& arc = arcs.arcs[k][a];
        const std::size_t c = class_of_[first_[k] + a];
        const auto [length, turning] = measure(arc);
        // A half, which rounding may have lifted or lowered, counts as lowered.
        wanted_[c] = std::max({wanted_[c], length / size_of(k, arc) - 1e-6, turning / (std::numbers::pi / 6)});
        // No two edges may join the same two nodes, and a closed curve needs the corners of a quad.
        const std::size_t apart = arc.from == arc.to ? 4 : between[std::minmax(arc.from, arc.to)] > 1 ? 2 : 1;
        const auto by_turning = static_cast<std::size_t>(std::ceil(turning / (std::numbers::pi / 3) - 1e-6));
        least_[c] = std::max({least_[c], apart, by_turning});
      }
    }
    for (std::size_t c = 0; c < number_of_classes_; ++c) wanted_[c] = std::max(wanted_[c], double(least_[c]));
  }

  /// \param turns by cell, as of `cell_turns()`
  template <IntervalSolver Solver>
  void solve(const std::vector<Cell>& cells, const std::vector<std::vector<int>>& turns, const Solver& solver) {
    Interval_problem problem{wanted_, least_, {}, {}, is_given_};
    for (std::size_t c = 0; c < number_of_classes_; ++c)
      if (must_be_even_[c]) problem.even.push_back({{c, 1}});
    std::vector<std::array<Interval_problem::Row, 2>> structured;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const Cell& cell = cells[c];
      std::map<std::size_t, int> around;
      for (const Cell::Loop& loop : cell.loops[0])
        for (Half_arc h : loop) ++around[arc_class(cell.top, h)];
      problem.even.emplace_back(around.begin(), around.end());
      if (turns[c].empty()) continue;
      auto rows = rows_of_sides(cell, turns[c]);
      if (is_cheap(rows[0]) && is_cheap(rows[1])) structured.push_back(std::move(rows));
    }
    solve(problem, structured, solver);
  }

  std::size_t operator()(std::size_t layer, Half_arc h) const { return intervals_[arc_class(layer, h)]; }

  /// Fixes the number on an arc, whatever else may be asked for.
  void give(std::size_t layer, Half_arc h, std::size_t count) {
    const std::size_t c = arc_class(layer, h);
    is_given_[c] = true;
    wanted_[c] = double(count);
    least_[c] = count;
  }

  /// Asks for twice as many intervals on all arcs of a class.
  void refine(std::size_t arc_class) {
    if (!is_given_[arc_class]) wanted_[arc_class] *= 2;
  }

  /// Asks for an even number.
  void make_even(std::size_t layer, Half_arc h) {
    const std::size_t c = arc_class(layer, h);
    must_be_even_[c] = !is_given_[c];
  }

  std::size_t arc_class(std::size_t layer, Half_arc h) const { return class_of_[first_[layer] + Arc_stack::arc_of(h)]; }

 private:
  void join_columns(const Arc_stack& arcs) {
    std::size_t count = 0;
    for (const auto& layer : arcs.arcs) {
      first_.push_back(count);
      count += layer.size();
    }
    internal::Union_find classes(count);
    for (std::size_t k = 1; k < arcs.arcs.size(); ++k)
      for (std::size_t a = 0; a < arcs.arcs[k].size(); ++a)
        for (Half_arc below : arcs.arcs[k][a].below)
          if (below != Arc_stack::none) classes.join(first_[k] + a, first_[k - 1] + Arc_stack::arc_of(below));
    std::map<std::size_t, std::size_t> number;
    for (std::size_t i = 0; i < count; ++i)
      class_of_.push_back(number.try_emplace(classes.root(i), number.size()).first->second);
    number_of_classes_ = number.size();
  }

  // The length of an arc, and how far it turns.
  static std::pair<double, double> measure(const Arc_stack::Arc& arc) {
    using namespace internal;
    double length = 0, turning = 0;
    for (std::size_t i = 0; i + 1 < arc.line.size(); ++i) {
      length += norm(arc.line[i + 1] - arc.line[i]);
      if (i > 0) turning += angle(arc.line[i] - arc.line[i - 1], arc.line[i + 1] - arc.line[i]);
    }
    return {length, turning};
  }

  // What the sides in opposite directions must have in common.
  std::array<Interval_problem::Row, 2> rows_of_sides(const Cell& cell, const std::vector<int>& turns) const {
    std::array<std::map<std::size_t, int>, 2> sums;
    int direction = 0;
    const Cell::Loop& loop = cell.loops[0][0];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      direction = (direction + turns[i] + 4) % 4;
      sums[direction % 2][arc_class(cell.top, loop[i])] += direction < 2 ? 1 : -1;
    }
    std::array<Interval_problem::Row, 2> rows;
    for (std::size_t s : {0, 1})
      for (const auto& term : sums[s])
        if (term.second != 0) rows[s].push_back(term);
    return rows;
  }

  // Whether the two sides of a row are not too far from agreeing by themselves.
  bool is_cheap(const Interval_problem::Row& row) const {
    double plus = 0, minus = 0;
    for (const auto& [c, k] : row) (k > 0 ? plus : minus) += std::abs(k) * wanted_[c];
    return row.empty() || (plus > 0 && minus > 0 && std::abs(plus - minus) <= std::max(2.0, std::min(plus, minus)));
  }

  // Where not all caps can be structured at once, those that come first are.
  template <class Solver>
  void solve(Interval_problem problem, const std::vector<std::array<Interval_problem::Row, 2>>& structured,
             const Solver& solver) {
    const auto with = [](Interval_problem p, const std::array<Interval_problem::Row, 2>& rows) {
      for (const auto& row : rows)
        if (!row.empty()) p.equal.push_back(row);
      return p;
    };
    Interval_problem all = problem;
    for (const auto& rows : structured) all = with(std::move(all), rows);
    if (auto found = solver(all)) {
      intervals_ = std::move(*found);
      return;
    }
    auto kept = solver(problem);
    for (const auto& rows : structured)
      if (auto found = solver(with(problem, rows))) {
        problem = with(std::move(problem), rows);
        kept = std::move(found);
      }
    if (!kept)
      internal::fail(Status_code::hex_mesh_failed, Stage::hex_mesh, "there are no numbers of intervals that fit");
    intervals_ = std::move(*kept);
  }

  std::size_t number_of_classes_ = 0;
  std::vector<std::size_t> first_;     // by layer
  std::vector<std::size_t> class_of_;  // by arc of all layers
  std::vector<double> wanted_;         // by class
  std::vector<std::size_t> least_;
  std::vector<bool> must_be_even_, is_given_;
  Intervals intervals_;
};

namespace internal {

/// The nodes of an arc from its one end to the other, equally far apart; measured across the sweep, so that on walls
/// along the sweep columns follow it whatever the slant of the caps.
inline std::vector<Vec3> place_on_arc(const Arc_stack::Arc& arc, std::size_t intervals, const Vec3& up) {
  constexpr double of_rise = 1e-3;
  const auto& line = arc.line;
  std::vector<double> sum{0};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 w = line[i + 1] - line[i];
    sum.push_back(sum.back() + norm(w - dot(w, up) * up) + of_rise * norm(w));
  }
  std::vector<Vec3> nodes{line.front()};
  std::size_t i = 0;
  for (std::size_t k = 1; k < intervals; ++k) {
    const double s = sum.back() * double(k) / double(intervals);
    while (i + 2 < line.size() && sum[i + 1] <= s) ++i;
    const double f = std::clamp((s - sum[i]) / std::max(sum[i + 1] - sum[i], 1e-300), 0.0, 1.0);
    nodes.push_back(line[i] + f * (line[i + 1] - line[i]));
  }
  nodes.push_back(line.back());
  return nodes;
}

}  // namespace internal
}  // namespace CCSweep

#endif
