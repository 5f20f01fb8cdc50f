#include "thigma/dynamics/detail/nearest_point.h"

#include <algorithm>

#include "thigma/math/infinity.h"

namespace thigma::detail {
namespace {

constexpr int kMaxRounds = 100;  // rows taken in; a few are usual
// A row whose direction lies this near to the span of those that press adds nothing to them.
constexpr double kDependent = 1e-11;

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

}  // namespace

void ActiveRows::orthonormalize(std::size_t from) THIGMA_RT {
  for (std::size_t j = from; j < idx(count); ++j) {
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

void ActiveRows::add(int index, const Vec6& gradient, double by) THIGMA_RT {
  const std::size_t n = idx(count++);
  row[n] = index;
  direction[n] = gradient;
  multiplier[n] = by;
  orthonormalize(n);
}

void ActiveRows::remove(int at) THIGMA_RT {
  --count;
  for (int i = at; i < count; ++i) {
    const std::size_t to = idx(i);
    row[to] = row[to + 1];
    direction[to] = direction[to + 1];
    multiplier[to] = multiplier[to + 1];
  }
  orthonormalize(idx(at));
}

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

}  // namespace thigma::detail
