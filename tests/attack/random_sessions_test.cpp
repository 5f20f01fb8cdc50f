// Random sessions whose devices, threads and faults do as they please: whatever comes, forces stay
// within the limits, a fault is zero force until the end, and the recording replays to the same
// bits. Some here; THIGMA_SESSIONS=COUNT runs so many, and goes on from the number in the file
// THIGMA_SESSIONS_STATE.

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "attack/cases.h"
#include "attack/wild_device.h"
#include "experiments/common/outside_depth.h"
#include "support/mesh_session.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/recording/replay_session.h"
#include "thigma/session/session_config.h"

namespace thigma::test {
namespace {

struct Tally {
  int run = 0, armed = 0, touched = 0, resumed = 0;
  std::array<int, 9> faults{};  // by Fault
  double deepest = 0.0;         // under constraints [m]
};

/// What the sessions are of: a cube on a plane without a mesh, or a ball on a box with rows.
struct Things {
  ClodHierarchy ball, box;
  experiments::DepthSurface ball_depth, box_depth;

  Things() {
    const TriangleMesh small = make_ball(0.015, 3);
    TriangleMesh large = make_box({0.12, 0.12, 0.02}, {6, 6, 1});
    for (Vec3& p : large.positions) p.z() -= 0.01;  // its top is z = 0
    ball = build_exact_hierarchy(small);
    box = build_exact_hierarchy(large);
    ball_depth = experiments::make_depth_surface(small);
    box_depth = experiments::make_depth_surface(large);
  }
};

const Things& things() {
  static const Things all;
  return all;
}

SessionConfig config_of(Random& random, bool is_constrained) {
  SessionConfig config = plane_session();
  if (is_constrained) {
    config.contact.source = nullptr;
    config.contact.object = &things().ball;
    config.contact.scene = {{&things().box, Pose{}}};
    config.contact.tolerance = 1.5e-4;
    config.world_from_body.position = {0.0, 0.0, 0.015 + 0.005};
    use_constraints(config);
  }
  const double stiffness = random.uniform(50.0, 800.0);
  config.haptic.coupling.linear_stiffness = stiffness;
  config.haptic.coupling.linear_damping =
      1.4 * std::sqrt(stiffness * config.haptic.body.mass) * random.uniform(0.5, 1.5);
  config.rate = std::array{1000.0, 1000.0, 333.0, 3000.0}[random.below(4)];
  config.duration = random.uniform(0.6, 1.8);
  config.contact_every = std::array{1, 1, 3, 10, 33}[random.below(5)];
  config.contact_latency = 1 + static_cast<int>(random.below(5));
  SafetyLimits& safety = config.haptic.safety;
  if (random.below(2) == 0) safety.max_force = random.uniform(0.1, 10.0);
  if (random.below(4) == 0) safety.max_torque = random.uniform(0.0, 0.1);
  safety.start_ramp = random.uniform(0.0, 0.3);
  safety.rides_out_gaps = random.below(4) == 0;
  config.haptic.resumes_lost_device = random.below(4) == 0;
  const std::uint64_t count = random.below(3);
  for (std::uint64_t i = 0; i < count; ++i) {
    FaultEvent fault;
    fault.kind = static_cast<InjectedFault>(random.below(4));
    fault.time = random.uniform(random.below(4) == 0 ? 0.0 : 0.5, 1.0) * config.duration;
    fault.duration = random.uniform(0.0, random.below(2) == 0 ? 0.02 : 0.4);
    config.faults.push_back(fault);
  }
  return config;
}

HandParams hand_of(Random& random) {
  constexpr std::array kPaths = {HandPath::press, HandPath::slide, HandPath::tap, HandPath::demo,
                                 HandPath::circle};
  HandParams hand = plane_hand(kPaths[random.below(kPaths.size())]);
  hand.program.speed *= random.uniform(1.0, 6.0);
  hand.max_force = random.uniform(0.5, 20.0);
  hand.actuates_rotation = random.below(3) != 0;
  hand.senses_rotation = hand.actuates_rotation || random.below(2) == 0;
  hand.tremor = random.below(2) == 0 ? 0.0 : 5e-5;
  hand.delay = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.005);
  hand.seed = random.next();
  return hand;
}

/// What holds at every frame.
class FrameRules {
 public:
  FrameRules(const SessionConfig& config, const DeviceLimits& device, bool is_constrained)
      : config_(config), is_constrained_(is_constrained) {
    most_force_ = std::min(config.haptic.safety.max_force, device.max_force) * (1.0 + 1e-9);
    most_torque_ = std::min(config.haptic.safety.max_torque, device.max_torque) * (1.0 + 1e-9);
  }

  void look(const HapticSample& s) {
    SCOPED_TRACE("frame " + std::to_string(s.frame));
    const double force = s.command.force.norm(), torque = s.command.torque.norm();
    ASSERT_TRUE(force <= most_force_) << force;
    ASSERT_TRUE(torque <= most_torque_) << torque;
    ASSERT_TRUE(s.body.position.allFinite() && s.body.orientation.coeffs().allFinite());
    ASSERT_TRUE(s.body.linear_momentum.allFinite() && s.body.angular_momentum.allFinite());
    ASSERT_NEAR(s.body.orientation.norm(), 1.0, 1e-9);
    ASSERT_TRUE(std::isfinite(s.energy));
    if (s.fault != Fault::none || !s.is_armed) {
      ASSERT_EQ(force, 0.0);
      ASSERT_EQ(torque, 0.0);
    }
    if (latched_ != Fault::none && s.fault != latched_) {
      ASSERT_TRUE(config_.haptic.resumes_lost_device && latched_ == Fault::device_lost);
      was_resumed = true;
    }
    latched_ = s.fault;
    was_armed = was_armed || s.is_armed;
    has_touched = has_touched || s.touching > 0;
    if (!is_constrained_ || s.frame % 50 != 0) return;
    deepest = std::max(deepest, experiments::outside_depth(
                                    things().ball_depth, Pose{s.body.position, s.body.orientation},
                                    things().box_depth, 4));
  }

  Fault latched() const { return latched_; }
  bool was_armed = false, has_touched = false, was_resumed = false;
  double deepest = 0.0;

 private:
  const SessionConfig& config_;
  bool is_constrained_;
  double most_force_ = 0.0, most_torque_ = 0.0;
  Fault latched_ = Fault::none;
};

void attack(std::uint64_t number, Tally& tally) {
  Random random(0x73657373 + number);
  const bool is_constrained = random.below(3) == 0;
  const SessionConfig config = config_of(random, is_constrained);
  const HandParams hand = hand_of(random);
  WildDevice device(hand, random, static_cast<std::uint64_t>(config.duration * config.rate));
  FrameRules rules(config, device.limits(), is_constrained);
  HapticParams params = config.haptic;
  use_device_limits(device.limits(), params);
  SessionReplay replay(params, config.world_from_body);
  SessionSinks sinks;
  sinks.haptic = [&](const HapticSample& s) {
    rules.look(s);
    replay.add(s);
  };
  sinks.contact = [&](const ContactSample& s) { replay.add(s); };
  const SessionSummary summary = run_lockstep(config, device, sinks);
  EXPECT_EQ(device.written().force.norm(), 0.0) << "the last thing a device hears";
  EXPECT_EQ(device.written().torque.norm(), 0.0);
  const ReplayReport again = replay.finish();
  EXPECT_TRUE(again.identical) << again.first_difference << ' ' << again.reason;
  EXPECT_EQ(again.state_hash, summary.state_hash);
  EXPECT_EQ(summary.end == SessionEnd::fault,
            rules.latched() != Fault::none && !is_resumable(params, rules.latched()));
  EXPECT_LE(rules.deepest, 1.5e-5) << "a thousandth of the radius";
  ++tally.run;
  tally.armed += rules.was_armed;
  tally.touched += rules.has_touched;
  tally.resumed += rules.was_resumed;
  ++tally.faults[static_cast<std::size_t>(rules.latched())];
  tally.deepest = std::max(tally.deepest, rules.deepest);
}

TEST(RandomSessions, KeepForcesWithinLimitsEndFaultsInZeroAndReplay) {
  const Cases cases("THIGMA_SESSIONS", 600);
  Tally tally;
  for (std::uint64_t number = cases.first; number < cases.end; ++number) {
    SCOPED_TRACE("session " + std::to_string(number));
    attack(number, tally);
    if ((number + 1) % 100 == 0) cases.done(number + 1);
    if (!cases.is_asked && ::testing::Test::HasFailure()) break;
  }
  std::printf("%d sessions, %d armed, %d in contact, %d resumed; deepest %.2g m\n", tally.run,
              tally.armed, tally.touched, tally.resumed, tally.deepest);
  for (std::size_t i = 0; i < tally.faults.size(); ++i)
    std::printf("  ended with %s: %d\n", fault_name(static_cast<Fault>(i)), tally.faults[i]);
  if (cases.count() < 500) return;
  EXPECT_GT(tally.armed, tally.run / 3);
  EXPECT_GT(tally.touched, tally.run / 3);
  for (std::size_t i = 0; i < tally.faults.size(); ++i)
    EXPECT_GT(tally.faults[i], 0) << fault_name(static_cast<Fault>(i)) << " never came about";
}

}  // namespace
}  // namespace thigma::test
