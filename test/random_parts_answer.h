// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_RANDOM_PARTS_ANSWER_H
#define CCSWEEP_TEST_RANDOM_PARTS_ANSWER_H

#include "random_parts_surface.h"

// The expected answer, read off the columns: nothing here looks at the mesh or at the library.
namespace random_parts::solid {

/// Counts decomposition sets: one for each edge of the overlay of all outlines as carried along the sweep, pair of
/// sub-volumes on its two sides and connected range of heights; what never meets that range does not divide it.
class Set_counter {
 public:
  explicit Set_counter(const Columns& columns) : columns_(columns) {
    for (auto e : columns.overlay().finite_edges()) add_elements(e.first, e.second);
    groups_ = Groups(elements_.size());
    for (auto v : columns.overlay().finite_vertex_handles()) join_at(v);
  }

  std::size_t count() {
    std::set<int> leaders;
    for (int i = 0; i < static_cast<int>(elements_.size()); ++i) leaders.insert(groups_.find(i));
    return leaders.size();
  }

 private:
  /// Two columns of different targets side by side along one edge of the triangulated overlay.
  struct Element {
    int low, high;
    int left, right;  ///< targets, as seen along the edge from its first vertex
  };
  /// An edge as seen from one of its ends.
  struct Spoke {
    std::pair<int, int> edge;
    int left, right;  ///< cells
    Vector direction;
  };

  void add_elements(Overlay::Face_handle f, int i) {
    const int a = f->vertex(Overlay::ccw(i))->info(), b = f->vertex(Overlay::cw(i))->info();
    for (const Column& l : columns_.of(f->info()))
      for (const Column& r : columns_.of(f->neighbor(i)->info())) {
        const int low = std::max(l.low, r.low), high = std::min(l.high, r.high);
        if (l.low_patch == r.low_patch || low >= high) continue;
        const int left = a < b ? l.low_patch : r.low_patch, right = a < b ? r.low_patch : l.low_patch;
        of_edge_[std::minmax(a, b)].push_back(static_cast<int>(elements_.size()));
        elements_.push_back({low, high, left, right});
      }
  }

  std::vector<Spoke> spokes(Overlay::Vertex_handle v) const {
    std::vector<Spoke> result;
    auto f = columns_.overlay().incident_faces(v), end = f;
    do {  // the edge that enters each face counter-clockwise: the face is on its left
      const int i = Overlay::cw(f->index(v));
      auto w = f->vertex(Overlay::ccw(f->index(v)));
      if (columns_.overlay().is_infinite(w)) continue;
      result.push_back(
          {std::minmax({v->info(), w->info()}), f->info(), f->neighbor(i)->info(), w->point() - v->point()});
    } while (++f != end);
    return result;
  }

  /// Whether an outline runs along the edge at some height of the closed range.
  bool is_outline(const Spoke& s, int low, int high) const {
    for (int k = std::max(low - 1, 0); k <= high; ++k) {
      const Column *l = columns_.at(s.left, k), *r = columns_.at(s.right, k);
      if ((l ? l->low_patch : -1) != (r ? r->low_patch : -1)) return true;
    }
    auto tops_differ = [&](int here, int there) {
      for (const Column& c : columns_.of(here)) {
        const auto& others = columns_.of(there);
        if (low <= c.high && c.high <= high &&
            std::none_of(others.begin(), others.end(), [&](const Column& o) { return o.high_patch == c.high_patch; }))
          return true;
      }
      return false;
    };
    return tops_differ(s.left, s.right) || tops_differ(s.right, s.left);
  }

  void join_at(Overlay::Vertex_handle v) {
    const std::vector<Spoke> around = spokes(v);
    for (std::size_t i = 0; i < around.size(); ++i)
      for (std::size_t j = i + 1; j < around.size(); ++j)
        for (int x : elements(around[i].edge))
          for (int y : elements(around[j].edge))
            if (continues(v->info(), around[i], elements_[x], around[j], elements_[y]) &&
                !is_divided(around, i, j, std::min(elements_[x].low, elements_[y].low),
                            std::max(elements_[x].high, elements_[y].high)))
              groups_.unite(x, y);
  }

  std::vector<int> elements(const std::pair<int, int>& edge) const {
    auto found = of_edge_.find(edge);
    return found == of_edge_.end() ? std::vector<int>() : found->second;
  }

  static bool continues(int v, const Spoke& s, const Element& x, const Spoke& t, const Element& y) {
    const bool out_x = s.edge.first == v, out_y = t.edge.first == v;
    const int left = out_x ? x.left : x.right, right = out_x ? x.right : x.left;
    return left == (out_y ? y.right : y.left) && right == (out_y ? y.left : y.right) &&
           std::max(x.low, y.low) < std::min(x.high, y.high);
  }

  bool is_divided(const std::vector<Spoke>& around, std::size_t i, std::size_t j, int low, int high) const {
    if (turn(around[i].direction, -around[j].direction) >= smooth_turn) return true;
    for (std::size_t k = 0; k < around.size(); ++k)
      if (k != i && k != j && is_outline(around[k], low, high)) return true;
    return false;
  }

  const Columns& columns_;
  std::vector<Element> elements_;
  std::map<std::pair<int, int>, std::vector<int>> of_edge_;
  Groups groups_;
};

/// Whether all material hangs together through common faces.
inline bool is_connected(const Columns& columns) {
  const int slabs = static_cast<int>(columns.heights().size());
  Groups voxels(columns.number_of_cells() * slabs);
  std::set<int> leaders;
  for (auto f : columns.overlay().finite_face_handles())
    for (int k = 0; k + 1 < slabs; ++k) {
      const Column* c = columns.at(f->info(), k);
      if (!c) continue;
      if (k + 1 < c->high) voxels.unite(f->info() * slabs + k, f->info() * slabs + k + 1);
      for (int i = 0; i < 3; ++i)
        if (columns.at(f->neighbor(i)->info(), k))
          voxels.unite(f->info() * slabs + k, f->neighbor(i)->info() * slabs + k);
    }
  for (auto f : columns.overlay().finite_face_handles())
    for (int k = 0; k + 1 < slabs; ++k)
      if (columns.at(f->info(), k)) leaders.insert(voxels.find(f->info() * slabs + k));
  return leaders.size() == 1;
}

}  // namespace random_parts::solid

namespace random_parts {

/// The part of a plan with its known answer; nothing where the plan makes no sound part: material that begins above
/// its end or falls apart, or features so close to each other that a tolerance may merge them.
inline std::optional<Part> build(const Plan& plan) {
  solid::Columns columns(plan);
  if (!columns.is_valid() || !solid::is_connected(columns)) return std::nullopt;
  std::optional<Part> part = solid::Surface(columns).part();
  if (!part) return std::nullopt;
  std::map<int, solid::Kernel::FT> volume;
  solid::Kernel::FT total = 0;
  for (auto f : columns.overlay().finite_face_handles())
    for (const solid::Column& c : columns.of(f->info())) {
      const double low = columns.heights()[c.low], high = columns.heights()[c.high];
      const solid::Kernel::FT v = columns.area(f->info()) * (solid::Kernel::FT(high) - low);
      volume.try_emplace(c.low_patch, 0).first->second += v;  // a lazy number made without a value is not zero
      total += v;
      part->sources.insert(c.high_patch);
      part->prisms.push_back({{}, low, high, c.low_patch});
      for (int i = 0; i < 3; ++i) {
        const solid::Point& p = f->vertex(i)->point();
        part->prisms.back().base[i] = {CGAL::to_double(p.x()), CGAL::to_double(p.y())};
      }
    }
  part->volume = CGAL::to_double(total);
  for (const auto& [target, v] : volume) part->sub_volumes[target] = CGAL::to_double(v);
  part->sets = solid::Set_counter(columns).count();
  return part;
}

}  // namespace random_parts

#endif
