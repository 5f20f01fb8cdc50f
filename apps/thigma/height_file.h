#pragma once
// Height maps of any file a user names.

#include <string>
#include <string_view>

#include "thigma/texture/height_image.h"

namespace thigma::app {

/// Reads a PGM (8 or 16 bits) or a grey PNG (1 to 16 bits), recognised by content. Greys count as
/// they are stored, without gamma; an alpha channel is left out.
/// Thread  [offline]; throws InputError for anything else, colour among it.
HeightImage read_height_file(const std::string& path);

/// The same of bytes; name: of the file, for messages.
HeightImage parse_height_file(std::string_view bytes, const std::string& name);

}  // namespace thigma::app
