// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup Concepts
/// A spatial index over segments in the plane, built once for each layer from the segments' boxes and asked for the
/// segments whose box meets a given one.
///
/// It must report every such segment, each once, in any order. It may report more: the caller decides by exact
/// predicates, so boxes rounded outwards to `double` serve every kernel, and the choice of an index never changes a
/// result.
///
/// An index may also have a member template `OutputIterator pairs(OutputIterator out) const` that writes all pairs of
/// its own segments whose boxes meet, each once and the lower number first, as pairs of `std::uint32_t`. Then it is a
/// `CCSweep::SelfJoiningSegmentIndex_2`, and is asked for this instead of once for every box.
///
/// Checked at compile time by `CCSweep::SegmentIndex_2`.
///
/// What the imprint puts into it are not single segments but the boxes of short runs of consecutive ones, for outlines
/// are ordered; so there are an eighth as many boxes and queries as segments.
///
/// Models: `CCSweep::Rtree_segment_index_2` (the default), `CCSweep::Run_segment_index_2` (a hierarchy of boxes over
/// runs of consecutive segments, which needs no sorting and joins itself), `CCSweep::Brute_force_segment_index_2` (the
/// oracle).
class SegmentIndex_2 {
 public:
  /// Takes the boxes of all segments. Segment `i` is the one with the box `boxes[i]`. Called once for each set of
  /// segments that is imprinted.
  explicit SegmentIndex_2(const std::vector<CGAL::Bbox_2>& boxes);

  /// Writes the number of every segment whose box meets `box`, touching included. Constant, so that several threads
  /// may ask.
  template <class OutputIterator>
  OutputIterator candidates(const CGAL::Bbox_2& box, OutputIterator out) const;
};
