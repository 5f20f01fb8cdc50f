// Heights in 16 bits against the texels they stand for.
#include <algorithm>
#include <cmath>
#include <limits>

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

Vec3 vector_of(const Texel& t) { return Vec3(t.x, t.y, t.z); }

/// What a cell says of its corners, and what they are: the largest difference, by the range.
struct Error {
  double largest = 0.0;  // of the range
  int cells = 0, mixed = 0;
};

/// along: the direction of heights over a cell; zero where no triangle lies over it.
template <class Along>
Error error_of(const HapticTexture& texture, const Along& along) {
  const HeightQuads& quads = texture.quads;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  Error error;
  const auto for_corners = [&](const auto& visit) {
    for (int row = 0; row < texture.height; ++row) {
      for (int column = 0; column < texture.width; ++column) {
        const Vec3 n = along(column, row);
        const HeightQuad& quad =
            quads.cells[static_cast<std::size_t>(row * texture.width + column)];
        if (n.isZero()) continue;
        for (int k = 0; k < 4; ++k)
          visit(quad, k, n.dot(vector_of(texel_at(texture, column + k % 2, row + k / 2))));
      }
    }
  };
  for_corners([&](const HeightQuad&, int, double height) {
    low = std::min(low, height);
    high = std::max(high, height);
  });
  double largest = 0.0;
  for_corners([&](const HeightQuad& quad, int k, double height) {
    error.cells += k == 0;
    error.mixed += k == 0 && quad.steps[0] == kMixedCell;
    if (quad.steps[0] == kMixedCell) return;
    const double steps = quad.steps[static_cast<std::size_t>(k)];
    largest = std::max(largest, std::fabs(quads.low + quads.step * steps - height));
  });
  // Of the differences the doubles themselves are off by this.
  const double rounding =
      4.0 * std::numeric_limits<double>::epsilon() * std::max(std::fabs(low), std::fabs(high));
  error.largest = std::max(largest - rounding, 0.0) / (high > low ? high - low : 1.0);
  return error;
}

constexpr double kMost = 1.0 / 65536.0;

/// A plate whose texels are heights times a direction.
template <class Height>
HapticTexture plate_along(const Vec3& direction, double size, const Height& height) {
  Random random(1);
  TextureSource source = test::plate_source(
      random, {.size = size, .cells = 1, .texels = 37, .amplitude = 0.0, .bend = 0.0});
  for (std::size_t i = 0; i < source.texels.size(); ++i) {
    const Vec3 d = height(static_cast<int>(i)) * direction;
    source.texels[i] = {static_cast<float>(d.x()), static_cast<float>(d.y()),
                        static_cast<float>(d.z())};
  }
  return make_texture(std::move(source), "plate");
}

// Relief of nanometres and of kilometres, with far outliers, and of a few steps' difference on a
// height that is a million times larger.
TEST(HeightQuads, are_within_a_65536th_of_the_range) {
  Random random(1);
  for (const double scale : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    for (int kind = 0; kind < 4; ++kind) {
      const HapticTexture texture = plate_along(Vec3::UnitZ(), 100.0 * scale, [&](int i) {
        if (kind == 0) return scale * random.uniform(-1.0, 1.0);
        if (kind == 1) return i == 700 ? scale : 1e-7 * scale * random.uniform();
        if (kind == 2) return scale * (1.0 + 1e-6 * (i % 7));
        return i % 2 ? scale : -scale;
      });
      EXPECT_EQ(std::fabs(texture.quads.along.z()), 1.0);
      const Error error = error_of(texture, [&](int, int) { return texture.quads.along; });
      EXPECT_LE(error.largest, kMost) << scale << ' ' << kind;
      EXPECT_EQ(error.mixed, 0);
      EXPECT_EQ(error.cells, 37 * 37);
    }
  }
}

TEST(HeightQuads, of_one_height_hold_it_itself) {
  for (const double height : {0.0, 1e-9, -0.3, 5.0}) {
    const HapticTexture texture = plate_along(Vec3::UnitZ(), 10.0, [&](int) { return height; });
    EXPECT_EQ(texture.quads.step, 0.0);
    EXPECT_EQ(texture.quads.low * texture.quads.along.z(), static_cast<double>(float(height)));
    for (const HeightQuad& quad : texture.quads.cells)
      EXPECT_EQ(quad.steps, (std::array<std::uint16_t, 4>{}));
  }
}

TEST(HeightQuads, lie_along_any_one_direction) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const Vec3 direction = random.in_cube(1.0).normalized();
    const HapticTexture texture =
        plate_along(direction, 0.1, [&](int) { return 1e-3 * random.uniform(-1.0, 1.0); });
    EXPECT_NEAR(std::fabs(texture.quads.along.dot(direction)), 1.0, 1e-6);
    const Error error = error_of(texture, [&](int, int) { return texture.quads.along; });
    EXPECT_LE(error.largest, kMost);
  }
}

// The last row and column are repeated beyond the map, as they are where displacements are read.
TEST(HeightQuads, hold_the_outermost_texels_beyond_the_map) {
  Random random(3);
  const HapticTexture texture =
      plate_along(Vec3::UnitZ(), 0.1, [&](int) { return random.uniform(-1e-3, 1e-3); });
  const int last = texture.width - 1;
  for (int k = 0; k <= last; ++k) {
    const auto at = [&](int column, int row) {
      return texture.quads.cells[static_cast<std::size_t>(row * texture.width + column)].steps;
    };
    EXPECT_EQ(at(last, k)[0], at(last, k)[1]);
    EXPECT_EQ(at(last, k)[2], at(last, k)[3]);
    EXPECT_EQ(at(k, last)[0], at(k, last)[2]);
    EXPECT_EQ(at(k, last)[1], at(k, last)[3]);
  }
}

Vec3 normal_of(const TriangleMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const auto at = [&](std::int32_t i) { return mesh.positions[static_cast<std::size_t>(i)]; };
  return (at(b) - at(a)).cross(at(c) - at(a)).normalized();
}

/// Whether a place of the map is on a triangle.
bool is_on(const std::array<Vec2, 3>& corners, const Vec2& place) {
  return test::barycentric(corners[0], corners[1], corners[2], place).minCoeff() >= 0.0;
}

// Displacements in all directions over triangles of many normals: whatever place on a triangle is
// read, its cell tells the heights along this triangle's normal, or that it is mixed.
TEST(HeightQuads, are_along_the_normal_of_any_triangle_over_their_cell) {
  Random random(4);
  for (int i = 0; i < 10; ++i) {
    const HapticTexture texture = make_texture(
        test::plate_source(random, {.cells = 1 + i % 5, .texels = 50, .bend = 20.0, .noise = 1e-4}),
        "bent");
    EXPECT_TRUE(texture.quads.along.isZero());
    const double range = texture.quads.step * kMostSteps;
    int whole = 0, mixed = 0;
    double largest = 0.0;
    for (int sample = 0; sample < 20000; ++sample) {
      const Vec2 place(random.uniform(0.0, 49.0), random.uniform(0.0, 49.0));
      const int column = static_cast<int>(place.x()), row = static_cast<int>(place.y());
      const HeightQuad& quad = texture.quads.cells[static_cast<std::size_t>(row * 50 + column)];
      for (std::size_t t = 0; t < texture.corners.size(); ++t) {
        if (!is_on(texture.corners[t], place)) continue;
        (quad.steps[0] == kMixedCell ? mixed : whole)++;
        if (quad.steps[0] == kMixedCell) continue;
        for (int k = 0; k < 4; ++k) {
          const double height = normal_of(texture.coarse, t)
                                    .dot(vector_of(texel_at(texture, column + k % 2, row + k / 2)));
          const double steps = quad.steps[static_cast<std::size_t>(k)];
          largest =
              std::max(largest, std::fabs(texture.quads.low + texture.quads.step * steps - height));
        }
      }
    }
    EXPECT_LE(largest, kMost * range);
    EXPECT_GT(whole, 10000);
    // A square of two triangles lies in one plane.
    EXPECT_EQ(mixed > 0, i % 5 > 0);
  }
}

}  // namespace
}  // namespace thigma
