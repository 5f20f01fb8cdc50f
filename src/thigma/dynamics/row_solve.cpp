#include "thigma/dynamics/row_solve.h"

#include <algorithm>
#include <cmath>

#include "thigma/dynamics/detail/friction_cones.h"

namespace thigma {
namespace {

using namespace detail;

constexpr double kAccuracy = 1e-10;  // of the free speed

bool has_friction(const VelocityRows& rows) THIGMA_RT {
  for (int i = 0; i < rows.count; ++i)
    if (rows.friction[idx(i)].at_rest > 0.0) return true;
  return false;
}

void keep_impulses(const WhiteRows& white, const Nearest& nearest, const Cones& cones, double scale,
                   RowImpulses& impulses) THIGMA_RT {
  std::fill_n(impulses.normal.begin(), idx(white.count), 0.0);
  std::fill_n(impulses.tangential.begin(), idx(white.count), std::array<double, 2>{0.0, 0.0});
  impulses.active_count = nearest.active.count;
  for (int i = 0; i < nearest.active.count; ++i) {
    const std::size_t k = idx(i), r = idx(nearest.active.row[k]);
    impulses.active[k] = nearest.active.row[k];
    if (cones.count == 0) impulses.normal[r] = nearest.active.multiplier[k] / white.length[r];
  }
  for (int i = 0; i < cones.count; ++i) {
    const Cone& c = cones.cone[idx(i)];
    const std::size_t r = idx(c.row);
    impulses.normal[r] = c.press / white.length[r];
    impulses.tangential[r] = {scale * c.hold_first, scale * c.hold_second};
    // Held within the cone of what slides, it sticks again.
    impulses.is_sliding[r] = c.is_sliding && !is_held(c);
  }
}

}  // namespace

RowSolution solve_rows(const Mat6& metric, const Vec6& free, const VelocityRows& rows,
                       RowImpulses& impulses) THIGMA_RT {
  RowSolution solution;
  const Factor f = factor(metric);
  WhiteRows white;
  whiten(rows, f.inverse, white);
  const Vec6 target = f.lower.transpose() * free;
  const double accuracy = kAccuracy * target.norm();

  Nearest nearest = nearest_point(white, target, impulses, accuracy);
  Cones cones;
  double scale = 1.0;
  if (nearest.active.count > 0 && has_friction(rows)) {
    const ConeWork work{rows, white, f.inverse, impulses};
    for (int i = 0; i < rows.count; ++i)
      if (impulses.normal[idx(i)] > 0.0) add_cone(work, i, cones);
    for (int i = 0; i < nearest.active.count; ++i)
      add_cone(work, nearest.active.row[idx(i)], cones);
    solution.sweeps = solve_cones(work, target, cones);
    solution.rounds = nearest.rounds;
    nearest = nearest_point(white, target - friction_pull(cones, 1.0), impulses, accuracy);
    scale = allowed_share(work, nearest, cones);
    if (scale < 1.0)
      nearest = nearest_point(white, target - friction_pull(cones, scale), impulses, accuracy);
  }
  keep_impulses(white, nearest, cones, scale, impulses);
  solution.rounds += nearest.rounds;
  solution.active = nearest.active.count;
  solution.is_whole = nearest.is_whole;
  solution.slip = count_slip(cones, scale, nearest.y);
  solution.velocity = f.inverse.transpose() * nearest.y;
  solution.impulse = f.lower * (nearest.y - target);
  for (int i = 0; i < rows.count; ++i) {
    const double excess = white.excess(i, nearest.y) * white.length[idx(i)];
    if (std::isfinite(excess)) solution.residual = std::max(solution.residual, excess);
  }
  return solution;
}

}  // namespace thigma
