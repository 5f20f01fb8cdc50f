#include "thigma/files/chunk_file.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "thigma/core/error.h"
#include "thigma/files/checksum.h"

namespace thigma {
namespace {

static_assert(std::endian::native == std::endian::little, "files are little-endian, as memory is");

constexpr std::size_t kCrcAt = 24;  // of the header

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

template <class T>
T get(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::size_t aligned(std::size_t size) {
  return (size + kChunkAlign - 1) / kChunkAlign * kChunkAlign;
}

std::uint32_t header_crc(std::string_view bytes, std::size_t size) {
  const std::uint32_t before = crc32(bytes.substr(0, kCrcAt));
  const std::uint32_t blank = crc32(std::string_view("\0\0\0\0", 4), before);
  return crc32(bytes.substr(kCrcAt + 4, size - kCrcAt - 4), blank);
}

[[noreturn]] void fail(const std::string& name, const std::string& what, std::size_t byte,
                       const std::string& expected) {
  throw InputError(name + ": " + what + ", byte " + std::to_string(byte) + ", expected " +
                   expected);
}

std::string bytes_text(std::uint64_t count) { return std::to_string(count) + " bytes"; }

/// Checks the header. returns the number of chunks.
std::size_t check_header(const ChunkKind& kind, std::string_view bytes, const std::string& name) {
  if (bytes.substr(0, kind.magic.size()) != kind.magic.substr(0, bytes.size()))
    fail(name, "is no " + std::string(kind.suffix) + " file", 0, std::string(kind.expected));
  if (bytes.size() < kChunkHeader)
    fail(name, "is cut off in its header", bytes.size(), bytes_text(kChunkHeader));
  const auto version = get<std::uint32_t>(bytes, 8);
  if (version != kind.version)
    fail(name, "has version " + std::to_string(version), 8,
         "version " + std::to_string(kind.version) +
             (version > kind.version ? ", or a newer thigma" : ""));
  const auto count = get<std::uint32_t>(bytes, 12);
  const auto size = get<std::uint64_t>(bytes, 16);
  if (size > bytes.size()) fail(name, "is cut off", bytes.size(), bytes_text(size));
  if (size < bytes.size()) fail(name, "goes on behind its end", size, "no more");
  if (count > kMostChunks || kChunkHeader + count * kChunkEntry > bytes.size())
    fail(name, "lists " + std::to_string(count) + " chunks", 12, "as many as there is room for");
  if (header_crc(bytes, kChunkHeader + count * kChunkEntry) != get<std::uint32_t>(bytes, kCrcAt))
    fail(name, "is damaged: the checksum of the header differs", kCrcAt, "an unchanged file");
  const auto rest = bytes.substr(kCrcAt + 4, kChunkHeader - kCrcAt - 4);
  if (rest.find_first_not_of('\0') != rest.npos)
    fail(name, "has an unknown header", kCrcAt + 4, "zeros");
  return count;
}

/// Reads entry i of the table. offset: where the chunk has to begin; moved to its end.
Chunk read_entry(std::string_view bytes, std::size_t i, std::size_t& offset,
                 const std::string& name) {
  const std::size_t entry = kChunkHeader + i * kChunkEntry;
  Chunk chunk;
  const std::string_view field = bytes.substr(entry, kChunkName);
  chunk.name = field.substr(0, std::min(field.find('\0'), field.size()));
  const bool is_name =
      !chunk.name.empty() &&
      chunk.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos &&
      field.find_first_not_of('\0', chunk.name.size()) == field.npos;
  if (!is_name) fail(name, "has a chunk without a name", entry, "letters, digits and _");
  const auto flags = get<std::uint32_t>(bytes, entry + 16);
  if (flags > 1) fail(name, "has unknown flags at chunk " + chunk.name, entry + 16, "0 or 1");
  chunk.is_required = flags == 1;
  chunk.record_bytes = get<std::uint32_t>(bytes, entry + 20);
  chunk.record_count = get<std::uint64_t>(bytes, entry + 24);
  const auto begin = get<std::uint64_t>(bytes, entry + 32),
             size = get<std::uint64_t>(bytes, entry + 40);
  if (begin != offset || size > bytes.size() - offset)
    fail(name, "has chunk " + chunk.name + " out of place", entry + 32,
         "byte " + std::to_string(offset) + ", within the file");
  const bool is_count =
      chunk.record_bytes == 0
          ? size == 0 && chunk.record_count == 0
          : size % chunk.record_bytes == 0 && chunk.record_count == size / chunk.record_bytes;
  if (!is_count)
    fail(name, "has a wrong count at chunk " + chunk.name, entry + 24, bytes_text(size));
  chunk.bytes = bytes.substr(offset, size);
  if (crc32(chunk.bytes) != get<std::uint32_t>(bytes, entry + 48))
    fail(name, "is damaged: the checksum of chunk " + chunk.name + " differs", offset,
         "an unchanged file");
  const std::string_view rest = bytes.substr(entry + 52, kChunkEntry - 52);
  if (rest.find_first_not_of('\0') != rest.npos)
    fail(name, "has an unknown entry for chunk " + chunk.name, entry + 52, "zeros");
  const std::size_t end = offset + size;
  offset = aligned(end);
  if (offset > bytes.size()) fail(name, "is cut off", bytes.size(), bytes_text(offset));
  const std::string_view gap = bytes.substr(end, offset - end);
  if (gap.find_first_not_of('\0') != gap.npos)
    fail(name, "is damaged behind chunk " + chunk.name, end, "zeros up to the next");
  return chunk;
}

}  // namespace

ChunkWriter::ChunkWriter(const ChunkKind& kind, std::size_t chunk_count, std::size_t bytes)
    : kind_(kind), chunk_count_(chunk_count) {
  out_.reserve(kChunkHeader + chunk_count * (kChunkEntry + kChunkAlign) + bytes);
  out_.resize(kChunkHeader + chunk_count * kChunkEntry, '\0');
}

void ChunkWriter::begin(std::string_view name, bool is_required, std::uint32_t record_bytes) {
  end();
  entries_.push_back({std::string(name), is_required, record_bytes, out_.size(), 0});
}

void ChunkWriter::end() {
  if (entries_.empty()) return;
  entries_.back().size = out_.size() - entries_.back().offset;
  out_.resize(aligned(out_.size()), '\0');
}

std::string ChunkWriter::finish() {
  end();
  assert(entries_.size() == chunk_count_);
  std::copy(kind_.magic.begin(), kind_.magic.end(), out_.begin());
  put(out_, 8, kind_.version);
  put(out_, 12, static_cast<std::uint32_t>(entries_.size()));
  put(out_, 16, static_cast<std::uint64_t>(out_.size()));
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& e = entries_[i];
    const std::size_t entry = kChunkHeader + i * kChunkEntry;
    std::copy(e.name.begin(), e.name.end(), out_.begin() + static_cast<std::ptrdiff_t>(entry));
    put(out_, entry + 16, std::uint32_t{e.is_required});
    put(out_, entry + 20, e.record_bytes);
    put(out_, entry + 24,
        static_cast<std::uint64_t>(e.record_bytes > 0 ? e.size / e.record_bytes : 0));
    put(out_, entry + 32, static_cast<std::uint64_t>(e.offset));
    put(out_, entry + 40, static_cast<std::uint64_t>(e.size));
    put(out_, entry + 48, crc32(std::string_view(out_).substr(e.offset, e.size)));
  }
  const std::size_t table_end = kChunkHeader + entries_.size() * kChunkEntry;
  put(out_, kCrcAt, header_crc(out_, table_end));
  return std::move(out_);
}

std::vector<Chunk> read_chunks(const ChunkKind& kind, std::string_view bytes,
                               const std::string& name) {
  const std::size_t count = check_header(kind, bytes, name);
  std::vector<Chunk> chunks;
  std::size_t offset = kChunkHeader + count * kChunkEntry;
  for (std::size_t i = 0; i < count; ++i) {
    Chunk chunk = read_entry(bytes, i, offset, name);
    for (const Chunk& other : chunks)
      if (other.name == chunk.name)
        fail(name, "has chunk " + chunk.name + " twice", kChunkHeader + i * kChunkEntry, "it once");
    chunks.push_back(std::move(chunk));
  }
  if (offset != bytes.size()) fail(name, "goes on behind its chunks", offset, "its end");
  return chunks;
}

}  // namespace thigma
