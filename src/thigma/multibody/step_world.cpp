#include "thigma/multibody/step_world.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/math/infinity.h"
#include "thigma/multibody/detail/enclosed.h"
#include "thigma/multibody/detail/jointed_island.h"
#include "thigma/multibody/detail/part.h"

namespace thigma {
namespace {

using detail::NearPair;
using detail::Part;

/// Whether a motor drives something of an island, or a spring does against no friction: at the ends
/// of a slow swing that stands still for long.
bool is_driven(const World& world, const detail::Islands& islands,
               const detail::Island& island) noexcept {
  for (std::int32_t k = 0; k < island.joints; ++k) {
    const WorldJoint& joint = world.joints[idx(islands.joint[idx(island.first_joint + k)])];
    if (joint.motor.is_on || (joint.stiffness > 0.0 && island.rows == 0)) return true;
  }
  return false;
}

/// Bodies that touch and have not moved for long enough rest until something comes near: whole
/// heaps together, so that none hangs in the air. What is driven never rests.
void put_to_sleep(const World& world, double dt, WorldState& state, WorldScratch& s) {
  constexpr double kTime = 0.5;  // [s]
  constexpr double kWay = 5e-6;  // of the reach: what a body may move in that time
  for (const detail::Island& island : s.islands.islands) {
    bool is_still = true;
    for (std::int32_t i = 0; i < island.bodies; ++i) {
      const std::int32_t body = s.islands.body[idx(island.first_body + i)];
      const Vec6 u = detail::velocity_of(world.rigid[idx(body)], state.bodies[idx(body)]);
      const double reach = world.boxes[idx(world.shape[idx(body)])].reach;
      const bool is_slow =
          detail::moved_by(world, s, body) == BodyKind::moving &&
          kTime * (u.head<3>().norm() + reach * u.tail<3>().norm()) <= kWay * reach;
      double& still = state.still[idx(body)];
      still = is_slow ? still + dt : 0.0;
      is_still = is_still && still >= kTime;
    }
    if (!is_still || (island.rows == 0 && island.joints == 0)) continue;
    if (is_driven(world, s.islands, island)) continue;
    for (std::int32_t i = 0; i < island.bodies; ++i) {
      const std::size_t body = idx(s.islands.body[idx(island.first_body + i)]);
      state.is_asleep[body] = 1;
      state.bodies[body].linear_momentum = state.bodies[body].angular_momentum = Vec3::Zero();
    }
  }
}

/// Notes which bodies hands have hold of, and wakes them.
void take_in_hands(std::span<const HandHold> hands, WorldState& state, WorldScratch& s) noexcept {
  std::fill(s.in_hand.begin(), s.in_hand.end(), 0);
  for (const HandHold& hand : hands) {
    if (hand.body < 0 || !hand.coupling.is_grasped) continue;
    s.in_hand[idx(hand.body)] = 1;
    if (state.is_asleep[idx(hand.body)] == 0) continue;
    state.is_asleep[idx(hand.body)] = 0;
    state.still[idx(hand.body)] = 0.0;
  }
}

void scale_history(double by, WorldScratch& s) noexcept {
  for (NearPair* pair : s.pairs.near)
    for (detail::RowHistory& row : pair->history) row.impulse *= by;
  for (std::vector<detail::JointImpulses>* list : {&s.joint_part, &s.joint_end})
    for (detail::JointImpulses& impulses : *list)
      for (double& impulse : impulses) impulse *= by;
}

void describe(const World& world, const WorldState& state, const WorldScratch& s,
              WorldStep& report) noexcept {
  report.pairs = static_cast<std::int32_t>(s.pairs.near.size());
  report.islands = static_cast<std::int32_t>(s.islands.islands.size());
  report.awake = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    report.awake += is_dynamic(world, static_cast<std::int32_t>(i)) && state.is_asleep[i] == 0;
  report.least_gap = kInfinity;
  for (const detail::RowSource& source : s.islands.sources)
    report.least_gap = std::min(report.least_gap, source.gap);
  report.joint_error = detail::joint_error(world, state.bodies);
}

}  // namespace

void WorldScratchDeleter::operator()(WorldScratch* scratch) const noexcept { delete scratch; }

WorldScratchPtr reserve_world(const World& world, std::size_t pairs) {
  WorldScratchPtr scratch(new WorldScratch);
  const std::size_t count = world.bodies.size();
  detail::reserve_pairs(world, pairs, scratch->pairs);
  const std::size_t joints = world.joints.size();
  reserve_island(count, count * 64, scratch->solve, joints * detail::kJointPlaces);
  detail::reserve_cut(count * 4, count * 64, scratch->cut);
  scratch->joint_rows.rows.reserve(joints * detail::kJointPlaces);
  scratch->joint_rows.sources.reserve(joints * detail::kJointPlaces);
  for (auto* list : {&scratch->joint_part, &scratch->joint_end, &scratch->joint_sum})
    list->assign(joints, detail::JointImpulses{});
  for (auto* list : {&scratch->joint_through, &scratch->joint_before, &scratch->joint_momentum})
    list->assign(count, Vec6::Zero());
  scratch->is_jointed.assign(count, 0);
  scratch->islands.joint.reserve(joints);
  scratch->moves.assign(count, 0);
  scratch->in_hand.assign(count, 0);
  scratch->go.assign(count, 0.0);
  scratch->margins.assign(count, 0.0);
  scratch->free.resize(count);
  scratch->next.reserve(count);
  scratch->hit_bodies.reserve(count);
  scratch->bounce.reserve(count);
  scratch->hit_rows.reserve(count * 64);
  scratch->hit_sources.reserve(count * 64);
  scratch->islands.rows.reserve(count * 64);
  scratch->islands.sources.reserve(count * 64);
  return scratch;
}

WorldStep step_world(const World& world, const WorldInputs& inputs, double dt, WorldState& state,
                     WorldScratch& s) {
  WorldStep report;
  constexpr int kParts = 16, kHalvings = 5;
  take_in_hands(inputs.hands, state, s);
  for (detail::JointImpulses& sum : s.joint_sum) sum.fill(0.0);
  double left = dt, last = dt;
  for (report.parts = 0; report.parts < kParts && left > 1e-9 * dt; ++report.parts) {
    double share = 0.0, length = left;
    for (int halving = 0; halving <= kHalvings && !(share > 0.0); ++halving) {
      if (halving > 0) length *= 0.5;
      if (length != last) scale_history(length / last, s);
      last = length;
      Part part{world, inputs, length, state, s, report};
      const bool is_last = halving == kHalvings;
      share = detail::make_part(part, is_last);
      if (is_last) report.waited += (1.0 - share) * length;
      if (is_last) break;
    }
    left -= length;
  }
  if (left > 1e-9 * dt) report.waited += left;
  if (last != dt) scale_history(dt / last, s);
  if (world.sleeps) put_to_sleep(world, dt, state, s);
  state.time += dt;
  describe(world, state, s, report);
  return report;
}

JointReading read_joint(const World& world, const WorldState& state, const WorldScratch& scratch,
                        std::int32_t joint, double dt) noexcept {
  const WorldJoint& j = world.joints[idx(joint)];
  const detail::JointImpulses& sum = scratch.joint_sum[idx(joint)];
  JointReading reading;
  reading.coordinate = joint_coordinate(j.kind, joint_ends(j, state.bodies));
  // Impulses of an angle are forces at the arm.
  const double scale = (j.kind == JointKind::hinge ? world.joint_arm[idx(joint)] : 1.0) / dt;
  reading.spring = -scale * sum[detail::kSpringPlace];
  reading.motor = -scale * sum[detail::kMotorPlace];
  reading.limit = scale * (sum[detail::kLowerPlace] - sum[detail::kUpperPlace]);
  return reading;
}

namespace {

/// Notes a pair of which one lies wholly in the other.
void find_enclosed(const World& world, const WorldState& state, const NearPair& pair,
                   detail::PartsOfShapes& parts, StartOverlap& worst) {
  const std::int32_t a = std::min(pair.first, pair.second), b = std::max(pair.first, pair.second);
  for (const std::int32_t inner : {b, a}) {
    const std::int32_t outer = inner == b ? a : b;
    if (!detail::is_enclosed(world, state, inner, outer, parts)) continue;
    worst = {a, b, 0.0, inner};
    return;
  }
}

}  // namespace

StartOverlap find_overlap(const World& world, const WorldState& state, WorldScratch& s) {
  StartOverlap worst;
  detail::PartsOfShapes parts(world);
  const std::size_t count = world.bodies.size();
  for (std::size_t i = 0; i < count; ++i)
    s.moves[i] = is_dynamic(world, static_cast<std::int32_t>(i)) ? 1 : 0;
  std::fill(s.margins.begin(), s.margins.end(), 0.0);
  detail::find_pairs(world, state, s.margins, s.moves, s.broad);
  detail::take_pairs(world, s.broad.pairs, s.pairs);
  for (NearPair* pair : s.pairs.near) {
    const BodyState relative =
        detail::relative_state(state.bodies[idx(pair->first)], state.bodies[idx(pair->second)]);
    const double tolerance = pair_kind(world, pair->kind).constraints.least_look_ahead;
    detail::find_contacts(world, relative, tolerance, *pair, s.pairs);
    pair->has_model = false;
    bool is_through = false;
    for (const Contact& contact : s.pairs.contacts.contacts) {
      is_through = is_through || contact.depth > 0.0;
      if (worst.inner >= 0 || !(contact.depth > std::max(worst.depth, 0.0))) continue;
      worst = {std::min(pair->first, pair->second), std::max(pair->first, pair->second),
               contact.depth};
    }
    if (!is_through && worst.inner < 0) find_enclosed(world, state, *pair, parts, worst);
  }
  return worst;
}

void require_apart(const World& world, const WorldState& state, WorldScratch& scratch) {
  const StartOverlap overlap = find_overlap(world, state, scratch);
  if (overlap.a < 0) return;
  const auto name = [&](std::int32_t body) {
    return "body '" + world.bodies[idx(body)].name + "'";
  };
  if (overlap.inner >= 0)
    throw InputError(name(overlap.inner) + ": starts inside " +
                     name(overlap.inner == overlap.a ? overlap.b : overlap.a) +
                     ", clear of its surface, expected them apart");
  char depth[48];
  std::snprintf(depth, sizeof depth, "%.3g mm", 1e3 * overlap.depth);
  throw InputError(name(overlap.b) + ": starts " + depth + " inside " + name(overlap.a) +
                   ", expected them apart");
}

}  // namespace thigma
