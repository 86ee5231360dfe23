// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Correct results are accepted, with every kernel and mesh type, wherever the part stands.
#include <CCSweep/verify.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/vector_property_map.hpp>
#include <boost/test/unit_test.hpp>

#include "verify_fixture.h"

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Kernels = boost::mpl::list<Epick, CGAL::Exact_predicates_exact_constructions_kernel,
                                 CGAL::Simple_cartesian<double>, CGAL::Simple_cartesian<CGAL::Exact_rational>>;

template <class Kernel>
using Step = verify_fixture::Step<typename Kernel::Point_3>;

template <class Kernel>
CCSweep::Status verified(const Step<Kernel>& step) {
  const auto input = step.input.mesh();
  using Face = typename std::decay_t<decltype(input)>::Face_index;
  return CCSweep::verify(input, input.template property_map<Face, int>("f:patch_id").first, step.decomposition());
}

template <class Kernel, class Function>
void move(Step<Kernel>& step, Function f) {
  for (auto* soup : {&step.input, &step.volumes[0], &step.volumes[1]})
    for (auto& p : soup->points) p = f(p);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(verify_kernels)

BOOST_AUTO_TEST_CASE_TEMPLATE(a_step_is_accepted, Kernel, Kernels) {
  const Step<Kernel> step;
  const CCSweep::Status status = verified<Kernel>(step);
  BOOST_TEST(status.ok(), status.reason);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_lost_ulp_of_volume_shows_with_exact_numbers_only, Kernel, Kernels) {
  Step<Kernel> step;  // the same vertex on both sides of the cut, not exactly on the patch above
  const typename Kernel::FT z = 2.0 + 0x1p-51;
  for (auto& soup : step.volumes) soup.points[soup.vertex(1, 1, 2)] = typename Kernel::Point_3(1, 1, z);
  BOOST_TEST(verified<Kernel>(step).ok() == std::is_floating_point_v<typename Kernel::FT>);
}

BOOST_AUTO_TEST_CASE(a_part_far_away_or_tiny_or_turned_is_accepted) {
  using Point = Epick::Point_3;
  Step<Epick> far, tiny, turned;
  move<Epick>(far, [](const Point& p) { return Point(p.x() + 1e6, p.y() - 1e6, p.z() + 1e6); });
  move<Epick>(tiny, [](const Point& p) { return Point(1e-3 * p.x(), 1e-3 * p.y(), 1e-3 * p.z()); });
  move<Epick>(turned, [](const Point& p) {
    return Point(0.36 * p.x() + 0.48 * p.y() - 0.8 * p.z(), -0.8 * p.x() + 0.6 * p.y(),
                 0.48 * p.x() + 0.64 * p.y() + 0.6 * p.z());
  });
  turned.result.direction = {-0.8, 0, 0.6};
  for (const auto* step : {&far, &tiny, &turned}) {
    const CCSweep::Status status = verified<Epick>(*step);
    BOOST_TEST(status.ok(), status.reason);
  }
}

BOOST_AUTO_TEST_CASE(a_polyhedron_with_a_point_map_is_accepted) {
  using Polyhedron = CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>;
  const Step<Epick> step;
  const auto mesh = step.input.mesh();
  Polyhedron polyhedron;
  using Vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
  using Face = boost::graph_traits<Polyhedron>::face_descriptor;
  std::map<CGAL::SM_Face_index, Face> copies;
  CGAL::copy_face_graph(mesh, polyhedron, CGAL::parameters::face_to_face_map(boost::make_assoc_property_map(copies)));
  std::map<Face, int> patch;
  std::map<Vertex, Epick::Point_3> points;
  for (auto [face, copy] : copies) patch[copy] = step.input.patch[face.idx()];
  for (Vertex v : vertices(polyhedron)) {
    points[v] = v->point();
    v->point() = Epick::Point_3(0, 0, 0);  // not to be used
  }
  const CCSweep::Status status =
      CCSweep::verify(polyhedron, boost::associative_property_map<std::map<Vertex, Epick::Point_3>>(points),
                      boost::associative_property_map<std::map<Face, int>>(patch), step.decomposition());
  BOOST_TEST(status.ok(), status.reason);
}

BOOST_AUTO_TEST_CASE(an_input_that_is_no_closed_triangle_mesh_is_refused) {
  Step<Epick> step;
  step.input.triangles.pop_back();
  BOOST_TEST(!verified<Epick>(step).ok());
  CGAL::Surface_mesh<Epick::Point_3> empty;
  auto patch = empty.add_property_map<CGAL::SM_Face_index, int>("f:patch_id", 0).first;
  BOOST_TEST(!CCSweep::verify(empty, patch, step.decomposition()).ok());
}

BOOST_AUTO_TEST_SUITE_END()
