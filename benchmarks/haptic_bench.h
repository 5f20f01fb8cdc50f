#pragma once
// CPU time of the haptic step, and of the dense solve it would need without the reduction to 6 x 6.

#include <vector>

namespace thigma::bench {

struct HapticTiming {
  // haptic_step with coupling and `clusters` contact planes, a tick each [s]
  std::vector<double> step;
  std::vector<double> dense;  // coupling, planes and the 13 x 13 step on the same states [s]
};

/// frames ticks of a body pressed onto `clusters` planes. Ticks are timed in blocks of 16, as one
/// is shorter than the clock can tell: percentiles are over block means.
HapticTiming time_haptic_step(int clusters, int frames);

}  // namespace thigma::bench
