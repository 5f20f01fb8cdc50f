#include "thigma/multibody/detail/multiplier_drift.h"

#include <algorithm>
#include <cmath>

namespace thigma::detail {
namespace {

/// Squares of the last change and of what it differs by from the one before, as speeds.
struct Likeness {
  double last = 0.0, apart = 0.0;
};

Likeness compare(const Multipliers& now, const MultiplierChange& last,
                 const MultiplierChange& before) noexcept {
  Likeness l;
  for (std::size_t i = 0; i < now.rows.size(); ++i) {
    const Vec3 x = last.rows[i] / now.weight[i], y = before.rows[i] / now.weight[i];
    l.last += x.squaredNorm();
    l.apart += (x - y).squaredNorm();
  }
  for (std::size_t i = 0; i < now.joints.size(); ++i) {
    if (!(now.joint_weight[i] > 0.0)) continue;
    const double x = last.joints[i] / now.joint_weight[i];
    const double y = before.joints[i] / now.joint_weight[i];
    l.last += x * x;
    l.apart += (x - y) * (x - y);
  }
  return l;
}

/// Steps until the friction of a row slides; infinity: never, or it slides already, and stays at
/// its bound.
double steps_to_slide(const IslandRow& row, const Vec3& by) noexcept {
  constexpr double kRounding = 1e-6;
  const double radius = row.friction * row.impulse.x(), grows = row.friction * by.x();
  const Vec2 held = row.impulse.tail<2>(), step = by.tail<2>();
  // |held + t step| = radius + t grows
  const double c = held.squaredNorm() - radius * radius;
  if (!(c < -kRounding * radius * radius)) return kInfinity;
  const double a = step.squaredNorm() - grows * grows;
  const double b = held.dot(step) - radius * grows;
  const double root = std::sqrt(std::max(b * b - a * c, 0.0));
  return b + root > 0.0 ? -c / (b + root) : kInfinity;  // c < 0: the first beyond 0
}

double steps_to_bound(const IslandRow& row, const Vec3& by) noexcept {
  const double normal = by.x() < 0.0 ? row.impulse.x() / -by.x() : kInfinity;
  return std::min(normal, steps_to_slide(row, by));
}

double steps_to_bound(const JointRow& row, double by) noexcept {
  if (by > 0.0) return (row.high - row.impulse) / by;
  return by < 0.0 ? (row.low - row.impulse) / by : kInfinity;
}

}  // namespace

double changes_to_bound(const Multipliers& now, const MultiplierChange& last,
                        const MultiplierChange& before) noexcept {
  constexpr double kSame = 0.02;  // of a change: two that differ by no more are the same
  const Likeness l = compare(now, last, before);
  if (!(l.last > 0.0) || !(l.apart <= kSame * kSame * l.last)) return 0.0;
  double steps = kInfinity;
  for (std::size_t i = 0; i < now.rows.size(); ++i)
    steps = std::min(steps, steps_to_bound(now.rows[i], last.rows[i]));
  for (std::size_t i = 0; i < now.joints.size(); ++i)
    if (now.joint_weight[i] > 0.0)
      steps = std::min(steps, steps_to_bound(now.joints[i], last.joints[i]));
  return std::isfinite(steps) ? std::max(steps, 0.0) : 0.0;
}

}  // namespace thigma::detail
