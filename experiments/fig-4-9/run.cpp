// Fig. 4.9: the normal force and how rough a wave feels.

#include <algorithm>

#include "experiments/common/all_experiments.h"
#include "experiments/common/hand_on_wave.h"

namespace thigma::experiments {
namespace fig_4_9 {
namespace {

std::vector<Roughness> curves() {
  return {{.stroke = {.normal_force = 0.25}, .label = "0.25 N"},
          {.stroke = {.normal_force = 0.5}, .label = "0.5 N"},
          {.stroke = {.normal_force = 1.0}, .label = "1 N"},
          {.stroke = {.normal_force = 2.0}, .label = "2 N"}};
}

void add_claims(const std::string& suffix, const std::string& how,
                const std::vector<Roughness>& curves, Outcome& outcome) {
  double least = 1e9, low = 1e9, high = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (i > 0) least = std::min(least, curves[i].peak / curves[i - 1].peak);
    low = std::min(low, curves[i].peak_spacing);
    high = std::max(high, curves[i].peak_spacing);
  }
  outcome.claims.push_back(above("force-monotone" + suffix,
                                 how + "peaks grow with the force: least ratio of neighbours",
                                 least, 1.0));
  outcome.claims.push_back(at_most("force-location" + suffix,
                                   how + "and stay at one spacing: largest over smallest",
                                   high / low, 1.35));
  outcome.claims.push_back(within("proportional" + suffix, how + "peak at 1 N over peak at 0.5 N",
                                  curves[2].peak / curves[1].peak, 1.9, 2.1));
}

}  // namespace
}  // namespace fig_4_9

Outcome run_fig_4_9(const Context& context) {
  using namespace fig_4_9;
  return run_roughness(context, "Normal force (Fig. 4.9)", curves(), add_claims);
}

}  // namespace thigma::experiments
