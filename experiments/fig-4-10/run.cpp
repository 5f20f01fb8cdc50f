// Fig. 4.10: exploratory speed and how rough a wave feels.

#include <algorithm>

#include "experiments/common/all_experiments.h"
#include "experiments/common/hand_on_wave.h"

namespace thigma::experiments {
namespace fig_4_10 {
namespace {

constexpr double kLarge[] = {4e-3, 6e-3, 8e-3}, kSmall[] = {5e-4, 7e-4, 1e-3};  // [m]

std::vector<Roughness> curves(bool is_quick) {
  std::vector<Roughness> list;
  for (const double speed : {0.025, 0.05, 0.1, 0.2}) {
    if (is_quick && speed == 0.05) continue;
    list.push_back({.stroke = {.speed = speed},
                    .label = std::to_string(static_cast<int>(1e3 * speed + 0.5)) + " mm/s"});
  }
  return list;
}

void add_claims(const std::string& suffix, const std::string& how,
                const std::vector<Roughness>& curves, Outcome& outcome) {
  double least = 1e9, widest = 0.0;
  for (const double spacing : kLarge)
    least = std::min(
        least, acceleration_at(curves.back(), spacing) / acceleration_at(curves.front(), spacing));
  for (const double spacing : kSmall) {
    double low = 1e9, high = 0.0;
    for (const Roughness& curve : curves) {
      low = std::min(low, acceleration_at(curve, spacing));
      high = std::max(high, acceleration_at(curve, spacing));
    }
    widest = std::max(widest, high / low);
  }
  outcome.claims.push_back(
      above("speed-large" + suffix,
            how + "at 4, 6 and 8 mm 200 mm/s is rougher than 25 mm/s: least ratio", least, 1.0));
  outcome.claims.push_back(known_not_to(
      at_most("speed-small" + suffix,
              how + "up to 1 mm almost constant: largest over smallest of the speeds", widest, 1.3),
      {"slow strokes over fine waves shake the hand at frequencies it follows; subjects' fall with "
       "speed is not seen either, and the text says that its own model does not show it",
       "data.csv", 1.6}));
}

}  // namespace
}  // namespace fig_4_10

Outcome run_fig_4_10(const Context& context) {
  using namespace fig_4_10;
  return run_roughness(context, "Exploratory speed (Fig. 4.10)", curves(context.quick), add_claims);
}

}  // namespace thigma::experiments
