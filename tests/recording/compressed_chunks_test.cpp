#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/compression.h"
#include "thigma/files/file.h"
#include "thigma/math/random.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

std::string scratch(const std::string& name) { return ::testing::TempDir() + "thigma_" + name; }

/// One compressed chunk of 1000 messages.
std::string compressed_file(const std::string& name) {
  const std::string path = scratch(name);
  McapWriter writer(path);
  const std::uint16_t channel = writer.add_channel("/a", "A", "");
  for (std::uint32_t i = 0; i < 1000; ++i)
    writer.write(channel, i, i, "{\"v\":" + std::to_string(i) + "}");
  writer.close();
  return path;
}

std::string refusal_of(const std::string& bytes) {
  try {
    parse_mcap(bytes, "x");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class CompressedChunks : public ::testing::Test {
  void SetUp() override {
    if (!has_zstd()) GTEST_SKIP() << "this build has no zstd";
  }
};

TEST_F(CompressedChunks, FilesAreAFractionOfWhatTheyHold) {
  const std::string path = compressed_file("chunks_short.mcap");
  const McapFile file = read_mcap(path);
  ASSERT_EQ(file.messages.size(), 1000u);
  EXPECT_EQ(file.messages[999].data, "{\"v\":999}");
  EXPECT_NE(file.messages[999].place.chunk, 0u);
  std::size_t held = 0;
  for (const McapMessage& message : file.messages) held += message.data.size() + 31;
  // the index of 16 bytes a message is not compressed
  EXPECT_LT(file.bytes.size(), 16u * 1000u + held / 4);
}

TEST_F(CompressedChunks, MessagesAreFoundAgainByTheirPlacesInAnyOrder) {
  const std::string path = scratch("chunks_places.mcap");
  {
    McapWriter writer(path);
    const std::uint16_t channel = writer.add_channel("/a", "A", "");
    for (std::uint32_t i = 0; i < 3000; ++i) {
      writer.write(channel, i, i, "{\"v\":" + std::to_string(i) + "}");
      if (i % 100 == 99) writer.flush();
    }
    writer.close();
  }
  const McapFile file = read_mcap(path);
  MemorySource source(file.bytes);
  McapMessages messages(source);
  Random random(3);
  for (int k = 0; k < 500; ++k) {
    const McapMessage& message = file.messages[random.below(file.messages.size())];
    EXPECT_EQ(messages.data(message.place), message.data);
  }
  EXPECT_THROW(messages.data({file.messages.back().place.chunk, std::uint64_t{1} << 40}),
               InputError);
  EXPECT_EQ(messages.data(file.messages[0].place), file.messages[0].data);
}

TEST_F(CompressedChunks, ChunksOfOtherKindsAndOfNoSizeAreRefusedWithTheReason) {
  const std::string bytes = read_file(compressed_file("chunks_lies.mcap"));
  const std::size_t name = bytes.find("zstd");
  ASSERT_NE(name, std::string::npos);
  std::string other = bytes;
  other.replace(name, 4, "lz4!");
  EXPECT_NE(refusal_of(other).find("expected zstd or none"), std::string::npos);
  std::string large = bytes;
  large[name - 9] = 1;  // the size: 2^56 bytes
  EXPECT_NE(refusal_of(large).find("expected at most 268435456"), std::string::npos)
      << refusal_of(large);
  std::string longer = bytes;
  longer[name - 16] = static_cast<char>(longer[name - 16] + 1);
  EXPECT_NE(refusal_of(longer).find("does not expand"), std::string::npos) << refusal_of(longer);
}

TEST(Recordings, OfEarlierVersionsAreNotCompressedAndRead) {
  const std::string path = std::string(THIGMA_SOURCE_DIR) + "/tests/fuzz/corpus/recording/session";
  const McapFile file = read_mcap(path);
  ASSERT_FALSE(file.messages.empty());
  for (const McapMessage& message : file.messages) EXPECT_EQ(message.place.chunk, 0u);
  EXPECT_GT(read_recording(path).frames.size(), 0u);
}

}  // namespace
}  // namespace thigma
