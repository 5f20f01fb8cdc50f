#pragma once
// A recording of a world whose numbers are known.

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/recording/world_recording.h"

namespace thigma::test {

inline constexpr std::uint64_t kFrames = 30;
inline constexpr std::uint64_t kSteps = 2;  // of each hand in a frame

inline std::string path_of(const char* name) { return ::testing::TempDir() + "thigma_" + name; }

inline WorldRecordingInfo info_of(bool is_apart) {
  WorldRecordingInfo info;
  info.devices = {"hand:", "web:"};
  info.bodies = {"block, \"red\"", "ring"};
  info.joints = {"hinge"};
  info.is_apart = is_apart;
  return info;
}

inline BodyState body_at(std::uint64_t frame, int body) {
  BodyState y;
  y.position = Vec3(0.1 * static_cast<double>(frame), -0.0, 1.0 / (3.0 + body));
  y.linear_momentum = Vec3(1e-300, 1e300, 1.0);
  return y;
}

/// Two bodies, of which the second falls asleep after ten frames, a joint and two hands.
inline void write_world(const std::string& path, bool is_apart) {
  WorldRecordingWriter writer(path, info_of(is_apart));
  for (std::uint64_t i = 0; i < kFrames; ++i) {
    const std::vector<BodyState> bodies{body_at(i, 0), body_at(i, 1)};
    const RecordedJoint joint{0.25 * static_cast<double>(i), 1.0, 2.0, 3.0};
    const std::vector<Wrench> commands{{Vec3(1.0, 2.0, 3.0), Vec3::Zero()}, {}};
    std::vector<RecordedHand> hands(2);
    hands[0].device.motion.pose.position = Vec3(0.5, 0.0, static_cast<double>(i));
    hands[0].energy = 1e-3 * static_cast<double>(i);
    hands[1].device.buttons = 100000;
    const std::vector<std::uint8_t> is_asleep{0, static_cast<std::uint8_t>(i >= 10 ? 1 : 0)};
    writer.write(i, 1e-3 * static_cast<double>(i + 1), bodies, {&joint, 1}, commands, hands,
                 is_asleep);
    std::vector<HandTick> ticks(is_apart ? 2 * kSteps : 0);
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      ticks[k].hand = static_cast<std::int32_t>(k % 2);
      ticks[k].step = kSteps * i + k / 2;
      ticks[k].tick.now = 0.5e-3 * static_cast<double>(ticks[k].step);
      ticks[k].sent.force.z() = static_cast<double>(k);
      ticks[k].energy = -1.0;
      ticks[k].tick.external_fault = k == 0 ? Fault::watchdog : Fault::none;
    }
    writer.write(ticks);
  }
  writer.close(kFrames, 1);
}

}  // namespace thigma::test
