#include "thigma/texture/height_image.h"

#include <algorithm>
#include <charconv>

#include "thigma/core/error.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

struct PgmReader {
  std::string_view bytes;
  const std::string& name;
  std::size_t at = 2;  // behind the magic

  [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
    throw InputError(name + ": " + what + ", byte " + std::to_string(at) + ", expected " +
                     expected);
  }

  /// The next number; comments run from # to the end of their line.
  int number(const char* of, int low, int high) {
    for (;;) {
      at = bytes.find_first_not_of(kBlanks, at);
      if (at == std::string_view::npos) {
        at = bytes.size();
        fail("is cut off", of);
      }
      if (bytes[at] != '#') break;
      at = std::min(bytes.find_first_of("\r\n", at), bytes.size());
    }
    int value = 0;
    const char* const first = bytes.data() + at;
    const auto [end, error] = std::from_chars(first, bytes.data() + bytes.size(), value);
    if (error != std::errc() || value < low || value > high)
      fail(std::string("no ") + of,
           "a number of " + std::to_string(low) + " to " + std::to_string(high));
    at += static_cast<std::size_t>(end - first);
    return value;
  }
};

void read_raw(PgmReader& pgm, int most, HeightImage& image) {
  if (pgm.at >= pgm.bytes.size() || kBlanks.find(pgm.bytes[pgm.at]) == kBlanks.npos)
    pgm.fail("no blank behind the header", "one");
  ++pgm.at;
  const std::size_t each = most > 255 ? 2 : 1, count = static_cast<std::size_t>(image.width) *
                                                       static_cast<std::size_t>(image.height);
  if (pgm.bytes.size() - pgm.at < each * count)
    pgm.fail("is cut off", std::to_string(each * count) + " bytes of greys");
  const auto byte = [&](std::size_t i) {
    return static_cast<int>(static_cast<unsigned char>(pgm.bytes[i]));
  };
  for (std::size_t i = 0; i < count; ++i, pgm.at += each) {
    const int grey = each == 1 ? byte(pgm.at) : 256 * byte(pgm.at) + byte(pgm.at + 1);
    if (grey > most)
      pgm.fail("a grey of " + std::to_string(grey), "at most " + std::to_string(most));
    image.values.push_back(static_cast<float>(grey) / static_cast<float>(most));
  }
}

}  // namespace

HeightImage parse_pgm(std::string_view bytes, const std::string& name) {
  PgmReader pgm{bytes, name};
  if (!is_pgm(bytes)) {
    pgm.at = 0;
    pgm.fail("is no PGM", "P2 or P5");
  }
  HeightImage image;
  image.width = pgm.number("width", 1, kMaxTextureSide);
  image.height = pgm.number("height", 1, kMaxTextureSide);
  const int most = pgm.number("largest grey", 1, 65535);
  const std::size_t count =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  // Every grey takes a byte at least: nothing is reserved for what cannot be there.
  if (count > static_cast<std::size_t>(kMaxTexels) || count > bytes.size())
    pgm.fail("claims " + std::to_string(count) + " greys", "no more than there are bytes");
  image.values.reserve(count);
  if (bytes[1] == '5') {
    read_raw(pgm, most, image);
    return image;
  }
  for (std::size_t i = 0; i < count; ++i)
    image.values.push_back(static_cast<float>(pgm.number("grey", 0, most)) /
                           static_cast<float>(most));
  return image;
}

bool is_pgm(std::string_view bytes) {
  return bytes.size() > 2 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5') &&
         (kBlanks.find(bytes[2]) != kBlanks.npos || bytes[2] == '#');
}

}  // namespace thigma
