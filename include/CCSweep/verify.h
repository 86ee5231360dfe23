// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VERIFY_H
#define CCSWEEP_VERIFY_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/verify_coverage.h>
#include <CCSweep/internal/verify_curves.h>
#include <CCSweep/internal/verify_intersections.h>
#include <CCSweep/internal/verify_manifold.h>
#include <CCSweep/internal/verify_partition.h>
#include <CCSweep/internal/verify_scene.h>
#include <CCSweep/internal/verify_volume.h>
#include <CCSweep/volumes/Decomposition.h>

namespace CCSweep {

/// Checks a finished decomposition against its input, independently of the algorithm that made it.
///
/// It holds when
/// - each sub-volume is one closed surface, 2-manifold as indexed, oriented outward, without degenerate triangles
///   and without self-intersection (contact in vertices and edges of identical coordinates is none);
/// - each sub-volume has one target and at least one source, and the roles of all faces are those of `result.roles`,
///   or `Role::cut` on faces whose id is no patch of the input;
/// - each cut triangle stands in exactly two sub-volumes, bit for bit, with opposite orientation and the same id,
///   and the cuts are those listed in `result.sets`;
/// - each other triangle lies on the input patch it names, within 1e-9 of the diagonal of the bounding box; no
///   patch is lost or covered twice; corners are kept, and so is the length of the curves between patches;
/// - the volumes, summed in exact arithmetic, are what the outer triangles enclose, and the volume of the input:
///   exactly with an exact number type, else within 1e-12 and the rounding of the coordinates.
///
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`; all faces must be triangles
/// \tparam VertexPointMap a readable property map from its vertices to points
/// \tparam FacePatchMap a readable property map from its faces to `int`
/// \tparam Point the points of the result; if their number type is not a floating point type, it is taken to be exact
///
/// \return a status with code `ok`, or with code `verification_failed`, stage `verification`, the first broken
///         promise in words, the ids of the patches (or cuts) concerned, and a place near it.
///
/// Deterministic. The time is O(n log n) for n triangles, plus the number of pairs of triangles whose bounding boxes
/// in a frame along `result.direction` overlap.
template <class FaceGraph, class VertexPointMap, class FacePatchMap, class Point>
Status verify(const FaceGraph& input, VertexPointMap point_of_vertex, FacePatchMap patch_of_face,
              const Decomposition<Point>& result) {
  namespace check = internal::verification;
  using Kernel = typename check::Exact_kernel<Point>::type;
  try {
    auto scene = check::read_scene<Kernel>(input, point_of_vertex, patch_of_face, result);
    check::check_order(result);
    check::check_role_table(scene, result);
    check::check_manifold(scene, scene.input);
    for (std::size_t i = 0; i < scene.volumes.size(); ++i) {
      check::check_manifold(scene, scene.volumes[i]);
      check::check_one_surface(scene.volumes[i]);
      check::check_roles(scene, result, i);
    }
    check::check_sets(scene, result);
    check::check_volumes(scene);
    check::check_curves(scene);
    check::check_corners(scene);
    check::Coverage<Kernel>(scene, result.direction).check();
    for (const auto& volume : scene.volumes) check::check_intersections(scene, volume, result.direction);
    return {};
  } catch (internal::Failure& failure) {
    return std::move(failure.status);
  }
}

/// Checks a finished decomposition against its input, whose points are those of the graph's own vertex point map.
template <class FaceGraph, class FacePatchMap, class Point>
Status verify(const FaceGraph& input, FacePatchMap patch_of_face, const Decomposition<Point>& result) {
  return verify(input, get(CGAL::vertex_point, input), patch_of_face, result);
}

}  // namespace CCSweep

#endif
