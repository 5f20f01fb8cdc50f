#include "thigma/multibody/detail/part_energy.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// What the reactions of a joint may do where it is met to rounding only [J].
double joint_slack(const Part& part, std::int32_t joint) noexcept {
  constexpr double kMet = 2e-11;  // of the size, of both ends
  const JointImpulses& given = part.s.joint_part[idx(joint)];
  double sum = 0.0;
  for (std::size_t place = 0; place < kSpringPlace; ++place) sum += std::fabs(given[place]);
  return sum / part.dt * kMet * part.world.joint_arm[idx(joint)];
}

}  // namespace

double energy_gain(const Part& part, const Island& island) noexcept {
  const auto& s = part.s;
  double gain = 0.0, allowed = 0.0;
  // Of the kinetic energy; of that without contacts, as the solve is no better; of the height.
  constexpr double kRounding = 1e-11, kSolve = 1e-9, kDigits = 1e-15;
  for (std::int32_t i = 0; i < island.bodies; ++i) {
    const std::int32_t body = s.islands.body[idx(island.first_body + i)];
    if (moved_by(part, body) != BodyKind::moving) return 0.0;
    const RigidBody& rigid = part.world.rigid[idx(body)];
    const BodyState &y = part.state.bodies[idx(body)], &next = s.next[idx(body)];
    const double before = kinetic_energy(rigid, y), after = kinetic_energy(rigid, next);
    gain += after - before - rigid.mass * rigid.gravity.dot(next.position - y.position);
    const IslandBody& free = s.free[idx(body)];
    allowed += kRounding * (after + before) + kSolve * free.free.dot(free.metric * free.free) +
               kDigits * rigid.mass * rigid.gravity.norm() * next.position.norm();
  }
  for (std::int32_t i = 0; i < island.rows; ++i) {
    const std::size_t r = idx(island.first_row + i);
    gain -= s.islands.rows[r].impulse.x() * s.islands.sources[r].lead;
  }
  for (std::int32_t k = 0; k < island.joints; ++k) {
    const WorldJoint& joint = part.world.joints[idx(s.islands.joint[idx(island.first_joint + k)])];
    if (joint.motor.is_on) return 0.0;
    allowed += joint_slack(part, s.islands.joint[idx(island.first_joint + k)]);
    if (!(joint.stiffness > 0.0)) continue;
    const double before = joint_energy(joint, part.state.bodies),
                 after = joint_energy(joint, s.next);
    gain += after - before;
    allowed += kRounding * (before + after);
  }
  return gain > allowed ? gain : 0.0;
}

bool take_back(const Part& part, const Island& island, double gain) noexcept {
  constexpr double kSmall = 0.1;  // of the kinetic energy
  auto& s = part.s;
  const auto rows = std::span(s.islands.rows).subspan(idx(island.first_row), idx(island.rows));
  const bool presses = std::any_of(rows.begin(), rows.end(), [](const IslandRow& row) {
    return row.impulse.x() > 0.0 && (row.a < 0 || row.b < 0);
  });
  double energy = 0.0;
  for (std::int32_t i = 0; i < island.bodies; ++i) {
    const std::int32_t body = s.islands.body[idx(island.first_body + i)];
    energy += kinetic_energy(part.world.rigid[idx(body)], s.next[idx(body)]);
  }
  if (!presses || !(gain <= kSmall * energy)) return false;
  const double share = std::sqrt(1.0 - gain / energy);
  for (std::int32_t i = 0; i < island.bodies; ++i) {
    BodyState& next = s.next[idx(s.islands.body[idx(island.first_body + i)])];
    next.linear_momentum *= share;
    next.angular_momentum *= share;
  }
  return true;
}

}  // namespace thigma::detail
