#include "thigma/multibody/detail/part.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/dynamics/implicit_step.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/jointed_island.h"
#include "thigma/multibody/detail/part_energy.h"
#include "thigma/multibody/detail/row_rules.h"
#include "thigma/simulation/free_motion.h"

namespace thigma::detail {
namespace {

/// Metric and free velocity of a body that hands hold.
bool find_held(const Part& part, std::int32_t body, IslandBody& out) noexcept {
  const RigidBody& rigid = part.world.rigid[idx(body)];
  const BodyAtState at = at_state(rigid, part.state.bodies[idx(body)]);
  Wrench wrench;
  WrenchJacobian jacobian = WrenchJacobian::Zero();
  bool is_held = false;
  for (const HandHold& hand : part.inputs.hands) {
    if (hand.body != body || !hand.coupling.is_grasped) continue;
    WrenchJacobian by = WrenchJacobian::Zero();
    wrench = wrench + coupling_wrench(hand.coupling, hand.handle, at, &by);
    jacobian += by;
    is_held = true;
  }
  if (!is_held) return false;
  const BodyState unbound = implicit_step(at, wrench, jacobian, part.dt);
  out.metric = step_metric(at, jacobian, part.dt);
  out.free << unbound.linear_momentum / rigid.mass,
      at.kinematics.inverse_inertia * unbound.angular_momentum;
  return true;
}

Vec6 drive_of(const WorldInputs& inputs, std::int32_t body) noexcept {
  Vec6 u = Vec6::Zero();
  for (const BodyDrive& drive : inputs.drives)
    if (drive.body == body) u << drive.velocity.linear, drive.velocity.angular;
  return u;
}

/// A prescribed body at rest is as good as a fixed one.
bool may_move(const Part& part, std::int32_t body) noexcept {
  if (part.world.bodies[idx(body)].kind == BodyKind::prescribed)
    return drive_of(part.inputs, body) != Vec6::Zero();
  return is_dynamic(part.world, body);
}

void find_free(const Part& part, std::int32_t body) noexcept {
  IslandBody& out = part.s.free[idx(body)];
  const RigidBody& rigid = part.world.rigid[idx(body)];
  const BodyState& y = part.state.bodies[idx(body)];
  const BodyKind kind = moved_by(part, body);
  if (kind == BodyKind::held && find_held(part, body, out)) return;
  out.metric = mass_matrix(rigid, y);
  if (kind == BodyKind::prescribed) {
    out.free = drive_of(part.inputs, body);
    return;
  }
  out.free = velocity_of(rigid, y);
  out.free.head<3>() += part.dt * rigid.gravity;
}

/// Bound on how far a point of a body goes at a velocity.
double way_of(const Part& part, std::int32_t body, const Vec6& u) noexcept {
  const double reach = part.world.boxes[idx(part.world.shape[idx(body)])].reach;
  return part.dt * (u.head<3>().norm() + reach * u.tail<3>().norm());
}

/// A body after the part.
BodyState after(const Part& part, std::int32_t body, const IslandBody& solved,
                double share) noexcept {
  const RigidBody& rigid = part.world.rigid[idx(body)];
  const BodyState& y = part.state.bodies[idx(body)];
  const double dt = share * part.dt;
  const Vec3 linear = solved.velocity.head<3>(), angular = solved.velocity.tail<3>();
  BodyState next = y;
  next.position += dt * linear;
  const BodyKind kind = moved_by(part, body);
  if (kind == BodyKind::moving) {
    next.linear_momentum += part.dt * rigid.mass * rigid.gravity + solved.impulse.head<3>();
    next.angular_momentum += solved.impulse.tail<3>();
    next.orientation = free_motion(rigid, next, dt).orientation;
    return next;
  }
  next.orientation = unit(rotation_from_vector(dt * angular) * y.orientation);
  if (kind == BodyKind::prescribed) {
    next.linear_momentum = next.angular_momentum = Vec3::Zero();
    return next;
  }
  const Mat3 rotation = rotation_matrix(y.orientation);
  next.linear_momentum = rigid.mass * linear;
  next.angular_momentum = rotation * (rigid.inertia * (rotation.transpose() * angular));
  return next;
}

/// A body that touches no other one that moves, and has met nothing in this part, goes by the mean
/// of its velocities before and after, which is right to second order. Bodies that touch others go
/// by the velocity after: only so do impulses at one place keep the angular momentum of both.
BodyState after_smoothly(const Part& part, std::int32_t body, const IslandBody& solved) noexcept {
  const RigidBody& rigid = part.world.rigid[idx(body)];
  const BodyState& y = part.state.bodies[idx(body)];
  BodyState next = after(part, body, solved, 1.0);
  next.position =
      y.position + 0.5 * part.dt * (y.linear_momentum + next.linear_momentum) / rigid.mass;
  BodyState turning = next;
  turning.angular_momentum = 0.5 * (y.angular_momentum + next.angular_momentum);
  turning.orientation = y.orientation;
  next.orientation = free_motion(rigid, turning, part.dt).orientation;
  return next;
}

void wake(Part& part, std::int32_t body) noexcept {
  auto& s = part.s;
  part.state.is_asleep[idx(body)] = 0;
  part.state.still[idx(body)] = 0.0;
  s.moves[idx(body)] = 1;
  find_free(part, body);
  s.go[idx(body)] = way_of(part, body, s.free[idx(body)].free);
}

/// Wakes what a joint ties to an awake body; whether there was any.
bool wake_by_joints(Part& part) noexcept {
  bool has_woken = false;
  for (const WorldJoint& joint : part.world.joints) {
    if (joint.b < 0) continue;
    const std::int32_t ends[2] = {joint.a, joint.b};
    for (std::size_t k = 0; k < 2; ++k) {
      const std::int32_t body = ends[k], other = ends[1 - k];
      if (part.state.is_asleep[idx(body)] == 0 || part.s.moves[idx(other)] == 0) continue;
      wake(part, body);
      has_woken = true;
    }
  }
  return has_woken;
}

/// Wakes what an awake body's box comes near to; whole heaps, as their bodies are near each other.
void find_near(Part& part) {
  auto& s = part.s;
  const std::size_t count = part.world.bodies.size();
  for (;;) {
    for (std::size_t i = 0; i < count; ++i) {
      const double ahead = 0.01 * part.world.boxes[idx(part.world.shape[i])].reach;
      s.margins[i] = s.go[i] + ahead;
    }
    find_pairs(part.world, part.state, s.margins, s.moves, s.broad);
    bool has_woken = false;
    for (const BodyPairIndex& pair : s.broad.pairs) {
      for (const std::int32_t body : {pair.a, pair.b}) {
        if (part.state.is_asleep[idx(body)] == 0) continue;
        wake(part, body);
        has_woken = true;
      }
    }
    has_woken = wake_by_joints(part) || has_woken;
    if (!has_woken) break;
  }
  take_pairs(part.world, s.broad.pairs, s.pairs);
}

/// How far the first of a pair goes in the frame of the second without contacts.
double free_way(const Part& part, const NearPair& pair, const BodyState& relative) noexcept {
  const auto go = [&](std::int32_t body) {
    BodyState y = part.state.bodies[idx(body)];
    if (part.s.moves[idx(body)] == 0) return y;
    const Vec6& u = part.s.free[idx(body)].free;
    y.position += part.dt * u.head<3>();
    y.orientation = unit(rotation_from_vector(part.dt * u.tail<3>()) * y.orientation);
    return y;
  };
  const double reach = pair_kind(part.world, pair.kind).constraints.reach;
  return travel_between(relative, relative_state(go(pair.first), go(pair.second)), reach);
}

/// Rows for all pairs, as far as they may need them; false: farther than any query looks.
bool renew_pairs(Part& part, bool is_last) noexcept {
  PairCounts counts;
  bool is_enough = true;
  constexpr double kSpare = 1.1;
  for (NearPair* pair : part.s.pairs.near) {
    const BodyState relative =
        relative_state(part.state.bodies[idx(pair->first)], part.state.bodies[idx(pair->second)]);
    const double way = std::max(pair->asked, kSpare * free_way(part, *pair, relative));
    const bool is_coarse = pair->pressed > 0 && pair->fresh < 0.0;  // rows that press are exact
    if (!is_coarse && (holds(part.world, *pair, relative, way) || pair->fresh >= way)) continue;
    if (way > most_ahead(part.world, *pair) && !is_last && !pair->model.rows.empty())
      is_enough = false;
    renew(part.world, relative, way, *pair, part.s.pairs, counts);
    pair->fresh = way;
    if (holds(part.world, *pair, relative, way)) continue;
    if (way > most_ahead(part.world, *pair) && !is_last) is_enough = false;
  }
  part.report.queries += counts.queries;
  part.report.coarse += counts.coarse;
  part.report.left_out += counts.left_out;
  return is_enough;
}

/// Gaps of rows after the part, best asked pair by pair.
struct GapsAfter {
  const Part& part;
  std::int32_t pair = -1;  // that the rest is of
  Vec3 position = Vec3::Zero();
  Mat3 rotation = Mat3::Identity();

  double of(const RowSource& source) noexcept {
    const NearPair& near = *part.s.pairs.near[idx(source.pair)];
    if (source.pair != pair) {
      const BodyState relative =
          relative_state(part.s.next[idx(near.first)], part.s.next[idx(near.second)]);
      position = relative.position;
      rotation = rotation_matrix(relative.orientation);
      pair = source.pair;
    }
    return row_at(near.model.rows[idx(source.row)], position, rotation).gap;
  }
};

/// Whether an island with joints has more energy than it may. Its velocities are right after
/// `collide` only; what that gave the joints is taken back where one has.
bool jointed_gain_energy(Part& part) noexcept {
  auto& s = part.s;
  bool is_gain = false;
  for (const Island& island : s.islands.islands)
    is_gain = is_gain || (island.joints > 0 && energy_gain(part, island) > 0.0);
  if (!is_gain) return false;
  for (const std::int32_t joint : s.islands.joint)
    for (std::size_t place = 0; place < kJointPlaces; ++place)
      s.joint_sum[idx(joint)][place] -= s.joint_end[idx(joint)][place];
  return true;
}

/// Lets the one body of an island go smoothly, where its rows let it.
void smooth(Part& part, const Island& island) noexcept {
  auto& s = part.s;
  const std::int32_t body = s.islands.body[idx(island.first_body)];
  if (island.bodies != 1 || moved_by(part, body) != BodyKind::moving) return;
  const BodyState before = s.next[idx(body)];
  for (std::int32_t i = 0; i < island.rows; ++i) {
    const std::size_t r = idx(island.first_row + i);
    if (s.islands.rows[r].impulse.x() > 0.0 && s.islands.sources[r].room > 0.0) return;
  }
  s.next[idx(body)] = after_smoothly(part, body, s.islands.bodies[idx(island.first_body)]);
  GapsAfter gaps{part};
  for (std::int32_t i = 0; i < island.rows; ++i) {
    const RowSource& source = s.islands.sources[idx(island.first_row + i)];
    const NearPair& pair = *s.pairs.near[idx(source.pair)];
    const double slop = pair_kind(part.world, pair.kind).constraints.slop;
    constexpr double kLess = 1e-6;  // of the stand-off, that a gap may lose below it
    if (gaps.of(source) >= std::min(slop, source.gap) - kLess * slop) continue;
    s.next[idx(body)] = before;
    return;
  }
}

void solve_one(Part& part, const Island& island) {
  auto& s = part.s;
  const std::span bodies(s.islands.bodies.data() + island.first_body, idx(island.bodies));
  constexpr int kTurns = 3;
  for (int turn = 0; turn < kTurns; ++turn) {
    solve_rows(part, island, bodies, {});
    for (std::int32_t i = 0; i < island.bodies; ++i) {
      const std::int32_t place = island.first_body + i, body = s.islands.body[idx(place)];
      s.next[idx(body)] = after(part, body, s.islands.bodies[idx(place)], 1.0);
    }
    if (turn + 1 == kTurns || !correct_limits(part, island)) break;
  }
  smooth(part, island);
}

void solve_all(Part& part) {
  auto& s = part.s;
  Islands& islands = s.islands;
  find_islands(s.moves, s.pairs.near, part.world.joints, islands);
  std::fill(s.is_jointed.begin(), s.is_jointed.end(), 0);
  fill_rows(part.world, part.state.bodies, s.pairs.near, part.dt, islands);
  islands.bodies.resize(islands.body.size());
  for (std::size_t i = 0; i < islands.body.size(); ++i)
    islands.bodies[i] = s.free[idx(islands.body[i])];
  s.next.assign(part.state.bodies.begin(), part.state.bodies.end());
  for (Island& island : islands.islands) {
    part.report.largest_island = std::max(part.report.largest_island, island.bodies);
    if (island.joints > 0)
      solve_jointed(part, island);
    else
      solve_one(part, island);
  }
  part.report.rows += static_cast<std::int64_t>(islands.rows.size());
}

/// Whether rows of coarse surfaces press; their pairs are then asked more finely.
bool has_coarse_pressing(Part& part) noexcept {
  auto& s = part.s;
  bool is_pressing = false;
  if (!(part.world.threshold > 0.0)) return false;
  for (std::size_t r = 0; r < s.islands.rows.size(); ++r) {
    const RowSource& source = s.islands.sources[r];
    NearPair& pair = *s.pairs.near[idx(source.pair)];
    if (!(pair.exact_within > 0.0) || !(s.islands.rows[r].impulse.x() > 0.0)) continue;
    if (!is_coarse_row(pair.model.rows[idx(source.row)])) continue;
    is_pressing = true;
    if (pair.fresh >= 0.0 || pair.pressed == 0) ++pair.pressed;
    pair.fresh = -1.0;
  }
  return is_pressing;
}

/// Where the bodies of a solve went.
enum class Went : std::uint8_t {
  within,   // where rows were made for
  farther,  // what rows have to be made for is noted
  too_far,  // likewise, but they were made for as much already, and hold for less
};

Went where_they_went(Part& part) noexcept {
  auto& s = part.s;
  constexpr double kSpare = 1.5;
  bool is_within = true, is_asked = false;
  for (std::size_t i = 0; i < s.islands.body.size(); ++i) {
    const std::int32_t body = s.islands.body[i];
    const double way = way_of(part, body, s.islands.bodies[i].velocity);
    if (way <= s.margins[idx(body)]) continue;
    s.go[idx(body)] = kSpare * way;
    is_asked = true;
  }
  for (NearPair* pair : s.pairs.near) {
    const BodyState before =
        relative_state(part.state.bodies[idx(pair->first)], part.state.bodies[idx(pair->second)]);
    const BodyState after = relative_state(s.next[idx(pair->first)], s.next[idx(pair->second)]);
    const double reach = pair_kind(part.world, pair->kind).constraints.reach;
    if (travel_between(pair->model.state, after, reach) <= pair->model.travel) continue;
    pair->asked = kSpare * travel_between(before, after, reach);
    is_asked = is_asked || pair->asked > pair->fresh;
    is_within = false;
  }
  if (has_coarse_pressing(part) || is_asked) return Went::farther;
  return is_within ? Went::within : Went::too_far;
}

/// Whether the bodies stay within their rows, no gap below what it was.
bool is_allowed(const Part& part) noexcept {
  const auto& s = part.s;
  for (const NearPair* pair : s.pairs.near) {
    const BodyState relative = relative_state(s.next[idx(pair->first)], s.next[idx(pair->second)]);
    const ConstraintWorld& constraints = pair_kind(part.world, pair->kind).constraints;
    if (travel_between(pair->model.state, relative, constraints.reach) > pair->model.travel)
      return false;
  }
  GapsAfter gaps{part};
  for (const RowSource& source : s.islands.sources)
    if (gaps.of(source) < std::min(source.gap, 0.0)) return false;
  return true;
}

void go(Part& part, double share) noexcept {
  auto& s = part.s;
  for (std::size_t i = 0; i < s.islands.body.size(); ++i) {
    const std::int32_t body = s.islands.body[i];
    s.next[idx(body)] = s.is_jointed[idx(body)] != 0
                            ? after_jointed(part, body, s.islands.bodies[i].velocity, share)
                            : after(part, body, s.islands.bodies[i], share);
  }
}

/// The largest share of the part, to 2^-10, in which all stay within their rows.
double share_within(Part& part) noexcept {
  double inside = 0.0, outside = 1.0;
  for (int turn = 0; turn < 10; ++turn) {
    const double middle = 0.5 * (inside + outside);
    go(part, middle);
    (is_allowed(part) ? inside : outside) = middle;
  }
  go(part, inside);
  return inside;
}

/// Impulses, for the next step; sliding where friction is at its bound.
void keep_rows(Part& part) noexcept {
  auto& s = part.s;
  for (NearPair* pair : s.pairs.near)
    for (RowHistory& row : pair->history) row = {row.id, Vec3::Zero(), false};
  part.report.pressing = 0;
  for (std::size_t r = 0; r < s.islands.rows.size(); ++r) {
    const IslandRow& row = s.islands.rows[r];
    if (!(row.impulse.x() > 0.0)) continue;
    ++part.report.pressing;
    const RowSource& source = s.islands.sources[r];
    RowHistory& history = s.pairs.near[idx(source.pair)]->history[idx(source.row)];
    history.impulse = row.impulse;
    history.is_sliding = is_sliding(row);
  }
  for (const Island& island : s.islands.islands)
    if (island.joints > 0) count_joints(part, island);
}

}  // namespace

Vec6 velocity_of(const RigidBody& body, const BodyState& state) noexcept {
  const Twist v = velocity(body, state);
  Vec6 u;
  u << v.linear, v.angular;
  return u;
}

Mat6 mass_matrix(const RigidBody& body, const BodyState& state) noexcept {
  const Mat3 rotation = rotation_matrix(state.orientation);
  Mat6 m = Mat6::Zero();
  m.topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
  m.bottomRightCorner<3, 3>() = rotation * body.inertia * rotation.transpose();
  return m;
}

void solve_rows(Part& part, const Island& island, std::span<IslandBody> bodies,
                std::span<JointRow> joints) {
  auto& s = part.s;
  const std::span rows(s.islands.rows.data() + island.first_row, idx(island.rows));
  const std::span<const RowSource> sources(s.islands.sources.data() + island.first_row,
                                           rows.size());
  const auto solve = [&] {
    const CutSolution cut = solve_cut(bodies, rows, sources, joints, s.cut, s.solve);
    part.report.newton += cut.solution.newton;
    part.report.handed += cut.handed;
    part.report.most_handed = std::max(part.report.most_handed, cut.most_handed);
    return cut.solution;
  };
  IslandSolution solution = solve();
  if (!solution.is_whole) {
    for (IslandRow& row : rows) row.limit = std::max(row.limit, 0.0);
    solution = solve();
    part.report.is_whole = part.report.is_whole && solution.is_whole;
  }
  part.report.residual = std::max(part.report.residual, solution.residual);
}

bool correct_limits(Part& part, const Island& island) noexcept {
  auto& s = part.s;
  bool is_short = false;
  GapsAfter gaps{part};
  for (std::int32_t i = 0; i < island.rows; ++i) {
    const std::size_t r = idx(island.first_row + i);
    const RowSource& source = s.islands.sources[r];
    const double gap = gaps.of(source);
    const NearPair& pair = *s.pairs.near[idx(source.pair)];
    const double slop = pair_kind(part.world, pair.kind).constraints.slop;
    const double closed = closed_by(gap, slop, source);
    if (closed == 0.0) continue;
    is_short = true;
    s.islands.rows[r].limit -= closed / part.dt;
  }
  return is_short;
}

double make_part(Part& part, bool is_last) {
  auto& s = part.s;
  const std::size_t count = part.world.bodies.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto body = static_cast<std::int32_t>(i);
    s.moves[i] = may_move(part, body) && part.state.is_asleep[i] == 0 ? 1 : 0;
    s.go[i] = 0.0;
    if (s.moves[i] == 0) continue;
    find_free(part, body);
    s.go[i] = way_of(part, body, s.free[i].free);
  }
  for (NearPair* pair : s.pairs.near) {
    pair->asked = 0.0;
    pair->fresh = -1.0;
    pair->pressed = 0;
  }
  constexpr int kTurns = 5;
  Went went = Went::farther;
  for (int turn = 0; turn < kTurns && went == Went::farther; ++turn) {
    find_near(part);
    if (!renew_pairs(part, is_last)) return 0.0;
    solve_all(part);
    went = where_they_went(part);
  }
  const bool is_within = went == Went::within;
  double share = 1.0;
  if (!is_last) {
    if (!is_within || !is_allowed(part)) return 0.0;
    for (const Island& island : s.islands.islands) {
      const double gain = island.joints > 0 ? 0.0 : energy_gain(part, island);
      if (gain > 0.0 && !take_back(part, island, gain)) return 0.0;
    }
  } else if (!is_within || !is_allowed(part)) {
    share = share_within(part);
  }
  const std::int32_t impacts = part.report.impacts;
  collide(part, s.next);
  if (!is_last && jointed_gain_energy(part)) {
    part.report.impacts = impacts;
    return 0.0;
  }
  keep_rows(part);
  std::swap(part.state.bodies, s.next);
  return share;
}

}  // namespace thigma::detail
