#include <string>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/byte_source.h"
#include "thigma/files/file.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

std::string file_with(const std::vector<McapAttachment>& attachments) {
  const std::string path = ::testing::TempDir() + "attachments.mcap";
  McapWriter writer(path);
  const std::uint16_t channel = writer.add_channel("/a", "A", "");
  for (const McapAttachment& attachment : attachments) writer.attach(attachment);
  writer.write(channel, 0, 1, "{}");
  writer.close();
  return read_file(path);
}

std::vector<McapAttachment> attachments_in(const std::string& bytes) {
  MemorySource source(bytes);
  return read_attachments(source, "F");
}

TEST(McapAttachments, ComeBackWithNameTypeAndBytes) {
  const std::string binary("\0\x01\xff\x0f", 4);
  const std::string bytes =
      file_with({{"scene.toml", "application/toml", "title = 1"}, {"assets/m", "", binary}});
  const std::vector<McapAttachment> found = attachments_in(bytes);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "scene.toml");
  EXPECT_EQ(found[0].media_type, "application/toml");
  EXPECT_EQ(found[1].data, binary);
  EXPECT_EQ(parse_mcap(bytes, "F").messages.size(), 1u) << "messages are read as before";
}

TEST(McapAttachments, OfAFileCutOffThoseThatAreWhole) {
  const std::string bytes = file_with({{"a", "", std::string(100, 'x')}, {"b", "", "y"}});
  std::size_t most = 0;
  for (std::size_t size = 8; size <= bytes.size(); ++size) {
    const std::size_t now = attachments_in(bytes.substr(0, size)).size();
    EXPECT_GE(now, most);
    most = now;
  }
  EXPECT_EQ(most, 2u);
  EXPECT_EQ(parse_mcap(bytes.substr(0, bytes.size() - 3), "F").messages.size(), 1u)
      << "what is cut off is read over its attachments";
}

TEST(McapAttachments, LyingLengthsAreRefused) {
  const std::string bytes = file_with({{"name", "type", "data"}});
  const std::size_t begin = bytes.find("name") - 4;  // its length
  for (const std::size_t at : {begin, begin + 8, begin + 16}) {
    for (const char lie : {'\x7f', '\x05', '\0'}) {
      std::string damaged = bytes;
      if (damaged[at] == lie) continue;
      damaged[at] = lie;
      EXPECT_THROW(attachments_in(damaged), InputError) << at << " " << static_cast<int>(lie);
    }
  }
  EXPECT_THROW(attachments_in("not MCAP at all"), InputError);
}

}  // namespace
}  // namespace thigma
