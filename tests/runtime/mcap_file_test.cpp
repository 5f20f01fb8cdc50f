#include "thigma/runtime/mcap_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "thigma/core/error.h"

namespace thigma {
namespace {

std::filesystem::path scratch(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / ("thigma_" + name);
}

/// Two channels, enough messages for several chunks.
std::filesystem::path write_sample(const std::string& name, int count) {
  const auto path = scratch(name);
  McapWriter writer(path.string());
  const auto a = writer.add_channel("/a", "A", "");
  const auto b = writer.add_channel("/b", "B", R"({"type":"object","properties":{"v":{"type":"number"}}})");
  for (int i = 0; i < count; ++i) {
    const std::string json = "{\"v\":" + std::to_string(i) + ",\"pad\":\"" + std::string(200, 'x') + "\"}";
    writer.write(i % 3 == 0 ? b : a, static_cast<std::uint32_t>(i), static_cast<std::uint64_t>(i) * 1000000u, json);
  }
  writer.close();
  return path;
}

void put(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST(McapFile, what_was_written_is_read) {
  const auto path = write_sample("roundtrip.mcap", 20000);
  const McapFile file = read_mcap(path.string());
  ASSERT_EQ(file.messages.size(), 20000u);
  EXPECT_TRUE(file.warnings.empty());
  for (std::size_t i = 0; i < file.messages.size(); ++i) {
    const McapMessage& m = file.messages[i];
    ASSERT_EQ(m.sequence, i);
    ASSERT_EQ(m.time, i * 1000000u);
    ASSERT_EQ(file.topics[static_cast<std::size_t>(m.channel)], i % 3 == 0 ? "/b" : "/a");
    ASSERT_EQ(m.data.substr(0, 5), "{\"v\":");
  }
}

TEST(McapFile, unfinished_file_is_not_left_behind) {
  const auto path = scratch("unfinished.mcap");
  {
    McapWriter writer(path.string());
    writer.add_channel("/a", "A", "");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST(McapFile, only_a_regular_file_is_replaced) {
  EXPECT_THROW(McapWriter("/dev/null"), IoError);
  EXPECT_THROW(McapWriter(std::filesystem::temp_directory_path().string()), IoError);
}

TEST(McapFile, every_truncation_is_refused) {
  const McapFile whole = read_mcap(write_sample("whole.mcap", 50).string());
  const auto path = scratch("cut.mcap");
  const std::size_t data_end = static_cast<std::size_t>(whole.messages.back().offset) + 30;
  for (std::size_t size = 0; size < whole.bytes.size(); size += size < data_end ? 97 : 1) {
    put(path, whole.bytes.substr(0, size));
    EXPECT_THROW(read_mcap(path.string()), InputError) << size;
  }
}

TEST(McapFile, flipped_bits_are_refused_or_said) {
  const McapFile whole = read_mcap(write_sample("whole2.mcap", 20).string());
  const auto path = scratch("flipped.mcap");
  // Everything from the first message on is covered by the chunk's checksum.
  const std::size_t begin = static_cast<std::size_t>(whole.messages.front().offset);
  const std::size_t end = static_cast<std::size_t>(whole.messages.back().offset);
  for (std::size_t at = begin; at < end; at += 13) {
    std::string bytes = whole.bytes;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    put(path, bytes);
    try {
      EXPECT_FALSE(read_mcap(path.string()).warnings.empty()) << at;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("byte"), std::string::npos);
    }
  }
}

TEST(McapFile, opens_in_the_official_reader) {
  const std::filesystem::path reader = std::filesystem::path(THIGMA_SOURCE_DIR) / "tests/mcap_reader";
  if (!std::filesystem::exists(reader / "node_modules/@mcap/core")) {
    GTEST_SKIP() << "needs `npm ci` in tests/mcap_reader (scripts/test does it where npm reaches a registry)";
  }
  const auto path = write_sample("official.mcap", 20000);
  const std::string out = scratch("official.json").string();
  const std::string command = "node '" + (reader / "read.mjs").string() + "' '" + path.string() + "' > '" + out + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(out);
  const std::string line((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  EXPECT_NE(line.find("\"messages\":20000"), std::string::npos) << line.substr(0, 200);
  EXPECT_NE(line.find("\"/b\":6667"), std::string::npos) << line.substr(0, 200);
}

}  // namespace
}  // namespace thigma
