// Fig. 4.8: a probe's diameter and how rough a wave feels through it.

#include <algorithm>

#include "experiments/common/all_experiments.h"
#include "experiments/common/hand_on_wave.h"

namespace thigma::experiments {
namespace fig_4_8 {
namespace {

std::vector<Roughness> curves() {
  std::vector<Roughness> list;
  for (const double diameter : {1e-3, 2e-3, 3e-3, 4e-3})
    list.push_back({.stroke = {.diameter = diameter},
                    .label = std::to_string(static_cast<int>(1e3 * diameter + 0.5)) + " mm"});
  return list;
}

/// Smallest ratio of the peaks of neighbouring curves, the smaller diameter first.
double least_ratio(const std::vector<Roughness>& curves, double Roughness::*of) {
  double least = 1e9;
  for (std::size_t i = 1; i < curves.size(); ++i)
    least = std::min(least, curves[i - 1].*of / (curves[i].*of));
  return least;
}

double largest_ratio(const std::vector<Roughness>& curves, double Roughness::*of) {
  double largest = 0.0;
  for (std::size_t i = 1; i < curves.size(); ++i)
    largest = std::max(largest, curves[i - 1].*of / (curves[i].*of));
  return largest;
}

void add_claims(const std::string& suffix, const std::string& how,
                const std::vector<Roughness>& curves, Outcome& outcome) {
  outcome.claims.push_back(above("height" + suffix,
                                 how + "peaks are higher for smaller diameters: least ratio",
                                 least_ratio(curves, &Roughness::peak), 1.0));
  outcome.claims.push_back(below("location" + suffix,
                                 how + "and lie at smaller spacings: largest ratio of the spacings",
                                 largest_ratio(curves, &Roughness::peak_spacing), 1.0));
  double least = 1.0;
  for (const Roughness& curve : curves) least = std::min(least, quadratic_fit(curve));
  outcome.claims.push_back(
      at_least("quadratic" + suffix, how + "logarithms follow a parabola, least R^2", least, 0.9));
}

}  // namespace
}  // namespace fig_4_8

Outcome run_fig_4_8(const Context& context) {
  using namespace fig_4_8;
  return run_roughness(context, "Probe diameter (Fig. 4.8)", curves(), add_claims);
}

}  // namespace thigma::experiments
