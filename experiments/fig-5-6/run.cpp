// Fig. 5.6: a spoon in free space on a virtual coupling; which masses each integrator bears, and
// how far it lags.

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/all_experiments.h"
#include "experiments/common/coupled_run.h"
#include "experiments/common/statistics.h"

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace fig_5_6 {
namespace {

// Length and gains of Sec. 5.5.2. The text gives no inertia; docs/sources.md, E5.
constexpr double kLength = 0.20, kGyration = 0.0066, kArm = 0.08;  // [m]
constexpr double kLinear = 200.0, kAngular = 0.6;                  // [N/m, N m/rad]
constexpr double kAngularDamping = 8.94e-3;                        // [N m s/rad]
constexpr double kPi = 3.14159265358979323846;
constexpr double kPeriod = 1e-3, kSeconds = 2.5;
// rotation of the object against the hand that is no lag any more [rad]
constexpr double kLost = 2.0;

Pose hand_pose(double t) {
  const double u = std::clamp(t / 0.3, 0.0, 1.0);
  const double f = u * u * (3.0 - 2.0 * u);
  const auto wave = [t](double hertz) { return sine(2.0 * kPi * hertz * t); };
  Pose pose;
  pose.position =
      0.1 * f * Vec3(wave(2.9), 0.4 * wave(1.7), 0.3 * wave(2.1)) + Vec3(kArm, 0.0, 0.0);
  pose.orientation =
      rotation_from_vector(f * Vec3(0.3 * wave(1.3), 0.4 * wave(0.9), 0.4 * wave(1.1)));
  return pose;
}

std::vector<Motion> hand_motion() {
  std::vector<Pose> poses;
  const int frames = static_cast<int>(std::lround(kSeconds / kPeriod));
  for (int i = 0; i <= frames; ++i) poses.push_back(hand_pose(i * kPeriod));
  return motion_along(poses, kPeriod);
}

CoupledSetup spoon(double mass, Integrator integrator) {
  CoupledSetup setup;
  const double along = kGyration * kGyration;
  const double across = kLength * kLength / 12.0 + 0.5 * along;
  setup.body = make_body(mass, mass * Vec3(along, across, across).asDiagonal().toDenseMatrix());
  setup.coupling.linear_stiffness = kLinear;
  setup.coupling.linear_damping = 2.0 * std::sqrt(kLinear * mass);
  setup.coupling.angular_stiffness = kAngular;
  setup.coupling.angular_damping = kAngularDamping;
  setup.coupling.body_from_grasp.position = {kArm, 0.0, 0.0};
  setup.integrator = integrator;
  setup.period = kPeriod;
  return setup;
}

struct Ran {
  bool is_stable = false;
  std::vector<CoupledFrame> frames;
  double stretch = 0.0, force = 0.0;  // largest
};

Ran run(double mass, Integrator integrator, const std::vector<Motion>& hand) {
  Ran ran;
  ran.frames = run_coupled(spoon(mass, integrator), hand);
  ran.is_stable = ran.frames.size() == hand.size();
  for (const CoupledFrame& f : ran.frames) {
    ran.is_stable = ran.is_stable && f.turn < kLost;
    ran.stretch = std::max(ran.stretch, f.stretch);
    ran.force = std::max(ran.force, f.coupling.force.norm());
  }
  return ran;
}

/// Least mass that an explicit integrator bears [kg].
double threshold(Integrator integrator, const std::vector<Motion>& hand) {
  double low = 0.010, high = 0.200;
  while (high > 1.002 * low) {
    const double middle = 0.5 * (low + high);
    (run(middle, integrator, hand).is_stable ? high : low) = middle;
  }
  return high;
}

plot::Series line(const std::string& label, const Ran& ran, double CoupledFrame::*value,
                  double scale) {
  plot::Series series{.label = label};
  for (std::size_t i = 0; i < ran.frames.size(); i += 5) {
    series.x.push_back(static_cast<double>(i) * kPeriod);
    series.y.push_back(scale * (ran.frames[i].*value));
  }
  return series;
}

const char* name(Integrator integrator) {
  if (integrator == Integrator::forward_euler) return "forward Euler";
  return integrator == Integrator::runge_kutta ? "Runge-Kutta" : "backward Euler";
}

}  // namespace
}  // namespace fig_5_6

Outcome run_fig_5_6(const Context&) {
  using namespace fig_5_6;
  Outcome outcome;
  outcome.tables = {{.columns = {"integrator", "mass [kg]", "stable", "largest deviation [m]",
                                 "largest force [N]"}}};
  outcome.figure = {
      .title = "Free-space motion of a spoon (Fig. 5.6)",
      .note = "k_c = 200 N/m, k_theta = 0.6 N m/rad, b_c critical at each mass, b_theta fixed",
      .panels = {{.x = {.label = "time [s]"}, .y = {.label = "deviation [mm]"}},
                 {.x = {.label = "time [s]"}, .y = {.label = "deviation [mm]", .is_log = true}},
                 {.x = {.label = "mass [g]", .is_log = true},
                  .y = {.label = "largest deviation [mm]", .is_log = true}}}};
  const std::vector<Motion> hand = hand_motion();
  const auto add = [&](double mass, Integrator integrator) {
    Ran ran = run(mass, integrator, hand);
    add_row(outcome.tables[0],
            {name(integrator), mass, ran.is_stable ? 1.0 : 0.0, ran.stretch, ran.force});
    return ran;
  };
  const Ran fe = add(0.100, Integrator::forward_euler);
  const Ran rk = add(0.070, Integrator::runge_kutta);
  std::vector<double> masses, deviations;
  Ran ten, hundred;
  bool is_light_stable = true;
  for (const double mass : {1e-4, 1e-3, 2e-3, 5e-3, 0.010, 0.020, 0.050, 0.100}) {
    Ran ran = add(mass, Integrator::implicit_tangent);
    if (mass <= 1e-3) is_light_stable = is_light_stable && ran.is_stable;
    if (mass >= 1e-3) {
      masses.push_back(1e3 * mass);
      deviations.push_back(1e3 * ran.stretch);
    }
    if (mass == 0.010) ten = ran;
    if (mass == 0.100) hundred = ran;
    if (mass == 1e-3 || mass == 0.010 || mass == 0.100) {
      const std::string label = "BE " + std::to_string(static_cast<int>(1e3 * mass + 0.5)) + " g";
      outcome.figure.panels[0].series.push_back(line(label, ran, &CoupledFrame::stretch, 1e3));
      outcome.figure.panels[1].series.push_back(line(label, ran, &CoupledFrame::stretch, 1e3));
    }
  }
  outcome.figure.panels[0].series.push_back(line("RK4 70 g", rk, &CoupledFrame::stretch, 1e3));
  outcome.figure.panels[0].series.push_back(line("FE 100 g", fe, &CoupledFrame::stretch, 1e3));
  outcome.figure.panels[2].series.push_back(
      {.label = "BE", .x = masses, .y = deviations, .mark = plot::Mark::line_and_points});
  const double euler = 1e3 * threshold(Integrator::forward_euler, hand);
  const double kutta = 1e3 * threshold(Integrator::runge_kutta, hand);
  outcome.claims = {
      within("forward-euler",
             "least mass that forward Euler bears (source: 100 g, to which the spoon's gyration is "
             "fitted)",
             euler, 95.0, 104.0, "g"),
      within("runge-kutta",
             "least mass that Runge-Kutta bears, with the same gyration (source: 70 g)", kutta,
             69.0, 76.0, "g"),
      at_least("backward-euler", "backward Euler is stable at 1 g and 0.1 g (source: 1 g)",
               is_light_stable ? 1.0 : 0.0, 1.0),
      within("ratio", "largest deviation at 100 g over that at 10 g", hundred.stretch / ten.stretch,
             8.0, 13.0),
      at_most("ten-grams", "largest deviation at 10 g (source: below 2 mm)", 1e3 * ten.stretch, 2.0,
              "mm"),
      stated("exponent", "deviation grows as mass to this power, 1 to 100 g (source: linear)",
             fit_power(masses, deviations).slope),
      stated("hundred-grams", "largest deviation at 100 g (source: 17 mm)", 1e3 * hundred.stretch,
             "mm"),
      stated("force-ten", "largest coupling force at 10 g (source: below 0.5 N)", ten.force, "N"),
      stated("force-hundred", "at 100 g (source: 3.5 N)", hundred.force, "N")};
  return outcome;
}

}  // namespace thigma::experiments
