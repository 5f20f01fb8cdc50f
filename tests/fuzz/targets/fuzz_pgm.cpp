#include <cmath>

#include "fuzz/fuzz_target.h"
#include "height_file.h"

namespace thigma::fuzz {

void fuzz_pgm(Bytes bytes) {
  HeightImage image;
  if (!is_taken("picture", [&] { image = app::parse_height_file(text_of(bytes), "picture"); }))
    return;
  require(image.width > 0 && image.height > 0, "a picture has pixels");
  require(image.values.size() ==
              static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
          "every pixel has a value");
  for (const float v : image.values) require(v >= 0.0f && v <= 1.0f, "greys lie from 0 to 1");
}

}  // namespace thigma::fuzz
