// Protocol E5 (docs/sources.md): how an object lags behind the hand in the air, for masses, gains
// and integrators, and what mass is felt.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/coupled_run.h"
#include "experiments/common/statistics.h"

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace e5_free_space {
namespace {

constexpr double kPi = 3.14159265358979323846, kPeriod = 1e-3;
constexpr double kLength = 0.20, kGyration = 0.0066;  // of the spoon of Fig. 5.6 [m]

struct Gains {
  double linear, angular;
};

CoupledSetup spoon(double mass, const Gains& gains, Integrator integrator) {
  CoupledSetup setup;
  const double along = kGyration * kGyration;
  const double across = kLength * kLength / 12.0 + 0.5 * along;
  setup.body = make_body(mass, mass * Vec3(along, across, across).asDiagonal().toDenseMatrix());
  setup.coupling.linear_stiffness = gains.linear;
  setup.coupling.linear_damping = 2.0 * std::sqrt(gains.linear * mass);
  setup.coupling.angular_stiffness = gains.angular;
  setup.coupling.angular_damping = 2.0 * std::sqrt(gains.angular * mass * across);
  setup.integrator = integrator;
  setup.period = kPeriod;
  return setup;
}

/// Three sines of 0.5 to 4 Hz, 60 mm and 40 degrees at most, from rest.
std::vector<Motion> wandering() {
  std::vector<Pose> poses;
  for (int i = 0; i <= 2500; ++i) {
    const double t = i * kPeriod, u = std::clamp(t / 0.3, 0.0, 1.0);
    const double f = u * u * (3.0 - 2.0 * u);
    const auto mixed = [&](double a, double b, double c) {
      return f / 3.0 *
             (sine(2.0 * kPi * a * t) + sine(2.0 * kPi * b * t) + sine(2.0 * kPi * c * t));
    };
    Pose pose;
    pose.position = 0.060 * Vec3(mixed(0.5, 1.7, 4.0), mixed(0.8, 2.3, 3.1), mixed(0.6, 1.1, 3.7));
    pose.orientation = rotation_from_vector(
        0.698 * Vec3(mixed(0.5, 1.3, 2.9), mixed(0.7, 1.9, 3.3), mixed(0.9, 1.5, 4.0)));
    poses.push_back(pose);
  }
  return motion_along(poses, kPeriod);
}

void run_table(Outcome& outcome) {
  const std::vector<Motion> hand = wandering();
  for (const Gains& gains : {Gains{200.0, 0.6}, Gains{2000.0, 10.0}}) {
    for (const Integrator integrator :
         {Integrator::forward_euler, Integrator::runge_kutta, Integrator::implicit_tangent}) {
      plot::Series line{.label = integrator == Integrator::forward_euler ? "FE"
                                 : integrator == Integrator::runge_kutta ? "RK4"
                                                                         : "BE",
                        .mark = plot::Mark::line_and_points};
      line.label += gains.linear < 1000.0 ? ", 200 N/m" : ", 2 kN/m";
      for (const double mass : {1e-4, 1e-3, 0.010, 0.070, 0.100}) {
        const auto frames = run_coupled(spoon(mass, gains, integrator), hand);
        double stretch = 0.0, turn = 0.0, force = 0.0, square = 0.0;
        for (const CoupledFrame& f : frames) {
          stretch = std::max(stretch, f.stretch);
          turn = std::max(turn, f.turn);
          force = std::max(force, f.coupling.force.norm());
          square += f.stretch * f.stretch;
        }
        const bool is_whole = frames.size() == hand.size() && turn < 0.5;
        add_row(outcome.tables[0],
                {line.label, gains.linear, gains.angular, mass, is_whole ? 1.0 : 0.0, stretch,
                 std::sqrt(square / static_cast<double>(std::max<std::size_t>(frames.size(), 1))),
                 turn, force});
        if (!is_whole) continue;
        line.x.push_back(1e3 * mass);
        line.y.push_back(1e3 * stretch);
      }
      outcome.figure.panels[0].series.push_back(line);
    }
  }
}

/// Largest distance of the lag under constant acceleration from (m - b T / 2) a / k_c, over it: a
/// backward Euler step's velocity is half a frame behind that of the position it makes, and the
/// damper pulls by as much.
double constant_acceleration() {
  constexpr double kAcceleration = 0.5;  // [m/s^2]
  double worst = 0.0;
  for (const double mass : {1e-3, 0.010, 0.100}) {
    std::vector<Motion> hand(1000);
    for (std::size_t i = 0; i < hand.size(); ++i) {
      const double t = static_cast<double>(i) * kPeriod;
      hand[i].pose.position.x() = 0.5 * kAcceleration * t * t;
      hand[i].twist.linear.x() = kAcceleration * t;
    }
    const auto frames = run_coupled(spoon(mass, {200.0, 0.6}, Integrator::implicit_tangent), hand);
    const double damping = 2.0 * std::sqrt(200.0 * mass);
    const double expected = (mass - 0.5 * damping * kPeriod) * kAcceleration / 200.0;
    worst = std::max(worst, std::fabs(frames.back().stretch / expected - 1.0));
  }
  return worst;
}

/// F_c / a over a sine of the handle, as root mean squares over whole periods.
double apparent_mass(double mass, double hertz) {
  const int settle = 1000, periods = std::max(2, static_cast<int>(std::lround(hertz)));
  const int frames = settle + static_cast<int>(std::lround(periods / hertz / kPeriod));
  const double omega = 2.0 * kPi * hertz, swing = 1.0 / (omega * omega);
  std::vector<Motion> hand(static_cast<std::size_t>(frames));
  std::vector<double> acceleration, force;
  for (int i = 0; i < frames; ++i) {
    const SinCos s = sin_cos(omega * i * kPeriod);
    hand[static_cast<std::size_t>(i)].pose.position.x() =
        swing * s.sin - swing * omega * i * kPeriod;
    hand[static_cast<std::size_t>(i)].twist.linear.x() = swing * omega * (s.cos - 1.0);
    if (i >= settle) acceleration.push_back(s.sin);
  }
  const auto run = run_coupled(spoon(mass, {200.0, 0.6}, Integrator::implicit_tangent), hand);
  for (std::size_t i = static_cast<std::size_t>(settle); i < run.size(); ++i)
    force.push_back(run[i].coupling.force.x());
  return root_mean_square(force) / root_mean_square(acceleration);
}

/// |m (k + b s) / (m s^2 + b s + k)| at s = i omega.
double analytic_mass(double mass, double hertz) {
  const double omega = 2.0 * kPi * hertz, k = 200.0, b = 2.0 * std::sqrt(k * mass);
  const double top = std::hypot(k, b * omega);
  return mass * top / std::hypot(k - mass * omega * omega, b * omega);
}

}  // namespace
}  // namespace e5_free_space

Outcome run_e5_free_space(const Context&) {
  using namespace e5_free_space;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"run", "k_c [N/m]", "k_theta [N m/rad]", "mass [kg]", "whole",
                   "largest deviation [m]", "rms deviation [m]", "largest rotation [rad]",
                   "largest force [N]"}},
      {.name = "apparent_mass",
       .columns = {"mass [kg]", "frequency [Hz]", "apparent mass [kg]", "analytic [kg]"}}};
  outcome.figure = {.title = "Free space (protocol E5)",
                    .panels = {{.x = {.label = "mass [g]", .is_log = true},
                                .y = {.label = "largest deviation [mm]", .is_log = true}},
                               {.x = {.label = "frequency [Hz]", .is_log = true},
                                .y = {.label = "apparent mass over mass"}}}};
  run_table(outcome);
  double worst = 0.0, worst_20 = 0.0, felt = 0.0;
  for (const double mass : {0.010, 0.100}) {
    plot::Series line{.label = mass < 0.05 ? "10 g" : "100 g", .mark = plot::Mark::line_and_points};
    for (const double hertz : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) {
      const double found = apparent_mass(mass, hertz), exact = analytic_mass(mass, hertz);
      add_row(outcome.tables[1], {mass, hertz, found, exact});
      double& most = hertz > 10.0 ? worst_20 : worst;
      most = std::max(most, std::fabs(found / exact - 1.0));
      if (mass < 0.05 && hertz <= 5.0) felt = std::max(felt, std::fabs(found / mass - 1.0));
      line.x.push_back(hertz);
      line.y.push_back(found / mass);
    }
    outcome.figure.panels[1].series.push_back(line);
  }
  outcome.claims = {
      at_most("acceleration", "lag under constant acceleration against (m - b T / 2) a / k_c",
              constant_acceleration(), 1e-3),
      at_most("apparent", "apparent mass at 0.5 to 10 Hz against the analytic one", worst, 0.05),
      stated("apparent-20", "the same at 20 Hz, where backward Euler shows", worst_20),
      at_most("felt", "apparent mass of 10 g up to 5 Hz against 10 g", felt, 0.05)};
  return outcome;
}

}  // namespace thigma::experiments
