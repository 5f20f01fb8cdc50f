#include "thigma/depth/height_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <emmintrin.h>

#include "thigma/depth/detail/map_motion.h"
#include "thigma/depth/detail/triangle_rows.h"

namespace thigma {
namespace {

// Between four samples; empty as soon as an empty one takes part.
float interpolate(const float* h, std::ptrdiff_t next, std::ptrdiff_t next_row, float x,
                  float y) noexcept {
  const float left = h[0] + y * (h[next_row] - h[0]);
  const float right = h[next] + y * (h[next_row + next] - h[next]);
  const float height = left + x * (right - left);
  return height < detail::kMixedSample ? kEmptySample : height;
}

// The same for four at once: corners in rows, h[row][column], lane by lane.
__m128 interpolate_four(const __m128 (&h)[2][2], __m128 x, __m128 y) noexcept {
  const __m128 left = _mm_add_ps(h[0][0], _mm_mul_ps(y, _mm_sub_ps(h[1][0], h[0][0])));
  const __m128 right = _mm_add_ps(h[0][1], _mm_mul_ps(y, _mm_sub_ps(h[1][1], h[0][1])));
  const __m128 height = _mm_add_ps(left, _mm_mul_ps(x, _mm_sub_ps(right, left)));
  const __m128 is_mixed = _mm_cmplt_ps(height, _mm_set1_ps(detail::kMixedSample));
  return _mm_or_ps(_mm_and_ps(is_mixed, _mm_set1_ps(kEmptySample)),
                   _mm_andnot_ps(is_mixed, height));
}

// Pairs of neighbours at four places of a row: the first ones, and the second ones.
void load_pairs(const float* row, const std::int32_t (&at)[4], __m128 (&h)[2]) noexcept {
  const auto pair = [&](int i) {
    return _mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(row + at[i]));
  };
  const __m128 even = _mm_unpacklo_ps(pair(0), pair(2)), odd = _mm_unpacklo_ps(pair(1), pair(3));
  h[0] = _mm_unpacklo_ps(even, odd);
  h[1] = _mm_unpackhi_ps(even, odd);
}

// The same weights everywhere.
void shift_map(const HeightMap& map, const detail::MapShift& by, HeightMap& moved) noexcept {
  const auto& [whole, first, last, way] = by;
  const std::ptrdiff_t next = way[0] > 0.0f, next_row = way[1] > 0.0f ? map.columns : 0;
  const __m128 x = _mm_set1_ps(way[0]), y = _mm_set1_ps(way[1]);
  for (int row = first[1]; row < last[1]; ++row) {
    float* out = moved.heights.data() + static_cast<std::ptrdiff_t>(row) * map.columns;
    const float* in =
        map.heights.data() + static_cast<std::ptrdiff_t>(row + whole[1]) * map.columns + whole[0];
    int i = first[0];
    for (; i + 4 <= last[0]; i += 4)
      _mm_storeu_ps(out + i, interpolate_four({{_mm_loadu_ps(in + i), _mm_loadu_ps(in + i + next)},
                                               {_mm_loadu_ps(in + i + next_row),
                                                _mm_loadu_ps(in + i + next_row + next)}},
                                              x, y));
    for (; i < last[0]; ++i) out[i] = interpolate(in + i, next, next_row, way[0], way[1]);
  }
}

// Narrows low..high to the k with 0 <= start + k step <= last.
void narrow(double start, double step, double last, double& low, double& high) noexcept {
  if (step == 0.0) {
    if (start < 0.0 || start > last) high = low - 1.0;
    return;
  }
  const double a = -start / step, b = (last - start) / step;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
}

// Positions along a row, held within the map [cells].
__m128 line_at(float start, float by, float last, __m128 steps) noexcept {
  const __m128 at = _mm_add_ps(_mm_set1_ps(start), _mm_mul_ps(steps, _mm_set1_ps(by)));
  return _mm_min_ps(_mm_max_ps(at, _mm_setzero_ps()), _mm_set1_ps(last));
}

// The map between samples at four places.
__m128 read_four(const HeightMap& map, __m128 x, __m128 y) noexcept {
  const auto before = [](__m128 at, int count) {
    return _mm_min_ps(_mm_cvtepi32_ps(_mm_cvttps_epi32(at)),
                      _mm_set1_ps(static_cast<float>(count - 2)));
  };
  const __m128 column = before(x, map.columns), row = before(y, map.rows);
  // Exact: maps have at most 4096 x 4096 samples.
  const __m128 index =
      _mm_add_ps(_mm_mul_ps(row, _mm_set1_ps(static_cast<float>(map.columns))), column);
  alignas(16) std::int32_t at[4];
  _mm_store_si128(reinterpret_cast<__m128i*>(at), _mm_cvttps_epi32(index));
  __m128 h[2][2];
  load_pairs(map.heights.data(), at, h[0]);
  load_pairs(map.heights.data() + map.columns, at, h[1]);
  return interpolate_four(h, _mm_sub_ps(x, column), _mm_sub_ps(y, row));
}

void turn_map(const HeightMap& map, const MapGrid& grid, const PlaneMotion& motion,
              HeightMap& moved) noexcept {
  const detail::MapTurn turn = detail::map_turn(grid, motion);
  const Vec2& by_column = turn.by_column;
  const float last_x = static_cast<float>(map.columns - 1),
              last_y = static_cast<float>(map.rows - 1);
  const float by_x = static_cast<float>(by_column.x()), by_y = static_cast<float>(by_column.y());
  for (int row = 0; row < map.rows; ++row) {
    const Vec2 start = turn.old(grid.at(0, row));  // where sample (0, row) was [cells]
    double low = 0.0, high = map.columns - 1;
    narrow(start.x(), by_column.x(), map.columns - 1, low, high);
    narrow(start.y(), by_column.y(), map.rows - 1, low, high);
    const float start_x = static_cast<float>(start.x()), start_y = static_cast<float>(start.y());
    float* out = moved.heights.data() + static_cast<std::ptrdiff_t>(row) * map.columns;
    const int last = static_cast<int>(std::floor(high));
    for (int k = static_cast<int>(std::ceil(low)); k <= last; k += 4) {
      const __m128 steps =
          _mm_add_ps(_mm_set1_ps(static_cast<float>(k)), _mm_setr_ps(0.0f, 1.0f, 2.0f, 3.0f));
      const __m128 heights = read_four(map, line_at(start_x, by_x, last_x, steps),
                                       line_at(start_y, by_y, last_y, steps));
      alignas(16) float four[4];
      _mm_store_ps(four, heights);
      std::copy_n(four, std::min(4, last + 1 - k), out + k);
    }
  }
}

}  // namespace

void render_heights(const ProjectedPatch& patch, const MapGrid& grid, const MapReading& reading,
                    HeightMap& map) noexcept {
  map.columns = grid.columns;
  map.rows = grid.rows;
  map.heights.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows),
                     kEmptySample);
  detail::raise_triangles(patch, grid, reading, map);
}

MapMaximum largest_sum(const HeightMap& a, const HeightMap& b) noexcept {
  const std::size_t count = a.heights.size(), whole = count - count % 8;
  const float *x = a.heights.data(), *y = b.heights.data();
  const auto four = [&](std::size_t i) {
    return _mm_add_ps(_mm_loadu_ps(x + i), _mm_loadu_ps(y + i));
  };
  __m128 even = _mm_set1_ps(2.0f * kEmptySample), odd = even;
  for (std::size_t i = 0; i < whole; i += 8) {
    even = _mm_max_ps(even, four(i));
    odd = _mm_max_ps(odd, four(i + 4));
  }
  float lanes[4];
  _mm_storeu_ps(lanes, _mm_max_ps(even, odd));
  MapMaximum found;
  found.sum = *std::max_element(lanes, lanes + 4);
  for (std::size_t i = whole; i < count; ++i) found.sum = std::max(found.sum, x[i] + y[i]);
  if (!(found.sum > 0.5f * kEmptySample)) return found;
  const __m128 sought = _mm_set1_ps(found.sum);
  std::size_t i = 0;
  while (i < whole && _mm_movemask_ps(_mm_cmpeq_ps(four(i), sought)) == 0) i += 4;
  while (x[i] + y[i] != found.sum) ++i;
  found.column = static_cast<int>(i) % a.columns;
  found.row = static_cast<int>(i) / a.columns;
  return found;
}

void move_map(const HeightMap& map, const MapGrid& grid, const PlaneMotion& motion,
              HeightMap& moved) noexcept {
  moved.columns = map.columns;
  moved.rows = map.rows;
  moved.heights.assign(map.heights.size(), kEmptySample);
  if (motion.turn == 0.0) {
    shift_map(map, detail::map_shift(grid, motion.shift), moved);
  } else {
    turn_map(map, grid, motion, moved);
  }
}

}  // namespace thigma
