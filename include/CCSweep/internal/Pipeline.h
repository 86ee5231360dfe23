// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_PIPELINE_H
#define CCSWEEP_INTERNAL_PIPELINE_H

#include <CCSweep/internal/Options.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/make_layering.h>
#include <CCSweep/linking/make_wall_sections.h>
#include <CCSweep/loops/sweep_layers.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/volumes/Decomposition.h>
#include <CCSweep/volumes/draw_cuts.h>
#include <CCSweep/volumes/make_cut_rows.h>
#include <CCSweep/volumes/make_sub_volumes.h>

#include <chrono>
#include <map>
#include <string>
#include <utility>

namespace CCSweep::internal {

/// Runs the stages one after another, tells the visitor and takes the time.
template <class Visitor>
class Stage_runner {
 public:
  explicit Stage_runner(Visitor& visitor) : visitor_(visitor) {}

  template <class Function>
  auto operator()(Stage stage, Function&& function) {
    if (visitor_.cancel()) fail(Status_code::cancelled, stage, "cancelled");
    visitor_.begin(stage, 0);
    const auto start = std::chrono::steady_clock::now();
    auto result = function();
    seconds_[name(stage)] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!result) throw Failure{result.status()};
    visitor_.end(stage);
    return std::move(result).value();
  }

  const std::map<std::string, double>& seconds() const { return seconds_; }

 private:
  Visitor& visitor_;
  std::map<std::string, double> seconds_;
};

/// What an attempt does beyond the plain one.
struct Refinement {
  bool follows_walls = false;     ///< inner columns get vertices where the wall beside them bends
  bool through_vertices = false;  ///< rows pass through the vertices of the linking faces
  bool divides_walls = false;     ///< as of `divide_walls()`
  int times_slabs = 1;            ///< how many more slabs there are between two levels
  double reach = 0;               ///< how far what was carried up snaps to the surface, in tolerances
};

/// The layers of a part and what was swept through them.
template <class Traits>
struct Swept_layers {
  Layering layering;
  Layered_loops<Traits> loops;
};

/// The stages that sweep (section 2, steps 1 to 5), for one choice of roles.
/// \param tolerance absolute
/// \param reach as of `Refinement`
template <class Traits, class SegmentIndex, class PointIndex, class Visitor>
Swept_layers<Traits> sweep(const Part<Traits>& part, const Roles& roles, const Layering_options& options,
                           double tolerance, double reach, std::size_t neighbours, Visitor& visitor,
                           Stage_runner<Visitor>& run) {
  Layering layering = run(Stage::layers, [&] { return make_layering(part, roles, options); });
  const Wall_sections sections = run(Stage::linking_mesh, [&] { return make_wall_sections(part, roles, layering); });
  Layered_loops<Traits> loops = run(Stage::loop_faces, [&] {
    return sweep_layers<Traits, SegmentIndex, PointIndex>(part, roles, layering, sections, tolerance, neighbours,
                                                          visitor, reach * tolerance);
  });
  return {std::move(layering), std::move(loops)};
}

/// The stages that cut (section 2, steps 6 and 7).
/// \param follows_walls as of `Refinement`
template <class Traits, class Visitor>
Decomposition<typename Traits::Point_3> cut(const Part<Traits>& part, const Roles& roles,
                                            Swept_layers<Traits> swept, bool follows_walls,
                                            Stage_runner<Visitor>& run) {
  const auto rows = run(Stage::decomposition_sets, [&] { return make_cut_rows(part, swept.layering, swept.loops); });
  return run(Stage::sub_volumes, [&] {
    return guarded([&] {
      const auto surface = value_or_fail(draw_cuts(part, roles, swept.loops, rows, follows_walls));
      return value_or_fail(make_sub_volumes(part, roles, swept.layering, swept.loops, rows, surface));
    });
  });
}

/// The stages from the roles on (section 2, steps 1 to 7), for one choice of roles.
template <class Traits, class SegmentIndex, class PointIndex, class Visitor>
class Pipeline {
  using Point_3 = typename Traits::Point_3;

 public:
  Pipeline(const Part<Traits>& part, const Options& options, Visitor& visitor, Stage_runner<Visitor>& run)
      : part_(part), options_(options), visitor_(visitor), run_(run) {}

  Decomposition<Point_3> operator()(const Roles& roles, const Refinement& refinement) {
    Layering_options layers = options_.layering;
    layers.through_vertices = refinement.through_vertices;
    layers.slabs *= refinement.times_slabs;
    const double tolerance = options_.tolerance * part_.diagonal;
    auto swept = sweep<Traits, SegmentIndex, PointIndex>(part_, roles, layers, tolerance, refinement.reach,
                                                         options_.neighbours, visitor_, run_);
    Decomposition<Point_3> result = cut(part_, roles, std::move(swept), refinement.follows_walls, run_);
    result.tolerance = tolerance;
    return result;
  }

 private:
  const Part<Traits>& part_;
  const Options& options_;
  Visitor& visitor_;
  Stage_runner<Visitor>& run_;
};

}  // namespace CCSweep::internal

#endif
