#include "thigma/files/compression.h"

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

std::string lines(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "{\"frame\":" + std::to_string(i) + ",\"force\":0}\n";
  return text;
}

std::string noise(std::size_t size) {
  Random random(7);
  std::string bytes(size, '\0');
  for (char& c : bytes) c = static_cast<char>(random.below(256));
  return bytes;
}

class Compression : public ::testing::Test {
  void SetUp() override {
    if (!has_zstd()) GTEST_SKIP() << "this build has no zstd";
  }
};

TEST_F(Compression, GivesBackWhatItTook) {
  const std::string bytes = lines(5000);
  const std::string stored = compress(bytes);
  EXPECT_LT(stored.size(), bytes.size() / 4);
  EXPECT_EQ(expand(stored, bytes.size()), bytes);
  EXPECT_EQ(compress(bytes), stored);
  EXPECT_EQ(expanded_size(stored), bytes.size());
  EXPECT_FALSE(expanded_size(bytes));
}

TEST_F(Compression, LeavesAloneWhatGetsNoShorter) {
  EXPECT_EQ(compress(noise(1000)), "");
  EXPECT_EQ(compress(""), "");
}

TEST_F(Compression, RefusesAnotherSizeAndWhatIsCutOff) {
  const std::string bytes = lines(200);
  const std::string stored = compress(bytes);
  EXPECT_FALSE(expand(stored, bytes.size() - 1));
  EXPECT_FALSE(expand(stored, bytes.size() + 1));
  // before there is memory for it
  EXPECT_FALSE(expand(stored, std::uint64_t{1} << 60));
  for (std::size_t size = 0; size < stored.size(); ++size)
    EXPECT_FALSE(expand(std::string_view(stored).substr(0, size), bytes.size()));
  EXPECT_FALSE(expand(noise(100), 100));
}

TEST_F(Compression, FlippedBitsNeverGiveMoreThanWasAskedFor) {
  const std::string bytes = lines(50);
  const std::string stored = compress(bytes);
  for (std::size_t at = 0; at < stored.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = stored;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      const auto back = expand(damaged, bytes.size());
      EXPECT_TRUE(!back || back->size() == bytes.size());
    }
  }
}

}  // namespace
}  // namespace thigma
