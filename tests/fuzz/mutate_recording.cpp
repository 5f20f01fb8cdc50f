// MCAP: the records are taken out of their chunks, one is changed, and chunks are put together
// again with right lengths and checksums, compressed or not, without the summary, which the format
// does not ask for.

#include "fuzz/fuzz_target.h"

#include "thigma/files/checksum.h"
#include "thigma/files/compression.h"
#include "thigma/math/random.h"
#include "thigma/recording/detail/mcap_records.h"

namespace thigma::fuzz {
namespace {

constexpr std::size_t kHead = 9, kMessageHead = 22;
// Of a chunk: times, size, checksum; then the name of the compression and the stored size.
constexpr std::size_t kSizeAt = 16, kNameAt = 28, kChunkHead = 40;
constexpr std::uint64_t kMostExpanded = std::uint64_t{1} << 20;

struct Record {
  std::uint8_t opcode = 0;
  std::string body;
};

std::uint64_t number_at(std::string_view bytes, std::size_t at) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i)
    value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes[at + i])) << (8 * i);
  return value;
}

void put(std::string& out, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

void put_record(std::string& out, const Record& record) {
  out += static_cast<char>(record.opcode);
  put(out, record.body.size(), 8);
  out += record.body;
}

/// Records as far as they are whole.
std::vector<Record> records_of(std::string_view bytes) {
  std::vector<Record> records;
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

/// What a chunk holds, as far as it can be told.
std::string content_of(std::string_view chunk) {
  if (chunk.size() < kChunkHead) return {};
  const std::string_view stored = chunk.substr(kChunkHead);
  if (chunk[kNameAt] == 0) return std::string(stored);
  const std::size_t name = thigma::detail::kZstd.size();
  const std::uint64_t size = number_at(chunk, kSizeAt);
  if (stored.size() < name || size > kMostExpanded) return {};
  return expand(stored.substr(name), size).value_or("");
}

std::string chunk_of(const std::vector<Record>& records, bool is_compressed) {
  std::string content;
  for (const Record& record : records) put_record(content, record);
  const std::string shorter = is_compressed ? compress(content) : std::string();
  std::string body;
  put(body, 0, 8);
  put(body, 0, 8);
  put(body, content.size(), 8);
  put(body, crc32(content), 4);
  const std::string_view name = shorter.empty() ? std::string_view() : thigma::detail::kZstd;
  put(body, name.size(), 4);
  body += name;
  put(body, shorter.empty() ? content.size() : shorter.size(), 8);
  return body + (shorter.empty() ? content : shorter);
}

void change(std::string& bytes, std::size_t from, std::size_t most, Mutate mutate) {
  std::string part = bytes.substr(from);
  const std::size_t size = part.size();
  part.resize(std::max(size, most));
  part.resize(mutate(reinterpret_cast<std::uint8_t*>(part.data()), size, part.size()));
  bytes.resize(from);
  bytes += part;
}

void change_records(std::vector<Record>& records, Random& random, Mutate mutate) {
  const std::size_t i = random.below(records.size());
  const std::size_t j = random.below(records.size());
  switch (random.below(12)) {
    case 0:
      records.erase(records.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    case 1:
      records.insert(records.begin() + static_cast<std::ptrdiff_t>(i), Record(records[j]));
      return;
    case 2:
      std::swap(records[i], records[j]);
      return;
    default:
      break;
  }
  Record& record = records[i];
  const bool is_data = record.opcode == thigma::detail::kMessage && random.below(8) != 0;
  const std::size_t from = is_data && record.body.size() > kMessageHead ? kMessageHead : 0;
  change(record.body, from, record.body.size() - from + 64, mutate);
}

}  // namespace

void mutate_recording(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate) {
  using namespace thigma::detail;
  Random random(seed);
  const bool is_file = bytes.starts_with(kMcapMagic);
  if (!is_file || random.below(16) == 0) return change(bytes, 0, most, mutate);
  std::vector<Record> outer = records_of(std::string_view(bytes).substr(kMcapMagic.size()));
  std::vector<Record> inner;
  std::string made(kMcapMagic);
  for (const Record& record : outer) {
    if (record.opcode == kHeader) put_record(made, record);
    if (record.opcode != kChunk) continue;
    for (Record& r : records_of(content_of(record.body))) inner.push_back(std::move(r));
  }
  if (inner.empty()) return change(bytes, 0, most, mutate);
  change_records(inner, random, mutate);
  const std::size_t cut = random.below(inner.size() + 1);  // two chunks
  const auto middle = inner.begin() + static_cast<std::ptrdiff_t>(cut);
  put_record(made, {kChunk, chunk_of({inner.begin(), middle}, random.below(4) == 0)});
  put_record(made, {kChunk, chunk_of({middle, inner.end()}, random.below(4) == 0)});
  if (random.below(4) != 0) {  // whole
    put_record(made, {kDataEnd, std::string(4, '\0')});
    put_record(made, {kFooter, std::string(20, '\0')});
    made += kMcapMagic;
  }
  if (made.size() <= most) bytes = std::move(made);
}

}  // namespace thigma::fuzz
