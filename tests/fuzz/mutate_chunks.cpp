// .clod and .tex: chunks are taken out, one is changed, and all are put back with right lengths and
// checksums.

#include "fuzz/fuzz_target.h"

#include "thigma/clod/clod_file.h"
#include "thigma/files/chunk_file.h"
#include "thigma/math/random.h"
#include "thigma/texture/texture_file.h"

namespace thigma::fuzz {
namespace {

void change(std::string& bytes, std::size_t most, Mutate mutate) {
  const std::size_t size = bytes.size();
  bytes.resize(std::max(most, size));
  bytes.resize(mutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
}

/// Chunks as they can be changed.
struct Piece {
  Chunk chunk;
  std::string bytes;
};

std::string put_together(const ChunkKind& kind, const std::vector<Piece>& pieces) {
  ChunkWriter file(kind, pieces.size(), 0);
  for (const Piece& piece : pieces) {
    file.begin(piece.chunk.name, piece.chunk.is_required, piece.chunk.record_bytes);
    const std::size_t record = std::max<std::size_t>(1, piece.chunk.record_bytes);
    file.out().append(piece.bytes, 0, piece.bytes.size() / record * record);
  }
  return file.finish();
}

void mutate_chunks(const ChunkKind& kind, std::string& bytes, std::size_t most, std::uint32_t seed,
                   Mutate mutate) {
  Random random(seed);
  std::vector<Piece> pieces;
  try {
    for (Chunk& chunk : read_chunks(kind, bytes, "file")) {
      std::string content(chunk.bytes);
      pieces.push_back({std::move(chunk), std::move(content)});
    }
  } catch (const InputError&) {
    return change(bytes, most, mutate);
  }
  if (pieces.empty() || random.below(16) == 0) return change(bytes, most, mutate);
  Piece& piece = pieces[random.below(pieces.size())];
  const bool keeps_size = random.below(4) != 0;  // most changes of a size are refused at once
  change(piece.bytes, keeps_size ? piece.bytes.size() : piece.bytes.size() + 256, mutate);
  if (keeps_size) piece.bytes.resize(piece.chunk.bytes.size());
  std::string made = put_together(kind, pieces);
  if (made.size() <= most) bytes = std::move(made);
}

}  // namespace

void mutate_clod(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate) {
  mutate_chunks(kClodKind, bytes, most, seed, mutate);
}

void mutate_tex(std::string& bytes, std::size_t most, std::uint32_t seed, Mutate mutate) {
  mutate_chunks(kTextureKind, bytes, most, seed, mutate);
}

}  // namespace thigma::fuzz
