// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// What chooses how many edges the curves of a hexahedral mesh get, so that opposite sides of structured caps agree and
/// every cap has an even outline.
///
/// Checked at compile time by `CCSweep::IntervalSolver`.
///
/// Models: `CCSweep::Parity_intervals` (the default), `CCSweep::Program_intervals` over any of CGAL's
/// `MixedIntegerProgramTraits`, with GLPK as `CCSweep::Glpk_intervals`.
class IntervalSolver {
 public:
  /// The numbers for a problem, of which `CCSweep::is_solution()` holds; nothing where there are none, or none was
  /// found. Called a few times for each mesh.
  std::optional<CCSweep::Intervals> operator()(const CCSweep::Interval_problem& problem) const;
};
