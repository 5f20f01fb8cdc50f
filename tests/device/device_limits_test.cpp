#include "thigma/device/device_limits.h"

#include <gtest/gtest.h>

#include "thigma/device/open_device.h"

namespace thigma {
namespace {

TEST(DeviceLimits, TableIsSortedAndComplete) {
  const auto models = device_models();
  ASSERT_GE(models.size(), 6u);
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(models[i - 1].name, models[i].name);
    }
    EXPECT_EQ(find_device_model(models[i].name), &models[i]);
    EXPECT_GT(models[i].max_force + models[i].max_stiffness, 0.0);
    // Whoever publishes a torque actuates rotation.
    if (models[i].max_torque > 0.0) {
      EXPECT_TRUE(models[i].actuates_rotation);
    }
  }
  EXPECT_EQ(find_device_model("omni"), nullptr);
}

TEST(DeviceLimits, EveryModelCanBeHeld) {
  for (const DeviceModel& model : device_models()) {
    const auto device = open_device("hand:?device=" + std::string(model.name));
    if (model.max_force > 0.0) {
      EXPECT_EQ(device->limits().max_force, model.max_force);
    }
    if (model.max_stiffness > 0.0) {
      EXPECT_EQ(device->limits().max_stiffness, model.max_stiffness);
    }
    EXPECT_EQ(device->limits().actuates_rotation, model.actuates_rotation);
    EXPECT_EQ(device->limits().senses_rotation, model.senses_rotation);
  }
}

}  // namespace
}  // namespace thigma
