#pragma once
// The MCAP container (version 0): chunked, indexed, chunks compressed; opened by any MCAP reader.
// Layout as this project writes and reads it: docs/formats.md.

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "thigma/files/byte_source.h"
#include "thigma/files/growing_file.h"
#include "thigma/recording/mcap_place.h"

namespace thigma {

/// A file within an MCAP file: any MCAP tool lists it and takes it out.
struct McapAttachment {
  std::string name;
  std::string media_type;
  std::string data;
};

/// Writes an MCAP file. Written beside its place as PATH.part and moved there by close(), so that
/// PATH is whole or absent; what a kill leaves of PATH.part is read up to its last whole chunk
/// (GrowingFile). Chunks are compressed by zstd where this build has it. Invariant: between
/// construction and close() the .part file is a prefix of a valid file, chunks at a time. Thread:
/// one thread, [offline]. Members throw IoError, one line, when the system refuses.
class McapWriter {
 public:
  explicit McapWriter(const std::string& path, std::string_view library = "thigma");
  // without close(): flushes and leaves the .part file, removes one without a message
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// Channel of JSON messages; all channels are added before the first write. json_schema may be
  /// empty.
  std::uint16_t add_channel(std::string_view topic, std::string_view schema_name,
                            std::string_view json_schema);

  /// Puts a file into the file, at once and whole, between the chunks.
  void attach(const McapAttachment& attachment);

  /// Appends one message; time [ns] of the session clock. Chunks are flushed as they reach 1 MiB,
  /// or with the first message half a second after their first.
  void write(std::uint16_t channel, std::uint32_t sequence, std::uint64_t time,
             std::string_view json);

  /// What was written so far survives the process.
  void flush();

  void close();

  /// After an error: without what was not flushed, closes the file, whole, if there is room for its
  /// end.
  /// returns  where it is: PATH, PATH.part without its end, "" where nothing was flushed and
  ///          nothing is left
  std::string close_early();

  void discard();  // removes the file

  std::uint64_t messages() const { return messages_; }    // flushed
  std::uint64_t last_time() const { return last_time_; }  // of them [ns]
  const std::string& path() const { return file_.path(); }
  const std::string& moved() const { return file_.moved(); }  // see GrowingFile

 private:
  struct Channel {
    std::string record_bytes;  // schema and channel records, repeated in the summary
    std::uint64_t messages = 0;
  };
  std::string chunk_entry(std::uint64_t length, const std::string& index_offsets,
                          std::uint64_t index_length, std::uint64_t stored) const;
  std::string_view compression_of(std::size_t stored) const;
  void count_chunk();
  void drop_chunk();
  std::string summary() const;
  std::uint64_t end_bytes() const;
  void finish();

  GrowingFile file_;
  bool is_open_ = true;
  std::vector<Channel> channels_;
  std::uint64_t messages_ = 0, first_time_ = 0, last_time_ = 0;  // flushed
  std::uint32_t chunks_ = 0, attachments_ = 0;
  std::string chunk_entries_;  // of the summary, and so those of the attachments

  std::string chunk_;  // not flushed
  std::uint64_t chunk_messages_ = 0, chunk_first_ = 0, chunk_last_ = 0;
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>> chunk_index_;
};

/// "byte 12", "byte 12 of the chunk at byte 99".
std::string place_text(const McapPlace& place);

struct McapMessage {
  std::int32_t channel = 0;  // into McapFile::topics
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;  // [ns]
  std::string_view data;   // into the McapFile; of scan_mcap: valid during the call
  McapPlace place;
};

/// What a pass over an MCAP file finds beside its messages.
struct McapScan {
  std::vector<std::string> topics;
  // what is not what its checksum says: read all the same, and said
  std::vector<std::string> warnings;
  std::string cut;             // "" where the file has its end; else why nothing more was read
  std::uint64_t end = 0;       // of what was read [byte]
  std::uint64_t size = 0;      // of the file [byte]
  std::uint64_t messages = 0;  // so far
};

/// Takes a message, whose topic is scan.topics[message.channel]; false: no more are wanted.
using McapSink = std::function<bool(const McapScan& scan, const McapMessage& message)>;

/// Goes through an MCAP file of any size, in the memory of its longest chunk and of the source's
/// window. Chunks are as they are or compressed by zstd, at most 256 MiB of each. A file that has
/// its end is read whole or refused. One without was cut off by a kill, a power cut or a full disk:
/// it is read up to the first record that is not whole, or not what its checksum says. Thread
/// [offline]; throws InputError "FILE: what, byte N, what was expected" on damage and when
/// unreadable, maybe after some messages were taken.
McapScan scan_mcap(ByteSource& source, const std::string& path, const McapSink& take);

/// Throws InputError that names PATH.part where that is there and PATH is not. Thread [offline].
void refuse_absent_recording(const std::string& path);

/// Messages once more, by their places, in any order. Keeps the last compressed chunk it was asked
/// of, so that neighbours cost nothing. Thread: one, [offline].
class McapMessages {
 public:
  explicit McapMessages(ByteSource& source) : source_(source) {}

  /// The data of the message that a pass over the same source found there. Valid until the next
  /// call, and while the source is not asked for anything else.
  /// errors  InputError where the file has changed
  std::string_view data(const McapPlace& place);

 private:
  ByteSource& source_;
  std::string chunk_;           // what the chunk holds
  std::uint64_t chunk_at_ = 0;  // of its record in the file; 0: none is kept
};

/// The files in an MCAP file, in their order; of one that was cut off those that are whole.
/// Thread [offline]; throws InputError "FILE: what, byte N, what was expected" for what is no MCAP
/// file, or where one is not what its checksum says.
std::vector<McapAttachment> read_attachments(ByteSource& source, const std::string& path);

/// An MCAP file in memory. Views stay valid while the object is not moved from or destroyed.
struct McapFile {
  std::string bytes;
  std::vector<std::string> topics;
  std::vector<McapMessage> messages;  // in file order
  std::deque<std::string> expanded;   // data of messages in compressed chunks
  std::vector<std::string> warnings;  // as in McapScan, and so the next two
  std::string cut;
  std::size_t end = 0;
};

/// Reads an MCAP file of at most 4 GiB as scan_mcap does.
McapFile read_mcap(const std::string& path);

/// The same of bytes that are there; `path` names them in errors. Thread [offline].
McapFile parse_mcap(std::string bytes, const std::string& path);

}  // namespace thigma
