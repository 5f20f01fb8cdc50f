#include "thigma/multibody/detail/block_cholesky.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// Lower factor of one block in place, zeros above.
bool factor_block(Mat6& a) noexcept {
  for (int j = 0; j < 6; ++j) {
    double square = a(j, j);
    for (int k = 0; k < j; ++k) square -= a(j, k) * a(j, k);
    if (!(square > 0.0) || !std::isfinite(square)) return false;
    a(j, j) = std::sqrt(square);
    for (int i = j + 1; i < 6; ++i) {
      double sum = a(i, j);
      for (int k = 0; k < j; ++k) sum -= a(i, k) * a(j, k);
      a(i, j) = sum / a(j, j);
    }
    for (int i = 0; i < j; ++i) a(i, j) = 0.0;
  }
  return true;
}

/// X L^T = B, in place of B.
void divide_right(const Mat6& lower, Mat6& b) noexcept {
  for (int j = 0; j < 6; ++j) {
    for (int k = 0; k < j; ++k) b.col(j) -= lower(j, k) * b.col(k);
    b.col(j) /= lower(j, j);
  }
}

}  // namespace

void shape_blocks(BlockMatrix& matrix) {
  const std::size_t count = matrix.first.size();
  matrix.start.resize(count + 1);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    matrix.start[i] = next;
    next += static_cast<std::int32_t>(i) - matrix.first[i] + 1;
  }
  matrix.start[count] = next;
  if (matrix.blocks.size() < idx(next)) matrix.blocks.resize(idx(next));
}

bool factor_blocks(BlockMatrix& matrix) noexcept {
  const auto count = static_cast<std::int32_t>(matrix.first.size());
  for (std::int32_t i = 0; i < count; ++i) {
    for (std::int32_t j = matrix.first[idx(i)]; j < i; ++j) {
      Mat6& target = matrix.at(i, j);
      const std::int32_t from = std::max(matrix.first[idx(i)], matrix.first[idx(j)]);
      for (std::int32_t k = from; k < j; ++k)
        target.noalias() -= matrix.at(i, k) * matrix.at(j, k).transpose();
      divide_right(matrix.at(j, j), target);
    }
    Mat6& diagonal = matrix.at(i, i);
    for (std::int32_t k = matrix.first[idx(i)]; k < i; ++k)
      diagonal.noalias() -= matrix.at(i, k) * matrix.at(i, k).transpose();
    if (!factor_block(diagonal)) return false;
  }
  return true;
}

void solve_blocks(const BlockMatrix& factor, std::span<Vec6> x) noexcept {
  const auto count = static_cast<std::int32_t>(factor.first.size());
  for (std::int32_t i = 0; i < count; ++i) {
    Vec6& b = x[idx(i)];
    for (std::int32_t k = factor.first[idx(i)]; k < i; ++k)
      b.noalias() -= factor.at(i, k) * x[idx(k)];
    factor.at(i, i).triangularView<Eigen::Lower>().solveInPlace(b);
  }
  for (std::int32_t i = count; i-- > 0;) {
    Vec6& b = x[idx(i)];
    factor.at(i, i).triangularView<Eigen::Lower>().transpose().solveInPlace(b);
    for (std::int32_t k = factor.first[idx(i)]; k < i; ++k)
      x[idx(k)].noalias() -= factor.at(i, k).transpose() * b;
  }
}

}  // namespace thigma::detail
