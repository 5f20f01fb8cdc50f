#pragma once
// Dense linear systems of a few unknowns, in place, with nothing but arithmetic.

#include <cmath>
#include <utility>

#include "thigma/core/rt.h"
#include "thigma/math/types.h"

namespace thigma {

/// Solves a x = b by Gaussian elimination with partial pivoting.
///
/// a       (N x N), destroyed; rows should be of like size, the caller scales
/// b       (N x M) right-hand sides; on return the solutions, not finite where `a` is singular
/// Thread  [haptic]; no failure: the caller's finiteness check is the one that counts.
template <int N, int M>
void solve_in_place(
    Eigen::Matrix<double, N, N, Eigen::RowMajor>& a,
    Eigen::Matrix<double, N, M, M == 1 ? Eigen::ColMajor : Eigen::RowMajor>& b) THIGMA_RT {
  for (int k = 0; k < N; ++k) {
    int pivot = k;
    for (int i = k + 1; i < N; ++i) {
      if (std::fabs(a(i, k)) > std::fabs(a(pivot, k))) pivot = i;
    }
    if (pivot != k) {
      for (int j = k; j < N; ++j) std::swap(a(k, j), a(pivot, j));
      for (int j = 0; j < M; ++j) std::swap(b(k, j), b(pivot, j));
    }
    const double inverse = 1.0 / a(k, k);
    a(k, k) = inverse;
    for (int i = k + 1; i < N; ++i) {
      const double factor = a(i, k) * inverse;
      for (int j = k + 1; j < N; ++j) a(i, j) -= factor * a(k, j);
      for (int j = 0; j < M; ++j) b(i, j) -= factor * b(k, j);
    }
  }
  for (int k = N - 1; k >= 0; --k) {
    for (int j = 0; j < M; ++j) {
      double sum = b(k, j);
      for (int i = k + 1; i < N; ++i) sum -= a(k, i) * b(i, j);
      b(k, j) = sum * a(k, k);
    }
  }
}

}  // namespace thigma
