#include "thigma/multibody/hand_step.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/infinity.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/hand_work.h"
#include "thigma/multibody/detail/pair_models.h"
#include "thigma/multibody/detail/row_rules.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma {
namespace {

using detail::HandPairAt;
using detail::HandWork;
using detail::RowSource;

/// Whether the body in the hand is where the model says all, no row of it below what it may be.
///
/// least   by row: the gap that it may have at least [m]
template <class Least>
bool is_within(const HandModel& model, std::span<const BodyState> states, Least least) THIGMA_RT {
  if (travel_between(model.bodies[0].state, states[0], model.reach) > model.room) return false;
  std::int32_t known = -1;
  HandPairAt at;
  for (const HandPair& pair : model.pairs) {
    if (!pair.is_guarded()) continue;
    at = detail::pair_at(pair, states);
    if (travel_between(pair.state, at.relative, pair.reach) > pair.travel) return false;
  }
  for (std::size_t r = 0; r < model.rows.size(); ++r) {
    const HandRow& row = model.rows[r];
    const HandPair& pair = model.pairs[idx(row.pair)];
    if (!pair.is_guarded()) continue;
    if (row.pair != known) at = detail::pair_at(pair, states);
    known = row.pair;
    if (row_at(row.row, at.relative.position, at.rotation).gap < least(r)) return false;
  }
  return true;
}

/// A state between two, at a share of the way from the first.
BodyState between(const BodyState& from, const BodyState& to, double share) THIGMA_RT {
  BodyState y = to;
  y.position = from.position + share * (to.position - from.position);
  const Vec3 turn = vector_from_rotation(to.orientation * from.orientation.conjugate());
  y.orientation = unit(rotation_from_vector(share * turn) * from.orientation);
  return y;
}

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
  if (!solution.is_whole) {
    result.is_squeezed = true;
    for (IslandRow& row : s.rows) row.limit = std::max(row.limit, 0.0);
    solution = once();
  }
  if (solution.is_whole) return solution;
  for (IslandBody& body : s.bodies) body.velocity = body.impulse = Vec6::Zero();
  for (IslandRow& row : s.rows) row.impulse = Vec3::Zero();
  for (JointRow& row : s.joint_rows.rows) row.impulse = 0.0;
  return solution;
}

void keep_joints(const HandWork& work) THIGMA_RT {
  const detail::JointRowList& list = work.s.joint_rows;
  for (std::size_t r = 0; r < list.rows.size(); ++r)
    work.memory.joints[idx(list.sources[r].joint)][list.sources[r].place] = list.rows[r].impulse;
}

/// As many turns as joints and turning take.
IslandSolution solve_turns(const HandWork& work, ConstrainedStep& result) THIGMA_RT {
  constexpr int kTurns = 3;
  IslandSolution solution;
  for (int turn = 0; turn < kTurns; ++turn) {
    detail::fill_joints(work, turn == 0);
    solution = solve(work, result);
    keep_joints(work);
    detail::go(work, 1.0);
    const bool is_short = turn + 1 < kTurns && detail::correct_limits(work);
    if (!solution.is_whole || (!is_short && work.model.joints.empty())) break;
    // A turn that none is left for would undo this one.
    if (work.memory.newton >= kHandNewton) break;
  }
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
    (is_within(work.model, work.s.next, least) ? inside : outside) = middle;
  }
  detail::go(work, inside);
  return inside;
}

/// Puts a row among the strongest.
void list_pressing(const PressingRow& row, PressingRows& list) THIGMA_RT {
  if (list.push_back(row)) return;
  PressingRow* weakest = std::min_element(
      list.begin(), list.end(),
      [](const auto& a, const auto& b) { return a.force.squaredNorm() < b.force.squaredNorm(); });
  if (weakest->force.squaredNorm() < row.force.squaredNorm()) *weakest = row;
}

/// What the rows did: kept for the next step, and told.
void keep_rows(const HandWork& work, ConstrainedStep& result) THIGMA_RT {
  HandScratch& s = work.s;
  for (std::size_t i = 0; i < work.model.rows.size(); ++i) {
    work.memory.impulses[i] = Vec3::Zero();
    work.memory.is_sliding[i] = false;
  }
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const IslandRow& row = s.rows[r];
    if (!(row.impulse.x() > 0.0)) continue;
    const RowSource& source = s.sources[r];
    const bool slides = detail::is_sliding(row);
    work.memory.impulses[idx(source.row)] = row.impulse;
    work.memory.is_sliding[idx(source.row)] = slides;
    if (row.a != 0 && row.b != 0) continue;
    ++result.solution.active;
    if (row.friction > 0.0) ++(slides ? result.slip.sliding : result.slip.sticking);
    const Vec3 p = row.impulse.x() * row.normal + row.impulse.y() * row.first +
                   row.impulse.z() * row.normal.cross(row.first);
    const double sign = row.a == 0 ? -1.0 : 1.0;
    list_pressing({work.model.rows[idx(source.row)].row.id, sign / work.dt * p}, result.pressing);
  }
  std::sort(result.pressing.begin(), result.pressing.end(), [](const auto& a, const auto& b) {
    const double x = a.force.squaredNorm(), y = b.force.squaredNorm();
    return x != y ? x > y : a.id < b.id;
  });
}

/// Of the world's next step the bodies next to the one in the hand have made this.
void keep_bodies(const HandWork& work, double share) THIGMA_RT {
  if (!work.goes) return;
  HandMemory& memory = work.memory;
  for (std::size_t i = 1; i < work.model.bodies.size(); ++i) {
    memory.states[i] = work.s.next[i];
    if (work.s.place[i] >= 0)
      memory.velocities[i] = share * work.s.bodies[idx(work.s.place[i])].velocity;
  }
  memory.left -= work.dt;
}

/// Surfaces that met in the step stop each other at its end, as in the world's; they do not spring
/// back.
void collide(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  bool any_met = false;
  for (std::size_t r = 0; r < s.rows.size() && !any_met; ++r)
    any_met =
        detail::has_met(s.rows[r], s.sources[r], work.model.pairs[idx(s.sources[r].pair)].slop);
  if (!any_met) return;
  detail::turn_rows(work);
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    if (s.place[i] < 0) continue;
    IslandBody& body = s.bodies[idx(s.place[i])];
    body.free = body.velocity;
    if (!work.model.bodies[i].is_solved) continue;
    body.metric =
        detail::mass_matrix(i == 0 ? work.at.body : work.model.bodies[i].rigid, s.next[i]);
  }
  s.solve.newton_left = std::max(kHandNewton - work.memory.newton, 0);
  const detail::CutSolution cut =
      detail::solve_cut(s.bodies, s.rows, s.sources, {}, s.cut, s.solve);
  work.memory.newton += cut.solution.newton;
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    if (s.place[i] < 0) continue;
    IslandBody& body = s.bodies[idx(s.place[i])];
    if (!cut.solution.is_whole) body.velocity = body.free;
    if (!cut.solution.is_whole || !work.model.bodies[i].is_solved) continue;
    s.next[i].linear_momentum += body.impulse.head<3>();
    s.next[i].angular_momentum += body.impulse.tail<3>();
  }
}

}  // namespace

void reserve_hand_step(HandScratch& s) {
  reserve_island(kHandBodies, kHandRows, s.solve, kHandJoints * detail::kJointPlaces);
  detail::reserve_cut(kHandPairs, kHandRows, s.cut);
  s.bodies.reserve(kHandBodies);
  s.rows.reserve(kHandRows);
  s.sources.reserve(kHandRows);
  s.joint_rows.rows.reserve(kHandJoints * detail::kJointPlaces);
  s.joint_rows.sources.reserve(kHandJoints * detail::kJointPlaces);
  s.joints.resize(kHandJoints);
}

HandCorrection take_hand_model(const HandModel& model, BodyState& held,
                               HandMemory& memory) THIGMA_RT {
  memory.sequence = model.sequence;
  memory.left = model.step;
  std::array<BodyState, kHandBodies> states;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    states[i] = memory.states[i] = model.bodies[i].state;
    memory.velocities[i] = model.bodies[i].velocity;
  }
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    memory.impulses[i] = model.rows[i].impulse;
    memory.is_sliding[i] = model.rows[i].is_sliding;
  }
  for (std::size_t k = 0; k < model.joints.size(); ++k) memory.joints[k] = model.joints[k].impulse;

  HandCorrection correction;
  // A gap may be as small as the world has it, and no smaller than none.
  std::array<double, kHandRows> least;
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    const HandRow& row = model.rows[i];
    const HandPairAt at = detail::pair_at(model.pairs[idx(row.pair)], states);
    least[i] = std::min(row_at(row.row, at.relative.position, at.rotation).gap, 0.0);
  }
  const auto of = [&](std::size_t row) { return least[row]; };
  const BodyState from = states[0];
  states[0] = held;
  if (is_within(model, states, of)) return correction;
  double inside = 0.0, outside = 1.0;
  for (int turn = 0; turn < 12; ++turn) {
    const double middle = 0.5 * (inside + outside);
    states[0] = between(from, held, middle);
    (is_within(model, states, of) ? inside : outside) = middle;
  }
  const BodyState back = between(from, held, inside);
  correction.way = travel_between(held, back, model.reach);
  held.position = back.position;
  held.orientation = back.orientation;
  return correction;
}

ConstrainedStep step_hand(const HandModel& model, const BodyAtState& at, const StepForces& forces,
                          double dt, HandMemory& memory, HandScratch& s) THIGMA_RT {
  ConstrainedStep result;
  constexpr double kWhole = 0.5;  // of a step: what is left of the world's is one
  const HandWork work{model, at, forces, dt, memory.left > kWhole * dt, memory, s};
  memory.newton = 0;
  detail::take_joints(model, s);
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
  keep_rows(work, result);
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
  if (!is_within(model, s.next, of)) {
    result.is_held_back = true;
    share = share_within(work, of);
  } else if (solution.is_whole) {
    collide(work);
  }
  memory.is_cut_short = memory.newton >= kHandNewton;
  result.state = s.next[0];
  keep_bodies(work, share);
  return result;
}

}  // namespace thigma
