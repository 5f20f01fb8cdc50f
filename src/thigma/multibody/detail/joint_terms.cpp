#include "thigma/multibody/detail/joint_terms.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// Of a trial before the bounds.
double unbounded(const JointRow& row, double speed, double weight) noexcept {
  const double known = row.firmness > 0.0 ? 0.0 : row.impulse;
  return known + weight * (speed - row.target);
}

}  // namespace

double speed_of(const JointRow& row, std::span<const Vec6> u) noexcept {
  double speed = 0.0;
  if (row.a >= 0) speed += row.on_a.dot(u[idx(row.a)]);
  if (row.b >= 0) speed += row.on_b.dot(u[idx(row.b)]);
  return speed;
}

double impulse_of(const JointRow& row, double speed, double weight) noexcept {
  return std::clamp(unbounded(row, speed, weight), row.low, row.high);
}

bool is_within_bounds(const JointRow& row, double speed, double weight) noexcept {
  const double impulse = unbounded(row, speed, weight);
  return impulse > row.low && impulse < row.high;
}

void add_impulse(const JointRow& row, double impulse, std::span<Vec6> to) noexcept {
  if (row.a >= 0) to[idx(row.a)] += impulse * row.on_a;
  if (row.b >= 0) to[idx(row.b)] += impulse * row.on_b;
}

void add_curvature(const JointRow& row, double weight, BlockMatrix& h) noexcept {
  const Vec6 wa = weight * row.on_a, wb = weight * row.on_b;
  if (row.a >= 0) h.at(row.a, row.a).noalias() += wa * row.on_a.transpose();
  if (row.b >= 0) h.at(row.b, row.b).noalias() += wb * row.on_b.transpose();
  if (row.a < 0 || row.b < 0) return;
  if (row.a > row.b)
    h.at(row.a, row.b).noalias() += wa * row.on_b.transpose();
  else
    h.at(row.b, row.a).noalias() += wb * row.on_a.transpose();
}

double mobility_of(const JointRow& row, std::span<const Mat6> inverse_metrics) noexcept {
  double mobility = 0.0;
  if (row.a >= 0) mobility += row.on_a.dot(inverse_metrics[idx(row.a)] * row.on_a);
  if (row.b >= 0) mobility += row.on_b.dot(inverse_metrics[idx(row.b)] * row.on_b);
  return mobility;
}

double violation_of(const JointRow& row, double speed) noexcept {
  if (row.firmness > 0.0) return 0.0;
  const double off = speed - row.target;
  // A bound that is reached excuses only what lies beyond it.
  if (off > 0.0) return row.impulse < row.high ? off : 0.0;
  return row.impulse > row.low ? -off : 0.0;
}

}  // namespace thigma::detail
