#include "thigma/files/compression.h"

#ifdef THIGMA_HAS_ZSTD
#include <zstd.h>
#endif

namespace thigma {

#ifdef THIGMA_HAS_ZSTD

bool has_zstd() { return true; }

std::string compress(std::string_view bytes, int level) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size) != 0 || size >= bytes.size()) return {};
  out.resize(size);
  return out;
}

std::optional<std::uint64_t> expanded_size(std::string_view frame) {
  const std::uint64_t size = ZSTD_getFrameContentSize(frame.data(), frame.size());
  if (size == ZSTD_CONTENTSIZE_ERROR || size == ZSTD_CONTENTSIZE_UNKNOWN) return std::nullopt;
  return size;
}

std::optional<std::string> expand(std::string_view frame, std::uint64_t size) {
  if (expanded_size(frame).value_or(size) != size) return std::nullopt;
  std::string out(static_cast<std::size_t>(size), '\0');
  const std::size_t got = ZSTD_decompress(out.data(), out.size(), frame.data(), frame.size());
  if (ZSTD_isError(got) != 0 || got != out.size()) return std::nullopt;
  return out;
}

#else

bool has_zstd() { return false; }
std::string compress(std::string_view, int) { return {}; }
std::optional<std::uint64_t> expanded_size(std::string_view) { return std::nullopt; }
std::optional<std::string> expand(std::string_view, std::uint64_t) { return std::nullopt; }

#endif

}  // namespace thigma
