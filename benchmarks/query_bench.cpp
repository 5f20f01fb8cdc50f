#include "benchmarks/query_bench.h"

#include <time.h>

#include <algorithm>
#include <vector>

#include "scenes/make_model.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/elementary.h"

namespace thigma::bench {
namespace {

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Jaws {
  ClodHierarchy upper, lower;
  double radius = 0.0;
  Pose touch;  // of the upper jaw
};

// Height at which the upper jaw just comes within a hair of the lower one.
Pose find_touch(const Jaws& jaws) {
  ContactSet set;
  set.contacts.reserve(1);
  ContactFront front;
  double low = 0.0, high = 2.0 * (jaws.upper.radius + jaws.lower.radius);  // in touch at low, apart at high
  const double center = jaws.lower.center.z() - jaws.upper.center.z();
  auto touches = [&](double height) {
    clear(set);
    Pose pose;
    pose.position.z() = center + height;
    query_contacts(jaws.upper, pose, jaws.lower, Pose{}, {.tolerance = 1e-4 * jaws.radius}, front, set);
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

Jaws make_jaws() {
  Jaws jaws;
  jaws.upper = build_exact_hierarchy(scenes::make_model({.name = "jaw_upper"}));
  jaws.lower = build_exact_hierarchy(scenes::make_model({.name = "jaw_lower"}));
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
    const double start = cpu_seconds();
    const QueryStats tracked = track_front(jaws.upper, pose, jaws.lower, Pose{}, query, front);
    const double middle = cpu_seconds();
    query_contacts(jaws.upper, pose, jaws.lower, Pose{}, query, front, set);
    const double spent = cpu_seconds() - start;
    if (i == 0) {
      timing.cold_us = 1e6 * spent;
      continue;
    }
    seconds.push_back(spent);
    tracking.push_back(middle - start);
    fronts.push_back(static_cast<double>(set.stats.front));
    timing.contacts += static_cast<double>(set.contacts.size()) / (frames - 1);
    timing.tests += static_cast<double>(set.stats.tests + tracked.tests) / (frames - 1);
    timing.pair_queries += static_cast<double>(set.stats.pair_queries + tracked.pair_queries) / (frames - 1);
    timing.front += fronts.back() / (frames - 1);
  }
  auto quantile = [](std::vector<double>& v, double q) {
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(q * static_cast<double>(v.size() - 1))];
  };
  timing.p50_us = 1e6 * quantile(seconds, 0.5);
  timing.p99_us = 1e6 * quantile(seconds, 0.99);
  timing.ns_per_node = 1e9 * quantile(tracking, 0.5) / quantile(fronts, 0.5);
  return timing;
}

double largest_front(const Jaws& jaws, double tolerance, double step) {
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(200'000);
  double largest = 0.0;
  for (int i = 10; i < 100; i += 10) {
    clear(set);
    query_contacts(jaws.upper, pose_at(jaws, i, 100, step), jaws.lower, Pose{}, {.tolerance = tolerance}, front, set);
    largest = std::max(largest, static_cast<double>(set.stats.front));
  }
  return largest;
}

}  // namespace

QueryTiming measure_jaws_query(int frames, double tolerance, double step, double front) {
  static const Jaws jaws = make_jaws();
  double d = tolerance * jaws.radius;
  if (front > 0.0) {
    double low = 1e-6 * jaws.radius, high = 0.1 * jaws.radius;
    for (int i = 0; i < 16; ++i) {
      d = 0.5 * (low + high);
      const double reached = largest_front(jaws, d, step);
      if (reached > 0.95 * front && reached < 1.05 * front) break;
      (reached < front ? low : high) = d;
    }
  }
  return run_path(jaws, frames, d, step);
}

}  // namespace thigma::bench
