#include "thigma/runtime/mcap_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "thigma/core/checksum.h"
#include "thigma/core/error.h"
#include "thigma/core/file.h"

// After the public MCAP specification: records are opcode, length, content; little-endian; strings
// carry their length. Chunks are uncompressed: a recording is a few megabytes, and any reader opens
// it.

namespace thigma {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::size_t kChunkBytes = 1u << 20;

enum Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f
};

template <class T>
void append(std::string& out, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    out.push_back(static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xff));
  }
}

void append_string(std::string& out, std::string_view text) {
  append(out, static_cast<std::uint32_t>(text.size()));
  out.append(text);
}

std::string record(Opcode opcode, std::string_view content) {
  std::string out;
  out.reserve(content.size() + 9);
  append(out, static_cast<std::uint8_t>(opcode));
  append(out, static_cast<std::uint64_t>(content.size()));
  out.append(content);
  return out;
}

}  // namespace

McapWriter::McapWriter(const std::string& path, std::string_view library)
    : path_(path), part_(path + ".part") {
  // Renaming would fail at a folder after the whole session, and put a file in the place of a
  // device such as /dev/null.
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown)) {
    throw IoError(path + ": cannot be written: not a regular file");
  }
  file_ = std::fopen(part_.c_str(), "wb");
  if (file_ == nullptr) throw IoError(path + ": cannot be written: " + std::strerror(errno));
  put(kMagic);
  std::string header;
  append_string(header, "");
  append_string(header, library);
  put(record(kHeader, header));
}

McapWriter::~McapWriter() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(part_.c_str());
}

void McapWriter::put(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
    throw IoError(path_ + ": cannot be written: " + std::strerror(errno));
  }
  offset_ += bytes.size();
}

std::uint16_t McapWriter::add_channel(std::string_view topic, std::string_view schema_name,
                                      std::string_view json_schema) {
  const std::uint16_t id = static_cast<std::uint16_t>(channels_.size() + 1);
  std::string schema;
  append(schema, id);
  append_string(schema, schema_name);
  append_string(schema, "jsonschema");
  append_string(schema,
                json_schema.empty() ? std::string_view("{\"type\":\"object\"}") : json_schema);
  std::string channel;
  append(channel, id);
  append(channel, id);
  append_string(channel, topic);
  append_string(channel, "json");
  append(channel, std::uint32_t{0});  // no metadata
  channels_.push_back({record(kSchema, schema) + record(kChannel, channel), 0});
  chunk_ += channels_.back().record_bytes;
  return id;
}

void McapWriter::write(std::uint16_t channel, std::uint32_t sequence, std::uint64_t time,
                       std::string_view json) {
  if (chunk_.size() >= kChunkBytes) flush_chunk();
  chunk_index_[channel].emplace_back(time, chunk_.size());
  chunk_first_ = chunk_messages_ == 0 ? time : std::min(chunk_first_, time);
  chunk_last_ = chunk_messages_ == 0 ? time : std::max(chunk_last_, time);
  ++chunk_messages_;
  first_time_ = message_count_ == 0 ? time : std::min(first_time_, time);
  last_time_ = message_count_ == 0 ? time : std::max(last_time_, time);
  append(chunk_, static_cast<std::uint8_t>(kMessage));
  append(chunk_, static_cast<std::uint64_t>(22 + json.size()));
  append(chunk_, channel);
  append(chunk_, sequence);
  append(chunk_, time);
  append(chunk_, time);
  chunk_.append(json);
  ++channels_[channel - 1u].messages;
  ++message_count_;
}

void McapWriter::flush_chunk() {
  if (chunk_.empty()) return;
  ChunkEntry entry{};
  entry.offset = offset_;
  entry.first = chunk_first_;
  entry.last = chunk_last_;
  entry.size = chunk_.size();
  std::string content;
  content.reserve(chunk_.size() + 64);
  append(content, entry.first);
  append(content, entry.last);
  append(content, static_cast<std::uint64_t>(chunk_.size()));
  append(content, crc32(chunk_));
  append_string(content, "");  // no compression
  append(content, static_cast<std::uint64_t>(chunk_.size()));
  content += chunk_;
  put(record(kChunk, content));
  entry.length = offset_ - entry.offset;
  entry.index_offset = offset_;
  for (const auto& [channel, items] : chunk_index_) {
    entry.index_offsets[channel] = offset_;
    std::string index;
    append(index, channel);
    append(index, static_cast<std::uint32_t>(items.size() * 16));
    for (const auto& [time, at] : items) {
      append(index, time);
      append(index, at);
    }
    put(record(kMessageIndex, index));
  }
  entry.index_length = offset_ - entry.index_offset;
  chunks_.push_back(std::move(entry));
  chunk_.clear();
  chunk_index_.clear();
  chunk_messages_ = chunk_first_ = chunk_last_ = 0;
}

void McapWriter::write_summary() {
  std::string summary;
  for (const Channel& channel : channels_) summary += channel.record_bytes;
  std::string statistics;
  append(statistics, message_count_);
  append(statistics, static_cast<std::uint16_t>(channels_.size()));  // schemas
  append(statistics, static_cast<std::uint32_t>(channels_.size()));
  append(statistics, std::uint32_t{0});  // attachments
  append(statistics, std::uint32_t{0});  // metadata records
  append(statistics, static_cast<std::uint32_t>(chunks_.size()));
  append(statistics, first_time_);
  append(statistics, last_time_);
  append(statistics, static_cast<std::uint32_t>(channels_.size() * 10));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    append(statistics, static_cast<std::uint16_t>(i + 1));
    append(statistics, channels_[i].messages);
  }
  summary += record(kStatistics, statistics);
  for (const ChunkEntry& chunk : chunks_) {
    std::string index;
    append(index, chunk.first);
    append(index, chunk.last);
    append(index, chunk.offset);
    append(index, chunk.length);
    append(index, static_cast<std::uint32_t>(chunk.index_offsets.size() * 10));
    for (const auto& [channel, at] : chunk.index_offsets) {
      append(index, channel);
      append(index, at);
    }
    append(index, chunk.index_length);
    append_string(index, "");
    append(index, chunk.size);  // compressed size
    append(index, chunk.size);
    summary += record(kChunkIndex, index);
  }
  const std::uint64_t start = offset_;
  put(summary);
  std::string footer;
  append(footer, start);
  append(footer, std::uint64_t{0});  // no summary offsets
  // The checksum covers the summary and the footer up to the checksum itself.
  std::string covered = summary;
  append(covered, static_cast<std::uint8_t>(kFooter));
  append(covered, std::uint64_t{20});
  covered += footer;
  append(footer, crc32(covered));
  put(record(kFooter, footer));
  put(kMagic);
}

void McapWriter::close() {
  if (file_ == nullptr) return;
  flush_chunk();
  std::string end;
  append(end, std::uint32_t{0});  // the chunks carry their own checksums
  put(record(kDataEnd, end));
  write_summary();
  std::FILE* file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0) throw IoError(path_ + ": cannot be written: " + std::strerror(errno));
  std::error_code error;
  std::filesystem::rename(part_, path_, error);
  if (error) throw IoError(path_ + ": cannot be written: " + error.message());
}

namespace {

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
  std::map<std::uint16_t, std::int32_t> channels;

  /// One pass over records in [at, end); true when a footer or data end was met.
  bool records(std::size_t at, std::size_t end, bool in_chunk) {
    Cursor cursor{file, path, at, end};
    while (cursor.at < end) {
      const std::size_t start = cursor.at;
      const auto opcode = cursor.get<std::uint8_t>("record");
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

}  // namespace

McapFile read_mcap(const std::string& path) {
  McapFile file;
  file.bytes = read_file(path);
  if (file.bytes.compare(0, kMagic.size(), kMagic) != 0) {
    throw InputError(path + ": not an MCAP file, byte 0, expected its magic bytes");
  }
  Reading reading{file, path, {}};
  const bool has_data_end = reading.records(kMagic.size(), file.bytes.size(), false);
  // The summary after the data is not needed here, but a file without its end is not the one that
  // was written.
  const bool has_end =
      file.bytes.size() >= 2 * kMagic.size() &&
      file.bytes.compare(file.bytes.size() - kMagic.size(), kMagic.size(), kMagic) == 0;
  if (!has_data_end || !has_end) {
    throw InputError(path + ": the recording ends early, byte " +
                     std::to_string(file.bytes.size()) +
                     ", expected a footer and the magic bytes: it is truncated");
  }
  return file;
}

}  // namespace thigma
