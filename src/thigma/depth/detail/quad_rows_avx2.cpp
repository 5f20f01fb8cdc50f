// Rows by quads, eight samples at a time. Compiled with AVX2, called only where the
// processor has it; includes only what is safe to compile so.
#include <immintrin.h>

#include "thigma/depth/detail/quad_rows.h"

namespace thigma::detail {
namespace {

__m256 lanes_from(int k) {
  return _mm256_add_ps(_mm256_set1_ps(static_cast<float>(k)),
                       _mm256_setr_ps(0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f));
}

// Two quads, of cells i and j.
__m128i load_two(const std::uint16_t* quads, const std::int32_t* cell, int i, int j) {
  const auto at = [&](int k) {
    return reinterpret_cast<const char*>(quads) + 8 * static_cast<std::int64_t>(cell[k]);
  };
  const __m128d first = _mm_load_sd(reinterpret_cast<const double*>(at(i)));
  return _mm_castpd_si128(_mm_loadh_pd(first, reinterpret_cast<const double*>(at(j))));
}

// Quads of eight cells, corner by corner.
struct Corners {
  __m256i first, right, below, across;
};

Corners load_eight(const std::uint16_t* quads, const std::int32_t* cell) {
  const auto four = [&](int low, int high) {
    return _mm256_inserti128_si256(_mm256_castsi128_si256(load_two(quads, cell, low, low + 1)),
                                   load_two(quads, cell, high, high + 1), 1);
  };
  const __m256i a = four(0, 4), b = four(2, 6), zero = _mm256_setzero_si256();
  const __m256i even = _mm256_unpacklo_epi16(a, b), odd = _mm256_unpackhi_epi16(a, b);
  const __m256i top = _mm256_unpacklo_epi16(even, odd), bottom = _mm256_unpackhi_epi16(even, odd);
  return {_mm256_unpacklo_epi16(top, zero), _mm256_unpackhi_epi16(top, zero),
          _mm256_unpacklo_epi16(bottom, zero), _mm256_unpackhi_epi16(bottom, zero)};
}

// What all rows of a triangle share, in registers: stores to the map could otherwise change it.
struct Lanes {
  __m256 by_h, by_step;
  const std::uint16_t* quads;
};

// Heights of eight samples of a row from the i-th on; which of them lie over mixed cells.
__m256 heights(const QuadBatch& batch, const Lanes& s, int place, __m256 coarse, __m256i& mixed) {
  const Corners corners = load_eight(s.quads, batch.cell + place);
  mixed = _mm256_cmpeq_epi32(corners.first, _mm256_set1_epi32(kMixedQuad));
  const __m256 first = _mm256_cvtepi32_ps(corners.first), right = _mm256_cvtepi32_ps(corners.right);
  const __m256 ax = _mm256_loadu_ps(batch.ax + place), ay = _mm256_loadu_ps(batch.ay + place);
  const __m256 at_left = _mm256_add_ps(
      first, _mm256_mul_ps(ay, _mm256_sub_ps(_mm256_cvtepi32_ps(corners.below), first)));
  const __m256 at_right = _mm256_add_ps(
      right, _mm256_mul_ps(ay, _mm256_sub_ps(_mm256_cvtepi32_ps(corners.across), right)));
  const __m256 steps = _mm256_add_ps(at_left, _mm256_mul_ps(ax, _mm256_sub_ps(at_right, at_left)));
  return _mm256_add_ps(coarse, _mm256_mul_ps(steps, s.by_step));
}

// Eight samples of a row, or fewer, of which some may lie over mixed cells. Coordinates are held
// within the map, so lanes beyond the end read what is there; what they write is what was there.
__attribute__((noinline)) void raise_some(const QuadTriangle& t, const QuadRow& row, int i,
                                          __m256 height, __m256i is_mixed) {
  float* const out = row.out + row.first + i;
  const int count = row.count - i < 8 ? row.count - i : 8;
  const __m256i is_of_row =
      _mm256_cmpgt_epi32(_mm256_set1_epi32(count), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  const __m256 raised = _mm256_castsi256_ps(_mm256_andnot_si256(is_mixed, is_of_row));
  if (t.end - out >= 8) {
    const __m256 old = _mm256_loadu_ps(out);
    _mm256_storeu_ps(out, _mm256_blendv_ps(old, _mm256_max_ps(height, old), raised));
  } else {
    alignas(32) float heights[8];
    _mm256_store_ps(heights, height);
    const int lanes = _mm256_movemask_ps(raised);
    for (int k = 0; k < count; ++k)
      if ((lanes >> k) & 1) out[k] = heights[k] > out[k] ? heights[k] : out[k];
  }
  int mixed = _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_and_si256(is_mixed, is_of_row)));
  for (; mixed != 0; mixed &= mixed - 1)
    raise_mixed_sse2(t, row, row.first + i + __builtin_ctz(static_cast<unsigned>(mixed)));
}

// Does eight samples at a time, the last ones once more with some of what was done, which changes
// nothing: eight(i) for those from the i-th on.
template <class Eight>
inline __attribute__((always_inline)) void in_eights(int count, const Eight& eight) {
  int i = 0;
  for (; i + 8 <= count; i += 8) eight(i);
  if (i < count) eight(count < 8 ? 0 : count - 8);
}

}  // namespace

void locate_avx2(QuadBatch& batch) noexcept {
  const QuadTriangle& t = batch.triangle;
  const auto all = [](float value) { return _mm256_set1_ps(value); };
  const __m256 zero = _mm256_setzero_ps(), by_x = all(t.by_x), by_y = all(t.by_y),
               high_x = all(t.high_x), high_y = all(t.high_y);
  const __m256i row_cells = _mm256_set1_epi32(t.quad_row);
  const char* const quads = reinterpret_cast<const char*>(t.quads);
  int begin = 0;
  const QuadRow* const last = batch.rows + batch.row_count;
  for (const QuadRow* row = batch.rows; row != last; ++row) {
    const __m256 start_x = all(row->x), start_y = all(row->y);
    const int first = row->first;
    in_eights(row->count, [&](int i) {
      const __m256 steps = lanes_from(first + i);
      __m256 x = _mm256_add_ps(start_x, _mm256_mul_ps(steps, by_x));
      __m256 y = _mm256_add_ps(start_y, _mm256_mul_ps(steps, by_y));
      x = _mm256_min_ps(_mm256_max_ps(x, zero), high_x);
      y = _mm256_min_ps(_mm256_max_ps(y, zero), high_y);
      const __m256i column = _mm256_cvttps_epi32(x), line = _mm256_cvttps_epi32(y);
      const int place = begin + i;
      _mm256_storeu_ps(batch.ax + place, _mm256_sub_ps(x, _mm256_cvtepi32_ps(column)));
      _mm256_storeu_ps(batch.ay + place, _mm256_sub_ps(y, _mm256_cvtepi32_ps(line)));
      const __m256i cells = _mm256_add_epi32(_mm256_mullo_epi32(line, row_cells), column);
      std::int32_t* const cell = batch.cell + place;
      _mm256_storeu_si256(reinterpret_cast<__m256i*>(cell), cells);
#pragma GCC unroll 8
      for (int k = 0; k < 8; ++k)
        _mm_prefetch(quads + 8 * static_cast<std::int64_t>(cell[k]), _MM_HINT_T0);
    });
    begin += row->count;
  }
}

void raise_avx2(const QuadBatch& batch) noexcept {
  const QuadTriangle& t = batch.triangle;
  const Lanes lanes{_mm256_set1_ps(t.by_h), _mm256_set1_ps(t.by_step), t.quads};
  int begin = 0;
  const QuadRow* const last = batch.rows + batch.row_count;
  for (const QuadRow* row = batch.rows; row != last; ++row) {
    const __m256 h = _mm256_set1_ps(row->h);
    const int first = row->first, count = row->count;
    float* const out = row->out + first;
    in_eights(count, [&](int i) {
      __m256i mixed;
      const __m256 coarse = _mm256_add_ps(h, _mm256_mul_ps(lanes_from(first + i), lanes.by_h));
      const __m256 height = heights(batch, lanes, begin + i, coarse, mixed);
      if (count >= 8 && _mm256_testz_si256(mixed, mixed)) {
        // The order of the operands is that of the scalar comparison.
        _mm256_storeu_ps(out + i, _mm256_max_ps(height, _mm256_loadu_ps(out + i)));
      } else {
        raise_some(t, *row, i, height, mixed);
      }
    });
    begin += count;
  }
}

}  // namespace thigma::detail
