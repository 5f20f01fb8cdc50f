#include "experiments/common/replay.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "benchmarks/probe.h"

#include "thigma/contact/clustering.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace {

constexpr std::size_t kCapacity = 400'000;
constexpr int kClusters = 5;

/// Query and direct response of one body after another, with what they remember.
struct Renderer {
  const Pair& pair;
  const PenaltyParams& gains;
  ContactQuery query;
  ContactFront front;
  ContactSet contacts;
  ContactClusters clusters;
  ClusterScratch scratch;
  ClusterStart start = ClusterStart::last_frame;
  double cpu = 0.0;  // of the last query [s]

  Renderer(const Pair& p, const Resolution& resolution, const PenaltyParams& g)
      : pair(p), gains(g) {
    query.tolerance = gains.tolerance;
    query.resolution = resolution;
    reserve_front(front, *pair.object, *pair.scene);
    contacts.contacts.reserve(kCapacity);
  }

  Wrench render(const Pose& world_from_object) {
    clear(contacts);
    const double before = bench::thread_cpu();
    query_contacts({*pair.object, world_from_object}, {*pair.scene, pair.world_from_scene}, query,
                   front, contacts);
    cpu = bench::thread_cpu() - before;
    if (start == ClusterStart::afresh) clusters = {};
    cluster_contacts(contacts.contacts, clusters,
                     {.max_clusters = kClusters, .tolerance = gains.tolerance}, scratch, clusters);
    return direct_wrench(clusters, gains, transform_point(world_from_object, pair.object->center));
  }
};

double rise(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

/// The script as rows for the hand, device frame: origin at the object's centre at the start, axes
/// of the world.
std::vector<TimedPose> script_rows(const Pair& pair, const HandScript& script) {
  std::vector<TimedPose> rows;
  const double step = 0.005;
  for (int i = 0; i * step <= script.seconds + 2.0 * step; ++i) {
    const double t = i * step;
    const double on = rise((t - script.approach_time) / 0.1);  // sliding starts at the touch
    const double after = std::max(t - script.approach_time, 0.0);
    const double depth = (pair.clearance + script.depth) * rise(t / script.approach_time) +
                         script.tap * on * sine(2.0 * kPi * script.tap_rate * after);
    TimedPose row;
    row.time = t;
    row.pose.position =
        depth * pair.approach + on * sine(2.0 * kPi * script.slide_rate * after) * script.slide;
    row.pose.orientation =
        rotation_from_vector(on * sine(2.0 * kPi * script.turn_rate * after) * script.turn);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

PenaltyParams direct_gains(const Pair& pair, double tolerance_share, double max_force) {
  return direct_penalty(
      {.max_force = max_force, .max_stiffness = max_force / (tolerance_share * pair.radius)});
}

Path record_path(const Pair& pair, const Resolution& resolution, const PenaltyParams& gains,
                 const HandScript& script) {
  HandParams params;
  params.script = script_rows(pair, script);
  params.encoder = 0.0;
  params.angular_encoder = 0.0;
  HandDevice hand(params);
  const Vec3 origin = transform_point(pair.start, pair.object->center);
  Path path;
  Renderer renderer(pair, resolution, gains);
  const int frames = static_cast<int>(std::lround(script.seconds / path.step));
  for (int i = 0; i < frames; ++i) {
    const Pose handle = hand.read(i * path.step).motion.pose;
    Pose pose;
    pose.orientation = handle.orientation * pair.start.orientation;
    pose.orientation.normalize();
    pose.position =
        origin + handle.position - pose.orientation._transformVector(pair.object->center);
    hand.write(renderer.render(pose));
    path.poses.push_back(pose);
  }
  return path;
}

Profile replay(const Pair& pair, const Path& path, const Resolution& resolution,
               const PenaltyParams& gains, int repeats, ClusterStart start) {
  Profile profile;
  for (int repeat = 0; repeat < std::max(repeats, 1); ++repeat) {
    Renderer renderer(pair, resolution, gains);
    renderer.start = start;
    for (std::size_t i = 0; i < path.poses.size(); ++i) {
      const Wrench wrench = renderer.render(path.poses[i]);
      if (repeat > 0) {
        profile.cpu[i] = std::min(profile.cpu[i], renderer.cpu);
        continue;
      }
      const QueryStats& stats = renderer.contacts.stats;
      double depth = -gains.tolerance, bound = 0.0, level = 0.0;
      for (const Contact& c : renderer.contacts.contacts) {
        depth = std::max(depth, c.depth);
        bound = std::max(bound, c.bound);
        level += 0.5 * (c.object_level + c.scene_level);
      }
      const double count = static_cast<double>(renderer.contacts.contacts.size());
      profile.force.push_back(wrench.force);
      profile.torque.push_back(wrench.torque);
      profile.force_size.push_back(wrench.force.norm());
      profile.cpu.push_back(renderer.cpu);
      profile.front.push_back(static_cast<double>(stats.front));
      profile.tests.push_back(static_cast<double>(stats.tests));
      profile.mandatory.push_back(static_cast<double>(stats.mandatory_tests));
      profile.unrefined.push_back(static_cast<double>(stats.unrefined));
      profile.contacts.push_back(count);
      profile.level.push_back(count > 0.0 ? level / count
                                          : std::numeric_limits<double>::quiet_NaN());
      profile.depth.push_back(depth);
      profile.bound.push_back(bound);
    }
  }
  return profile;
}

Resolution as_in_text(double threshold) {
  Resolution resolution;
  resolution.is_exact = threshold <= 0.0;
  resolution.metric.haptic = threshold;
  resolution.deviation_cap = kNoCap;
  return resolution;
}

Span in_contact(const Profile& reference) {
  Span span{reference.force_size.size(), 0};
  for (std::size_t i = 0; i < reference.force_size.size(); ++i) {
    if (!(reference.force_size[i] > 0.0)) continue;
    span.begin = std::min(span.begin, i);
    span.end = i + 1;
  }
  if (span.begin > span.end) span.begin = span.end;
  return span;
}

std::vector<double> cut(const std::vector<double>& values, const Span& span) {
  return {values.begin() + static_cast<std::ptrdiff_t>(span.begin),
          values.begin() + static_cast<std::ptrdiff_t>(span.end)};
}

}  // namespace thigma::experiments
