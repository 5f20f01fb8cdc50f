#include "experiments/throws/thrown.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace {

constexpr double kStart = 0.028;  // of the object's centre over the plate [m]
constexpr double kWay = 0.060, kRest = 0.15;
// 5 to 200 g, 50 to 1000 N/m, 0.05 to 5 m/s, each spread evenly over its logarithm.
constexpr double kMass[] = {0.005, 0.2}, kStiffness[] = {50.0, 1000.0}, kSpeed[] = {0.05, 5.0};
constexpr double kSpin = 50.0;

double log_uniform(Random& random, const double (&range)[2]) {
  return range[0] * std::pow(range[1] / range[0], random.uniform());
}

double lowest(const LedPair& pair, const BodyState& body) {
  const Mat3 rotation = rotation_matrix(body.orientation);
  double low = std::numeric_limits<double>::infinity();
  for (const Vec3& p : pair.object.positions)
    low = std::min(low, body.position.z() + rotation.row(2).dot(p));
  return low;
}

}  // namespace

Throw make_throw(std::uint64_t seed, std::uint64_t index) {
  Random random(seed * 0x9e3779b97f4a7c15ull + index);
  Throw one;
  one.shape = static_cast<int>(random.below(3));
  one.every = kThrowEvery[random.below(4)];
  one.speed = log_uniform(random, kSpeed);
  one.spin = random.uniform(0.0, kSpin) * random.direction();
  one.mass = log_uniform(random, kMass);
  one.stiffness = log_uniform(random, kStiffness);
  one.turned = random.orientation();
  // Down, up to 30 degrees off.
  const double off = random.uniform(0.0, 0.5), round = random.uniform(0.0, 6.283185307179586);
  one.towards = Vec3(off * std::cos(round), off * std::sin(round), -1.0).normalized();
  return one;
}

ThrowWorld make_throw_world() {
  // Wide enough that nothing comes round its border.
  const TriangleMesh plate = make_box({0.3, 0.3, kThrowPlate}, {6, 6, 1});
  ThrowWorld world;
  const Pose start{{0.0, 0.0, kStart}, Quat::Identity()};
  world.pairs.push_back(make_led_pair("box", make_box({0.010, 0.012, 0.014}), plate, start));
  world.pairs.push_back(make_led_pair("ball", make_ball(0.008, 3), plate, start));
  world.pairs.push_back(make_led_pair("rod", make_cylinder(0.002, 0.030, 10), plate, start));
  return world;
}

Thrown run_throw(const ThrowWorld& world, const Throw& one, bool is_constrained) {
  LedPair pair = world.pairs[static_cast<std::size_t>(one.shape)];
  pair.mass = one.mass;
  pair.start.orientation = one.turned;
  LedGains gains;
  gains.is_constrained = is_constrained;
  gains.every = one.every;
  gains.stiffness = one.stiffness;
  gains.damping = 1.4 * std::sqrt(one.stiffness * one.mass);
  // As stiff for turning as for moving, at the object's rim.
  gains.angular_stiffness = 0.3 * one.stiffness * pair.reach * pair.reach;
  const double moving = kWay / one.speed;
  SessionConfig config = led_config(pair, gains, 0.02 + moving + kRest);
  config.contact.capacity = 4096;
  const HandPath hand = [&](double t) {
    const double in = std::clamp(t - 0.02, 0.0, moving);
    return Pose{pair.start.position + one.speed * in * one.towards,
                rotation_from_vector(in * one.spin) * pair.start.orientation};
  };
  Thrown how;
  const auto look = [&](const HapticSample& sample, const LedStep&) {
    how.depth = std::max(how.depth, 0.5 * kThrowPlate - lowest(pair, sample.body));
    how.has_passed = how.has_passed || sample.body.position.z() < -0.5 * kThrowPlate;
    how.has_touched = how.has_touched || sample.touching > 0;
  };
  const LedRun run = run_led(config, hand, look);
  how.is_fault = run.summary.end == SessionEnd::fault;
  how.frames = run.frames;
  how.held_back = run.held_back;
  return how;
}

void add_throw(const Throw& one, const Thrown& how, ThrowCount& count) {
  const auto rate = static_cast<std::size_t>(
      std::find(kThrowEvery.begin(), kThrowEvery.end(), one.every) - kThrowEvery.begin());
  ++count.thrown[rate];
  count.passed[rate] += how.has_passed;
  count.entered[rate] += how.depth > 0.0;
  count.faults[rate] += how.is_fault;
  count.held_back += how.held_back;
  count.frames += how.frames;
  count.touched += how.has_touched;
  count.depth = std::max(count.depth, how.depth);
}

std::int64_t total(const std::array<std::int64_t, 4>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

}  // namespace thigma::experiments
