// What rows, travel and friction did over a session.

#include <algorithm>

#include "thigma/session/statistics.h"

namespace thigma {

void accumulate(HeldCounts& counts, const HapticSample& sample) THIGMA_RT {
  if (!sample.is_grasped) return;
  ++counts.frames;
  counts.held_back += sample.is_held_back ? 1 : 0;
  counts.squeezed += sample.is_squeezed ? 1 : 0;
  counts.touching += sample.touching > 0 ? 1 : 0;
  counts.active += static_cast<std::uint64_t>(std::max(sample.touching, 0));
  counts.active_max = std::max(counts.active_max, sample.touching);
  counts.residual_max = std::max(counts.residual_max, sample.solve_residual);
  counts.wanted_speed_max = std::max(counts.wanted_speed_max, sample.wanted_speed);
  counts.row_gap_min = std::min(counts.row_gap_min, -sample.penetration);
}

void accumulate(SlipTotals& totals, const SlipCount& slip) THIGMA_RT {
  totals.sticking += static_cast<std::uint64_t>(slip.sticking);
  totals.sliding += static_cast<std::uint64_t>(slip.sliding);
  totals.work += slip.work;
}

FrictionSummary summarize(const SlipTotals& slip) noexcept {
  FrictionSummary s;
  const std::uint64_t all = slip.sticking + slip.sliding;
  s.is_on = all > 0;
  if (all > 0) s.sticking_share = static_cast<double>(slip.sticking) / static_cast<double>(all);
  s.slip_work = slip.work;
  return s;
}

void accumulate(RowCounts& counts, const ContactSample& sample) THIGMA_RT {
  const std::size_t rows = sample.model.constraints.rows.size();
  ++counts.models[rows];
  counts.found_max = std::max(counts.found_max, sample.rows);
  counts.halvings_max = std::max(counts.halvings_max, sample.travel_halvings);
  counts.left_out_max = std::max(counts.left_out_max, sample.left_out);
  counts.halved_models += sample.travel_halvings > 0 ? 1 : 0;
  counts.left_out_models += sample.left_out > 0 ? 1 : 0;
  counts.look_ahead_max = std::max(counts.look_ahead_max, sample.look_ahead);
  counts.coarse_max = std::max(counts.coarse_max, sample.coarse);
  if (rows > 0) counts.travel_min = std::min(counts.travel_min, sample.travel);
}

ConstraintSummary summarize(const HeldCounts& held, const RowCounts& rows) noexcept {
  ConstraintSummary s;
  s.is_on = true;
  const double frames = static_cast<double>(std::max<std::uint64_t>(held.frames, 1));
  s.held_back_share = static_cast<double>(held.held_back) / frames;
  s.squeezed_share = static_cast<double>(held.squeezed) / frames;
  s.held_back_frames = held.held_back;
  s.active_mean = static_cast<double>(held.active) /
                  static_cast<double>(std::max<std::uint64_t>(held.touching, 1));
  s.active_max = held.active_max;
  s.residual_max = held.residual_max;
  s.wanted_speed_max = held.wanted_speed_max;
  s.row_gap_min = held.row_gap_min;
  s.found_max = rows.found_max;
  s.halvings_max = rows.halvings_max;
  s.halved_models = rows.halved_models;
  s.left_out_max = rows.left_out_max;
  s.left_out_models = rows.left_out_models;
  s.travel_min = rows.travel_min;
  s.look_ahead_max = rows.look_ahead_max;
  s.coarse_max = rows.coarse_max;
  std::uint64_t all = 0, so_far = 0, sum = 0;
  for (std::size_t n = 1; n < rows.models.size(); ++n) {
    all += rows.models[n];
    sum += n * rows.models[n];
  }
  s.rows_mean = static_cast<double>(sum) / static_cast<double>(std::max<std::uint64_t>(all, 1));
  for (std::size_t n = 1; n < rows.models.size(); ++n) {
    if (rows.models[n] == 0) continue;
    s.rows_max = static_cast<std::int64_t>(n);
    if (2 * so_far < all) s.rows_p50 = s.rows_max;
    so_far += rows.models[n];
  }
  return s;
}

}  // namespace thigma
