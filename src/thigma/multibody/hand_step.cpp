#include "thigma/multibody/hand_step.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/dynamics/implicit_step.h"
#include "thigma/math/infinity.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/pair_models.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma {
namespace {

using detail::RowSource;

/// What a step works on.
struct Work {
  const HandModel& model;
  const BodyAtState& at;
  const StepForces& forces;
  double dt;
  bool goes;  // the bodies next to the one in the hand, in this step
  HandMemory& memory;
  HandScratch& s;
};

/// A pair at poses.
struct PairAt {
  BodyState relative;
  Mat3 rotation;
};
PairAt pair_at(const HandPair& pair, std::span<const BodyState> states) THIGMA_RT {
  PairAt at;
  at.relative = detail::relative_state(states[idx(pair.first)], states[idx(pair.second)]);
  at.rotation = rotation_matrix(at.relative.orientation);
  return at;
}

/// Whether the body in the hand is where the model says all, no row of it below what it may be.
///
/// least   by row: the gap that it may have at least [m]
template <class Least>
bool is_within(const HandModel& model, std::span<const BodyState> states, Least least) THIGMA_RT {
  if (travel_between(model.bodies[0].state, states[0], model.reach) > model.room) return false;
  std::int32_t known = -1;
  PairAt at;
  for (const HandPair& pair : model.pairs) {
    if (!pair.is_guarded()) continue;
    at = pair_at(pair, states);
    if (travel_between(pair.state, at.relative, pair.reach) > pair.travel) return false;
  }
  for (std::size_t r = 0; r < model.rows.size(); ++r) {
    const HandRow& row = model.rows[r];
    const HandPair& pair = model.pairs[idx(row.pair)];
    if (!pair.is_guarded()) continue;
    if (row.pair != known) at = pair_at(pair, states);
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

/// Which bodies are in the island, and the poses that the step begins at.
void place_bodies(const Work& work) THIGMA_RT {
  HandScratch& s = work.s;
  std::int32_t count = 0;
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    const HandBody& body = work.model.bodies[i];
    s.states[i] = i == 0 ? work.at.state : work.memory.states[i];
    const bool moves = i == 0 || (work.goes && (body.is_solved || body.velocity != Vec6::Zero()));
    s.place[i] = moves ? count++ : -1;
  }
}

/// Metrics and velocities without rows.
void fill_bodies(const Work& work) THIGMA_RT {
  HandScratch& s = work.s;
  const RigidBody& rigid = work.at.body;
  const BodyState unbound =
      implicit_step(work.at, work.forces.wrench, work.forces.jacobian, work.dt);
  IslandBody held;
  held.metric = step_metric(work.at, work.forces.jacobian, work.dt);
  held.free << unbound.linear_momentum / rigid.mass,
      work.at.kinematics.inverse_inertia * unbound.angular_momentum;
  s.bodies.clear();
  s.bodies.push_back(held);
  double most = held.metric.diagonal().head<3>().maxCoeff();
  for (const HandBody& body : work.model.bodies)
    if (body.is_solved) most = std::max(most, body.rigid.mass);
  for (std::size_t i = 1; i < work.model.bodies.size(); ++i) {
    if (s.place[i] < 0) continue;
    const HandBody& body = work.model.bodies[i];
    IslandBody out;
    out.free = work.memory.velocities[i];
    if (body.is_solved) {
      out.metric = detail::mass_matrix(body.rigid, s.states[i]);
      out.free.head<3>() += work.dt * body.rigid.gravity;
    } else {
      // So heavy that nothing stops it. More would cost digits.
      constexpr double kUnstoppable = 1e6;
      out.metric = kUnstoppable * most / body.rigid.mass *
                   detail::mass_matrix(body.rigid, s.states[i]);
    }
    s.bodies.push_back(out);
  }
}

void fill_rows(const Work& work) THIGMA_RT {
  HandScratch& s = work.s;
  s.rows.clear();
  s.sources.clear();
  std::int32_t known = -1;
  PairAt at;
  Mat3 turn = Mat3::Identity();
  for (std::size_t i = 0; i < work.model.rows.size(); ++i) {
    const HandRow& model = work.model.rows[i];
    const HandPair& pair = work.model.pairs[idx(model.pair)];
    IslandRow row;
    row.a = s.place[idx(pair.first)];
    row.b = s.place[idx(pair.second)];
    if (row.a < 0 && row.b < 0) continue;
    if (model.pair != known) {
      at = pair_at(pair, s.states);
      turn = rotation_matrix(s.states[idx(pair.second)].orientation);
      known = model.pair;
    }
    const RowAtState here = row_at(model.row, at.relative.position, at.rotation);
    if (!std::isfinite(here.gap)) continue;
    row.normal = turn * here.normal;
    row.first = turn * tangents_of(here.normal).first;
    row.arm_a = turn * here.arm;
    row.arm_b = turn * (at.relative.position + here.arm);
    row.limit = detail::limit_of(here.gap, pair.slop, work.dt);
    const Friction& friction = model.row.friction;
    row.friction = work.memory.is_sliding[i] ? friction.kinetic : friction.at_rest;
    row.impulse = work.memory.impulses[i];
    s.rows.push_back(row);
    s.sources.push_back({model.pair, static_cast<std::int32_t>(i),
                         std::max(here.gap - pair.slop, 0.0), here.gap,
                         std::max(-row.limit, 0.0)});
  }
}

/// Rows of the joints, from where the step begins to where the velocities of the last turn lead.
void fill_joints(const Work& work, bool is_first) THIGMA_RT {
  HandScratch& s = work.s;
  s.joint_rows.rows.clear();
  s.joint_rows.sources.clear();
  for (std::size_t k = 0; k < work.model.joints.size(); ++k) {
    const HandJoint& model = work.model.joints[k];
    const auto place = [&](std::int32_t body) { return body < 0 ? -1 : s.place[idx(body)]; };
    detail::JointPart part{s.joints[k], static_cast<std::int32_t>(k)};
    part.a = place(model.a);
    part.b = place(model.b);
    if (part.a < 0 && part.b < 0) continue;
    part.arm = model.arm;
    part.motor = model.motor;
    part.begin = joint_ends(s.joints[k], s.states);
    part.end = is_first ? part.begin : joint_ends(s.joints[k], s.next);
    part.dt = work.dt;
    if (!is_first) {
      if (part.a >= 0) part.u_a = s.bodies[idx(part.a)].velocity;
      if (part.b >= 0) part.u_b = s.bodies[idx(part.b)].velocity;
    }
    list_part_rows(part, work.memory.joints[k], s.joint_rows);
  }
}

void take_joints(const HandModel& model, HandScratch& s) THIGMA_RT {
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const HandJoint& from = model.joints[k];
    WorldJoint& to = s.joints[k];
    to.kind = from.kind;
    to.a = from.a;
    to.b = from.b;
    to.a_from_joint = from.a_from_joint;
    to.b_from_joint = from.b_from_joint;
    to.lower = from.lower;
    to.upper = from.upper;
    to.stiffness = from.stiffness;
    to.damping = from.damping;
    to.rest = from.rest;
    to.motor = from.motor;
  }
}

/// Where bodies are after a share of the step; momenta of what is solved are those of the velocity.
void go(const Work& work, double share) THIGMA_RT {
  HandScratch& s = work.s;
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    const BodyState& y = s.states[i];
    BodyState& next = s.next[i];
    next = y;
    if (s.place[i] < 0) continue;
    const Vec6 u = share * s.bodies[idx(s.place[i])].velocity;
    const Vec3 linear = u.head<3>(), angular = u.tail<3>();
    next.position = y.position + work.dt * linear;
    next.orientation = unit(rotation_from_vector(work.dt * angular) * y.orientation);
    if (!work.model.bodies[i].is_solved) continue;
    const RigidBody& rigid = i == 0 ? work.at.body : work.model.bodies[i].rigid;
    const Mat3 rotation = rotation_matrix(y.orientation);
    next.linear_momentum = rigid.mass * linear;
    next.angular_momentum = rotation * (rigid.inertia * (rotation.transpose() * angular));
  }
}

/// Rows that turning has closed ask for less; whether any does. As of the world's step.
bool correct_limits(const Work& work) THIGMA_RT {
  HandScratch& s = work.s;
  bool is_short = false;
  std::int32_t known = -1;
  PairAt at;
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const RowSource& source = s.sources[r];
    const HandPair& pair = work.model.pairs[idx(source.pair)];
    if (source.pair != known) at = pair_at(pair, s.next);
    known = source.pair;
    const ContactRow& row = work.model.rows[idx(source.row)].row;
    const double gap = row_at(row, at.relative.position, at.rotation).gap;
    const double kept = std::min(pair.slop, source.gap);
    constexpr double kShort = 0.5;  // of what is kept
    if (gap >= kShort * kept || !(kept > 0.0)) continue;
    is_short = true;
    s.rows[r].limit -= (kept - gap) / work.dt;
  }
  return is_short;
}

/// Solves; where rows contradict each other, again with those to recover along at rest.
IslandSolution solve(const Work& work, ConstrainedStep& result) THIGMA_RT {
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

void keep_joints(const Work& work) THIGMA_RT {
  const detail::JointRowList& list = work.s.joint_rows;
  for (std::size_t r = 0; r < list.rows.size(); ++r)
    work.memory.joints[idx(list.sources[r].joint)][list.sources[r].place] = list.rows[r].impulse;
}

/// As many turns as joints and turning take.
IslandSolution solve_turns(const Work& work, ConstrainedStep& result) THIGMA_RT {
  constexpr int kTurns = 3;
  IslandSolution solution;
  for (int turn = 0; turn < kTurns; ++turn) {
    fill_joints(work, turn == 0);
    solution = solve(work, result);
    keep_joints(work);
    go(work, 1.0);
    const bool is_short = turn + 1 < kTurns && correct_limits(work);
    if (!solution.is_whole || (!is_short && work.model.joints.empty())) break;
  }
  return solution;
}

/// The largest share of the step, to 2^-12, in which the body in the hand stays where the model
/// says all.
template <class Least>
double share_within(const Work& work, Least least) THIGMA_RT {
  double inside = 0.0, outside = 1.0;
  for (int turn = 0; turn < 12; ++turn) {
    const double middle = 0.5 * (inside + outside);
    go(work, middle);
    (is_within(work.model, work.s.next, least) ? inside : outside) = middle;
  }
  go(work, inside);
  return inside;
}

/// Puts a row among the strongest.
void list_pressing(const PressingRow& row, PressingRows& list) THIGMA_RT {
  if (list.push_back(row)) return;
  PressingRow* weakest = std::min_element(list.begin(), list.end(), [](const auto& a, const auto& b) {
    return a.force.squaredNorm() < b.force.squaredNorm();
  });
  if (weakest->force.squaredNorm() < row.force.squaredNorm()) *weakest = row;
}

/// What the rows did: kept for the next step, and told.
void keep_rows(const Work& work, ConstrainedStep& result) THIGMA_RT {
  HandScratch& s = work.s;
  for (std::size_t i = 0; i < work.model.rows.size(); ++i) {
    work.memory.impulses[i] = Vec3::Zero();
    work.memory.is_sliding[i] = false;
  }
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const IslandRow& row = s.rows[r];
    if (!(row.impulse.x() > 0.0)) continue;
    const RowSource& source = s.sources[r];
    constexpr double kRounding = 1e-6;
    const double most = row.friction * row.impulse.x();
    const bool is_sliding =
        std::sqrt(row.impulse.y() * row.impulse.y() + row.impulse.z() * row.impulse.z()) >=
        (1.0 - kRounding) * most;
    work.memory.impulses[idx(source.row)] = row.impulse;
    work.memory.is_sliding[idx(source.row)] = is_sliding;
    if (row.a != 0 && row.b != 0) continue;
    ++result.solution.active;
    if (row.friction > 0.0) ++(is_sliding ? result.slip.sliding : result.slip.sticking);
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
void keep_bodies(const Work& work, double share) THIGMA_RT {
  if (!work.goes) return;
  HandMemory& memory = work.memory;
  for (std::size_t i = 1; i < work.model.bodies.size(); ++i) {
    memory.states[i] = work.s.next[i];
    if (work.s.place[i] >= 0)
      memory.velocities[i] = share * work.s.bodies[idx(work.s.place[i])].velocity;
  }
  memory.left -= work.dt;
}

/// Rows that pressed, at the poses after the step, for a solve without time.
void turn_rows(const Work& work) THIGMA_RT {
  HandScratch& s = work.s;
  std::size_t kept = 0;
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    if (!(s.rows[r].impulse.x() > 0.0)) continue;
    const RowSource& source = s.sources[r];
    const HandPair& pair = work.model.pairs[idx(source.pair)];
    const PairAt at = pair_at(pair, s.next);
    const RowAtState here = row_at(work.model.rows[idx(source.row)].row, at.relative.position,
                                   at.rotation);
    if (!std::isfinite(here.gap)) continue;
    const Mat3 turn = rotation_matrix(s.next[idx(pair.second)].orientation);
    IslandRow row = s.rows[r];
    row.normal = turn * here.normal;
    row.first = turn * tangents_of(here.normal).first;
    row.arm_a = turn * here.arm;
    row.arm_b = turn * (at.relative.position + here.arm);
    row.limit = 0.0;
    row.impulse = Vec3::Zero();
    s.rows[kept] = row;
    s.sources[kept++] = source;
  }
  s.rows.resize(kept);
  s.sources.resize(kept);
}

/// Surfaces that met in the step stop each other at its end, as in the world's; they do not spring
/// back.
void collide(const Work& work) THIGMA_RT {
  HandScratch& s = work.s;
  constexpr double kTouch = 1e-6;  // of the gap that is kept: less is no way
  bool has_met = false;
  for (std::size_t r = 0; r < s.rows.size(); ++r)
    has_met = has_met || (s.rows[r].impulse.x() > 0.0 &&
                          s.sources[r].room > kTouch * work.model.pairs[idx(s.sources[r].pair)].slop);
  if (!has_met) return;
  turn_rows(work);
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
    const PairAt at = pair_at(model.pairs[idx(row.pair)], states);
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
  const Work work{model, at, forces, dt, memory.left > kWhole * dt, memory, s};
  memory.newton = 0;
  take_joints(model, s);
  place_bodies(work);
  fill_bodies(work);
  fill_rows(work);
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
