// MCAP: the records are taken out of their chunks, one is changed, and chunks are put together
// again with right lengths and checksums, compressed or not, without the summary, which the format
// does not ask for.

#include <cstring>

#include "fuzz/fuzz_target.h"
#include "support/mcap_bytes.h"

#include "thigma/math/random.h"
#include "thigma/recording/detail/mcap_records.h"

namespace thigma::fuzz {
namespace {

using test::McapRecord;
using test::records_of;

constexpr std::size_t kMessageHead = 22;
constexpr std::uint64_t kMostExpanded = std::uint64_t{1} << 20;  // of a chunk [byte]

using Place = std::vector<McapRecord>::const_iterator;

std::string chunk_of(Place begin, Place end, bool is_compressed) {
  std::string content;
  for (Place record = begin; record != end; ++record) test::put_record(content, *record);
  return test::chunk_of(content, is_compressed);
}

void change(std::string& bytes, std::size_t from, std::size_t most, Mutate mutate) {
  std::string part = bytes.substr(from);
  const std::size_t size = part.size();
  part.resize(std::max(size, most));
  part.resize(mutate(reinterpret_cast<std::uint8_t*>(part.data()), size, part.size()));
  bytes.resize(from);
  bytes += part;
}

/// Another number in the place of one of a text: any change to its bytes rarely leaves one.
void change_number(std::string& text, Random& random) {
  constexpr const char* kNumbers[] = {"0",      "-1",   "1",          "2",
                                      "3.5",    "-0.0", "1e308",      "-1e300",
                                      "1e-320", "null", "4294967296", "18446744073709551615"};
  constexpr const char* kDigits = "-0123456789";
  if (text.size() <= kMessageHead) return;
  std::size_t at =
      text.find_first_of(kDigits, kMessageHead + random.below(text.size() - kMessageHead));
  if (at == std::string::npos) return;
  while (at > kMessageHead && std::strchr("-+.eE0123456789", text[at - 1]) != nullptr) --at;
  const std::size_t end = text.find_first_not_of("-+.eE0123456789", at);
  text.replace(at, std::min(end, text.size()) - at, kNumbers[random.below(std::size(kNumbers))]);
}

void change_records(std::vector<McapRecord>& records, Random& random, Mutate mutate) {
  const std::size_t i = random.below(records.size());
  const std::size_t j = random.below(records.size());
  switch (random.below(12)) {
    case 0:
      records.erase(records.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    case 1:
      records.insert(records.begin() + static_cast<std::ptrdiff_t>(i), McapRecord(records[j]));
      return;
    case 2:
      std::swap(records[i], records[j]);
      return;
    case 3:
    case 4:
    case 5:
    case 6:
      return change_number(records[i].body, random);
    default:
      break;
  }
  McapRecord& record = records[i];
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
  std::vector<McapRecord> inner;
  std::string made(kMcapMagic);
  for (const McapRecord& record : records_of(std::string_view(bytes).substr(kMcapMagic.size()))) {
    if (record.opcode == kHeader) test::put_record(made, record);
    if (record.opcode != kChunk) continue;
    for (McapRecord& r : records_of(test::content_of_chunk(record.body, kMostExpanded)))
      inner.push_back(std::move(r));
  }
  if (inner.empty()) return change(bytes, 0, most, mutate);
  change_records(inner, random, mutate);
  const std::size_t cut = random.below(inner.size() + 1);  // two chunks
  const Place middle = inner.cbegin() + static_cast<std::ptrdiff_t>(cut);
  test::put_record(made, {kChunk, chunk_of(inner.cbegin(), middle, random.below(4) == 0)});
  test::put_record(made, {kChunk, chunk_of(middle, inner.cend(), random.below(4) == 0)});
  if (random.below(4) != 0) test::put_mcap_end(made);  // whole
  if (made.size() <= most) bytes = std::move(made);
}

}  // namespace thigma::fuzz
