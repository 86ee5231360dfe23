// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CCSWEEP_TEST_LOOPS_SCENE_H
#define CCSWEEP_TEST_LOOPS_SCENE_H

#include <cstddef>
#include <istream>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "loops_drawings.h"

namespace loops_test {

// A labelled face: an outer loop, and holes as loops in the same sense.
struct Piece {
  int label;
  Loop outer;
  std::vector<Loop> holes = {};
  friend bool operator==(const Piece&, const Piece&) = default;
};

struct Scene {
  std::string name;
  std::vector<Piece> sources, targets;
};

template <class K>
CCSweep::Layer_drawing<K> drawn(const Scene& scene) {
  CCSweep::Layer_drawing<K> drawing;
  for (bool is_source : {true, false}) {
    for (const Piece& piece : is_source ? scene.sources : scene.targets) {
      const Loop_label label = is_source ? Loop_label{piece.label, -1} : Loop_label{-1, piece.label};
      draw(drawing, piece.outer, label);
      for (const Loop& hole : piece.holes) draw(drawing, reversed(hole), label);
    }
  }
  return drawing;
}

// A scene as text, a loop a line: "source 3 x y x y ...", "target ...", and "hole x y ..." after what it is in.
inline void write(std::ostream& out, const Scene& scene) {
  out.precision(std::numeric_limits<double>::max_digits10);
  const auto put = [&](const Loop& loop) {
    for (const auto& [x, y] : loop) out << ' ' << x << ' ' << y;
    out << '\n';
  };
  out << "# " << scene.name << '\n';
  for (bool is_source : {true, false}) {
    for (const Piece& piece : is_source ? scene.sources : scene.targets) {
      put((out << (is_source ? "source " : "target ") << piece.label, piece.outer));
      for (const Loop& hole : piece.holes) put((out << "hole", hole));
    }
  }
}

inline Scene read(std::istream& in) {
  Scene scene;
  std::vector<Piece>* pieces = &scene.sources;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    int label = 0;
    words >> kind;
    if (kind == "#") std::getline(words >> std::ws, scene.name);
    if (kind == "source" || kind == "target") words >> label;
    Loop loop;
    for (double x, y; words >> x >> y;) loop.push_back({x, y});
    if (kind == "source" || kind == "target") {
      pieces = kind == "source" ? &scene.sources : &scene.targets;
      pieces->push_back({label, loop});
    } else if (kind == "hole") {
      pieces->back().holes.push_back(loop);
    }
  }
  return scene;
}

// Takes away pieces, holes and nodes for as long as the rest still fails.
template <class Fails>
class Minimiser {
 public:
  Minimiser(Scene scene, const Fails& fails) : scene_(std::move(scene)), fails_(fails) {}

  Scene run() {
    do {
      changed_ = false;
      for (std::vector<Piece> Scene::*set : {&Scene::sources, &Scene::targets}) {
        thin([set](Scene& s) -> auto& { return s.*set; }, 0);
        for (std::size_t p = 0; p < (scene_.*set).size(); ++p) {
          thin([=](Scene& s) -> auto& { return (s.*set)[p].holes; }, 0);
          thin([=](Scene& s) -> auto& { return (s.*set)[p].outer; }, 3);
          for (std::size_t h = 0; h < (scene_.*set)[p].holes.size(); ++h) {
            thin([=](Scene& s) -> auto& { return (s.*set)[p].holes[h]; }, 3);
          }
        }
      }
    } while (changed_);
    return scene_;
  }

 private:
  template <class Part>
  void thin(const Part& part, std::size_t least) {
    for (std::size_t i = part(scene_).size(); i-- > 0 && part(scene_).size() > least;) {
      Scene smaller = scene_;
      auto& list = part(smaller);
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
      if (!fails_(smaller)) continue;
      scene_ = smaller;
      changed_ = true;
    }
  }

  Scene scene_;
  const Fails& fails_;
  bool changed_ = false;
};

}  // namespace loops_test

#endif
