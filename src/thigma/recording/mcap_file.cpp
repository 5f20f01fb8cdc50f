#include "thigma/recording/mcap_file.h"

#include <algorithm>

#include "thigma/core/error.h"
#include "thigma/files/checksum.h"
#include "thigma/files/compression.h"
#include "thigma/recording/detail/mcap_records.h"

// After the public MCAP specification: records are opcode, length, content; little-endian; strings
// carry their length.

namespace thigma {
namespace {

using namespace detail;

constexpr std::size_t kChunkBytes = 1u << 20;
constexpr std::uint64_t kChunkTime = 500'000'000;  // of its messages, first to last [ns]

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

std::string record(McapOpcode opcode, std::string_view content) {
  std::string out;
  out.reserve(content.size() + 9);
  append(out, static_cast<std::uint8_t>(opcode));
  append(out, static_cast<std::uint64_t>(content.size()));
  out.append(content);
  return out;
}

}  // namespace

McapWriter::McapWriter(const std::string& path, std::string_view library) : file_(path) {
  std::string header;
  append_string(header, "");
  append_string(header, library);
  try {
    file_.append(std::string(kMcapMagic) + record(kHeader, header));
  } catch (...) {
    file_.discard();
    throw;
  }
}

McapWriter::~McapWriter() {
  if (!is_open_) return;
  try {
    flush();
  } catch (...) {  // the disk is full: what is there stays
  }
  if (messages_ == 0) file_.discard();
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

void McapWriter::attach(const McapAttachment& attachment) {
  std::string content, entry;
  content.reserve(attachment.data.size() + attachment.name.size() + 128);
  append(content, std::uint64_t{0});  // of the session clock; no clock on the wall
  append(content, std::uint64_t{0});
  append_string(content, attachment.name);
  append_string(content, attachment.media_type);
  append(content, static_cast<std::uint64_t>(attachment.data.size()));
  content += attachment.data;
  append(content, crc32(content));
  const std::string bytes = record(kAttachment, content);
  append(entry, file_.size());
  append(entry, static_cast<std::uint64_t>(bytes.size()));
  append(entry, std::uint64_t{0});
  append(entry, std::uint64_t{0});
  append(entry, static_cast<std::uint64_t>(attachment.data.size()));
  append_string(entry, attachment.name);
  append_string(entry, attachment.media_type);
  entry = record(kAttachmentIndex, entry);
  file_.append(bytes, end_bytes() + entry.size());
  chunk_entries_ += entry;
  ++attachments_;
}

void McapWriter::write(std::uint16_t channel, std::uint32_t sequence, std::uint64_t time,
                       std::string_view json) {
  const bool is_long = time > chunk_first_ && time - chunk_first_ >= kChunkTime;
  if (chunk_.size() >= kChunkBytes || (chunk_messages_ > 0 && is_long)) flush();
  chunk_index_[channel].emplace_back(time, chunk_.size());
  chunk_first_ = chunk_messages_ == 0 ? time : std::min(chunk_first_, time);
  chunk_last_ = chunk_messages_ == 0 ? time : std::max(chunk_last_, time);
  ++chunk_messages_;
  append(chunk_, static_cast<std::uint8_t>(kMessage));
  append(chunk_, static_cast<std::uint64_t>(22 + json.size()));
  append(chunk_, channel);
  append(chunk_, sequence);
  append(chunk_, time);
  append(chunk_, time);
  chunk_.append(json);
}

void McapWriter::flush() {
  if (chunk_.empty()) return;
  std::string content;
  content.reserve(chunk_.size() + 64);
  append(content, chunk_first_);
  append(content, chunk_last_);
  append(content, static_cast<std::uint64_t>(chunk_.size()));
  append(content, crc32(chunk_));
  const std::string shorter = compress(chunk_);
  const std::string& stored = shorter.empty() ? chunk_ : shorter;
  append_string(content, compression_of(stored.size()));
  append(content, static_cast<std::uint64_t>(stored.size()));
  content += stored;
  std::string bytes = record(kChunk, content);
  const std::uint64_t length = bytes.size();
  std::string index_offsets;
  for (const auto& [channel, items] : chunk_index_) {
    append(index_offsets, channel);
    append(index_offsets, file_.size() + bytes.size());
    std::string index;
    append(index, channel);
    append(index, static_cast<std::uint32_t>(items.size() * 16));
    for (const auto& [time, at] : items) {
      append(index, time);
      append(index, at);
    }
    bytes += record(kMessageIndex, index);
  }
  const std::string entry =
      chunk_entry(length, index_offsets, bytes.size() - length, stored.size());
  // Room for the end, so that a full disk still takes it.
  file_.append(bytes, end_bytes() + entry.size());
  chunk_entries_ += entry;
  count_chunk();
  drop_chunk();
}

/// The name of what makes the bytes of the chunk that many.
std::string_view McapWriter::compression_of(std::size_t stored) const {
  return stored == chunk_.size() ? std::string_view() : kZstd;
}

/// The index record of the chunk that is about to be written, for the summary.
std::string McapWriter::chunk_entry(std::uint64_t length, const std::string& index_offsets,
                                    std::uint64_t index_length, std::uint64_t stored) const {
  std::string entry;
  append(entry, chunk_first_);
  append(entry, chunk_last_);
  append(entry, file_.size());
  append(entry, length);
  append(entry, static_cast<std::uint32_t>(index_offsets.size()));
  entry += index_offsets;
  append(entry, index_length);
  append_string(entry, compression_of(stored));
  append(entry, stored);
  append(entry, static_cast<std::uint64_t>(chunk_.size()));
  return record(kChunkIndex, entry);
}

void McapWriter::count_chunk() {
  for (const auto& [channel, items] : chunk_index_)
    channels_[channel - 1u].messages += items.size();
  if (chunk_messages_ > 0) {
    first_time_ = messages_ == 0 ? chunk_first_ : std::min(first_time_, chunk_first_);
    last_time_ = messages_ == 0 ? chunk_last_ : std::max(last_time_, chunk_last_);
  }
  messages_ += chunk_messages_;
  ++chunks_;
}

void McapWriter::drop_chunk() {
  chunk_.clear();
  chunk_index_.clear();
  chunk_messages_ = chunk_first_ = chunk_last_ = 0;
}

std::string McapWriter::summary() const {
  std::string summary;
  for (const Channel& channel : channels_) summary += channel.record_bytes;
  std::string statistics;
  append(statistics, messages_);
  append(statistics, static_cast<std::uint16_t>(channels_.size()));  // schemas
  append(statistics, static_cast<std::uint32_t>(channels_.size()));
  append(statistics, attachments_);
  append(statistics, std::uint32_t{0});  // metadata records
  append(statistics, chunks_);
  append(statistics, first_time_);
  append(statistics, last_time_);
  append(statistics, static_cast<std::uint32_t>(channels_.size() * 10));
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    append(statistics, static_cast<std::uint16_t>(i + 1));
    append(statistics, channels_[i].messages);
  }
  return summary + record(kStatistics, statistics) + chunk_entries_;
}

/// How long the end would be now.
std::uint64_t McapWriter::end_bytes() const {
  std::uint64_t bytes = (9 + 4) + (9 + 46 + 10 * channels_.size()) + chunk_entries_.size() +
                        kFooterBytes + kMcapMagic.size();
  for (const Channel& channel : channels_) bytes += channel.record_bytes.size();
  return bytes;
}

void McapWriter::finish() {
  is_open_ = false;
  std::string data_end;
  append(data_end, std::uint32_t{0});  // the chunks carry their own checksums
  std::string end = record(kDataEnd, data_end);
  std::string footer;
  append(footer, file_.size() + end.size());
  append(footer, std::uint64_t{0});  // no summary offsets
  // The checksum covers the summary and the footer up to the checksum itself.
  std::string covered = summary();
  append(covered, static_cast<std::uint8_t>(kFooter));
  append(covered, std::uint64_t{20});
  covered += footer;
  append(covered, crc32(covered));
  end += covered;
  end += kMcapMagic;
  file_.append(end);
  file_.keep();
}

void McapWriter::close() {
  if (!is_open_) return;
  flush();
  finish();
}

std::string McapWriter::close_early() {
  if (!is_open_) return file_.part();
  drop_chunk();
  if (messages_ == 0) {
    discard();
    return {};
  }
  try {
    finish();
    return file_.path();
  } catch (const IoError&) {
    return file_.part();
  }
}

void McapWriter::discard() {
  is_open_ = false;
  file_.discard();
}

}  // namespace thigma
