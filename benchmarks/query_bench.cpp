#include "benchmarks/query_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "benchmarks/baselines/fcl_baseline.h"
#include "benchmarks/probe.h"
#include "tests/support/triangle_search.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/exact/exact_front.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/elementary.h"
#include "thigma/math/quantile.h"
#include "thigma/models/make_model.h"

namespace thigma::bench {
namespace {

struct Jaws {
  TriangleMesh upper_mesh, lower_mesh;
  ClodHierarchy upper, lower;
  double radius = 0.0;
  Pose touch;  // of the upper jaw
};

// Height at which the upper jaw just comes within a hair of the lower one.
Pose find_touch(const Jaws& jaws) {
  ContactSet set;
  set.contacts.reserve(1);
  ContactFront front;
  // in touch at low, apart at high
  double low = 0.0, high = 2.0 * (jaws.upper.radius + jaws.lower.radius);
  const double center = jaws.lower.center.z() - jaws.upper.center.z();
  auto touches = [&](double height) {
    clear(set);
    Pose pose;
    pose.position.z() = center + height;
    query_contacts({jaws.upper, pose}, {jaws.lower}, {.tolerance = 1e-4 * jaws.radius}, front, set);
    return !set.contacts.empty();
  };
  for (int i = 0; i < 40 && high - low > 1e-5 * jaws.radius; ++i) {
    const double middle = 0.5 * (low + high);
    (touches(middle) ? low : high) = middle;
  }
  Pose pose;
  pose.position.z() = center + high;
  return pose;
}

// triangles: of each jaw, 0 for the models' own counts.
Jaws make_jaws(int triangles = 0) {
  Jaws jaws;
  jaws.upper_mesh = models::make_model({.name = "jaw_upper", .triangles = triangles});
  jaws.lower_mesh = models::make_model({.name = "jaw_lower", .triangles = triangles});
  jaws.upper = build_exact_hierarchy(jaws.upper_mesh);
  jaws.lower = build_exact_hierarchy(jaws.lower_mesh);
  jaws.radius = std::min(jaws.upper.radius, jaws.lower.radius);
  jaws.touch = find_touch(jaws);
  return jaws;
}

// Comes down over the first tenth, then grinds sideways and rocks while pressed.
Pose pose_at(const Jaws& jaws, int frame, int frames, double step) {
  const double s = static_cast<double>(frame) / frames;
  const double press = s < 0.1 ? 0.02 - 0.2 * s : 0.001 * sine(40.0 * s);
  const double phase = step / 0.004 * frame;  // the grinding circle has 0.4 % of the radius
  Pose pose = jaws.touch;
  pose.position += jaws.radius * Vec3(0.004 * (cosine(phase) - 1.0), 0.004 * sine(phase), press);
  const SinCos half = sin_cos(0.0005 * sine(0.7 * phase));
  pose.orientation = Quat(half.cos, half.sin, 0.0, 0.0);
  return pose;
}

QueryTiming run_path(const Jaws& jaws, int frames, double tolerance, double step) {
  ContactFront front;
  reserve_front(front, jaws.upper, jaws.lower);
  ContactSet set;
  set.contacts.reserve(200'000);
  QueryTiming timing;
  timing.tolerance = tolerance;
  std::vector<double> seconds, tracking, fronts;
  for (int i = 0; i < frames; ++i) {
    clear(set);
    const Pose pose = pose_at(jaws, i, frames, step);
    const ContactQuery query{.tolerance = tolerance};
    // The query after it finds the front in place, so the two parts add up to a query.
    const double start = thread_cpu();
    ContactSet none;
    detail::QueryFrame frame =
        detail::make_frame({jaws.upper, pose}, {jaws.lower}, query, front, none);
    detail::track_exact(frame);
    const double middle = thread_cpu();
    query_contacts({jaws.upper, pose}, {jaws.lower}, query, front, set);
    const double spent = thread_cpu() - start;
    if (i == 0) {
      timing.cold_us = 1e6 * spent;
      continue;
    }
    seconds.push_back(spent);
    tracking.push_back(middle - start);
    fronts.push_back(static_cast<double>(set.stats.front));
    timing.contacts += static_cast<double>(set.contacts.size()) / (frames - 1);
    timing.tests += static_cast<double>(set.stats.tests + none.stats.tests) / (frames - 1);
    timing.pair_queries +=
        static_cast<double>(set.stats.pair_queries + none.stats.pair_queries) / (frames - 1);
    timing.front += fronts.back() / (frames - 1);
  }
  timing.us = figure_of(seconds, 1e6);
  timing.ns_per_node = 1e9 * sample_quantile(tracking, 0.5) / sample_quantile(fronts, 0.5);
  return timing;
}

double largest_front(const Jaws& jaws, double tolerance, double step) {
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(200'000);
  double largest = 0.0;
  for (int i = 10; i < 100; i += 10) {
    clear(set);
    query_contacts({jaws.upper, pose_at(jaws, i, 100, step)}, {jaws.lower},
                   {.tolerance = tolerance}, front, set);
    largest = std::max(largest, static_cast<double>(set.stats.front));
  }
  return largest;
}

const Jaws& the_jaws() {
  static const Jaws jaws = make_jaws();
  return jaws;
}

std::vector<std::int32_t> patch_of_triangle(const ClodHierarchy& h) {
  std::vector<std::int32_t> of(static_cast<std::size_t>(h.triangle_count), -1);
  for (std::size_t p = 0; p < h.patches.size(); ++p) {
    const ClodPatch& patch = h.patches[p];
    for (std::int32_t t = 0; t < patch.triangle_count; ++t) {
      of[static_cast<std::size_t>(
          h.triangle_ids[static_cast<std::size_t>(patch.first_triangle + t)])] =
          static_cast<std::int32_t>(p);
    }
  }
  return of;
}

using PatchPairs = std::set<std::pair<std::int32_t, std::int32_t>>;

struct Truth {
  PatchPairs within;
  double least = 0.0;
};

Truth find_truth(const Jaws& jaws, const Pose& pose, double d) {
  static const std::vector<std::int32_t> of_upper = patch_of_triangle(jaws.upper),
                                         of_lower = patch_of_triangle(jaws.lower);
  static const test::TriangleTree lower = test::build_triangle_tree(jaws.lower_mesh);
  const test::TriangleTree upper = test::build_triangle_tree(jaws.upper_mesh, pose);
  Truth truth;
  for (const test::TrianglePair& pair : test::triangle_pairs_within(upper, lower, d)) {
    truth.within.insert(
        {of_upper[static_cast<std::size_t>(pair.a)], of_lower[static_cast<std::size_t>(pair.b)]});
  }
  truth.least = test::least_triangle_distance(upper, lower);
  return truth;
}

/// What one frame says about ours and the baseline; recall and errors are gathered in `out`.
void check_frame(const Jaws& jaws, const Pose& pose, double d, FclPair* fcl,
                 std::vector<double>& baseline_seconds, std::array<double, 3>& found,
                 JawsComparison& out) {
  const Truth truth = find_truth(jaws, pose, d);
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(200'000);
  query_contacts({jaws.upper, pose}, {jaws.lower}, {.tolerance = d}, front, set);
  double deepest = -1e300;
  for (const Contact& contact : set.contacts) {
    found[1] += truth.within.count({contact.object_patch, contact.scene_patch}) != 0 ? 1.0 : 0.0;
    deepest = std::max(deepest, contact.depth);
  }
  found[0] += static_cast<double>(truth.within.size());
  const double ours = std::max(0.0, -deepest);
  if (!set.contacts.empty())
    out.error_ours = std::max(out.error_ours, std::fabs(ours - truth.least) / jaws.radius);
  if (fcl == nullptr) return;
  const double start = thread_cpu();
  const FclDistance theirs = fcl_distance(*fcl, pose);
  baseline_seconds.push_back(thread_cpu() - start);
  found[2] += truth.within.empty() ? 0.0 : 1.0;  // its one pair
  out.error_baseline = std::max(
      out.error_baseline, std::fabs(std::max(0.0, theirs.distance) - truth.least) / jaws.radius);
}

}  // namespace

QueryTiming measure_jaws_query(int frames, double tolerance, double step, double front) {
  const Jaws& full = the_jaws();
  const double d = tolerance * full.radius;
  if (front <= 0.0) return run_path(full, frames, d, step);
  if (front < largest_front(full, d, step)) {
    // A smaller front at the same tolerance is one of coarser jaws.
    Jaws best = make_jaws(4000);
    double reached = largest_front(best, tolerance * best.radius, step);
    for (int triangles = 6000; reached < 0.9 * front && triangles < 40000;
         triangles += triangles / 2) {
      best = make_jaws(triangles);
      reached = largest_front(best, tolerance * best.radius, step);
    }
    return run_path(best, frames, tolerance * best.radius, step);
  }
  double low = d, high = 0.1 * full.radius, middle = d;
  for (int i = 0; i < 16; ++i) {
    middle = 0.5 * (low + high);
    const double reached = largest_front(full, middle, step);
    if (reached > 0.95 * front && reached < 1.05 * front) break;
    (reached < front ? low : high) = middle;
  }
  return run_path(full, frames, middle, step);
}

JawsComparison compare_jaws_query(int frames, int checked, double tolerance, double step) {
  const Jaws& jaws = the_jaws();
  const double d = tolerance * jaws.radius;
  JawsComparison out;
  out.ours = run_path(jaws, frames, d, step);
  FclPairPtr fcl = has_fcl() ? make_fcl_pair(jaws.upper_mesh, jaws.lower_mesh) : FclPairPtr{};
  out.has_baseline = fcl != nullptr;
  std::vector<double> seconds;
  std::array<double, 3> found{};  // true pairs, ours, baseline's
  for (int i = 0; i < checked; ++i) {
    check_frame(jaws, pose_at(jaws, (2 * i + 1) * frames / (2 * checked), frames, step), d,
                fcl.get(), seconds, found, out);
  }
  if (found[0] > 0.0) {
    out.recall_ours = found[1] / found[0];
    out.recall_baseline = found[2] / found[0];
  }
  out.baseline_us = figure_of(seconds, 1e6);
  return out;
}

}  // namespace thigma::bench
