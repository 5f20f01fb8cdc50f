#pragma once
// The pairs of `never-enters`, and how the hand presses, slides, twists and taps each.

#include <functional>
#include <string>
#include <vector>

#include "experiments/common/led_session.h"

namespace thigma::experiments {

/// A pair, made when it is its turn.
struct PressedScene {
  std::string name;
  std::function<LedPair()> make;
  Vec3 towards = -Vec3::UnitZ();  // unit: the way the hand presses
  Vec3 slide{0.003, 0.002, 0.0};  // half the way to and fro [m]
  Vec3 twist{0.03, 0.03, 0.03};   // half the turn to and fro [rad]
  bool is_real = false;           // of the shared meshes
};

/// Seconds of pressed_hand, and from when on the hand is at rest, pressing.
inline constexpr double kPressedSeconds = 3.0, kAtRest = 2.6;

/// Those that stand in the program.
/// triangles  of each surface of jaws, ball joint and gears; 0: their own count
std::vector<PressedScene> built_in_scenes(int triangles);

/// Pairs of the shared real meshes; empty where THIGMA_SHARED names no folder with them.
std::vector<PressedScene> real_scenes();

/// From the start `press` beyond the first touch in 0.3 s, slid and twisted for 0.6 s, tapped three
/// times over 8 mm at 0.16 m/s, then at rest.
HandPath pressed_hand(const LedPair& pair, const PressedScene& scene, double press);

}  // namespace thigma::experiments
