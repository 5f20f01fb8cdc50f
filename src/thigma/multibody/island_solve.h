#pragma once
// Gauss's least constraint for several bodies at once: the velocities nearest to the free ones that
// no contact forbids, with Coulomb friction.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/math/infinity.h"
#include "thigma/multibody/detail/block_cholesky.h"

namespace thigma {

/// A body of an island.
struct IslandBody {
  // A of its step: M, and of a held body h B + h^2 K of its coupling. Symmetric positive definite
  // [kg, kg m, kg m^2]
  Mat6 metric = Mat6::Identity();
  Vec6 free = Vec6::Zero();  // velocity without contacts [m/s, rad/s; world]
  // results: with the contacts, and what these gave it, about its centre of mass [N s, N m s]
  Vec6 velocity = Vec6::Zero(), impulse = Vec6::Zero();
};

/// A contact of two bodies of an island, or of one with what does not move.
struct IslandRow {
  std::int32_t a = -1, b = -1;                      // bodies of the island; -1: what does not move
  Vec3 normal = Vec3::UnitZ();                      // unit, out of a, into b [world]
  Vec3 first = Vec3::UnitX();                       // unit, across the normal [world]
  Vec3 arm_a = Vec3::Zero(), arm_b = Vec3::Zero();  // of one place, from both centres [m; world]
  double limit = 0.0;  // the normal speed of a towards b at most; below 0: they have to part [m/s]
  double friction = 0.0;  // Coulomb's coefficient now, >= 0
  // on b along the normal and the two tangents, and the opposite on a: warm start and result [N s]
  Vec3 impulse = Vec3::Zero();
};

/// One number that a joint asks of two bodies of an island, or of one and what does not move: a
/// speed that they have to have, or a force between bounds that works towards it.
struct JointRow {
  std::int32_t a = -1, b = -1;                    // bodies of the island; -1: what does not move
  Vec6 on_a = Vec6::Zero(), on_b = Vec6::Zero();  // speed = on_a . u_a + on_b . u_b [1, m; world]
  double target = 0.0;                            // of the speed [m/s]
  double low = -kInfinity, high = kInfinity;      // of the impulse; low = 0: the speed at most
  double firmness = 0.0;  // 0: as hard as its bounds let it; else impulse a speed, of a spring [kg]
  // bodies get -on times it: warm start and result [N s]
  double impulse = 0.0;
};

/// What a solve did.
struct IslandSolution {
  int rounds = 0;          // of multipliers
  int newton = 0;          // steps: so many factors
  double residual = 0.0;   // largest speed by which a row is violated, at least 0 [m/s]
  double unsettled = 0.0;  // change of the friction impulses in the last round, of the largest
  // false: rows contradict each other, or rounds ran out before the residual was small
  bool is_whole = true;
};

/// Working memory: grows while warming up, never after.
struct IslandScratch {
  detail::BlockMatrix hessian;
  std::vector<Vec6> velocity, trial, gradient, trial_gradient, step;
  std::vector<Mat6> inverse;   // of the metrics
  std::vector<Vec3> force;     // of the rows, at a trial
  std::vector<double> weight;  // of the rows: so many times the mass that a contact feels [kg]
  std::vector<double> radius;  // most friction of the rows in a round [N s]
  std::vector<double> joint_force, joint_weight;  // of the joints' rows, likewise
  // By which a round changed the multipliers, and the round before; so many are known.
  std::vector<Vec3> change, change_before;
  std::vector<double> joint_change, joint_change_before;
  int changes = 0;
  std::vector<Vec3> kept;  // multipliers before a try
  std::vector<double> joint_kept;
  // Factors that solves may still take, where their time is bounded: one that has none left ends
  // with the impulses it has, and is not whole. Below 0: as many as they need
  std::int32_t newton_left = -1;
  // A solve begins with the velocities that bodies have, not with the free ones: fewer factors
  // where they are near. The solution is the same, to what it is met to
  bool goes_on = false;
};

/// Room for an island. Thread [offline]; throws std::bad_alloc.
void reserve_island(std::size_t bodies, std::size_t rows, IslandScratch& scratch,
                    std::size_t joints = 0);

/// Velocities nearest to the free ones, in the metric of the bodies' steps, that obey every row.
///
/// bodies   an order in which bodies that touch stand near each other costs least
/// rows     0 <= limit: rest obeys all, so there is a solution; where negative limits contradict
///          each other, is_whole is false
/// joints   rows of joints; the same may be asked twice
/// returns  velocity = free + A^-1 (impulses of the rows), to rounding: what rows give one body
///          they take from the other. Friction opposes sliding and never exceeds its coefficient
///          times the normal impulse but by the last round's change, so that neither adds energy
/// Thread   [haptic]; no failure, nothing allocated after reserve_island. The same bits for the
///          same input
/// Source   min 1/2 |u - free|_A^2 subject to the rows: method of multipliers (Rockafellar 1976),
///          each round a semismooth Newton's method on the augmented Lagrangian, one block-sparse
///          Cholesky factor a step. Coulomb: friction disks of the radius that the normals of the
///          round before allow (Panagiotopoulos 1975), a fixed point over the rounds. No cone is
///          made a pyramid. Where the bounds go to and fro they go a share of the way (relaxation);
///          rounds end where changes are small and shrink no more. Where nothing slid before it is
///          tried first whether nothing slides, with cones, which need no fixed point.
IslandSolution solve_island(std::span<IslandBody> bodies, std::span<IslandRow> rows,
                            std::span<JointRow> joints, IslandScratch& scratch) noexcept;

/// The same without joints.
inline IslandSolution solve_island(std::span<IslandBody> bodies, std::span<IslandRow> rows,
                                   IslandScratch& scratch) noexcept {
  return solve_island(bodies, rows, {}, scratch);
}

}  // namespace thigma
