#include <filesystem>
#include <map>

#include "thigma/core/checksum.h"
#include "thigma/core/error.h"
#include "thigma/core/file.h"
#include "thigma/runtime/detail/mcap_records.h"
#include "thigma/runtime/mcap_file.h"

// A file with its end is whole, and whatever is wrong in it is damage. One without is what a kill, a
// power cut or a full disk left: chunks carry their own checksums, so it is read from the front up to
// the first that is not whole.

namespace thigma {
namespace {

using namespace detail;

/// Bounds-checked little-endian cursor over a part of the file.
struct Cursor {
  const McapFile& file;
  const std::string& path;
  std::size_t at, end;

  [[noreturn]] void fail(const char* what, const char* expected) const {
    throw InputError(path + ": " + what + ", byte " + std::to_string(at) + ", expected " +
                     expected);
  }
  void need(std::size_t count, const char* what) const {
    if (end - at < count) fail(what, "more bytes: the file is truncated or damaged");
  }
  template <class T>
  T get(const char* what) {
    need(sizeof(T), what);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      value |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(file.bytes[at + i])) << (8 * i);
    }
    at += sizeof(T);
    return static_cast<T>(value);
  }
  std::string_view take(std::uint64_t count, const char* what) {
    need(count > end - at ? end - at + 1 : static_cast<std::size_t>(count), what);
    const std::string_view view(file.bytes.data() + at, static_cast<std::size_t>(count));
    at += static_cast<std::size_t>(count);
    return view;
  }
  std::string_view text(const char* what) { return take(get<std::uint32_t>(what), what); }
};

struct Reading {
  McapFile& file;
  const std::string& path;
  std::map<std::uint16_t, std::int32_t> channels{};

  /// One pass over the records of a whole file, or of a chunk; true when a footer or data end was met.
  bool records(std::size_t at, std::size_t end, bool in_chunk) {
    Cursor cursor{file, path, at, end};
    while (cursor.at < end) {
      const std::size_t start = cursor.at;
      const auto opcode = cursor.get<std::uint8_t>("record");
      if (opcode == kNoRecord) cursor.fail("a record of no kind", "one of the kinds of MCAP");
      const auto length = cursor.get<std::uint64_t>("record length");
      const std::size_t begin = cursor.at;
      cursor.take(length, "record");
      Cursor body{file, path, begin, cursor.at};
      if (opcode == kDataEnd || opcode == kFooter) return true;
      if (opcode == kChannel) channel(body);
      if (opcode == kMessage) message(body, start);
      if (opcode == kChunk) {
        if (in_chunk) body.fail("chunk in a chunk", "no nesting");
        chunk(body);
      }
    }
    return false;
  }

  /// The whole records of a file without its end; why it goes no further, and from where, is in `file`.
  void prefix(std::size_t at) {
    const std::size_t size = file.bytes.size();
    for (file.end = at; file.end < size; file.end = at) {
      Cursor cursor{file, path, at, size};
      if (size - at < 9) return stop("the record there is incomplete");
      const auto opcode = cursor.get<std::uint8_t>("record");
      const auto length = cursor.get<std::uint64_t>("record length");
      if (opcode == kDataEnd) return stop("what follows the data is incomplete");
      if (opcode != kHeader && opcode != kChunk && opcode != kMessageIndex)
        return stop("there is no record of a recording");
      if (length > size - cursor.at) return stop("the record there is incomplete");
      at = cursor.at + static_cast<std::size_t>(length);
      if (opcode != kChunk) continue;
      if (!is_right(Cursor{file, path, cursor.at, at}))
        return stop("the chunk there is not what its checksum says");
      chunk(Cursor{file, path, cursor.at, at});
    }
    stop("there is no end");
  }

  void stop(const char* why) { file.cut = why; }

  /// Records between the chunks have no checksum, but the summary says how many messages there are.
  void check_summary() {
    const std::size_t footer = file.bytes.size() - kMcapMagic.size() - kFooterBytes;
    Cursor end{file, path, footer + 9, file.bytes.size()};
    const auto start = end.get<std::uint64_t>("footer");
    end.get<std::uint64_t>("footer");
    const std::size_t crc_at = end.at;
    const auto crc = end.get<std::uint32_t>("footer");
    if (start == 0 && crc == 0) return;  // of another writer, without a summary
    const bool is_placed = start >= kMcapMagic.size() && start <= footer;
    const std::string_view bytes(file.bytes);
    const std::size_t at = is_placed ? static_cast<std::size_t>(start) : footer;
    if (!is_placed || (crc != 0 && crc32(bytes.substr(at, crc_at - at)) != crc)) {
      file.warnings.push_back("the summary from byte " + std::to_string(at) +
                              " on is not what its checksum says");
      return;
    }
    for (Cursor cursor{file, path, at, footer}; cursor.at < footer;) {
      const auto opcode = cursor.get<std::uint8_t>("record");
      const auto length = cursor.get<std::uint64_t>("record length");
      const std::size_t begin = cursor.at;
      cursor.take(length, "record");
      if (opcode != kStatistics) continue;
      const auto messages = Cursor{file, path, begin, cursor.at}.get<std::uint64_t>("statistics");
      if (messages != file.messages.size()) {
        throw InputError(path + ": " + std::to_string(file.messages.size()) + " messages, byte " +
                         std::to_string(begin) + ", expected the " + std::to_string(messages) +
                         " that the summary counts: it is damaged");
      }
    }
  }

  /// Whether the length and the checksum of a chunk are those of what is in it.
  bool is_right(Cursor body) const {
    constexpr std::size_t kBefore = 8 + 8 + 8 + 4 + 4 + 8;
    if (body.end - body.at < kBefore) return false;
    const std::string_view content(file.bytes.data() + body.at + kBefore,
                                   body.end - body.at - kBefore);
    body.at += 16;
    const auto size = body.get<std::uint64_t>("chunk");
    const auto crc = body.get<std::uint32_t>("chunk");
    const auto compression = body.get<std::uint32_t>("chunk");
    const auto stored = body.get<std::uint64_t>("chunk");
    return compression == 0 && size == content.size() && stored == content.size() &&
           crc32(content) == crc;
  }

  void channel(Cursor body) {
    const auto id = body.get<std::uint16_t>("channel");
    body.get<std::uint16_t>("channel schema");
    const std::string topic(body.text("channel topic"));
    if (body.text("message encoding") != "json") body.fail("message encoding", "json");
    if (channels.count(id) != 0) return;
    channels[id] = static_cast<std::int32_t>(file.topics.size());
    file.topics.push_back(topic);
  }

  void message(Cursor body, std::size_t start) {
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
    m.offset = start;
    file.messages.push_back(m);
  }

  void chunk(Cursor body) {
    body.get<std::uint64_t>("chunk");
    body.get<std::uint64_t>("chunk");
    body.get<std::uint64_t>("chunk");
    const auto crc = body.get<std::uint32_t>("chunk");
    if (!body.text("chunk compression").empty())
      body.fail("compressed chunk", "an uncompressed one");
    const auto size = body.get<std::uint64_t>("chunk size");
    const std::size_t begin = body.at;
    const std::string_view content = body.take(size, "chunk");
    if (crc != 0 && crc32(content) != crc) {
      file.warnings.push_back("the chunk at byte " + std::to_string(begin) +
                              " is not what its checksum says");
    }
    records(begin, begin + content.size(), true);
  }
};

/// Whether the footer and the magic bytes of a whole file are at its end.
bool has_end(const std::string& bytes) {
  constexpr std::size_t kEnd = kFooterBytes + kMcapMagic.size();
  return bytes.size() >= kMcapMagic.size() + kEnd &&
         static_cast<std::uint8_t>(bytes[bytes.size() - kEnd]) == kFooter &&
         bytes.compare(bytes.size() - kMcapMagic.size(), kMcapMagic.size(), kMcapMagic) == 0;
}

}  // namespace

McapFile read_mcap(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown) && std::filesystem::exists(path + ".part", unknown)) {
    throw InputError(path + ": is not there, but what a session that is not over has written is, " +
                     "expected " + path + ".part");
  }
  return parse_mcap(read_file(path), path);
}

McapFile parse_mcap(std::string bytes, const std::string& path) {
  McapFile file;
  file.bytes = std::move(bytes);
  if (file.bytes.compare(0, kMcapMagic.size(), kMcapMagic) != 0) {
    throw InputError(path + ": not an MCAP file, byte 0, expected its magic bytes");
  }
  const bool is_cut = !has_end(file.bytes);
  Reading reading{file, path};
  if (is_cut) {
    reading.prefix(kMcapMagic.size());
    return file;
  }
  file.end = file.bytes.size();
  if (!reading.records(kMcapMagic.size(), file.bytes.size(), false)) {
    throw InputError(path + ": no end of the data, byte " + std::to_string(file.bytes.size()) +
                     ", expected one before the footer: it is damaged");
  }
  reading.check_summary();
  return file;
}

}  // namespace thigma
