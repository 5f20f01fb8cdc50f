#pragma once
// Central differences: the twin of every analytic Jacobian.

#include "thigma/math/types.h"

namespace thigma {

/// Jacobian of a function of a fixed-size vector by fourth-order central differences,
/// error ~ step^4.
///
/// f      callable: Eigen::Matrix<double, Columns, 1> -> Eigen::Matrix<double, Rows, 1>
/// y      where
/// steps  step of every component, in its own unit; f must be smooth within +-2 steps
/// Thread  [offline].
template <int Rows, int Columns, class Function>
Eigen::Matrix<double, Rows, Columns> finite_difference_jacobian(
    const Function& f, const Eigen::Matrix<double, Columns, 1>& y,
    const Eigen::Matrix<double, Columns, 1>& steps) {
  using Vector = Eigen::Matrix<double, Columns, 1>;
  const auto at = [&](int column, double offset) -> Eigen::Matrix<double, Rows, 1> {
    Vector moved = y;
    moved[column] += offset;
    return f(moved);
  };
  Eigen::Matrix<double, Rows, Columns> jacobian;
  for (int i = 0; i < Columns; ++i) {
    const double h = steps[i];
    jacobian.col(i) =
        (8.0 * (at(i, h) - at(i, -h)) - (at(i, 2.0 * h) - at(i, -2.0 * h))) / (12.0 * h);
  }
  return jacobian;
}

}  // namespace thigma
