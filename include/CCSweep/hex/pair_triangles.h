// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_PAIR_TRIANGLES_H
#define CCSWEEP_HEX_PAIR_TRIANGLES_H

#include <CCSweep/hex/Cap_triangulation.h>
#include <CCSweep/hex/quad_quality.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// Two triangles with a common side, and the quad they make.
struct Triangle_pair {
  double quality;
  std::size_t first, second;
  std::array<std::uint32_t, 4> quad;
};

/// The least sine of a quad's angles, seen along the outline where a side lies on it.
inline double quality_of_pair(const Cap_triangulation& mesh, const std::array<std::uint32_t, 4>& quad) {
  const auto& p = mesh.points;
  double worst = quad_scaled_jacobian(p[quad[0]], p[quad[1]], p[quad[2]], p[quad[3]]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Point2 &here = p[quad[i]], &after = mesh.towards(quad[i], quad[(i + 1) % 4]),
                 &before = mesh.towards(quad[i], quad[(i + 3) % 4]);
    worst = std::min(worst, turn(here, after, before) / (length_between(here, after) * length_between(here, before)));
  }
  return worst;
}

/// All pairs that make a quad of more than a quality, the best first; none with a flat corner on the outline, which no
/// smoothing opens.
inline std::vector<Triangle_pair> pairs_of_triangles(const Cap_triangulation& mesh, double least) {
  constexpr double flat = 0.2;
  struct Side {
    std::uint64_t ends;  // first and second node
    std::uint32_t triangle, corner;
    bool operator<(const Side& other) const { return ends < other.ends; }
  };
  const auto key = [](std::uint64_t a, std::uint64_t b) { return a << 32 | b; };
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i)
      sides.push_back({key(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]), t, i});
  std::sort(sides.begin(), sides.end());
  const auto find = [&](std::uint32_t a, std::uint32_t b) -> const Side* {
    const auto found = std::lower_bound(sides.begin(), sides.end(), Side{key(a, b), 0, 0});
    return found == sides.end() || found->ends != key(a, b) ? nullptr : &*found;
  };
  const auto on_outline = [&](std::uint32_t a, std::uint32_t b) { return find(b, a) == nullptr; };
  const auto has_flat_corner = [&](const std::array<std::uint32_t, 4>& q) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (q[i] >= mesh.number_on_loops) continue;
      const std::uint32_t before = q[(i + 3) % 4], after = q[(i + 1) % 4];
      const Point2 &here = mesh.points[q[i]], &a = mesh.towards(q[i], after), &b = mesh.towards(q[i], before);
      if (on_outline(before, q[i]) && on_outline(q[i], after) &&
          turn(here, a, b) < flat * length_between(here, a) * length_between(here, b))
        return true;
    }
    return false;
  };
  std::vector<Triangle_pair> pairs;
  for (const Side& here : sides) {
    const auto a = static_cast<std::uint32_t>(here.ends >> 32), b = static_cast<std::uint32_t>(here.ends);
    const Side* there = a < b ? find(b, a) : nullptr;
    if (there == nullptr) continue;
    const std::uint32_t tip = mesh.triangles[here.triangle][(here.corner + 2) % 3];
    const std::uint32_t foot = mesh.triangles[there->triangle][(there->corner + 2) % 3];
    const std::array<std::uint32_t, 4> quad{a, foot, b, tip};
    if (const double quality = quality_of_pair(mesh, quad); quality > least && !has_flat_corner(quad))
      pairs.push_back({quality, here.triangle, there->triangle, quad});
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Triangle_pair& a, const Triangle_pair& b) { return a.quality > b.quality; });
  return pairs;
}

using Pair_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;
using Mates = std::vector<boost::graph_traits<Pair_graph>::vertex_descriptor>;

using Mate_map = Mates::pointer;
inline const auto no_mate = boost::graph_traits<Pair_graph>::null_vertex();

/// The matching that takes the best pair first, and so on. The graph's edges come in that order.
inline void match_best_first(const Pair_graph& graph, Mate_map mates) {
  for (auto e : boost::make_iterator_range(edges(graph)))
    if (const auto a = source(e, graph), b = target(e, graph); mates[a] == no_mate && mates[b] == no_mate) {
      mates[a] = b;
      mates[b] = a;
    }
}

/// The same, but a triangle with one partner left takes that at once (Karp and Sipser, 1981): hardly any is left over.
class Forced_first_matching {
 public:
  Forced_first_matching(const Pair_graph& graph, Mate_map mates) : graph_(graph), mates_(mates) {
    for (auto v : boost::make_iterator_range(vertices(graph))) {
      partners_.push_back(out_degree(v, graph));
      if (partners_.back() == 1) forced_.push_back(v);
    }
  }

  void run() {
    match_forced();
    for (auto e : boost::make_iterator_range(edges(graph_)))
      if (const auto a = source(e, graph_), b = target(e, graph_); is_free(a) && is_free(b)) {
        match(a, b);
        match_forced();
      }
  }

 private:
  using Vertex = boost::graph_traits<Pair_graph>::vertex_descriptor;

  bool is_free(Vertex v) const { return mates_[v] == no_mate; }

  void match_forced() {
    while (!forced_.empty()) {
      const Vertex v = forced_.back();
      forced_.pop_back();
      if (!is_free(v)) continue;
      const auto around = adjacent_vertices(v, graph_);
      const auto partner = std::find_if(around.first, around.second, [&](Vertex w) { return is_free(w); });
      if (partner != around.second) match(v, *partner);
    }
  }

  void match(Vertex a, Vertex b) {
    mates_[a] = b;
    mates_[b] = a;
    for (Vertex v : {a, b})
      for (Vertex w : boost::make_iterator_range(adjacent_vertices(v, graph_)))
        if (is_free(w) && --partners_[w] == 1) forced_.push_back(w);
  }

  const Pair_graph& graph_;
  Mate_map mates_;
  std::vector<std::size_t> partners_;  // by vertex: the neighbours that are free
  std::vector<Vertex> forced_;
};

/// What Edmonds' algorithm starts from.
template <class Graph, class MateMap>
struct Forced_first_start {
  static void find_matching(const Graph& graph, MateMap mates) { Forced_first_matching(graph, mates).run(); }
};

/// Chooses pairs so that no triangle is in two of them: the best first, and if so wanted, Edmonds' algorithm makes
/// them as many as there can be. That search costs O(n) for each pair which is missing at its start, so it gets one
/// with hardly any missing. (The weighted matching of Boost 1.74 does not come to an end on some graphs.)
/// \return the pairs chosen, by their place in `pairs`
inline std::vector<std::size_t> choose_pairs(const std::vector<Triangle_pair>& pairs, std::size_t triangles,
                                             bool as_many_as_can_be) {
  Pair_graph graph(triangles);
  for (const Triangle_pair& pair : pairs) add_edge(pair.first, pair.second, graph);
  Mates mates(triangles, no_mate);
  if (as_many_as_can_be) {
    const auto index = get(boost::vertex_index, graph);
    boost::matching<Pair_graph, Mate_map, decltype(index), boost::edmonds_augmenting_path_finder, Forced_first_start,
                    boost::no_matching_verifier>(graph, mates.data(), index);
  } else {
    match_best_first(graph, mates.data());
  }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (mates[pairs[i].first] == pairs[i].second && mates[pairs[i].second] == pairs[i].first) chosen.push_back(i);
  return chosen;
}

/// The triangles that are in none of the pairs chosen.
inline std::vector<std::size_t> left_over(const std::vector<Triangle_pair>& pairs,
                                          const std::vector<std::size_t>& chosen, std::size_t triangles) {
  std::vector<bool> used(triangles, false);
  for (std::size_t i : chosen) used[pairs[i].first] = used[pairs[i].second] = true;
  std::vector<std::size_t> left;
  for (std::size_t t = 0; t < triangles; ++t)
    if (!used[t]) left.push_back(t);
  return left;
}

/// Of each of some triangles the neighbour that it makes the best quad with, or itself if there is none. What is left
/// over shares its few neighbours with others; where one of them is split in three, there are more.
inline std::vector<std::size_t> partners_of(const std::vector<std::size_t>& triangles,
                                            const std::vector<Triangle_pair>& pairs) {
  std::set<std::size_t> partners;
  for (std::size_t t : triangles) {
    const auto best = std::find_if(pairs.begin(), pairs.end(),
                                   [&](const Triangle_pair& pair) { return pair.first == t || pair.second == t; });
    partners.insert(best == pairs.end() ? t : best->first == t ? best->second : best->first);
  }
  return {partners.begin(), partners.end()};
}

}  // namespace CCSweep::internal

#endif
