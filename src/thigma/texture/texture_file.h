#pragma once
// .tex files: haptic textures in bytes. docs/formats.md describes every one of them.

#include <optional>
#include <string>
#include <string_view>

#include "thigma/files/chunk_file.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma {

/// How a .tex file is told from others.
inline constexpr ChunkKind kTextureKind{.magic = {"\x89"
                                                  "HTEX\r\n\x1a",
                                                  8},
                                        .version = 1,
                                        .suffix = ".tex",
                                        .expected = "a haptic texture as `thigma bake` writes it"};

/// What baking measured. Nothing that rendering needs.
struct BakeFigures {
  std::int32_t charts = 0;      // connected pieces of the map
  double distortion_max = 0.0;  // see bake.h [-]
  // see bake.h [m]; none: of a height map
  std::optional<double> fit_error_rms, fit_error_max, crack_max;
};

/// A texture with what is known of it.
struct TextureAsset {
  HapticTexture texture;
  BakeFigures figures;
};

/// The bytes of a .tex file. Same texture, same bytes.
/// Thread  [offline]; no failure for what make_texture leaves.
std::string format_texture(const TextureAsset& asset);

/// Reads what format_texture wrote; sizes and texels are checked as make_texture does.
///
/// name        of the file, for messages
/// unit_scale  lengths are multiplied by it, > 0
/// Thread      [offline]; throws InputError with the reason: cut off, changed, of another version,
///             or lying. Takes no more than a small multiple of the bytes, whatever they claim.
TextureAsset parse_texture(std::string_view bytes, const std::string& name,
                           double unit_scale = 1.0);

/// The same of a file. Throws InputError, too, when it cannot be read.
TextureAsset read_texture(const std::string& path, double unit_scale = 1.0);

/// True for bytes that start as a .tex file does.
bool is_texture(std::string_view bytes);

}  // namespace thigma
