// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/IO/read_part.h>
#include <CCSweep/part/check_input.h>

#include <boost/test/unit_test.hpp>

#include "io_shapes.h"

using CCSweep::check_input;
using CCSweep::Status_code;
using namespace shapes;

namespace {

CCSweep::Status status_of(const Scratch& scratch, const std::string& name, const std::string& content) {
  const auto part = scratch.read(name, content);
  return part.ok() ? check_input(part.value().mesh, part.value().mesh.points()) : part.status();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(io_off_stl)

BOOST_AUTO_TEST_CASE(off_and_stl_hold_the_same_part) {
  const Scratch scratch;
  const auto soup = triangulated(box({0, -2, 0.5}, {0.25, 7, 1}));  // floats without rounding
  const auto in_off = scratch.read("a.off", off(soup)), ascii = scratch.read("a.stl", ascii_stl(soup)),
             binary = scratch.read("b.STL", binary_stl(soup));
  BOOST_REQUIRE(in_off.ok() && ascii.ok() && binary.ok());
  BOOST_TEST(in_off.value().mesh.number_of_vertices() == 8u);
  BOOST_TEST(ascii.value().mesh.number_of_vertices() == 8u);
  BOOST_TEST(number_of_patches(ascii.value()) == 6u);
  BOOST_TEST((facets(in_off.value()) == facets(ascii.value())));
  BOOST_TEST((facets(in_off.value()) == facets(binary.value())));
}

BOOST_AUTO_TEST_CASE(off_comes_in_many_shapes) {
  const Scratch scratch;
  const std::string faces = "3 0 2 1\n3 0 1 3 # red\n\n3 1 2 3 0 0 1\n3 0 3 2\n";
  const std::string plain = "OFF 4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces;
  const std::string colored = "COFF\n4 4 6\n0 0 0 255 0 0 1\n1 0 0 1 1 1 1\n0 1 0 0 0 0 0\n\n0 0 1 0 0 0 0\n" + faces;
  BOOST_TEST(status_of(scratch, "a.off", plain).ok());
  BOOST_TEST(status_of(scratch, "a.off", colored).ok());
  BOOST_TEST(status_of(scratch, "a.off", "OFF BINARY\n" + plain).code == Status_code::unreadable_file);
  BOOST_TEST(status_of(scratch, "a.off", "4OFF\n" + plain).code == Status_code::unreadable_file);
  BOOST_TEST(status_of(scratch, "a.off", "").code == Status_code::unreadable_file);
}

BOOST_AUTO_TEST_CASE(a_truncated_file_is_refused_or_complete) {
  const Scratch scratch;
  const auto soup = triangulated(cube());
  const std::array<std::array<std::string, 2>, 3> files = {
      {{"part.off", off(soup)}, {"part.stl", ascii_stl(soup)}, {"part.stl", binary_stl(soup)}}};
  for (const auto& [name, whole] : files) {
    const auto wanted = facets(scratch.read(name, whole).value());
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const auto part = scratch.read(name, whole.substr(0, size));
      BOOST_TEST((part.ok() ? facets(part.value()) == wanted : part.status().code == Status_code::unreadable_file));
    }
  }
}

BOOST_AUTO_TEST_CASE(no_byte_makes_it_crash) {
  const Scratch scratch;
  const auto soup = triangulated(cube());
  const std::array<std::array<std::string, 2>, 3> files = {
      {{"part.off", off(soup)}, {"part.stl", ascii_stl(soup)}, {"part.stl", binary_stl(soup)}}};
  for (const auto& [name, whole] : files)
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (const char mask : {'\xff', '\x01', '\x10'}) {
        std::string broken = whole;
        broken[i] = static_cast<char>(broken[i] ^ mask);
        status_of(scratch, name, broken);
      }
}

BOOST_AUTO_TEST_CASE(no_count_is_believed) {
  const Scratch scratch;
  for (const char* counts :
       {"8 4000000000", "4000000000 6", "8 7", "9 6", "7 6", "8 5", "-8 6", "8.5 6", "8 nan", "1e300 6"}) {
    std::string text = off(cube());
    text.replace(text.find("8 6"), 3, counts);
    BOOST_TEST(status_of(scratch, "a.off", text).code == Status_code::unreadable_file, counts);
  }
  for (const char count : {'\x00', '\x0b', '\x0d', '\xff'}) {
    std::string bytes = binary_stl(triangulated(cube()));
    bytes[80] = count;
    BOOST_TEST(status_of(scratch, "a.stl", bytes).code == Status_code::unreadable_file);
  }
  std::string huge = binary_stl(triangulated(cube()));
  huge.replace(80, 4, 4, '\xff');
  BOOST_TEST(status_of(scratch, "a.stl", huge).code == Status_code::unreadable_file);
}

BOOST_AUTO_TEST_CASE(stl_is_read_whatever_its_case_and_however_many_solids) {
  const Scratch scratch;
  const auto soup = triangulated(cube());
  std::string text = ascii_stl(soup);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  BOOST_TEST(status_of(scratch, "a.stl", text).ok());
  text = ascii_stl(soup);
  text.insert(text.find("facet normal", text.size() / 2), "endsolid one\nsolid\n");
  BOOST_TEST(status_of(scratch, "a.stl", text).ok());
  BOOST_TEST(status_of(scratch, "a.stl", ascii_stl(soup) + "solid empty\nendsolid\n").ok());
  BOOST_TEST(status_of(scratch, "a.stl", "solid nothing\nendsolid nothing\n").code == Status_code::empty_mesh);
}

BOOST_AUTO_TEST_CASE(zero_has_no_sign_when_stl_is_welded) {
  const Scratch scratch;
  std::string text = ascii_stl(triangulated(cube()));
  text.replace(text.find("vertex 0 "), 9, "vertex -0 ");
  BOOST_TEST(status_of(scratch, "a.stl", text).ok());
}

BOOST_AUTO_TEST_CASE(stl_is_welded_by_fans) {
  const Scratch scratch;
  const auto at_an_edge = scratch.read("a.stl", ascii_stl(triangulated(bosses_that_touch())));
  BOOST_REQUIRE_MESSAGE(at_an_edge.ok(), at_an_edge.status().reason);
  BOOST_TEST(at_an_edge.value().mesh.number_of_vertices() == bosses_that_touch().points.size());
  BOOST_TEST(check_input(at_an_edge.value().mesh, at_an_edge.value().mesh.points()).ok());

  // So is a surface whose sheets share what they touch in, whatever the format.
  Polygon_soup shared = triangulated(bosses_that_touch());
  std::map<std::array<double, 3>, Polygon_soup::Vertex> first;
  for (auto& corner : shared.corners) corner = first.try_emplace(shared.points[corner], corner).first->second;
  BOOST_TEST(check_soup(shared).code == Status_code::not_manifold);
  const auto from_off = scratch.read("a.off", off(shared));
  BOOST_REQUIRE_MESSAGE(from_off.ok(), from_off.status().reason);
  BOOST_TEST(from_off.value().mesh.number_of_vertices() == bosses_that_touch().points.size());

  // Two cubes that touch in an edge or in a corner: the surface is that of two solids, but it is sound.
  for (double z : {0.0, 1.0}) {
    const auto cubes = both(cube(), box({1, 1, z}, {2, 2, z + 1}));
    const auto part = scratch.read("b.stl", binary_stl(triangulated(cubes)));
    BOOST_REQUIRE(part.ok());
    BOOST_TEST(part.value().mesh.number_of_vertices() == 16u);
    BOOST_TEST(check_input(part.value().mesh, part.value().mesh.points()).code == Status_code::disjoint_solids);
  }
}

BOOST_AUTO_TEST_CASE(defects_are_found_in_stl_too) {
  const Scratch scratch;
  const auto soup = triangulated(cube());
  const auto status = [&](const Polygon_soup& triangles) {
    return status_of(scratch, "a.stl", ascii_stl(triangles)).code;
  };
  auto flipped = soup;
  std::swap(flipped.corners[0], flipped.corners[1]);
  BOOST_TEST(status(flipped) == Status_code::not_oriented);
  BOOST_TEST(status(inside_out(soup)) == Status_code::not_oriented);
  auto twice = soup;
  add_polygon(twice, {soup.corners[0], soup.corners[1], soup.corners[2]}, 0);
  BOOST_TEST(status(twice) == Status_code::not_manifold);
  auto open = soup;
  open.offsets.pop_back();
  open.corners.resize(open.offsets.back());
  BOOST_TEST(status(open) == Status_code::not_closed);
  auto flat = soup;
  flat.corners[0] = flat.corners[1];
  BOOST_TEST(status(flat) == Status_code::degenerate_facet);
}

BOOST_AUTO_TEST_SUITE_END()
