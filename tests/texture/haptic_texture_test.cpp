#include "thigma/texture/haptic_texture.h"

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

TextureSource flat_source(int width, int height) {
  TextureSource source;
  source.coarse.positions = {{0, 0, 0}, {0.01, 0, 0}, {0.01, 0.01, 0}, {0, 0.01, 0}};
  source.coarse.triangles = {{0, 1, 2}, {0, 2, 3}};
  const double right = width - 0.5, top = height - 0.5;
  source.corners = {{Vec2(-0.5, -0.5), Vec2(right, -0.5), Vec2(right, top)},
                    {Vec2(-0.5, -0.5), Vec2(right, top), Vec2(-0.5, top)}};
  source.width = width;
  source.height = height;
  source.texels.assign(static_cast<std::size_t>(width * height), Texel{});
  return source;
}

std::string refusal(TextureSource source) {
  try {
    make_texture(std::move(source), "rough.tex");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(HapticTexture, texel_size_and_amplitude_are_those_of_the_surface) {
  TextureSource source = flat_source(100, 50);
  for (int i = 0; i < 5000; ++i)
    source.texels[static_cast<std::size_t>(i)].z = 1e-4f * static_cast<float>(i % 7);
  const HapticTexture texture = make_texture(source, "t");
  EXPECT_NEAR(texture.texel_size, std::sqrt(1e-4 / 5000), 1e-12);
  EXPECT_NEAR(texture.amplitude, 3e-4, 1e-10);
}

TEST(HapticTexture, bounds_under_a_triangle_hold_what_is_read_there) {
  Random random(2);
  for (int cells = 1; cells < 6; ++cells) {
    const HapticTexture texture = make_texture(
        test::plate_source(random, {.cells = cells, .texels = 50, .noise = 1e-4}), "t");
    ASSERT_EQ(texture.under.size(), texture.corners.size());
    const TexelBounds& all = texture.pyramid.back().cells.front();
    int smaller = 0;
    for (std::size_t t = 0; t < texture.corners.size(); ++t) {
      const TexelBounds& under = texture.under[t];
      smaller += under.low.z > all.low.z || under.high.z < all.high.z;
      const std::array<Vec2, 3>& c = texture.corners[t];
      for (int i = 0; i < 200; ++i) {
        const double a = random.uniform(), b = random.uniform(0.0, 1.0 - a);
        const Vec3 d = test::lookup(texture, a * c[0] + b * c[1] + (1.0 - a - b) * c[2]);
        const auto is_within = [](double low, double x, double high) {
          return x >= low - 1e-12 && x <= high + 1e-12;
        };
        EXPECT_TRUE(is_within(under.low.x, d.x(), under.high.x));
        EXPECT_TRUE(is_within(under.low.y, d.y(), under.high.y));
        EXPECT_TRUE(is_within(under.low.z, d.z(), under.high.z));
      }
    }
    if (cells == 5) {
      EXPECT_GT(smaller, 0);
    }
  }
}

// Each cell against all texels that may take part in an interpolation within it.
TEST(HapticTexture, every_cell_bounds_its_texels_and_no_more) {
  Random random(1);
  for (const auto& [width, height] :
       {std::pair{1, 1}, {2, 2}, {3, 7}, {64, 64}, {33, 5}, {1, 40}, {20, 19}}) {
    TextureSource source = flat_source(width, height);
    for (Texel& t : source.texels)
      t = {static_cast<float>(random.uniform(-1e-3, 1e-3)), 0.0f,
           static_cast<float>(random.uniform(0.0, 1e-3))};
    const HapticTexture texture = make_texture(source, "t");
    EXPECT_EQ(texture.pyramid.back().cells.size(), 1u);
    int side = 1;
    for (const BoundsLevel& level : texture.pyramid) {
      side *= 2;
      EXPECT_GE(level.columns * side, width - 1);
      EXPECT_GE(level.rows * side, height - 1);
      for (int j = 0; j < level.rows; ++j) {
        for (int i = 0; i < level.columns; ++i) {
          float low = 1.0f, high = -1.0f;
          for (int row = j * side; row <= std::min((j + 1) * side, height - 1); ++row) {
            for (int column = i * side; column <= std::min((i + 1) * side, width - 1); ++column) {
              const Texel& t = source.texels[static_cast<std::size_t>(row * width + column)];
              low = std::min(low, t.x);
              high = std::max(high, t.x);
            }
          }
          const TexelBounds& cell = level.cells[static_cast<std::size_t>(j * level.columns + i)];
          ASSERT_EQ(cell.low.x, low)
              << width << ' ' << height << ' ' << side << ' ' << i << ' ' << j;
          ASSERT_EQ(cell.high.x, high);
          ASSERT_LE(cell.low.z, cell.high.z);
        }
      }
    }
  }
}

TEST(HapticTexture, a_single_texel_and_a_very_wide_map_are_fine) {
  EXPECT_EQ(make_texture(flat_source(1, 1), "t").pyramid.size(), 1u);
  const HapticTexture wide = make_texture(flat_source(kMaxTextureSide, 3), "t");
  EXPECT_EQ(wide.pyramid.back().cells.size(), 1u);
  EXPECT_EQ(wide.amplitude, 0.0);
}

TEST(HapticTexture, plain_surface_has_no_relief) {
  const HapticTexture plain = make_plain_texture(make_box({1, 1, 1}), "box");
  EXPECT_EQ(plain.corners.size(), plain.coarse.triangles.size());
  EXPECT_EQ(plain.amplitude, 0.0);
  EXPECT_THROW(make_plain_texture({}, "nothing"), InputError);
}

TEST(HapticTexture, bad_sources_are_refused_with_what_and_where) {
  const auto expect = [](const TextureSource& source, const char* reason) {
    const std::string message = refusal(source);
    EXPECT_EQ(message.rfind("rough.tex: ", 0), 0u) << message;
    EXPECT_NE(message.find(reason), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  };
  TextureSource source = flat_source(8, 8);
  EXPECT_EQ(refusal(source), "");
  source.corners.clear();
  expect(source, "no texture coordinates");
  source = flat_source(8, 8);
  source.texels.pop_back();
  expect(source, "63 texels");
  source = flat_source(8, 8);
  source.width = 0;
  expect(source, "0 x 8");
  source.width = 20000;
  expect(source, "20000 x 8");
  source.width = source.height = 16384;
  expect(source, "at most 67108864");
  source = flat_source(8, 8);
  source.coarse.triangles.clear();
  expect(source, "no triangle");
  source = flat_source(8, 8);
  source.texels[11].y = std::numeric_limits<float>::quiet_NaN();
  expect(source, "texel 11 is not finite");
  source.texels[11].y = 1.0f;
  expect(source, "texel 11 is farther away");
  source = flat_source(8, 8);
  source.corners[1][2].x() = 7.6;
  expect(source, "triangle 1 leaves the map");
  source.corners[1][2].x() = std::numeric_limits<double>::quiet_NaN();
  expect(source, "triangle 1 leaves the map");
  source = flat_source(8, 8);
  source.corners[0] = {Vec2(0, 0), Vec2(3, 3), Vec2(6, 6)};
  expect(source, "triangle 0 has no area");
  source = flat_source(8, 8);
  source.corners[1] = source.corners[0];
  expect(source, "triangles 0 and 1 overlap at texel");
}

}  // namespace
}  // namespace thigma
