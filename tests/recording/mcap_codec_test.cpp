#include "thigma/recording/detail/mcap_codec.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/math/random.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

std::string scratch(const std::string& name) { return ::testing::TempDir() + "thigma_" + name; }

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

class Codec : public ::testing::Test {
  void SetUp() override {
    if (!detail::has_zstd()) GTEST_SKIP() << "this build has no zstd";
  }
};

TEST_F(Codec, GivesBackWhatItTook) {
  const std::string bytes = lines(5000);
  const std::string stored = detail::compress_chunk(bytes);
  EXPECT_LT(stored.size(), bytes.size() / 4);
  EXPECT_EQ(detail::expand_chunk(stored, bytes.size()), bytes);
  EXPECT_EQ(detail::compress_chunk(bytes), stored);
}

TEST_F(Codec, LeavesAloneWhatGetsNoShorter) {
  EXPECT_EQ(detail::compress_chunk(noise(1000)), "");
  EXPECT_EQ(detail::compress_chunk(""), "");
}

TEST_F(Codec, RefusesAnotherSizeAndWhatIsCutOff) {
  const std::string bytes = lines(200);
  const std::string stored = detail::compress_chunk(bytes);
  EXPECT_FALSE(detail::expand_chunk(stored, bytes.size() - 1));
  EXPECT_FALSE(detail::expand_chunk(stored, bytes.size() + 1));
  // before there is memory for it
  EXPECT_FALSE(detail::expand_chunk(stored, std::uint64_t{1} << 60));
  for (std::size_t size = 0; size < stored.size(); ++size)
    EXPECT_FALSE(detail::expand_chunk(std::string_view(stored).substr(0, size), bytes.size()));
  EXPECT_FALSE(detail::expand_chunk(noise(100), 100));
}

TEST_F(Codec, FlippedBitsNeverGiveMoreThanWasAskedFor) {
  const std::string bytes = lines(50);
  const std::string stored = detail::compress_chunk(bytes);
  for (std::size_t at = 0; at < stored.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = stored;
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
      const auto back = detail::expand_chunk(damaged, bytes.size());
      EXPECT_TRUE(!back || back->size() == bytes.size());
    }
  }
}

TEST_F(Codec, FilesAreAFractionOfWhatTheyHold) {
  const std::string path = compressed_file("codec_short.mcap");
  const McapFile file = read_mcap(path);
  ASSERT_EQ(file.messages.size(), 1000u);
  EXPECT_EQ(file.messages[999].data, "{\"v\":999}");
  EXPECT_NE(file.messages[999].place.chunk, 0u);
  std::size_t held = 0;
  for (const McapMessage& message : file.messages) held += message.data.size() + 31;
  // the index of 16 bytes a message is not compressed
  EXPECT_LT(file.bytes.size(), 16u * 1000u + held / 4);
}

TEST_F(Codec, MessagesAreFoundAgainByTheirPlacesInAnyOrder) {
  const std::string path = scratch("codec_places.mcap");
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

TEST_F(Codec, ChunksOfOtherKindsAndOfNoSizeAreRefusedWithTheReason) {
  const std::string bytes = read_file(compressed_file("codec_lies.mcap"));
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
