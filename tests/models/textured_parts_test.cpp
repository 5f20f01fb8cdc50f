#include "thigma/models/textured_parts.h"

#include <gtest/gtest.h>

#include "thigma/models/textured_model.h"

namespace thigma::models {
namespace {

TEST(TexturedParts, EveryModelIsAClosedSurfaceWithATexture) {
  for (const TexturedInfo& info : textured_models()) {
    const HapticTexture texture = make_textured_model({info.name, 64});
    EXPECT_FALSE(texture.coarse.triangles.empty()) << info.name;
    EXPECT_GT(texture.width, 0) << info.name;
    EXPECT_GT(texture.height, 0) << info.name;
  }
}

}  // namespace
}  // namespace thigma::models
