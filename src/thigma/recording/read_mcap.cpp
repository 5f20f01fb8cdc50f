#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/files/compression.h"
#include "thigma/files/file.h"
#include "thigma/recording/detail/mcap_records.h"
#include "thigma/recording/mcap_file.h"

// A file with its end is whole, and whatever is wrong in it is damage. One without is what a kill,
// a power cut or a full disk left: chunks carry their own checksums, so it is read from the front
// up to the first that is not whole. Nothing longer than a chunk is ever in memory at once.

namespace thigma {
namespace {

using namespace detail;

constexpr std::uint64_t kRecordHead = 9;    // opcode and length
constexpr std::uint64_t kMessageHead = 22;  // of a message record, before its data
constexpr std::uint64_t kMostExpanded = std::uint64_t{1} << 28;  // [byte]

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes[i])) << (8 * i);
  return value;
}

/// Bounds-checked little-endian cursor over a part of the file, or of what a compressed chunk of it
/// holds.
struct Cursor {
  ByteSource& source;
  const std::string& path;
  std::uint64_t at, end;
  std::uint64_t chunk = 0;  // see McapPlace

  [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
    throw InputError(path + ": " + what + ", " + place_text({chunk, at}) + ", expected " +
                     expected);
  }
  /// Of `count` bytes from here on.
  Cursor part(std::uint64_t count) const { return {source, path, at, at + count, chunk}; }
  void skip(std::uint64_t count, const char* what) {
    if (at > end || count > end - at) fail(what, "more bytes: the file is truncated or damaged");
    at += count;
  }
  std::string_view take(std::uint64_t count, const char* what) {
    skip(count, what);
    return source.view(at - count, count);
  }
  template <class T>
  T get(const char* what) {
    return static_cast<T>(little_endian(take(sizeof(T), what)));
  }
  std::string_view text(const char* what) { return take(get<std::uint32_t>(what), what); }
};

/// What stands before the records of a chunk.
struct ChunkHead {
  std::uint64_t size = 0, stored = 0;
  std::uint32_t crc = 0;
  std::string compression;
};

/// Leaves `body` where the stored bytes begin.
ChunkHead read_chunk_head(Cursor& body) {
  ChunkHead head;
  body.skip(16, "chunk");  // first and last time
  head.size = body.get<std::uint64_t>("chunk");
  head.crc = body.get<std::uint32_t>("chunk");
  head.compression = body.text("chunk compression");
  head.stored = body.get<std::uint64_t>("chunk size");
  return head;
}

/// Whether there is a whole head, and the stored bytes are all there is behind it.
std::optional<ChunkHead> find_chunk_head(Cursor& body) {
  try {
    ChunkHead head = read_chunk_head(body);
    if (head.stored == body.end - body.at) return head;
  } catch (const InputError&) {  // it says that it is longer than it is
  }
  return std::nullopt;
}

/// What the compressed chunk holds whose stored bytes begin at `body`; none where it is damaged.
std::optional<std::string> expanded(Cursor& body, const ChunkHead& head) {
  if (head.compression != kZstd || head.size > kMostExpanded) return std::nullopt;
  return expand(body.take(head.stored, "chunk"), head.size);
}

/// A compressed chunk that must expand.
std::string expanded_or_fail(Cursor& body, const ChunkHead& head) {
  if (head.compression != kZstd) body.fail("compression of a chunk", "zstd or none");
  if (!has_zstd()) body.fail("a chunk compressed by zstd", "a build of this program with libzstd");
  if (head.size > kMostExpanded)
    body.fail("a chunk of " + std::to_string(head.size) + " bytes",
              "at most " + std::to_string(kMostExpanded));
  std::optional<std::string> bytes = expanded(body, head);
  if (!bytes)
    body.fail("a chunk that does not expand to what it says it holds",
              "the file as it was written");
  return std::move(*bytes);
}

struct Reading {
  ByteSource& source;
  const std::string& path;
  const McapSink& take;
  McapScan& scan;
  std::map<std::uint16_t, std::int32_t> channels{};
  bool is_enough = false;  // no more messages are wanted

  /// One pass over the records of a whole file, or of a chunk; true when a footer or data end was
  /// met.
  bool records(Cursor cursor, bool in_chunk) {
    while (cursor.at < cursor.end && !is_enough) {
      const std::uint64_t start = cursor.at;
      const auto opcode = cursor.get<std::uint8_t>("record");
      if (opcode == kNoRecord) cursor.fail("a record of no kind", "one of the kinds of MCAP");
      const auto length = cursor.get<std::uint64_t>("record length");
      Cursor body = cursor;
      cursor.skip(length, "record");
      body.end = cursor.at;
      if (opcode == kDataEnd || opcode == kFooter) return true;
      if (opcode == kChannel) channel(body);
      if (opcode == kMessage) message(body, start);
      if (opcode == kChunk) {
        if (in_chunk) body.fail("chunk in a chunk", "no nesting");
        chunk(body, start);
      }
    }
    return false;
  }

  /// The whole records of a file without its end; why it goes no further, and from where, is in
  /// `scan`.
  void prefix(std::uint64_t at) {
    const std::uint64_t size = source.size();
    for (scan.end = at; scan.end < size && !is_enough; scan.end = at) {
      Cursor cursor{source, path, at, size};
      if (size - at < kRecordHead) return stop("the record there is incomplete");
      const auto opcode = cursor.get<std::uint8_t>("record");
      const auto length = cursor.get<std::uint64_t>("record length");
      if (opcode == kDataEnd) return stop("what follows the data is incomplete");
      if (opcode != kHeader && opcode != kChunk && opcode != kMessageIndex && opcode != kAttachment)
        return stop("there is no record of a recording");
      if (length > size - cursor.at) return stop("the record there is incomplete");
      const std::uint64_t start = at;
      at = cursor.at + length;
      if (opcode != kChunk) continue;
      if (!is_right(cursor.part(length)))
        return stop("the chunk there is not what its checksum says");
      chunk(cursor.part(length), start);
    }
    stop("there is no end");
  }

  void stop(const char* why) { scan.cut = why; }

  /// Of a stretch of the file, a window at a time.
  std::uint32_t checksum(std::uint64_t at, std::uint64_t size) {
    constexpr std::uint64_t kWindow = std::uint64_t{1} << 16;
    std::uint32_t crc = 0;
    for (const std::uint64_t end = at + size; at < end;) {
      const std::uint64_t count = std::min(kWindow, end - at);
      crc = crc32(source.view(at, count), crc);
      at += count;
    }
    return crc;
  }

  /// Records between the chunks have no checksum, but the summary says how many messages there are.
  void check_summary() {
    const std::uint64_t footer = source.size() - kMcapMagic.size() - kFooterBytes;
    Cursor end{source, path, footer + kRecordHead, source.size()};
    const auto start = end.get<std::uint64_t>("footer");
    end.get<std::uint64_t>("footer");
    const std::uint64_t crc_at = end.at;
    const auto crc = end.get<std::uint32_t>("footer");
    if (start == 0 && crc == 0) return;  // of another writer, without a summary
    const bool is_placed = start >= kMcapMagic.size() && start <= footer;
    const std::uint64_t at = is_placed ? start : footer;
    if (!is_placed || (crc != 0 && checksum(at, crc_at - at) != crc)) {
      scan.warnings.push_back("the summary from byte " + std::to_string(at) +
                              " on is not what its checksum says");
      return;
    }
    for (Cursor cursor{source, path, at, footer}; cursor.at < footer;) {
      const auto opcode = cursor.get<std::uint8_t>("record");
      const auto length = cursor.get<std::uint64_t>("record length");
      const std::uint64_t begin = cursor.at;
      cursor.skip(length, "record");
      if (opcode != kStatistics) continue;
      const auto messages = Cursor{source, path, begin, cursor.at}.get<std::uint64_t>("statistics");
      if (messages != scan.messages) {
        throw InputError(path + ": " + std::to_string(scan.messages) + " messages, byte " +
                         std::to_string(begin) + ", expected the " + std::to_string(messages) +
                         " that the summary counts: it is damaged");
      }
    }
  }

  /// Whether the lengths and the checksum of a chunk are those of what is in it.
  bool is_right(Cursor body) {
    const std::optional<ChunkHead> head = find_chunk_head(body);
    if (!head) return false;
    const auto is_sum = [&](std::uint32_t crc) { return head->crc == 0 || head->crc == crc; };
    if (head->compression.empty())
      return head->size == head->stored && is_sum(checksum(body.at, head->stored));
    // Whole, but not for this program: said as it is, not as damage.
    if (head->compression == "lz4" || (head->compression == kZstd && !has_zstd()))
      expanded_or_fail(body, *head);
    const std::optional<std::string> bytes = expanded(body, *head);
    return bytes && is_sum(crc32(*bytes));
  }

  void channel(Cursor body) {
    const auto id = body.get<std::uint16_t>("channel");
    body.get<std::uint16_t>("channel schema");
    const std::string topic(body.text("channel topic"));
    if (body.text("message encoding") != "json") body.fail("message encoding", "json");
    if (channels.count(id) != 0) return;
    channels[id] = static_cast<std::int32_t>(scan.topics.size());
    scan.topics.push_back(topic);
  }

  void message(Cursor body, std::uint64_t start) {
    const auto id = body.get<std::uint16_t>("message");
    const auto found = channels.find(id);
    if (found == channels.end())
      body.fail("message of an unknown channel", "its channel record before it");
    McapMessage m;
    m.channel = found->second;
    m.sequence = body.get<std::uint32_t>("message");
    m.time = body.get<std::uint64_t>("message");
    body.get<std::uint64_t>("message");
    m.data = body.take(body.end - body.at, "message");
    m.place = {body.chunk, start};
    ++scan.messages;
    is_enough = !take(scan, m);
  }

  void chunk(Cursor body, std::uint64_t start) {
    const ChunkHead head = read_chunk_head(body);
    if (!head.compression.empty()) {
      const std::string bytes = expanded_or_fail(body, head);
      if (head.crc != 0 && crc32(bytes) != head.crc) warn_of_chunk(start);
      MemorySource expanded(bytes);
      records({expanded, path, 0, bytes.size(), start}, true);
      return;
    }
    const std::uint64_t begin = body.at;
    body.skip(head.stored, "chunk");
    if (head.crc != 0 && checksum(begin, head.stored) != head.crc) warn_of_chunk(begin);
    records({source, path, begin, begin + head.stored}, true);
  }

  void warn_of_chunk(std::uint64_t at) {
    scan.warnings.push_back("the chunk at byte " + std::to_string(at) +
                            " is not what its checksum says");
  }
};

/// Whether the footer and the magic bytes of a whole file are at its end.
bool has_end(ByteSource& source) {
  constexpr std::uint64_t kEnd = kFooterBytes + kMcapMagic.size();
  if (source.size() < kMcapMagic.size() + kEnd) return false;
  const std::string_view end = source.view(source.size() - kEnd, kEnd);
  return static_cast<std::uint8_t>(end.front()) == kFooter && end.ends_with(kMcapMagic);
}

}  // namespace

McapScan scan_mcap(ByteSource& source, const std::string& path, const McapSink& take) {
  McapScan scan;
  scan.size = source.size();
  const std::uint64_t magic = kMcapMagic.size();
  if (scan.size < magic || source.view(0, magic) != kMcapMagic)
    throw InputError(path + ": not an MCAP file, byte 0, expected its magic bytes");
  Reading reading{source, path, take, scan};
  if (!has_end(source)) {
    reading.prefix(magic);
    return scan;
  }
  const bool is_ended = reading.records({source, path, magic, scan.size}, false);
  scan.end = scan.size;
  if (reading.is_enough) return scan;
  if (!is_ended) {
    throw InputError(path + ": no end of the data, byte " + std::to_string(scan.size) +
                     ", expected one before the footer: it is damaged");
  }
  reading.check_summary();
  return scan;
}

void refuse_absent_recording(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown) && std::filesystem::exists(path + ".part", unknown)) {
    throw InputError(path + ": is not there, but what a session that is not over has written is, " +
                     "expected " + path + ".part");
  }
}

std::string place_text(const McapPlace& place) {
  return "byte " + std::to_string(place.at) +
         (place.chunk == 0 ? "" : " of the chunk at byte " + std::to_string(place.chunk));
}

std::string_view McapMessages::data(const McapPlace& place) {
  static const std::string kName = "the recording";
  if (place.chunk != 0 && place.chunk != chunk_at_) {
    chunk_at_ = 0;
    Cursor head{source_, kName, place.chunk + 1, source_.size()};
    const auto length = head.get<std::uint64_t>("record length");
    Cursor body = head;
    head.skip(length, "record");
    body.end = head.at;
    const ChunkHead chunk = read_chunk_head(body);
    chunk_ = expanded_or_fail(body, chunk);
    chunk_at_ = place.chunk;
  }
  MemorySource expanded(chunk_);
  ByteSource& bytes = place.chunk == 0 ? source_ : static_cast<ByteSource&>(expanded);
  Cursor record{bytes, kName, place.at + 1, bytes.size(), place.chunk};
  const auto length = record.get<std::uint64_t>("record length");
  record.skip(kMessageHead, "message");
  if (length < kMessageHead) record.fail("message", "one where there was one");
  return record.take(length - kMessageHead, "message");
}

McapFile read_mcap(const std::string& path) {
  refuse_absent_recording(path);
  return parse_mcap(read_file(path), path);
}

McapFile parse_mcap(std::string bytes, const std::string& path) {
  McapFile file;
  file.bytes = std::move(bytes);
  MemorySource source(file.bytes);
  constexpr std::uint64_t kMostKept = std::uint64_t{1} << 32;  // [byte]
  std::uint64_t kept = 0;
  McapScan scan = scan_mcap(source, path, [&](const McapScan&, const McapMessage& message) {
    file.messages.push_back(message);
    kept += message.data.size();
    if (kept > kMostKept)
      throw InputError(path +
                       ": messages of more than 4 GiB, expected fewer in one that is kept "
                       "in memory");
    if (message.place.chunk != 0)
      file.messages.back().data = file.expanded.emplace_back(message.data);
    return true;
  });
  file.topics = std::move(scan.topics);
  file.warnings = std::move(scan.warnings);
  file.cut = std::move(scan.cut);
  file.end = static_cast<std::size_t>(scan.end);
  return file;
}

}  // namespace thigma
