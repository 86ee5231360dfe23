// Copyright (c) 2026 The CCSweep authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The imprint beside the overlays a user could take instead. All of them get the same loops, and the areas that each
// finds are compared with those of the first in the same run.
#include <CCSweep/loops/imprint.h>

#include <CGAL/Arr_default_overlay_traits.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <array>
#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/difference.hpp>
#include <boost/geometry/algorithms/intersection.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <polyclipping/clipper.hpp>
#include <string>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "imprint_families.h"

namespace {

using namespace imprint_benchmark;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

std::map<std::string, Areas>& known_areas() {
  static std::map<std::string, Areas> areas;
  return areas;
}

// The first that measures a scene says what its areas are.
void check_areas(benchmark::State& state, const std::string& scene, const Areas& found) {
  const auto [known, is_first] = known_areas().try_emplace(scene, found);
  for (std::size_t i = 0; i < 3; ++i) {
    const double scale = known->second[0] + known->second[1] + known->second[2];
    if (!(std::fabs(known->second[i] - found[i]) <= 1e-6 * scale)) state.SkipWithError("the areas differ");
  }
}

// --- this package

template <class SegmentIndex>
struct Ccsweep {
  double tolerance = 0;
  CCSweep::Layer_drawing<Kernel> input;
  CCSweep::Imprint<Kernel> result;

  explicit Ccsweep(const Scene& scene, double t = 0) : tolerance(t), input(drawing<Kernel>(scene)) {}
  void run() { result = CCSweep::imprint_layer<Kernel, SegmentIndex>(input, tolerance).value(); }
  void clear() { result = {}; }
  Areas areas() const {
    Areas sum{};
    for (const auto& segment : result.segments()) {
      const auto &p = result.points[segment.source.value()], &q = result.points[segment.target.value()];
      const double twice = p.x() * q.y() - q.x() * p.y();
      add(segment.left, twice / 2, sum);
      add(segment.right, -twice / 2, sum);
    }
    return sum;
  }
  static void add(const CCSweep::Loop_label& label, double part, Areas& sum) {
    if (label.empty()) return;
    sum[label.target == CCSweep::Loop_label::none ? 1 : label.source == CCSweep::Loop_label::none ? 2 : 0] += part;
  }
};
using Ccsweep_rtree = Ccsweep<CCSweep::Rtree_segment_index_2<Kernel>>;
using Ccsweep_runs = Ccsweep<CCSweep::Run_segment_index_2<Kernel>>;

struct Ccsweep_tolerant : Ccsweep_rtree {
  explicit Ccsweep_tolerant(const Scene& scene) : Ccsweep_rtree(scene, 1e-9) {}
};

// --- the bare bound: what any method with an r-tree must do at least

struct Bound {
  using Point = boost::geometry::model::d2::point_xy<double>;
  using Box = boost::geometry::model::box<Point>;
  using Value = std::pair<Box, std::size_t>;
  using Segments = std::vector<std::array<Kernel::Point_2, 2>>;

  Segments s, t;
  std::size_t crossings = 0;

  explicit Bound(const Scene& scene) : s(segments(scene.sources)), t(segments(scene.targets)) {}
  static Segments segments(const std::vector<Face>& faces) {
    Segments result;
    for (const Face& face : faces) {
      for (const Loop& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const Place &p = loop[i], &q = loop[(i + 1) % loop.size()];
          result.push_back({Kernel::Point_2(p[0], p[1]), Kernel::Point_2(q[0], q[1])});
        }
      }
    }
    return result;
  }
  static Box box(const std::array<Kernel::Point_2, 2>& segment) {
    const CGAL::Bbox_2 b = segment[0].bbox() + segment[1].bbox();
    return {{b.xmin(), b.ymin()}, {b.xmax(), b.ymax()}};
  }
  void run() {
    namespace index = boost::geometry::index;
    std::vector<Value> values;
    values.reserve(s.size());
    for (std::size_t i = 0; i < s.size(); ++i) values.emplace_back(box(s[i]), i);
    const index::rtree<Value, index::quadratic<16>> tree(values);
    crossings = 0;
    std::vector<Value> found;
    const Kernel::Orientation_2 turn = Kernel().orientation_2_object();
    for (const auto& [a, b] : t) {
      found.clear();
      tree.query(index::intersects(box({a, b})), std::back_inserter(found));
      for (const Value& value : found) {
        const auto& [p, q] = s[value.second];
        if (turn(a, b, p) * turn(a, b, q) <= 0 && turn(p, q, a) * turn(p, q, b) <= 0) ++crossings;
      }
    }
    benchmark::DoNotOptimize(crossings);
  }
  void clear() {}
};

// --- CGAL's overlay: of arrangements that are given, and from the same input as all others

struct Cgal_overlay {
  using Traits = CGAL::Arr_segment_traits_2<Exact>;
  using Label = CCSweep::Loop_label;
  using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, Label>>;
  struct Merge {
    Label operator()(const Label& a, const Label& b) const { return {a.source, b.target}; }
  };

  Arrangement s, t, result;

  explicit Cgal_overlay(const Scene& scene) { make(scene.sources, true, s), make(scene.targets, false, t); }
  // Only whether a face is inside matters for the areas.
  static void make(const std::vector<Face>& faces, bool is_source, Arrangement& arrangement) {
    std::vector<Traits::X_monotone_curve_2> curves;
    for (const Face& face : faces) {
      for (const Loop& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const Place &p = loop[i], &q = loop[(i + 1) % loop.size()];
          curves.emplace_back(Exact::Point_2(p[0], p[1]), Exact::Point_2(q[0], q[1]));
        }
      }
    }
    CGAL::insert(arrangement, curves.begin(), curves.end());
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) f->set_data({});
    // The faces next to the outside are inside; what is behind those are holes.
    for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
      if (f->is_unbounded()) continue;
      const bool is_hole = faces.size() == 1 && !f->outer_ccb()->twin()->face()->is_unbounded();
      if (!is_hole) f->set_data(is_source ? Label{0, -1} : Label{-1, 0});
    }
  }
  void run() {
    CGAL::Arr_face_overlay_traits<Arrangement, Arrangement, Arrangement, Merge> traits;
    CGAL::overlay(s, t, result, traits);
  }
  void clear() { result.clear(); }
  Areas areas() const {
    Areas sum{};
    for (auto e = result.edges_begin(); e != result.edges_end(); ++e) {
      const auto &p = e->source()->point(), &q = e->target()->point();
      const double part = (CGAL::to_double(p.x()) * CGAL::to_double(q.y()) -
                           CGAL::to_double(q.x()) * CGAL::to_double(p.y())) / 2;
      Ccsweep_rtree::add(e->face()->data(), part, sum);
      Ccsweep_rtree::add(e->twin()->face()->data(), -part, sum);
    }
    return sum;
  }
};

struct Cgal : Cgal_overlay {
  const Scene& scene;

  explicit Cgal(const Scene& given) : Cgal_overlay(given), scene(given) {}
  void run() {
    s.clear();
    t.clear();
    make(scene.sources, true, s);
    make(scene.targets, false, t);
    Cgal_overlay::run();
  }
};

// --- Boost.Geometry: an intersection and two differences

struct Boost_geometry {
  using Point = boost::geometry::model::d2::point_xy<double>;
  using Polygon = boost::geometry::model::polygon<Point, false, false>;
  using Polygons = boost::geometry::model::multi_polygon<Polygon>;

  Polygon s, t;
  Polygons both, s_only, t_only;

  explicit Boost_geometry(const Scene& scene) : s(polygon(scene.sources[0])), t(polygon(scene.targets[0])) {}
  static Polygon polygon(const Face& face) {
    Polygon result;
    for (const Place& p : face.loops[0]) result.outer().emplace_back(p[0], p[1]);
    for (std::size_t i = 1; i < face.loops.size(); ++i) {
      result.inners().emplace_back();
      for (const Place& p : face.loops[i]) result.inners().back().emplace_back(p[0], p[1]);
    }
    return result;
  }
  void run() {
    boost::geometry::intersection(s, t, both);
    boost::geometry::difference(s, t, s_only);
    boost::geometry::difference(t, s, t_only);
  }
  void clear() { both.clear(), s_only.clear(), t_only.clear(); }
  Areas areas() const {
    return {boost::geometry::area(both), boost::geometry::area(s_only), boost::geometry::area(t_only)};
  }
};

// --- Clipper, on its integer grid

struct Clipper {
  static constexpr double scale = 1 << 29;
  ClipperLib::Paths s, t;
  std::array<ClipperLib::Paths, 3> results;

  explicit Clipper(const Scene& scene) : s(paths(scene.sources[0])), t(paths(scene.targets[0])) {}
  static ClipperLib::Paths paths(const Face& face) {
    ClipperLib::Paths result;
    for (const Loop& loop : face.loops) {
      result.emplace_back();
      for (const Place& p : loop) {
        result.back().emplace_back(std::llround(p[0] * scale), std::llround(p[1] * scale));
      }
    }
    return result;
  }
  static void clip(const ClipperLib::Paths& s, const ClipperLib::Paths& t, ClipperLib::ClipType type,
                   ClipperLib::Paths& result) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(s, ClipperLib::ptSubject, true);
    clipper.AddPaths(t, ClipperLib::ptClip, true);
    clipper.Execute(type, result);
  }
  void run() {
    clip(s, t, ClipperLib::ctIntersection, results[0]);
    clip(s, t, ClipperLib::ctDifference, results[1]);
    clip(t, s, ClipperLib::ctDifference, results[2]);
  }
  void clear() { results = {}; }
  Areas areas() const {
    Areas sum{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (const ClipperLib::Path& path : results[i]) sum[i] += ClipperLib::Area(path) / scale / scale;
    }
    return sum;
  }
};

// Throwing the result away is not measured.
template <class Peer>
void measure(benchmark::State& state, const std::string& name, const std::vector<Scene>& scenes) {
  std::vector<Peer> peers(scenes.begin(), scenes.end());
  std::size_t i = 0;
  for (auto _ : state) {
    Peer& peer = peers[i];
    peer.run();
    state.PauseTiming();
    if constexpr (requires { peer.areas(); }) check_areas(state, name + "/" + std::to_string(i), peer.areas());
    peer.clear();
    i = (i + 1) % peers.size();
    state.ResumeTiming();
  }
}

// Scenes of a name and the turn from one to the next.
struct Series {
  std::string name;
  Scene scene;
  double turn;
};

template <class Peer>
void add(const Series& series, const std::string& peer) {
  benchmark::RegisterBenchmark((series.name + "/" + peer).c_str(), [series](benchmark::State& state) {
    measure<Peer>(state, series.name, variations(series.scene, series.turn));
  })->Unit(benchmark::kMicrosecond);
}

void add_all(const Series& series) {
  add<Ccsweep_rtree>(series, "ccsweep_rtree");
  add<Ccsweep_runs>(series, "ccsweep_runs");
  add<Ccsweep_tolerant>(series, "ccsweep_tolerant");
  add<Bound>(series, "bound");
  add<Cgal_overlay>(series, "cgal_overlay");
  add<Cgal>(series, "cgal");
  if (series.scene.sources.size() > 1) return;  // what follows takes two faces only
  add<Boost_geometry>(series, "boost");
  add<Clipper>(series, "clipper");
}

void register_all() {
#ifdef __GLIBC__
  // Memory that one run gave back serves the next, for all peers alike: else the first to grow pays for fresh pages.
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
  const std::map<Family, std::string> families{{Family::apart, "apart"},
                                               {Family::root, "root"},
                                               {Family::quarter, "quarter"},
                                               {Family::root_holes, "root_holes"},
                                               {Family::quarter_holes, "quarter_holes"}};
  for (const auto& [family, name] : families) {
    for (std::size_t n : {100, 1000, 10000, 100000}) {
      constexpr double turn = 0.001;  // the holes must still meet
      add_all({"imprint/" + name + "/" + std::to_string(n), two_faces(family, n), turn});
    }
  }
  for (std::size_t m : {4, 8, 16, 32, 64}) add_all({"imprint/layer/" + std::to_string(m), layer(m), 0.02});
}

const bool registered = (register_all(), true);

}  // namespace
