// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_LOOPS_OVERLAY_FACE_LABELS_H
#define CCSWEEP_LOOPS_OVERLAY_FACE_LABELS_H

#include <CCSweep/Layer_drawing.h>
#include <CCSweep/loops/overlay_labels.h>
#include <CCSweep/loops/overlay_nodes.h>
#include <CCSweep/loops/overlay_planar_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CCSweep::internal {

// The label of each face. What an edge says of a set holds on its two sides; what it does not speak of carries over
// from one side to the other; nothing is outside. Linear.
template <class Traits>
class Face_labels {
 public:
  static std::vector<Loop_label> of(const Planar_map<Traits>& map, const Layer_nodes<Traits>& nodes) {
    Face_labels labels(map, nodes);
    for (const int set : {0, 1}) {
      labels.states_.assign(map.number_of_faces(), State::unknown);
      labels.states_[0] = State::known;
      labels.hear(set);
      labels.carry_over(set);
      labels.check(set);
    }
    return std::move(labels.labels_);
  }

 private:
  using Number = std::uint32_t;  // of a face or a halfedge
  enum class State : char { unknown, visited, known };

  Face_labels(const Planar_map<Traits>& map, const Layer_nodes<Traits>& nodes)
      : map_(map), nodes_(nodes), labels_(map.number_of_faces()) {}

  int& label(Number face, int set) { return set == 0 ? labels_[face].source : labels_[face].target; }

  // Most faces learn their label from an edge of their own.
  void hear(int set) {
    for (Number h = 0; h < map_.number_of_halfedges(); h += 2) {
      const Sides sides = map_.sides(h, set);
      if (sides.left == sides.right) continue;
      hear(h, set, sides.left);
      hear(h + 1, set, sides.right);
    }
  }

  void hear(Number h, int set, int said) {
    const Number face = map_.face(h);
    if (states_[face] == State::unknown) {
      states_[face] = State::known;
      label(face, set) = said;
    } else if (label(face, set) != said) {
      refuse(h, set, face == 0 ? Sides{} : contradiction(h, set));
    }
  }

  // What another edge around the same face says.
  Sides contradiction(Number h, int set) const {
    const Sides said = map_.sides(h, set);
    Sides result;
    for_each_halfedge(map_.face(h), [&](Number g) {
      const Sides sides = map_.sides(g, set);
      if (sides.left != sides.right && sides.left != said.left) result = sides;
    });
    return result;
  }

  // No edge around the other faces speaks: those that are connected share the label of any known face next to them.
  void carry_over(int set) {
    std::vector<Number> region;
    for (Number start = 0; start < states_.size(); ++start) {
      if (states_[start] != State::unknown) continue;
      region.assign(1, start);
      states_[start] = State::visited;
      int found = Loop_label::none;
      for (std::size_t i = 0; i < region.size(); ++i) {
        for_each_halfedge(region[i], [&](Number h) {
          const Number face = map_.face(h ^ 1);
          if (states_[face] == State::known) found = label(face, set);
          if (states_[face] != State::unknown) return;
          states_[face] = State::visited;
          region.push_back(face);
        });
      }
      for (const Number face : region) {
        states_[face] = State::known;
        label(face, set) = found;
      }
    }
  }

  template <class Function>
  void for_each_halfedge(Number face, const Function& f) const {
    map_.for_each_cycle(face, [&](Number start) {
      Number h = start;
      do {
        f(h);
        h = map_.next(h);
      } while (h != start);
    });
  }

  void check(int set) {
    for (Number h = 0; h < map_.number_of_halfedges(); h += 2) {
      const Sides sides = map_.sides(h, set);
      if (sides.left == sides.right && label(map_.face(h), set) != label(map_.face(h + 1), set)) refuse(h, set);
    }
  }

  [[noreturn]] void refuse(Number h, int set, const Sides& contradiction = {}) {
    const Sides sides = map_.sides(h, set);
    std::vector<int> patches{sides.left, sides.right, contradiction.left, contradiction.right};
    for (const Number side : {h, h ^ 1}) patches.push_back(label(map_.face(side), set));
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    std::erase(patches, Loop_label::none);
    fail_imprint(nodes_, map_.node(map_.source(h)),
                 set == 0 ? "sources overlap or are not closed" : "targets overlap or are not closed", patches);
  }

  const Planar_map<Traits>& map_;
  const Layer_nodes<Traits>& nodes_;
  std::vector<Loop_label> labels_;
  std::vector<State> states_;  // of the faces, for one set
};

}  // namespace CCSweep::internal

#endif
