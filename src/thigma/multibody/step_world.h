#pragma once
// One step of a world of several bodies: pairs, rows, islands, one solve for each, impacts.

#include <cstdint>
#include <memory>
#include <span>

#include "thigma/dynamics/coupling.h"
#include "thigma/multibody/world.h"

namespace thigma {

/// A hand that holds a body in a step. A moving body that no hand of a step holds is free.
struct HandHold {
  std::int32_t body = -1;  // of kind held or moving; several hands may hold one body
  Coupling coupling;
  Motion handle;  // of the hand [world]
};

/// The velocity of a prescribed body in a step; one that is not named rests.
struct BodyDrive {
  std::int32_t body = -1;
  Twist velocity;  // [m/s, rad/s; world]
};

/// The target of a joint's motor in a step, instead of its own.
struct MotorDrive {
  std::int32_t joint = -1;
  double target = 0.0;  // [m/s, rad/s], of a servo [m, rad]
};

/// What acts on a world in a step beside gravity.
struct WorldInputs {
  std::span<const HandHold> hands{};
  std::span<const BodyDrive> drives{};
  std::span<const MotorDrive> motors{};
};

/// What a step did.
struct WorldStep {
  std::int32_t pairs = 0;           // near each other
  std::int32_t islands = 0;         // of more than one body, or with contacts
  std::int32_t largest_island = 0;  // bodies
  std::int32_t awake = 0;           // bodies that were moved
  std::int64_t queries = 0;         // of pairs
  std::int64_t coarse = 0;          // rows of surfaces that stay coarse far away, of these queries
  std::int64_t rows = 0;            // that had to be obeyed, of all parts of the step
  std::int64_t handed = 0;          // rows that the solver got, of all solves
  std::int32_t most_handed = 0;     // rows of a pair in one solve
  std::int32_t pressing = 0;        // that pressed at its end
  std::int32_t parts = 0;           // the step was made in so many: bodies were too fast for one
  std::int32_t newton = 0;          // factors of all solves
  std::int32_t impacts = 0;         // contacts that began with a bounce
  double residual = 0.0;            // largest speed at which a row was violated [m/s]
  // Time that was not made up: bodies waited, as they would have gone farther than rows hold [s]
  double waited = 0.0;
  bool is_whole = true;       // false: some rows contradicted each other and only held
  std::int64_t left_out = 0;  // contacts and rows without room: these pairs stand still
  double least_gap = 0.0;     // of a row, before the step [m]
  double joint_error = 0.0;   // by which a joint is not met, after the step [m]
};

/// Working memory of step_world. Grows while warming up, never after: until as many pairs as there
/// ever are were near at once. Moved, not copied.
struct WorldScratch;
struct WorldScratchDeleter {
  void operator()(WorldScratch* scratch) const noexcept;
};
using WorldScratchPtr = std::unique_ptr<WorldScratch, WorldScratchDeleter>;

/// Working memory for a world.
///
/// pairs    of each kind that are near at once without taking more memory; each takes 50 kB, and
///          what a front of its surfaces needs
/// Thread   [offline]; throws std::bad_alloc
WorldScratchPtr reserve_world(const World& world, std::size_t pairs = 4);

/// Makes one step of dt.
///
/// world    constant
/// inputs   hands and drives of the step; those of other kinds of bodies are passed over
/// dt       > 0 [s]
/// state    before, and after
/// Thread   [contact]; throws std::bad_alloc where memory grows. The same bits for the same calls:
///          nothing depends on time or on threads
/// Source   Gauss's principle of least constraint for all bodies of an island at once; rows of
///          constraint/, each pair in the frame of one of its bodies. Where surfaces meet the step
///          ends at the surface; then they collide there, without a step of time: Poisson's
///          restitution of the whole impulse, less where energy would grow
WorldStep step_world(const World& world, const WorldInputs& inputs, double dt, WorldState& state,
                     WorldScratch& scratch);

/// What a joint was like in the last step.
struct JointReading {
  double coordinate = 0.0;  // [m, rad]
  // on a along the coordinate, means over the step: of spring, motor and limits [N, N m]
  double spring = 0.0, motor = 0.0, limit = 0.0;
};

/// Reads a joint after a step of dt.
/// Thread    [contact]; no failure.
JointReading read_joint(const World& world, const WorldState& state, const WorldScratch& scratch,
                        std::int32_t joint, double dt) noexcept;

/// A pair that starts in each other, or the deepest of them.
struct StartOverlap {
  std::int32_t a = -1, b = -1;  // bodies; -1: none
  double depth = 0.0;           // of the surfaces through each other [m]
  std::int32_t inner = -1;      // a or b: lies inside the other, clear of its surface; -1: neither
};

/// Looks for bodies that are in each other at a state: whose surfaces are through each other, or of
/// which one lies, or a connected part of it, inside the closed surface of the other. One of the
/// second kind goes before all of the first. An open surface, or one turned inside out, has no
/// inside. Only pairs of which one moves by itself are looked at, and only those that may touch.
/// Thread    [offline]; throws std::bad_alloc.
StartOverlap find_overlap(const World& world, const WorldState& state, WorldScratch& scratch);

/// Refuses a start in which bodies are in each other.
/// Thread    [offline]; throws InputError with both names and, of surfaces that are through each
///           other, the depth.
void require_apart(const World& world, const WorldState& state, WorldScratch& scratch);

}  // namespace thigma
