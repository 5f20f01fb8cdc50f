// Fig. 5.4: the coupling's saturating spring, value and slope.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"

#include "thigma/dynamics/coupling.h"

namespace thigma::experiments {

Outcome run_fig_5_4(const Context& context) {
  Outcome outcome;
  outcome.tables = {{.columns = {"k_0 [N/m]", "stretch [m]", "force [N]", "slope [N/m]"}}};
  outcome.figure = {.title = "Saturating coupling spring (Fig. 5.4)",
                    .panels = {{.x = {.label = "stretch [mm]"}, .y = {.label = "force [N]"}},
                               {.x = {.label = "stretch [mm]"}, .y = {.label = "slope [N/m]"}}}};
  double value_jump = 0.0, slope_jump = 0.0, slope_error = 0.0, least_slope = 1e300;
  double end_error = 0.0, start_error = 0.0;
  const int steps = context.quick ? 2000 : 200000;
  for (const double k : {200.0, 300.0, 500.0}) {
    const double greatest = 4.0;  // Sec. 5.5.3 [N]
    const Saturation s = make_saturation(k, 0.5 * greatest / k, greatest);
    plot::Series force{.label = std::to_string(static_cast<int>(k)) + " N/m"}, slope;
    for (const double knot : {s.linear_range, s.full_range}) {
      const SpringForce before = spring_force(s, knot * (1.0 - 1e-12));
      const SpringForce after = spring_force(s, knot * (1.0 + 1e-12));
      value_jump = std::max(value_jump, std::fabs(after.force - before.force) / greatest);
      slope_jump = std::max(slope_jump, std::fabs(after.slope - before.slope) / k);
    }
    const double step = 1.5 * s.full_range / steps;
    for (int i = 0; i <= steps; ++i) {
      const double x = i * step;
      const SpringForce at = spring_force(s, x);
      least_slope = std::min(least_slope, at.slope / k);
      const double h = 1e-4 * s.full_range;
      if (x > h) {
        const double difference =
            (spring_force(s, x + h).force - spring_force(s, x - h).force) / (2.0 * h);
        slope_error = std::max(slope_error, std::fabs(difference - at.slope) / k);
      }
      if (x <= s.linear_range)
        start_error = std::max(start_error, std::fabs(at.force - k * x) / greatest);
      if (x >= s.full_range)
        end_error = std::max(end_error, std::fabs(at.force - greatest) / greatest);
      if (i % (steps / 200) != 0) continue;
      add_row(outcome.tables[0], {k, x, at.force, at.slope});
      force.x.push_back(1e3 * x);
      slope.x.push_back(1e3 * x);
      force.y.push_back(at.force);
      slope.y.push_back(at.slope);
    }
    outcome.figure.panels[0].series.push_back(force);
    outcome.figure.panels[1].series.push_back(slope);
  }
  outcome.claims = {
      at_most("value", "jump of the force at either knot, over the greatest force", value_jump,
              1e-9),
      at_most("slope", "jump of the slope at either knot, over k_0", slope_jump, 1e-9),
      at_most("derivative", "slope against a central difference of the force, over k_0",
              slope_error, 1e-3),
      at_least("monotone", "least slope over k_0", least_slope, 0.0),
      at_most("linear", "distance from k_0 x within the linear range, over the greatest force",
              start_error, 1e-12),
      at_most("saturates", "distance from the greatest force beyond the second knot, over it",
              end_error, 1e-12)};
  return outcome;
}

}  // namespace thigma::experiments
