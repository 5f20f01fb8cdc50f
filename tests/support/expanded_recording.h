#pragma once
// A recording whose text can be found and changed: as it would be without compression, and without
// the summary, which the format does not ask for.

#include <cstdint>
#include <string>
#include <string_view>

#include "thigma/files/compression.h"
#include "thigma/recording/detail/mcap_records.h"

namespace thigma::test {

inline std::uint64_t number_of(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

inline void put_number(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

inline void put_record(std::string& out, detail::McapOpcode opcode, std::string_view body) {
  out += static_cast<char>(opcode);
  put_number(out, body.size(), 8);
  out += body;
}

/// The body of a chunk, uncompressed.
inline std::string expanded_chunk(std::string_view body) {
  constexpr std::size_t kBefore = 28;  // times, size, checksum
  const std::size_t name = number_of(body.substr(kBefore, 4));
  const std::string_view stored = body.substr(kBefore + 4 + name + 8);
  const std::string held = name == 0
                               ? std::string(stored)
                               : expand(stored, number_of(body.substr(16, 8))).value_or("");
  std::string out(body.substr(0, kBefore));
  put_number(out, 0, 4);
  put_number(out, held.size(), 8);
  return out + held;
}

inline std::string expanded_recording(std::string_view bytes) {
  std::string out(detail::kMcapMagic);
  for (std::string_view left = bytes.substr(detail::kMcapMagic.size()); left.size() > 9;) {
    const auto opcode = static_cast<detail::McapOpcode>(left[0]);
    const std::string_view body = left.substr(9, number_of(left.substr(1, 8)));
    if (opcode == detail::kDataEnd) break;
    if (opcode == detail::kHeader || opcode == detail::kAttachment) put_record(out, opcode, body);
    if (opcode == detail::kChunk) put_record(out, opcode, expanded_chunk(body));
    left.remove_prefix(9 + body.size());
  }
  put_record(out, detail::kDataEnd, std::string(4, '\0'));
  put_record(out, detail::kFooter, std::string(20, '\0'));
  return out.append(detail::kMcapMagic);
}

}  // namespace thigma::test
