#pragma once
// Cholesky factors of a symmetric matrix of 6 x 6 blocks, each row of blocks from its first one
// that is not zero on (its envelope).

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/math/types.h"

namespace thigma::detail {

/// A symmetric positive definite matrix, then its lower factor in place. Blocks of row i are those
/// of columns first[i]..i.
struct BlockMatrix {
  std::vector<std::int32_t> first;  // by row: its first column
  std::vector<std::int32_t> start;  // by row: where its blocks begin, and the end
  std::vector<Mat6> blocks;

  Mat6& at(std::int32_t row, std::int32_t column) noexcept {
    return blocks[static_cast<std::size_t>(start[static_cast<std::size_t>(row)] + column -
                                           first[static_cast<std::size_t>(row)])];
  }
  const Mat6& at(std::int32_t row, std::int32_t column) const noexcept {
    return blocks[static_cast<std::size_t>(start[static_cast<std::size_t>(row)] + column -
                                           first[static_cast<std::size_t>(row)])];
  }
};

/// Shape of a matrix from `first`, which is set; blocks are not set. Memory only grows.
void shape_blocks(BlockMatrix& matrix);

/// L of A = L L^T in place. Returns false where A is not positive definite to rounding.
bool factor_blocks(BlockMatrix& matrix) noexcept;

/// x with L L^T x = b, in place.
void solve_blocks(const BlockMatrix& factor, std::span<Vec6> x) noexcept;

}  // namespace thigma::detail
