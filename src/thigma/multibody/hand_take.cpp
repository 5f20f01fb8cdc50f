// Taking up a hand model.

#include <algorithm>

#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/hand_within.h"
#include "thigma/multibody/hand_step.h"

namespace thigma {
namespace {

using detail::HandPairAt;
using detail::is_within;

/// A state between two, at a share of the way from the first.
BodyState between(const BodyState& from, const BodyState& to, double share) THIGMA_RT {
  BodyState y = to;
  y.position = from.position + share * (to.position - from.position);
  const Vec3 turn = vector_from_rotation(to.orientation * from.orientation.conjugate());
  y.orientation = unit(rotation_from_vector(share * turn) * from.orientation);
  return y;
}

}  // namespace

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

}  // namespace thigma
