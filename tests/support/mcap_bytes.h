#pragma once
// MCAP files taken apart and put together again, record by record: for tests that change what is in
// them. What is put together has no summary, which the format does not ask for.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/files/checksum.h"
#include "thigma/files/compression.h"
#include "thigma/recording/detail/mcap_records.h"

namespace thigma::test {

struct McapRecord {
  std::uint8_t opcode = 0;
  std::string body;
};

inline std::uint64_t number_at(std::string_view bytes, std::size_t at, int count = 8) {
  std::uint64_t value = 0;
  for (int i = count; i-- > 0;)
    value = value << 8 | static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

inline void put_number(std::string& out, std::uint64_t value, int count) {
  for (int i = 0; i < count; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

inline void put_record(std::string& out, const McapRecord& record) {
  out += static_cast<char>(record.opcode);
  put_number(out, record.body.size(), 8);
  out += record.body;
}

/// Records as far as they are whole, from behind the magic bytes or the head of a chunk on.
inline std::vector<McapRecord> records_of(std::string_view bytes) {
  constexpr std::size_t kHead = 9;
  std::vector<McapRecord> records;
  while (bytes.size() >= kHead) {
    const std::uint64_t length = number_at(bytes, 1);
    if (length > bytes.size() - kHead) break;
    const auto size = static_cast<std::size_t>(length);
    records.push_back(
        {static_cast<std::uint8_t>(bytes[0]), std::string(bytes.substr(kHead, size))});
    bytes.remove_prefix(kHead + size);
  }
  return records;
}

/// What a chunk holds, as far as it can be told; "" of one that says it is longer than `most`.
inline std::string content_of_chunk(std::string_view chunk, std::uint64_t most) {
  // Times, size, checksum; then the name of the compression and the stored size.
  constexpr std::size_t kSizeAt = 16, kNameAt = 28, kHead = 40;
  if (chunk.size() < kHead) return {};
  const std::string_view stored = chunk.substr(kHead);
  if (chunk[kNameAt] == 0) return std::string(stored);
  const std::size_t name = detail::kZstd.size();
  const std::uint64_t size = number_at(chunk, kSizeAt);
  if (stored.size() < name || size > most) return {};
  return expand(stored.substr(name), size).value_or("");
}

/// The body of a chunk that holds this, with a right checksum and no times.
inline std::string chunk_of(const std::string& content, bool is_compressed) {
  const std::string shorter = is_compressed ? compress(content) : std::string();
  const std::string& stored = shorter.empty() ? content : shorter;
  const std::string_view name = shorter.empty() ? std::string_view() : detail::kZstd;
  std::string body;
  put_number(body, 0, 8);
  put_number(body, 0, 8);
  put_number(body, content.size(), 8);
  put_number(body, crc32(content), 4);
  put_number(body, name.size(), 4);
  body += name;
  put_number(body, stored.size(), 8);
  return body + stored;
}

inline void put_mcap_end(std::string& out) {
  put_record(out, {detail::kDataEnd, std::string(4, '\0')});
  put_record(out, {detail::kFooter, std::string(20, '\0')});
  out += detail::kMcapMagic;
}

/// A recording as it would be without compression: its text can be found and changed.
inline std::string expanded_recording(std::string_view bytes) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 28;  // of a chunk [byte]
  std::string out(detail::kMcapMagic);
  for (const McapRecord& record : records_of(bytes.substr(detail::kMcapMagic.size()))) {
    if (record.opcode == detail::kDataEnd) break;
    if (record.opcode == detail::kHeader || record.opcode == detail::kAttachment)
      put_record(out, record);
    if (record.opcode == detail::kChunk)
      put_record(out, {detail::kChunk, chunk_of(content_of_chunk(record.body, kMost), false)});
  }
  put_mcap_end(out);
  return out;
}

}  // namespace thigma::test
