#pragma once
// Velocity from quantised positions, as drivers estimate it.

#include <array>
#include <cstddef>

#include "thigma/core/rt.h"
#include "thigma/math/pose.h"

namespace thigma::detail {

/// First-order adaptive windowing: the slope over the longest window in which a straight line
/// explains every sample to one encoder step, each axis by itself; so fast motion has little lag
/// and slow motion little noise. Invariant: times in the ring increase. Source: Janabi-Sharifi,
/// Hayward, Chen 2000, end-fit variant.
class VelocityEstimate {
 public:
  /// step, angular_step  encoder steps [m, rad]; window, angular_window: longest windows [s].
  VelocityEstimate(double step, double angular_step, double window, double angular_window) THIGMA_RT
      : step_(step),
        angular_step_(angular_step),
        window_(window),
        angular_window_(angular_window) {}

  /// Estimate after one more sample; the last one again when time stands still. Where it goes back,
  /// as a clock that is set does, the estimate begins anew, from rest. Thread [haptic].
  const Twist& update(double time, const Pose& pose) THIGMA_RT;

 private:
  struct Sample {
    double time = 0.0;
    Pose pose;
  };
  // 15 ms at 4 kHz; at higher rates the window is shorter
  static constexpr std::size_t kSamples = 64;

  const Sample& back(std::size_t age) const THIGMA_RT {
    return samples_[(newest_ + kSamples - age) % kSamples];
  }

  std::array<Sample, kSamples> samples_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
  double step_, angular_step_, window_, angular_window_;
  Twist twist_;
};

}  // namespace thigma::detail
