#include "thigma/multibody/detail/jointed_island.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

/// An island with joints in a part of a step.
struct Jointed {
  Part& part;
  const Island& island;
  double share = 1.0;  // the island's

  std::int32_t body(std::int32_t place) const noexcept {
    return part.s.islands.body[idx(island.first_body + place)];
  }
  BodyKind kind(std::int32_t place) const noexcept { return moved_by(part, body(place)); }
  std::span<IslandBody> bodies() const noexcept {
    return {part.s.islands.bodies.data() + island.first_body, idx(island.bodies)};
  }
  std::span<IslandRow> rows() const noexcept {
    return {part.s.islands.rows.data() + island.first_row, idx(island.rows)};
  }
};

Quat cayley(const Vec3& turn) noexcept {
  return unit(Quat(1.0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()));
}

/// Of what acts through the part in V where nothing meets: a half where V is a mean.
double share_of(const Part& part, const Island& island) noexcept {
  for (std::int32_t i = 0; i < island.bodies; ++i) {
    const std::int32_t body = part.s.islands.body[idx(island.first_body + i)];
    if (moved_by(part, body) != BodyKind::moving) return 1.0;
  }
  return 0.5;
}

JointMotor motor_of(const Part& part, std::int32_t joint) noexcept {
  JointMotor motor = part.world.joints[idx(joint)].motor;
  for (const MotorDrive& drive : part.inputs.motors)
    if (drive.joint == joint) motor.target = drive.target;
  return motor;
}

JointPart part_of(const Jointed& jointed, std::int32_t joint) noexcept {
  const Part& part = jointed.part;
  const Islands& islands = part.s.islands;
  const WorldJoint& j = part.world.joints[idx(joint)];
  JointPart out{j, joint};
  out.arm = part.world.joint_arm[idx(joint)];
  out.motor = motor_of(part, joint);
  const auto local = [&](std::int32_t body) {
    const std::int32_t place = body < 0 ? -1 : islands.place[idx(body)];
    return place < 0 ? -1 : place - jointed.island.first_body;
  };
  out.a = local(j.a);
  out.b = local(j.b);
  out.dt = part.dt;
  out.share = jointed.share;
  return out;
}

/// What a moving body would do without its rows, so that A (u - free) is what they have to give:
/// exact at the velocity u of the turn before.
void find_free(const Jointed& jointed, std::int32_t place) noexcept {
  const Part& part = jointed.part;
  const std::int32_t body = jointed.body(place);
  const RigidBody& rigid = part.world.rigid[idx(body)];
  const BodyState& y = part.state.bodies[idx(body)];
  IslandBody& out = jointed.bodies()[idx(place)];
  const double share = jointed.share;
  const Vec3 omega = out.velocity.tail<3>();
  const Quat turn = cayley(part.dt * omega), half = cayley(0.5 * part.dt * omega);
  const Mat3 turned = rotation_matrix(turn), begin = rotation_matrix(y.orientation);
  const Mat3 middle = rotation_matrix(half) * begin;
  const Mat3 inertia = middle * rigid.inertia * middle.transpose();
  const Vec3 impulse = out.impulse.tail<3>() - part.s.joint_through[idx(place)].tail<3>();
  const Vec3& momentum = y.angular_momentum;
  const Vec3 kept = (1.0 - share) * (turned * momentum) + share * momentum;
  const Vec3 early = (1.0 - share) * (turned * impulse - impulse);
  const Vec3 given =
      turned * (begin * (rigid.inertia * (begin.transpose() * omega))) - kept - early;
  out.metric.setZero();
  out.metric.topLeftCorner<3, 3>() = rigid.mass * Mat3::Identity();
  out.metric.bottomRightCorner<3, 3>() = inertia;
  out.free.head<3>() = y.linear_momentum / rigid.mass + share * part.dt * rigid.gravity;
  out.free.tail<3>() = omega - inertia.ldlt().solve(given);
}

/// Velocities to begin with, and what acts without rows.
void begin(const Jointed& jointed) noexcept {
  const Part& part = jointed.part;
  for (std::int32_t i = 0; i < jointed.island.bodies; ++i) {
    IslandBody& body = jointed.bodies()[idx(i)];
    body.impulse.setZero();
    part.s.joint_through[idx(i)].setZero();
    body.velocity = body.free;
    if (jointed.kind(i) != BodyKind::moving) continue;
    const std::int32_t number = jointed.body(i);
    body.velocity = velocity_of(part.world.rigid[idx(number)], part.state.bodies[idx(number)]);
    body.velocity.head<3>() += jointed.share * part.dt * part.world.rigid[idx(number)].gravity;
  }
}

/// Momenta after the part, and poses.
void go(const Jointed& jointed) noexcept {
  auto& s = jointed.part.s;
  for (std::int32_t i = 0; i < jointed.island.bodies; ++i) {
    const std::int32_t number = jointed.body(i);
    const IslandBody& body = jointed.bodies()[idx(i)];
    const RigidBody& rigid = jointed.part.world.rigid[idx(number)];
    const BodyState& y = jointed.part.state.bodies[idx(number)];
    const Vec6 all = body.impulse + (1.0 / jointed.share - 1.0) * s.joint_through[idx(i)];
    s.joint_momentum[idx(number)] << y.linear_momentum + all.head<3>() +
                                         jointed.part.dt * rigid.mass * rigid.gravity,
        y.angular_momentum + all.tail<3>();
    s.is_jointed[idx(number)] = 1;
    s.next[idx(number)] = after_jointed(jointed.part, number, body.velocity, 1.0);
  }
}

void list_rows(const Jointed& jointed) {
  auto& s = jointed.part.s;
  s.joint_rows.rows.clear();
  s.joint_rows.sources.clear();
  for (std::int32_t k = 0; k < jointed.island.joints; ++k) {
    const std::int32_t number = s.islands.joint[idx(jointed.island.first_joint + k)];
    JointPart joint = part_of(jointed, number);
    joint.begin = joint_ends(joint.joint, jointed.part.state.bodies);
    joint.end = joint_ends(joint.joint, s.next);
    if (joint.a >= 0) joint.u_a = jointed.bodies()[idx(joint.a)].velocity;
    if (joint.b >= 0) joint.u_b = jointed.bodies()[idx(joint.b)].velocity;
    list_part_rows(joint, s.joint_part[idx(number)], s.joint_rows);
  }
}

/// Impulses of the solve: kept, and of what acts through the part their sum on each body.
void take_impulses(const Jointed& jointed) noexcept {
  auto& s = jointed.part.s;
  for (std::int32_t i = 0; i < jointed.island.bodies; ++i) s.joint_through[idx(i)].setZero();
  for (std::size_t r = 0; r < s.joint_rows.rows.size(); ++r) {
    const JointRow& row = s.joint_rows.rows[r];
    const JointRowSource& source = s.joint_rows.sources[r];
    s.joint_part[idx(source.joint)][source.place] = row.impulse;
    const bool is_through = source.kind == JointRowKind::hold ||
                            source.kind == JointRowKind::spring ||
                            source.kind == JointRowKind::servo;
    if (!is_through) continue;
    if (row.a >= 0) s.joint_through[idx(row.a)] -= row.impulse * row.on_a;
    if (row.b >= 0) s.joint_through[idx(row.b)] -= row.impulse * row.on_b;
  }
}

/// Largest error of the island's joints where it ends, over what rounding leaves.
bool is_met(const Jointed& jointed) noexcept {
  const auto& s = jointed.part.s;
  constexpr double kMet = 1e-11, kRounding = 1e-15;  // of the size; of the place
  for (std::int32_t k = 0; k < jointed.island.joints; ++k) {
    const std::int32_t number = s.islands.joint[idx(jointed.island.first_joint + k)];
    const WorldJoint& joint = jointed.part.world.joints[idx(number)];
    const double arm = jointed.part.world.joint_arm[idx(number)];
    const double far = s.next[idx(joint.a)].position.norm();
    std::array<double, 6> errors{};
    const int count = joint_errors(joint.kind, joint_ends(joint, s.next), arm, errors);
    for (std::size_t e = 0; e < idx(count); ++e)
      if (!(std::fabs(errors[e]) <= kMet * arm + kRounding * far)) return false;
  }
  return true;
}

/// One solve; returns by how much velocities changed, of the largest there is with rows or without.
double solve(const Jointed& jointed) {
  Part& part = jointed.part;
  auto& s = part.s;
  for (std::int32_t i = 0; i < jointed.island.bodies; ++i) {
    s.joint_before[idx(i)] = jointed.bodies()[idx(i)].velocity;
    if (jointed.kind(i) == BodyKind::moving) find_free(jointed, i);
  }
  solve_rows(part, jointed.island, jointed.bodies(), s.joint_rows.rows);
  double most = 0.0, moved = 0.0;
  for (std::int32_t i = 0; i < jointed.island.bodies; ++i) {
    const double reach = part.world.boxes[idx(part.world.shape[idx(jointed.body(i))])].reach;
    const auto speed = [&](const Vec6& u) {
      return u.head<3>().norm() + reach * u.tail<3>().norm();
    };
    const Vec6& u = jointed.bodies()[idx(i)].velocity;
    most = std::max({most, speed(u), speed(jointed.bodies()[idx(i)].free)});
    moved = std::max(moved, speed(u - s.joint_before[idx(i)]));
  }
  return most > 0.0 ? moved / most : 0.0;
}

/// Solves again and again, at the joints where the velocities of the turn before take them.
void turn_and_solve(const Jointed& jointed) {
  begin(jointed);
  go(jointed);
  constexpr int kTurns = 12, kCorrections = 2;  // a turn leaves about dt w of the error
  constexpr double kSettled = 1e-9;  // of the velocities, with rows and without: as the solve is
  int corrections = 0;
  for (int turn = 0; turn < kTurns; ++turn) {
    list_rows(jointed);
    const double change = solve(jointed);
    take_impulses(jointed);
    go(jointed);
    if (corrections < kCorrections && correct_limits(jointed.part, jointed.island)) {
      ++corrections;
      continue;
    }
    if (change <= kSettled && is_met(jointed)) break;
  }
}

/// Whether surfaces or limits press, by the last solve of the island or of the step before.
bool presses(const Jointed& jointed) noexcept {
  const auto& s = jointed.part.s;
  for (const IslandRow& row : jointed.rows())
    if (row.impulse.x() > 0.0) return true;
  for (std::int32_t k = 0; k < jointed.island.joints; ++k) {
    const std::int32_t number = s.islands.joint[idx(jointed.island.first_joint + k)];
    const JointImpulses& given = s.joint_part[idx(number)];
    if (given[kLowerPlace] > 0.0 || given[kUpperPlace] > 0.0) return true;
  }
  return false;
}

}  // namespace

BodyState after_jointed(const Part& part, std::int32_t body, const Vec6& velocity,
                        double share) noexcept {
  const RigidBody& rigid = part.world.rigid[idx(body)];
  const BodyState& y = part.state.bodies[idx(body)];
  const Vec3 linear = velocity.head<3>(), angular = velocity.tail<3>();
  const double dt = share * part.dt;
  BodyState next = y;
  next.position += dt * linear;
  if (part.world.bodies[idx(body)].kind == BodyKind::prescribed) {
    next.orientation = unit(rotation_from_vector(dt * angular) * y.orientation);
    next.linear_momentum = next.angular_momentum = Vec3::Zero();
    return next;
  }
  next.orientation = unit(cayley(dt * angular) * y.orientation);
  next.linear_momentum = part.s.joint_momentum[idx(body)].head<3>();
  next.angular_momentum = part.s.joint_momentum[idx(body)].tail<3>();
  if (moved_by(part, body) == BodyKind::moving) return next;
  const Mat3 rotation = rotation_matrix(y.orientation);
  next.linear_momentum = rigid.mass * linear;
  next.angular_momentum = rotation * (rigid.inertia * (rotation.transpose() * angular));
  return next;
}

void solve_jointed(Part& part, Island& island) {
  const double usual = share_of(part, island);
  island.share = usual;
  if (presses({part, island, usual})) island.share = 1.0;
  turn_and_solve({part, island, island.share});
  // What presses does so at the beginning and whole, with what joints add to it.
  const double right = presses({part, island, island.share}) ? 1.0 : usual;
  if (island.share == right) return;
  island.share = right;
  turn_and_solve({part, island, island.share});
}

void count_joints(Part& part, const Island& island) noexcept {
  auto& s = part.s;
  for (std::int32_t k = 0; k < island.joints; ++k) {
    const std::int32_t number = s.islands.joint[idx(island.first_joint + k)];
    const JointImpulses& given = s.joint_part[idx(number)];
    const bool is_servo = part.world.joints[idx(number)].motor.is_servo;
    for (std::size_t place = 0; place < kJointPlaces; ++place) {
      const bool is_through = place <= kSpringPlace || (place == kMotorPlace && is_servo);
      const double whole = is_through ? 1.0 / island.share : 1.0;
      s.joint_sum[idx(number)][place] += whole * given[place];
    }
  }
}

void list_joint_ends(Part& part, const Island& island, std::span<const BodyState> states) {
  const Jointed jointed{part, island};
  auto& s = part.s;
  s.joint_rows.rows.clear();
  s.joint_rows.sources.clear();
  for (std::int32_t k = 0; k < island.joints; ++k) {
    const std::int32_t number = s.islands.joint[idx(island.first_joint + k)];
    JointPart joint = part_of(jointed, number);
    joint.begin = joint.end = joint_ends(joint.joint, states);
    list_end_rows(joint, s.joint_part[idx(number)], s.joint_end[idx(number)], s.joint_rows);
    s.joint_end[idx(number)].fill(0.0);
  }
}

void keep_joint_ends(Part& part) noexcept {
  auto& s = part.s;
  for (std::size_t r = 0; r < s.joint_rows.rows.size(); ++r) {
    const JointRowSource& source = s.joint_rows.sources[r];
    const double impulse = s.joint_rows.rows[r].impulse;
    s.joint_end[idx(source.joint)][source.place] = impulse;
    s.joint_sum[idx(source.joint)][source.place] += impulse;
  }
}

double joint_error(const World& world, std::span<const BodyState> states) noexcept {
  double most = 0.0;
  for (std::size_t i = 0; i < world.joints.size(); ++i) {
    std::array<double, 6> errors{};
    const int count = joint_errors(world.joints[i].kind, joint_ends(world.joints[i], states),
                                   world.joint_arm[i], errors);
    for (std::size_t k = 0; k < idx(count); ++k) most = std::max(most, std::fabs(errors[k]));
  }
  return most;
}

}  // namespace thigma::detail
