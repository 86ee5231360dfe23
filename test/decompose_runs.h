// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_DECOMPOSE_RUNS_H
#define CCSWEEP_TEST_DECOMPOSE_RUNS_H

#include <CCSweep/Status.h>
#include <CCSweep/part/Roles.h>
#include <CCSweep/volumes/Decomposition.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesh_changes.h"

// Decompositions that are to be compared with each other.
namespace decompose_runs {

using mesh_changes::Coordinates;
using mesh_changes::Soup;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Decomposition = CCSweep::Decomposition<Kernel::Point_3>;
using Outcome = CCSweep::Result<Decomposition>;

/// Writes down every call, and stops the run at one of the questions.
struct Recorder {
  enum class Kind { begin, step, end, cancel, drawn, imprinted };
  struct Call {
    Kind kind;
    CCSweep::Stage stage = CCSweep::Stage::input;
    std::size_t number = 0;  ///< the total, or the layer
  };
  std::vector<Call> calls;
  std::size_t questions = 0, refused_question = 0;

  void begin(CCSweep::Stage stage, std::size_t total) { calls.push_back({Kind::begin, stage, total}); }
  void step(CCSweep::Stage stage) { calls.push_back({Kind::step, stage}); }
  void end(CCSweep::Stage stage) { calls.push_back({Kind::end, stage}); }
  bool cancel() {
    calls.push_back({Kind::cancel});
    return ++questions == refused_question;
  }
  template <class LayerDrawing>
  void drawn(std::size_t layer, const LayerDrawing&, const std::vector<int>&) {
    calls.push_back({Kind::drawn, CCSweep::Stage::imprint, layer});
  }
  template <class LoopFaceGraph>
  void imprinted(std::size_t layer, const LoopFaceGraph&) {
    calls.push_back({Kind::imprinted, CCSweep::Stage::imprint, layer});
  }

  std::size_t count(Kind kind) const {
    std::size_t n = 0;
    for (const Call& call : calls) n += call.kind == kind;
    return n;
  }
  std::size_t count(Kind kind, CCSweep::Stage stage) const {
    std::size_t n = 0;
    for (const Call& call : calls) n += call.kind == kind && call.stage == stage;
    return n;
  }
};

struct Request {
  Coordinates direction{};
  std::vector<int> sources = {}, targets = {};
  int layers = 1;
  double spanning_angle = 60;
};

/// In a file of its own and with all parameters, so that the library is compiled once.
Outcome decompose(const Mesh& mesh, const Request& request, Recorder& recorder);

inline Outcome decompose(const Mesh& mesh, const Request& request) {
  Recorder recorder;
  return decompose(mesh, request, recorder);
}

inline Outcome decompose(const Soup& soup, const Request& request) {
  return decompose(mesh_changes::mesh<Kernel::Point_3>(soup), request);
}

/// About a point of the mesh, as the sum about the origin cancels badly far from it.
inline double volume(const Mesh& mesh) {
  const Kernel::Point_3& apex = mesh.point(*mesh.vertices().begin());
  double sum = 0;
  for (Mesh::Face_index f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    sum += CGAL::volume(apex, mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                        mesh.point(mesh.target(mesh.next(h))));
  }
  return sum;
}

/// What must not depend on how a part is placed, ordered or refined.
struct Answer {
  std::map<int, double> volumes;             ///< by target
  std::map<int, std::vector<int>> sources;   ///< by target
  std::multiset<std::pair<int, int>> sets;   ///< the targets on both sides
  std::map<int, CCSweep::Role> roles;
};

inline Answer answer(const Decomposition& found) {
  Answer result;
  for (const auto& v : found.volumes) {
    result.volumes[v.target] += volume(v.mesh);
    result.sources[v.target] = v.sources;
  }
  for (const auto& s : found.sets) {
    const int i = found.volumes[s.volumes[0]].target, j = found.volumes[s.volumes[1]].target;
    result.sets.insert(std::minmax(i, j));
  }
  result.roles = found.roles;
  return result;
}

inline double total(const std::map<int, double>& volumes) {
  double sum = 0;
  for (const auto& [target, v] : volumes) sum += v;
  return sum;
}

inline void expect_same_volumes(const Answer& found, const Answer& expected, double tolerance, double factor = 1) {
  const double size = factor * total(expected.volumes);
  BOOST_TEST(found.volumes.size() == expected.volumes.size());
  for (const auto& [target, v] : expected.volumes) {
    BOOST_TEST_CONTEXT("target " << target) {
      BOOST_TEST(found.volumes.count(target) == 1u);
      if (found.volumes.count(target)) BOOST_TEST(std::abs(found.volumes.at(target) - factor * v) <= tolerance * size);
    }
  }
}

/// `tolerance` is relative to the whole volume.
inline void expect_same(const Answer& found, const Answer& expected, double tolerance, double factor = 1) {
  expect_same_volumes(found, expected, tolerance, factor);
  BOOST_TEST((found.sources == expected.sources));
  BOOST_TEST((found.roles == expected.roles));
  BOOST_TEST(found.sets.size() == expected.sets.size());
  BOOST_TEST((found.sets == expected.sets));
}

inline void expect_ok(const Outcome& outcome) {
  BOOST_TEST(outcome.ok(), name(outcome.status().code) << " in stage " << name(outcome.status().stage) << ": "
                                                       << outcome.status().reason);
}

/// Decomposes a changed part and compares.
inline void expect_same(const Soup& soup, const Request& request, const Answer& expected, double tolerance,
                        double factor = 1) {
  const Outcome outcome = decompose(soup, request);
  expect_ok(outcome);
  if (outcome.ok()) expect_same(answer(outcome.value()), expected, tolerance, factor);
}

/// Vertices and faces in the same order, bit for bit, with `f` applied to the points of `a`.
template <class Function>
bool is_same_mesh(const Mesh& a, const Mesh& b, Function f) {
  if (a.number_of_vertices() != b.number_of_vertices() || a.number_of_faces() != b.number_of_faces()) return false;
  for (Mesh::Vertex_index v : a.vertices()) {
    const auto &p = a.point(v), &q = b.point(v);
    if (f(Coordinates{p.x(), p.y(), p.z()}) != Coordinates{q.x(), q.y(), q.z()}) return false;
  }
  for (const char* name : {"f:patch_id", "f:role"}) {
    const auto m = a.property_map<Mesh::Face_index, int>(name), n = b.property_map<Mesh::Face_index, int>(name);
    if (m.second != n.second) return false;
    for (Mesh::Face_index g : a.faces())
      if (m.second && m.first[g] != n.first[g]) return false;
  }
  for (Mesh::Halfedge_index h : a.halfedges())
    if (a.target(h) != b.target(h) || a.next(h) != b.next(h) || a.face(h) != b.face(h)) return false;
  return true;
}

template <class Function>
void expect_same_bytes(const Decomposition& a, const Decomposition& b, Function f) {
  BOOST_TEST(a.volumes.size() == b.volumes.size());
  if (a.volumes.size() != b.volumes.size()) return;
  for (std::size_t i = 0; i < a.volumes.size(); ++i) {
    BOOST_TEST(a.volumes[i].target == b.volumes[i].target);
    BOOST_TEST((a.volumes[i].sources == b.volumes[i].sources));
    BOOST_TEST(is_same_mesh(a.volumes[i].mesh, b.volumes[i].mesh, f), "the sub-volumes number " << i << " differ");
  }
  BOOST_TEST(a.sets.size() == b.sets.size());
  for (std::size_t i = 0; i < std::min(a.sets.size(), b.sets.size()); ++i) {
    BOOST_TEST(a.sets[i].id == b.sets[i].id);
    BOOST_TEST((a.sets[i].volumes == b.sets[i].volumes));
    BOOST_TEST(a.sets[i].triangles == b.sets[i].triangles);
  }
}

}  // namespace decompose_runs

#endif
