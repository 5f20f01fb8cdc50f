#pragma once
// Where a hand model says all of the body in the hand.

#include <span>

#include "thigma/core/index.h"
#include "thigma/multibody/detail/hand_work.h"

namespace thigma::detail {

/// Whether the body in the hand is where the model says all, no row of it below what it may be.
///
/// least   by row: the gap that it may have at least [m]
template <class Least>
bool is_within(const HandModel& model, std::span<const BodyState> states, Least least) THIGMA_RT {
  if (travel_between(model.bodies[0].state, states[0], model.reach) > model.room) return false;
  std::int32_t known = -1;
  HandPairAt at;
  for (const HandPair& pair : model.pairs) {
    if (!pair.is_guarded()) continue;
    at = detail::pair_at(pair, states);
    if (travel_between(pair.state, at.relative, pair.reach) > pair.travel) return false;
  }
  for (std::size_t r = 0; r < model.rows.size(); ++r) {
    const HandRow& row = model.rows[r];
    const HandPair& pair = model.pairs[idx(row.pair)];
    if (!pair.is_guarded()) continue;
    if (row.pair != known) at = detail::pair_at(pair, states);
    known = row.pair;
    if (row_at(row.row, at.relative.position, at.rotation).gap < least(r)) return false;
  }
  return true;
}

}  // namespace thigma::detail
