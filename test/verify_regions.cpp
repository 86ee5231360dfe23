// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a surface that verification takes to be free of overlap without a look at their triangles.
#include <CCSweep/internal/verify_intersections.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace check = CCSweep::internal::verification;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Sheets over the square [-4, 4]^2, and the same triangles turned over as a second patch, which closes the surface.
struct Sheets {
  check::Scene<Kernel> scene;
  check::Surface surface;

  std::uint32_t add_point(double x, double y, double z) {
    scene.points.emplace_back(x, y, z);
    scene.near.push_back({x, y, z});
    return static_cast<std::uint32_t>(scene.points.size() - 1);
  }

  // `point(x, y, is_above)` is the point of a triangle above or below the line y = 0.
  template <class PointAt>
  void add_sheet(const PointAt& point) {
    for (int x = -4; x < 4; ++x)
      for (int y = -4; y < 4; ++y) {
        const auto at = [&](int dx, int dy) { return point(x + dx, y + dy, y >= 0); };
        surface.points.push_back({at(0, 0), at(1, 0), at(1, 1)});
        surface.points.push_back({at(0, 0), at(1, 1), at(0, 1)});
      }
  }

  void close() {
    const std::size_t size = surface.points.size();
    for (std::size_t t = 0; t < size; ++t) {
      const auto [a, b, c] = surface.points[t];
      surface.points.push_back({a, c, b});
    }
    surface.patch.assign(size, 0);
    surface.patch.resize(2 * size, 1);
    std::map<std::tuple<int, std::uint32_t, std::uint32_t>, std::uint32_t> halfedges;
    const auto corner = [this](std::uint32_t h, int k) { return surface.points[h / 3][(h % 3 + k) % 3]; };
    for (std::uint32_t h = 0; h < 3 * surface.points.size(); ++h)
      halfedges[{surface.patch[h / 3], corner(h, 0), corner(h, 1)}] = h;
    for (std::uint32_t h = 0; h < 3 * surface.points.size(); ++h) {
      const int patch = surface.patch[h / 3];
      const auto inside = halfedges.find({patch, corner(h, 1), corner(h, 0)});
      surface.opposite.push_back(inside != halfedges.end() ? inside->second
                                                           : halfedges.at({1 - patch, corner(h, 1), corner(h, 0)}));
    }
  }

  // The number of triangles that need a look.
  std::size_t others() { return check::Graph_regions<Kernel>(scene, surface).regions().back().size(); }
};

// The points of a square grid, wider at the rim.
std::map<std::array<int, 2>, std::uint32_t> grid(Sheets& sheets, double rim, double height) {
  std::map<std::array<int, 2>, std::uint32_t> result;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y) {
      const double scale = std::max(std::abs(x), std::abs(y)) == 4 ? rim : 1;
      result[{x, y}] = sheets.add_point(scale * x, scale * y, height);
    }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(verify_regions)

BOOST_AUTO_TEST_CASE(a_sheet_needs_no_look) {
  Sheets sheets;
  const auto points = grid(sheets, 1, 0);
  sheets.add_sheet([&](int x, int y, bool) { return points.at({x, y}); });
  sheets.close();
  BOOST_TEST(sheets.others() == 0u);
}

BOOST_AUTO_TEST_CASE(a_sheet_with_a_hole_needs_no_look) {
  Sheets sheets;
  const auto points = grid(sheets, 1, 0);
  sheets.add_sheet([&](int x, int y, bool) { return points.at({x, y}); });
  std::erase_if(sheets.surface.points, [&](const check::Triple& t) {
    return std::find(t.begin(), t.end(), points.at({0, 0})) != t.end();
  });
  sheets.close();
  BOOST_TEST(sheets.others() == 0u);
}

// Two sheets that change places along the line between two points, where they cross. Their boundaries are two squares,
// one in the other.
BOOST_AUTO_TEST_CASE(sheets_wound_around_two_points_need_a_look) {
  Sheets sheets;
  const auto lower = grid(sheets, 1, 0), upper = grid(sheets, 1.25, 1);
  const auto add = [&](const auto& own, const auto& other) {
    sheets.add_sheet([&](int x, int y, bool is_above) {
      if (y == 0 && std::abs(x) == 1) return lower.at({x, y});
      return x == 0 && y == 0 && !is_above ? other.at({x, y}) : own.at({x, y});
    });
  };
  add(lower, upper);
  add(upper, lower);
  sheets.close();
  BOOST_TEST(sheets.others() == sheets.surface.points.size());
}

BOOST_AUTO_TEST_SUITE_END()
