#include "thigma/texture/level_textures.h"

#include "support/wavy_ball.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"
#include "thigma/texture/bake.h"

namespace thigma {
namespace {

/// A ball with waves that its coarser versions cannot have.
TriangleMesh wavy_of(int frequency) { return test::wavy_ball_of(frequency, 0.03, 0.05); }

const std::vector<TriangleMesh>& level_meshes() {
  static const std::vector<TriangleMesh> meshes = {wavy_of(16), wavy_of(8), wavy_of(4)};
  return meshes;
}

const LevelTextures& level_sample() {
  static const LevelTextures textures{
      bake_levels(level_meshes()[0], level_meshes(), {.texels = 96, .samples = 2000}, "ball")};
  return textures;
}

const std::string& level_bytes() {
  static const std::string bytes = format_level_textures(level_sample());
  return bytes;
}

std::string level_complaint(std::string_view bytes, double scale = 1.0) {
  try {
    parse_level_textures(bytes, "a.tex", scale);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("a.tex", 0), 0u) << error.what();
    return error.what();
  }
  return "";
}

TEST(LevelTextures, HoldTheFineSurfaceOnEveryLevel) {
  ASSERT_EQ(level_sample().levels.size(), 3u);
  EXPECT_FALSE(level_sample().levels[0].has_value()) << "the fine surface itself";
  for (std::size_t k = 1; k < 3; ++k) {
    ASSERT_TRUE(level_sample().levels[k].has_value());
    const TextureAsset& level = *level_sample().levels[k];
    EXPECT_EQ(level.texture.coarse.triangles, level_meshes()[k].triangles);
    EXPECT_LT(*level.figures.fit_error_rms, 1e-3 * 0.03) << k;
    EXPECT_LT(*level.figures.fit_error_max, 1e-2 * 0.03) << k;
    EXPECT_GT(level.texture.amplitude, 3.0 * *level.figures.fit_error_rms)
        << "there is something to hold";
  }
  const LevelTextures finer{
      bake_levels(wavy_of(24), level_meshes(), {.texels = 64, .samples = 500}, "ball")};
  EXPECT_TRUE(finer.levels[0].has_value()) << "finer than the finest level";
}

TEST(LevelTextures, GiveBackEveryBitFromAFile) {
  const LevelTextures read = parse_level_textures(level_bytes(), "a.tex");
  EXPECT_EQ(format_level_textures(read), level_bytes());
  EXPECT_EQ(format_level_textures({bake_levels(level_meshes()[0], level_meshes(),
                                               {.texels = 96, .samples = 2000}, "ball")}),
            level_bytes());
  const LevelTextures scaled = parse_level_textures(level_bytes(), "a.tex", 1000.0);
  EXPECT_NEAR(scaled.levels[2]->texture.texel_size,
              1000.0 * level_sample().levels[2]->texture.texel_size, 1e-9);
}

TEST(LevelTextures, RefuseWhatIsCutOffChangedOrLying) {
  std::string bytes = level_bytes();
  for (std::size_t size = 0; size < bytes.size(); size += size < 400 ? 7 : 4001)
    EXPECT_NE(level_complaint(std::string_view(bytes).substr(0, size)), "") << size;
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const std::size_t at = i < 120 ? static_cast<std::size_t>(i) : random.below(bytes.size());
    const int bit = static_cast<int>(random.below(8));
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
    EXPECT_NE(level_complaint(bytes), "") << at << ' ' << bit;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << bit));
  }
  LevelTextures more = level_sample();
  more.levels.resize(2);
  more.levels.push_back(std::nullopt);
  EXPECT_EQ(level_complaint(format_level_textures(more)), "") << "a level may do without";
  EXPECT_NE(
      level_complaint(format_texture(*level_sample().levels[1])).find("no textures of levels"),
      std::string::npos);
  EXPECT_NE(level_complaint(bytes, -1.0), "");
  // The other way round the reason says what to do.
  try {
    parse_texture(level_bytes(), "a.tex");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("beside them in a scene"), std::string::npos)
        << error.what();
  }
}

TEST(LevelTextures, AreRefusedOverOtherLevels) {
  check_level_textures(level_sample(), level_meshes(), "a.tex");
  const auto refuses = [](std::vector<TriangleMesh> meshes, const char* says) {
    try {
      check_level_textures(level_sample(), meshes, "a.tex");
      ADD_FAILURE() << says;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
    }
  };
  std::vector<TriangleMesh> meshes = level_meshes();
  meshes.pop_back();
  refuses(meshes, "2, as the levels of detail have");
  meshes = level_meshes();
  meshes[2].positions[7].x() += 1e-6;
  refuses(meshes, "level 2");
  meshes = level_meshes();
  meshes[1] = wavy_of(7);
  refuses(meshes, "level 1");
}

}  // namespace
}  // namespace thigma
