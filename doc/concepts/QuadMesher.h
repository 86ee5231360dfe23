// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// What meshes the plane section of a cell with quads, which are then swept from its source to its target.
///
/// Checked at compile time by `CCSweep::QuadMesher`.
///
/// Models: `CCSweep::Best_quads` (the default), `CCSweep::Structured_quads`, `CCSweep::Matched_quads`,
/// `CCSweep::Subdivided_quads`, and where Gmsh's library is linked, `CCSweep::Gmsh_quads`.
class QuadMesher {
 public:
  /// Quads that cover a region, counter-clockwise. The nodes on the region's loops come first, in their order, and no
  /// others may lie on the loops; `size` is the edge length wanted inside. Nothing where the mesher can't mesh the
  /// region, which `CCSweep::Subdivided_quads` then does.
  std::optional<CCSweep::Quad_mesh> operator()(const CCSweep::Quad_region& region, double size) const;
};
