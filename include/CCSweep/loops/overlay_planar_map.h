// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_PLANAR_MAP_H
#define CCSWEEP_LOOPS_OVERLAY_PLANAR_MAP_H

#include <CCSweep/loops/overlay_crossing.h>
#include <CCSweep/loops/overlay_edges.h>
#include <CCSweep/loops/overlay_labels.h>
#include <CCSweep/loops/overlay_nodes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <span>
#include <vector>

namespace CCSweep::internal {

// The subdivision of the plane by edges that meet in common end nodes only. Halfedge 2e runs from a to b of edge e, so
// it ascends by xy; 2e + 1 runs back. Face 0 is the unbounded one. Linear, for a bounded number of edges at a node;
// with several components the edges above and below their lowest nodes are sorted.
template <class Traits>
class Planar_map {
 public:
  using Number = std::uint32_t;  // of a halfedge, an edge, a cycle or a face
  static constexpr Number none = std::numeric_limits<Number>::max();

  Planar_map(const Layer_nodes<Traits>& nodes, const Overlay_edges& edges)
      : nodes_(nodes), all_(edges), edges_(edges.edges) {
    sort_around_nodes();
    link();
    find_cycles();
    find_components();
    find_faces();
  }

  Number number_of_halfedges() const { return static_cast<Number>(2 * edges_.size()); }
  Number number_of_faces() const { return static_cast<Number>(faces_.size()); }
  // The ends of edges have numbers of their own.
  std::size_t number_of_ends() const { return all_.ends.size(); }
  Node_index node(Number end) const { return all_.ends[end]; }
  Number source(Number h) const { return h % 2 == 0 ? edges_[h / 2].a : edges_[h / 2].b; }
  Number target(Number h) const { return source(h ^ 1); }
  // The nodes of an edge, from its lower end to its upper one.
  std::span<const Node_index> path(Number edge) const { return all_.path(edge); }
  std::size_t number_of_path_nodes() const { return all_.nodes.size(); }
  Number next(Number h) const { return next_[h]; }
  Number face(Number h) const { return cycles_[cycle_[h]].face; }
  Sides sides(Number h, int set) const {
    const Sides& sides = edges_[h / 2].sides[set];
    return h % 2 == 0 ? sides : Sides{sides.right, sides.left};
  }
  // Calls f with one halfedge of each cycle around a face: first the outer one, except on the unbounded face.
  template <class Function>
  void for_each_cycle(Number face, const Function& f) const {
    for (Number c = faces_[face].first; c != none; c = cycles_[c].next) f(cycles_[c].start);
  }
  // The number of edges at an end.
  std::size_t degree(Number end) const { return first_[end + 1] - first_[end]; }

 private:
  struct Cycle {
    Number start;
    Number face = none;
    Number next = none;  // another one around the same face
  };
  struct Face {
    Number first = none, last = none;  // of its cycles
  };

  void add_to_face(Number cycle, Number face) {
    cycles_[cycle].face = face;
    (faces_[face].first == none ? faces_[face].first : cycles_[faces_[face].last].next) = cycle;
    faces_[face].last = cycle;
  }

  // Counterclockwise from the direction straight down, that one excluded: first those that ascend by xy.
  void sort_around_nodes() {
    first_.assign(number_of_ends() + 1, 0);
    for (Number h = 0; h < number_of_halfedges(); ++h) ++first_[source(h) + 1];
    for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
    out_.resize(number_of_halfedges());
    std::vector<Number> place(first_.begin(), first_.end() - 1);
    for (Number h = 0; h < number_of_halfedges(); h += 2) out_[place[source(h)]++] = h;
    const std::vector<Number> middle = place;
    for (Number h = 1; h < number_of_halfedges(); h += 2) out_[place[source(h)]++] = h;
    for (Number n = 0; n < number_of_ends(); ++n) {
      sort_half(first_[n], middle[n]);
      sort_half(middle[n], first_[n + 1]);
    }
  }

  // For halfedges that leave an end, and all ascend or all descend.
  void sort_half(Number first, Number last) {
    if (last - first <= 1) return;
    std::sort(out_.begin() + first, out_.begin() + last, [this](Number g, Number h) {
      return turn<Traits>(point(node(source(g))), point(second(g)), point(second(h))) == CGAL::LEFT_TURN;
    });
  }

  // Left turns (section 2.7, step 6): the next halfedge makes the smallest interior angle, so it is the first one
  // clockwise from where this one came.
  void link() {
    next_.resize(number_of_halfedges());
    for (Number n = 0; n < number_of_ends(); ++n) {
      for (Number i = first_[n]; i < first_[n + 1]; ++i) {
        next_[out_[i] ^ 1] = out_[i == first_[n] ? first_[n + 1] - 1 : i - 1];
      }
    }
  }

  void find_cycles() {
    cycle_.assign(number_of_halfedges(), none);
    for (Number start = 0; start < cycle_.size(); ++start) {
      if (cycle_[start] != none) continue;
      for (Number h = start; cycle_[h] == none; h = next_[h]) cycle_[h] = static_cast<Number>(cycles_.size());
      cycles_.push_back({start});
    }
  }

  // The lowest end of each connected component, ascending.
  void find_components() {
    std::vector<char> seen(number_of_ends(), false);
    std::vector<Number> stack;
    for (Number start = 0; start < number_of_ends(); ++start) {
      if (seen[start] || degree(start) == 0) continue;
      Number lowest = start;
      seen[start] = true;
      stack.push_back(lowest);
      while (!stack.empty()) {
        const Number n = stack.back();
        stack.pop_back();
        if (is_less(n, lowest)) lowest = n;
        for (Number i = first_[n]; i < first_[n + 1]; ++i) {
          const Number m = target(out_[i]);
          if (!seen[m]) stack.push_back(m);
          seen[m] = true;
        }
      }
      lowest_.push_back(lowest);
    }
    std::sort(lowest_.begin(), lowest_.end(), [this](Number n, Number m) { return is_less(n, m); });
  }

  // At the lowest node of a component everything ascends, so the wedge left of the last halfedge opens to the
  // outside: its cycle goes around the component. All other cycles are outer ones of a face of their own.
  Number cycle_around(Number lowest) const { return cycle_[out_[first_[lowest + 1] - 1]]; }

  void find_faces() {
    for (Number n : lowest_) cycles_[cycle_around(n)].face = 0;
    faces_.reserve(cycles_.size() + 1);
    faces_.emplace_back();
    for (Number c = 0; c < cycles_.size(); ++c) {
      if (cycles_[c].face == 0) continue;
      faces_.emplace_back();
      add_to_face(c, number_of_faces() - 1);
    }
    nest();
  }

  // Orders edges, and nodes that lie on none of them, from below.
  struct Below {
    using is_transparent = void;
    const Planar_map* map;

    bool operator()(Number e, Number f) const {
      if (e == f) return false;
      const Planar_map& m = *map;
      const Number a = m.edges_[e].a, b = m.edges_[f].a;
      if (a == b) {
        return turn<Traits>(m.point(m.node(a)), m.point(m.second(2 * e)), m.point(m.second(2 * f))) == CGAL::LEFT_TURN;
      }
      if (m.is_less(a, b)) return m.turns(e, m.node(b)) == CGAL::LEFT_TURN;
      return m.turns(f, m.node(a)) == CGAL::RIGHT_TURN;
    }
    bool operator()(Number e, Node_index n) const { return map->turns(e, n) == CGAL::LEFT_TURN; }
    bool operator()(Node_index n, Number e) const { return map->turns(e, n) == CGAL::RIGHT_TURN; }
  };

  static bool ascends(Number h) { return h % 2 == 0; }
  const typename Traits::Point_2& point(Node_index n) const { return nodes_.point(n); }
  bool is_less(Node_index n, Node_index m) const { return is_less_xy<Traits>(point(n), point(m)); }
  bool is_less(Number end, Number other) const { return is_less(node(end), node(other)); }
  // The node after the source of a halfedge.
  Node_index second(Number h) const {
    const std::span<const Node_index> nodes = path(h / 2);
    return ascends(h) ? nodes[1] : nodes[nodes.size() - 2];
  }

  // On which side of an edge a node is that is between its ends by xy.
  CGAL::Orientation turns(Number edge, Node_index n) const {
    const std::span<const Node_index> nodes = path(edge);
    const auto upper =
        std::partition_point(nodes.begin() + 1, nodes.end() - 1, [&](Node_index m) { return is_less(m, n); });
    return turn<Traits>(point(*std::prev(upper)), point(*upper), point(n));
  }

  // The edges that pass above or below the lowest end of a component.
  std::vector<Number> edges_around_lowest() const {
    std::vector<Number> result;
    const auto less = [this](Number n, Number m) { return is_less(n, m); };
    for (Number e = 0; e < edges_.size(); ++e) {
      const auto next = std::upper_bound(lowest_.begin(), lowest_.end(), edges_[e].a, less);
      if (next != lowest_.end() && is_less(*next, edges_[e].b)) result.push_back(e);
    }
    return result;
  }

  // Step 8: a sweep by xy finds for each component the edge below its lowest node, and so the face it lies in.
  void nest() {
    if (lowest_.size() == 1) add_to_face(cycle_around(lowest_.front()), 0);
    if (lowest_.size() <= 1) return;
    std::vector<Number> starts = edges_around_lowest(), ends = starts;
    std::sort(starts.begin(), starts.end(), [&](auto e, auto f) { return is_less(edges_[e].a, edges_[f].a); });
    std::sort(ends.begin(), ends.end(), [&](auto e, auto f) { return is_less(edges_[e].b, edges_[f].b); });
    using Status_line = std::set<Number, Below>;
    Status_line line(Below{this});
    std::vector<typename Status_line::iterator> places(edges_.size(), line.end());
    auto start = starts.begin(), end = ends.begin();
    const auto start_before = [&](Number n) {
      for (; start != starts.end() && is_less(edges_[*start].a, n); ++start) places[*start] = line.insert(*start).first;
    };
    for (Number n : lowest_) {
      for (; end != ends.end() && !is_less(n, edges_[*end].b); ++end) {
        start_before(edges_[*end].b);
        line.erase(places[*end]);
      }
      start_before(n);
      const auto above = line.lower_bound(node(n));
      add_to_face(cycle_around(n), above == line.begin() ? 0 : face(2 * *std::prev(above)));
    }
  }

  const Layer_nodes<Traits>& nodes_;
  const Overlay_edges& all_;
  const std::vector<Overlay_edge>& edges_;
  std::vector<Number> first_, out_;  // the halfedges that leave each end
  std::vector<Number> next_, cycle_;
  std::vector<Cycle> cycles_;
  std::vector<Number> lowest_;
  std::vector<Face> faces_;
};

}  // namespace CCSweep::internal

#endif
