// What a user has confirmed of a device, on the disk.
#include "thigma/device/detail/device_profile.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma::detail {
namespace {

TEST(DeviceProfile, is_kept_and_nothing_else_is_believed) {
  const std::string folder = testing::TempDir() + "thigma_profiles";
  std::filesystem::remove_all(folder);
  setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  const std::string file = device_profile_file("openhaptics-Touch X/../7");
  EXPECT_EQ(file, folder + "/thigma/devices/openhaptics-Touch-X-..-7.txt");
  EXPECT_EQ(read_device_profile(file).torque_unit, 0.0);
  for (const double unit : {1.0, 1000.0}) {
    write_device_profile(file, {unit});
    EXPECT_EQ(read_device_profile(file).torque_unit, unit);
  }
  std::ofstream(file) << "# thigma device profile\ntorque_unit = 100000\n";
  EXPECT_THROW(read_device_profile(file), InputError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace thigma::detail
