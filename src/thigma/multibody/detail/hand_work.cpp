#include "thigma/multibody/detail/hand_work.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/dynamics/implicit_step.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/pair_models.h"
#include "thigma/multibody/detail/row_rules.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma::detail {

HandPairAt pair_at(const HandPair& pair, std::span<const BodyState> states) THIGMA_RT {
  HandPairAt at;
  at.relative = relative_state(states[idx(pair.first)], states[idx(pair.second)]);
  at.rotation = rotation_matrix(at.relative.orientation);
  return at;
}

void place_bodies(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  std::int32_t count = 0;
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    const HandBody& body = work.model.bodies[i];
    s.states[i] = i == 0 ? work.at.state : work.memory.states[i];
    const bool moves = i == 0 || (work.goes && (body.is_solved || body.velocity != Vec6::Zero()));
    s.place[i] = moves ? count++ : -1;
  }
}

void fill_bodies(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  const RigidBody& rigid = work.at.body;
  const BodyState unbound =
      implicit_step(work.at, work.forces.wrench, work.forces.jacobian, work.dt);
  IslandBody held;
  held.metric = step_metric(work.at, work.forces.jacobian, work.dt);
  held.free << unbound.linear_momentum / rigid.mass,
      work.at.kinematics.inverse_inertia * unbound.angular_momentum;
  // Solves begin with the velocities of the step before.
  held.velocity << work.at.state.linear_momentum / rigid.mass,
      work.at.kinematics.inverse_inertia * work.at.state.angular_momentum;
  s.bodies.clear();
  s.bodies.push_back(held);
  double most = held.metric.diagonal().head<3>().maxCoeff();
  for (const HandBody& body : work.model.bodies)
    if (body.is_solved) most = std::max(most, body.rigid.mass);
  for (std::size_t i = 1; i < work.model.bodies.size(); ++i) {
    if (s.place[i] < 0) continue;
    const HandBody& body = work.model.bodies[i];
    IslandBody out;
    out.free = out.velocity = work.memory.velocities[i];
    if (body.is_solved) {
      out.metric = mass_matrix(body.rigid, s.states[i]);
      out.free.head<3>() += work.dt * body.rigid.gravity;
    } else {
      // So heavy that nothing stops it. More would cost digits.
      constexpr double kUnstoppable = 1e6;
      out.metric = kUnstoppable * most / body.rigid.mass * mass_matrix(body.rigid, s.states[i]);
    }
    s.bodies.push_back(out);
  }
}

void fill_rows(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  s.rows.clear();
  s.sources.clear();
  std::int32_t known = -1;
  HandPairAt at;
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
    place_row(here, turn, at.relative.position, row);
    row.limit = limit_of(here.gap, pair.slop, work.dt);
    const Friction& friction = model.row.friction;
    row.friction = work.memory.is_sliding[i] ? friction.kinetic : friction.at_rest;
    row.impulse = work.memory.impulses[i];
    s.rows.push_back(row);
    s.sources.push_back({model.pair, static_cast<std::int32_t>(i),
                         std::max(here.gap - pair.slop, 0.0), here.gap, std::max(-row.limit, 0.0)});
  }
}

void fill_joints(const HandWork& work, bool is_first) THIGMA_RT {
  HandScratch& s = work.s;
  s.joint_rows.rows.clear();
  s.joint_rows.sources.clear();
  for (std::size_t k = 0; k < work.model.joints.size(); ++k) {
    const HandJoint& model = work.model.joints[k];
    const auto place = [&](std::int32_t body) { return body < 0 ? -1 : s.place[idx(body)]; };
    JointPart part{model, static_cast<std::int32_t>(k)};
    part.a = place(model.a);
    part.b = place(model.b);
    if (part.a < 0 && part.b < 0) continue;
    part.arm = model.arm;
    part.motor = model.motor;
    part.begin = joint_ends(model, s.states);
    part.end = is_first ? part.begin : joint_ends(model, s.next);
    part.dt = work.dt;
    if (!is_first) {
      if (part.a >= 0) part.u_a = s.bodies[idx(part.a)].velocity;
      if (part.b >= 0) part.u_b = s.bodies[idx(part.b)].velocity;
    }
    list_part_rows(part, work.memory.joints[k], s.joint_rows);
  }
}

void go(const HandWork& work, double share) THIGMA_RT {
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

bool correct_limits(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  bool is_short = false;
  std::int32_t known = -1;
  HandPairAt at;
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const RowSource& source = s.sources[r];
    const HandPair& pair = work.model.pairs[idx(source.pair)];
    if (source.pair != known) at = pair_at(pair, s.next);
    known = source.pair;
    const ContactRow& row = work.model.rows[idx(source.row)].row;
    const double gap = row_at(row, at.relative.position, at.rotation).gap;
    const double closed = closed_by(gap, pair.slop, source);
    if (closed == 0.0) continue;
    is_short = true;
    s.rows[r].limit -= closed / work.dt;
  }
  return is_short;
}

void turn_rows(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  std::size_t kept = 0;
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    if (!(s.rows[r].impulse.x() > 0.0)) continue;
    const RowSource& source = s.sources[r];
    const HandPair& pair = work.model.pairs[idx(source.pair)];
    const HandPairAt at = pair_at(pair, s.next);
    const RowAtState here =
        row_at(work.model.rows[idx(source.row)].row, at.relative.position, at.rotation);
    if (!std::isfinite(here.gap)) continue;
    const Mat3 turn = rotation_matrix(s.next[idx(pair.second)].orientation);
    IslandRow row = s.rows[r];
    place_row(here, turn, at.relative.position, row);
    row.limit = 0.0;
    row.impulse = Vec3::Zero();
    s.rows[kept] = row;
    s.sources[kept++] = source;
  }
  s.rows.resize(kept);
  s.sources.resize(kept);
}

}  // namespace thigma::detail
