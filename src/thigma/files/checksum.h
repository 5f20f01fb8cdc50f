#pragma once
// Checksums: one for damage, one for identity.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace thigma {

/// CRC-32 (IEEE 802.3, reflected) of bytes; pass a previous result to continue. Thread [offline].
std::uint32_t crc32(std::string_view bytes, std::uint32_t previous = 0);

using Sha256 = std::array<std::uint8_t, 32>;

/// SHA-256 of bytes.
/// Thread [offline]; no failure.
/// Source FIPS 180-4.
Sha256 sha256(std::string_view bytes);

/// 64 hexadecimal digits, lower case.
std::string hex_text(const Sha256& digest);

}  // namespace thigma
