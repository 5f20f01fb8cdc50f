// PNG: one piece is changed, and the checksums of all are mended. What is compressed is changed as
// it stands.

#include "fuzz/fuzz_target.h"

#include "thigma/files/checksum.h"
#include "thigma/math/random.h"

namespace thigma::fuzz {
namespace {

constexpr std::size_t kMagic = 8, kAround = 12;  // length, kind and checksum of a piece

std::size_t length_at(const std::string& bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

void mend(std::string& bytes) {
  for (std::size_t at = kMagic; at + kAround <= bytes.size();) {
    const std::size_t length = length_at(bytes, at);
    if (length > bytes.size() - at - kAround) return;
    const std::uint32_t crc = crc32(std::string_view(bytes).substr(at + 4, length + 4));
    for (std::size_t i = 0; i < 4; ++i)
      bytes[at + 8 + length + i] = static_cast<char>(crc >> (24 - 8 * i) & 0xff);
    at += kAround + length;
  }
}

}  // namespace

void mutate_png(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate) {
  Random random(seed);
  const std::size_t size = bytes.size();
  bytes.resize(std::max(most, size));
  bytes.resize(mutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
  if (random.below(8) != 0) mend(bytes);
}

}  // namespace thigma::fuzz
