#pragma once
// Working memory of a step of a world, and what its parts share.

#include "thigma/multibody/detail/islands.h"
#include "thigma/multibody/detail/joint_rows.h"
#include "thigma/multibody/detail/row_cut.h"
#include "thigma/multibody/step_world.h"

namespace thigma {

struct WorldScratch {
  detail::BroadPhase broad;
  detail::PairModels pairs;
  detail::Islands islands;
  detail::RowCut cut;
  IslandScratch solve;
  std::vector<std::uint8_t> moves;    // by body: dynamic and awake
  std::vector<std::uint8_t> in_hand;  // by body: a hand has hold of it in this step
  std::vector<double> go;             // by body: how far any of its points may go [m]
  std::vector<double> margins;        // by body, of the broad phase [m]
  std::vector<IslandBody> free;       // by body: metric and velocity without contacts
  std::vector<BodyState> next;        // by body: after the step
  std::vector<std::uint8_t> pressed;  // by row
  // of joints
  detail::JointRowList joint_rows;  // of the island that is solved
  // by joint: impulses of the last solve of a part, and of its end; of all parts of a step
  std::vector<detail::JointImpulses> joint_part, joint_end, joint_sum;
  std::vector<Vec6> joint_through, joint_before;  // by place in the island
  std::vector<Vec6> joint_momentum;               // by body: after the part [N s, N m s]
  std::vector<std::uint8_t> is_jointed;           // by body: its island has joints
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

/// What moves a body in this step: a moving one that a hand has hold of counts as held.
inline BodyKind moved_by(const World& world, const WorldScratch& s, std::int32_t body) noexcept {
  const auto i = static_cast<std::size_t>(body);
  const BodyKind kind = world.bodies[i].kind;
  return kind == BodyKind::moving && s.in_hand[i] != 0 ? BodyKind::held : kind;
}
inline BodyKind moved_by(const Part& part, std::int32_t body) noexcept {
  return moved_by(part.world, part.s, body);
}

/// Velocity of a body [m/s, rad/s; world].
Vec6 velocity_of(const RigidBody& body, const BodyState& state) noexcept;

/// M at a state (6 x 6) [world].
Mat6 mass_matrix(const RigidBody& body, const BodyState& state) noexcept;

/// Velocities of an island's bodies under its rows and those of its joints; rows that ask for what
/// contradicts only hold then.
void solve_rows(Part& part, const Island& island, std::span<IslandBody> bodies,
                std::span<JointRow> joints);

/// Rows that turning has closed beyond their linear change ask for less, or, where they touched
/// already, to part by what turning takes; whether any does. From `next`.
bool correct_limits(Part& part, const Island& island) noexcept;

/// What the surfaces that met in a part make of each other, once, at the states after it; bodies
/// that joints hold take the velocities that these allow there.
///
/// states   of all bodies, after the part; momenta change
void collide(Part& part, std::span<BodyState> states);

}  // namespace thigma::detail
