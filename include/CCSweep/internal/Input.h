// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_INPUT_H
#define CCSWEEP_INTERNAL_INPUT_H

#include <CCSweep/internal/Options.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/part/check_input.h>
#include <CCSweep/part/make_part.h>
#include <CCSweep/volumes/triangulate_plane.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>


#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// What the named parameters of a call stand for: types and maps.
template <class FaceGraph, class NamedParameters>
struct Call {
  using Traits = typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type;
  using Segment_index = Parameter_type<internal_np::segment_index_t, NamedParameters, Rtree_segment_index_2<Traits>>;
  using Point_index = Parameter_type<internal_np::point_index_t, NamedParameters, Rtree_point_index_3>;

  static auto points(const FaceGraph& mesh, const NamedParameters& np) {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    return choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                            CGAL::get_const_property_map(CGAL::vertex_point, mesh));
  }

  static auto patches(const NamedParameters& np) {
    return CGAL::parameters::get_parameter(np, CGAL::internal_np::face_patch);
  }

  // The caller's visitor, or one that does nothing.
  static decltype(auto) visitor(const NamedParameters& np) {
    return unwrap_visitor(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor), Visitor_base()));
  }

 private:
  template <class V>
  static V& unwrap_visitor(std::reference_wrapper<V> reference) { return reference.get(); }
  template <class V>
  static V unwrap_visitor(V visitor) { return visitor; }
};

// Triangulates a polygonal face in the plane it is most parallel to.
template <class Traits, class Point>
std::vector<Triangle> triangulated_face(const std::vector<std::uint32_t>& corners, const std::vector<Point>& points) {
  typename Traits::Vector_3 normal = CGAL::NULL_VECTOR;
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal = normal + CGAL::cross_product(points[corners[i]] - points[corners[0]],
                                          points[corners[(i + 1) % corners.size()]] - points[corners[0]]);
  const auto [x, y] =
      chart_axes({CGAL::to_double(normal.x()), CGAL::to_double(normal.y()), CGAL::to_double(normal.z())});
  Planar_region<Traits> region;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point& p = points[corners[i]];
    region.points.emplace_back(corners[i], typename Traits::Point_2(p[x], p[y]));
    region.boundary.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
  const auto triangles = Region_triangulation<Traits>::run(region);
  if (!triangles)
    fail(Status_code::degenerate_facet, Stage::input, "a polygonal face can't be triangulated", {},
         Part<Traits>::coordinates(points[corners[0]]));
  return *triangles;
}

// Copies a mesh with larger faces and triangulates them; the pieces keep the patch id.
template <class Traits, class FaceGraph, class VertexPointMap, class FacePatchMap>
Part<Traits> triangulated_part(const FaceGraph& mesh, VertexPointMap points_of, FacePatchMap patches) {
  using Mesh = typename Part<Traits>::Mesh;
  using Face = typename Part<Traits>::Face;
  using Vertex = typename Part<Traits>::Vertex;
  Mesh copy;
  std::vector<typename Traits::Point_3> points;
  std::unordered_map<typename boost::graph_traits<FaceGraph>::vertex_descriptor, std::uint32_t> number;
  for (auto v : vertices(mesh)) {
    number[v] = static_cast<std::uint32_t>(points.size());
    points.push_back(get(points_of, v));
    copy.add_vertex(points.back());
  }
  auto id = copy.template add_property_map<Face, int>("f:patch_id", -1).first;
  for (auto f : faces(mesh)) {
    std::vector<std::uint32_t> corners;
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) corners.push_back(number[v]);
    std::vector<Triangle> triangles{{corners[0], corners[1], corners[2]}};
    if (corners.size() > 3) triangles = triangulated_face<Traits>(corners, points);
    for (const Triangle& t : triangles) {
      const Face made = copy.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
      if (!made.is_valid())
        fail(Status_code::degenerate_facet, Stage::input, "a polygonal face can't be triangulated", {},
             Part<Traits>::coordinates(points[t[0]]));
      id[made] = static_cast<int>(get(patches, f));
    }
  }
  const Status status = check_input(copy, copy.points(), id);
  if (!status.ok()) throw Failure{status};
  return value_or_fail(make_part<Traits>(copy, copy.points(), id));
}

// Checks the input and makes the part.
template <class Traits, class FaceGraph, class VertexPointMap, class FacePatchMap>
Part<Traits> read_input(const FaceGraph& mesh, VertexPointMap points, FacePatchMap patches) {
  if constexpr (std::is_same_v<FacePatchMap, CGAL::internal_np::Param_not_found>) {
    fail(Status_code::missing_patch_ids, Stage::input,
         "no face patch map was given, which tells the CAD face of each facet");
  } else {
    if (num_faces(mesh) != 0 && CGAL::is_closed(mesh) && !CGAL::is_triangle_mesh(mesh))
      return triangulated_part<Traits>(mesh, points, patches);
    const Status status = check_input(mesh, points, patches);
    if (!status.ok()) throw Failure{status};
    return value_or_fail(make_part<Traits>(mesh, points, patches));
  }
}

}  // namespace CCSweep::internal

#endif
