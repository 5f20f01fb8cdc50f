#include "thigma/depth/height_map.h"

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

#include "thigma/depth/detail/quad_rows.h"

namespace thigma {
namespace {

ProjectedPatch projected(const test::PlateContact& p, Facing facing) {
  const TexturedPatch& side = facing == Facing::along ? p.contact.object : p.contact.scene;
  ProjectedPatch patch;
  project_patch({side.texture, side.triangles, side.world_from_body},
                contact_frame(p.contact.point, p.contact.normal), facing, patch);
  return patch;
}

/// To first order, by trying all triangles; kNoSurface where none lies.
double first_order(const ProjectedPatch& patch, const Vec2& at) {
  double height = kNoSurface;
  for (const ProjectedTriangle& t : patch.triangles)
    if (test::barycentric(t.at[0], t.at[1], t.at[2], at).minCoeff() >= -1e-9)
      height = std::max(height, height_on(patch, t, at));
  return height;
}

std::vector<detail::HeightSpan> random_spans(Random& random, const HapticTexture& texture,
                                             std::vector<float>& out) {
  std::vector<detail::HeightSpan> spans;
  for (int i = 0; i < 200; ++i) {
    detail::HeightSpan s;
    s.texels = &texture.texels[0].x;
    s.texel_row = texture.width + 1;
    s.high_x = static_cast<float>(texture.width - 1);
    s.high_y = static_cast<float>(texture.height - 1);
    s.x = static_cast<float>(random.uniform(-3.0, texture.width));
    s.y = static_cast<float>(random.uniform(-3.0, texture.height));
    s.by_x = static_cast<float>(random.uniform(-2.0, 2.0));
    s.by_y = static_cast<float>(random.uniform(-2.0, 2.0));
    s.h = static_cast<float>(random.uniform(-1e-3, 1e-3));
    s.by_h = static_cast<float>(random.uniform(-1e-5, 1e-5));
    for (float& m : s.m) m = static_cast<float>(random.uniform(-1.0, 1.0));
    s.first = static_cast<int>(random.below(9));
    s.count = static_cast<int>(random.below(40));
    s.out = out.data();
    spans.push_back(s);
  }
  return spans;
}

TEST(HeightSpan, every_width_gives_the_same_bits) {
  Random random(1);
  const HapticTexture texture = make_texture(test::plate_source(random, {.noise = 1e-4}), "t");
  std::vector<float> scalar(64), sse2(64), avx2(64);
  for (detail::HeightSpan s : random_spans(random, texture, scalar)) {
    for (std::vector<float>* out : {&scalar, &sse2, &avx2})
      std::fill(out->begin(), out->end(), kEmptySample);
    s.out = scalar.data();
    detail::raise_span_scalar(s);
    s.out = sse2.data();
    detail::raise_span_sse2(s);
    EXPECT_EQ(scalar, sse2);
    if (!__builtin_cpu_supports("avx2")) continue;
    s.out = avx2.data();
    detail::raise_span_avx2(s);
    EXPECT_EQ(scalar, avx2);
    for (int k = 0; k < 64; ++k) {
      const bool is_in = k >= s.first && k < s.first + s.count;
      EXPECT_EQ(scalar[static_cast<std::size_t>(k)] > kEmptySample, is_in) << k;
    }
  }
}

/// Rows over a texture, in one batch.
detail::QuadBatch random_batch(Random& random, const HapticTexture& texture,
                               std::vector<float>& out) {
  const std::vector<detail::HeightSpan> spans = random_spans(random, texture, out);
  detail::QuadBatch batch;
  detail::QuadTriangle& t = batch.triangle;
  t.texels = spans.front();
  t.quads = texture.quads.cells.front().steps.data();
  t.quad_row = texture.width;
  t.high_x = t.texels.high_x;
  t.high_y = t.texels.high_y;
  t.by_x = t.texels.by_x;
  t.by_y = t.texels.by_y;
  t.by_h = t.texels.by_h;
  t.by_step = static_cast<float>(random.uniform(1e-9, 1e-8));
  while (batch.row_count < detail::QuadBatch::kRows &&
         batch.sample_count < detail::QuadBatch::kFull) {
    const detail::HeightSpan& span = spans[static_cast<std::size_t>(batch.row_count)];
    float* const row = out.data() + 64 * batch.row_count;
    batch.sample_count += span.count;
    batch.rows[batch.row_count++] = {span.x,     span.y,     span.h, 0.5f * span.h,
                                     span.first, span.count, row};
  }
  return batch;
}

TEST(QuadRows, every_width_gives_the_same_bits_mixed_cells_among_them) {
  Random random(7);
  HapticTexture texture = make_texture(test::plate_source(random, {.noise = 1e-4}), "t");
  for (HeightQuad& quad : texture.quads.cells) {
    for (std::uint16_t& steps : quad.steps) steps = static_cast<std::uint16_t>(random.below(65535));
    if (random.uniform() < 0.03) quad.steps[0] = kMixedCell;
  }
  constexpr std::size_t kOut = 64 * detail::QuadBatch::kRows;
  std::vector<float> before(kOut), scalar, sse2, avx2;
  for (int i = 0; i < 300; ++i) {
    for (float& h : before)
      h = random.uniform() < 0.5 ? kEmptySample : static_cast<float>(random.uniform(-1e-3, 1e-3));
    detail::QuadBatch batch = random_batch(random, texture, before);
    const auto raised = [&](auto locate, auto raise) {
      std::vector<float> out = before;
      for (int row = 0; row < batch.row_count; ++row) batch.rows[row].out = out.data() + 64 * row;
      batch.triangle.end = out.data() + out.size();
      locate(batch);
      raise(batch);
      return out;
    };
    scalar = raised(detail::locate_scalar, detail::raise_scalar);
    sse2 = raised(detail::locate_sse2, detail::raise_sse2);
    EXPECT_EQ(scalar, sse2);
    for (int row = 0; row < batch.row_count; ++row) {
      const detail::QuadRow& r = batch.rows[row];
      for (int k = 0; k < 64; ++k) {
        const std::size_t at = static_cast<std::size_t>(64 * row + k);
        const bool is_in = k >= r.first && k < r.first + r.count;
        EXPECT_TRUE(is_in ? scalar[at] > kEmptySample : scalar[at] == before[at]);
      }
    }
    if (!__builtin_cpu_supports("avx2")) continue;
    avx2 = raised(detail::locate_avx2, detail::raise_avx2);
    EXPECT_EQ(scalar, avx2);
  }
}

TEST(HeightMap, holds_the_heights_of_the_patch_and_no_cracks) {
  Random random(2);
  int covered = 0;
  for (int i = 0; i < 20; ++i) {
    const test::PlateContact p(random, {.cells = 1 + i % 5, .bend = 2.0, .noise = 1e-4});
    const ProjectedPatch patch = projected(p, i % 2 ? Facing::along : Facing::against);
    const MapGrid grid{{Vec2(-0.013, -0.012), Vec2(0.012, 0.014)}, 37 + i, 50};
    HeightMap map;
    render_heights(patch, grid, {.has_quads = false}, map);
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const float got = map.heights[static_cast<std::size_t>(row * grid.columns + column)];
        const double want = first_order(patch, grid.at(column, row));
        if (want == kNoSurface) {
          // Rows and columns within a millionth of a cell of an edge may count.
          const Vec2 inward = -1e-5 * grid.spacing().cwiseProduct(grid.at(column, row).cwiseSign());
          if (first_order(patch, grid.at(column, row) + inward) == kNoSurface) {
            EXPECT_EQ(got, kEmptySample);
          }
          continue;
        }
        ASSERT_NEAR(static_cast<double>(got), want, 2e-8)
            << column << ' ' << row;  // 1e-6 of the size
        ++covered;
      }
    }
  }
  EXPECT_GT(covered, 10000);
}

TEST(HeightMap, scalar_and_widest_agree_on_every_bit) {
  Random random(3);
  for (int i = 0; i < 30; ++i) {
    const test::PlateContact p(random, {.cells = 1 + i % 5, .bend = 2.0});
    const ProjectedPatch patch = projected(p, Facing::along);
    const MapGrid grid{patch.box, 50, 50};
    HeightMap scalar, widest;
    for (const bool has_quads : {true, false}) {
      render_heights(patch, grid, {SpanWidth::scalar, has_quads}, scalar);
      render_heights(patch, grid, {SpanWidth::widest, has_quads}, widest);
      EXPECT_EQ(scalar.heights, widest.heights);
    }
  }
}

/// Largest difference between maps by quads and by displacements, by what quads may add.
double off_by_quads(const ProjectedPatch& patch, const MapGrid& grid) {
  HeightMap quads, texels;
  render_heights(patch, grid, {}, quads);
  render_heights(patch, grid, {.has_quads = false}, texels);
  // Over the cosine, at most 1 / 0.1 where a triangle is still seen; plain rounding beside it.
  double steepest = 1.0, largest = 0.0;
  for (const ProjectedTriangle& t : patch.triangles)
    steepest = std::max(steepest, t.carried.norm());
  const double range = patch.texture->quads.step * kMostSteps;
  for (std::size_t i = 0; i < quads.heights.size(); ++i) {
    EXPECT_EQ(quads.heights[i] == kEmptySample, texels.heights[i] == kEmptySample);
    if (texels.heights[i] == kEmptySample) continue;
    largest =
        std::max(largest, static_cast<double>(std::fabs(quads.heights[i] - texels.heights[i])));
  }
  return (largest - 5e-9) / (steepest * range / 65536.0);
}

TEST(HeightMap, of_quads_is_within_a_65536th_of_the_range_of_that_of_displacements) {
  Random random(8);
  double largest = 0.0;
  int of_one_direction = 0;
  for (int i = 0; i < 60; ++i) {
    const test::PlateContact p(random, {.cells = 1 + i % 5,
                                        .texels = 20 + i,
                                        .bend = i % 3 ? 20.0 : 0.0,
                                        .noise = i % 2 ? 1e-4 : 0.0});
    const ProjectedPatch patch = projected(p, i % 4 < 2 ? Facing::along : Facing::against);
    of_one_direction += !patch.texture->quads.along.isZero();
    const MapGrid grid{{Vec2(-0.013, -0.012), Vec2(0.012, 0.014)}, 37 + i, 90};
    largest = std::max(largest, off_by_quads(patch, grid));
  }
  EXPECT_LE(largest, 1.0);
  EXPECT_GT(largest, 0.1);
  EXPECT_GT(of_one_direction, 10);
  EXPECT_LT(of_one_direction, 50);
}

HeightMap random_map(Random& random, int columns, int rows, double empty) {
  HeightMap map{columns, rows, {}};
  for (int i = 0; i < columns * rows; ++i)
    map.heights.push_back(
        random.uniform() < empty ? kEmptySample : static_cast<float>(random.uniform(-1e-3, 1e-3)));
  return map;
}

TEST(HeightMap, largest_sum_is_the_first_of_the_largest) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const int columns = 1 + static_cast<int>(random.below(20)),
              rows = 1 + static_cast<int>(random.below(20));
    HeightMap a = random_map(random, columns, rows, 0.3),
              b = random_map(random, columns, rows, 0.3);
    if (i % 3 == 0) {  // ties
      for (float& h : a.heights) h = h > 0.0f ? 1.0f : h;
      for (float& h : b.heights) h = h > 0.0f ? 1.0f : h;
    }
    float best = 0.5f * kEmptySample;
    int where = -1;
    for (int k = 0; k < columns * rows; ++k) {
      const float sum =
          a.heights[static_cast<std::size_t>(k)] + b.heights[static_cast<std::size_t>(k)];
      if (sum > best) {
        best = sum;
        where = k;
      }
    }
    const MapMaximum got = largest_sum(a, b);
    EXPECT_EQ(got.column < 0, where < 0);
    if (where < 0) continue;
    EXPECT_EQ(got.sum, best);
    EXPECT_EQ(got.row * columns + got.column, where);
  }
}

TEST(HeightMap, shift_by_whole_cells_is_exact) {
  Random random(5);
  const HeightMap map = random_map(random, 13, 9, 0.1);
  const MapGrid grid{{Vec2(-0.1, 0.3), Vec2(1.2, 1.2)}, 13, 9};
  HeightMap moved;
  for (int dx = -14; dx <= 14; ++dx) {
    for (int dy = -10; dy <= 10; ++dy) {
      move_map(map, grid, {.shift = grid.spacing().cwiseProduct(Vec2(dx, dy))}, moved);
      for (int row = 0; row < 9; ++row) {
        for (int column = 0; column < 13; ++column) {
          const int i = column - dx, j = row - dy;
          const bool is_inside = i >= 0 && j >= 0 && i < 13 && j < 9;
          const float want =
              is_inside ? map.heights[static_cast<std::size_t>(j * 13 + i)] : kEmptySample;
          ASSERT_EQ(moved.heights[static_cast<std::size_t>(row * 13 + column)], want)
              << dx << ' ' << dy;
        }
      }
    }
  }
}

// A plane is interpolated without error, so that it shows where samples are read.
TEST(HeightMap, turned_and_shifted_map_reads_where_the_motion_came_from) {
  Random random(6);
  const MapGrid grid{{Vec2(-1.0, -0.8), Vec2(1.2, 1.0)}, 40, 31};
  const Vec2 slope(0.3, -0.2);
  HeightMap map{40, 31, {}}, moved;
  for (int k = 0; k < 40 * 31; ++k)
    map.heights.push_back(static_cast<float>(slope.dot(grid.at(k % 40, k / 40))));
  for (int i = 0; i < 50; ++i) {
    const PlaneMotion motion{{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)},
                             i % 5 ? random.uniform(-0.3, 0.3) : 0.0,
                             {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)}};
    move_map(map, grid, motion, moved);
    const Eigen::Rotation2Dd back(-motion.turn);
    int kept = 0;
    for (int k = 0; k < 40 * 31; ++k) {
      const Vec2 from =
          back * (grid.at(k % 40, k / 40) - motion.shift - motion.centre) + motion.centre;
      const Vec2 low = grid.at(0, 0), high = grid.at(39, 30);
      const bool is_inside =
          (from.array() >= low.array() - 1e-9).all() && (from.array() <= high.array() + 1e-9).all();
      const float got = moved.heights[static_cast<std::size_t>(k)];
      if (!is_inside) {
        EXPECT_EQ(got, kEmptySample);
        continue;
      }
      ++kept;
      EXPECT_NEAR(static_cast<double>(got), slope.dot(from), 1e-6);
    }
    if (motion.turn == 0.0) {
      EXPECT_GT(kept, 500);
    }
  }
}

TEST(HeightMap, interpolation_with_an_empty_sample_is_empty) {
  const MapGrid grid{{Vec2(0, 0), Vec2(3, 3)}, 3, 3};
  HeightMap map{3, 3, std::vector<float>(9, 1.0f)}, moved;
  map.heights[4] = kEmptySample;
  move_map(map, grid, {.shift = Vec2(1e-4, 0.0)}, moved);
  EXPECT_EQ(moved.heights[4], kEmptySample);
  EXPECT_EQ(moved.heights[5], kEmptySample);
  EXPECT_EQ(moved.heights[1], 1.0f);
  EXPECT_EQ(moved.heights[0], kEmptySample);  // came from outside
}

}  // namespace
}  // namespace thigma
