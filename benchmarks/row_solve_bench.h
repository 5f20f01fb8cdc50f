#pragma once
// CPU time of the constrained response with many rows that press, with friction.

#include <vector>

namespace thigma::bench {

/// A tick each.
struct RowSolveTiming {
  std::vector<double> solve;  // of the rows [s]
  std::vector<double> step;   // of the haptic step around it [s]
  std::vector<double> clock;  // of reading the clock, that is part of the former [s]
  double rows_pressed = 0.0;  // at the beginning of a solve, mean
  double residual_max = 0.0;  // [m/s]
  double sliding_share = 0.0;
};

/// A foot of rows x rows places on a plate, all of which press when a solve begins, with friction
/// 0.3: pressed down, tilted and led in a circle, where most slide at the end of a tick. Every tick
/// starts from a load that is spread over all of them: as many as there can be.
RowSolveTiming time_row_solve(int rows, int frames);

}  // namespace thigma::bench
