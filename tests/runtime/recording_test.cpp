#include "thigma/runtime/recording.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>

#include "runtime/recording_samples.h"
#include "thigma/core/error.h"
#include "thigma/core/file.h"

namespace thigma {
namespace {

TEST(Recording, every_input_number_is_in_the_input_hash) {
  const HapticSample base = test::sample(3);
  const std::uint64_t hash = input_hash(base);
  HapticSample s = base;
  const auto differs = [&](auto change) {
    s = base;
    change();
    return input_hash(s) != hash;
  };
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(differs([&] { test::flip_last_bit(s.device.motion.pose.position[i]); }));
    EXPECT_TRUE(differs([&] { test::flip_last_bit(s.device.motion.twist.linear[i]); }));
    EXPECT_TRUE(differs([&] { test::flip_last_bit(s.device.motion.twist.angular[i]); }));
  }
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(differs([&] { test::flip_last_bit(s.device.motion.pose.orientation.coeffs()[i]); }));
  }
  EXPECT_TRUE(differs([&] { s.device.buttons ^= 1u; }));
  EXPECT_TRUE(differs([&] { s.model_sequence ^= 1u; }));
  EXPECT_TRUE(differs([&] { s.external_fault = Fault::watchdog; }));
  EXPECT_FALSE(differs([&] { s.step_cpu = 1.0f; }));
}

TEST(Recording, opens_in_the_official_reader_with_all_topics) {
  const std::filesystem::path reader = std::filesystem::path(THIGMA_SOURCE_DIR) / "tests/mcap_reader";
  if (!std::filesystem::exists(reader / "node_modules/@mcap/core")) {
    GTEST_SKIP() << "needs `npm ci` in tests/mcap_reader (scripts/test does it where npm reaches a registry)";
  }
  const std::string path = test::write_recording("official_session.mcap", 500);
  const std::string out = path + ".json";
  const std::string command = "node '" + (reader / "read.mjs").string() + "' '" + path + "' > '" + out + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string line = read_file(out);
  for (const char* topic : {"/device/state\":500", "/device/command\":500", "/body/state\":500", "/timing\":500",
                            "/contact/model\":50", "/contact/frame\":50", "/events\":", "/config\":1"}) {
    EXPECT_NE(line.find(topic), std::string::npos) << topic << " in " << line.substr(0, 300);
  }
}

}  // namespace
}  // namespace thigma
