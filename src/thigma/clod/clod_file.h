#pragma once
// .clod files: levels of detail in bytes. docs/formats.md describes every one of them.

#include <string>
#include <string_view>

#include "thigma/clod/clod_asset.h"
#include "thigma/files/chunk_file.h"

namespace thigma {

/// How a .clod file is told from others.
inline constexpr ChunkKind kClodKind{.magic = {"\x89"
                                               "CLOD\r\n\x1a",
                                               8},
                                     .version = 1,
                                     .suffix = ".clod",
                                     .expected = "levels of detail as `thigma build` writes them"};

/// The bytes of a .clod file. Same asset, same bytes.
///
/// name    of the file, for messages
/// Thread  [offline]; throws InputError when the asset breaks a promise that reading checks, or
///         does not fit 32-bit indices.
std::string format_clod(const ClodAsset& asset, const std::string& name = "asset");

/// Reads what format_clod wrote.
///
/// name        of the file, for messages
/// unit_scale  lengths are multiplied by it, see scale_asset; > 0
/// returns     an asset whose every index, count and number is in range: no query of it can fail,
///             whatever the bytes. What only the mesh could tell, such as s, h and D, is taken as
///             it stands
/// Thread      [offline]; throws InputError with the reason: cut off, changed, of another version,
///             or lying. Takes no more than a small multiple of the bytes, whatever they claim.
ClodAsset parse_clod(std::string_view bytes, const std::string& name, double unit_scale = 1.0);

/// The same of a file. Throws InputError, too, when it cannot be read.
ClodAsset read_clod(const std::string& path, double unit_scale = 1.0);

/// Writes an asset as a .clod file, whole or not at all. Thread [offline]; IoError.
void write_clod(const ClodAsset& asset, const std::string& path);

/// scale_asset for a factor that a user gave. Throws InputError naming `name` when it is not
/// positive and finite or lengths leave the range of read_mesh.
void scale_clod(ClodAsset& asset, double unit_scale, const std::string& name);

/// True for bytes that start as a .clod file does.
bool is_clod(std::string_view bytes);

}  // namespace thigma
