#include "thigma/multibody/detail/block_cholesky.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma::detail {
namespace {

/// A random symmetric positive definite matrix whose rows of blocks begin where `first` says.
BlockMatrix random_matrix(const std::vector<std::int32_t>& first, Random& random) {
  BlockMatrix m;
  m.first = first;
  shape_blocks(m);
  const auto count = static_cast<std::int32_t>(first.size());
  for (std::int32_t i = 0; i < count; ++i) {
    for (std::int32_t j = first[static_cast<std::size_t>(i)]; j <= i; ++j)
      m.at(i, j) = Mat6::NullaryExpr([&] { return random.normal(); });
    const Mat6 square = m.at(i, i) * m.at(i, i).transpose();
    m.at(i, i) = square + 200.0 * Mat6::Identity();
  }
  return m;
}

Eigen::MatrixXd dense(const BlockMatrix& m) {
  const auto count = static_cast<std::int32_t>(m.first.size());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(6 * count, 6 * count);
  for (std::int32_t i = 0; i < count; ++i) {
    for (std::int32_t j = m.first[static_cast<std::size_t>(i)]; j <= i; ++j) {
      full.block<6, 6>(6 * i, 6 * j) = m.at(i, j);
      full.block<6, 6>(6 * j, 6 * i) = m.at(i, j).transpose();
    }
  }
  return full;
}

TEST(BlockCholesky, SolvesAsADenseMatrixDoes) {
  Random random(3);
  for (const std::vector<std::int32_t>& first :
       {std::vector<std::int32_t>{0}, {0, 0, 1, 2}, {0, 1, 2}, {0, 0, 0, 2, 1, 4}}) {
    BlockMatrix m = random_matrix(first, random);
    const Eigen::MatrixXd full = dense(m);
    std::vector<Vec6> x(first.size());
    Eigen::VectorXd b(full.rows());
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = Vec6::NullaryExpr([&] { return random.normal(); });
      b.segment<6>(6 * static_cast<Eigen::Index>(i)) = x[i];
    }
    ASSERT_TRUE(factor_blocks(m));
    solve_blocks(m, x);
    const Eigen::VectorXd expected = full.ldlt().solve(b);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_LT((x[i] - expected.segment<6>(6 * static_cast<Eigen::Index>(i))).norm(),
                1e-12 * expected.norm());
  }
}

TEST(BlockCholesky, SaysWhereAMatrixIsNotPositive) {
  Random random(4);
  BlockMatrix m = random_matrix({0, 0, 1}, random);
  m.at(1, 1)(3, 3) = -1.0;
  EXPECT_FALSE(factor_blocks(m));
  m = random_matrix({0, 0}, random);
  m.at(1, 1)(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(factor_blocks(m));
}

}  // namespace
}  // namespace thigma::detail
