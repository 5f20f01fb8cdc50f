#include "experiments/constraint-force/ideal_proxy.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace {

constexpr double kSide = 0.020, kRadius = 0.005, kLength = 0.030;  // of E2's cube and peg [m]
constexpr double kClearances[] = {2e-5, 1e-4, 5e-4};         // of E2's holes, on the diameter [m]
constexpr std::size_t kFirstPeg = 3;                         // place among E2's scenes
constexpr double kPegTilt = 3.14159265358979323846 / 180.0;  // of E2's pegs, to either side [rad]
// The protocol gives radii. Facets as there lie 20 um inside, a fifteenth of what is felt.
constexpr double kFinerBalls = 4.0;
constexpr double kIn = 0.2;    // before the path, from apart to its first pose [s]
constexpr double kEase = 0.1;  // of the path, until the hand has its speed [s]

/// Where a function of one number changes its sign in [low, high].
double root(const std::function<double(double)>& f, double low, double high) {
  const bool rises = f(high) > 0.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == rises ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Height of the middle of a cube tilted about an axis of a face, standing on its edge.
double height_on_edge(double tilt) {
  const SinCos a = sin_cos(tilt);
  return 0.5 * kSide * (a.cos + std::fabs(a.sin));
}

/// The tilt at which the springs to a hand of this height and tilt are at their least.
double resting_tilt(double height, double tilt, const ProxySprings& springs) {
  const auto slope = [&](double t) {
    const SinCos a = sin_cos(t);
    return springs.linear * (height_on_edge(t) - height) * 0.5 * kSide * (a.cos - a.sin) +
           springs.angular * (t - tilt);
  };
  return slope(0.0) >= 0.0 ? 0.0 : root(slope, 0.0, tilt);
}

/// Tilt at which a peg meets both rims of a hole.
double tilt_at_touch(double gap) {
  const auto depth = [gap](double t) {
    const SinCos a = sin_cos(t);
    return 0.5 * kLength * a.sin - kRadius * (1.0 - a.cos) - gap;
  };
  return root(depth, 0.0, 0.2);
}

Vec3 peg_torque(const Pose& hand, double gap, const ProxySprings& springs) {
  const double tilt = vector_from_rotation(hand.orientation).y();
  const double most = tilt_at_touch(gap);
  const double over = std::max(0.0, std::fabs(tilt) - most);
  return {0.0, tilt > 0.0 ? -springs.angular * over : springs.angular * over, 0.0};
}

/// A sheet as a plate: what is below it is inside.
TriangleMesh closed_plate(double x, double y, int nx, int ny) {
  return transformed(make_box({x, y, 0.01}, {nx, ny, 1}), {{0.0, 0.0, -0.005}, Quat::Identity()});
}

/// E2's balls, so many times as fine as in e2-force-quality.
void divide_balls(double finer, QualityScene& scene) {
  scene.object = make_ball(0.020, static_cast<int>(std::lround(12.0 * finer)));
  scene.scene = make_ball(0.030, static_cast<int>(std::lround(16.0 * finer)));
}

ProxyScene balls(QualityScene scene, const ProxySprings& springs) {
  const double apart = 0.050;
  const double k = springs.linear;
  return {std::move(scene), [=](const Pose& p) {
            return Vec3(k * (apart - p.position.norm()) * p.position.normalized());
          }};
}

}  // namespace

std::vector<ProxyScene> proxy_scenes(int poses, const ProxySprings& springs) {
  std::vector<QualityScene> scenes = quality_scenes(poses);
  const double k = springs.linear;
  scenes[0].scene = closed_plate(0.16, 0.08, 32, 16);
  scenes[6].scene = closed_plate(0.06, 0.06, 8, 8);
  divide_balls(kFinerBalls, scenes[1]);
  std::vector<ProxyScene> result;
  result.push_back({scenes[0], [k](const Pose&) { return Vec3(0.0, 0.0, k * 1e-3); }});
  result.push_back(balls(scenes[1], springs));
  result.push_back({scenes[2], [k](const Pose& p) {
                      const double x = p.position.x();
                      const double over = std::max(0.0, std::fabs(x) - 1e-4);
                      return Vec3(x > 0.0 ? -k * over : k * over, 0.0, 0.0);
                    }});
  std::size_t next = kFirstPeg;
  for (const double clearance : kClearances) {
    result.push_back({scenes[next++], [clearance, springs](const Pose& p) {
                        return peg_torque(p, 0.5 * clearance, springs);
                      }});
  }
  result.push_back({scenes[6], [springs](const Pose& p) {
                      const double tilt = vector_from_rotation(p.orientation).y();
                      const double rest = resting_tilt(p.position.z(), tilt, springs);
                      const double push = height_on_edge(rest) - p.position.z();
                      return Vec3(0.0, 0.0, springs.linear * push);
                    }});
  result.push_back({scenes[7], [](const Pose&) { return Vec3(0.0, 0.0, 0.0); }});
  return result;
}

ProxyScene farther_peg(ProxyScene widest) {
  const double beyond = kPegTilt - tilt_at_touch(0.5 * kClearances[0]);
  const double larger = (tilt_at_touch(0.5 * kClearances[2]) + beyond) / kPegTilt;
  for (Pose& pose : widest.scene.path)
    pose.orientation = rotation_from_vector(larger * vector_from_rotation(pose.orientation));
  return widest;
}

ProxyScene finer_balls(int poses, double finer, const ProxySprings& springs) {
  QualityScene scene = quality_scenes(8 * poses)[1];
  scene.path.resize(static_cast<std::size_t>(poses));
  divide_balls(finer, scene);
  return balls(std::move(scene), springs);
}

ProxyQuality judge_proxy(const ProxyScene& proxy, const ProxySprings& springs,
                         const ProxyPace& pace) {
  const QualityScene& scene = proxy.scene;
  const double seconds = pace.seconds;
  const auto last = static_cast<double>(scene.path.size() - 1);
  // A hand that jumped to its speed would ring on the coupling.
  const auto way = [seconds](double t) {
    const double by = std::clamp(t, 0.0, seconds);
    return (by < kEase ? 0.5 * by * by / kEase : by - 0.5 * kEase) / (seconds - 0.5 * kEase);
  };
  const auto path_at = [&](double t) {
    const double place = way(t - kIn) * last;
    const auto i = static_cast<std::size_t>(std::min(std::floor(place), last - 1.0));
    const double share = place - static_cast<double>(i);
    const Pose &a = scene.path[i], &b = scene.path[i + 1];
    const Vec3 turn = vector_from_rotation(b.orientation * a.orientation.conjugate());
    return Pose{a.position + share * (b.position - a.position),
                rotation_from_vector(share * turn) * a.orientation};
  };
  // From apart to the first pose: back along the ideal force.
  Vec3 apart = proxy.ideal(scene.path[0]);
  apart = apart.norm() > 0.0 && !scene.has_torque ? Vec3(2e-3 * apart.normalized()) : Vec3(0, 0, 0);
  const auto mesh_at = [&](double t) {
    Pose pose = path_at(t);
    pose.position += (1.0 - std::clamp(t / kIn, 0.0, 1.0)) * apart;
    return pose;
  };
  LedPair pair = make_led_pair(scene.name, scene.object, scene.scene, mesh_at(0.0));
  const Pose mesh_from_body = inverse(mesh_at(0.0)) * pair.start;
  LedGains gains;
  gains.stiffness = springs.linear;
  gains.angular_stiffness = springs.angular;
  gains.every = pace.every;
  gains.angular_damping = 5e-4;
  gains.damping = pace.damping;
  const HandPath hand = [&](double t) { return mesh_at(t) * mesh_from_body; };
  std::vector<Vec3> felt, ideal;
  SessionConfig config = led_config(pair, gains, kIn + seconds);
  config.haptic.constraint.slop *= pace.slop;
  const LedRun run = run_led(config, hand, [&](const HapticSample& sample, const LedStep&) {
    if (sample.time < kIn + kEase + 0.05 * seconds) return;
    felt.push_back(scene.has_torque ? sample.command.torque : sample.command.force);
    ideal.push_back(proxy.ideal(path_at(sample.time)));
  });
  ProxyQuality q;
  double off = 0.0, size = 0.0;
  int angles = 0;
  for (const Vec3& v : ideal) q.largest = std::max(q.largest, v.norm());
  for (std::size_t i = 0; i < ideal.size(); ++i) {
    off += std::pow(felt[i].norm() - ideal[i].norm(), 2);
    size += ideal[i].squaredNorm();
    if (ideal[i].norm() == 0.0) q.stray = std::max(q.stray, felt[i].norm());
    if (!(ideal[i].norm() > 0.05 * q.largest) || q.largest == 0.0) continue;
    const double angle = std::atan2(felt[i].cross(ideal[i]).norm(), felt[i].dot(ideal[i]));
    ++angles;
    q.mean_angle += angle;
    q.largest_angle = std::max(q.largest_angle, angle);
  }
  q.magnitude = size > 0.0 ? std::sqrt(off / size) : 0.0;
  if (angles > 0) q.mean_angle /= angles;
  q.held_back = static_cast<double>(run.held_back) / std::max(1, run.frames);
  return q;
}

}  // namespace thigma::experiments
