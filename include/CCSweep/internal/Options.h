// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_INTERNAL_OPTIONS_H
#define CCSWEEP_INTERNAL_OPTIONS_H

#include <CCSweep/linking/Layering.h>
#include <CCSweep/loops/point_index.h>
#include <CCSweep/loops/segment_index.h>
#include <CCSweep/parameters.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/visitor.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <array>
#include <functional>
#include <type_traits>
#include <vector>

namespace CCSweep::internal {

// The named parameters of a call, unpacked once.
struct Options {
  Role_request roles;
  Layering_options layering;
  double tolerance = 1e-5;  // relative to the diagonal of the bounding box
  std::size_t neighbours = 10;
};

template <class T>
T& unwrap(T& value) { return value; }
template <class T>
T& unwrap(std::reference_wrapper<T>& reference) { return reference.get(); }

// A direction may come as three doubles or as a vector of any kernel.
inline std::array<double, 3> to_array(const std::array<double, 3>& direction) { return direction; }
template <class Vector_3>
std::array<double, 3> to_array(const Vector_3& v) {
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

template <class NamedParameters>
Options unpack(const NamedParameters& np) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Options options;
  options.roles.direction =
      to_array(choose_parameter(get_parameter(np, internal_np::direction), options.roles.direction));
  options.roles.sources = choose_parameter(get_parameter(np, internal_np::sources), options.roles.sources);
  options.roles.targets = choose_parameter(get_parameter(np, internal_np::targets), options.roles.targets);
  options.tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), options.tolerance);
  options.layering.spanning_angle =
      choose_parameter(get_parameter(np, internal_np::spanning_angle), options.layering.spanning_angle);
  options.layering.slabs = choose_parameter(get_parameter(np, internal_np::layers), options.layering.slabs);
  options.neighbours = choose_parameter(get_parameter(np, internal_np::neighbours), options.neighbours);
  return options;
}

// The type a parameter was given with, or its default.
template <class Tag, class NamedParameters, class Default>
using Parameter_type = std::decay_t<
    typename CGAL::internal_np::Lookup_named_param_def<Tag, NamedParameters, Default>::type>;

template <class FaceGraph, class NamedParameters>
using Default_traits = typename CGAL::GetGeomTraits<FaceGraph, NamedParameters>::type;

}  // namespace CCSweep::internal

#endif
