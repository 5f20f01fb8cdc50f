// Gains from limits. All stiffnesses are computed in device space, with the object's mass brought
// there: what the device is compared with is what the hand feels.

#include "thigma/dynamics/gains.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <Eigen/Eigenvalues>

#include "thigma/core/error.h"
#include "thigma/dynamics/sampled_loop.h"

namespace thigma {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kPublishedPeriod = 1e-3;  // that maximum stiffnesses are published for [s]
constexpr double kLeastRatio = 0.3;        // damping ratio below which a spring is felt to ring
constexpr double kMostRatio = 1.8;         // and above which it drags
constexpr double kRounding = 1e-9;

/// Arms that may hold the handle: the lightest, the stiffest and one that brings a mass of its own.
struct Arm {
  double mass, stiffness, damping;
};
// docs/sources.md, E3; the last is the simulated hand's.
constexpr Arm kLinearArms[] = {
    {0.0, 100.0, 1.0}, {0.0, 500.0, 5.0}, {0.0, 1500.0, 15.0}, {0.15, 400.0, 8.0}};
constexpr Arm kAngularArms[] = {{0.0, 0.1, 0.002}, {0.0, 0.5, 0.01}, {2e-4, 0.5, 0.01}};

/// One half of the task in device space.
struct Half {
  const PortHalf* port = nullptr;
  const Arm* arms = nullptr;
  int arm_count = 0;
  double body_mass = 0.0;  // as the handle feels it
  double scale = 1.0;      // device stiffness per virtual stiffness
  double period = 0.0, delay = 0.0;
  bool is_held = false;  // a contact holds the object where it is, instead of a spring
};

Half linear_half(const GainTask& task) {
  const double scale = task.force_scale * task.motion_scale;
  return {&task.linear,
          kLinearArms,
          static_cast<int>(std::size(kLinearArms)),
          task.body.mass * scale,
          scale,
          1.0 / task.rate,
          task.delay,
          task.is_constrained};
}

double largest_moment(const RigidBody& body) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(body.inertia, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

Half angular_half(const GainTask& task) {
  const double scale = task.force_scale / task.motion_scale;
  return {&task.angular,
          kAngularArms,
          static_cast<int>(std::size(kAngularArms)),
          largest_moment(task.body) * scale,
          scale,
          1.0 / task.rate,
          task.delay,
          task.is_constrained};
}

double critical_damping(double stiffness, double mass) { return 2.0 * std::sqrt(stiffness * mass); }

/// Whether the loop with these gains (device space) settles with every arm, in the air and against
/// a contact.
bool does_settle(const Half& half, double stiffness, double damping) {
  const double contact = kGainMargin * half.body_mass / (half.period * half.period);
  SampledLoop loop{.period = half.period,
                   .delay = half.delay,
                   .handle_mass = half.port->mass,
                   .handle_damping = half.port->damping,
                   .body_mass = half.body_mass,
                   .coupling_stiffness = stiffness,
                   .coupling_damping = damping};
  for (int i = 0; i < half.arm_count; ++i) {
    loop.arm_mass = half.arms[i].mass;
    loop.arm_stiffness = half.arms[i].stiffness;
    loop.arm_damping = half.arms[i].damping;
    for (const bool is_in_contact : {false, true}) {
      const double k = is_in_contact && !half.is_held ? contact : 0.0;
      loop.contact_stiffness = k;
      loop.contact_damping = critical_damping(k, half.body_mass);
      loop.body_mass = is_in_contact && half.is_held ? kNoLimit : half.body_mass;
      if (!(loop_growth(loop) < 1.0)) return false;
    }
  }
  return true;
}

/// Largest stiffness (device space) that settles when critically damped; infinity when all that
/// matter do.
double loop_limit(const Half& half) {
  if (!(half.port->mass > 0.0)) return kNoLimit;
  const auto settles = [&](double k) {
    return does_settle(half, k, critical_damping(k, half.body_mass));
  };
  // Beyond a radian a frame of the handle itself nothing settles; 1e-6 of that is no spring any
  // more.
  double high = half.port->mass / (half.period * half.period);
  double low = 1e-6 * high;
  if (settles(high)) return kNoLimit;
  if (!settles(low)) return low;
  for (int i = 0; i < 20; ++i) {
    const double middle = std::sqrt(low * high);
    (settles(middle) ? low : high) = middle;
  }
  return low;
}

GainChoice choose(const Half& half, bool is_felt, bool has_frame_limit) {
  GainChoice choice;
  choice.limits.fill(kNoLimit);
  const auto limit = [&](GainLimit which) -> double& {
    return choice.limits[static_cast<std::size_t>(which)];
  };
  if (is_felt) {
    const PortHalf& port = *half.port;
    // b > K (T / 2 + delay): what a device bears at its published period it bears less of later
    // (docs/sources.md, E3, check 4).
    const double lateness = kPublishedPeriod / (half.period + 2.0 * half.delay);
    if (port.max_stiffness > 0.0)
      limit(GainLimit::device) = port.max_stiffness * std::min(lateness, 1.0);
    if (port.friction > 0.0 && port.encoder > 0.0)
      limit(GainLimit::friction) = 2.0 * port.friction / port.encoder;
    limit(GainLimit::loop) = loop_limit(half);
  }
  if (has_frame_limit) limit(GainLimit::frames) = half.body_mass / (half.period * half.period);
  const auto least = std::min_element(choice.limits.begin(), choice.limits.end());
  choice.binds = static_cast<GainLimit>(least - choice.limits.begin());
  for (double& each : choice.limits) each /= half.scale;
  choice.limit = *least;
  choice.stiffness = kGainMargin * choice.limit;
  choice.damping = critical_damping(choice.stiffness, half.body_mass / half.scale);
  return choice;
}

void require_positive(const char* what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  char text[120];
  std::snprintf(text, sizeof text, "gains: %s = %g, expected a number above 0", what, value);
  throw InputError(text);
}

std::string format(const char* pattern, double a, double b, const char* unit, const char* why) {
  char text[240];
  std::snprintf(text, sizeof text, pattern, a, unit, b, unit, why);
  return text;
}

/// Why a limit is one, for a person.
const char* reason(GainLimit limit) {
  switch (limit) {
    case GainLimit::device:
      return "what the device is published to render at this rate and delay";
    case GainLimit::friction:
      return "where the device's friction no longer swallows the steps of its encoders";
    case GainLimit::loop:
      return "where the loop of handle, samples and object begins to swing";
    case GainLimit::frames:
      return "a radian a frame, where contacts found a frame late throw the object back";
  }
  return "";
}

void check_stiffness(const char* name, const char* unit, double value, const GainChoice& choice,
                     std::vector<GainWarning>& warnings) {
  if (value <= choice.limit * (1.0 + kRounding)) return;
  warnings.push_back(
      {name, value, choice.limit,
       format("%.4g %s is above %.4g %s, %s", value, choice.limit, unit, reason(choice.binds))});
}

/// A spring with its damper: [N/m, N s/m] or [N m/rad, N m s/rad].
struct DampedSpring {
  double stiffness = 0.0, damping = 0.0;
};

void check_ratio(const char* name, const char* unit, const DampedSpring& spring, double mass,
                 std::vector<GainWarning>& warnings) {
  const double damping = spring.damping;
  const double critical = critical_damping(spring.stiffness, mass);
  if (!(critical > 0.0)) return;
  const double ratio = damping / critical;
  if (ratio < kLeastRatio * (1.0 - kRounding)) {
    warnings.push_back({name, damping, kLeastRatio * critical,
                        format("%.4g %s is below %.4g %s, %s", damping, kLeastRatio * critical,
                               unit, "0.3 of critical: it rings")});
  } else if (ratio > kMostRatio * (1.0 + kRounding)) {
    warnings.push_back({name, damping, kMostRatio * critical,
                        format("%.4g %s is above %.4g %s, %s", damping, kMostRatio * critical, unit,
                               "1.8 of critical: it drags")});
  }
}

void check_effort(const char* name, const char* unit, const std::optional<Saturation>& spring,
                  double device, std::vector<GainWarning>& warnings) {
  if (!spring || !(device > 0.0) || spring->max_force <= device * (1.0 + kRounding)) return;
  warnings.push_back({name, spring->max_force, device,
                      format("%.4g %s is above %.4g %s, %s", spring->max_force, device, unit,
                             "what the device can exert: it is cut before the spring levels off")});
}

/// Springs that are each within their limits may still swing together with dampings of their own.
void check_loop(const char* name, const Half& half, const DampedSpring& spring,
                const GainChoice& choice, std::vector<GainWarning>& warnings) {
  const auto [stiffness, damping] = spring;
  if (!(half.port->mass > 0.0) || stiffness > choice.limit) return;
  if (does_settle(half, stiffness * half.scale, damping * half.scale)) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "%.4g lets the loop swing at a stiffness of %.4g; critical: %.4g", damping,
                stiffness, critical_damping(stiffness, half.body_mass / half.scale));
  warnings.push_back(
      {name, damping, critical_damping(stiffness, half.body_mass / half.scale), text});
}

}  // namespace

const char* limit_name(GainLimit limit) noexcept {
  constexpr const char* kNames[kGainLimits] = {"device", "friction", "loop", "frames"};
  return kNames[static_cast<std::size_t>(limit)];
}

GainProposal propose_gains(const GainTask& task) {
  require_positive("mass", task.body.mass);
  require_positive("inertia", largest_moment(task.body));
  require_positive("rate", task.rate);
  require_positive("motion scale", task.motion_scale);
  require_positive("force scale", task.force_scale);
  if (!(task.delay >= 0.0) || !std::isfinite(task.delay))
    throw InputError("gains: delay is not a time of 0 or more");
  GainProposal proposal;
  const Half linear = linear_half(task), angular = angular_half(task);
  proposal.linear = choose(linear, true, true);
  proposal.angular = choose(angular, task.has_device_rotation, true);
  if (task.is_constrained)
    proposal.contact = {.limit = kNoLimit, .limits = {kNoLimit, kNoLimit, kNoLimit, kNoLimit}};
  else
    proposal.contact = choose(linear, false, true);
  proposal.max_force = task.linear.max_effort / task.force_scale;
  if (task.has_device_rotation)
    proposal.max_torque = task.angular.max_effort * task.motion_scale / task.force_scale;
  return proposal;
}

std::vector<GainWarning> check_gains(const GainTask& task, const GainProposal& proposal,
                                     const Coupling& coupling, double contact_stiffness,
                                     double contact_damping) {
  std::vector<GainWarning> warnings;
  const double mass = task.body.mass, moment = largest_moment(task.body);
  check_stiffness("linear_stiffness", "N/m", coupling.linear_stiffness, proposal.linear, warnings);
  check_stiffness("angular_stiffness", "N m/rad", coupling.angular_stiffness, proposal.angular,
                  warnings);
  if (!task.is_constrained)
    check_stiffness("stiffness", "N/m", contact_stiffness, proposal.contact, warnings);
  const DampedSpring linear{coupling.linear_stiffness, coupling.linear_damping},
      angular{coupling.angular_stiffness, coupling.angular_damping};
  check_ratio("linear_damping", "N s/m", linear, mass, warnings);
  check_ratio("angular_damping", "N m s/rad", angular, moment, warnings);
  if (!task.is_constrained)
    check_ratio("damping", "N s/m", {contact_stiffness, contact_damping}, mass, warnings);
  check_loop("linear_damping", linear_half(task), linear, proposal.linear, warnings);
  if (task.has_device_rotation)
    check_loop("angular_damping", angular_half(task), angular, proposal.angular, warnings);
  check_effort("max_force", "N", coupling.linear_saturation, proposal.max_force, warnings);
  check_effort("max_torque", "N m", coupling.angular_saturation, proposal.max_torque, warnings);
  return warnings;
}

}  // namespace thigma
