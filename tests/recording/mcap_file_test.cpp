#include "thigma/recording/mcap_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

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
  const auto b =
      writer.add_channel("/b", "B", R"({"type":"object","properties":{"v":{"type":"number"}}})");
  for (int i = 0; i < count; ++i) {
    const std::string json =
        "{\"v\":" + std::to_string(i) + ",\"pad\":\"" + std::string(200, 'x') + "\"}";
    writer.write(i % 3 == 0 ? b : a, static_cast<std::uint32_t>(i),
                 static_cast<std::uint64_t>(i) * 1000000u, json);
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

TEST(McapFile, is_flushed_every_half_second_of_its_messages) {
  const auto path = scratch("flushed.mcap");
  McapWriter writer(path.string());
  const auto channel = writer.add_channel("/a", "A", "");
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const std::uint64_t time = i * 1'000'000;
    writer.write(channel, static_cast<std::uint32_t>(i), time, "{}");
    if (i % 100 != 0) continue;
    const McapFile part = read_mcap(path.string() + ".part");
    const std::uint64_t flushed = part.messages.empty() ? 0 : part.messages.back().time;
    EXPECT_LE(time - flushed, 501'000'000u);
    EXPECT_EQ(part.messages.size(), writer.messages());
  }
  writer.close();
  EXPECT_EQ(read_mcap(path.string()).messages.size(), 5000u);
}

TEST(McapFile, closed_early_it_is_whole_without_what_was_not_flushed) {
  const auto path = scratch("early.mcap");
  McapWriter writer(path.string());
  const auto channel = writer.add_channel("/a", "A", "");
  for (std::uint32_t i = 0; i < 10; ++i) writer.write(channel, i, i, "{}");
  writer.flush();
  for (std::uint32_t i = 10; i < 20; ++i) writer.write(channel, i, i, "{}");
  EXPECT_EQ(writer.close_early(), path.string());
  const McapFile file = read_mcap(path.string());
  EXPECT_EQ(file.cut, "");
  EXPECT_EQ(file.messages.size(), 10u);
}

TEST(McapFile, opens_in_the_official_reader) {
  const std::filesystem::path reader =
      std::filesystem::path(THIGMA_SOURCE_DIR) / "tests/mcap_reader";
  if (!std::filesystem::exists(reader / "node_modules/@mcap/core")) {
    GTEST_SKIP() << "needs `npm ci` in tests/mcap_reader (scripts/test does it where npm reaches a "
                    "registry)";
  }
  const auto path = write_sample("official.mcap", 20000);
  const std::string out = scratch("official.json").string();
  const std::string command =
      "node '" + (reader / "read.mjs").string() + "' '" + path.string() + "' > '" + out + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream in(out);
  const std::string line((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  EXPECT_NE(line.find("\"messages\":20000"), std::string::npos) << line.substr(0, 200);
  EXPECT_NE(line.find("\"/b\":6667"), std::string::npos) << line.substr(0, 200);
}

}  // namespace
}  // namespace thigma
