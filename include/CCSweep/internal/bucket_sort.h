// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_BUCKET_SORT_H
#define CCSWEEP_INTERNAL_BUCKET_SORT_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Sorts by a key below `keys`, and by `less` where keys are equal. Linear, if few items have the same key.
template <class Item, class Key, class Less>
void bucket_sort(std::vector<Item>& items, std::size_t keys, const Key& key, const Less& less) {
  if (items.size() < keys / 16) {  // counting would take longer than comparing
    std::sort(items.begin(), items.end(),
              [&](const Item& a, const Item& b) { return key(a) != key(b) ? key(a) < key(b) : less(a, b); });
    return;
  }
  std::vector<std::uint32_t> place(keys + 1, 0);
  for (const Item& item : items) ++place[key(item) + 1];
  for (std::size_t k = 1; k < place.size(); ++k) place[k] += place[k - 1];
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[place[key(item)]++] = item;
  std::uint32_t first = 0;
  for (const std::uint32_t last : place) {  // where the items of a key end now
    if (last > first + 1) std::sort(sorted.begin() + first, sorted.begin() + last, less);
    first = last;
  }
  items = std::move(sorted);
}

}  // namespace CCSweep::internal

#endif
