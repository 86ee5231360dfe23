// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// Watches a decomposition, and may stop it. Given by the named parameter `visitor`, as `std::ref(visitor)` where the
/// visitor has a state.
///
/// Every call comes from the thread that called the algorithm. Where a result fails its verification and the layering
/// is refined, the stages from the layers on run again, with all their calls.
///
/// Checked at compile time by `CCSweep::SweepVisitor` and `CCSweep::SweepVisitorOf`.
///
/// Models: `CCSweep::Visitor_base`, which does nothing and is a base for visitors that need but a few of the calls.
class SweepVisitor {
 public:
  /// \name Progress
  /// @{

  /// Called before the first step of a stage, once for each stage that runs. `total` is the number of its steps, 0 if
  /// it has none.
  void begin(CCSweep::Stage stage, std::size_t total);
  /// Called after each step: `total` times, unless the stage fails or is cancelled.
  void step(CCSweep::Stage stage);
  /// Called after the last step: once, unless the stage fails or is cancelled.
  void end(CCSweep::Stage stage);
  /// Asked before each step, at least once for each. When it returns true the algorithm ends with
  /// `CCSweep::Status_code::cancelled`.
  bool cancel();

  /// @}
  /// \name Topology
  /// @{

  /// Called before the loops of a layer are overlaid: once for each layer, in ascending order. `drawing` is a
  /// `CCSweep::Layer_drawing`, `patch_id[i]` the id of its label i; both live as long as the call.
  template <class LayerDrawing>
  void drawn(std::size_t layer, const LayerDrawing& drawing, const std::vector<int>& patch_id);
  /// Called after the sources and targets of a layer have been overlaid: once for each level, in ascending order.
  /// `graph` is a model of `LoopFaceGraph` and lives as long as the call.
  template <class LoopFaceGraph>
  void imprinted(std::size_t layer, const LoopFaceGraph& graph);

  /// @}
};
