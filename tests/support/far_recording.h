#pragma once
// Recordings that are longer than 4 GiB and take no room: a hole in the middle, where the file
// system has them.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "thigma/files/checksum.h"
#include "thigma/files/file.h"

namespace thigma::test {

/// Puts a record of a kind that readers skip, `hole` bytes long, before all others of a whole
/// recording. The summary says where it is, and its checksum is right.
inline void push_away(const std::string& path, std::uint64_t hole) {
  constexpr std::size_t kMagic = 8, kEnd = 8 + 29, kKind = 0x80;
  const auto put = [](std::string& bytes, std::size_t at, std::uint64_t value, int count) {
    for (int i = 0; i < count; ++i)
      bytes[at + static_cast<std::size_t>(i)] = static_cast<char>(value >> (8 * i) & 0xff);
  };
  std::string bytes = read_file(path);
  const std::size_t start_at = bytes.size() - kEnd + 9, crc_at = start_at + 16;
  std::uint64_t start = 0;
  for (int i = 7; i >= 0; --i)
    start = start << 8 | static_cast<std::uint8_t>(bytes[start_at + static_cast<std::size_t>(i)]);
  put(bytes, start_at, start + 9 + hole, 8);
  const std::string_view summary = std::string_view(bytes).substr(static_cast<std::size_t>(start));
  put(bytes, crc_at, crc32(summary.substr(0, crc_at - static_cast<std::size_t>(start))), 4);
  std::string head(9, '\0');
  head[0] = static_cast<char>(kKind);
  put(head, 1, hole, 8);
  std::ofstream(path, std::ios::binary) << bytes.substr(0, kMagic) << head;
  std::filesystem::resize_file(path, kMagic + head.size() + hole);
  std::ofstream(path, std::ios::binary | std::ios::app) << bytes.substr(kMagic);
}

}  // namespace thigma::test
