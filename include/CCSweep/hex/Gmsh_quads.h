// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_GMSH_QUADS_H
#define CCSWEEP_HEX_GMSH_QUADS_H

#include <CCSweep/hex/Quad_region.h>
#include <CCSweep/hex/smooth_quads.h>

#include <gmsh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

/// Gmsh is one for the whole program: it starts with the first object that needs it and ends with the last.
class Gmsh_session {
 public:
  static std::shared_ptr<Gmsh_session> share() {
    static std::weak_ptr<Gmsh_session> current;
    auto session = current.lock();
    if (!session) current = session = std::shared_ptr<Gmsh_session>(new Gmsh_session);
    return session;
  }
  ~Gmsh_session() { gmsh::finalize(); }
  Gmsh_session(const Gmsh_session&) = delete;
  Gmsh_session& operator=(const Gmsh_session&) = delete;

 private:
  Gmsh_session() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
  }
};

/// A region as a model of Gmsh, which lasts as long as the object.
class Gmsh_region {
 public:
  Gmsh_region(const Quad_region& region, double size) {
    gmsh::model::add("region");
    std::vector<int> loops;
    for (const auto& loop : region.loops) {
      const std::size_t first = corners_.size();
      for (const auto& [x, y] : loop.nodes) corners_.push_back(gmsh::model::geo::addPoint(x, y, 0, size));
      std::vector<int> lines;
      for (std::size_t i = first; i < corners_.size(); ++i) {
        lines.push_back(gmsh::model::geo::addLine(corners_[i], corners_[i + 1 < corners_.size() ? i + 1 : first]));
        gmsh::model::geo::mesh::setTransfiniteCurve(lines.back(), 2);  // the loops' nodes and no others
      }
      loops.push_back(gmsh::model::geo::addCurveLoop(lines));
    }
    face_ = gmsh::model::geo::addPlaneSurface(loops);
    gmsh::model::geo::synchronize();
  }
  ~Gmsh_region() { gmsh::model::remove(); }
  Gmsh_region(const Gmsh_region&) = delete;
  Gmsh_region& operator=(const Gmsh_region&) = delete;

  std::optional<Quad_mesh> mesh() const {
    // The frontal algorithm for quads, 8, crashes on narrow regions in Gmsh 4.8.
    constexpr int blossom = 1, frontal = 6, triangle = 2, quad = 3;
    gmsh::option::setNumber("Mesh.RecombinationAlgorithm", blossom);
    gmsh::model::mesh::setAlgorithm(2, face_, frontal);
    gmsh::model::mesh::setRecombine(2, face_);
    gmsh::model::mesh::generate(2);
    // Gmsh takes what is in a vector already for its size.
    std::vector<std::size_t> triangles, corners_of_triangles, quads, corners_of_quads;
    gmsh::model::mesh::getElementsByType(triangle, triangles, corners_of_triangles);
    gmsh::model::mesh::getElementsByType(quad, quads, corners_of_quads);
    if (!triangles.empty() || quads.empty()) return std::nullopt;

    Quad_mesh mesh;
    std::map<std::size_t, std::uint32_t> number;
    const auto add_nodes = [&](int dimension, int entity) {
      std::vector<std::size_t> tags;
      std::vector<double> places, parameters;
      gmsh::model::mesh::getNodes(tags, places, parameters, dimension, entity);
      for (std::size_t i = 0; i < tags.size(); ++i) {
        number[tags[i]] = static_cast<std::uint32_t>(mesh.points.size());
        mesh.points.push_back({places[3 * i], places[3 * i + 1]});
      }
    };
    for (const int corner : corners_) add_nodes(0, corner);
    add_nodes(2, face_);
    for (std::size_t i = 0; i < corners_of_quads.size(); i += 4) {
      auto& made = mesh.quads.emplace_back();
      for (std::size_t k = 0; k < 4; ++k) made[k] = number.at(corners_of_quads[i + k]);
    }
    return mesh;
  }

 private:
  std::vector<int> corners_;  // by node of the region
  int face_;
};

}  // namespace internal

/// Meshes with Gmsh's recombined frontal mesh; a model of `QuadMesher` for programs that link Gmsh's library.
///
/// Gmsh has one state for the whole program, so that this may be used by one thread only, and not between calls of
/// `gmsh::initialize()` and `gmsh::finalize()`.
/// \return nothing where Gmsh fails, or leaves a triangle over.
class Gmsh_quads {
 public:
  std::optional<Quad_mesh> operator()(const Quad_region& region, double size) const {
    try {
      auto mesh = internal::Gmsh_region(region, size).mesh();
      if (mesh) smooth_quads(*mesh, number_of_nodes(region));
      return mesh;
    } catch (...) {  // text, or an exception, depending on the version
      return std::nullopt;
    }
  }

 private:
  std::shared_ptr<internal::Gmsh_session> session_ = internal::Gmsh_session::share();
};

}  // namespace CCSweep

#endif
