#include "thigma/files/byte_source.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

std::string scratch(const std::string& name) { return ::testing::TempDir() + "thigma_" + name; }

TEST(FileSource, gives_every_stretch_with_little_memory) {
  const std::string path = scratch("source.bin");
  std::string all;
  for (int i = 0; i < 10000; ++i) all += static_cast<char>(i * 31 + i / 256);
  std::ofstream(path, std::ios::binary).write(all.data(), static_cast<std::streamsize>(all.size()));
  FileSource source(path, 64, 1000);
  ASSERT_EQ(source.size(), all.size());
  std::uint64_t at = 1;
  for (int i = 0; i < 5000; ++i) {
    at = (at * 7919 + 13) % all.size();
    const std::uint64_t count = std::min<std::uint64_t>(at % 300, all.size() - at);
    ASSERT_EQ(source.view(at, count), std::string_view(all).substr(at, count)) << at;
  }
  EXPECT_EQ(source.view(all.size(), 0), "");
  EXPECT_LE(source.memory(), 1000u);
  EXPECT_THROW(source.view(0, 1001), InputError);
}

TEST(FileSource, reaches_beyond_what_32_bits_count) {
  const std::string path = scratch("source_far.bin");
  std::ofstream(path, std::ios::binary) << "begin";
  const std::uint64_t far = (std::uint64_t{1} << 32) + 12345;
  std::filesystem::resize_file(path, far);  // a hole, where the file system has them
  std::ofstream(path, std::ios::binary | std::ios::app) << "end";
  FileSource source(path);
  ASSERT_EQ(source.size(), far + 3);
  EXPECT_EQ(source.view(0, 5), "begin");
  EXPECT_EQ(source.view(far, 3), "end");
  std::filesystem::remove(path);
}

TEST(FileSource, says_that_a_file_has_become_shorter) {
  const std::string path = scratch("source_short.bin");
  std::ofstream(path, std::ios::binary) << std::string(1000, 'x');
  FileSource source(path, 16);
  EXPECT_EQ(source.view(0, 3), "xxx");
  std::filesystem::resize_file(path, 500);
  EXPECT_THROW(source.view(800, 10), InputError);
  EXPECT_THROW(FileSource(path + ".absent"), InputError);
  EXPECT_THROW(FileSource(::testing::TempDir()), InputError);
}

}  // namespace
}  // namespace thigma
