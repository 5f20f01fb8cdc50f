#include "thigma/dynamics/constrained_step.h"

#include <algorithm>
#include <cmath>

#include "thigma/dynamics/detail/impacts.h"
#include "thigma/dynamics/detail/row_memory.h"
#include "thigma/dynamics/implicit_step.h"
#include "thigma/math/infinity.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

/// Speed at which a gap may close, or has to open, in a step.
double limit_of(double gap, const ConstraintParams& params, double dt) THIGMA_RT {
  const double room = gap - params.slop;
  if (room >= 0.0) return room / dt;
  return -std::min(params.recovery * -room / dt, params.recovery_speed);
}

/// How the rows stand before a step.
struct GapsBefore {
  double least = kInfinity;           // [m]
  std::array<double, kMaxRows> kept;  // what the step is to leave of each: no more than slop [m]
};

/// The rows at a state, as inequalities on the velocity.
void evaluate(const StepBounds& bounds, const BodyState& state, const Mat3& rotation,
              VelocityRows& rows, GapsBefore& gaps) THIGMA_RT {
  const ConstraintModel& model = bounds.model;
  rows.count = static_cast<int>(model.rows.size());
  for (std::size_t i = 0; i < model.rows.size(); ++i) {
    const RowAtState at = row_at(model.rows[i], state.position, rotation);
    const Vec3 moment = at.arm.cross(at.normal);
    for (std::size_t k = 0; k < 3; ++k) {
      rows.gradient[k][i] = at.normal[static_cast<Eigen::Index>(k)];
      rows.gradient[k + 3][i] = moment[static_cast<Eigen::Index>(k)];
    }
    rows.limit[i] = limit_of(at.gap, bounds.params, bounds.dt);
    rows.friction[i] = model.rows[i].friction;
    rows.arm[i] = at.arm;
    rows.tangent[i] = tangents_of(at.normal).first;
    gaps.least = std::min(gaps.least, at.gap);
    gaps.kept[i] = std::min(at.gap, bounds.params.slop);
  }
}

Mat3 world_inertia(const BodyAtState& at) THIGMA_RT {
  const Mat3& rotation = at.kinematics.rotation;
  return rotation * at.body.inertia * rotation.transpose();
}

/// What a step works on.
struct StepWork {
  const BodyAtState& at;  // before
  const StepBounds& bounds;
  Mat3 inertia;  // [world]

  BodyState after(const Vec6& velocity) const THIGMA_RT {
    BodyState next;
    const Vec3 linear = velocity.head<3>(), angular = velocity.tail<3>();
    next.linear_momentum = at.body.mass * linear;
    next.angular_momentum = inertia * angular;
    next.position = at.state.position + bounds.dt * linear;
    next.orientation = unit(rotation_from_vector(bounds.dt * angular) * at.state.orientation);
    return next;
  }
};

Vec6 velocity_of(const BodyAtState& at) THIGMA_RT {
  Vec6 velocity;
  velocity << at.state.linear_momentum / at.body.mass,
      at.kinematics.inverse_inertia * at.state.angular_momentum;
  return velocity;
}

/// Bound on the speed of any point of the body [m/s].
double speed_bound(const BodyAtState& at, double reach) THIGMA_RT {
  const Vec3 turn = at.kinematics.inverse_inertia * at.state.angular_momentum;
  return at.state.linear_momentum.norm() / at.body.mass + reach * turn.norm();
}

double least_gap(const ConstraintModel& model, const BodyState& state) THIGMA_RT {
  double least = kInfinity;
  const Mat3 rotation = rotation_matrix(state.orientation);
  for (const ContactRow& row : model.rows)
    least = std::min(least, row_at(row, state.position, rotation).gap);
  return least;
}

/// How the rows stand after a step.
struct GapsAfter {
  double least = kInfinity;  // [m]
  bool is_short = false;     // less is left of a gap than there was, and less than half of slop
  std::array<double, kMaxRows> gap;  // [m]
};

void find_gaps(const StepBounds& bounds, const BodyState& after, const GapsBefore& before,
               GapsAfter& gaps) THIGMA_RT {
  constexpr double kSame = 0.999;  // but for rounding
  const Mat3 rotation = rotation_matrix(after.orientation);
  gaps.least = kInfinity;
  gaps.is_short = false;
  for (std::size_t i = 0; i < bounds.model.rows.size(); ++i) {
    const double gap = row_at(bounds.model.rows[i], after.position, rotation).gap;
    const double kept = before.kept[i];
    gaps.gap[i] = gap;
    gaps.least = std::min(gaps.least, gap);
    const double enough = std::min(kSame * kept, 0.5 * bounds.params.slop);
    gaps.is_short = gaps.is_short || (kept > 0.0 && gap < enough);
  }
}

/// What a step is solved for: the metric and the velocity without rows.
struct FreeMotion {
  const Mat6& metric;
  const Vec6& velocity;
};

void timed_solve(const FreeMotion& free, const VelocityRows& rows, std::int64_t (*clock)() noexcept,
                 RowImpulses& impulses, ConstrainedStep& result) THIGMA_RT {
  const bool is_timed = clock != nullptr && rows.count > 0;
  const std::int64_t begin = is_timed ? clock() : 0;
  result.solution = solve_rows(free.metric, free.velocity, rows, impulses);
  if (is_timed) result.solve_ns += clock() - begin;
}

Vec6 found(const FreeMotion& free, const ConstrainedStep& result) THIGMA_RT {
  return result.solution.active == 0 ? free.velocity : result.solution.velocity;
}

/// Solves; where rows contradict each other, again without those that throw the body back, then
/// with those to recover along at rest.
Vec6 solve(const FreeMotion& free, const StepBounds& bounds, VelocityRows& rows,
           RowImpulses& impulses, ConstrainedStep& result) THIGMA_RT {
  const auto clock = bounds.clock;
  const std::size_t own = bounds.model.rows.size();
  timed_solve(free, rows, clock, impulses, result);
  if (!result.solution.is_whole && rows.count > static_cast<int>(own)) {
    rows.count = static_cast<int>(own);
    timed_solve(free, rows, clock, impulses, result);
  }
  if (!result.solution.is_whole) {
    result.is_squeezed = true;
    for (int i = 0; i < rows.count; ++i) {
      double& limit = rows.limit[static_cast<std::size_t>(i)];
      limit = std::max(limit, 0.0);
    }
    timed_solve(free, rows, clock, impulses, result);
  }
  return result.solution.is_whole ? found(free, result) : Vec6(Vec6::Zero());
}

/// How a step moves the body.
struct StepMotion {
  Vec6 velocity;
  BodyState state;  // after it
  GapsAfter gaps;
};

/// Solves again with limits lowered by what turning made of the gaps beyond their linear change.
/// Once is enough: the object then turns less where a gap closes. A correction that other rows
/// forbid is none.
void correct(const StepWork& work, const FreeMotion& free, const GapsBefore& before,
             VelocityRows& rows, RowImpulses& impulses, ConstrainedStep& result,
             StepMotion& motion) THIGMA_RT {
  if (!motion.gaps.is_short) return;
  const StepBounds& bounds = work.bounds;
  const std::array<double, kMaxRows> limit = rows.limit;
  const RowImpulses pressed = impulses;
  const RowSolution solution = result.solution;
  for (std::size_t i = 0; i < bounds.model.rows.size(); ++i)
    rows.limit[i] -= std::max(before.kept[i] - motion.gaps.gap[i], 0.0) / bounds.dt;
  timed_solve(free, rows, bounds.clock, impulses, result);
  if (!result.solution.is_whole) {
    rows.limit = limit;
    impulses = pressed;
    result.solution = solution;
    return;
  }
  motion.velocity = found(free, result);
  motion.state = work.after(motion.velocity);
  find_gaps(bounds, motion.state, before, motion.gaps);
}

/// The largest share of a step, to 2^-12, that ends within the travel, no gap below a least. Where
/// that is none of it, to 2^-24: between surfaces that lie on each other the travel is a small
/// share of what the hand wants, and the object has to come loose in such steps.
double share_within(const StepWork& work, const Vec6& velocity, double least) THIGMA_RT {
  const ConstraintModel& model = work.bounds.model;
  double inside = 0.0, outside = 1.0;
  for (int turn = 0; turn < 12 || (inside == 0.0 && turn < 24); ++turn) {
    const double middle = 0.5 * (inside + outside);
    const BodyState y = work.after(middle * velocity);
    (!is_beyond(model, y) && least_gap(model, y) >= least ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

Mat6 step_metric(const BodyAtState& at, const WrenchJacobian& jacobian, double dt) THIGMA_RT {
  const RigidBody& body = at.body;
  const Mat3 inertia = world_inertia(at);
  Mat6 metric = Mat6::Zero();
  metric.topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
  metric.bottomRightCorner<3, 3>() = inertia;
  metric.leftCols<3>() -= dt * body.mass * jacobian.middleCols<3>(7);
  metric.rightCols<3>() -= dt * jacobian.rightCols<3>() * inertia;
  metric.leftCols<3>() -= dt * dt * jacobian.leftCols<3>();
  metric.rightCols<3>() -= dt * dt * jacobian.middleCols<4>(3) * rate_matrix(at.state.orientation);
  const Mat6 transposed = metric.transpose();
  return 0.5 * (metric + transposed);
}

ConstrainedStep constrained_step(const BodyAtState& at, const StepForces& forces,
                                 const StepBounds& bounds, RowMemory& memory) THIGMA_RT {
  ConstrainedStep result;
  const ConstraintModel& model = bounds.model;
  const double dt = bounds.dt;
  const StepWork work{at, bounds, world_inertia(at)};
  const BodyState unbound = implicit_step(at, forces.wrench, forces.jacobian, dt);
  Vec6 free;
  free << unbound.linear_momentum / at.body.mass,
      at.kinematics.inverse_inertia * unbound.angular_momentum;

  VelocityRows rows;
  RowImpulses impulses;
  detail::recall(model, memory, impulses);
  GapsBefore before;
  evaluate(bounds, at.state, at.kinematics.rotation, rows, before);
  result.least_gap = before.least;
  // A model that came after the object had left its travel: its rows say nothing here, and the
  // object waits for the next.
  const bool is_late = is_beyond(model, at.state);
  if (is_late) result.least_gap = kInfinity;
  const Mat6 metric = step_metric(at, forces.jacobian, dt);
  const FreeMotion unheld{metric, free};
  detail::add_bounces(memory, rows);
  StepMotion motion;
  motion.velocity = solve(unheld, bounds, rows, impulses, result);
  motion.state = motion.velocity == free ? unbound : work.after(motion.velocity);
  find_gaps(bounds, motion.state, before, motion.gaps);
  if (!is_late) correct(work, unheld, before, rows, impulses, result, motion);
  result.state = motion.state;
  if (!bounds.pairs.empty()) {
    const Vec6 speed = velocity_of(at);
    result.impacts = detail::find_impacts({bounds, rows, impulses, speed, free}, memory);
    detail::note_bounces(result.impacts, bounds, memory);
  }
  detail::keep(model, impulses, memory);
  detail::list_pressing(model, rows, impulses, dt, result.pressing);
  if (result.solution.is_whole) result.slip = result.solution.slip;
  result.contact = {result.solution.impulse.head<3>() / dt, result.solution.impulse.tail<3>() / dt};
  result.wanted_speed = travel_between(at.state, result.state, model.reach) / dt;
  result.wanted_gain = std::max(result.wanted_speed - speed_bound(at, model.reach), 0.0) / dt;

  result.is_held_back = is_beyond(model, result.state);
  const double least = std::min(result.least_gap, 0.0);
  if (result.is_held_back || motion.gaps.least < least) {
    const double share = share_within(work, motion.velocity, least);
    result.state = work.after(share * motion.velocity);
    result.slip.work *= share;
  }
  return result;
}

}  // namespace thigma
