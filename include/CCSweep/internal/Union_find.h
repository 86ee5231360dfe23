// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_UNION_FIND_H
#define CCSWEEP_INTERNAL_UNION_FIND_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CCSweep::internal {

// Disjoint sets of the numbers below n. The smallest member stands for its set, whatever the order of the unions.
class Union_find {
 public:
  explicit Union_find(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::uint32_t(0)); }

  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::size_t i, std::size_t j) {
    if (parent_[i] == parent_[j]) return;
    i = root(i);
    j = root(j);
    parent_[std::max(i, j)] = static_cast<std::uint32_t>(std::min(i, j));
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace CCSweep::internal

#endif
