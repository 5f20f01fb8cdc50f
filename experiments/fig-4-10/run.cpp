// Fig. 4.10: exploratory speed and how rough a wave feels.

#include <algorithm>
#include <cmath>
#include <functional>

#include "experiments/common/all_experiments.h"
#include "experiments/common/hand_on_wave.h"

#include "thigma/math/elementary.h"

namespace thigma::experiments {
namespace fig_4_10 {
namespace {

constexpr double kSpeeds[] = {0.025, 0.05, 0.1, 0.2};                           // [m/s]
constexpr double kLarge[] = {4e-3, 6e-3, 8e-3}, kSmall[] = {5e-4, 7e-4, 1e-3};  // [m]

std::vector<Roughness> curves(bool is_quick) {
  std::vector<Roughness> list;
  for (const double speed : kSpeeds) {
    if (is_quick && speed == 0.05) continue;
    list.push_back({.stroke = {.speed = speed},
                    .label = std::to_string(static_cast<int>(1e3 * speed + 0.5)) + " mm/s"});
  }
  return list;
}

/// Largest over smallest acceleration of the speeds, over the small spacings.
double widest_ratio(const std::function<double(double speed, double spacing)>& acceleration) {
  double widest = 0.0;
  for (const double spacing : kSmall) {
    double low = 1e9, high = 0.0;
    for (const double speed : kSpeeds) {
      low = std::min(low, acceleration(speed, spacing));
      high = std::max(high, acceleration(speed, spacing));
    }
    widest = std::max(widest, high / low);
  }
  return widest;
}

/// hands.csv: the same for other hands, in closed form. Above its natural frequency a hand is a
/// mass, and speed cancels: takes the cause away, and returns the ratio of the hand of 0.3 kg,
/// which follows 5 Hz.
double add_hands(Outcome& outcome) {
  double heavy = std::nan("");
  Table hands{
      .name = "hands",
      .columns = {"mass [kg]", "natural frequency [Hz]", "largest over smallest acceleration"}};
  for (const double mass : {0.02, 0.05, 0.1, 0.2, 0.3, 0.5}) {
    WaveStroke stroke{.mass = mass};
    const double widest = widest_ratio([&](double speed, double spacing) {
      stroke.speed = speed;
      return largest_acceleration(stroke, exact_slopes(stroke, spacing));
    });
    add_row(hands, {mass, std::sqrt(stroke.stiffness / mass) / (2.0 * kPi), widest});
    if (mass == 0.3) heavy = widest;
  }
  outcome.tables.push_back(std::move(hands));
  return heavy;
}

void add_claims(const std::string& suffix, const std::string& how,
                const std::vector<Roughness>& curves, Outcome& outcome) {
  double least = 1e9;
  for (const double spacing : kLarge)
    least = std::min(
        least, acceleration_at(curves.back(), spacing) / acceleration_at(curves.front(), spacing));
  const double widest = widest_ratio([&](double speed, double spacing) {
    const auto of_speed = std::find_if(curves.begin(), curves.end(),
                                       [&](const Roughness& c) { return c.stroke.speed == speed; });
    // A speed that --quick leaves out counts as its neighbour.
    return acceleration_at(of_speed != curves.end() ? *of_speed : curves.front(), spacing);
  });
  outcome.claims.push_back(
      above("speed-large" + suffix,
            how + "at 4, 6 and 8 mm 200 mm/s is rougher than 25 mm/s: least ratio", least, 1.0));
  outcome.claims.push_back(known_not_to(
      at_most("speed-small" + suffix,
              how + "up to 1 mm almost constant: largest over smallest of the speeds", widest, 1.3),
      {"the slowest strokes shake the hand at frequencies it still follows; above them it is a "
       "mere mass, and speed "
       "cancels. The text names no hand: one of 0.2 kg on the same spring is within the bound, "
       "this has 0.1 kg",
       "hands.csv", 1.6}));
}

}  // namespace
}  // namespace fig_4_10

Outcome run_fig_4_10(const Context& context) {
  using namespace fig_4_10;
  Outcome outcome =
      run_roughness(context, "Exploratory speed (Fig. 4.10)", curves(context.quick), add_claims);
  outcome.claims.push_back(at_most("speed-small-heavy",
                                   "the same ratio of a hand of 0.3 kg, which follows 5 Hz alone: "
                                   "every wave shakes it far above that",
                                   add_hands(outcome), 1.3));
  return outcome;
}

}  // namespace thigma::experiments
