// Impacts at the end of a part of a step: the surfaces that met stop each other, then spring back.

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/jointed_island.h"
#include "thigma/multibody/detail/row_rules.h"
#include "thigma/multibody/detail/row_speed.h"

namespace thigma::detail {
namespace {

/// An island whose surfaces met.
struct Hit {
  Part& part;
  const Island& island;
  std::span<BodyState> states;  // after the part

  std::int32_t body(std::int32_t place) const noexcept {
    return part.s.islands.body[idx(island.first_body + place)];
  }
  const RigidBody& rigid(std::int32_t place) const noexcept {
    return part.world.rigid[idx(body(place))];
  }
  bool is_free(std::int32_t place) const noexcept {
    return part.world.bodies[idx(body(place))].kind != BodyKind::prescribed;
  }
};

/// Whether a row came to press in this part.
bool has_met(const Part& part, const IslandRow& row, const RowSource& source) noexcept {
  const NearPair& pair = *part.s.pairs.near[idx(source.pair)];
  return has_met(row, source, pair_kind(part.world, pair.kind).constraints.slop);
}

/// Speed at which a row's surfaces meet, over that without contacts at the end of the part: what
/// acts gives only the share until there. 0: no impact, it is pressed together.
double speed_share(const Hit& hit, const IslandRow& row, const RowSource& source) noexcept {
  const auto& s = hit.part.s;
  Vec6 before[2], free[2];
  const Vec6 *b[2] = {nullptr, nullptr}, *f[2] = {nullptr, nullptr};
  const std::int32_t places[2] = {row.a, row.b};
  for (std::size_t k = 0; k < 2; ++k) {
    if (places[k] < 0) continue;
    const std::int32_t body = hit.body(places[k]);
    before[k] = velocity_of(hit.rigid(places[k]), hit.part.state.bodies[idx(body)]);
    free[k] = s.free[idx(body)].free;
    if (!hit.is_free(places[k])) before[k] = free[k];
    b[k] = &before[k];
    f[k] = &free[k];
  }
  return meeting_share({normal_speed(row, b[0], b[1]), normal_speed(row, f[0], f[1])}, source.room,
                       hit.part.dt);
}

/// Rows that press, at the states after the part.
void list_rows(const Hit& hit) {
  auto& s = hit.part.s;
  s.hit_rows.clear();
  s.hit_sources.clear();
  for (std::int32_t i = 0; i < hit.island.rows; ++i) {
    const std::int32_t r = hit.island.first_row + i;
    const IslandRow& before = s.islands.rows[idx(r)];
    if (!(before.impulse.x() > 0.0)) continue;
    const RowSource& source = s.islands.sources[idx(r)];
    const NearPair& pair = *s.pairs.near[idx(source.pair)];
    const BodyState& second = hit.states[idx(pair.second)];
    const BodyState relative = relative_state(hit.states[idx(pair.first)], second);
    const RowAtState at = row_at(pair.model.rows[idx(source.row)], relative.position,
                                 rotation_matrix(relative.orientation));
    if (!std::isfinite(at.gap)) continue;
    const Mat3 turn = rotation_matrix(second.orientation);
    IslandRow row = before;
    place_row(at, turn, relative.position, row);
    row.limit = 0.0;
    row.impulse = Vec3::Zero();
    s.hit_rows.push_back(row);
    s.hit_sources.push_back(r);
  }
}

void list_bodies(const Hit& hit) {
  auto& s = hit.part.s;
  s.hit_bodies.resize(idx(hit.island.bodies));
  for (std::int32_t i = 0; i < hit.island.bodies; ++i) {
    IslandBody& body = s.hit_bodies[idx(i)];
    const BodyState& y = hit.states[idx(hit.body(i))];
    body.metric = mass_matrix(hit.rigid(i), y);
    // What is prescribed has no momentum.
    body.free = hit.is_free(i) ? velocity_of(hit.rigid(i), y)
                               : s.islands.bodies[idx(hit.island.first_body + i)].velocity;
  }
}

void give(const Hit& hit, std::int32_t place, const Vec6& impulse) noexcept {
  BodyState& y = hit.states[idx(hit.body(place))];
  y.linear_momentum += impulse.head<3>();
  y.angular_momentum += impulse.tail<3>();
}

/// What springs back: e times the impulse that stopped each contact. Returns how many bounce.
std::int32_t list_bounces(const Hit& hit) {
  auto& s = hit.part.s;
  s.bounce.assign(idx(hit.island.bodies), Vec6::Zero());
  std::int32_t count = 0;
  for (std::size_t i = 0; i < s.hit_rows.size(); ++i) {
    const IslandRow& after = s.hit_rows[i];
    const IslandRow& row = s.islands.rows[idx(s.hit_sources[i])];
    const RowSource& source = s.islands.sources[idx(s.hit_sources[i])];
    if (!has_met(hit.part, row, source)) continue;
    const NearPair& pair = *s.pairs.near[idx(source.pair)];
    const auto& bodies = hit.part.world.bodies;
    const double e = restitution_between(bodies[idx(pair.first)], bodies[idx(pair.second)]);
    if (!(e > 0.0)) continue;
    const double share = speed_share(hit, row, source);
    if (!(share > 0.0)) continue;
    ++count;
    const Vec3 p = e * share * (row.impulse.x() + after.impulse.x()) * after.normal;
    add_impulse_at(after, -p, s.bounce);
  }
  return count;
}

/// Of the bounces, what the joints let the bodies take.
void hold_bounces(const Hit& hit) {
  auto& s = hit.part.s;
  JointRowList& list = s.joint_rows;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.rows.size(); ++i) {
    if (list.sources[i].kind != JointRowKind::hold) continue;
    list.rows[kept] = list.rows[i];
    list.rows[kept++].impulse = 0.0;
  }
  for (std::size_t i = 0; i < s.hit_bodies.size(); ++i)
    s.hit_bodies[i].free = s.hit_bodies[i].metric.ldlt().solve(s.bounce[i]);
  hit.part.report.newton +=
      solve_island(s.hit_bodies, {}, std::span(list.rows.data(), kept), s.solve).newton;
  for (std::size_t i = 0; i < s.hit_bodies.size(); ++i)
    s.bounce[i] = s.hit_bodies[i].metric * s.hit_bodies[i].velocity;
}

/// The largest share of the bounces, 0 to 1, with which an island has no more energy than before
/// the part: kinetic, and what gravity has given since.
double share_of_energy(const Hit& hit) noexcept {
  const auto& s = hit.part.s;
  EnergyShare energy;
  for (std::int32_t i = 0; i < hit.island.bodies; ++i) {
    if (!hit.is_free(i)) continue;
    const RigidBody& rigid = hit.rigid(i);
    const BodyState& before = hit.part.state.bodies[idx(hit.body(i))];
    const BodyState& after = hit.states[idx(hit.body(i))];
    energy.budget += kinetic_energy(rigid, before) - kinetic_energy(rigid, after) +
                     rigid.mass * rigid.gravity.dot(after.position - before.position);
    const Vec6 by = s.hit_bodies[idx(i)].metric.ldlt().solve(s.bounce[idx(i)]);
    energy.slope += by.dot(s.hit_bodies[idx(i)].metric * velocity_of(rigid, after));
    energy.bend += 0.5 * by.dot(s.bounce[idx(i)]);
  }
  for (std::int32_t k = 0; k < hit.island.joints; ++k) {
    const std::int32_t number = s.islands.joint[idx(hit.island.first_joint + k)];
    const WorldJoint& joint = hit.part.world.joints[idx(number)];
    energy.budget += joint_energy(joint, hit.part.state.bodies) - joint_energy(joint, hit.states);
  }
  return share_of(energy);
}

void collide_island(const Hit& hit) {
  auto& s = hit.part.s;
  list_rows(hit);
  list_bodies(hit);
  s.joint_rows.rows.clear();
  const bool has_joints = hit.island.joints > 0;
  if (has_joints) list_joint_ends(hit.part, hit.island, hit.states);
  const IslandSolution solution =
      solve_island(s.hit_bodies, s.hit_rows, s.joint_rows.rows, s.solve);
  hit.part.report.newton += solution.newton;
  if (has_joints) keep_joint_ends(hit.part);
  for (std::int32_t i = 0; i < hit.island.bodies; ++i)
    if (hit.is_free(i)) give(hit, i, s.hit_bodies[idx(i)].impulse);
  const std::int32_t bounces = list_bounces(hit);
  if (bounces == 0) return;
  if (has_joints) hold_bounces(hit);
  const double share = share_of_energy(hit);
  for (std::int32_t i = 0; i < hit.island.bodies; ++i)
    if (hit.is_free(i)) give(hit, i, share * s.bounce[idx(i)]);
  hit.part.report.impacts += bounces;
}

}  // namespace

void collide(Part& part, std::span<BodyState> states) {
  const Islands& islands = part.s.islands;
  for (const Island& island : islands.islands) {
    const Hit hit{part, island, states};
    bool is_hit = island.joints > 0;
    for (std::int32_t i = 0; i < island.rows && !is_hit; ++i) {
      const std::size_t r = idx(island.first_row + i);
      is_hit = has_met(part, islands.rows[r], islands.sources[r]);
    }
    if (is_hit) collide_island(hit);
  }
}

}  // namespace thigma::detail
