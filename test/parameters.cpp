// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <boost/test/unit_test.hpp>

#include <array>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace {

namespace P = CCSweep::parameters;
namespace ours = CCSweep::internal_np;
namespace theirs = CGAL::internal_np;
using CGAL::parameters::choose_parameter;
using CGAL::parameters::get_parameter;
using CGAL::parameters::get_parameter_reference;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Tag, class Pack>
constexpr bool is_set(const Pack&) {
  return !CGAL::parameters::is_default_parameter<Pack, Tag>::value;
}

template <class Pack>
void check_every_parameter(const Pack& pack) {
  BOOST_TEST(get_parameter(pack, ours::direction)[1] == 1.5);
  BOOST_TEST(get_parameter(pack, ours::sources) == (std::vector{3, 4}), boost::test_tools::per_element());
  BOOST_TEST(get_parameter(pack, ours::targets) == std::vector{7}, boost::test_tools::per_element());
  BOOST_TEST(get_parameter(pack, ours::tolerance) == 1e-7);
  BOOST_TEST(get_parameter(pack, ours::spanning_angle) == 30.);
  BOOST_TEST(get_parameter(pack, ours::layers) == 5);
  BOOST_TEST(get_parameter(pack, ours::neighbours) == 8);
  BOOST_TEST(get_parameter(pack, ours::segment_index) == 's');
  BOOST_TEST(get_parameter(pack, ours::point_index) == 'p');
  BOOST_TEST(get_parameter(pack, theirs::vertex_point) == 1001);
  BOOST_TEST(get_parameter(pack, theirs::face_patch) == 1002);
  BOOST_TEST(get_parameter(pack, theirs::geom_traits) == 1003);
  BOOST_TEST(get_parameter(pack, theirs::visitor) == 1004);
}

struct Not_copyable {
  Not_copyable() = default;
  Not_copyable(const Not_copyable&) = delete;
  int calls = 0;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(parameters)

BOOST_AUTO_TEST_CASE(every_parameter_arrives_in_any_order) {
  const std::array direction{0.5, 1.5, 2.5};
  const std::vector sources{3, 4}, targets{7};
  check_every_parameter(P::direction(direction).sources(sources).targets(targets).tolerance(1e-7).spanning_angle(30.)
                            .layers(5).neighbours(8).segment_index('s').point_index('p')
                            .vertex_point_map(1001).face_patch_map(1002).geom_traits(1003).visitor(1004));
  check_every_parameter(P::visitor(1004).geom_traits(1003).face_patch_map(1002).vertex_point_map(1001)
                            .point_index('p').segment_index('s').neighbours(8).layers(5).spanning_angle(30.)
                            .tolerance(1e-7).targets(targets).sources(sources).direction(direction));
  check_every_parameter(P::layers(5).visitor(1004).direction(direction).face_patch_map(1002).tolerance(1e-7)
                            .vertex_point_map(1001).sources(sources).geom_traits(1003).targets(targets)
                            .point_index('p').neighbours(8).segment_index('s').spanning_angle(30.));
}

BOOST_AUTO_TEST_CASE(a_chain_of_cgal_goes_on_after_from) {
  const std::array direction{0.5, 1.5, 2.5};
  const std::vector sources{3, 4}, targets{7};
  check_every_parameter(P::from(CGAL::parameters::face_patch_map(1002).visitor(1004)).direction(direction)
                            .sources(sources).geom_traits(1003).targets(targets).tolerance(1e-7).spanning_angle(30.)
                            .layers(5).vertex_point_map(1001).neighbours(8).segment_index('s').point_index('p'));
}

BOOST_AUTO_TEST_CASE(what_is_not_given_has_its_default) {
  BOOST_TEST(!is_set<ours::layers_t>(P::default_values()));
  BOOST_TEST(!is_set<ours::layers_t>(CGAL::parameters::default_values()));
  BOOST_TEST(!is_set<ours::layers_t>(P::tolerance(1.).face_patch_map(2)));
  BOOST_TEST(is_set<ours::layers_t>(P::tolerance(1.).layers(3).face_patch_map(2)));
  BOOST_TEST(choose_parameter(get_parameter(P::tolerance(1.), ours::layers), 11) == 11);
  BOOST_TEST(choose_parameter(get_parameter(P::layers(3), ours::layers), 11) == 3);
}

BOOST_AUTO_TEST_CASE(a_visitor_given_by_reference_is_not_copied) {
  Not_copyable visitor;
  const auto pack = P::layers(1).visitor(std::ref(visitor)).tolerance(1.);
  ++get_parameter_reference(pack, theirs::visitor).calls;
  BOOST_TEST(visitor.calls == 1);
}

BOOST_AUTO_TEST_CASE(cgal_takes_the_pack_and_skips_what_it_does_not_know) {
  Mesh mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(6, 0, 0), Kernel::Point_3(0, 6, 0),
                         Kernel::Point_3(0, 0, 6), mesh);
  auto points = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:doubled").first;
  for (auto v : mesh.vertices()) points[v] = CGAL::ORIGIN + 2 * (mesh.point(v) - CGAL::ORIGIN);
  namespace PMP = CGAL::Polygon_mesh_processing;
  BOOST_TEST(PMP::volume(mesh, P::layers(4)) == 36);
  BOOST_TEST(PMP::volume(mesh, P::layers(4).vertex_point_map(points)) == 288);
  BOOST_TEST(PMP::volume(mesh, P::vertex_point_map(points).layers(4).geom_traits(Kernel())) == 288);
}

BOOST_AUTO_TEST_SUITE_END()
