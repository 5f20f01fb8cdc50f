#pragma once
// The normals alone: the point nearest to a target that no row forbids, by the dual method of
// Goldfarb and Idnani (1983).

#include <array>

#include "thigma/dynamics/detail/white_rows.h"

namespace thigma::detail {

/// Rows that press, with an orthonormal basis of their directions: direction = basis * upper.
struct ActiveRows {
  int count = 0;
  std::array<int, kMaxActive> row{};
  std::array<double, kMaxActive> multiplier{};
  std::array<Vec6, kMaxActive> direction{}, basis{};
  std::array<std::array<double, kMaxActive>, kMaxActive> upper{};

  /// Those before `from` are as they were.
  void orthonormalize(std::size_t from) THIGMA_RT;
  void add(int index, const Vec6& gradient, double by) THIGMA_RT;
  void remove(int at) THIGMA_RT;
};

/// What was found.
struct Nearest {
  Vec6 y = Vec6::Zero();
  ActiveRows active;
  int rounds = 0;
  bool is_whole = true;
};

/// target    in white coordinates
/// warm      whose rows are tried first
/// accuracy  by which a row may be violated
/// Thread    [haptic]; no failure: is_whole is false where rounds run out or rows contradict each
///           other.
Nearest nearest_point(const WhiteRows& rows, const Vec6& target, const RowImpulses& warm,
                      double accuracy) THIGMA_RT;

}  // namespace thigma::detail
