#include "benchmarks/pair_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "benchmarks/baselines/fcl_baseline.h"
#include "benchmarks/probe.h"

#include "thigma/convex/gjk.h"
#include "thigma/convex/hull.h"
#include "thigma/math/random.h"

namespace thigma::bench {
namespace {

struct alignas(32) Lanes {
  float values[3 * kMaxHullVertices] = {};
};

struct Hulls {
  std::vector<std::vector<Vec3>> points;
  std::vector<Lanes> lanes;
  std::vector<HullView> views;
};

// A shallow cap of diameter about 1 with n extreme points, in a random attitude.
std::vector<Vec3> make_cap(int n, const Vec3& center, Random& random) {
  const Mat3 attitude = random.orientation().toRotationMatrix();
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double r = 0.5 * std::sqrt(random.uniform(0.1, 1.0));
    const Vec3 d = random.direction();
    const Vec2 flat = Vec2(d.x(), d.y()).normalized() * r;
    points.push_back(center + attitude * Vec3(flat.x(), flat.y(), -0.4 * r * r));
  }
  return points;
}

void add_hull(std::vector<Vec3> points, const Vec3& center, Hulls& hulls, std::size_t i) {
  hulls.points[i] = std::move(points);
  const std::vector<Vec3>& p = hulls.points[i];
  HullView v;
  v.vertices = p.data();
  v.vertex_count = static_cast<int>(p.size());
  v.lane_count = (v.vertex_count + 7) / 8 * 8;
  v.center = center;
  for (const Vec3& q : p) v.radius = std::max(v.radius, (q - center).norm());
  for (int k = 0; k < v.lane_count; ++k) {
    const Vec3 q = p[static_cast<std::size_t>(std::min(k, v.vertex_count - 1))] - center;
    for (int c = 0; c < 3; ++c)
      hulls.lanes[i].values[c * v.lane_count + k] = static_cast<float>(q[c]);
  }
  v.lanes = hulls.lanes[i].values;
  hulls.views[i] = v;
}

struct Scene {
  Hulls a, b;
  std::vector<RelativePose> poses;
};

Scene make_scene(int low, int high, const PairTimingParams& params) {
  Random random(params.seed);
  Scene scene;
  const auto n = static_cast<std::size_t>(params.pairs);
  for (Hulls* h : {&scene.a, &scene.b}) {
    h->points.resize(n);
    h->lanes.resize(n);
    h->views.resize(n);
  }
  const Mat3 rotation = random.orientation().toRotationMatrix();
  const Vec3 translation = random.in_cube(5.0);
  const auto span = static_cast<std::uint64_t>(high - low + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 center = random.direction() * random.uniform(10.0, 30.0);
    const Vec3 apart = random.direction() * random.uniform(1.06, 1.5);
    const Vec3 center_b = rotation.transpose() * (center + apart - translation);
    add_hull(make_cap(low + static_cast<int>(random.below(span)), center, random), center, scene.a,
             i);
    add_hull(make_cap(low + static_cast<int>(random.below(span)), center_b, random), center_b,
             scene.b, i);
  }
  const Vec3 step = random.direction() * params.motion;
  const Vec3 turn = random.direction();
  for (int f = 0; f < params.frames; ++f) {
    // to and fro: never far, always about `motion` a frame
    const double s = std::sin(0.2 * f) / 0.2;
    const double angle = 0.5 * params.motion / 30.0 * s;
    const Mat3 small = Quat(1.0, angle * turn.x(), angle * turn.y(), angle * turn.z())
                           .normalized()
                           .toRotationMatrix();
    scene.poses.push_back({small * rotation, small * translation + s * step});
  }
  return scene;
}

// What reading the clock adds to a measured span [s]: a system call, 1-2 ns a pair if left in.
double clock_cost() {
  double least = 1e300;
  for (int i = 0; i < 1000; ++i) {
    const double start = thread_cpu();
    least = std::min(least, thread_cpu() - start);
  }
  return least;
}

// Times `frame(pose)` over all frames, several times; the first round warms up.
template <class Frame>
PairTiming time_frames(const char* name, int low, int high, const Scene& scene,
                       const PairTimingParams& params, Frame frame) {
  PairTiming t;
  t.name = name;
  t.vertices_low = low;
  t.vertices_high = high;
  std::vector<double> best(scene.poses.size(), 1e300);
  const double clock = clock_cost();
  for (int r = 0; r <= params.repetitions; ++r) {
    for (std::size_t f = 0; f < scene.poses.size(); ++f) {
      const double start = thread_cpu();
      frame(scene.poses[f]);
      const double ns = (thread_cpu() - start - clock) * 1e9 / params.pairs;
      if (r > 0) best[f] = std::min(best[f], ns);
    }
  }
  std::sort(best.begin(), best.end());
  t.median = best[best.size() / 2];
  t.p99 = best[best.size() * 99 / 100];
  t.least = best.front();
  return t;
}

volatile double g_sink = 0.0;  // keeps results alive

// Vertices a hull may have, from and to.
constexpr std::array<std::pair<int, int>, 5> kClasses = {
    {{4, 6}, {8, 8}, {16, 16}, {30, 30}, {4, 30}}};

TriangleMesh hull_mesh(const std::vector<Vec3>& points) {
  const ConvexHull hull = build_hull(points);
  return {hull.vertices, hull.triangles};
}

void time_class(int low, int high, const PairTimingParams& params, std::vector<PairTiming>& out) {
  const Scene scene = make_scene(low, high, params);
  const std::size_t n = scene.a.views.size();
  constexpr double kFar = 1e300;
  std::vector<GjkCache> caches(n);
  double sum = 0.0, turns = 0.0, solved = 0.0;
  out.push_back(time_frames("single", low, high, scene, params, [&](const RelativePose& x) {
    for (std::size_t i = 0; i < n; ++i) {
      const Separation s = closest_points(scene.a.views[i], scene.b.views[i], x, kFar, caches[i]);
      sum += s.distance;
      turns += s.iterations;
    }
    solved += static_cast<double>(n);
  }));
  out.back().iterations = turns / solved;
  std::vector<GjkCache> batch_caches(n);
  std::vector<GjkQuery> queries(n);
  std::vector<Separation> separations(n);
  for (std::size_t i = 0; i < n; ++i)
    queries[i] = {&scene.a.views[i], &scene.b.views[i], &batch_caches[i]};
  out.push_back(time_frames("batched", low, high, scene, params, [&](const RelativePose& x) {
    closest_points_batch(queries, x, kFar, separations.data());
    sum += separations[0].distance;
  }));
  std::vector<std::array<float, 3>> axes(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 d = (separations[i].witness_b - separations[i].witness_a).normalized();
    axes[i] = {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())};
  }
  out.push_back(time_frames("axis", low, high, scene, params, [&](const RelativePose& x) {
    for (std::size_t i = 0; i < n; ++i)
      sum += axis_separates(scene.a.views[i], scene.b.views[i], x, axes[i].data(), 0.05);
  }));
  out.push_back(time_frames("sphere", low, high, scene, params, [&](const RelativePose& x) {
    for (std::size_t i = 0; i < n; ++i)
      sum += spheres_separate(scene.a.views[i], scene.b.views[i], x, 0.05);
  }));
  g_sink = sum;
}

}  // namespace

std::vector<PairTiming> time_pairs(const PairTimingParams& params) {
  std::vector<PairTiming> out;
  for (const auto& [low, high] : kClasses) time_class(low, high, params, out);
  return out;
}

std::vector<ConvexBaseline> time_convex_baseline(const PairTimingParams& params) {
  std::vector<ConvexBaseline> out;
  if (!has_fcl()) return out;
  for (const auto& [low, high] : kClasses) {
    const Scene scene = make_scene(low, high, params);
    const std::size_t n = scene.a.views.size();
    std::vector<FclConvexPairPtr> pairs(n);
    for (std::size_t i = 0; i < n; ++i) {
      pairs[i] = make_fcl_convex_pair(hull_mesh(scene.a.points[i]), hull_mesh(scene.b.points[i]));
    }
    ConvexBaseline row{low, high, 0.0, 0.0, 0.0};
    std::vector<GjkCache> caches(n);
    for (std::size_t i = 0; i < n; ++i) {
      const RelativePose& x = scene.poses.front();
      const double ours =
          closest_points(scene.a.views[i], scene.b.views[i], x, 1e300, caches[i]).distance;
      const double theirs = fcl_convex_distance(*pairs[i], Pose{x.translation, Quat(x.rotation)});
      row.disagreement = std::max(row.disagreement, std::fabs(ours - theirs));
    }
    const PairTiming t = time_frames("fcl", low, high, scene, params, [&](const RelativePose& x) {
      const Pose pose{x.translation, Quat(x.rotation)};
      double sum = 0.0;
      for (std::size_t i = 0; i < n; ++i) sum += fcl_convex_distance(*pairs[i], pose);
      g_sink = sum;
    });
    row.median = t.median;
    row.p99 = t.p99;
    out.push_back(row);
  }
  return out;
}

}  // namespace thigma::bench
