#include "thigma/recording/detail/mcap_codec.h"

#ifdef THIGMA_HAS_ZSTD
#include <zstd.h>
#endif

namespace thigma::detail {

#ifdef THIGMA_HAS_ZSTD

bool has_zstd() { return true; }

std::string compress_chunk(std::string_view bytes) {
  constexpr int kLevel = 1;  // the next ones save a tenth, and take twice as long
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0 || size >= bytes.size()) return {};
  out.resize(size);
  return out;
}

std::optional<std::string> expand_chunk(std::string_view stored, std::uint64_t size) {
  // What the frame itself says is looked at before there is memory for it.
  const std::uint64_t said = ZSTD_getFrameContentSize(stored.data(), stored.size());
  if (said == ZSTD_CONTENTSIZE_ERROR || (said != ZSTD_CONTENTSIZE_UNKNOWN && said != size))
    return std::nullopt;
  std::string out(static_cast<std::size_t>(size), '\0');
  const std::size_t got = ZSTD_decompress(out.data(), out.size(), stored.data(), stored.size());
  if (ZSTD_isError(got) != 0 || got != out.size()) return std::nullopt;
  return out;
}

#else

bool has_zstd() { return false; }
std::string compress_chunk(std::string_view) { return {}; }
std::optional<std::string> expand_chunk(std::string_view, std::uint64_t) { return std::nullopt; }

#endif

}  // namespace thigma::detail
