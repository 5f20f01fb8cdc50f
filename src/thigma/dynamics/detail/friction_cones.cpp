#include "thigma/dynamics/detail/friction_cones.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/infinity.h"

namespace thigma::detail {
namespace {

// Of the free speed: how much of y a sweep may still move, and how far a row may be violated that
// is not taken in. The normals are found exactly afterwards: this is about friction alone.
constexpr double kStill = 1e-9, kViolated = 1e-6;
// Sweeps are as many as cost no more than so many cones, or so many. Redundant rows need few.
constexpr int kMaxProjections = 400, kLeastSweeps = 5;

Vec6 generalized(const Mat6& inverse, const Vec3& arm, const Vec3& direction) THIGMA_RT {
  Vec6 w;
  w << direction, arm.cross(direction);
  return inverse.triangularView<Eigen::Lower>() * w;
}

/// Largest friction impulse of a row [N s].
double most_hold(const Cone& c) THIGMA_RT { return c.friction * c.press * c.per_press; }

/// One cone brought to where its row neither gives way nor leaves Coulomb's law.
void project(Cone& c, Vec6& y) THIGMA_RT {
  const double along = c.normal.dot(y);
  const double press = std::max(0.0, c.press + along - c.limit);
  const double by_press = press - c.press;
  c.press = press;
  if (!c.has_friction) {
    y -= by_press * c.normal;
    return;
  }
  double first = c.hold_first + (c.first.dot(y) - by_press * c.normal_first) * c.by_tangent;
  double second = c.hold_second + (c.second.dot(y) - by_press * c.normal_second) * c.by_tangent;
  const double most = most_hold(c), square = first * first + second * second;
  if (square > most * most) {
    const double share = most / std::sqrt(square);
    first *= share;
    second *= share;
  }
  y -= by_press * c.normal + (first - c.hold_first) * c.first + (second - c.hold_second) * c.second;
  c.hold_first = first;
  c.hold_second = second;
}

/// Rows on their static cone that still move slide from here on; returns whether there are any
/// whose coefficient that changes.
bool break_away(const ConeWork& work, const Vec6& y, Cones& cones) THIGMA_RT {
  constexpr double kMoving = 1e-3;  // of the speed that a whole cone stops, the largest
  double stopped = 0.0;
  for (int i = 0; i < cones.count; ++i)
    stopped = std::max(stopped, most_hold(cones.cone[idx(i)]) * cones.cone[idx(i)].tangent_square);
  bool is_any = false;
  for (int i = 0; i < cones.count; ++i) {
    Cone& c = cones.cone[idx(i)];
    const double kinetic = work.rows.friction[idx(c.row)].kinetic;
    if (c.is_sliding || !(kinetic < c.friction)) continue;
    const double along = c.first.dot(y), across = c.second.dot(y);
    const double speed = std::sqrt(along * along + across * across);
    if (!(speed > kMoving * stopped)) continue;
    c.is_sliding = is_any = true;
    c.friction = kinetic;
  }
  return is_any;
}

int most_sweeps(const Cones& cones) THIGMA_RT {
  return std::max(kLeastSweeps, kMaxProjections / std::max(cones.count, 1));
}

double coefficient_of(int row, const VelocityRows& rows, const Cones& cones) THIGMA_RT {
  for (int i = 0; i < cones.count; ++i)
    if (cones.cone[idx(i)].row == row) return cones.cone[idx(i)].friction;
  return rows.friction[idx(row)].kinetic;
}

}  // namespace

void add_cone(const ConeWork& work, int row, Cones& cones) THIGMA_RT {
  const auto& [rows, white, inverse, warm] = work;
  for (int i = 0; i < cones.count; ++i)
    if (cones.cone[idx(i)].row == row) return;
  if (cones.count == static_cast<int>(cones.cone.size())) return;
  Cone& c = cones.cone[idx(cones.count++)];
  const std::size_t r = idx(row);
  c.row = row;
  c.has_friction = rows.friction[r].at_rest > 0.0;
  c.is_sliding = warm.is_sliding[r] || !c.has_friction;
  c.friction = c.is_sliding ? rows.friction[r].kinetic : rows.friction[r].at_rest;
  c.normal = white.row(row);
  c.limit = white.limit[r];
  c.per_press = white.length[r] > 0.0 ? 1.0 / white.length[r] : 0.0;
  c.press = warm.normal[r] * white.length[r];
  c.hold_first = c.hold_second = c.tangent_square = 0.0;
  if (!c.has_friction) return;
  const Vec3 normal(rows.gradient[0][r], rows.gradient[1][r], rows.gradient[2][r]);
  const Vec3 tangent = rows.tangent[r];
  c.first = generalized(inverse, rows.arm[r], tangent);
  c.second = generalized(inverse, rows.arm[r], normal.cross(tangent));
  c.tangent_square = std::max(c.first.squaredNorm(), c.second.squaredNorm());
  c.by_tangent = 1.0 / c.tangent_square;
  c.normal_first = c.normal.dot(c.first);
  c.normal_second = c.normal.dot(c.second);
  c.hold_first = warm.tangential[r][0];
  c.hold_second = warm.tangential[r][1];
}

int solve_cones(const ConeWork& work, const Vec6& target, Cones& cones) THIGMA_RT {
  Vec6 y = target;
  for (int i = 0; i < cones.count; ++i) {
    const Cone& c = cones.cone[idx(i)];
    y -= c.press * c.normal + c.hold_first * c.first + c.hold_second * c.second;
  }
  const double size = target.norm();
  int sweeps = 0;
  while (sweeps < most_sweeps(cones)) {
    double moved = kInfinity;
    while (moved > kStill * size && sweeps < most_sweeps(cones)) {
      const Vec6 before = y;
      for (int i = 0; i < cones.count; ++i) project(cones.cone[idx(i)], y);
      moved = (y - before).norm();
      ++sweeps;
    }
    const Violation next = most_violated(work.white, y, kViolated * size);
    if (next.row < 0 && break_away(work, y, cones)) continue;
    if (next.row < 0) break;
    const int before = cones.count;
    add_cone(work, next.row, cones);
    if (cones.count == before) break;
    Cone& c = cones.cone[idx(before)];
    c.press = c.hold_first = c.hold_second = 0.0;  // y does not hold them
  }
  return sweeps;
}

Vec6 friction_pull(const Cones& cones, double scale) THIGMA_RT {
  Vec6 pull = Vec6::Zero();
  for (int i = 0; i < cones.count; ++i) {
    const Cone& c = cones.cone[idx(i)];
    pull += scale * (c.hold_first * c.first + c.hold_second * c.second);
  }
  return pull;
}

double allowed_share(const ConeWork& work, const Nearest& nearest, const Cones& cones) THIGMA_RT {
  double held = 0.0, allowed = 0.0;
  for (int i = 0; i < cones.count; ++i) {
    held += hold_of(cones.cone[idx(i)]);
  }
  for (int i = 0; i < nearest.active.count; ++i) {
    const std::size_t k = idx(i), r = idx(nearest.active.row[k]);
    allowed += coefficient_of(nearest.active.row[k], work.rows, cones) *
               nearest.active.multiplier[k] / work.white.length[r];
  }
  constexpr double kRounding = 1e-6;
  return held <= allowed * (1.0 + kRounding) ? 1.0 : allowed / held;
}

double hold_of(const Cone& c) THIGMA_RT {
  return std::sqrt(c.hold_first * c.hold_first + c.hold_second * c.hold_second);
}

bool is_held(const Cone& c) THIGMA_RT {
  constexpr double kRounding = 1e-9;
  return c.has_friction && hold_of(c) < (1.0 - kRounding) * most_hold(c);
}

SlipCount count_slip(const Cones& cones, double scale, const Vec6& y) THIGMA_RT {
  SlipCount slip;
  for (int i = 0; i < cones.count; ++i) {
    const Cone& c = cones.cone[idx(i)];
    if (!c.has_friction || !(c.press > 0.0)) continue;
    if (is_held(c)) {
      ++slip.sticking;
      continue;
    }
    ++slip.sliding;
    slip.work += scale * (c.hold_first * c.first.dot(y) + c.hold_second * c.second.dot(y));
  }
  return slip;
}

}  // namespace thigma::detail
