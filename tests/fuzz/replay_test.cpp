// Every committed input through its target: seeds, and what fuzzing has found.

#include <filesystem>

#include "fuzz/fuzz_target.h"
#include <gtest/gtest.h>

#include "thigma/files/file.h"
#include "thigma/math/random.h"

namespace thigma::fuzz {
namespace {

namespace fs = std::filesystem;

Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

std::vector<fs::path> corpus_of(const std::string& name) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(THIGMA_SOURCE_DIR) / "tests/fuzz/corpus" / name))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class FuzzReplay : public ::testing::TestWithParam<Target> {
 protected:
  void SetUp() override { is_thorough = true; }
};

TEST_P(FuzzReplay, comes_back_from_every_committed_input) {
  const Target& target = GetParam();
  const std::vector<fs::path> files = corpus_of(target.name);
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename().string());
    EXPECT_NO_THROW(target.run(bytes_of(read_file(file.string()))));
  }
}

std::size_t flip(std::uint8_t* bytes, std::size_t size, std::size_t) {
  static Random random(7);
  if (size > 0) bytes[random.below(size)] ^= static_cast<std::uint8_t>(1 + random.below(255));
  return size;
}

TEST_P(FuzzReplay, comes_back_from_committed_inputs_with_a_changed_byte) {
  const Target& target = GetParam();
  std::uint32_t seed = 0;
  for (const fs::path& file : corpus_of(target.name)) {
    const std::string whole = read_file(file.string());
    for (int i = 0; i < 40; ++i) {
      std::string bytes = whole;
      if (target.mutate != nullptr) {
        target.mutate(bytes, bytes.size() + 1024, ++seed, flip);
      } else {
        flip(reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size(), bytes.size());
      }
      ASSERT_NO_THROW(target.run(bytes_of(bytes))) << file << ' ' << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzReplay, ::testing::ValuesIn(targets()),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace thigma::fuzz
