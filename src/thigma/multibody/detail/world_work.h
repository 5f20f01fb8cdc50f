#pragma once
// Working memory of a step of a world, and what its parts share.

#include "thigma/multibody/detail/islands.h"
#include "thigma/multibody/step_world.h"

namespace thigma {

struct WorldScratch {
  detail::BroadPhase broad;
  detail::PairModels pairs;
  detail::Islands islands;
  IslandScratch solve;
  std::vector<std::uint8_t> moves;    // by body: dynamic and awake
  std::vector<double> go;             // by body: how far any of its points may go [m]
  std::vector<double> margins;        // by body, of the broad phase [m]
  std::vector<IslandBody> free;       // by body: metric and velocity without contacts
  std::vector<BodyState> next;        // by body: after the step
  std::vector<std::uint8_t> pressed;  // by row
  // of impacts
  std::vector<IslandBody> hit_bodies;
  std::vector<IslandRow> hit_rows;
  std::vector<std::int32_t> hit_sources;  // into Islands::rows
  std::vector<Vec6> bounce;
};

}  // namespace thigma

namespace thigma::detail {

/// One part of a step.
struct Part {
  const World& world;
  const WorldInputs& inputs;
  double dt = 0.0;  // of the part [s]
  WorldState& state;
  WorldScratch& s;
  WorldStep& report;
};

/// Velocity of a body [m/s, rad/s; world].
Vec6 velocity_of(const RigidBody& body, const BodyState& state) noexcept;

/// M at a state (6 x 6) [world].
Mat6 mass_matrix(const RigidBody& body, const BodyState& state) noexcept;

/// What the surfaces that met in a part make of each other, once, at the states after it.
///
/// states   of all bodies, after the part; momenta change
void collide(Part& part, std::span<BodyState> states);

}  // namespace thigma::detail
