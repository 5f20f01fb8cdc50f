#pragma once
// The MCAP container (version 0): chunked, indexed, uncompressed; opened by any MCAP reader.
// Layout as this project writes and reads it: docs/formats.md.

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace thigma {

/// Writes an MCAP file. Written beside its place as PATH.part and moved there by close(), so that PATH is
/// whole or absent.
/// Invariant: between construction and close() the .part file is a prefix of a valid file, chunks at a time.
/// Thread: one thread, [offline]. Every member throws IoError when the system refuses.
class McapWriter {
 public:
  explicit McapWriter(const std::string& path, std::string_view library = "thigma");
  ~McapWriter();  // without close(): removes the .part file
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Channel of JSON messages; all channels are added before the first write. json_schema may be empty.
  std::uint16_t add_channel(std::string_view topic, std::string_view schema_name, std::string_view json_schema);

  /// Appends one message; time [ns] of the session clock.
  void write(std::uint16_t channel, std::uint32_t sequence, std::uint64_t time, std::string_view json);

  void close();
  std::uint64_t messages() const { return message_count_; }

 private:
  struct ChunkEntry {
    std::uint64_t offset, length, first, last, index_offset, index_length, size;
    std::map<std::uint16_t, std::uint64_t> index_offsets;
  };
  struct Channel {
    std::string record_bytes;  // schema and channel records, repeated in the summary
    std::uint64_t messages = 0;
  };
  void put(std::string_view bytes);
  void flush_chunk();
  void write_summary();

  std::string path_, part_;
  std::FILE* file_ = nullptr;
  std::uint64_t offset_ = 0, message_count_ = 0, first_time_ = 0, last_time_ = 0;
  std::string chunk_;
  std::uint64_t chunk_messages_ = 0, chunk_first_ = 0, chunk_last_ = 0;
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> chunk_index_;
  std::vector<ChunkEntry> chunks_;
  std::vector<Channel> channels_;
};

struct McapMessage {
  std::int32_t channel = 0;     // into McapFile::topics
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;       // [ns]
  std::string_view data;        // into McapFile::bytes
  std::uint64_t offset = 0;     // of the record in the file or in its chunk's place in the file [byte]
};

/// A whole MCAP file in memory. Views stay valid while the object is not moved from or destroyed.
struct McapFile {
  std::string bytes;
  std::vector<std::string> topics;
  std::vector<McapMessage> messages;  // in file order
  std::vector<std::string> warnings;  // chunks whose checksum is off: read all the same, and said
};

/// Reads an MCAP file with uncompressed chunks.
/// Thread [offline]; throws InputError "FILE: what, byte N, what was expected" on damage, IoError when unreadable.
McapFile read_mcap(const std::string& path);

}  // namespace thigma
