// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_KEY_MAP_H
#define CCSWEEP_INTERNAL_KEY_MAP_H

#include <CCSweep/indices.h>

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CCSweep::internal {

// Spreads the bits of keys that count through small numbers; no two keys become equal.
struct Key_hash {
  std::size_t operator()(std::uint64_t key) const {
    key = (key ^ (key >> 32)) * 0xbf58476d1ce4e5b9u;
    return key ^ (key >> 31);
  }
};

/// A map from numbers to values in one piece of memory. It is not iterated over, so that no order comes from a hash.
template <class Value>
using Key_map = CGAL::Unique_hash_map<std::uint64_t, Value, Key_hash>;

/// The key of a pair of nodes in either order.
inline std::uint64_t pair_key(Node_index a, Node_index b) {
  return std::uint64_t(std::min(a, b).value()) << 32 | std::max(a, b).value();
}

}  // namespace CCSweep::internal

#endif
