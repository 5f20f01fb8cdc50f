#include "thigma/dynamics/detail/white_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/math/infinity.h"

namespace thigma::detail {

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

}  // namespace thigma::detail
