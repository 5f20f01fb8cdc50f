#pragma once
// Chunks of MCAP files, shorter: zstd, which the specification names and its readers open.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thigma::detail {

inline constexpr std::string_view kZstd = "zstd";  // the specification's name

/// Whether this build has zstd (libzstd-dev).
bool has_zstd();

/// The bytes compressed; "" where that is not shorter, or this build has no zstd. The same bytes
/// give the same ones with the same version of zstd.
std::string compress_chunk(std::string_view bytes);

/// What was compressed, `size` bytes of it; none where the bytes are damaged, are no such size, or
/// this build has no zstd.
std::optional<std::string> expand_chunk(std::string_view stored, std::uint64_t size);

}  // namespace thigma::detail
