#pragma once
// The container of this project's binary files: a header, a table of named chunks, the chunks.
// docs/formats.md has every byte.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace thigma {

/// What tells one kind of file from another.
struct ChunkKind {
  std::string_view magic;     // the first 8 bytes
  std::uint32_t version = 1;  // of the format; another one is refused
  std::string_view suffix;    // ".clod", for messages
  std::string_view expected;  // "levels of detail as `thigma build` writes them", for messages
};

inline constexpr std::size_t kChunkHeader = 64, kChunkEntry = 64, kChunkAlign = 64;
inline constexpr std::size_t kMostChunks = 1024;
inline constexpr std::size_t kChunkName = 16;

/// A named array of equal records.
struct Chunk {
  std::string name;          // 1..16 characters of a-z, 0-9 and _
  bool is_required = false;  // a reader that does not know it has to refuse the file
  std::uint32_t record_bytes = 0;
  std::uint64_t record_count = 0;
  std::string_view bytes;  // record_bytes * record_count of them
};

/// Writes chunks one behind the other into one string.
/// Invariant: between begin() and the next begin() or finish() everything appended belongs to one
/// chunk.
class ChunkWriter {
 public:
  /// chunk_count  how many there will be; bytes  of all together, or a guess
  ChunkWriter(const ChunkKind& kind, std::size_t chunk_count, std::size_t bytes);
  void begin(std::string_view name, bool is_required, std::uint32_t record_bytes);
  std::string& out() { return out_; }
  std::string finish();

 private:
  struct Entry {
    std::string name;
    bool is_required;
    std::uint32_t record_bytes;
    std::size_t offset, size;
  };
  void end();

  ChunkKind kind_;
  std::size_t chunk_count_;
  std::vector<Entry> entries_;
  std::string out_;
};

/// The chunks of a file, views into `bytes`. Lengths, checksums, order, padding: everything about
/// the container has been checked; a changed byte anywhere is found.
///
/// name    of the file, for messages
/// Thread  [offline]; throws InputError with the reason.
std::vector<Chunk> read_chunks(const ChunkKind& kind, std::string_view bytes,
                               const std::string& name);

}  // namespace thigma
