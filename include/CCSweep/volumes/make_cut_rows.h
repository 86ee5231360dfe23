// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_VOLUMES_MAKE_CUT_ROWS_H
#define CCSWEEP_VOLUMES_MAKE_CUT_ROWS_H

#include <CCSweep/Status.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Layering.h>
#include <CCSweep/loops/Layered_loops.h>
#include <CCSweep/part/Part.h>
#include <CCSweep/part/Surface_location.h>
#include <CCSweep/volumes/Cut_rows.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CCSweep {
namespace internal {

template <class Traits>
class Row_builder {
  using Loops = Layered_loops<Traits>;
  using Segment = typename Loops::Segment;
  using Cut = typename Loops::Cut;

 public:
  Row_builder(const Part<Traits>& part, const Layering& layering, Loops& loops)
      : part_(part), layering_(layering), loops_(loops) {}

  std::vector<Cut_row> run() {
    std::vector<Cut_row> rows;
    for (std::size_t k = loops_.segments.size() - 1; k-- > 0;) {
      std::map<Ends, std::vector<Node_index>> nodes_here;
      for (const Cut& cut : loops_.cuts[k]) {
        rows.push_back(make_row(Layer_index(k), cut));
        const auto& nodes = rows.back().bottom;
        nodes_here.emplace(std::minmax(nodes.front(), nodes.back()), nodes);
      }
      nodes_above_ = std::move(nodes_here);
    }
    std::reverse(rows.begin(), rows.end());
    straighten_columns(rows);
    return rows;
  }

 private:
  using Ends = std::pair<Node_index, Node_index>;

  Cut_row make_row(Layer_index layer, const Cut& cut) {
    const Segment& segment = loops_.segments[layer.value()][cut.bottom];
    Cut_row row{layer, {}, nodes_along(cut.top), segment.left.target, segment.right.target, {}};
    if (row.top.size() == 1) row.top.push_back(row.top.front());
    const std::vector<double> fraction = fractions(row.top);
    row.bottom = copy_down(row.top, fraction, segment.a, segment.b);
    const Vec3& up = loops_.up[layer.value() + 1];
    for (std::size_t i = 0; i < row.top.size(); ++i) {
      const Vec3 projected = cut.projected[0] + fraction[i] * (cut.projected[1] - cut.projected[0]);
      row.lift.push_back(dot(up, coordinates(row.top[i]) - projected));
    }
    return row;
  }

  // The chain with the nodes that came down from above.
  std::vector<Node_index> nodes_along(const std::vector<Node_index>& chain) const {
    std::vector<Node_index> nodes{chain.front()};
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const auto found = nodes_above_.find(std::minmax(chain[i], chain[i + 1]));
      if (found == nodes_above_.end()) {
        nodes.push_back(chain[i + 1]);
        continue;
      }
      std::vector<Node_index> piece = found->second;
      if (piece.front() != chain[i]) std::reverse(piece.begin(), piece.end());
      nodes.insert(nodes.end(), piece.begin() + 1, piece.end());
    }
    return nodes;
  }

  std::vector<double> fractions(const std::vector<Node_index>& nodes) const {
    std::vector<double> f(nodes.size(), 0);
    for (std::size_t i = 1; i < nodes.size(); ++i)
      f[i] = f[i - 1] + norm(coordinates(nodes[i]) - coordinates(nodes[i - 1]));
    const double whole = f.back();
    for (double& x : f) x = whole > 0 ? x / whole : 0;
    f.back() = 1;
    return f;
  }

  // One node below each node of the upper row, at the same fraction of the lower segment.
  std::vector<Node_index> copy_down(const std::vector<Node_index>& top, const std::vector<double>& fraction,
                                    Node_index a, Node_index b) {
    std::vector<Node_index> bottom{a};
    for (std::size_t i = 1; i + 1 < top.size(); ++i) bottom.push_back(add_node(a, b, fraction[i]));
    bottom.push_back(b);
    for (std::size_t i = 0; i < top.size(); ++i)
      loops_.nodes[bottom[i].value()].loop_vertex |= loops_.node(top[i]).loop_vertex;
    return bottom;
  }

  Node_index add_node(Node_index a, Node_index b, double fraction) {
    const auto p = loops_.node(a), q = loops_.node(b);
    typename Loops::Node node{point_between(p.point, q.point, fraction), Surface_location(), false};
    const auto e = common_edge(part_, p.where, q.where);
    if (e.is_valid()) {
      const double s = fraction_on_edge(part_, e, p.where), t = fraction_on_edge(part_, e, q.where);
      node.where = Surface_location::edge(e, s + fraction * (t - s));
      node.point = point_on_edge(part_, e, node.where.t);
    }
    loops_.nodes.push_back(node);
    return Node_index(loops_.nodes.size() - 1);
  }

  // The projection knows only the layers below. Where a column ends on a source, the difference to where it was
  // projected to is shared out over its inner nodes, so that they stay between the caps however these bend.
  void straighten_columns(const std::vector<Cut_row>& rows) {
    struct Link {
      Node_index above;
      std::size_t layer;
      double lift;
    };
    std::map<Node_index, Link> links;
    for (const Cut_row& row : rows)
      for (std::size_t i = 0; i < row.top.size(); ++i)
        links.emplace(row.bottom[i], Link{row.top[i], row.layer.value(), row.lift[i]});
    for (const auto& [start, link] : links) {
      if (!loops_.node(start).where.on_surface()) continue;
      std::vector<const Link*> column{&link};
      while (!loops_.node(column.back()->above).where.on_surface()) {
        const auto next = links.find(column.back()->above);
        if (next == links.end()) break;
        column.push_back(&next->second);
      }
      const double low = layering_.layers[link.layer], high = layering_.layers[column.back()->layer + 1];
      for (std::size_t i = 0; i + 1 < column.size(); ++i) {
        const std::size_t layer = column[i]->layer + 1;
        raise(column[i]->above, column.back()->lift * (layering_.layers[layer] - low) / (high - low), loops_.up[layer]);
      }
    }
  }

  void raise(Node_index n, double height, const Vec3& up) {
    using FT = typename Traits::FT;
    auto& point = loops_.nodes[n.value()].point;
    if (height != 0)
      point = point + typename Traits::Vector_3(FT(height * up[0]), FT(height * up[1]), FT(height * up[2]));
  }

  Vec3 coordinates(Node_index n) const { return Part<Traits>::coordinates(loops_.node(n).point); }

  const Part<Traits>& part_;
  const Layering& layering_;
  Loops& loops_;
  std::map<Ends, std::vector<Node_index>> nodes_above_;  // along the segments of the upper layer that cuts go up from
};

}  // namespace internal

/// Gathers the nodes of the cuts into structured columns (section 2.8): the new nodes of each imprint are copied down
/// their columns to the boundary of the target they started from (2.7, Fig. 12).
/// The nodes are added to `loops`. Complexity: O(n log n) in the nodes of the cuts, copies included.
template <class Traits>
Result<std::vector<Cut_row>> make_cut_rows(const Part<Traits>& part, const Layering& layering,
                                           Layered_loops<Traits>& loops) {
  return internal::guarded([&] { return internal::Row_builder<Traits>(part, layering, loops).run(); });
}

}  // namespace CCSweep

#endif
