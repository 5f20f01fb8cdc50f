#include "thigma/multibody/detail/hand_collide.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/multibody/detail/row_cut.h"
#include "thigma/multibody/detail/row_rules.h"
#include "thigma/multibody/detail/row_speed.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma::detail {
namespace {

const RigidBody& rigid_of(const HandWork& work, std::size_t i) THIGMA_RT {
  return i == 0 ? work.at.body : work.model.bodies[i].rigid;
}

/// Before the step, of a body that moves in it.
Vec6 velocity_before(const HandWork& work, std::size_t i) THIGMA_RT {
  return i == 0 ? velocity_of(work.at.body, work.at.state) : work.memory.velocities[i];
}

/// Speed at which a row's surfaces meet, over that without rows at the end of the step.
double speed_share(const HandWork& work, const IslandRow& row, const RowSource& source) THIGMA_RT {
  const HandPair& pair = work.model.pairs[idx(source.pair)];
  Vec6 before[2];
  const Vec6 *b[2] = {nullptr, nullptr}, *f[2] = {nullptr, nullptr};
  const std::int32_t places[2] = {row.a, row.b};
  const std::int32_t bodies[2] = {pair.first, pair.second};
  for (std::size_t k = 0; k < 2; ++k) {
    if (places[k] < 0) continue;
    before[k] = velocity_before(work, idx(bodies[k]));
    b[k] = &before[k];
    f[k] = &work.s.bodies[idx(places[k])].free;
  }
  return meeting_share({normal_speed(row, b[0], b[1]), normal_speed(row, f[0], f[1])}, source.room,
                       work.dt);
}

/// Whether a body gives what it would in the world: one that moves there and waits here, or is at
/// the border, would be a wall.
bool is_known(const HandWork& work, std::size_t i) THIGMA_RT {
  const HandBody& body = work.model.bodies[i];
  return i == 0 || !body.is_free || (body.is_solved && work.s.place[i] >= 0);
}

/// What each row that met springs back with; whether any has met.
bool find_met(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  bool any_met = false;
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const RowSource& source = s.sources[r];
    const HandPair& pair = work.model.pairs[idx(source.pair)];
    double& spring = s.spring[idx(source.row)];
    spring = 0.0;
    if (!has_met(s.rows[r], source, pair.slop)) continue;
    any_met = true;
    const bool is_whole = is_known(work, idx(pair.first)) && is_known(work, idx(pair.second));
    if (pair.restitution > 0.0 && is_whole && work.model.joints.empty())
      spring = pair.restitution * speed_share(work, s.rows[r], source);
  }
  return any_met;
}

/// The bodies as masses alone, at the end of the step.
void fill_masses(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    if (s.place[i] < 0) continue;
    IslandBody& body = s.bodies[idx(s.place[i])];
    body.free = body.velocity;
    if (work.model.bodies[i].is_solved) body.metric = mass_matrix(rigid_of(work, i), s.next[i]);
  }
}

/// Gives a body of the island an impulse and the velocity that comes of it.
void give(const HandWork& work, std::size_t i, const Vec6& impulse,
          const Vec6& velocity) THIGMA_RT {
  work.s.next[i].linear_momentum += impulse.head<3>();
  work.s.next[i].angular_momentum += impulse.tail<3>();
  work.s.bodies[idx(work.s.place[i])].velocity = velocity;
}

/// What springs back, by body; whether any does.
bool list_bounces(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  bool any = false;
  for (std::size_t i = 0; i < s.bodies.size(); ++i) s.bounce[i].setZero();
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const IslandRow& row = s.rows[r];
    const std::size_t number = idx(s.sources[r].row);
    if (!(s.spring[number] > 0.0)) continue;
    any = true;
    const Vec3 p =
        s.spring[number] * (work.memory.impulses[number].x() + row.impulse.x()) * row.normal;
    add_impulse_at(row, -p, s.bounce);
  }
  return any;
}

/// Whether a body takes what it is given: not what is at the border.
bool takes(const HandWork& work, std::size_t i) THIGMA_RT {
  return work.s.place[i] >= 0 && work.model.bodies[i].is_solved;
}

/// The bodies spring back, by the largest share with which they have no more energy than before the
/// step: kinetic, and what gravity has given since.
void spring_back(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  EnergyShare energy;
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    if (!takes(work, i)) continue;
    const std::size_t place = idx(s.place[i]);
    const RigidBody& rigid = rigid_of(work, i);
    const Vec6 before = velocity_before(work, i), after = s.bodies[place].velocity;
    const Mat6 mass = mass_matrix(rigid, s.states[i]);
    const Mat6& metric = s.bodies[place].metric;
    energy.budget += 0.5 * before.dot(mass * before) - 0.5 * after.dot(metric * after) +
                     rigid.mass * rigid.gravity.dot(s.next[i].position - s.states[i].position);
    s.bodies[place].free = metric.ldlt().solve(s.bounce[place]);
    energy.slope += s.bodies[place].free.dot(metric * after);
    energy.bend += 0.5 * s.bodies[place].free.dot(s.bounce[place]);
  }
  const double share = share_of(energy);
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    if (!takes(work, i)) continue;
    const IslandBody& body = s.bodies[idx(s.place[i])];
    give(work, i, share * s.bounce[idx(s.place[i])], body.velocity + share * body.free);
  }
}

}  // namespace

void collide(const HandWork& work) THIGMA_RT {
  HandScratch& s = work.s;
  if (!find_met(work)) return;
  turn_rows(work);
  fill_masses(work);
  s.solve.newton_left = std::max(kHandNewton - work.memory.newton, 0);
  const CutSolution cut = solve_cut(s.bodies, s.rows, s.sources, {}, s.cut, s.solve);
  work.memory.newton += cut.solution.newton;
  for (std::size_t i = 0; i < work.model.bodies.size(); ++i) {
    if (s.place[i] < 0) continue;
    IslandBody& body = s.bodies[idx(s.place[i])];
    if (!cut.solution.is_whole) body.velocity = body.free;
    if (cut.solution.is_whole && work.model.bodies[i].is_solved)
      give(work, i, body.impulse, body.velocity);
  }
  if (cut.solution.is_whole && list_bounces(work)) spring_back(work);
}

}  // namespace thigma::detail
