// Fig. 4.10: exploratory speed and how rough a wave feels.

#include <algorithm>
#include <cmath>

#include "experiments/common/all_experiments.h"
#include "experiments/common/hand_on_wave.h"

#include "thigma/math/elementary.h"

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

/// Acceleration of a hand at a speed over a wave.
double shaken(const WaveStroke& hand, double speed, const SlopeTable& wave) {
  WaveStroke stroke = hand;
  stroke.speed = speed;
  return largest_acceleration(stroke, wave);
}

/// Largest over smallest of four speeds, up to 1 mm, the most.
double widest_of(const WaveStroke& hand) {
  double widest = 0.0;
  for (const double spacing : kSmall) {
    const SlopeTable wave = exact_slopes(hand, spacing);
    double low = 1e9, high = 0.0;
    for (const double speed : {0.025, 0.05, 0.1, 0.2}) {
      const double a = shaken(hand, speed, wave);
      low = std::min(low, a);
      high = std::max(high, a);
    }
    widest = std::max(widest, high / low);
  }
  return widest;
}

/// Other hands: how near the slowest stroke over the longest of the waves comes to what they follow.
double try_hands(Outcome& outcome) {
  Table table{.name = "hands",
              .columns = {"mass [kg]", "stiffness [N/m]", "damping ratio", "natural frequency [Hz]",
                          "lowest frequency over it", "largest over smallest"}};
  double free = std::nan("");
  for (const double mass : {0.02, 0.1, 0.3}) {
    for (const double stiffness : {100.0, 300.0, 1000.0}) {
      const WaveStroke hand{.mass = mass, .stiffness = stiffness};
      const double natural = std::sqrt(stiffness / mass) / (2.0 * kPi), lowest = 0.025 / 1e-3;
      const double widest = widest_of(hand);
      add_row(table, {mass, stiffness, hand.damping_ratio, natural, lowest / natural, widest});
      if (mass == 0.3 && stiffness == 100.0) free = widest;
    }
  }
  outcome.tables.push_back(std::move(table));
  return free;
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
      {"slow strokes over fine waves shake this hand at three times the frequency it follows, not far above it; one "
       "that follows slower ones alone (hands.csv, `speed-small-free`) holds",
       "hands.csv", 1.6}));
}

}  // namespace
}  // namespace fig_4_10

Outcome run_fig_4_10(const Context& context) {
  using namespace fig_4_10;
  Outcome outcome = run_roughness(context, "Exploratory speed (Fig. 4.10)", curves(context.quick), add_claims);
  outcome.claims.push_back(at_most("speed-small-free", "the same of a hand of 0.3 kg and 100 N/m, which follows 2.9 Hz: every wave is far above",
                                   try_hands(outcome), 1.3));
  return outcome;
}

}  // namespace thigma::experiments
