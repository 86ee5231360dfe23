// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_CUT_TRIANGLES_H
#define CCSWEEP_VOLUMES_CUT_TRIANGLES_H

#include <CCSweep/internal/Union_find.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/volumes/Cut_rows.h>
#include <CCSweep/volumes/Cut_surface.h>
#include <CCSweep/volumes/triangulate_plane.h>

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// The cut surfaces as triangles over the vertices of the cut surface of the part, and the decomposition set of each.
struct Cut_triangles {
  std::vector<Triangle> triangles;   ///< outward for the sub-volume of `left`
  std::vector<Patch_index> left, right;
  std::vector<std::size_t> set;      ///< numbered from 0
  std::size_t number_of_sets = 0;
  std::vector<std::pair<std::size_t, Patch_index>> on_surface;  ///< surface triangles that cuts fell on, and to whom
                                                                ///< these leave them
};

/// Triangulates the rows of the cuts, two triangles between four nodes, and gathers them into decomposition sets: one
/// for each LoopEdge, pair of targets and connected range of layers (section 2.8).
template <class Traits>
class Cut_triangulator {
 public:
  Cut_triangulator(const Layered_loops<Traits>& loops, const std::vector<Cut_row>& rows,
                   const Cut_surface<Traits>& surface)
      : loops_(loops), rows_(rows), surface_(surface) {}

  Cut_triangles run() {
    for (const Cut_row& row : rows_)
      for (std::size_t i = 0; i + 1 < row.bottom.size(); ++i) add_cell(row, i);
    loop_edges_.emplace(cells_.size());
    join_cells_up();
    join_cells_along();
    number_sets();
    cancel_folds();
    leave_surface();
    number_sets_without_gaps();
    return std::move(result_);
  }

 private:
  // The part of a row between two neighbouring columns.
  struct Cell {
    const Cut_row* row;
    std::size_t i;
    std::size_t first_triangle;
  };

  std::uint32_t vertex(Node_index n) const { return surface_.vertex_of_node[n.value()]; }

  void add_cell(const Cut_row& row, std::size_t i) {
    cells_.push_back({&row, i, result_.triangles.size()});
    const auto bottom = surface_.path(vertex(row.bottom[i]), vertex(row.bottom[i + 1]));
    const auto right = surface_.path(vertex(row.bottom[i + 1]), vertex(row.top[i + 1]));
    const auto top = surface_.path(vertex(row.top[i]), vertex(row.top[i + 1]));
    const auto left = surface_.path(vertex(row.bottom[i]), vertex(row.top[i]));
    const bool is_plain = bottom.size() + right.size() + top.size() + left.size() == 8;
    const bool has_collapsed = bottom.front() == bottom.back() || top.front() == top.back() ||
                               left.front() == left.back() || right.front() == right.back();
    // A fan far up a wall would cut into it where it bulges between.
    if (!is_plain && !has_collapsed)
      add_polygon(bottom, right, top, left);
    else if (is_on_surface(row.bottom[i]) && !is_on_surface(row.bottom[i + 1]))
      add_fan(bottom.back(), joined(reversed_path(top), reversed_path(left)));
    else
      add_fan(bottom.front(), joined(right, reversed_path(top)));
    for (std::size_t t = cells_.back().first_triangle; t < result_.triangles.size(); ++t) {
      result_.left.push_back(row.left);
      result_.right.push_back(row.right);
    }
  }

  bool is_on_surface(Node_index n) const { return loops_.node(n).where.on_surface(); }

  using Path = std::vector<std::uint32_t>;
  static Path reversed_path(Path path) {
    std::reverse(path.begin(), path.end());
    return path;
  }
  static Path joined(Path first, const Path& second) {
    first.insert(first.end(), second.begin() + 1, second.end());
    return first;
  }

  // From an inner node, so that no triangle lies in the wall where a cut runs up along it.
  void add_fan(std::uint32_t centre, const Path& around) {
    for (std::size_t k = 0; k + 1 < around.size(); ++k)
      if (around[k] != around[k + 1] && around[k] != centre && around[k + 1] != centre)
        add_triangle({centre, around[k], around[k + 1]});
  }

  void add_triangle(const Triangle& t) { result_.triangles.push_back(t); }

  // Sides with further vertices: triangulated on the unit square, where each vertex stands at its fraction.
  void add_polygon(const std::vector<std::uint32_t>& bottom, const std::vector<std::uint32_t>& right,
                   const std::vector<std::uint32_t>& top, const std::vector<std::uint32_t>& left) {
    Planar_region<Traits> region;
    auto add_side = [&](const std::vector<std::uint32_t>& side, auto&& place) {
      const std::vector<double> fraction = fractions(side);
      for (std::size_t k = 0; k < side.size(); ++k) {
        const auto [x, y] = place(fraction[k]);
        region.points.emplace_back(side[k], typename Traits::Point_2(x, y));
        if (k > 0) region.boundary.push_back({side[k - 1], side[k]});
      }
    };
    using XY = std::pair<double, double>;
    add_side(bottom, [](double f) { return XY(f, 0); });
    add_side(top, [](double f) { return XY(f, 1); });
    add_side(left, [](double f) { return XY(0, f); });
    add_side(right, [](double f) { return XY(1, f); });
    const auto triangles = Region_triangulation<Traits>::run(region);
    if (!triangles)
      fail(Status_code::cut_failed, Stage::decomposition_sets, "a cut folds onto itself", {},
           coordinates(bottom.front()));
    for (const Triangle& t : *triangles) add_triangle(t);
  }

  std::array<double, 3> coordinates(std::uint32_t v) const {
    return Part<Traits>::coordinates(surface_.points[v]);
  }

  std::vector<double> fractions(const std::vector<std::uint32_t>& side) const {
    std::vector<double> f(side.size(), 0);
    for (std::size_t k = 1; k < side.size(); ++k)
      f[k] = f[k - 1] + norm(coordinates(side[k]) - coordinates(side[k - 1]));
    const double whole = f.back();
    for (double& x : f) x = whole > 0 ? x / whole : 0;
    f.back() = 1;
    f.front() = 0;
    return f;
  }

  using Pair = std::pair<Patch_index, Patch_index>;
  static Pair targets(const Cell& cell) { return std::minmax(cell.row->left, cell.row->right); }

  // A connected range of layers.
  void join_cells_up() {
    std::map<std::tuple<Node_index, Node_index, Pair>, std::size_t> above;
    auto key = [&](Node_index m, Node_index n, const Cell& cell) {
      return std::tuple(std::min(m, n), std::max(m, n), targets(cell));
    };
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto& bottom = cells_[c].row->bottom;
      above[key(bottom[cells_[c].i], bottom[cells_[c].i + 1], cells_[c])] = c;
    }
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto& top = cells_[c].row->top;
      const auto found = above.find(key(top[cells_[c].i], top[cells_[c].i + 1], cells_[c]));
      if (found != above.end()) loop_edges_->join(c, found->second);
    }
  }

  // Along a LoopEdge: over columns that are no LoopVertices.
  void join_cells_along() {
    std::map<std::tuple<Node_index, Node_index, Pair>, std::size_t> first_at;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const Cut_row& row = *cells_[c].row;
      for (std::size_t i : {cells_[c].i, cells_[c].i + 1}) {
        if (loops_.node(row.bottom[i]).loop_vertex || loops_.node(row.top[i]).loop_vertex) continue;
        const auto [found, is_new] = first_at.try_emplace({row.bottom[i], row.top[i], targets(cells_[c])}, c);
        if (!is_new) loop_edges_->join(c, found->second);
      }
    }
  }

  void number_sets() {
    std::vector<std::size_t> roots;
    for (std::size_t c = 0; c < cells_.size(); ++c)
      if (loop_edges_->root(c) == c) roots.push_back(c);
    std::stable_sort(roots.begin(), roots.end(),
                     [&](std::size_t c, std::size_t d) { return targets(cells_[c]) < targets(cells_[d]); });
    std::map<std::size_t, std::size_t> number;
    for (std::size_t r : roots) number.emplace(r, number.size());
    result_.number_of_sets = number.size();
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const std::size_t end = c + 1 < cells_.size() ? cells_[c + 1].first_triangle : result_.triangles.size();
      result_.set.resize(end, number.at(loop_edges_->root(c)));
    }
  }

  // Where the imprint has drawn two neighbours of a cut onto one line, the cut runs there and back: between its two
  // sheets is nothing, and they cancel.
  void cancel_folds() {
    std::map<std::pair<Triangle, Pair>, std::size_t> seen;
    std::vector<bool> stays(result_.triangles.size(), true);
    for (std::size_t t = 0; t < stays.size(); ++t) {
      const bool is_ordered = result_.left[t] < result_.right[t];
      const Pair pair = std::minmax(result_.left[t], result_.right[t]);
      const Triangle front = turned_to(result_.triangles[t], is_ordered);
      const Triangle back = turned_to(result_.triangles[t], !is_ordered);
      const auto other = seen.find({back, pair});
      if (other == seen.end()) {
        seen.emplace(std::pair(front, pair), t);
      } else {
        stays[t] = stays[other->second] = false;
        seen.erase(other);
      }
    }
    keep(stays);
  }

  // Where a cut runs on the part's surface, the target outside it has nothing there: the surface bounds the one inside.
  void leave_surface() {
    std::vector<bool> is_cut(surface_.points.size(), false);
    std::map<Triangle, std::pair<std::size_t, Patch_index>> faces;  // both of each triangle, by the target behind
    for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
      const Triangle& v = result_.triangles[t];
      faces.emplace(turned_to(v, true), std::pair(t, result_.left[t]));
      faces.emplace(turned_to(v, false), std::pair(t, result_.right[t]));
      for (std::uint32_t corner : v) is_cut[corner] = true;
    }
    std::vector<bool> stays(result_.triangles.size(), true);
    for (std::size_t s = 0; s < surface_.triangles.size(); ++s) {
      const Triangle& v = surface_.triangles[s];
      if (!is_cut[v[0]] || !is_cut[v[1]] || !is_cut[v[2]]) continue;
      const auto found = faces.find(turned_to(v, true));
      if (found == faces.end()) continue;
      stays[found->second.first] = false;
      result_.on_surface.emplace_back(s, found->second.second);
    }
    keep(stays);
  }

  void number_sets_without_gaps() {
    std::map<std::size_t, std::size_t> number;
    for (std::size_t set : result_.set) number.emplace(set, 0);
    result_.number_of_sets = 0;
    for (auto& [set, n] : number) n = result_.number_of_sets++;
    for (std::size_t& set : result_.set) set = number.at(set);
  }

  // From the lowest vertex on, as it is or the other way round.
  static Triangle turned_to(Triangle v, bool as_it_is) {
    if (!as_it_is) std::swap(v[1], v[2]);
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    return v;
  }

  void keep(const std::vector<bool>& stays) {
    keep(stays, result_.triangles);
    keep(stays, result_.left);
    keep(stays, result_.right);
    keep(stays, result_.set);
  }

  template <class T>
  static void keep(const std::vector<bool>& stays, std::vector<T>& values) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (stays[i]) values[n++] = values[i];
    values.resize(n);
  }

  const Layered_loops<Traits>& loops_;
  const std::vector<Cut_row>& rows_;
  const Cut_surface<Traits>& surface_;
  std::vector<Cell> cells_;
  std::optional<Union_find> loop_edges_;  // of the cells of one decomposition set
  Cut_triangles result_;
};

}  // namespace CCSweep::internal

#endif
