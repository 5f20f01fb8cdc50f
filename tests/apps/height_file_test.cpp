#include "height_file.h"

#include <vector>

#include "support/png_bytes.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"

namespace thigma::app {
namespace {

using test::png_of;

std::string complaint(std::string_view bytes) {
  try {
    parse_height_file(bytes, "a.png");
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("a.png: ", 0), 0u) << error.what();
    return error.what();
  }
  return "";
}

TEST(HeightFile, ReadsGreyPicturesOfAnyDepth) {
  const HeightImage eight = parse_height_file(png_of(3, 2, 8, {0, 255, 51, 102, 153, 204}), "a");
  EXPECT_EQ(eight.width, 3);
  EXPECT_EQ(eight.values, (std::vector<float>{0.0f, 1.0f, 51 / 255.0f, 102 / 255.0f, 153 / 255.0f,
                                              204 / 255.0f}));
  const std::vector<unsigned char> deep = {0x12, 0x34, 0xff, 0xff, 0x00, 0x01, 0x80, 0x00};
  for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7}) {
    const HeightImage image =
        parse_height_file(png_of(2, 2, 16, deep, PNG_COLOR_TYPE_GRAY, interlace), "a");
    EXPECT_EQ(image.values,
              (std::vector<float>{4660 / 65535.0f, 1.0f, 1 / 65535.0f, 32768 / 65535.0f}));
  }
  const HeightImage bits = parse_height_file(png_of(8, 1, 1, {0xa1}), "a");
  EXPECT_EQ(bits.values, (std::vector<float>{1, 0, 1, 0, 0, 0, 0, 1}));
  const HeightImage alpha =
      parse_height_file(png_of(2, 1, 8, {255, 0, 51, 9}, PNG_COLOR_TYPE_GRAY_ALPHA), "a");
  EXPECT_EQ(alpha.values, (std::vector<float>{1.0f, 51 / 255.0f}));
  EXPECT_EQ(parse_height_file("P2 1 1 2\n1\n", "a").values, std::vector<float>{0.5f});
}

TEST(HeightFile, SkipsAByteOrderMarkBeforeAPgm) {
  EXPECT_EQ(parse_height_file("\xEF\xBB\xBFP2 1 1 2\n1\n", "a").values, std::vector<float>{0.5f});
}

TEST(HeightFile, RefusesColourDamageAndLies) {
  EXPECT_NE(complaint(png_of(1, 1, 8, {1, 2, 3}, PNG_COLOR_TYPE_RGB)).find("colour"),
            std::string::npos);
  EXPECT_NE(complaint("GIF89a"), "");
  std::string greedy = png_of(2, 2, 8, {1, 2, 3, 4});
  greedy.replace(33, 8, std::string("\x44\xae\x42\x60zTXt", 8));  // in place of the pixels
  EXPECT_NE(complaint(greedy).find("a piece of 1152270944 bytes"), std::string::npos);
  EXPECT_NE(complaint(""), "");
  std::vector<unsigned char> data(64 * 64);
  Random random(3);
  for (unsigned char& byte : data) byte = static_cast<unsigned char>(random.below(256));
  std::string bytes = png_of(64, 64, 8, data);
  EXPECT_EQ(complaint(bytes), "");
  for (std::size_t size = 0; size < bytes.size(); size += size < 100 ? 1 : 61)
    EXPECT_NE(complaint(std::string_view(bytes).substr(0, size)), "") << size;
  // Every chunk of a PNG has a checksum; what is behind the signature is found.
  for (int i = 0; i < 300; ++i) {
    const std::size_t at = 8 + random.below(bytes.size() - 8);
    const int bit = static_cast<int>(random.below(8));
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
    EXPECT_NE(complaint(bytes), "") << at << ' ' << bit;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
  }
  // A few bytes that claim the largest picture.
  EXPECT_NE(complaint(png_of(16384, 1, 8, std::vector<unsigned char>(16384)).substr(0, 60)), "");
}

}  // namespace
}  // namespace thigma::app
