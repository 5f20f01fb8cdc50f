#include "thigma/device/null_device.h"

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(NullDevice, StaysWhateverIsApplied) {
  const auto held = make_null_device();
  held->write({{5.0, 0.0, 0.0}, {0.0, 1.0, 0.0}});
  const DeviceState state = held->read(2.5);
  EXPECT_EQ(state.time, 2.5);
  EXPECT_EQ(state.motion.pose.position, Vec3::Zero());
  EXPECT_EQ(state.motion.pose.orientation.coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(state.buttons, kClutchButton);
  EXPECT_EQ(state.status, DeviceStatus::ok);
  EXPECT_EQ(make_null_device(false)->read(0.0).buttons, 0u);
}

}  // namespace
}  // namespace thigma
