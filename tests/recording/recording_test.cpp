#include "thigma/recording/recording.h"

#include <cstdlib>
#include <filesystem>
#include <limits>

#include "recording/recording_samples.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma {
namespace {

TEST(Recording, bits_are_told_in_sixteen_digits) {
  EXPECT_EQ(hex_text(0), std::string(16, '0'));
  EXPECT_EQ(hex_text(0x0123456789abcdefull), "0123456789abcdef");
}

TEST(Recording, opens_in_the_official_reader_with_all_topics) {
  const std::filesystem::path reader =
      std::filesystem::path(THIGMA_SOURCE_DIR) / "tests/mcap_reader";
  if (!std::filesystem::exists(reader / "node_modules/@mcap/core")) {
    GTEST_SKIP() << "needs `npm ci` in tests/mcap_reader (scripts/test does it where npm reaches a "
                    "registry)";
  }
  const std::string path = test::write_recording("official_session.mcap", 500);
  const std::string out = path + ".json";
  const std::string command =
      "node '" + (reader / "read.mjs").string() + "' '" + path + "' > '" + out + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string line = read_file(out);
  for (const char* topic :
       {"/device/state\":500", "/device/command\":500", "/body/state\":500", "/timing\":500",
        "/contact/model\":50", "/contact/frame\":50", "/events\":", "/config\":1"}) {
    EXPECT_NE(line.find(topic), std::string::npos) << topic << " in " << line.substr(0, 300);
  }
}

}  // namespace
}  // namespace thigma
