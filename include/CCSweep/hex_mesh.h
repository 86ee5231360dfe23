// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_MESH_H
#define CCSWEEP_HEX_MESH_H

#include <CCSweep/Status.h>
#include <CCSweep/concepts.h>
#include <CCSweep/hex/Best_mesh.h>
#include <CCSweep/hex/Hex_mesh.h>
#include <CCSweep/hex/Parity_intervals.h>
#include <CCSweep/hex/mesh_quads.h>
#include <CCSweep/hex/sizing.h>
#include <CCSweep/internal/Hex_pipeline.h>
#include <CCSweep/internal/Input.h>
#include <CCSweep/internal/Options.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/internal/outer_mesh.h>
#include <CCSweep/volumes/Decomposition.h>

#include <CGAL/number_utils.h>

#include <array>
#include <type_traits>
#include <vector>

namespace CCSweep {
namespace internal {

inline Patch_sizes to_sizing(double size) { return size; }
template <SizingField Sizing>
  requires(!std::is_arithmetic_v<Sizing>)
Sizing to_sizing(const Sizing& sizing) {
  return sizing;
}

/// The direction in which a sub-volume leads away from its target.
template <class Point>
std::array<double, 3> direction_of(const Sub_volume<Point>& volume) {
  using Volume = Sub_volume<Point>;
  const auto& mesh = volume.mesh;
  const auto role = mesh.template property_map<typename Volume::Mesh::Face_index, int>(Volume::role_map).first;
  const auto place = [&](auto v) {
    const Point& p = mesh.point(v);
    return Vec3{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  };
  Vec3 sum{};
  for (auto f : mesh.faces()) {
    if (role[f] != static_cast<int>(Role::target)) continue;
    const auto h = mesh.halfedge(f);
    const Vec3 a = place(mesh.source(h)), b = place(mesh.target(h)), c = place(mesh.target(mesh.next(h)));
    sum = sum - cross(b - a, c - a);
  }
  return sum;
}

template <class T>
inline constexpr bool is_decomposition = false;
template <class Point>
inline constexpr bool is_decomposition<Decomposition<Point>> = true;
template <class T>
inline constexpr bool is_sub_volume = false;
template <class Point>
inline constexpr bool is_sub_volume<Sub_volume<Point>> = true;

}  // namespace internal

/// Meshes a multi-sweep part with hexahedra, conformal across all the sub-volumes that `decompose()` would make of it.
///
/// The layers of the decomposition, with further ones at the size asked for, are cut into columns of one source and one
/// target each; one quad mesh of a column's section is swept from its source to its target. Neighbouring columns share
/// the nodes between them. Nodes on the boundary lie on the facets of the part. A sub-volume that this sweep does not
/// suit is swept anew in a straight direction of its own, if there is one in which all its cuts are linking faces, and
/// if its hexahedra are the better for it; the nodes on its cuts stay as they are.
///
/// \tparam FaceGraph a model of `SweepMesh`, with what `decompose()` asks of it
/// \param np a sequence of named parameters, see `CCSweep::parameters`; `face_patch_map` and `size` are needed
///
/// \return the mesh, every hexahedron of which has a positive Jacobian determinant everywhere; or a status that names
/// stage, patches and place. `hex_mesh_failed` if a hexahedron would fold, `invalid_parameter` for a size that is no
/// positive number or absurdly small.
/// The sizes are a number or a `SizingField`, for example `Patch_sizes(2).patch(7, 0.5)`.
/// Complexity: linear in the hexahedra, and one sparse factorisation for each column's section.
template <class FaceGraph, class NamedParameters>
  requires(!internal::is_decomposition<FaceGraph> && !internal::is_sub_volume<FaceGraph>) && SweepMesh<FaceGraph>
Result<Hex_mesh> hex_mesh(const FaceGraph& mesh, const NamedParameters& np) {
  using Call = internal::Call<FaceGraph, NamedParameters>;
  using Traits = typename Call::Traits;
  return internal::guarded([&] {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    auto&& visitor = Call::visitor(np);
    const internal::Options options = internal::unpack(np);
    const internal::Hex_policies policies{
        internal::to_sizing(choose_parameter(get_parameter(np, CGAL::internal_np::size), 0.0)),
        choose_parameter(get_parameter(np, internal_np::interval_solver), Parity_intervals()),
        choose_parameter(get_parameter(np, internal_np::quad_mesher), Best_quads())};
    const Part<Traits> part = internal::read_input<Traits>(mesh, Call::points(mesh, np), Call::patches(np));
    return internal::Hex_pipeline<Traits, typename Call::Segment_index, typename Call::Point_index,
                                  std::remove_reference_t<decltype(visitor)>, std::remove_const_t<decltype(policies)>>(
        part, options, policies, visitor)();
  });
}

/// Meshes a decomposition with hexahedra at any size: the part it was made of, in the same sense and with the same
/// caps.
/// \param np a sequence of named parameters; `size` is needed, roles and direction are those of the decomposition
template <class Point, class NamedParameters>
Result<Hex_mesh> hex_mesh(const Decomposition<Point>& decomposition, const NamedParameters& np) {
  return internal::guarded([&] {
    const auto outer = internal::outer_mesh(decomposition);
    std::vector<int> sources, targets;
    for (const auto& [patch, role] : decomposition.roles) {
      if (role == Role::source) sources.push_back(patch);
      if (role == Role::target) targets.push_back(patch);
    }
    return internal::value_or_fail(hex_mesh(outer.mesh, np.direction(decomposition.direction)
                                                            .sources(sources)
                                                            .targets(targets)
                                                            .face_patch_map(outer.patch_ids())));
  });
}

/// Meshes one sub-volume by itself, in the direction that suits it best: its own, from its target to its sources, or if
/// no good mesh comes of that, any other in which it can be swept. Its cuts then are faces like all others, so the mesh
/// need not conform to those of its neighbours.
/// \param np a sequence of named parameters; `size` is needed
template <class Point, class NamedParameters>
Result<Hex_mesh> hex_mesh(const Sub_volume<Point>& volume, const NamedParameters& np) {
  return internal::guarded([&] {
    constexpr double good = 0.4;
    using Volume = Sub_volume<Point>;
    const auto patch =
        volume.mesh.template property_map<typename Volume::Mesh::Face_index, int>(Volume::patch_id_map).first;
    internal::Best_mesh best(good);
    if (!best.show(hex_mesh(volume.mesh, np.direction(internal::direction_of(volume))
                                             .sources(volume.sources)
                                             .targets(std::vector<int>{volume.target})
                                             .face_patch_map(patch))))
      best.show(hex_mesh(volume.mesh, np.face_patch_map(patch)));
    return best.take();
  });
}

}  // namespace CCSweep

#endif
