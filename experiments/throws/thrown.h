#pragma once
// Objects thrown at a plate of 0.1 mm through the whole loop, seeded; which of them pass.

#include <array>
#include <cstdint>
#include <vector>

#include "experiments/common/led_session.h"

namespace thigma::experiments {

inline constexpr double kThrowPlate = 1e-4;  // thick [m]

/// One throw. All of it follows from its number.
struct Throw {
  int shape = 0;             // of ThrowWorld::pairs
  int every = 1;             // haptic frames from one contact frame to the next
  double speed = 0.0;        // of the hand [m/s]
  Vec3 spin = Vec3::Zero();  // of the hand, up to 50 [rad/s]
  Vec3 towards = -Vec3::UnitZ();
  Quat turned = Quat::Identity();  // of the object at the start
  double mass = 0.0;               // [kg]
  double stiffness = 0.0;          // of the coupling [N/m]
};

/// Number `index` of a series.
Throw make_throw(std::uint64_t seed, std::uint64_t index);

/// What is thrown, and the plate; made once.
struct ThrowWorld {
  std::vector<LedPair> pairs;  // a box, a ball, a rod
};
ThrowWorld make_throw_world();

/// How it went.
struct Thrown {
  bool has_passed = false;  // the centre of mass came below the plate
  double depth = 0.0;       // deepest vertex below the plate's top [m]; <= 0: none entered
  bool is_fault = false;
  int frames = 0, held_back = 0;
  bool has_touched = false;  // something pressed
};

/// Runs one: the hand starts above the plate, goes 60 mm along its way, 30 mm and more of it below
/// the plate, and stays there for 0.15 s. Limits on the device's speed are lifted.
Thrown run_throw(const ThrowWorld& world, const Throw& one, bool is_constrained);

/// Sums over throws, by contact rate.
struct ThrowCount {
  std::array<std::int64_t, 4> thrown{}, passed{}, entered{}, faults{};
  std::int64_t held_back = 0, frames = 0, touched = 0;
  double depth = 0.0;  // deepest of all [m]
};
inline constexpr std::array<int, 4> kThrowEvery = {1, 3, 10, 33};
void add_throw(const Throw& one, const Thrown& how, ThrowCount& count);
std::int64_t total(const std::array<std::int64_t, 4>& counts);

}  // namespace thigma::experiments
