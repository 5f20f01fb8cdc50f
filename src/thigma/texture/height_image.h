#pragma once
// Pictures as heights.

#include <string>
#include <string_view>
#include <vector>

namespace thigma {

/// A grey picture. Row 0 is the top one.
struct HeightImage {
  int width = 0, height = 0;  // pixels
  std::vector<float> values;  // 0 black .. 1 white, row by row
};

/// Reads a PGM, plain (P2) or raw (P5), with up to 65535 greys.
///
/// name      of the file, for messages
/// Thread    [offline]; throws InputError naming the byte for anything damaged, cut off, larger
///           than a texture may be, or with a grey above its maximum. Takes no more memory than a
///           small multiple of the bytes.
/// Source    Netpbm's description of the format.
HeightImage parse_pgm(std::string_view bytes, const std::string& name);

/// True for bytes that start as a PGM does.
bool is_pgm(std::string_view bytes);

}  // namespace thigma
