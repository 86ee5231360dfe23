// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_IO_INTERNAL_ENCODE_H
#define CCSWEEP_IO_INTERNAL_ENCODE_H

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <string>

namespace CCSweep::internal {

// The double that stands for a coordinate in a file. It depends on nothing but the number: a lazy number is evaluated
// first, as its interval depends on how it was made; and zero has no sign.
template <class FT>
double file_double(const FT& x) {
  if constexpr (requires { x.exact(); })
    return CGAL::to_double(x.exact()) + 0.0;
  else
    return CGAL::to_double(x) + 0.0;
}

template <class Point>
std::array<double, 3> file_point(const Point& p) {
  return {file_double(p.x()), file_double(p.y()), file_double(p.z())};
}

template <class T>
void append_little_endian(std::string& out, T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  out.append(bytes.data(), bytes.size());
}

// The shortest text that reads back as the same number, whatever the locale.
template <class T>
void append_text(std::string& out, T value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  out.append(buffer.data(), end);
}

}  // namespace CCSweep::internal

#endif
