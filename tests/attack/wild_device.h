#pragma once
// A simulated hand whose device misbehaves as it pleases.

#include <vector>

#include "thigma/device/hand.h"
#include "thigma/math/random.h"

namespace thigma::test {

/// What goes wrong with a sample.
enum class Mischief : std::uint8_t {
  nan_position,
  infinite_velocity,
  nan_orientation,
  no_orientation,  // a quaternion of zeros
  jump,
  turn,      // as jump, of the orientation
  too_fast,  // by its own report
  spinning,  // the same of turning
  lost,
  not_ready,
  silent,     // the sample before, stamp and all
  backwards,  // a stamp of the past
  buttons,    // all of them turned over
  light,      // a weight below 1
};
inline constexpr std::uint64_t kMischiefs = 14;

/// A HandDevice with mischief in spans of frames. Same numbers, same samples.
class WildDevice final : public HapticDevice {
 public:
  /// frames   about how many there will be
  WildDevice(const HandParams& hand, Random& random, std::uint64_t frames);

  const DeviceLimits& limits() const override { return hand_.limits(); }
  std::string name() const override { return "wild"; }
  DeviceState read(double now) THIGMA_RT override;
  void write(const Wrench& wrench) THIGMA_RT override;

  const Wrench& written() const { return written_; }

 private:
  struct Span {
    std::uint64_t first = 0, end = 0;
    Mischief kind = Mischief::jump;
    double size = 0.0;  // 0 to 1
    Vec3 along = Vec3::UnitX();
  };
  static void spoil(const Span& span, const DeviceState& before, DeviceState& state) THIGMA_RT;

  HandDevice hand_;
  std::vector<Span> spans_;
  DeviceState last_;
  Wrench written_;
  std::uint64_t frame_ = 0;
};

}  // namespace thigma::test
