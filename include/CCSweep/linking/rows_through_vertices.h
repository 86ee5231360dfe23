// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LINKING_ROWS_THROUGH_VERTICES_H
#define CCSWEEP_LINKING_ROWS_THROUGH_VERTICES_H

#include <CCSweep/linking/cap_groups.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Roles.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The rows between two levels that pass through vertices of the linking faces, after the lower level itself. Between
/// such rows walls do not bend, so that a cut along a wall meets its facets edge on edge. Of a bent sweep the vertices
/// of one row need not have quite the same parameter; they get the row's.
///
/// \param slab how far the parameter may grow between two rows
template <class Traits>
std::vector<double> rows_through_vertices(const Part<Traits>& part, const Roles& roles, double low, double high,
                                          double slab, std::vector<double>& parameter) {
  const double apart = 0.1 * slab, alike = roles.is_straight() ? height_resolution(part) : apart;
  std::vector<std::pair<double, std::size_t>> inner;
  for (std::size_t v = 0; v < parameter.size(); ++v)
    if (parameter[v] > low && parameter[v] < high) inner.emplace_back(parameter[v], v);
  std::sort(inner.begin(), inner.end());
  std::vector<double> rows{low};
  for (std::size_t first = 0, last = 0; first < inner.size(); first = last) {
    double sum = 0;
    for (; last < inner.size() && inner[last].first - inner[first].first <= alike; ++last) sum += inner[last].first;
    const double row = sum / double(last - first);
    if (row - rows.back() < apart || high - row < apart) continue;
    rows.push_back(row);
    for (std::size_t i = first; i < last; ++i) parameter[inner[i].second] = row;
  }
  return rows;
}

}  // namespace CCSweep::internal

#endif
