// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A spatial index of one's own, a uniform grid, takes the place of the library's r-tree.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/decompose.h>
#include <CCSweep/loops/segment_index.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

//! [index]
class Grid_index {
 public:
  explicit Grid_index(const std::vector<CGAL::Bbox_2>& boxes) : boxes_(boxes) {
    for (const CGAL::Bbox_2& box : boxes) bounds_ += box;
    side_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(boxes.size())));
    cells_.resize(side_ * side_);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for_each_cell(boxes[i], [&](std::size_t cell) { cells_[cell].push_back(i); });
    }
  }

  template <class OutputIterator>
  OutputIterator candidates(const CGAL::Bbox_2& box, OutputIterator out) const {
    std::vector<std::size_t> found;
    for_each_cell(box, [&](std::size_t cell) { found.insert(found.end(), cells_[cell].begin(), cells_[cell].end()); });
    // A segment stands in several cells but must be reported once.
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return std::copy_if(found.begin(), found.end(), out,
                        [&](std::size_t i) { return CGAL::do_overlap(boxes_[i], box); });
  }

 private:
  // The row or column of the grid; what lies outside belongs to the outermost, so that no box is missed.
  std::size_t cell(double x, int axis) const {
    const double size = bounds_.max(axis) - bounds_.min(axis);
    if (!(size > 0)) return 0;
    const double last = static_cast<double>(side_ - 1);
    return static_cast<std::size_t>(std::clamp((x - bounds_.min(axis)) / size * static_cast<double>(side_), 0., last));
  }

  template <class Function>
  void for_each_cell(const CGAL::Bbox_2& box, const Function& function) const {
    for (std::size_t j = cell(box.ymin(), 1); j <= cell(box.ymax(), 1); ++j) {
      for (std::size_t i = cell(box.xmin(), 0); i <= cell(box.xmax(), 0); ++i) function(j * side_ + i);
    }
  }

  std::vector<CGAL::Bbox_2> boxes_;
  CGAL::Bbox_2 bounds_;
  std::size_t side_;
  std::vector<std::vector<std::size_t>> cells_;
};
static_assert(CCSweep::SegmentIndex_2<Grid_index>);
//! [index]

int tell(const CCSweep::Status& status) {
  std::cerr << name(status.code) << " in stage " << name(status.stage) << ": " << status.reason << '\n';
  return 1;
}

int main(int argc, char* argv[]) {
  const auto part = CCSweep::read_part<Point>(argc > 1 ? argv[1] : CCSWEEP_EXAMPLE_DATA "/parallel_barrels.ply");
  if (!part) return tell(part.status());

  //! [call]
  const auto result = CCSweep::decompose(
      part.value().mesh,
      CCSweep::parameters::face_patch_map(part.value().patch_ids()).segment_index(Grid_index({})));
  //! [call]
  if (!result) return tell(result.status());
  std::cout << result.value().volumes.size() << " sub-volumes\n";
}
