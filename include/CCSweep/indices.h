// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INDICES_H
#define CCSWEEP_INDICES_H

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>

namespace CCSweep {

/// A number that names one kind of thing, so that a layer is never mistaken for a patch. A default constructed
/// index names nothing.
template <class Kind>
class Index {
 public:
  constexpr Index() = default;
  constexpr explicit Index(std::size_t value) : value_(static_cast<std::uint32_t>(value)) {}

  constexpr bool is_valid() const { return value_ != none; }
  constexpr std::size_t value() const { return value_; }
  constexpr Index next() const { return Index(value_ + 1); }

  constexpr auto operator<=>(const Index&) const = default;
  friend std::ostream& operator<<(std::ostream& out, Index index) { return out << index.value_; }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t value_ = none;
};

using Patch_index = Index<struct Patch_kind>;  ///< a connected piece of an input patch
using Curve_index = Index<struct Curve_kind>;  ///< a feature curve
using Layer_index = Index<struct Layer_kind>;  ///< a value of the sweep parameter
using Level_index = Index<struct Level_kind>;  ///< a layer that carries caps
using Node_index = Index<struct Node_kind>;    ///< a node of a layer

}  // namespace CCSweep

template <class Kind>
struct std::hash<CCSweep::Index<Kind>> {
  std::size_t operator()(CCSweep::Index<Kind> index) const noexcept { return index.value(); }
};

#endif
