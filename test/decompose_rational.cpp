// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// A kernel put together by the user: Cartesian coordinates in exact rationals, without filters.
#include <CCSweep/IO/read_part.h>
#include <CCSweep/decompose.h>
#include <CCSweep/parameters.h>
#include <CCSweep/verify.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/test/unit_test.hpp>

#include <array>

namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

Kernel::FT volume_of(const CGAL::Surface_mesh<Kernel::Point_3>& mesh) {
  Kernel::FT sum = 0;
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += CGAL::volume(Kernel::Point_3(CGAL::ORIGIN), mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
  }
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(decompose_rational)

BOOST_AUTO_TEST_CASE(rational_volumes_add_up_exactly) {
  const auto part =
      CCSweep::read_part<Kernel::Point_3>(CCSWEEP_TEST_DATA "/stepped_many_to_many.ply").value();
  const auto outcome = CCSweep::decompose(
      part.mesh, CCSweep::parameters::direction(Kernel::Vector_3(0, 0, 1)).face_patch_map(part.patch_ids()));
  BOOST_TEST_REQUIRE(outcome.ok(), outcome.status().reason);
  const auto& found = outcome.value();
  BOOST_TEST_REQUIRE(found.volumes.size() == 3u);
  BOOST_TEST(found.sets.size() == 4u);
  const std::array<int, 3> targets{1, 3, 5};
  const std::array<double, 3> expected{368, 246, 124};
  Kernel::FT sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto volume = volume_of(found.volumes[i].mesh);
    BOOST_TEST(found.volumes[i].target == targets[i]);
    // Cuts are projected in doubles, so that each is a rounding error off; what one side loses the other gains.
    BOOST_TEST(CGAL::to_double(volume) == expected[i], boost::test_tools::tolerance(1e-13));
    sum += volume;
  }
  BOOST_TEST((sum == volume_of(part.mesh)));
  const CCSweep::Status status = CCSweep::verify(part.mesh, part.patch_ids(), found);
  BOOST_TEST(status.ok(), status.reason);
}

BOOST_AUTO_TEST_SUITE_END()
