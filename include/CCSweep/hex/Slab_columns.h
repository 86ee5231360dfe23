// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_HEX_SLAB_COLUMNS_H
#define CCSWEEP_HEX_SLAB_COLUMNS_H

#include <CCSweep/Status.h>
#include <CCSweep/hex/Layer_stack.h>
#include <CCSweep/internal/guarded.h>
#include <CCSweep/linking/Column_map.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CCSweep::internal {

/// A place on a segment of a layer: a fraction of the way from its node a to its node b.
struct Segment_place {
  std::uint32_t segment = 0;
  double fraction = 0;
};

/// A place on the neighbouring layer that lies in the same column.
struct Column_place {
  Segment_place place;
  bool is_reversed = false;  ///< the segments at the two ends of the column run in opposite senses
  Patch_index wall = {};     ///< the linking patch between them; invalid for a cut
  bool is_left = false;      ///< of a wall: its material is on the left of the segment asked for
};

/// The segments of one layer by their nodes.
class Segment_finder {
 public:
  explicit Segment_finder(const std::vector<Layer_stack::Segment>& segments) : segments_(segments) {
    for (std::size_t s = 0; s < segments.size(); ++s)
      number_.emplace(key(segments[s].a, segments[s].b), static_cast<std::uint32_t>(s));
  }
  /// The segment between two nodes, and whether it runs from m to n.
  std::pair<std::uint32_t, bool> operator()(Layer_stack::Node m, Layer_stack::Node n) const {
    const auto found = number_.find(key(m, n));
    if (found == number_.end())
      fail(Status_code::inconsistent_levels, Stage::hex_mesh, "a wall has lost its row on a layer");
    return {found->second, segments_[found->second].a == m};
  }

 private:
  static std::uint64_t key(std::uint64_t m, std::uint64_t n) { return m < n ? m << 32 | n : n << 32 | m; }
  const std::vector<Layer_stack::Segment>& segments_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
};

/// Which places of two neighbouring layers lie in one column: up the walls by the rings' maps, up the cuts by their
/// nodes. Complexity: O(log n) for each place.
class Slab_columns {
 public:
  Slab_columns(const Layer_stack& stack, std::size_t lower)
      : stack_(stack), low_(stack.layers[lower]), high_(stack.layers[lower + 1]) {
    const Segment_finder find_low(low_.segments), find_high(high_.segments);
    low_uses_.resize(low_.segments.size());
    high_uses_.resize(high_.segments.size());
    for (std::size_t r = 0; r < low_.rings.size(); ++r) {
      const auto& ring = low_.rings[r];
      ring_segments_.push_back({loop_uses(ring.bottom, find_low, r, low_uses_),
                                loop_uses(ring.top, find_high, r, high_uses_)});
      maps_.emplace_back(points(ring.bottom), points(ring.top), ring.rails, low_.up);
    }
    for (std::size_t c = 0; c < low_.cuts.size(); ++c) add_cut(c, find_high);
  }

  std::vector<Column_place> above(const Segment_place& p) const {
    std::vector<Column_place> result;
    for (const Use& use : low_uses_[p.segment]) {
      if (use.is_cut) {
        if (auto place = up_cut(use.number, p.fraction)) result.push_back(*place);
      } else {
        const Loop_place from{use.index, use.forward ? p.fraction : 1 - p.fraction};
        const Loop_place to = maps_[use.number].above(from);
        result.push_back(on_ring(use, ring_segments_[use.number].top, to, use.index));
      }
    }
    return result;
  }

  std::vector<Column_place> below(const Segment_place& p) const {
    std::vector<Column_place> result;
    for (const Use& use : high_uses_[p.segment]) {
      if (use.is_cut) {
        result.push_back(down_cut(use, p.fraction));
      } else {
        const Loop_place from{use.index, use.forward ? p.fraction : 1 - p.fraction};
        const Loop_place to = maps_[use.number].below(from);
        result.push_back(on_ring(use, ring_segments_[use.number].bottom, to, to.index));
      }
    }
    return result;
  }

 private:
  struct Use {
    bool is_cut;
    std::uint32_t number;   // of the ring or the cut
    std::uint32_t index;    // of the piece
    bool forward;           // the segment runs along the piece
  };
  struct Piece {
    std::uint32_t segment;
    bool forward;
  };
  struct Ring_segments {
    std::vector<Piece> bottom, top;
  };

  std::vector<Vec3> points(const std::vector<Layer_stack::Node>& nodes) const {
    std::vector<Vec3> result;
    for (auto n : nodes) result.push_back(stack_.points[n]);
    return result;
  }

  static std::vector<Piece> loop_uses(const std::vector<Layer_stack::Node>& loop, const Segment_finder& find,
                                      std::size_t ring, std::vector<std::vector<Use>>& uses) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto [s, forward] = find(loop[i], loop[(i + 1) % loop.size()]);
      pieces.push_back({s, forward});
      uses[s].push_back({false, static_cast<std::uint32_t>(ring), static_cast<std::uint32_t>(i), forward});
    }
    return pieces;
  }

  Column_place on_ring(const Use& use, const std::vector<Piece>& pieces, const Loop_place& to,
                       std::size_t bottom_piece) const {
    const Piece& piece = pieces[to.index];
    return {{piece.segment, piece.forward ? to.fraction : 1 - to.fraction},
            piece.forward != use.forward,
            low_.rings[use.number].patch[bottom_piece],
            use.forward};
  }

  // Along a cut's upper border the fraction of its lower segment is shared out by length.
  struct Chain {
    std::vector<double> fraction;  // at each node
    std::vector<Piece> pieces;
  };

  void add_cut(std::size_t c, const Segment_finder& find) {
    const auto& cut = low_.cuts[c];
    Chain chain{{0}, {}};
    for (std::size_t i = 0; i + 1 < cut.top.size(); ++i) {
      const auto [s, forward] = find(cut.top[i], cut.top[i + 1]);
      chain.pieces.push_back({s, forward});
      chain.fraction.push_back(chain.fraction.back() +
                               norm(stack_.points[cut.top[i + 1]] - stack_.points[cut.top[i]]));
      high_uses_[s].push_back({true, static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(i), forward});
    }
    for (double& f : chain.fraction) f /= std::max(chain.fraction.back(), 1e-300);
    if (!chain.pieces.empty()) chain.fraction.back() = 1;
    chains_.push_back(std::move(chain));
    low_uses_[cut.bottom].push_back({true, static_cast<std::uint32_t>(c), 0, true});
  }

  std::optional<Column_place> up_cut(std::size_t c, double f) const {
    const Chain& chain = chains_[c];
    if (chain.pieces.empty()) return std::nullopt;
    const auto next = std::upper_bound(chain.fraction.begin() + 1, chain.fraction.end() - 1, f);
    const std::size_t i = next - chain.fraction.begin() - 1;
    const double g = std::clamp((f - chain.fraction[i]) / (chain.fraction[i + 1] - chain.fraction[i]), 0.0, 1.0);
    const Piece& piece = chain.pieces[i];
    return Column_place{{piece.segment, piece.forward ? g : 1 - g}, !piece.forward};
  }

  Column_place down_cut(const Use& use, double f) const {
    const Chain& chain = chains_[use.number];
    const double g = use.forward ? f : 1 - f;
    return {{low_.cuts[use.number].bottom,
             chain.fraction[use.index] + g * (chain.fraction[use.index + 1] - chain.fraction[use.index])},
            !use.forward};
  }

  const Layer_stack& stack_;
  const Layer_stack::Layer &low_, &high_;
  std::vector<std::vector<Use>> low_uses_, high_uses_;  // by segment
  std::vector<Ring_segments> ring_segments_;
  std::vector<Column_map> maps_;
  std::vector<Chain> chains_;
};

}  // namespace CCSweep::internal

#endif
