// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VISITOR_H
#define CCSWEEP_VISITOR_H

#include <CCSweep/Status.h>

#include <concepts>
#include <cstddef>
#include <vector>

namespace CCSweep {

/// Watches a decomposition, and may stop it.
///
/// - `begin(stage, total)` comes before the first step of a stage, once for each stage that runs; `total` is its number
///   of steps, 0 if it has none.
/// - `step(stage)` comes after each step: `total` times, unless the stage fails or is cancelled.
/// - `end(stage)` comes after the last step: once, unless the stage fails or is cancelled.
/// - `cancel()` comes before each step, at least once for each; when it returns true the call ends with
///   `Status_code::cancelled`.
/// - `drawn(layer, drawing, patch_id)` comes before the loops of a layer are overlaid, once for each layer; `drawing`
///   is a `Layer_drawing`, `patch_id[i]` the id of its label i, and both live as long as the call.
/// - `imprinted(layer, graph)` comes after the sources and targets of a layer have been overlaid, once for each level;
///   `graph` is a model of `LoopFaceGraph` and lives as long as the call.
///
/// Where a result fails its verification and the layering is refined, where several axes compete, or where the
/// hexahedra of a sub-volume are swept anew, the stages from the layers on run again, with all their calls. Every call
/// comes from the thread that called the algorithm.
template <class V>
concept SweepVisitor = requires(V& visitor, Stage stage, std::size_t total) {
  visitor.begin(stage, total);
  visitor.step(stage);
  visitor.end(stage);
  { visitor.cancel() } -> std::convertible_to<bool>;
};

/// A `SweepVisitor` that also takes the layers, before and after their imprint.
template <class V, class LayerDrawing, class LoopFaceGraph>
concept SweepVisitorOf =
    SweepVisitor<V> && requires(V& visitor, std::size_t layer, const LayerDrawing& drawing,
                                const std::vector<int>& patch_id, const LoopFaceGraph& graph) {
      visitor.drawn(layer, drawing, patch_id);
      visitor.imprinted(layer, graph);
    };

/// The visitor that does nothing: the default, and a base for those that need but a few of the calls. Calls are bound
/// at compile time, so that a call nobody overrides costs nothing.
struct Visitor_base {
  void begin(Stage, std::size_t) {}
  void step(Stage) {}
  void end(Stage) {}
  bool cancel() { return false; }
  template <class LayerDrawing>
  void drawn(std::size_t, const LayerDrawing&, const std::vector<int>&) {}
  template <class LoopFaceGraph>
  void imprinted(std::size_t, const LoopFaceGraph&) {}
};

}  // namespace CCSweep

#endif
