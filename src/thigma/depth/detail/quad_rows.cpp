// Rows by quads: the scalar definition, and four samples at a time.
#include "thigma/depth/detail/quad_rows.h"

#include <emmintrin.h>

namespace thigma::detail {
namespace {

// A height within a quad, in steps.
float steps_in(const std::uint16_t* quad, float ax, float ay) noexcept {
  const float first = quad[0], right = quad[1], below = quad[2], across = quad[3];
  const float at_left = first + ay * (below - first);
  const float at_right = right + ay * (across - right);
  return at_left + ax * (at_right - at_left);
}

// Quads of four cells, corner by corner.
void load_four(const std::uint16_t* quads, const std::int32_t* cell,
               __m128i (&corner)[4]) noexcept {
  const auto quad = [&](int i) {
    return _mm_loadl_epi64(
        reinterpret_cast<const __m128i*>(quads + 4 * static_cast<std::int64_t>(cell[i])));
  };
  const __m128i zero = _mm_setzero_si128();
  const __m128i even = _mm_unpacklo_epi16(quad(0), quad(2)),
                odd = _mm_unpacklo_epi16(quad(1), quad(3));
  const __m128i top = _mm_unpacklo_epi16(even, odd), bottom = _mm_unpackhi_epi16(even, odd);
  corner[0] = _mm_unpacklo_epi16(top, zero);
  corner[1] = _mm_unpackhi_epi16(top, zero);
  corner[2] = _mm_unpacklo_epi16(bottom, zero);
  corner[3] = _mm_unpackhi_epi16(bottom, zero);
}

__m128 lanes_from(int k) noexcept {
  return _mm_add_ps(_mm_set1_ps(static_cast<float>(k)), _mm_setr_ps(0.0f, 1.0f, 2.0f, 3.0f));
}

// A row and the place of its first sample in the batch.
struct RowAt {
  const QuadRow& row;
  int begin = 0;
};

// Four samples of a row from the i-th on.
void raise_four(const QuadBatch& batch, const RowAt& at, int i) noexcept {
  const QuadTriangle& t = batch.triangle;
  const QuadRow& row = at.row;
  __m128i corner[4];
  load_four(t.quads, batch.cell + at.begin + i, corner);
  const __m128 first = _mm_cvtepi32_ps(corner[0]), right = _mm_cvtepi32_ps(corner[1]);
  const __m128 ax = _mm_loadu_ps(batch.ax + at.begin + i),
               ay = _mm_loadu_ps(batch.ay + at.begin + i);
  const __m128 at_left =
      _mm_add_ps(first, _mm_mul_ps(ay, _mm_sub_ps(_mm_cvtepi32_ps(corner[2]), first)));
  const __m128 at_right =
      _mm_add_ps(right, _mm_mul_ps(ay, _mm_sub_ps(_mm_cvtepi32_ps(corner[3]), right)));
  const __m128 steps = _mm_add_ps(at_left, _mm_mul_ps(ax, _mm_sub_ps(at_right, at_left)));
  const __m128 coarse =
      _mm_add_ps(_mm_set1_ps(row.h), _mm_mul_ps(lanes_from(row.first + i), _mm_set1_ps(t.by_h)));
  const __m128 height = _mm_add_ps(coarse, _mm_mul_ps(steps, _mm_set1_ps(t.by_step)));
  const int mixed =
      _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(corner[0], _mm_set1_epi32(kMixedQuad))));
  float* const out = row.out + row.first + i;
  if (mixed == 0 && i + 4 <= row.count) {
    // The order of the operands is that of the scalar comparison.
    _mm_storeu_ps(out, _mm_max_ps(height, _mm_loadu_ps(out)));
    return;
  }
  alignas(16) float heights[4];
  _mm_store_ps(heights, height);
  for (int k = 0; k < 4 && i + k < row.count; ++k) {
    if ((mixed >> k) & 1) {
      raise_mixed_sse2(t, row, row.first + i + k);
    } else {
      out[k] = heights[k] > out[k] ? heights[k] : out[k];
    }
  }
}

}  // namespace

void raise_mixed(const QuadTriangle& triangle, const QuadRow& row, int k) noexcept {
  HeightSpan one = triangle.texels;
  one.x = row.x;
  one.y = row.y;
  one.h = row.h_texels;
  one.first = k;
  one.count = 1;
  one.out = row.out;
  raise_span_scalar(one);
}

void raise_mixed_sse2(const QuadTriangle& triangle, const QuadRow& row, int k) noexcept {
  raise_sample_sse2(triangle.texels, {row.x, row.y, row.h_texels, row.out}, k);
}

void locate_scalar(QuadBatch& batch) noexcept {
  const QuadTriangle& t = batch.triangle;
  int begin = 0;
  for (const QuadRow* row = batch.rows; row != batch.rows + batch.row_count; ++row) {
    for (int i = 0; i < row->count; ++i) {
      const float step = static_cast<float>(row->first + i);
      float x = row->x + step * t.by_x;
      float y = row->y + step * t.by_y;
      x = x > 0.0f ? x : 0.0f;
      x = x < t.high_x ? x : t.high_x;
      y = y > 0.0f ? y : 0.0f;
      y = y < t.high_y ? y : t.high_y;
      const std::int32_t column = static_cast<std::int32_t>(x), line = static_cast<std::int32_t>(y);
      batch.ax[begin + i] = x - static_cast<float>(column);
      batch.ay[begin + i] = y - static_cast<float>(line);
      const std::int32_t cell = line * t.quad_row + column;
      batch.cell[begin + i] = cell;
      __builtin_prefetch(t.quads + 4 * static_cast<std::int64_t>(cell));
    }
    begin += row->count;
  }
}

void raise_scalar(const QuadBatch& batch) noexcept {
  const QuadTriangle& t = batch.triangle;
  int begin = 0;
  for (const QuadRow* row = batch.rows; row != batch.rows + batch.row_count; ++row) {
    for (int i = 0; i < row->count; ++i) {
      const int place = begin + i;
      const std::uint16_t* const quad = t.quads + 4 * static_cast<std::int64_t>(batch.cell[place]);
      if (quad[0] == kMixedQuad) {
        raise_mixed(t, *row, row->first + i);
        continue;
      }
      const float coarse = row->h + static_cast<float>(row->first + i) * t.by_h;
      const float height = coarse + steps_in(quad, batch.ax[place], batch.ay[place]) * t.by_step;
      float& out = row->out[row->first + i];
      out = height > out ? height : out;
    }
    begin += row->count;
  }
}

void locate_sse2(QuadBatch& batch) noexcept {
  const QuadTriangle& t = batch.triangle;
  const auto all = [](float value) { return _mm_set1_ps(value); };
  const __m128 zero = _mm_setzero_ps(), by_x = all(t.by_x), by_y = all(t.by_y),
               high_x = all(t.high_x), high_y = all(t.high_y);
  const __m128i row_cells = _mm_set1_epi32(t.quad_row), low = _mm_set1_epi64x(0xffffffff);
  int begin = 0;
  for (const QuadRow* row = batch.rows; row != batch.rows + batch.row_count; ++row) {
    // Beyond the end of a row those of the next one are written, which come later.
    for (int i = 0; i < row->count; i += 4) {
      const int place = begin + i;
      const __m128 steps = lanes_from(row->first + i);
      __m128 x = _mm_add_ps(all(row->x), _mm_mul_ps(steps, by_x));
      __m128 y = _mm_add_ps(all(row->y), _mm_mul_ps(steps, by_y));
      x = _mm_min_ps(_mm_max_ps(x, zero), high_x);
      y = _mm_min_ps(_mm_max_ps(y, zero), high_y);
      const __m128i column = _mm_cvttps_epi32(x), line = _mm_cvttps_epi32(y);
      _mm_storeu_ps(batch.ax + place, _mm_sub_ps(x, _mm_cvtepi32_ps(column)));
      _mm_storeu_ps(batch.ay + place, _mm_sub_ps(y, _mm_cvtepi32_ps(line)));
      // Products of 32 bits: of the even lanes, then of the odd ones.
      const __m128i even = _mm_and_si128(_mm_mul_epu32(line, row_cells), low),
                    odd = _mm_mul_epu32(_mm_srli_epi64(line, 32), row_cells);
      const __m128i cells = _mm_add_epi32(_mm_or_si128(even, _mm_slli_epi64(odd, 32)), column);
      std::int32_t* const cell = batch.cell + place;
      _mm_storeu_si128(reinterpret_cast<__m128i*>(cell), cells);
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k)
        __builtin_prefetch(t.quads + 4 * static_cast<std::int64_t>(cell[k]));
    }
    begin += row->count;
  }
}

void raise_sse2(const QuadBatch& batch) noexcept {
  int begin = 0;
  for (const QuadRow* row = batch.rows; row != batch.rows + batch.row_count; ++row) {
    for (int i = 0; i < row->count; i += 4) raise_four(batch, {*row, begin}, i);
    begin += row->count;
  }
}

}  // namespace thigma::detail
