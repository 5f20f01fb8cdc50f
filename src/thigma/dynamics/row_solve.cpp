#include "thigma/dynamics/row_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/core/index.h"
#include "thigma/math/infinity.h"

namespace thigma {
namespace {

constexpr int kMaxRounds = 100;       // rows taken in; a few are usual
constexpr int kMaxSweeps = 60;        // over the cones, and of few cones as many as cost no more
constexpr int kMaxProjections = 500;  // than so many of one
constexpr double kAccuracy = 1e-10;   // of the free speed
// A row whose direction lies this near to the span of those that press adds nothing to them.
constexpr double kDependent = 1e-11;

/// L of A = L L^T, and L^-1 by forward substitution. A of any scale: no pivoting is needed.
struct Factor {
  Mat6 lower = Mat6::Zero();
  Mat6 inverse = Mat6::Zero();  // of lower
};

Factor factor(const Mat6& metric) THIGMA_RT {
  Factor f;
  for (int j = 0; j < 6; ++j) {
    for (int i = j; i < 6; ++i) {
      double sum = metric(i, j);
      for (int k = 0; k < j; ++k) sum -= f.lower(i, k) * f.lower(j, k);
      f.lower(i, j) = i == j ? std::sqrt(std::max(sum, std::numeric_limits<double>::min()))
                             : sum / f.lower(j, j);
    }
  }
  for (int j = 0; j < 6; ++j) {
    f.inverse(j, j) = 1.0 / f.lower(j, j);
    for (int i = j + 1; i < 6; ++i) {
      double sum = 0.0;
      for (int k = j; k < i; ++k) sum -= f.lower(i, k) * f.inverse(k, j);
      f.inverse(i, j) = sum / f.lower(i, i);
    }
  }
  return f;
}

/// The rows in coordinates where the metric is the identity, each of unit length.
struct WhiteRows {
  int count = 0;
  alignas(32) std::array<std::array<double, kMaxRows>, 6> gradient;
  alignas(32) std::array<double, kMaxRows> limit;
  std::array<double, kMaxRows> length;  // of the gradient before: impulse = multiplier / length

  Vec6 row(int i) const THIGMA_RT {
    Vec6 g;
    for (int k = 0; k < 6; ++k) g[k] = gradient[idx(k)][idx(i)];
    return g;
  }
  double excess(int i, const Vec6& y) const THIGMA_RT { return row(i).dot(y) - limit[idx(i)]; }
};

void whiten(const VelocityRows& rows, const Mat6& inverse, WhiteRows& white) THIGMA_RT {
  white.count = rows.count;
  for (int i = 0; i < rows.count; ++i) {
    const std::size_t r = idx(i);
    double square = 0.0;
    for (int k = 0; k < 6; ++k) {
      double sum = 0.0;
      for (int m = 0; m <= k; ++m) sum += inverse(k, m) * rows.gradient[idx(m)][r];
      white.gradient[idx(k)][r] = sum;
      square += sum * sum;
    }
    const double length = std::sqrt(square);
    const double scale = length > 0.0 ? 1.0 / length : 0.0;  // a row of zeros forbids nothing
    for (auto& component : white.gradient) component[r] *= scale;
    white.limit[r] = length > 0.0 ? rows.limit[r] * scale : kInfinity;
    white.length[r] = length;
  }
}

struct Violation {
  int row = -1;
  double excess = 0.0;
};

Violation most_violated(const WhiteRows& rows, const Vec6& y, double accuracy) THIGMA_RT {
  Violation worst{-1, accuracy};
  const auto& g = rows.gradient;
  for (int i = 0; i < rows.count; ++i) {
    const std::size_t r = idx(i);
    const double excess = g[0][r] * y[0] + g[1][r] * y[1] + g[2][r] * y[2] + g[3][r] * y[3] +
                          g[4][r] * y[4] + g[5][r] * y[5] - rows.limit[r];
    if (excess > worst.excess) worst = {i, excess};
  }
  return worst;
}

/// Rows that press, with an orthonormal basis of their directions: direction = basis * upper.
struct ActiveRows {
  int count = 0;
  std::array<int, kMaxActive> row{};
  std::array<double, kMaxActive> multiplier{};
  std::array<Vec6, kMaxActive> direction{}, basis{};
  std::array<std::array<double, kMaxActive>, kMaxActive> upper{};

  void orthonormalize() THIGMA_RT {
    for (std::size_t j = 0; j < idx(count); ++j) {
      Vec6 rest = direction[j];
      std::array<double, kMaxActive> along{};
      for (int pass = 0; pass < 2; ++pass) {  // twice is enough
        for (std::size_t i = 0; i < j; ++i) {
          const double part = basis[i].dot(rest);
          along[i] += part;
          rest -= part * basis[i];
        }
      }
      for (std::size_t i = 0; i < j; ++i) upper[i][j] = along[i];
      upper[j][j] = rest.norm();
      basis[j] = upper[j][j] > 0.0 ? Vec6(rest / upper[j][j]) : Vec6(Vec6::Zero());
    }
  }

  void add(int index, const Vec6& gradient, double by) THIGMA_RT {
    const std::size_t n = idx(count++);
    row[n] = index;
    direction[n] = gradient;
    multiplier[n] = by;
    orthonormalize();
  }

  void remove(int at) THIGMA_RT {
    --count;
    for (int i = at; i < count; ++i) {
      const std::size_t to = idx(i);
      row[to] = row[to + 1];
      direction[to] = direction[to + 1];
      multiplier[to] = multiplier[to + 1];
    }
    orthonormalize();
  }
};

/// How taking in one more row moves the solution and the multipliers of the rows that press.
struct Direction {
  Vec6 step = Vec6::Zero();                 // of y, for a unit of the new multiplier, downwards
  std::array<double, kMaxActive> relief{};  // of the multipliers, downwards
  double square = 0.0;                      // |step|^2, 0 where the row depends on the others
};

Direction direction_of(const ActiveRows& active, const Vec6& gradient) THIGMA_RT {
  Direction d;
  d.step = gradient;
  std::array<double, kMaxActive> along{};
  const std::size_t n = idx(active.count);
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < n; ++i) {
      const double part = active.basis[i].dot(d.step);
      along[i] += part;
      d.step -= part * active.basis[i];
    }
  }
  for (std::size_t i = n; i-- > 0;) {
    double sum = along[i];
    for (std::size_t k = i + 1; k < n; ++k) sum -= active.upper[i][k] * d.relief[k];
    d.relief[i] = sum / active.upper[i][i];
  }
  d.square = d.step.squaredNorm();
  if (active.count == kMaxActive || d.square < kDependent * kDependent) d.square = 0.0;
  return d;
}

/// Takes one violated row in; false where no step satisfies it.
bool take_in(const WhiteRows& rows, int row, Vec6& y, ActiveRows& active) THIGMA_RT {
  const Vec6 gradient = rows.row(row);
  double multiplier = 0.0;
  for (int turn = 0; turn <= 2 * kMaxActive; ++turn) {
    const Direction d = direction_of(active, gradient);
    const double excess = gradient.dot(y) - rows.limit[idx(row)];
    const double whole = d.square > 0.0 ? std::max(excess, 0.0) / d.square : kInfinity;
    double partial = kInfinity;
    int leaves = -1;
    for (int i = 0; i < active.count; ++i) {
      const double relief = d.relief[idx(i)];
      if (!(relief > 0.0)) continue;
      const double until = active.multiplier[idx(i)] / relief;
      if (until < partial) partial = until, leaves = i;
    }
    const double length = std::min(whole, partial);
    if (!(length < kInfinity)) return false;
    for (int i = 0; i < active.count; ++i) {
      const std::size_t k = idx(i);
      active.multiplier[k] = std::max(active.multiplier[k] - length * d.relief[k], 0.0);
    }
    multiplier += length;
    if (d.square > 0.0) y -= length * d.step;
    if (whole <= partial) {
      active.add(row, gradient, multiplier);
      return true;
    }
    active.remove(leaves);
  }
  return false;
}

/// The normals alone: the point nearest to `target` that no row forbids.
struct Nearest {
  Vec6 y = Vec6::Zero();
  ActiveRows active;
  int rounds = 0;
  bool is_whole = true;
};

Nearest nearest_point(const WhiteRows& rows, const Vec6& target, const RowImpulses& warm,
                      double accuracy) THIGMA_RT {
  Nearest result;
  result.y = target;
  for (; result.rounds < kMaxRounds; ++result.rounds) {
    Violation next{-1, accuracy};
    for (int i = 0; i < warm.active_count; ++i) {
      const int row = warm.active[idx(i)];
      if (row >= rows.count) continue;
      const double excess = rows.excess(row, result.y);
      if (excess > next.excess) next = {row, excess};
    }
    if (next.row < 0) next = most_violated(rows, result.y, accuracy);
    if (next.row < 0) return result;
    if (!take_in(rows, next.row, result.y, result.active)) break;
  }
  result.is_whole = false;
  return result;
}

/// A row that may press, with its two tangents, in white coordinates.
struct Cone {
  int row = -1;
  bool has_friction = false;
  bool is_sliding = false;
  double friction = 0.0;  // its coefficient now
  Vec6 normal = Vec6::Zero(), first = Vec6::Zero(), second = Vec6::Zero();
  double tangent_square = 0.0;  // the larger of the two tangents' squares
  // multipliers: of the unit normal, and of the tangents [N s]
  double press = 0.0, hold_first = 0.0, hold_second = 0.0;
};

/// Rows whose cones a solve looks at. What does not fit has no friction: more rows than press.
struct Cones {
  int count = 0;
  std::array<Cone, 64> cone;
};

Vec6 generalized(const Mat6& inverse, const Vec3& arm, const Vec3& direction) THIGMA_RT {
  Vec6 w;
  w << direction, arm.cross(direction);
  return inverse.triangularView<Eigen::Lower>() * w;
}

void add_cone(const VelocityRows& rows, const WhiteRows& white, const Mat6& inverse, int row,
              const RowImpulses& warm, Cones& cones) THIGMA_RT {
  for (int i = 0; i < cones.count; ++i)
    if (cones.cone[idx(i)].row == row) return;
  if (cones.count == static_cast<int>(cones.cone.size())) return;
  Cone& c = cones.cone[idx(cones.count++)];
  const std::size_t r = idx(row);
  c.row = row;
  c.has_friction = rows.static_friction[r] > 0.0;
  c.is_sliding = warm.is_sliding[r] || !c.has_friction;
  c.friction = c.is_sliding ? rows.friction[r] : rows.static_friction[r];
  c.normal = white.row(row);
  c.press = warm.normal[r] * white.length[r];
  c.hold_first = c.hold_second = c.tangent_square = 0.0;
  if (!c.has_friction) return;
  const Vec3 normal(rows.gradient[0][r], rows.gradient[1][r], rows.gradient[2][r]);
  const Vec3 tangent = rows.tangent[r];
  c.first = generalized(inverse, rows.arm[r], tangent);
  c.second = generalized(inverse, rows.arm[r], normal.cross(tangent));
  c.tangent_square = std::max(c.first.squaredNorm(), c.second.squaredNorm());
  c.hold_first = warm.tangential[r][0];
  c.hold_second = warm.tangential[r][1];
}

/// One cone brought to where its row neither gives way nor leaves Coulomb's law; returns how far y
/// moved.
double project(const WhiteRows& white, Cone& c, Vec6& y) THIGMA_RT {
  const double press = std::max(0.0, c.press + c.normal.dot(y) - white.limit[idx(c.row)]);
  double moved = std::fabs(press - c.press);
  y -= (press - c.press) * c.normal;
  c.press = press;
  if (!c.has_friction) return moved;
  double first = c.hold_first + c.first.dot(y) / c.tangent_square;
  double second = c.hold_second + c.second.dot(y) / c.tangent_square;
  const double most = c.friction * press / white.length[idx(c.row)];
  const double size = std::sqrt(first * first + second * second);
  if (size > most) {
    first *= most / size;
    second *= most / size;
  }
  const Vec6 by = (first - c.hold_first) * c.first + (second - c.hold_second) * c.second;
  y -= by;
  c.hold_first = first;
  c.hold_second = second;
  return std::max(moved, by.norm());
}

/// Largest friction impulse of a row [N s].
double most_hold(const WhiteRows& white, const Cone& c) THIGMA_RT {
  return c.friction * c.press / white.length[idx(c.row)];
}

double hold_of(const Cone& c) THIGMA_RT {
  return std::sqrt(c.hold_first * c.hold_first + c.hold_second * c.hold_second);
}

/// Rows on their static cone that still move slide from here on; returns whether there are any
/// whose coefficient that changes.
bool break_away(const VelocityRows& rows, const WhiteRows& white, const Vec6& y,
                Cones& cones) THIGMA_RT {
  constexpr double kMoving = 1e-3;  // of the speed that a whole cone stops, the largest
  double stopped = 0.0;
  for (int i = 0; i < cones.count; ++i)
    stopped =
        std::max(stopped, most_hold(white, cones.cone[idx(i)]) * cones.cone[idx(i)].tangent_square);
  bool is_any = false;
  for (int i = 0; i < cones.count; ++i) {
    Cone& c = cones.cone[idx(i)];
    const double kinetic = rows.friction[idx(c.row)];
    if (c.is_sliding || !(kinetic < c.friction)) continue;
    const double speed = std::hypot(c.first.dot(y), c.second.dot(y));
    if (!(speed > kMoving * stopped)) continue;
    c.is_sliding = is_any = true;
    c.friction = kinetic;
  }
  return is_any;
}

int most_sweeps(const Cones& cones) THIGMA_RT {
  return std::max(kMaxSweeps, kMaxProjections / std::max(cones.count, 1));
}

/// Gauss-Seidel over the cones from the warm start, rows that turn out to be violated taken in.
int solve_cones(const VelocityRows& rows, const WhiteRows& white, const Mat6& inverse,
                const Vec6& target, const RowImpulses& warm, double accuracy,
                Cones& cones) THIGMA_RT {
  Vec6 y = target;
  for (int i = 0; i < cones.count; ++i) {
    const Cone& c = cones.cone[idx(i)];
    y -= c.press * c.normal + c.hold_first * c.first + c.hold_second * c.second;
  }
  int sweeps = 0;
  while (sweeps < most_sweeps(cones)) {
    double moved = kInfinity;
    while (moved > accuracy && sweeps < most_sweeps(cones)) {
      moved = 0.0;
      for (int i = 0; i < cones.count; ++i)
        moved = std::max(moved, project(white, cones.cone[idx(i)], y));
      ++sweeps;
    }
    const Violation next = most_violated(white, y, 100.0 * accuracy);
    if (next.row < 0 && break_away(rows, white, y, cones)) continue;
    if (next.row < 0) break;
    const int before = cones.count;
    add_cone(rows, white, inverse, next.row, warm, cones);
    if (cones.count == before) break;
    Cone& c = cones.cone[idx(before)];
    c.press = c.hold_first = c.hold_second = 0.0;  // y does not hold them
  }
  return sweeps;
}

/// Friction impulses on y, scaled to what the cones of these normals allow in all: the normals
/// found exactly may press less than those of the sweeps.
Vec6 friction_pull(const Cones& cones, double scale) THIGMA_RT {
  Vec6 pull = Vec6::Zero();
  for (int i = 0; i < cones.count; ++i) {
    const Cone& c = cones.cone[idx(i)];
    pull += scale * (c.hold_first * c.first + c.hold_second * c.second);
  }
  return pull;
}

double coefficient_of(int row, const VelocityRows& rows, const Cones& cones) THIGMA_RT {
  for (int i = 0; i < cones.count; ++i)
    if (cones.cone[idx(i)].row == row) return cones.cone[idx(i)].friction;
  return rows.friction[idx(row)];
}

double allowed_share(const VelocityRows& rows, const WhiteRows& white, const Nearest& nearest,
                     const Cones& cones) THIGMA_RT {
  double held = 0.0, allowed = 0.0;
  for (int i = 0; i < cones.count; ++i) {
    held += hold_of(cones.cone[idx(i)]);
  }
  for (int i = 0; i < nearest.active.count; ++i) {
    const std::size_t k = idx(i), r = idx(nearest.active.row[k]);
    allowed += coefficient_of(nearest.active.row[k], rows, cones) * nearest.active.multiplier[k] /
               white.length[r];
  }
  constexpr double kRounding = 1e-6;
  return held <= allowed * (1.0 + kRounding) ? 1.0 : allowed / held;
}

bool has_friction(const VelocityRows& rows) THIGMA_RT {
  for (int i = 0; i < rows.count; ++i)
    if (rows.static_friction[idx(i)] > 0.0) return true;
  return false;
}

/// Whether friction is within the cone: nothing slides.
bool is_held(const WhiteRows& white, const Cone& c) THIGMA_RT {
  constexpr double kRounding = 1e-9;
  return c.has_friction && hold_of(c) < (1.0 - kRounding) * most_hold(white, c);
}

/// How friction held, at the end of a solve.
SlipCount count_slip(const WhiteRows& white, const Cones& cones, double scale,
                     const Vec6& y) THIGMA_RT {
  SlipCount slip;
  for (int i = 0; i < cones.count; ++i) {
    const Cone& c = cones.cone[idx(i)];
    if (!c.has_friction || !(c.press > 0.0)) continue;
    if (is_held(white, c)) {
      ++slip.sticking;
      continue;
    }
    ++slip.sliding;
    slip.work += scale * (c.hold_first * c.first.dot(y) + c.hold_second * c.second.dot(y));
  }
  return slip;
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
    impulses.is_sliding[r] = c.is_sliding && !is_held(white, c);
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
    for (int i = 0; i < rows.count; ++i)
      if (impulses.normal[idx(i)] > 0.0) add_cone(rows, white, f.inverse, i, impulses, cones);
    for (int i = 0; i < nearest.active.count; ++i)
      add_cone(rows, white, f.inverse, nearest.active.row[idx(i)], impulses, cones);
    solution.sweeps = solve_cones(rows, white, f.inverse, target, impulses, accuracy, cones);
    solution.rounds = nearest.rounds;
    nearest = nearest_point(white, target - friction_pull(cones, 1.0), impulses, accuracy);
    scale = allowed_share(rows, white, nearest, cones);
    if (scale < 1.0)
      nearest = nearest_point(white, target - friction_pull(cones, scale), impulses, accuracy);
  }
  keep_impulses(white, nearest, cones, scale, impulses);
  solution.rounds += nearest.rounds;
  solution.active = nearest.active.count;
  solution.is_whole = nearest.is_whole;
  solution.slip = count_slip(white, cones, scale, nearest.y);
  solution.velocity = f.inverse.transpose() * nearest.y;
  solution.impulse = f.lower * (nearest.y - target);
  for (int i = 0; i < rows.count; ++i) {
    const double excess = white.excess(i, nearest.y) * white.length[idx(i)];
    if (std::isfinite(excess)) solution.residual = std::max(solution.residual, excess);
  }
  return solution;
}

}  // namespace thigma
