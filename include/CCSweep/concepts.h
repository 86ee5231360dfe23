// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_CONCEPTS_H
#define CCSWEEP_CONCEPTS_H

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <cstddef>
#include <utility>

namespace CCSweep {

/// A mesh that the library can read: CGAL's `HalfedgeListGraph` and `FaceListGraph`, by their valid expressions.
/// What the mesh must also be (closed, 2-manifold, outward oriented) is checked when it is read, and told by a
/// `Status`.
///
/// Models: `CGAL::Surface_mesh`, `CGAL::Polyhedron_3`, and every other halfedge structure with these free functions.
template <class Mesh>
concept SweepMesh = requires(const Mesh& mesh, typename boost::graph_traits<Mesh>::vertex_descriptor v,
                             typename boost::graph_traits<Mesh>::halfedge_descriptor h,
                             typename boost::graph_traits<Mesh>::edge_descriptor e,
                             typename boost::graph_traits<Mesh>::face_descriptor f) {
  { *vertices(mesh).first } -> std::convertible_to<decltype(v)>;
  { *halfedges(mesh).first } -> std::convertible_to<decltype(h)>;
  { *edges(mesh).first } -> std::convertible_to<decltype(e)>;
  { *faces(mesh).first } -> std::convertible_to<decltype(f)>;
  { num_vertices(mesh) } -> std::convertible_to<std::size_t>;
  { num_halfedges(mesh) } -> std::convertible_to<std::size_t>;
  { num_edges(mesh) } -> std::convertible_to<std::size_t>;
  { num_faces(mesh) } -> std::convertible_to<std::size_t>;
  { next(h, mesh) } -> std::same_as<decltype(h)>;
  { prev(h, mesh) } -> std::same_as<decltype(h)>;
  { opposite(h, mesh) } -> std::same_as<decltype(h)>;
  { source(h, mesh) } -> std::same_as<decltype(v)>;
  { target(h, mesh) } -> std::same_as<decltype(v)>;
  { face(h, mesh) } -> std::same_as<decltype(f)>;
  { edge(h, mesh) } -> std::same_as<decltype(e)>;
  { halfedge(v, mesh) } -> std::same_as<decltype(h)>;
  { halfedge(e, mesh) } -> std::same_as<decltype(h)>;
  { halfedge(f, mesh) } -> std::same_as<decltype(h)>;
  { boost::graph_traits<Mesh>::null_face() } -> std::convertible_to<decltype(f)>;
};

/// A readable property map from the vertices of `Mesh` to their points.
template <class Map, class Mesh>
concept VertexPointMap =
    SweepMesh<Mesh> &&
    std::convertible_to<typename boost::graph_traits<Mesh>::vertex_descriptor,
                        typename boost::property_traits<Map>::key_type> &&
    requires(const Map& map, typename boost::graph_traits<Mesh>::vertex_descriptor v) {
      { get(map, v) } -> std::convertible_to<typename boost::property_traits<Map>::value_type>;
    };

/// A readable property map from the faces of `Mesh` to the ids of their CAD faces.
template <class Map, class Mesh>
concept FacePatchMap =
    SweepMesh<Mesh> &&
    std::convertible_to<typename boost::graph_traits<Mesh>::face_descriptor,
                        typename boost::property_traits<Map>::key_type> &&
    requires(const Map& map, typename boost::graph_traits<Mesh>::face_descriptor f) {
      { get(map, f) } -> std::convertible_to<int>;
    };

/// The kernel of a decomposition: the part of CGAL's `Kernel` that the stages use. Its predicates must be exact; its
/// constructions may round, and then what they made is checked again by predicates.
///
/// Models: `CGAL::Exact_predicates_inexact_constructions_kernel`,
/// `CGAL::Exact_predicates_exact_constructions_kernel`, `CGAL::Simple_cartesian<CGAL::Exact_rational>`.
template <class Traits>
concept SweepTraits =
    std::default_initializable<Traits> && std::copy_constructible<Traits> &&
    requires(const Traits& traits, const typename Traits::FT& x, const typename Traits::Point_2& p,
             const typename Traits::Point_3& q, const typename Traits::Vector_3& v,
             const typename Traits::Segment_2& s) {
      { CGAL::to_double(x) } -> std::convertible_to<double>;
      { CGAL::to_interval(x) } -> std::convertible_to<std::pair<double, double>>;
      { x + x * x - x / x } -> std::convertible_to<typename Traits::FT>;
      { x < x } -> std::convertible_to<bool>;

      { typename Traits::Point_2(x, x) };
      { typename Traits::Point_3(x, x, x) };
      { typename Traits::Segment_2(p, p) };
      { p.x() } -> std::convertible_to<typename Traits::FT>;
      { q.z() } -> std::convertible_to<typename Traits::FT>;
      { q - q } -> std::convertible_to<typename Traits::Vector_3>;
      { q + x * v } -> std::convertible_to<typename Traits::Point_3>;
      { v * v } -> std::convertible_to<typename Traits::FT>;

      { traits.orientation_2_object()(p, p, p) } -> std::convertible_to<CGAL::Orientation>;
      { traits.compare_xy_2_object()(p, p) } -> std::convertible_to<CGAL::Comparison_result>;
      { traits.collinear_are_ordered_along_line_2_object()(p, p, p) } -> std::convertible_to<bool>;
      { traits.do_intersect_2_object()(s, s) } -> std::convertible_to<bool>;
      traits.intersect_2_object()(s, s);
      { traits.side_of_oriented_circle_2_object()(p, p, p, p) } -> std::convertible_to<CGAL::Oriented_side>;
      { traits.orientation_3_object()(q, q, q, q) } -> std::convertible_to<CGAL::Orientation>;
      { traits.collinear_3_object()(q, q, q) } -> std::convertible_to<bool>;
      { traits.compare_xyz_3_object()(q, q) } -> std::convertible_to<CGAL::Comparison_result>;
      {
        traits.construct_cross_product_vector_3_object()(v, v)
      } -> std::convertible_to<typename Traits::Vector_3>;
    };

}  // namespace CCSweep

#endif
