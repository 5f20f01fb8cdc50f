#pragma once
// Bytes made shorter by zstd, for recordings and kept levels of detail.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thigma {

/// Whether this build has zstd (libzstd-dev).
bool has_zstd();

/// The bytes as a frame of zstd; "" where that is not shorter, or this build has no zstd. The same
/// bytes give the same ones with the same version of zstd.
/// level    of zstd: 1 is the fastest, of text; 3 saves a tenth more of binary numbers
/// Thread   [any]
std::string compress(std::string_view bytes, int level = 1);

/// How long a frame says that its content is [byte]; none where it is no frame or does not say.
std::optional<std::uint64_t> expanded_size(std::string_view frame);

/// The content of a frame, `size` bytes of it; none where it is damaged or of another size, or this
/// build has no zstd. No memory is taken where the frame itself says another size.
/// Thread   [any]
std::optional<std::string> expand(std::string_view frame, std::uint64_t size);

}  // namespace thigma
