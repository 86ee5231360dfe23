// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// The kernel of a decomposition, given by the named parameter `geom_traits`: the part of CGAL's `Kernel` that the
/// stages use.
///
/// Predicates must be exact. Constructions may round; what was constructed is then checked again by predicates. With
/// exact constructions nothing is rounded in memory, and the volumes of the sub-volumes add up to the part's exactly.
///
/// Checked at compile time by `CCSweep::SweepTraits` in `CCSweep/concepts.h`.
///
/// Models: `CGAL::Exact_predicates_inexact_constructions_kernel` (the usual choice),
/// `CGAL::Exact_predicates_exact_constructions_kernel`, `CGAL::Simple_cartesian<CGAL::Exact_rational>`.
class SweepTraits {
 public:
  /// \name Types
  /// @{
  /// A field number type, with `CGAL::to_double()` and `CGAL::to_interval()`.
  typedef unspecified_type FT;
  /// A point in a chart.
  typedef unspecified_type Point_2;
  /// A segment in a chart.
  typedef unspecified_type Segment_2;
  /// A point in space.
  typedef unspecified_type Point_3;
  /// A vector in space.
  typedef unspecified_type Vector_3;
  /// @}

  /// \name Predicates
  /// Functors of CGAL's kernel of the same names, exact.
  /// @{
  /// The turn of three points.
  Orientation_2 orientation_2_object() const;
  /// The lexicographic order of two points.
  Compare_xy_2 compare_xy_2_object() const;
  /// Whether the second of three points on a line lies between the others.
  Collinear_are_ordered_along_line_2 collinear_are_ordered_along_line_2_object() const;
  /// Whether two segments meet.
  Do_intersect_2 do_intersect_2_object() const;
  /// The test of Delaunay triangulations.
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const;
  /// The side of a point to the plane of three others.
  Orientation_3 orientation_3_object() const;
  /// Whether three points lie on a line.
  Collinear_3 collinear_3_object() const;
  /// The lexicographic order of two points; the canonical order of a part rests on it.
  Compare_xyz_3 compare_xyz_3_object() const;
  /// @}

  /// \name Constructions
  /// @{
  /// Where two segments meet.
  Intersect_2 intersect_2_object() const;
  /// A vector across two others.
  Construct_cross_product_vector_3 construct_cross_product_vector_3_object() const;
  /// @}
};
