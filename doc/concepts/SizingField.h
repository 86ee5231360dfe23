// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// The edge lengths wanted of a hexahedral mesh. Where several apply to an edge, the smallest counts. Patches are named
/// by their ids.
///
/// Checked at compile time by `CCSweep::SizingField`.
///
/// Models: `CCSweep::Patch_sizes`, and a `double` is taken for one size everywhere.
class SizingField {
 public:
  /// On the whole part; also the height of the layers.
  double on_part() const;
  /// On a patch.
  double on_patch(int id) const;
  /// On the curves between two patches.
  double on_curve(int a, int b) const;
  /// Whether all sizes are finite numbers above 0; others are refused as `invalid_parameter`.
  bool are_valid() const;
};
