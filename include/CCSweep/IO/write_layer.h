// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_WRITE_LAYER_H
#define CCSWEEP_IO_WRITE_LAYER_H

#include <CCSweep/IO/internal/encode.h>
#include <CCSweep/IO/internal/staged_files.h>
#include <CCSweep/IO/internal/vtp_array.h>
#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/Layer_drawing.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CCSweep {
namespace internal {

// The loops of a layer, in doubles, with patch ids for labels.
template <class Traits>
class Layer_picture {
 public:
  Layer_picture(const Layer_drawing<Traits>& drawing, const std::vector<int>& patch_id)
      : drawing_(drawing), patch_id_(patch_id) {
    for (const auto& node : drawing.nodes) {
      points_.push_back({CGAL::to_double(node.point.x()), CGAL::to_double(node.point.y())});
      for (int i : {0, 1}) {
        low_[i] = points_.size() == 1 ? points_[0][i] : std::min(low_[i], points_.back()[i]);
        high_[i] = points_.size() == 1 ? points_[0][i] : std::max(high_[i], points_.back()[i]);
      }
    }
  }

  // Borders of sources green, of targets red, what both share grey; dashed where the imprint may move them. A line
  // tells its patches when it is pointed at.
  std::string svg() const {
    const double size = std::max({high_[0] - low_[0], high_[1] - low_[1], 1e-300}), scale = 1000 / size;
    const auto x = [&](std::size_t n) { return text(20 + scale * (points_[n][0] - low_[0])); };
    const auto y = [&](std::size_t n) { return text(20 + scale * (high_[1] - points_[n][1])); };
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + text(40 + scale * (high_[0] - low_[0])) +
                      "\" height=\"" + text(40 + scale * (high_[1] - low_[1])) + "\" fill=\"none\">\n";
    for (const auto& s : drawing_.segments) {
      const bool of_source = s.left.source != s.right.source, of_target = s.left.target != s.right.target;
      const char* colour = of_source && of_target ? "#777777" : of_source ? "#2a8a3e" : "#c0392b";
      out += "<line x1=\"" + x(s.source.value()) + "\" y1=\"" + y(s.source.value()) + "\" x2=\"" +
             x(s.target.value()) + "\" y2=\"" + y(s.target.value()) + "\" stroke=\"" + colour + "\"" +
             (s.fixed ? "" : " stroke-dasharray=\"4 2\"") + "><title>left: " + words(s.left) +
             "; right: " + words(s.right) + "</title></line>\n";
    }
    return out + "</svg>\n";
  }

  std::string vtp() const {
    std::string points, ends, offsets;
    for (const auto& p : points_) {
      append_text(points, p[0]);
      points += ' ';
      append_text(points, p[1]);
      points += " 0\n";
    }
    std::array<std::string, 5> data;
    for (std::size_t i = 0; i < drawing_.segments.size(); ++i) {
      const auto& s = drawing_.segments[i];
      ends += std::to_string(s.source.value()) + ' ' + std::to_string(s.target.value()) + '\n';
      offsets += std::to_string(2 * (i + 1)) + '\n';
      const std::array<int, 5> values{id(s.left.source), id(s.left.target), id(s.right.source), id(s.right.target),
                                      s.fixed ? 1 : 0};
      for (std::size_t k = 0; k < data.size(); ++k) data[k] += std::to_string(values[k]) + '\n';
    }
    constexpr const char* names[] = {"left_source", "left_target", "right_source", "right_target", "fixed"};
    std::string cells;
    for (std::size_t k = 0; k < data.size(); ++k) cells += vtp_array("Int32", names[k], data[k]);
    return vtp_head("NumberOfPoints=\"" + std::to_string(points_.size()) + "\" NumberOfLines=\"" +
                    std::to_string(drawing_.segments.size()) + "\"") +
           "<CellData>\n" + cells + "</CellData>\n<Points>\n" +
           vtp_array("Float64", "Points", points, " NumberOfComponents=\"3\"") + "</Points>\n<Lines>\n" +
           vtp_array("Int32", "connectivity", ends) + vtp_array("Int32", "offsets", offsets) + "</Lines>\n" +
           vtp_tail();
  }

 private:
  static std::string text(double value) {
    std::string out;
    append_text(out, value);
    return out;
  }

  int id(int label) const { return label == Loop_label::none ? Loop_label::none : patch_id_.at(label); }

  std::string words(const Loop_label& label) const {
    if (label.empty()) return "nothing";
    std::string out = label.target == Loop_label::none ? "" : "target " + std::to_string(id(label.target));
    if (label.source != Loop_label::none)
      out += (out.empty() ? "source " : ", source ") + std::to_string(id(label.source));
    return out;
  }

  const Layer_drawing<Traits>& drawing_;
  const std::vector<int>& patch_id_;
  std::vector<std::array<double, 2>> points_;
  std::array<double, 2> low_{}, high_{};
};

}  // namespace internal

/// Writes the loops of a layer before its imprint, in the coordinates of its chart, to look at:
/// - `layer_NNN.svg`, where sources are green, targets red, and dashed lines those that the imprint may move;
/// - `layer_NNN.vtp`, lines of a VTK PolyData with the cell data `left_source`, `left_target`, `right_source`,
///   `right_target` (patch ids, or -1) and `fixed`.
///
/// \param patch_id the id of each label
/// Returns `Status_code::write_failed` with the path when a file can't be written.
template <class Traits>
Status write_layer(std::size_t layer, const Layer_drawing<Traits>& drawing, const std::vector<int>& patch_id,
                   const std::string& folder) {
  return internal::guarded([&] {
           const internal::Layer_picture<Traits> picture(drawing, patch_id);
           std::string number = std::to_string(layer);
           number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
           internal::Staged_files files(folder);
           files.add("layer_" + number + ".svg", picture.svg());
           files.add("layer_" + number + ".vtp", picture.vtp());
           files.commit();
           return true;
         })
      .status();
}

}  // namespace CCSweep

#endif
