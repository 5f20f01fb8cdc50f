#pragma once
// What the machine itself can do, beside which every figure is read.

#include <cstdint>
#include <optional>
#include <vector>

namespace thigma::bench {

/// CPU time of the calling thread [s].
double thread_cpu();

/// Billions of dependent integer additions a second of CPU time, best of several runs: the clock
/// the code really got.
double dependent_adds();

/// How late an empty 1 kHz loop wakes up over `seconds` [s each], with the scheduling the process
/// has.
std::vector<double> empty_loop_lateness(double seconds);

/// What is said about many calls, in their unit. What was not measured is absent, never 0.
struct Figure {
  double p50 = 0.0, p99 = 0.0;
  std::optional<double> p999{}, max{};
};

/// Percentiles of samples times a factor: of seconds, 1e6 gives microseconds.
Figure figure_of(const std::vector<double>& samples, double factor);

}  // namespace thigma::bench
