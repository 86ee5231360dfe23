// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CCSweep/concepts.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_concepts.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <boost/concept/assert.hpp>
#include <boost/graph/adjacency_list.hpp>
#include <boost/test/unit_test.hpp>

#include <map>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

template <class Mesh>
struct Asserted_by_CGAL {
  BOOST_CONCEPT_ASSERT((CGAL::HalfedgeListGraphConcept<Mesh>));
  BOOST_CONCEPT_ASSERT((CGAL::FaceListGraphConcept<Mesh>));
  static constexpr bool value = CCSweep::SweepMesh<Mesh>;
};

// A kernel that lacks nothing but the exact orientation of three points.
struct Traits_without_orientation : CGAL::Simple_cartesian<CGAL::Exact_rational> {
  void orientation_2_object() const = delete;
};

}  // namespace

BOOST_AUTO_TEST_SUITE(concepts)

BOOST_AUTO_TEST_CASE(what_models_the_graph_concepts_of_cgal_models_a_sweep_mesh) {
  BOOST_TEST(Asserted_by_CGAL<Surface_mesh>::value);
  BOOST_TEST(Asserted_by_CGAL<Polyhedron>::value);
}

BOOST_AUTO_TEST_CASE(a_graph_without_faces_is_no_sweep_mesh) {
  BOOST_TEST(!CCSweep::SweepMesh<boost::adjacency_list<>>);
}

BOOST_AUTO_TEST_CASE(maps_are_told_from_what_is_none) {
  using Points = boost::property_map<Surface_mesh, CGAL::vertex_point_t>::const_type;
  using Patches = Surface_mesh::Property_map<Surface_mesh::Face_index, int>;
  using Ids = std::map<boost::graph_traits<Polyhedron>::face_descriptor, int>;
  using Map_of_the_user = boost::associative_property_map<Ids>;
  BOOST_TEST((CCSweep::VertexPointMap<Points, Surface_mesh>));
  BOOST_TEST((CCSweep::FacePatchMap<Patches, Surface_mesh>));
  BOOST_TEST((CCSweep::FacePatchMap<Map_of_the_user, Polyhedron>));
  BOOST_TEST((!CCSweep::VertexPointMap<Patches, Surface_mesh>));
  BOOST_TEST((!CCSweep::FacePatchMap<Points, Surface_mesh>));
}

BOOST_AUTO_TEST_CASE(kernels_with_exact_predicates_model_sweep_traits) {
  BOOST_TEST(CCSweep::SweepTraits<CGAL::Exact_predicates_inexact_constructions_kernel>);
  BOOST_TEST(CCSweep::SweepTraits<CGAL::Exact_predicates_exact_constructions_kernel>);
  BOOST_TEST(CCSweep::SweepTraits<CGAL::Simple_cartesian<CGAL::Exact_rational>>);
  BOOST_TEST(!CCSweep::SweepTraits<Traits_without_orientation>);
  BOOST_TEST(!CCSweep::SweepTraits<Surface_mesh>);
}

BOOST_AUTO_TEST_SUITE_END()
