#include "thigma/files/chunk_file.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

constexpr ChunkKind kKind{
    .magic = {"TESTFILE", 8}, .version = 3, .suffix = ".test", .expected = "a test"};

std::string sample(const ChunkKind& kind = kKind) {
  ChunkWriter file(kind, 2, 0);
  file.begin("numbers", true, 2);
  file.out() += "aabbcc";
  file.begin("none", false, 8);
  return file.finish();
}

std::string complaint(const ChunkKind& kind, std::string_view bytes) {
  try {
    read_chunks(kind, bytes, "f");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ChunkFile, GivesBackItsChunks) {
  const std::string bytes = sample();
  const std::vector<Chunk> chunks = read_chunks(kKind, bytes, "f");
  ASSERT_EQ(chunks.size(), 2u);
  EXPECT_EQ(chunks[0].name, "numbers");
  EXPECT_TRUE(chunks[0].is_required);
  EXPECT_EQ(chunks[0].record_count, 3u);
  EXPECT_EQ(chunks[0].bytes, "aabbcc");
  EXPECT_EQ(chunks[1].record_count, 0u);
}

TEST(ChunkFile, TellsKindsAndVersionsApart) {
  ChunkKind other = kKind;
  other.magic = {"OTHERONE", 8};
  EXPECT_EQ(complaint(other, sample()), "f: is no .test file, byte 0, expected a test");
  ChunkKind older = kKind;
  older.version = 2;
  EXPECT_EQ(complaint(older, sample()),
            "f: has version 3, byte 8, expected version 2, or a newer thigma");
}

TEST(ChunkFile, FindsEveryChangedBitAndEveryCut) {
  std::string bytes = sample();
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
      EXPECT_NE(complaint(kKind, bytes), "") << at << ' ' << bit;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
    }
    EXPECT_NE(complaint(kKind, std::string_view(bytes).substr(0, at)), "") << at;
  }
  EXPECT_EQ(complaint(kKind, bytes), "");
  EXPECT_NE(complaint(kKind, bytes + std::string(64, '\0')), "");
}

}  // namespace
}  // namespace thigma
