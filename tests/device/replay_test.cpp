#include "thigma/device/replay.h"

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(ReplayDevice, GivesEverySampleOnceThenFinishes) {
  std::vector<DeviceState> samples(3);
  for (int i = 0; i < 3; ++i) {
    samples[i].time = 0.1 * i;
    samples[i].motion.pose.position.x() = 1.0 / 3.0 + i;
    samples[i].buttons = static_cast<std::uint32_t>(i);
  }
  samples[1].status = DeviceStatus::not_ready;
  const auto device = make_replay_device(samples, {.max_force = 7.0});
  EXPECT_EQ(device->limits().max_force, 7.0);
  for (int i = 0; i < 3; ++i) {
    const DeviceState state = device->read(1000.0);  // the clock of the reader does not matter
    EXPECT_EQ(state.time, samples[i].time);
    EXPECT_EQ(state.motion.pose.position, samples[i].motion.pose.position);
    EXPECT_EQ(state.buttons, samples[i].buttons);
    EXPECT_EQ(state.status, samples[i].status);
    device->write({{1.0, 2.0, 3.0}, Vec3::Zero()});
  }
  for (int i = 0; i < 2; ++i) {
    const DeviceState state = device->read(0.0);
    EXPECT_EQ(state.status, DeviceStatus::finished);
    EXPECT_EQ(state.motion.pose.position, samples[2].motion.pose.position);
  }
}

TEST(ReplayDevice, WithoutSamplesIsFinishedAtOnce) {
  EXPECT_EQ(make_replay_device({})->read(0.5).status, DeviceStatus::finished);
}

}  // namespace
}  // namespace thigma
