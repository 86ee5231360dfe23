// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_TABLE_H
#define CCSWEEP_LOOPS_OVERLAY_TABLE_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// Spreads the bits of two words over one.
inline std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  a = (a ^ (a >> 32)) * 0x9e3779b97f4a7c15u;
  a ^= b + (a >> 29);
  a = (a ^ (a >> 32)) * 0xbf58476d1ce4e5b9u;
  return a ^ (a >> 31);
}

inline std::uint64_t mixed(double x, double y) {
  return mixed(std::bit_cast<std::uint64_t>(x + 0.), std::bit_cast<std::uint64_t>(y + 0.));  // -0 equals 0
}

// A hash table of numbers, with open addressing; what they stand for is the caller's to compare. Nothing that comes
// out may depend on the order in which it hands out numbers.
class Number_table {
 public:
  explicit Number_table(std::size_t expected = 0) { reserve(expected); }

  void reserve(std::size_t more) {
    if (2 * (size_ + more) + 16 > slots_.size()) grow(std::bit_ceil(2 * (size_ + more) + 16));
  }

  void insert(std::uint64_t hash, std::uint32_t number) {
    reserve(1);
    ++size_;
    put({static_cast<std::uint32_t>(hash), number});
  }

  // All numbers inserted with this hash, and maybe others.
  template <class Function>
  void for_each(std::uint64_t hash, Function function) const {
    const Slot wanted{static_cast<std::uint32_t>(hash), none};
    for (std::size_t i = first(wanted); slots_[i].number != none; i = next(i)) {
      if (slots_[i].hash == wanted.hash) function(slots_[i].number);
    }
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct Slot {
    std::uint32_t hash = 0, number = none;
  };

  std::size_t first(const Slot& slot) const { return slot.hash & (slots_.size() - 1); }
  std::size_t next(std::size_t i) const { return (i + 1) & (slots_.size() - 1); }

  void put(const Slot& slot) {
    std::size_t i = first(slot);
    while (slots_[i].number != none) i = next(i);
    slots_[i] = slot;
  }

  void grow(std::size_t size) {
    std::vector<Slot> old(size);
    std::swap(old, slots_);
    for (const Slot& slot : old) {
      if (slot.number != none) put(slot);
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

class Number_set {
 public:
  // Whether the number is new.
  bool insert(int number) {
    const std::uint64_t hash = mixed(std::uint64_t{0}, static_cast<std::uint32_t>(number));
    bool is_new = true;
    table_.for_each(hash, [&](std::uint32_t place) { is_new = is_new && numbers_[place] != number; });
    if (!is_new) return false;
    table_.insert(hash, static_cast<std::uint32_t>(numbers_.size()));
    numbers_.push_back(number);
    return true;
  }

 private:
  Number_table table_;
  std::vector<int> numbers_;
};

}  // namespace CCSweep::internal

#endif
