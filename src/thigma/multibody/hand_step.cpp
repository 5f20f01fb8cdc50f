#include "thigma/multibody/hand_step.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/infinity.h"
#include "thigma/multibody/detail/hand_collide.h"
#include "thigma/multibody/detail/hand_result.h"
#include "thigma/multibody/detail/hand_within.h"
#include "thigma/multibody/detail/hand_work.h"
#include "thigma/multibody/detail/pair_models.h"
#include "thigma/multibody/detail/row_rules.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma {
namespace {

using detail::HandWork;
using detail::RowSource;

bool is_out_of_factors(const HandWork& work) THIGMA_RT { return work.memory.newton >= kHandNewton; }

/// Solves; where rows contradict each other, again with those to recover along at rest.
IslandSolution solve(const HandWork& work, ConstrainedStep& result) THIGMA_RT {
  HandScratch& s = work.s;
  const auto once = [&] {
    // The first turn of a step gets most, the others what is left.
    constexpr std::int32_t kMost = kHandNewton * 2 / 3;
    const std::int32_t left = kHandNewton - work.memory.newton;
    s.solve.newton_left = std::clamp(left, 0, kMost);
    const detail::CutSolution cut =
        detail::solve_cut(s.bodies, s.rows, s.sources, s.joint_rows.rows, s.cut, s.solve);
    work.memory.newton += cut.solution.newton;
    return cut.solution;
  };
  IslandSolution solution = once();
  if (solution.is_whole || is_out_of_factors(work)) return solution;
  result.is_squeezed = true;
  for (IslandRow& row : s.rows) row.limit = std::max(row.limit, 0.0);
  return once();
}

/// All bodies wait.
void rest(const HandWork& work) THIGMA_RT {
  for (IslandBody& body : work.s.bodies) body.velocity = body.impulse = Vec6::Zero();
  for (IslandRow& row : work.s.rows) row.impulse = Vec3::Zero();
  for (JointRow& row : work.s.joint_rows.rows) row.impulse = 0.0;
}

void keep_joints(const HandWork& work) THIGMA_RT {
  const detail::JointRowList& list = work.s.joint_rows;
  for (std::size_t r = 0; r < list.rows.size(); ++r)
    work.memory.joints[idx(list.sources[r].joint)][list.sources[r].place] = list.rows[r].impulse;
}

/// As many turns as joints and turning take, and factors are there for.
IslandSolution solve_turns(const HandWork& work, ConstrainedStep& result) THIGMA_RT {
  constexpr int kTurns = 3;
  HandScratch& s = work.s;
  IslandSolution solution;
  for (int turn = 0; turn < kTurns; ++turn) {
    if (turn > 0) {
      s.kept_bodies = s.bodies;
      s.kept_rows = s.rows;
    }
    const bool was_squeezed = result.is_squeezed;
    detail::fill_joints(work, turn == 0);
    const IslandSolution next = solve(work, result);
    if (turn > 0 && !next.is_whole && is_out_of_factors(work)) {
      // The turn before is right but for what this one would have turned.
      s.bodies = s.kept_bodies;
      s.rows = s.kept_rows;
      result.is_squeezed = was_squeezed;
      detail::go(work, 1.0);
      break;
    }
    solution = next;
    if (!solution.is_whole) rest(work);
    keep_joints(work);
    detail::go(work, 1.0);
    const bool is_short = turn + 1 < kTurns && detail::correct_limits(work);
    if (!solution.is_whole || (!is_short && work.model.joints.empty())) break;
    // A turn that none is left for would undo this one.
    if (is_out_of_factors(work)) break;
  }
  work.memory.is_cut_short = !solution.is_whole && is_out_of_factors(work);
  return solution;
}

/// The largest share of the step, to 2^-12, in which the body in the hand stays where the model
/// says all.
template <class Least>
double share_within(const HandWork& work, Least least) THIGMA_RT {
  double inside = 0.0, outside = 1.0;
  for (int turn = 0; turn < 12; ++turn) {
    const double middle = 0.5 * (inside + outside);
    detail::go(work, middle);
    (detail::is_within(work.model, work.s.next, least) ? inside : outside) = middle;
  }
  detail::go(work, inside);
  return inside;
}

}  // namespace

void reserve_hand_step(HandScratch& s) {
  reserve_island(kHandBodies, kHandRows, s.solve, kHandJoints * detail::kJointPlaces);
  detail::reserve_cut(kHandPairs, kHandRows, s.cut);
  s.bodies.reserve(kHandBodies);
  s.rows.reserve(kHandRows);
  s.kept_bodies.reserve(kHandBodies);
  s.kept_rows.reserve(kHandRows);
  s.solve.goes_on = true;
  s.sources.reserve(kHandRows);
  s.joint_rows.rows.reserve(kHandJoints * detail::kJointPlaces);
  s.joint_rows.sources.reserve(kHandJoints * detail::kJointPlaces);
}

ConstrainedStep step_hand(const HandModel& model, const BodyAtState& at, const StepForces& forces,
                          double dt, HandMemory& memory, HandScratch& s) THIGMA_RT {
  ConstrainedStep result;
  constexpr double kWhole = 0.5;  // of a step: what is left of the world's is one
  const HandWork work{model, at, forces, dt, memory.left > kWhole * dt, memory, s};
  memory.newton = 0;
  detail::place_bodies(work);
  detail::fill_bodies(work);
  detail::fill_rows(work);
  result.least_gap = kInfinity;
  for (const RowSource& source : s.sources)
    if (model.pairs[idx(source.pair)].is_guarded())
      result.least_gap = std::min(result.least_gap, source.gap);
  const IslandSolution solution = solve_turns(work, result);
  memory.rows = static_cast<std::int32_t>(s.rows.size());
  memory.bodies = static_cast<std::int32_t>(s.bodies.size());
  result.solution.residual = solution.residual;
  result.solution.is_whole = solution.is_whole;
  detail::keep_rows(work, result);
  result.solution.velocity = s.bodies[0].velocity;
  result.solution.impulse = s.bodies[0].impulse;
  result.contact = {s.bodies[0].impulse.head<3>() / dt, s.bodies[0].impulse.tail<3>() / dt};
  result.state = s.next[0];
  result.wanted_speed = travel_between(at.state, result.state, model.reach) / dt;

  std::array<double, kHandRows> least;
  least.fill(-kInfinity);
  for (const RowSource& source : s.sources) least[idx(source.row)] = std::min(source.gap, 0.0);
  const auto of = [&](std::size_t row) { return least[row]; };
  double share = 1.0;
  if (!detail::is_within(model, s.next, of)) {
    result.is_held_back = true;
    share = share_within(work, of);
  } else if (solution.is_whole) {
    detail::collide(work);
  }
  result.state = s.next[0];
  detail::keep_bodies(work, share);
  return result;
}

}  // namespace thigma
