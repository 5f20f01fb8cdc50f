// Protocol E6 (docs/sources.md): steps of the handle into a wall, and taps of the simulated hand.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/coupled_run.h"

#include "thigma/device/hand.h"

namespace thigma::experiments {
namespace e6_impact {
namespace {

constexpr double kPeriod = 1e-3, kMass = 0.010, kMoment = 1e-6;
constexpr double kCoupling = 480.0, kContact = 6000.0;  // as `tune` proposes for 10 g [N/m]
constexpr double kTolerance = 2e-4, kGap = 0.005;       // [m]

double critical(double stiffness, double mass) { return 2.0 * std::sqrt(stiffness * mass); }

ContactWorld wall() {
  ContactWorld world;
  world.source = point_on_floor;
  world.capacity = 4;
  world.tolerance = kTolerance;
  world.response = {.stiffness = kContact, .damping = critical(kContact, kMass)};
  return world;
}

Coupling coupling() {
  Coupling c;
  c.linear_stiffness = kCoupling;
  c.linear_damping = critical(kCoupling, kMass);
  c.angular_stiffness = 0.18;
  c.angular_damping = critical(0.18, kMoment);
  return c;
}

/// What one step into the wall was like.
struct Step {
  double final = 0.0, rise = 0.0, overshoot = 0.0, settling = 0.0, penetration = 0.0;
  double hardness = 0.0, restitution = 0.0;
  double latency = 0.0;  // frames from the first within the tolerance to the first with a force
};

Step step_in(double depth, double speed, plot::Series& force_line) {
  CoupledSetup setup;
  setup.body = make_body(kMass, kMoment * Mat3::Identity());
  setup.coupling = coupling();
  setup.contact = wall();
  setup.start.position.z() = kGap;
  setup.start.linear_momentum.z() = -kMass * speed;
  std::vector<Motion> hand(1500);
  for (std::size_t i = 0; i < hand.size(); ++i) {
    const double z = kGap - speed * kPeriod * static_cast<double>(i + 1);
    const bool is_there = z <= -depth;
    hand[i].pose.position.z() = is_there ? -depth : z;
    hand[i].twist.linear.z() = is_there ? 0.0 : -speed;
  }
  const auto frames = run_coupled(setup, hand);
  Step s;
  std::vector<double> force;
  for (const CoupledFrame& f : frames) force.push_back(f.coupling.force.norm());
  s.final = force.back();
  std::size_t near = frames.size(), felt = frames.size(), rise_10 = 0, rise_90 = 0;
  double out = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double z = frames[i].body.position.z();
    if (near == frames.size() && z < kTolerance) near = i;
    if (felt == frames.size() && frames[i].contact.force.norm() > 0.0) felt = i;
    s.penetration = std::max(s.penetration, -z);
    if (rise_10 == 0 && force[i] > 0.1 * s.final) rise_10 = i;
    if (rise_90 == 0 && force[i] > 0.9 * s.final) rise_90 = i;
    if (std::fabs(force[i] - s.final) > 0.02 * s.final) s.settling = static_cast<double>(i);
    if (felt < frames.size() && i < felt + 30)
      out = std::max(out, frames[i].body.linear_momentum.z() / kMass);
    if (felt < i && i < felt + 20)
      s.hardness = std::max(s.hardness, (force[i] - force[i - 1]) / kPeriod / speed);
    force_line.x.push_back(1e3 * (static_cast<double>(i) - static_cast<double>(near)) * kPeriod);
    force_line.y.push_back(force[i]);
  }
  s.rise = kPeriod * static_cast<double>(rise_90 - rise_10);
  s.overshoot = *std::max_element(force.begin(), force.end()) / s.final - 1.0;
  s.settling = kPeriod * (s.settling - static_cast<double>(near));
  s.restitution = out / speed;
  s.latency = static_cast<double>(felt) - static_cast<double>(near);
  force_line.x.resize(std::min<std::size_t>(force_line.x.size(), near + 150));
  force_line.y.resize(force_line.x.size());
  return s;
}

/// Taps of the simulated hand: the largest force of each.
std::vector<double> taps(double seconds) {
  HandParams params;
  params.program.path = HandPath::tap;
  params.program.clearance = kGap;
  params.program.speed = 0.02;
  HandDevice hand(params);
  SessionConfig config;
  config.haptic.body = make_body(kMass, kMoment * Mat3::Identity());
  config.haptic.coupling = coupling();
  config.haptic.device = hand.limits();
  config.contact = wall();
  config.world_from_body.position.z() = kGap;
  config.duration = seconds;
  std::vector<double> peaks;
  int free = 100;
  run_lockstep(config, hand,
               {.haptic =
                    [&](const HapticSample& s) {
                      if (s.touching == 0) {
                        ++free;
                        return;
                      }
                      // A chatter is not a tap.
                      if (free >= 30) peaks.push_back(0.0);
                      free = 0;
                      peaks.back() = std::max(peaks.back(), s.command.force.norm());
                    },
                .contact = {},
                .event = {}});
  return peaks;
}

}  // namespace
}  // namespace e6_impact

Outcome run_e6_impact(const Context& context) {
  using namespace e6_impact;
  Outcome outcome;
  outcome.tables = {{.columns = {"step [m]", "speed [m/s]", "final force [N]", "rise [s]",
                                 "overshoot", "settling [s]", "penetration [m]",
                                 "rate-hardness [N/m]", "restitution", "latency [frames]"}},
                    {.name = "taps", .columns = {"tap", "largest force [N]"}}};
  outcome.figure = {.title = "Steps into a wall (protocol E6)",
                    .note = "10 g, k_c = 480 N/m, k = 6 kN/m, 1 kHz; handle moved, not held",
                    .panels = {{.x = {.label = "time since the tolerance [ms]"},
                                .y = {.label = "coupling force [N]"}},
                               {.x = {.label = "tap"}, .y = {.label = "largest force [N]"}}}};
  double restitution = 0.0, latency = 0.0, least_hardness = 1e300, hold = 0.0;
  const double series = kCoupling * kContact / (kCoupling + kContact);
  for (const double depth : {0.005, 0.020, 0.050}) {
    for (const double speed : {0.05, 0.2, 0.5, 1.0}) {
      plot::Series line{.label = std::to_string(speed).substr(0, 4) + " m/s"};
      const Step s = step_in(depth, speed, line);
      add_row(outcome.tables[0], {depth, speed, s.final, s.rise, s.overshoot, s.settling,
                                  s.penetration, s.hardness, s.restitution, s.latency});
      restitution = std::max(restitution, s.restitution);
      latency = std::max(latency, s.latency);
      least_hardness = std::min(least_hardness, s.hardness / series);
      const double expected = series * (depth + kTolerance);
      hold = std::max(hold, std::fabs(s.final / expected - 1.0));
      if (depth == 0.005) outcome.figure.panels[0].series.push_back(line);
    }
  }
  const std::vector<double> peaks = taps(context.quick ? 5.0 : 10.0);
  plot::Series bars{.mark = plot::Mark::points};
  double early = 0.0, late = 0.0;
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    add_row(outcome.tables[1], {static_cast<double>(i), peaks[i]});
    bars.x.push_back(static_cast<double>(i));
    bars.y.push_back(peaks[i]);
    (2 * i < peaks.size() ? early : late) = std::max(2 * i < peaks.size() ? early : late, peaks[i]);
  }
  outcome.figure.panels[1].series.push_back(bars);
  outcome.claims = {
      at_most("final", "held force against both springs in series", hold, 0.01),
      at_most("latency", "frames from within the tolerance to a contact force", latency, 2.0),
      at_most("restitution", "speed back over speed in, the largest", restitution, 0.5),
      at_least("hardness", "least rate-hardness over the stiffness of both springs in series",
               least_hardness, 0.9),
      at_most("taps", "hardest tap of the second half over that of the first", late / early, 1.2),
      at_least("tapped", "taps", static_cast<double>(peaks.size()), 3.0)};
  return outcome;
}

}  // namespace thigma::experiments
