// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/IO/read_part.h>
#include <CCSweep/part/check_input.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <limits>

#include "io_shapes.h"

using CCSweep::check_input;
using CCSweep::Status_code;
using namespace shapes;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  BOOST_REQUIRE_MESSAGE(at != std::string::npos, what);
  return text.replace(at, what.size(), by);
}

void check_code(const Scratch& scratch, const std::string& content, Status_code code,
                const std::string& in_reason = "") {
  const auto part = scratch.read("part.ply", content);
  BOOST_TEST(part.status().code == code, part.status().reason);
  if (!part.ok()) BOOST_TEST(part.status().reason.find(scratch.path("part.ply")) == 0u);
  BOOST_TEST(part.status().reason.find(in_reason) != std::string::npos, part.status().reason);
}

// Whatever has become of the file, it is refused, or it is read as a part that check_input() can judge.
void check_no_crash(const Scratch& scratch, const std::string& content) {
  const auto part = scratch.read("part.ply", content);
  if (part.ok()) check_input(part.value().mesh, part.value().mesh.points(), part.value().patch_ids());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(io_ply)

BOOST_AUTO_TEST_CASE(all_formats_hold_the_same_part) {
  const Scratch scratch;
  const auto soup = triangulated(box({0.1, -2, 1e6}, {1.0 / 3, 7, 1e6 + 1}));
  const auto ascii = scratch.read("a.ply", ascii_ply(soup)), little = scratch.read("l.ply", binary_ply(soup)),
             big = scratch.read("b.ply", binary_ply(soup, true));
  BOOST_REQUIRE(ascii.ok() && little.ok() && big.ok());
  BOOST_TEST(ascii.value().mesh.number_of_faces() == 12u);
  BOOST_TEST((facets(ascii.value()) == facets(little.value())));
  BOOST_TEST((facets(ascii.value()) == facets(big.value())));
}

BOOST_AUTO_TEST_CASE(the_points_may_be_those_of_an_exact_kernel) {
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const Scratch scratch;
  const auto part = CCSweep::read_part<Kernel::Point_3>(scratch.write("a.ply", ascii_ply(cube())));
  BOOST_REQUIRE(part.ok());
  BOOST_TEST(check_input(part.value().mesh, part.value().mesh.points()).ok());
}

BOOST_AUTO_TEST_CASE(polygons_are_triangulated_and_keep_their_patch) {
  const Scratch scratch;
  // A prism over an L, with a node in the middle of an edge: three corners on one line.
  Polygon_soup soup;
  const std::vector<std::array<double, 2>> outline = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const auto n = static_cast<Vertex>(outline.size());
  for (double z : {0.0, 1.0})
    for (const auto& p : outline) soup.points.push_back({p[0], p[1], z});
  for (Vertex i = 0; i < n; ++i) {
    const Vertex j = (i + 1) % n;
    add_polygon(soup, {i, j, j + n, i + n}, 10 + static_cast<int>(i));
  }
  add_polygon(soup, {6, 5, 4, 3, 2, 1, 0}, 0);
  add_polygon(soup, {7, 8, 9, 10, 11, 12, 13}, 1);
  const auto part = scratch.read("l.ply", ascii_ply(soup));
  BOOST_REQUIRE_MESSAGE(part.ok(), part.status().reason);
  BOOST_TEST(part.value().mesh.number_of_faces() == 2u * 7 + 2 * 5);
  BOOST_TEST(number_of_patches(part.value()) == 9u);
  BOOST_TEST(check_input(part.value().mesh, part.value().mesh.points()).ok());
}

BOOST_AUTO_TEST_CASE(a_polygon_that_crosses_itself_is_refused) {
  const Scratch scratch;
  auto soup = cube();
  std::swap(soup.corners[1], soup.corners[2]);  // a bow tie; its edges no longer fit to the neighbours
  check_code(scratch, ascii_ply(soup), Status_code::not_oriented);
  soup = cube();
  soup.points[5] = {-0.5, 0.3, 1};  // over the opposite side: the top crosses itself
  check_code(scratch, ascii_ply(soup), Status_code::self_intersecting);
}

BOOST_AUTO_TEST_CASE(other_elements_and_properties_are_passed_over) {
  const Scratch scratch;
  const std::string text =
      "ply\r\nformat ascii 1.0\r\nobj_info a b c\r\nelement camera 1\r\nproperty list uint8 float32 view\r\n"
      "element vertex 4\r\nproperty uchar red\r\nproperty float z\r\nproperty float y\r\nproperty float x\r\n"
      "element face 4\r\nproperty short patch_id\r\nproperty list int8 uint16 texture\r\n"
      "property list uint16 uint8 vertex_index\r\nproperty float quality\r\nelement nothing 0\r\nend_header\r\n"
      "2 0.5 1e3\r\n"
      "1 0 0 0\r\n2 0 0 1\r\n3 0 1 0\r\n4 1 0 0\r\n"
      "-7 0 3 0 2 1 0.5\r\n8 2 1 1 3 0 1 3 0\r\n9 0 3 1 2 3 0\r\n10 0 3 0 3 2 +1.5\r\n";
  const auto part = scratch.read("t.ply", text);
  BOOST_REQUIRE_MESSAGE(part.ok(), part.status().reason);
  BOOST_TEST(part.value().mesh.number_of_faces() == 4u);
  const Facet bottom{{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}}, -7};
  BOOST_TEST(std::ranges::count(facets(part.value()), bottom) == 1);
}

BOOST_AUTO_TEST_CASE(without_patch_ids_they_come_from_the_angles) {
  const Scratch scratch;
  const auto part = scratch.read("a.ply", ascii_ply(cube(), false));
  BOOST_REQUIRE(part.ok());
  BOOST_TEST(number_of_patches(part.value()) == 6u);
  BOOST_TEST(number_of_patches(scratch.read("b.ply", ascii_ply(cube(), false), {true, 91}).value()) == 1u);
  BOOST_TEST(scratch.read("c.ply", ascii_ply(cube(), false), {false, 30}).status().code ==
             Status_code::missing_patch_ids);
  BOOST_TEST(scratch.read("c.ply", ascii_ply(cube()), {true, -1}).status().code == Status_code::invalid_parameter);
}

BOOST_AUTO_TEST_CASE(detected_patches_do_not_depend_on_the_order_of_the_facets) {
  const Scratch scratch;
  const auto soup = triangulated(cube());
  Polygon_soup turned;
  turned.points.assign(soup.points.rbegin(), soup.points.rend());
  for (std::size_t f = soup.number_of_polygons(); f-- > 0;)
    add_polygon(turned, {7 - soup.polygon(f)[1], 7 - soup.polygon(f)[2], 7 - soup.polygon(f)[0]}, 0);
  const auto a = scratch.read("a.ply", ascii_ply(soup, false)), b = scratch.read("b.ply", ascii_ply(turned, false));
  BOOST_TEST((facets(a.value()) == facets(b.value())));
}

BOOST_AUTO_TEST_CASE(a_truncated_file_is_refused_or_complete) {
  const Scratch scratch;
  for (const std::string& whole : {ascii_ply(cube()), binary_ply(cube()), binary_ply(cube(), true)}) {
    const auto wanted = facets(scratch.read("part.ply", whole).value());
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const auto part = scratch.read("part.ply", whole.substr(0, size));
      if (part.ok()) BOOST_TEST((facets(part.value()) == wanted));
      if (!part.ok()) BOOST_TEST(part.status().code == Status_code::unreadable_file);
    }
  }
}

BOOST_AUTO_TEST_CASE(no_byte_makes_it_crash) {
  const Scratch scratch;
  for (const std::string& whole : {ascii_ply(cube()), binary_ply(cube())}) {
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (const char mask : {'\xff', '\x01', '\x10'}) {
        std::string broken = whole;
        broken[i] = static_cast<char>(broken[i] ^ mask);
        check_no_crash(scratch, broken);
      }
  }
}

BOOST_AUTO_TEST_CASE(no_count_is_believed) {
  const Scratch scratch;
  for (const std::string& whole : {ascii_ply(cube()), binary_ply(cube())}) {
    for (const char* lie : {"9", "4000000000", "18446744073709551615"}) {
      check_code(scratch, replaced(whole, "vertex 8", std::string("vertex ") + lie), Status_code::unreadable_file);
      check_code(scratch, replaced(whole, "face 6", std::string("face ") + lie), Status_code::unreadable_file);
    }
    for (const char* lie : {"7", "0"})
      check_code(scratch, replaced(whole, "vertex 8", std::string("vertex ") + lie), Status_code::unreadable_file);
    for (const char* lie : {"-1", "18446744073709551616", "x", ""})
      check_code(scratch, replaced(whole, "face 6", std::string("face ") + lie), Status_code::unreadable_file,
                 "line 8");
    check_code(scratch, replaced(whole, "face 6", "face 5"), Status_code::unreadable_file, "more data");
    check_code(scratch, replaced(whole, "end_header", "element other 4000000000\nproperty int a\nend_header"),
               Status_code::unreadable_file);
  }
  check_code(scratch, replaced(binary_ply(cube()), "list uchar int", "list uint int"), Status_code::unreadable_file);
  check_code(scratch, replaced(ascii_ply(cube()), "\n4 4 5 7 6 1", "\n4000000000 4 5 7 6 1"),
             Status_code::unreadable_file, "line 21");
}

BOOST_AUTO_TEST_CASE(a_header_must_make_sense) {
  const Scratch scratch;
  const std::string whole = ascii_ply(cube());
  const std::array<std::array<const char*, 2>, 11> changes = {{{"ply\n", "plx\n"},
                                                               {"ascii", "text"},
                                                               {"1.0", "2.0"},
                                                               {"format ascii 1.0\n", ""},
                                                               {"double z", "real z"},
                                                               {"double z", "double w"},
                                                               {"double z", "double x"},
                                                               {"element face", "element facet"},
                                                               {"element vertex", "element point"},
                                                               {"int patch_id", "float patch_id"},
                                                               {"list uchar", "list float"}}};
  for (const auto& [what, by] : changes) check_code(scratch, replaced(whole, what, by), Status_code::unreadable_file);
  check_code(scratch, "", Status_code::unreadable_file);
  BOOST_TEST(CCSweep::read_soup(scratch.path("missing.ply")).status().code == Status_code::unreadable_file);
  std::filesystem::create_directory(scratch.path("folder.ply"));
  BOOST_TEST(CCSweep::read_soup(scratch.path("folder.ply")).status().code == Status_code::unreadable_file);
  BOOST_TEST(CCSweep::read_soup(scratch.write("part.xyz", whole)).status().code == Status_code::unreadable_file);
}

BOOST_AUTO_TEST_CASE(what_is_no_number_or_no_vertex_is_refused) {
  const Scratch scratch;
  const std::string whole = ascii_ply(cube());
  check_code(scratch, replaced(whole, "\n4 4 5 7 6 1", "\n4 4 5 8 6 1"), Status_code::unreadable_file, "line 21");
  check_code(scratch, replaced(whole, "\n4 4 5 7 6 1", "\n4 4 5 -1 6 1"), Status_code::unreadable_file, "line 21");
  check_code(scratch, replaced(whole, "\n4 4 5 7 6 1", "\n4 4 5 6.5 6 1"), Status_code::unreadable_file, "line 21");
  check_code(scratch, replaced(whole, "\n4 4 5 7 6 1", "\n4 4 5 x 6 1"), Status_code::unreadable_file, "line 21");
  check_code(scratch, replaced(whole, "\n4 4 5 7 6 1", "\n4 4 5 7 6"), Status_code::unreadable_file, "line 21");
  check_code(scratch, replaced(whole, "\n4 4 5 7 6 1", "\n4 4 5 7 6 1 1"), Status_code::unreadable_file, "line 21");
  check_code(scratch, replaced(whole, "\n4 4 5 7 6 1", "\n4 4 5 7 6 3000000000"), Status_code::unreadable_file,
             "line 21");
  for (const char* wild : {"nan", "inf", "-inf", "1e999"})
    check_code(scratch, replaced(whole, "\n1 1 1\n", std::string("\n1 ") + wild + " 1\n"),
               Status_code::non_finite_coordinate);
  auto soup = cube();
  soup.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  check_code(scratch, binary_ply(soup), Status_code::non_finite_coordinate, "vertex 3");
}

BOOST_AUTO_TEST_CASE(the_defect_is_named_and_placed) {
  const Scratch scratch;
  auto open = cube();
  open.corners.resize(20);
  open.offsets.pop_back();
  open.patch_ids.pop_back();
  const auto part = scratch.read("open.ply", ascii_ply(open));
  BOOST_TEST(part.status().code == Status_code::not_closed);
  BOOST_REQUIRE(part.status().place.has_value());
  BOOST_TEST((*part.status().place)[0] == 1.0);  // the missing face is that at x = 1
  BOOST_TEST(part.status().patches.size() == 1u);
}

BOOST_AUTO_TEST_CASE(the_parts_of_the_tests_are_valid) {
  std::size_t parts = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CCSWEEP_TEST_DATA)) {
    if (entry.path().extension() != ".ply") continue;
    const auto part = CCSweep::read_part<CCSweep::Double_point>(entry.path().string());
    BOOST_REQUIRE_MESSAGE(part.ok(), part.status().reason);
    const auto status = check_input(part.value().mesh, part.value().mesh.points(), part.value().patch_ids());
    BOOST_TEST(status.ok(), entry.path() << ": " << status.reason);
    ++parts;
  }
  BOOST_TEST(parts >= 12u);
}

BOOST_AUTO_TEST_SUITE_END()
