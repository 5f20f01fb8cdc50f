#include "thigma/texture/height_image.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

std::string complaint(std::string_view bytes) {
  try {
    parse_pgm(bytes, "a.pgm");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(HeightImage, ReadsPlainAndRaw) {
  const HeightImage plain = parse_pgm("P2\n# a comment\n3 2\n100\n0 50 100\n25 75 10\n", "a");
  EXPECT_EQ(plain.width, 3);
  EXPECT_EQ(plain.height, 2);
  EXPECT_EQ(plain.values, (std::vector<float>{0.0f, 0.5f, 1.0f, 0.25f, 0.75f, 0.1f}));
  const HeightImage raw = parse_pgm(std::string_view("P5 2 1 255\n\x00\xff", 13), "a");
  EXPECT_EQ(raw.values, (std::vector<float>{0.0f, 1.0f}));
  // Two bytes a grey, the larger one first; a grey may look like a blank.
  const HeightImage deep = parse_pgm(std::string_view("P5 2 1 65535\n\x0a\x00\x00\x01", 17), "a");
  EXPECT_EQ(deep.values, (std::vector<float>{2560.0f / 65535.0f, 1.0f / 65535.0f}));
}

TEST(HeightImage, RefusesWhatIsCutOffWrongOrLying) {
  const std::string whole = "P5 4 3 255\n0123456789ab";
  EXPECT_EQ(complaint(whole), "");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(complaint(std::string_view(whole).substr(0, size)), "") << size;
  for (const char* wrong :
       {"", "P6 1 1 255\nabc", "P5 0 1 255\na", "P5 1 -1 255\na", "P5 16385 1 255\na",
        "P5 1 1 0\na", "P5 1 1 70000\nab", "P5 1 1 255a", "P5 1 1 64\na", "P2 2 1 9 3",
        "P2 1 1 9 x", "P2 1 1 9 10", "P2 1 1 9 -1", "P2 99999999999999 1 9 1",
        "P5 16384 16384 255\nabc", "P5 4000 4000 255\nabc"})
    EXPECT_NE(complaint(wrong), "") << wrong;
  EXPECT_EQ(complaint("P5 1 1 64\na"), "a.pgm: a grey of 97, byte 10, expected at most 64");
}

}  // namespace
}  // namespace thigma
