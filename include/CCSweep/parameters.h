// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_PARAMETERS_H
#define CCSWEEP_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

// The parameters that CGAL has no name for. Each line makes a tag, a member that continues a chain, and a free
// function that starts one, just as a line of CGAL's own list does.
#define CCSWEEP_FOR_EACH_NAMED_PARAMETER(ADD)     \
  ADD(direction_t, direction, direction)          \
  ADD(sources_t, sources, sources)                \
  ADD(targets_t, targets, targets)                \
  ADD(tolerance_t, tolerance, tolerance)          \
  ADD(spanning_angle_t, spanning_angle, spanning_angle) \
  ADD(layers_t, layers, layers)                   \
  ADD(neighbours_t, neighbours, neighbours)       \
  ADD(segment_index_t, segment_index, segment_index) \
  ADD(point_index_t, point_index, point_index)       \
  ADD(interval_solver_t, interval_solver, interval_solver) \
  ADD(quad_mesher_t, quad_mesher, quad_mesher)

namespace CCSweep {

namespace internal_np {

#define CCSWEEP_ADD_TAG(Tag, tag, function) enum Tag { tag };
CCSWEEP_FOR_EACH_NAMED_PARAMETER(CCSWEEP_ADD_TAG)
#undef CCSWEEP_ADD_TAG

}  // namespace internal_np

/// A pack of named parameters, ours and CGAL's in any order. It is a pack of CGAL's too, so that CGAL's functions
/// take it and skip what they don't know. As in CGAL, a pack keeps copies: hand over what must not be copied, a
/// visitor with a state for example, as `std::ref(visitor)`.
///
/// CGAL makes every name a member of its pack, which nobody else can add to. This pack therefore has members of the
/// same names as CGAL's that return a pack of ours, where a chain can go on with a name of ours.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
class Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base> {
  using Of_CGAL = CGAL::Named_function_parameters<T, Tag, Base>;

 public:
  Named_parameters() = default;
  explicit Named_parameters(const T& value) : Of_CGAL(value) {}
  Named_parameters(const T& value, const Base& base) : Of_CGAL(value, base) {}
  explicit Named_parameters(const Of_CGAL& pack) : Of_CGAL(pack) {}

#define CGAL_add_named_parameter(Added, tag, function)                                     \
  template <class Value>                                                                   \
  auto function(const Value& value) const {                                                \
    return Named_parameters<Value, CGAL::internal_np::Added, Named_parameters>(value, *this); \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

#define CCSWEEP_ADD_MEMBER(Added, tag, function)                                        \
  template <class Value>                                                                \
  auto function(const Value& value) const {                                             \
    return Named_parameters<Value, internal_np::Added, Named_parameters>(value, *this); \
  }
  CCSWEEP_FOR_EACH_NAMED_PARAMETER(CCSWEEP_ADD_MEMBER)
#undef CCSWEEP_ADD_MEMBER
};

/// The named parameters of the library: functions that start a chain, `tolerance(1e-6).layers(4).visitor(v)`.
/// Of CGAL's names, `vertex_point_map`, `face_patch_map`, `geom_traits`, `visitor` and `size` mean here what they mean
/// there.
///
/// | name | is | default |
/// |---|---|---|
/// | `vertex_point_map` | a readable map from vertex to point | `get(CGAL::vertex_point, mesh)` |
/// | `face_patch_map` | a readable map from face to the `int` id of its CAD face | none: the part is refused |
/// | `geom_traits` | a model of `SweepTraits` | the kernel of the points |
/// | `visitor` | a model of `SweepVisitor` | does nothing |
/// | `direction` | `std::array<double, 3>` or a vector: from targets to sources, at the targets | chosen |
/// | `sources`, `targets` | `std::vector<int>`: the ids of the caps | chosen |
/// | `tolerance` | `double`: merging distance of the imprint, relative to the diagonal of the part's box | 1e-5 |
/// | `spanning_angle` | `double`: how far a bent sweep may turn between two layers, in degrees | 7.5 |
/// | `layers` | `int`: at least so many layers between two levels; the sub-volumes do not depend on it | 1 |
/// | `neighbours` | `int`: wall nodes whose residuals a projected node heeds, eq. (4) | 10 |
/// | `size` | `double` or a model of `SizingField`: edge length of the hexahedra of `hex_mesh()` | none: needed there |
/// | `interval_solver` | a model of `IntervalSolver`, for `hex_mesh()` | `Parity_intervals` |
/// | `quad_mesher` | a model of `QuadMesher`, for `hex_mesh()` | `Best_quads` |
/// | `segment_index` | a model of `SegmentIndex_2`; only its type counts | an r-tree |
/// | `point_index` | a model of `PointIndex_3`; only its type counts | an r-tree |
namespace parameters {

/// The pack in which every parameter has its default.
inline auto default_values() { return Named_parameters<bool, CGAL::internal_np::all_default_t>(); }

/// Continues a chain that CGAL's functions began: `from(CGAL::parameters::face_patch_map(p)).tolerance(1e-6)`.
template <class T, class Tag, class Base>
auto from(const CGAL::Named_function_parameters<T, Tag, Base>& pack) {
  return Named_parameters<T, Tag, Base>(pack);
}

#define CGAL_add_named_parameter(Added, tag, function)                   \
  template <class Value>                                                 \
  auto function(const Value& value) {                                    \
    return Named_parameters<Value, CGAL::internal_np::Added>(value);     \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter

#define CCSWEEP_ADD_FUNCTION(Added, tag, function)             \
  template <class Value>                                       \
  auto function(const Value& value) {                          \
    return Named_parameters<Value, internal_np::Added>(value); \
  }
CCSWEEP_FOR_EACH_NAMED_PARAMETER(CCSWEEP_ADD_FUNCTION)
#undef CCSWEEP_ADD_FUNCTION

}  // namespace parameters
}  // namespace CCSweep

#undef CCSWEEP_FOR_EACH_NAMED_PARAMETER

#endif
