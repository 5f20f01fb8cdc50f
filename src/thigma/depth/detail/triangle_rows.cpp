#include "thigma/depth/detail/triangle_rows.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <emmintrin.h>

#include "thigma/depth/detail/quad_rows.h"
#include "thigma/depth/detail/triangle_span.h"
#include "thigma/math/plane_cross.h"

namespace thigma::detail {
namespace {

struct Kernels {
  void (*raise_span)(const HeightSpan&) noexcept;
  void (*locate)(QuadBatch&) noexcept;
  void (*raise)(const QuadBatch&) noexcept;
};

const Kernels& kernels_of(SpanWidth width) noexcept {
  static constexpr Kernels kScalar{raise_span_scalar, locate_scalar, raise_scalar},
      kSse2{raise_span_sse2, locate_sse2, raise_sse2},
      kAvx2{raise_span_avx2, locate_avx2, raise_avx2};
  if (width == SpanWidth::scalar) return kScalar;
  return __builtin_cpu_supports("avx2") ? kAvx2 : kSse2;
}

/// Raises rows of quads in batches, each after the cells of the next one are looked for: these come
/// from memory meanwhile.
class QuadRows {
 public:
  explicit QuadRows(const Kernels& kernels) noexcept : kernels_(kernels) {}
  QuadRows(const QuadRows&) = delete;
  QuadRows& operator=(const QuadRows&) = delete;

  void begin(const QuadTriangle& triangle) noexcept {
    pass_on();
    filling_->triangle = triangle;
  }
  /// A row to be set, and then added.
  QuadRow& next() noexcept { return filling_->rows[filling_->row_count]; }
  void add_next() noexcept {
    if (next().count <= QuadBatch::kPart) {  // no copy: it would wait for what was just set
      add_part(next().count);
      return;
    }
    const QuadRow whole = next();
    for (int done = 0; done < whole.count; done += QuadBatch::kPart) {
      QuadRow& part = next();
      part = whole;
      part.first = whole.first + done;
      part.count = std::min(QuadBatch::kPart, whole.count - done);
      add_part(part.count);
    }
  }
  void finish() noexcept {
    pass_on();
    pass_on();
  }

 private:
  void add_part(int samples) noexcept {
    filling_->sample_count += samples;
    ++filling_->row_count;
    if (filling_->row_count < QuadBatch::kRows && filling_->sample_count < QuadBatch::kFull) return;
    const QuadBatch* const full = filling_;
    pass_on();
    filling_->triangle = full->triangle;
  }
  void pass_on() noexcept {
    if (filling_->row_count > 0) kernels_.locate(*filling_);
    if (waiting_->row_count > 0) kernels_.raise(*waiting_);
    waiting_->row_count = waiting_->sample_count = 0;
    std::swap(filling_, waiting_);
  }

  const Kernels& kernels_;
  QuadBatch batches_[2];
  QuadBatch *filling_ = &batches_[0], *waiting_ = &batches_[1];
};

// Two edges of a triangle as lines u(v), of which the first has it on its right and the second on
// its left, with -u in place of u: what lies over the triangle is beyond both.
struct EdgePair {
  __m128d u, v;  // of their first corners
  __m128d by_v;
};

// The edges of a triangle in two pairs, the same twice where there is one on a side. An edge that
// lies within a row bounds no row.
std::array<EdgePair, 2> edge_pairs(const ProjectedTriangle& t) noexcept {
  double u[2][2] = {}, v[2][2] = {}, by_v[2][2] = {};
  int count[2] = {0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2& a = t.at[k];
    const double rise = t.at[(k + 1) % 3].y() - a.y();
    if (rise == 0.0) continue;
    const double by = (t.at[(k + 1) % 3].x() - a.x()) / rise;
    const int side = t.edges[k].y() < 0.0 ? 0 : 1;
    const double sign = side == 0 ? 1.0 : -1.0;
    for (int pair = count[side]++; pair < 2; ++pair) {
      u[pair][side] = sign * a.x();
      v[pair][side] = a.y();
      by_v[pair][side] = sign * by;
    }
  }
  std::array<EdgePair, 2> pairs;
  for (std::size_t k = 0; k < 2; ++k)
    pairs[k] = {_mm_loadu_pd(u[k]), _mm_loadu_pd(v[k]), _mm_loadu_pd(by_v[k])};
  return pairs;
}

__m128d at_height(const EdgePair& pair, __m128d v) noexcept {
  return _mm_add_pd(pair.u, _mm_mul_pd(_mm_sub_pd(v, pair.v), pair.by_v));
}

double inside_of_edge(const ProjectedTriangle& t, std::size_t k, const Vec2& at) noexcept {
  return cross(t.edges[k], at - t.at[k]);
}

std::array<Vec2, 4> corners_of(const PlaneBox& box) noexcept {
  return {box.low, Vec2(box.high.x(), box.low.y()), Vec2(box.low.x(), box.high.y()), box.high};
}

// Whether an edge has all of a box on its other side.
bool is_beside(const ProjectedTriangle& t, const PlaneBox& box) noexcept {
  const std::array<Vec2, 4> corners = corners_of(box);
  for (std::size_t k = 0; k < 3; ++k) {
    double most = inside_of_edge(t, k, corners[0]);
    for (std::size_t i = 1; i < 4; ++i) most = std::max(most, inside_of_edge(t, k, corners[i]));
    if (most < 0.0) return true;
  }
  return false;
}

bool has_inside(const ProjectedTriangle& t, const PlaneBox& box) noexcept {
  for (const Vec2& corner : corners_of(box))
    for (std::size_t k = 0; k < 3; ++k)
      if (!(inside_of_edge(t, k, corner) >= 0.0)) return false;
  return true;
}

/// One triangle over a grid.
class TriangleRows {
 public:
  TriangleRows(const ProjectedTriangle& t, const MapGrid& grid) noexcept
      : low_v_(grid.box.low.y()),
        spacing_v_(grid.spacing().y()),
        per_u_(1.0 / grid.spacing().x()),
        first_u_(grid.at(0, 0).x()),
        columns_(grid.columns) {
    texel_ = {_mm_loadu_pd(t.texel_origin.data()),
              _mm_set_pd(t.texel_by_at(1, 0) * first_u_, t.texel_by_at(0, 0) * first_u_),
              _mm_set_pd(t.texel_by_at(1, 1), t.texel_by_at(0, 1))};
    height_ = {_mm_set1_pd(t.height_origin), _mm_set1_pd(t.height_by_at.x() * first_u_),
               _mm_set1_pd(t.height_by_at.y())};
    std::tie(bottom_, top_) = std::minmax({t.at[0].y(), t.at[1].y(), t.at[2].y()});
    is_whole_ = has_inside(t, grid.box);
    last_row_ = grid.rows - 1;
    if (is_whole_) return;
    edges_ = edge_pairs(t);
    const auto row_of = [&](double v) { return (v - low_v_) / spacing_v_ - 0.5; };
    const Range rows = range_of(_mm_set_pd(row_of(top_), row_of(bottom_)), grid.rows);
    first_row_ = rows.first;
    last_row_ = rows.end - 1;
  }

  int first_row() const noexcept { return first_row_; }
  int last_row() const noexcept { return last_row_; }

  /// Sets the part of a row; false where it has none.
  ///
  /// origin  that the texels are counted from
  /// lowest  of the quads [m]
  bool set_row(int row, const Vec2& origin, double lowest, QuadRow& part) const noexcept {
    const __m128d v = _mm_set1_pd(low_v_ + spacing_v_ * (row + 0.5));
    part.first = 0;
    part.count = columns_;
    if (!is_whole_) {
      set_ends(v, part);
      if (part.count <= 0) return false;
    }
    const __m128d h = height_.at(v), texel = _mm_sub_pd(texel_.at(v), _mm_loadu_pd(origin.data()));
    const __m128d both = _mm_add_pd(h, _mm_set_pd(0.0, lowest));
    alignas(16) float start[4];
    _mm_store_ps(start, _mm_movelh_ps(_mm_cvtpd_ps(texel), _mm_cvtpd_ps(both)));
    part.x = start[0];
    part.y = start[1];
    part.h = start[2];
    part.h_texels = start[3];
    return true;
  }

 private:
  // The first sample of a row on the triangle, and how many there are; none or fewer where there is
  // none.
  void set_ends(__m128d v, QuadRow& part) const noexcept {
    const __m128d within = _mm_min_pd(_mm_max_pd(v, _mm_set1_pd(bottom_)), _mm_set1_pd(top_));
    const __m128d low_high = _mm_max_pd(at_height(edges_[0], within), at_height(edges_[1], within));
    const __m128d turned = _mm_set_pd(-0.0, 0.0);  // -u is u again
    const __m128d u = _mm_xor_pd(low_high, turned);
    const __m128d cells = _mm_mul_pd(_mm_sub_pd(u, _mm_set1_pd(first_u_)), _mm_set1_pd(per_u_));
    const Range samples = range_of(cells, columns_);
    part.first = samples.first;
    part.count = samples.end - samples.first;
  }

  struct Range {
    int first, end;
  };
  // The first of `count` indices from the first place on, and the one after the last up to the
  // second place; within them whatever the places, also where one is no number. Without branches:
  // where rows end nothing foretells.
  static Range range_of(__m128d cells, int count) noexcept {
    const __m128d from = _mm_add_pd(cells, _mm_set_pd(1.0 + kSpanOverlap, -kSpanOverlap));
    const __m128d held = _mm_min_pd(_mm_max_pd(from, _mm_setzero_pd()), _mm_set1_pd(count));
    const __m128i whole = _mm_cvttpd_epi32(held);
    const int is_above = _mm_movemask_pd(_mm_cmpgt_pd(held, _mm_cvtepi32_pd(whole)));
    return {_mm_cvtsi128_si32(whole) + (is_above & 1),
            _mm_cvtsi128_si32(_mm_shuffle_epi32(whole, 1))};
  }

  /// At the first sample of a row: origin + (by_u u + by_v v).
  struct Affine {
    __m128d origin, by_first_u, by_v;
    __m128d at(__m128d v) const noexcept {
      return _mm_add_pd(origin, _mm_add_pd(by_first_u, _mm_mul_pd(by_v, v)));
    }
  };

  Affine texel_, height_;
  double low_v_ = 0.0, spacing_v_ = 1.0, per_u_ = 1.0, first_u_ = 0.0;  // [m], [1/m]
  int columns_ = 0;
  double bottom_ = 0.0, top_ = 0.0;
  int first_row_ = 0, last_row_ = -1;
  bool is_whole_ = false;  // all samples lie on the triangle
  std::array<EdgePair, 2> edges_;
};

void raise_by_texels(const Kernels& kernels, const QuadRow& row, HeightSpan span) noexcept {
  span.x = row.x;
  span.y = row.y;
  span.h = row.h_texels;
  span.first = row.first;
  span.count = row.count;
  span.out = row.out;
  kernels.raise_span(span);
}

}  // namespace

void raise_triangles(const ProjectedPatch& patch, const MapGrid& grid, const MapReading& reading,
                     HeightMap& map) noexcept {
  const Kernels& kernels = kernels_of(reading.width);
  QuadRows quads(kernels);
  for (const ProjectedTriangle& t : patch.triangles) {
    if (!overlap(t.box, grid.box) || is_beside(t, grid.box)) continue;
    const TriangleRows rows(t, grid);
    Vec2 origin;
    double low = 0.0;
    QuadTriangle triangle;
    triangle.texels = start_span(patch, t, {grid.spacing().x(), 0.0}, origin);
    const bool has_quads = reading.has_quads && add_quads(patch, t, origin, triangle, low);
    triangle.end = map.heights.data() + map.heights.size();
    if (has_quads) quads.begin(triangle);
    QuadRow alone;
    float* out = map.heights.data() + static_cast<std::ptrdiff_t>(rows.first_row()) * grid.columns;
    for (int row = rows.first_row(); row <= rows.last_row(); ++row, out += grid.columns) {
      QuadRow& part = has_quads ? quads.next() : alone;
      if (!rows.set_row(row, origin, low, part)) continue;
      part.out = out;
      if (has_quads) {
        quads.add_next();
      } else {
        raise_by_texels(kernels, part, triangle.texels);
      }
    }
  }
  quads.finish();
}

void look_for_line(const ProjectedPatch& patch, const ProjectedTriangle& t, const Vec2& from,
                   const Vec2& step, const MapReading& reading, std::span<float> out,
                   LineRow& line) noexcept {
  Vec2 origin;
  double low = 0.0;
  QuadBatch& batch = line.batch;
  batch.triangle.texels = start_span(patch, t, step, origin);
  line.has_quads = reading.has_quads && add_quads(patch, t, origin, batch.triangle, low);
  batch.triangle.end = out.data() + out.size();
  const Vec2 texel = t.texel_origin + t.texel_by_at * from - origin;
  const double h = t.height_origin + t.height_by_at.dot(from);
  QuadRow& row = batch.rows[0];
  row.x = static_cast<float>(texel.x());
  row.y = static_cast<float>(texel.y());
  row.h = static_cast<float>(h + low);
  row.h_texels = static_cast<float>(h);
  row.first = 0;
  row.count = static_cast<int>(out.size());
  row.out = out.data();
  batch.row_count = 1;
  batch.sample_count = row.count;
  if (line.has_quads) kernels_of(reading.width).locate(batch);
}

void raise_line(const MapReading& reading, const LineRow& line) noexcept {
  const Kernels& kernels = kernels_of(reading.width);
  if (line.has_quads)
    kernels.raise(line.batch);
  else
    raise_by_texels(kernels, line.batch.rows[0], line.batch.triangle.texels);
}

}  // namespace thigma::detail
