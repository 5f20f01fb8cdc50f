#pragma once
// The rows of a solve in coordinates where the metric is the identity.

#include <array>

#include "thigma/core/index.h"
#include "thigma/dynamics/row_solve.h"

namespace thigma::detail {

/// L of A = L L^T, and L^-1 by forward substitution. A of any scale: no pivoting is needed.
struct Factor {
  Mat6 lower = Mat6::Zero();
  Mat6 inverse = Mat6::Zero();  // of lower
};

/// Thread [haptic].
Factor factor(const Mat6& metric) THIGMA_RT;

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

/// inverse: Factor::inverse. Thread [haptic].
void whiten(const VelocityRows& rows, const Mat6& inverse, WhiteRows& white) THIGMA_RT;

/// A row that y violates, or -1.
struct Violation {
  int row = -1;
  double excess = 0.0;
};

/// The row that y violates the most, by more than `accuracy`. Thread [haptic].
Violation most_violated(const WhiteRows& rows, const Vec6& y, double accuracy) THIGMA_RT;

}  // namespace thigma::detail
