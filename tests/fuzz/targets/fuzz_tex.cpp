#include <cmath>

#include "fuzz/fuzz_target.h"

#include "thigma/texture/texture_file.h"

namespace thigma::fuzz {

void fuzz_tex(Bytes bytes) {
  TextureAsset asset;
  if (!is_taken("texture", [&] { asset = parse_texture(text_of(bytes), "texture"); })) return;
  require(std::isfinite(asset.texture.amplitude), "the amplitude is finite");
  const std::string written = format_texture(asset);
  require(format_texture(parse_texture(written, "texture")) == written,
          "what is read is written the same");
}

}  // namespace thigma::fuzz
