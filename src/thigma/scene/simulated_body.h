#pragma once
// What a scene says of an object that no hand holds: [simulation] in its file.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "thigma/math/types.h"
#include "thigma/simulation/collision.h"

namespace thigma {

struct SessionConfig;
struct SimulationState;
struct SimulationWorld;

/// [simulation].
struct SimulatedBody {
  CollisionLaw law;              // of all surfaces
  Vec3 velocity = Vec3::Zero();  // at the start [m/s; world]
  Vec3 spin = Vec3::Zero();      // at the start [rad/s; world]
  // the seed moves the start by up to this along each axis, and turns it as far [m]
  double scatter = 0.0;
  // [contact] names one; otherwise it is a thousandth of the smaller radius
  bool has_tolerance = false;
};

/// [simulation] of a scene's text, if it has one. Thread [offline]; InputError as parse_scene.
std::optional<SimulatedBody> parse_simulated_body(std::string_view text, const std::string& file);

/// What is simulated, of the session of the same scene: body, hierarchies, poses, tolerance,
/// resolution (without blending).
SimulationWorld simulation_world(const SimulatedBody& body, const SessionConfig& config);

/// Where it starts: the session's pose, scattered.
SimulationState simulation_start(const SimulatedBody& body, const SessionConfig& config,
                                 std::uint64_t seed);

}  // namespace thigma
