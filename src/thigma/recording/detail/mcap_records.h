#pragma once
// What the writer and the reader of MCAP files share: magic bytes and record kinds of the public
// specification.

#include <cstdint>
#include <string_view>

namespace thigma::detail {

inline constexpr std::string_view kMcapMagic("\x89MCAP0\r\n", 8);

inline constexpr std::string_view kZstd = "zstd";  // the name of a compression

// Zero is none: a hole that a power cut leaves is not taken for empty records.
enum McapOpcode : std::uint8_t {
  kNoRecord = 0x00,
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0a,
  kStatistics = 0x0b,
  kDataEnd = 0x0f
};

/// Footer and magic: the last bytes of every whole file.
inline constexpr std::size_t kFooterBytes = 9 + 20;

}  // namespace thigma::detail
