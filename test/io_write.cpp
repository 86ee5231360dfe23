// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/IO/read_part.h>
#include <CCSweep/IO/round_to_double.h>
#include <CCSweep/IO/write_volumes.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <iterator>

#include "io_shapes.h"

using CCSweep::Status_code;
using namespace shapes;

namespace {

using Names = std::vector<std::string>;

template <class Point>
CCSweep::Sub_volume<Point> volume_of(const Polygon_soup& soup) {
  auto part = CCSweep::internal::make_mesh<Point>(triangulated(soup));
  CCSweep::Sub_volume<Point> volume{std::move(part.mesh), 0, {1}};
  using Face = typename CGAL::Surface_mesh<Point>::Face_index;
  volume.mesh.template add_property_map<Face, int>(volume.role_map, 2);
  return volume;
}

CCSweep::Decomposition<CCSweep::Double_point> decomposition_of(std::size_t n) {
  CCSweep::Decomposition<CCSweep::Double_point> result;
  for (std::size_t i = 0; i < n; ++i)
    result.volumes.push_back(
        volume_of<CCSweep::Double_point>(box({0, 0, 1.0 / 3}, {0.1, 1e-17, 1 + static_cast<double>(i)})));
  return result;
}

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(io_write)

BOOST_AUTO_TEST_CASE(what_is_written_is_read_again_bit_for_bit) {
  const Scratch scratch;
  const auto result = decomposition_of(2);
  BOOST_TEST(write_volumes(result, scratch.path("new/folder")).ok());
  for (std::size_t i = 0; i < 2; ++i) {
    const auto part =
        CCSweep::read_part<CCSweep::Double_point>(scratch.path("new/folder/" + CCSweep::volume_file_name(i)));
    BOOST_REQUIRE_MESSAGE(part.ok(), part.status().reason);
    BOOST_TEST((facets(part.value()) == facets({result.volumes[i].mesh})));
  }
  BOOST_TEST(content(scratch.path("new/folder/volume_000.ply")).find("property int role\n") != std::string::npos);
  BOOST_TEST(content(scratch.path("new/folder/decomposition.vtp")).find("NumberOfPolys=\"24\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(an_earlier_result_goes_and_everything_else_stays) {
  const Scratch scratch;
  for (const char* name : {"volume_12.ply", "volume_0001.ply", "volume_001.ply.bak", "volume_x.ply", "notes.txt"})
    scratch.write(name, "mine");
  BOOST_TEST(write_volumes(decomposition_of(3), scratch.path("")).ok());
  scratch.write("volume_1000.ply", "of a result with many sub-volumes");
  BOOST_TEST(write_volumes(decomposition_of(1), scratch.path("")).ok());
  Names wanted = {"decomposition.vtp",  "notes.txt",     "volume_000.ply", "volume_0001.ply",
                  "volume_001.ply.bak", "volume_12.ply", "volume_x.ply"};
  BOOST_TEST(scratch.names() == wanted, boost::test_tools::per_element());
  BOOST_TEST(content(scratch.path("volume_0001.ply")) == "mine");
  BOOST_TEST(CCSweep::remove_volumes(scratch.path("")).ok());
  BOOST_TEST(scratch.names().size() == 5u);
  BOOST_TEST(CCSweep::remove_volumes(scratch.path("nowhere")).ok());
}

BOOST_AUTO_TEST_CASE(a_failure_leaves_the_folder_as_it_was) {
  const Scratch scratch;
  scratch.write("volume_000.ply", "of an earlier result");
  std::filesystem::create_directory(scratch.path("volume_001.ply"));
  const auto status = write_volumes(decomposition_of(2), scratch.path(""));
  BOOST_TEST(status.code == Status_code::write_failed);
  BOOST_TEST((status.stage == CCSweep::Stage::output));
  BOOST_TEST(scratch.names() == (Names{"volume_000.ply", "volume_001.ply"}), boost::test_tools::per_element());
  BOOST_TEST(content(scratch.path("volume_000.ply")) == "of an earlier result");
  BOOST_TEST(write_volumes(decomposition_of(1), scratch.path("volume_000.ply/below")).code ==
             Status_code::write_failed);
}

BOOST_AUTO_TEST_CASE(a_volume_needs_its_face_properties) {
  const Scratch scratch;
  auto result = decomposition_of(1);
  auto& mesh = result.volumes[0].mesh;
  auto roles = mesh.property_map<CGAL::SM_Face_index, int>("f:role").first;
  mesh.remove_property_map(roles);
  BOOST_TEST(write_volumes(result, scratch.path("out")).code == Status_code::invalid_parameter);
}

BOOST_AUTO_TEST_CASE(equal_exact_numbers_are_rounded_to_the_same_double) {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const Kernel::FT third = Kernel::FT(1) / 3;
  // The same number by another way; its interval is wider.
  Kernel::FT other = third;
  for (int i = 0; i < 50; ++i) other = other * 7 / 7 + 0.1 - 0.1;
  BOOST_TEST((third == other));
  BOOST_TEST(CCSweep::internal::file_double(third) == CCSweep::internal::file_double(other));
  BOOST_TEST(!std::signbit(CCSweep::internal::file_double(-0.0)));

  CCSweep::Decomposition<Kernel::Point_3> exact;
  exact.volumes.push_back(volume_of<Kernel::Point_3>(cube()));
  const auto rounded = CCSweep::round_to_double(exact);
  BOOST_TEST((facets({rounded.volumes[0].mesh}) == facets({volume_of<CCSweep::Double_point>(cube()).mesh})));
  BOOST_TEST(rounded.volumes[0].target == 0);
}

BOOST_AUTO_TEST_SUITE_END()
