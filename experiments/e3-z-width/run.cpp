// Protocol E3 (docs/sources.md): where a sampled wall stops being stable and passive, beside what
// is exact, and how stiff the engine may be in the same hand.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/e3-z-width/engine_width.h"
#include "experiments/e3-z-width/wall.h"

#include "thigma/loop/passivity.h"

namespace thigma::experiments {
namespace e3_z_width {
namespace {

constexpr double kPeriod = 1e-3;

/// Device A without damping against a wall on both sides: the linear case.
double measured_boundary(double beta, int late, double exact, bool is_quick) {
  WallCase c{.hand = e3_device('A'),
             .wall = {.is_two_sided = true},
             .period = kPeriod,
             .seconds = is_quick ? 3.0 : 12.0};
  c.hand.damping = 0.0;
  c.hand.delay = late * kPeriod;
  c.wall.damping = beta * c.hand.mass / kPeriod;
  double low = 0.8 * exact, high = 1.2 * exact;
  for (int i = 0; i < (is_quick ? 8 : 12); ++i) {
    const double middle = 0.5 * (low + high);
    c.wall.stiffness = middle * c.hand.mass / (kPeriod * kPeriod);
    (growth(swing(c), c.seconds, c.period) < 1.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void run_boundary(const Context& context, Outcome& outcome) {
  outcome.tables.push_back(
      {.name = "boundary",
       .columns = {"delay [samples]", "beta", "exact alpha", "measured alpha", "error"}});
  double worst = 0.0;
  int points = 0;
  for (int late = 0; late <= 3; ++late) {
    plot::Series exact_line{.label = std::to_string(late) + " late, exact", .color = late};
    plot::Series found{.label = "measured", .mark = plot::Mark::points, .color = late};
    const double most = late == 0 ? 1.9 : late == 1 ? 0.7 : late == 2 ? 0.47 : 0.35;
    for (double beta = 0.02 * most; beta < most; beta += 0.02 * most) {
      exact_line.x.push_back(beta);
      exact_line.y.push_back(exact_boundary(beta, late));
    }
    const int count = late == 0 ? 10 : 5;
    for (int i = 0; i < count; ++i, ++points) {
      const double beta = most * (i + 0.7) / count;
      const double exact = exact_boundary(beta, late);
      const double measured = measured_boundary(beta, late, exact, context.quick);
      const double error = std::fabs(measured / exact - 1.0);
      worst = std::max(worst, std::isfinite(error) ? error : 1.0);
      add_row(outcome.tables.back(), {static_cast<double>(late), beta, exact, measured, error});
      found.x.push_back(beta);
      found.y.push_back(measured);
    }
    outcome.figure.panels[0].series.push_back(exact_line);
    outcome.figure.panels[0].series.push_back(found);
  }
  outcome.claims.push_back(at_least("points", "points on the boundary", points, 25.0));
  outcome.claims.push_back(at_most(
      "boundary", "largest distance of the measured boundary from the exact one", worst, 0.02));
}

/// Energy that the engine's own observer sees over the worst motion of a wall with B >= 0, damper
/// of the device included: to and fro at half the sampling rate.
double observed_energy(const Wall& wall, double device_damping) {
  EnergyObserver observer;
  constexpr double kSwing = 1e-3;
  double before = 0.0, damped = 0.0;
  Pose handle;
  constexpr int kTicks = 20001;
  for (int k = 0; k <= kTicks; ++k) {
    const double x = k == 0 || k == kTicks ? 0.0 : k % 2 == 0 ? kSwing : -kSwing;
    handle.position.x() = x;
    observe_motion(observer, handle);
    observe_wrench(observer,
                   {-Vec3(wall.stiffness * x + wall.damping * (x - before) / kPeriod, 0.0, 0.0),
                    Vec3::Zero()});
    damped += device_damping * (x - before) * (x - before) / kPeriod;
    before = x;
  }
  return observer.energy + damped;
}

void run_passivity(Outcome& outcome) {
  outcome.tables.push_back(
      {.name = "passivity",
       .columns = {"K [N/m]", "B [N s/m]", "bound [N s/m]", "passive at 1.001", "passive at 0.999",
                   "observed at 1.001 [J]", "observed at 0.999 [J]"}});
  int cases = 0, above = 0, below = 0, seen = 0, could_see = 0;
  for (const double K : {200.0, 500.0, 1000.0, 2000.0, 5000.0}) {
    for (const double B : {-0.5, 0.0, 0.2, 0.7, 2.0}) {
      const Wall wall{K, B, true};
      const double bound = 0.5 * K * kPeriod + std::fabs(B);
      const bool over = is_passive(wall, 1.001 * bound, kPeriod);
      const bool under = is_passive(wall, 0.999 * bound, kPeriod);
      const double high = observed_energy(wall, 1.001 * bound);
      const double low = observed_energy(wall, 0.999 * bound);
      ++cases;
      above += over ? 1 : 0;
      below += under ? 0 : 1;
      could_see += B >= 0.0 ? 1 : 0;
      seen += B >= 0.0 && high >= 0.0 && low < 0.0 ? 1 : 0;
      add_row(outcome.tables.back(), {K, B, bound, over ? 1.0 : 0.0, under ? 1.0 : 0.0, high, low});
    }
  }
  outcome.claims.push_back(at_least(
      "passive", "of 25 walls, those that no motion draws energy from at 1.001 of K T / 2 + |B|",
      above, cases));
  outcome.claims.push_back(
      at_least("active", "those that some motion draws energy from at 0.999 of it", below, cases));
  outcome.claims.push_back(at_least(
      "observed", "those with B >= 0 where the port's observer sees both signs in the worst motion",
      seen, could_see));
}

void run_z_width(const Context& context, Outcome& outcome) {
  Table& table = outcome.tables[0];
  const std::vector<char> devices =
      context.quick ? std::vector<char>{'B'} : std::vector<char>{'A', 'B', 'C'};
  const std::vector<double> periods =
      context.quick ? std::vector<double>{1e-3} : std::vector<double>{1e-2, 2e-3, 1e-3, 2e-4, 1e-4};
  const int steps = context.quick ? 4 : 12;
  for (const char letter : devices) {
    for (const double period : periods) {
      for (const double delay : {0.0, period, 0.015}) {
        if (context.quick && delay > period) continue;
        plot::Series line{.label = std::string(1, letter) + (delay == 0.0 ? "" : ", late"),
                          .mark = plot::Mark::line_and_points};
        for (const bool has_hand : {false, true}) {
          WallCase c;
          c.hand = e3_device(letter);
          c.period = period;
          c.push = 2.0;
          c.hand.delay = delay;
          if (has_hand) {  // held 10 mm inside
            c.hand.arm_stiffness = 500.0;
            c.hand.arm_damping = 5.0;
            c.hand.program.start.position.x() = 0.0;
            c.push = 5.0;
          }
          for (int i = 0; i < steps; ++i) {
            c.wall.damping = 2.0 * c.hand.mass / period * i / steps;
            double low = 10.0, high = 1e6;
            const auto unstable = [&](double K) {
              c.wall.stiffness = K;
              return is_unstable(c);
            };
            if (unstable(low)) high = low;
            while (high > 1.1 * low) {
              const double middle = std::sqrt(low * high);
              (unstable(middle) ? high : low) = middle;
            }
            add_row(table, {std::string(1, letter), period, delay, has_hand ? 1.0 : 0.0,
                            c.wall.damping, high > low ? low : 0.0});
            if (!has_hand && period == kPeriod) {
              line.x.push_back(c.wall.damping);
              line.y.push_back(low);
            }
          }
        }
        if (!line.x.empty() && delay < 0.01) outcome.figure.panels[1].series.push_back(line);
      }
    }
  }
}

void run_engine(const Context& context, Outcome& outcome) {
  outcome.tables.push_back(
      {.name = "engine",
       .columns = {"place", "rotation", "delay [s]", "largest stable", "linear loop", "ratio"}});
  double least = 1e300;
  std::vector<Place> places = engine_places();
  if (context.quick) places.resize(2);
  const std::vector<double> delays =
      context.quick ? std::vector<double>{0.005} : std::vector<double>{0.0, 0.002, 0.005, 0.015};
  for (const Place& place : places) {
    tell(context, "engine: " + place.name);
    for (const bool is_angular : {false, true}) {
      plot::Series line{.label = place.name + (is_angular ? ", turning" : ""),
                        .mark = plot::Mark::line_and_points};
      for (const double delay : delays) {
        const double loop = loop_boundary(is_angular, delay);
        const double found = engine_boundary(place, is_angular, delay, is_angular ? 20.0 : 60000.0);
        add_row(outcome.tables.back(),
                {place.name, is_angular ? 1.0 : 0.0, delay, found, loop, found / loop});
        if (!is_angular && delay > 0.0) least = std::min(least, found / loop);
        line.x.push_back(1e3 * delay);
        line.y.push_back(found);
      }
      outcome.figure.panels[is_angular ? 3 : 2].series.push_back(line);
    }
  }
  outcome.claims.push_back(
      stated("engine",
             "least stiffness of the coupling that the engine bears with delay, over the "
             "boundary of the linear loop",
             least));
}

}  // namespace
}  // namespace e3_z_width

Outcome run_e3_z_width(const Context& context) {
  using namespace e3_z_width;
  Outcome outcome;
  outcome.tables = {{.columns = {"device", "period [s]", "delay [s]", "held", "B [N s/m]",
                                 "largest stable K [N/m]"}}};
  outcome.figure = {
      .title = "Z-width (protocol E3)",
      .note =
          "two-sided wall on 0.1 kg; one-sided walls under 2 N at 1 kHz; coupling of the "
          "engine in the simulated hand",
      .panels = {{.title = "linear case",
                  .x = {.label = "beta = B T / m"},
                  .y = {.label = "alpha = K T^2 / m"}},
                 {.title = "walls",
                  .x = {.label = "B [N s/m]"},
                  .y = {.label = "largest stable K [N/m]", .is_log = true}},
                 {.title = "engine",
                  .x = {.label = "delay [ms]"},
                  .y = {.label = "largest k_c [N/m]", .is_log = true}},
                 {.title = "engine, turning",
                  .x = {.label = "delay [ms]"},
                  .y = {.label = "largest k_theta [N m/rad]", .is_log = true}}},
      .columns = 2};
  tell(context, "linear case");
  run_boundary(context, outcome);
  run_passivity(outcome);
  tell(context, "walls");
  run_z_width(context, outcome);
  run_engine(context, outcome);
  return outcome;
}

}  // namespace thigma::experiments
