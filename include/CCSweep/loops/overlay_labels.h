// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_LABELS_H
#define CCSWEEP_LOOPS_OVERLAY_LABELS_H

#include <CCSweep/Layer_drawing.h>

#include <algorithm>
#include <compare>
#include <iterator>
#include <optional>
#include <vector>

namespace CCSweep::internal {

// The labels of the two sides of an edge in one set.
struct Sides {
  int left = Loop_label::none;
  int right = Loop_label::none;
  auto operator<=>(const Sides&) const = default;
};

// The sum of what coincident edges say in one set: every label counts once for each edge it is left of, and minus
// once for each it is right of, and one label on either side must remain, or none at all. The same statement made
// over and over is made once. No value: the statements contradict each other.
inline std::optional<Sides> sum(const Sides& a, const Sides& b) {
  if (a.left == a.right) return b.left == b.right ? Sides{} : b;
  if (b.left == b.right || a == b) return a;
  if (a.left == b.right) return b.left == a.right ? Sides{} : Sides{b.left, a.right};
  if (a.right == b.left) return Sides{a.left, b.right};
  return std::nullopt;
}

inline std::optional<Sides> sum(std::vector<Sides> statements) {
  std::erase_if(statements, [](const Sides& sides) { return sides.left == sides.right; });
  if (statements.empty()) return Sides{};
  if (std::all_of(statements.begin(), statements.end(), [&](const Sides& s) { return s == statements.front(); })) {
    return statements.front();
  }
  std::vector<int> left, right, only_left, only_right;
  for (const Sides& sides : statements) {
    left.push_back(sides.left);
    right.push_back(sides.right);
  }
  std::sort(left.begin(), left.end());
  std::sort(right.begin(), right.end());
  std::set_difference(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(only_left));
  std::set_difference(right.begin(), right.end(), left.begin(), left.end(), std::back_inserter(only_right));
  if (only_left.empty()) return Sides{};
  if (only_left.size() == 1) return Sides{only_left.front(), only_right.front()};
  return std::nullopt;
}

// The patches that statements name, ascending.
inline std::vector<int> patches(const std::vector<Sides>& statements) {
  std::vector<int> result;
  for (const Sides& sides : statements) {
    if (sides.left != sides.right) result.insert(result.end(), {sides.left, sides.right});
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  std::erase(result, Loop_label::none);
  return result;
}

}  // namespace CCSweep::internal

#endif
