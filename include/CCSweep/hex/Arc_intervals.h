// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_ARC_INTERVALS_H
#define CCSWEEP_HEX_ARC_INTERVALS_H

#include <CCSweep/hex/Arc_stack.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/internal/Union_find.h>
#include <CCSweep/part/Part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace CCSweep {

/// How many intervals each arc has. Arcs above one another have equally many; the number is even, so that every cap
/// can be meshed by quads.
class Arc_intervals {
 public:
  using Half_arc = Arc_stack::Half_arc;

  Arc_intervals(const Arc_stack& arcs, double size) {
    std::size_t count = 0;
    for (const auto& layer : arcs.arcs) {
      first_.push_back(count);
      count += layer.size();
    }
    internal::Union_find classes(count);
    for (std::size_t k = 1; k < arcs.arcs.size(); ++k)
      for (std::size_t a = 0; a < arcs.arcs[k].size(); ++a)
        for (Half_arc below : arcs.arcs[k][a].below)
          if (below != Arc_stack::none) classes.join(first_[k] + a, first_[k - 1] + Arc_stack::arc_of(below));
    for (std::size_t i = 0; i < count; ++i) class_of_.push_back(classes.root(i));
    intervals_.assign(count, 2);
    for (std::size_t k = 0; k < arcs.arcs.size(); ++k)
      for (std::size_t a = 0; a < arcs.arcs[k].size(); ++a) {
        std::size_t& n = intervals_[class_of_[first_[k] + a]];
        n = std::max(n, wanted(arcs.arcs[k][a], size));
      }
  }

  std::size_t operator()(std::size_t layer, Half_arc h) const { return intervals_[arc_class(layer, h)]; }

  /// Gives an arc, and all that lie in its columns, more intervals, an even number.
  void add(std::size_t layer, Half_arc h, std::size_t more) { intervals_[arc_class(layer, h)] += more; }

  std::size_t arc_class(std::size_t layer, Half_arc h) const { return class_of_[first_[layer] + Arc_stack::arc_of(h)]; }

 private:
  // By the length, and by how far the arc turns: two intervals are seen as one edge of the coarse mesh.
  static std::size_t wanted(const Arc_stack::Arc& arc, double size) {
    constexpr double turn_of_two = std::numbers::pi / 3;
    double length = 0, turning = 0;
    const auto& line = arc.line;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      using namespace internal;
      length += norm(line[i + 1] - line[i]);
      if (i > 0) turning += angle(line[i] - line[i - 1], line[i + 1] - line[i]);
    }
    const double by_length = std::round(length / (2 * size)), by_turning = std::ceil(turning / turn_of_two - 1e-6);
    return 2 * static_cast<std::size_t>(std::max({1.0, by_length, by_turning}));
  }

  std::vector<std::size_t> first_;      // by layer
  std::vector<std::size_t> class_of_;   // by arc of all layers
  std::vector<std::size_t> intervals_;  // by class
};

namespace internal {

/// The nodes of an arc from its one end to the other, equally far apart; measured across the sweep, so that on walls
/// along the sweep columns follow it whatever the slant of the caps.
inline std::vector<Vec3> place_on_arc(const Arc_stack::Arc& arc, std::size_t intervals, const Vec3& up) {
  constexpr double of_rise = 1e-3;
  const auto& line = arc.line;
  std::vector<double> sum{0};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 w = line[i + 1] - line[i];
    sum.push_back(sum.back() + norm(w - dot(w, up) * up) + of_rise * norm(w));
  }
  std::vector<Vec3> nodes{line.front()};
  std::size_t i = 0;
  for (std::size_t k = 1; k < intervals; ++k) {
    const double s = sum.back() * double(k) / double(intervals);
    while (i + 2 < line.size() && sum[i + 1] <= s) ++i;
    const double f = std::clamp((s - sum[i]) / std::max(sum[i + 1] - sum[i], 1e-300), 0.0, 1.0);
    nodes.push_back(line[i] + f * (line[i + 1] - line[i]));
  }
  nodes.push_back(line.back());
  return nodes;
}

}  // namespace internal
}  // namespace CCSweep

#endif
