#include "thigma/multibody/detail/island_newton.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "thigma/core/index.h"
#include "thigma/multibody/detail/joint_terms.h"
#include "thigma/multibody/detail/row_speed.h"

namespace thigma::detail {
namespace {

using Mat36 = Eigen::Matrix<double, 3, 6>;

Mat36 lever(const Vec3& arm) noexcept {
  Mat36 j;
  j << 1.0, 0.0, 0.0, 0.0, arm.z(), -arm.y(),  //
      0.0, 1.0, 0.0, -arm.z(), 0.0, arm.x(),   //
      0.0, 0.0, 1.0, arm.y(), -arm.x(), 0.0;
  return j;
}

/// Normal and tangents as rows.
Mat3 frame_of(const IslandRow& row) noexcept {
  Mat3 frame;
  frame.row(0) = row.normal;
  frame.row(1) = row.first;
  frame.row(2) = row.normal.cross(row.first);
  return frame;
}

/// The multipliers that a trial gives a row: on the half line of the normal and the disk across.
Vec3 force_of(const IslandRow& row, const Vec3& speed, double weight, double radius) noexcept {
  Vec3 f;
  f.x() = std::max(0.0, row.impulse.x() + weight * (speed.x() - row.limit));
  const double first = row.impulse.y() + weight * speed.y();
  const double second = row.impulse.z() + weight * speed.z();
  const double length = std::sqrt(first * first + second * second);
  const double share = length > radius ? radius / length : 1.0;
  f.y() = radius > 0.0 ? share * first : 0.0;
  f.z() = radius > 0.0 ? share * second : 0.0;
  return f;
}

/// What a trial asks of a row with a cone.
Vec3 pull_of(const IslandRow& row, const Vec3& speed, double weight) noexcept {
  return row.impulse + weight * (speed - Vec3(row.limit, 0.0, 0.0));
}

/// Gradient of the augmented Lagrangian at u; the rows' forces there.
void evaluate(IslandWork& work, std::span<const Vec6> u, std::span<Vec6> gradient) noexcept {
  for (std::size_t i = 0; i < work.bodies.size(); ++i)
    gradient[i].noalias() = work.bodies[i].metric * (u[i] - work.bodies[i].free);
  for (std::size_t i = 0; i < work.rows.size(); ++i) {
    const IslandRow& row = work.rows[i];
    const bool has_cone = work.has_cones && row.friction > 0.0;
    const Vec3 speed = approach(row, u);
    work.s.force[i] = has_cone ? cone_force_of(pull_of(row, speed, work.s.weight[i]), row.friction)
                               : force_of(row, speed, work.s.weight[i], work.s.radius[i]);
    if (work.s.force[i].x() > 0.0 || (!has_cone && work.s.radius[i] > 0.0))
      add_impulse(row, work.s.force[i], gradient);
  }
  for (std::size_t i = 0; i < work.joints.size(); ++i) {
    const JointRow& row = work.joints[i];
    work.s.joint_force[i] = impulse_of(row, speed_of(row, u), work.s.joint_weight[i]);
    add_impulse(row, work.s.joint_force[i], gradient);
  }
}

/// Derivative of a row's force by its speed, over the weight.
Mat3 slope_of(const IslandRow& row, const Vec3& speed, double weight, double radius) noexcept {
  Mat3 d = Mat3::Zero();
  if (row.impulse.x() + weight * (speed.x() - row.limit) > 0.0) d(0, 0) = 1.0;
  if (!(radius > 0.0)) return d;
  const Vec2 z(row.impulse.y() + weight * speed.y(), row.impulse.z() + weight * speed.z());
  const double length = z.norm();
  if (length <= radius) {
    d(1, 1) = d(2, 2) = 1.0;
    return d;
  }
  const Vec2 along = z / length;
  d.bottomRightCorner<2, 2>() =
      radius / length * (Eigen::Matrix2d::Identity() - along * along.transpose());
  return d;
}

/// Adds J^T W J of a row: blocks of the lower half.
void add_curvature(const IslandRow& row, const Mat3& slope, BlockMatrix& h) noexcept {
  const Mat36 a = lever(row.arm_a), b = lever(row.arm_b);
  const Mat36 wa = slope * a, wb = slope * b;
  if (row.a >= 0) h.at(row.a, row.a).noalias() += a.transpose() * wa;
  if (row.b >= 0) h.at(row.b, row.b).noalias() += b.transpose() * wb;
  if (row.a < 0 || row.b < 0) return;
  if (row.a > row.b)
    h.at(row.a, row.b).noalias() -= a.transpose() * wb;
  else
    h.at(row.b, row.a).noalias() -= b.transpose() * wa;
}

bool factor_hessian(IslandWork& work, std::span<const Vec6> u) noexcept {
  BlockMatrix& h = work.s.hessian;
  for (std::size_t i = 0; i < work.bodies.size(); ++i) {
    const auto row = static_cast<std::int32_t>(i);
    for (std::int32_t k = h.first[i]; k < row; ++k) h.at(row, k).setZero();
    h.at(row, row) = work.bodies[i].metric;
  }
  for (std::size_t i = 0; i < work.rows.size(); ++i) {
    const IslandRow& row = work.rows[i];
    const Vec3 speed = approach(row, u);
    const Mat3 slope = work.has_cones && row.friction > 0.0
                           ? cone_slope_of(pull_of(row, speed, work.s.weight[i]), row.friction)
                           : slope_of(row, speed, work.s.weight[i], work.s.radius[i]);
    if (!(slope.cwiseAbs().maxCoeff() > 0.0)) continue;
    const Mat3 frame = frame_of(row);
    add_curvature(row, work.s.weight[i] * (frame.transpose() * slope * frame), h);
  }
  for (std::size_t i = 0; i < work.joints.size(); ++i) {
    const JointRow& row = work.joints[i];
    if (is_within_bounds(row, speed_of(row, u), work.s.joint_weight[i]))
      add_curvature(row, work.s.joint_weight[i], h);
  }
  return factor_blocks(h);
}

/// A norm of a gradient: of the velocities it stands for, in energy's metric.
double size_of(const IslandWork& work, std::span<const Vec6> gradient) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < gradient.size(); ++i)
    sum += gradient[i].dot(work.s.inverse[i] * gradient[i]);
  return std::sqrt(std::max(sum, 0.0));
}

double along(std::span<const Vec6> x, std::span<const Vec6> y) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i].dot(y[i]);
  return sum;
}

void go(const IslandWork& work, double share) noexcept {
  for (std::size_t i = 0; i < work.bodies.size(); ++i)
    work.s.trial[i] = work.s.velocity[i] + share * work.s.step[i];
}

/// Along a step the derivative only grows: its zero, roughly, between nothing and the whole step.
void search_line(IslandWork& work) noexcept {
  IslandScratch& s = work.s;
  const double begin = along(s.gradient, s.step);
  double low = 0.0, at_low = begin, high = 1.0;
  go(work, 1.0);
  evaluate(work, s.trial, s.trial_gradient);
  double at_high = along(s.trial_gradient, s.step);
  constexpr double kEnough = 0.3;  // of the slope at the beginning
  for (int turn = 0; turn < 12 && at_high > kEnough * -begin; ++turn) {
    const double share = std::clamp(at_low / (at_low - at_high), 0.05, 0.95);
    const double middle = low + share * (high - low);
    go(work, middle);
    evaluate(work, s.trial, s.trial_gradient);
    const double slope = along(s.trial_gradient, s.step);
    if (std::fabs(slope) <= kEnough * -begin) break;
    if (slope < 0.0) {
      low = middle;
      at_low = slope;
    } else {
      high = middle;
      at_high = slope;
    }
  }
}

/// The same where the slope is still downhill: the function is convex, so it is less there. The
/// rough search may go up where a row bends the function sharply near the beginning.
void search_downhill(IslandWork& work) noexcept {
  IslandScratch& s = work.s;
  const double begin = along(s.gradient, s.step);
  double low = 0.0, at_low = begin, high = 1.0, at_high = 0.0;
  const auto slope_at = [&](double share) {
    go(work, share);
    evaluate(work, s.trial, s.trial_gradient);
    return along(s.trial_gradient, s.step);
  };
  at_high = slope_at(high);
  if (at_high <= 0.0) return;
  constexpr double kFlat = 0.1;  // of the slope at the beginning
  constexpr int kTurns = 40;
  for (int turn = 0; turn < kTurns && (low == 0.0 || at_low < kFlat * begin); ++turn) {
    const double guess = turn % 2 == 0 ? at_low / (at_low - at_high) : 0.5;
    const double middle = low + std::clamp(guess, 0.05, 0.95) * (high - low);
    const double slope = slope_at(middle);
    if (slope <= 0.0) {
      low = middle;
      at_low = slope;
    } else {
      high = middle;
      at_high = slope;
    }
  }
  slope_at(low > 0.0 ? low : high);
}

}  // namespace

Vec3 cone_force_of(const Vec3& z, double friction) noexcept {
  const double across = z.tail<2>().norm();
  if (z.x() + friction * across <= 0.0) return Vec3::Zero();
  if (across <= friction * z.x()) return z;
  const double normal = (z.x() + friction * across) / (1.0 + friction * friction);
  const double share = friction * normal / across;
  return {normal, share * z.y(), share * z.z()};
}

Mat3 cone_slope_of(const Vec3& z, double friction) noexcept {
  const double across = z.tail<2>().norm();
  if (z.x() + friction * across <= 0.0) return Mat3::Zero();
  if (across <= friction * z.x()) return Mat3::Identity();
  const Vec2 along = z.tail<2>() / across;
  const Vec3 edge(1.0, friction * along.x(), friction * along.y());
  const double square = 1.0 + friction * friction;
  const double turns = friction * (z.x() + friction * across) / (square * across);
  Mat3 d = edge * edge.transpose() / square;
  d.bottomRightCorner<2, 2>() += turns * (Eigen::Matrix2d::Identity() - along * along.transpose());
  return d;
}

Vec3 approach(const IslandRow& row, std::span<const Vec6> u) noexcept {
  const Vec3 w = approach_of(row, row.a >= 0 ? &u[idx(row.a)] : nullptr,
                             row.b >= 0 ? &u[idx(row.b)] : nullptr);
  const Vec3 second = row.normal.cross(row.first);
  return {row.normal.dot(w), row.first.dot(w), second.dot(w)};
}

void add_impulse(const IslandRow& row, const Vec3& impulse, std::span<Vec6> to) noexcept {
  const Vec3 p = impulse.x() * row.normal + impulse.y() * row.first +
                 impulse.z() * row.normal.cross(row.first);
  add_impulse_at(row, p, to);
}

int minimize(IslandWork& work, double enough, int most) noexcept {
  IslandScratch& s = work.s;
  evaluate(work, s.velocity, s.gradient);
  double size = size_of(work, s.gradient);
  int steps = 0;
  while (steps < most && size > enough && s.newton_left != 0) {
    if (!factor_hessian(work, s.velocity)) break;
    if (s.newton_left > 0) --s.newton_left;
    for (std::size_t i = 0; i < s.gradient.size(); ++i) s.step[i] = -s.gradient[i];
    solve_blocks(s.hessian, s.step);
    search_line(work);
    double next = size_of(work, s.trial_gradient);
    ++steps;
    if (!(next < size) && size > 1e3 * enough) {
      search_downhill(work);
      next = size_of(work, s.trial_gradient);
    }
    if (!(next < size) && size <= 1e3 * enough) {  // rounding: nothing is won any more
      evaluate(work, s.velocity, s.gradient);      // of the forces, those of the last step's end
      break;
    }
    std::swap(s.velocity, s.trial);
    std::swap(s.gradient, s.trial_gradient);
    size = next;
  }
  return steps;
}

}  // namespace thigma::detail
