#include "thigma/depth/detail/triangle_rows.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

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

// An edge of a triangle as a line u(v): what lies over the triangle is on one side of it.
struct EdgeLine {
  double u = 0.0, v = 0.0;  // of its first corner
  double by_v = 0.0;
};

// The edges of a triangle that have it on their right, and those that have it on their left; one
// that lies within a row bounds no row.
struct EdgeLines {
  std::array<EdgeLine, 3> left, right;
  int left_count = 0, right_count = 0;
};

EdgeLines edge_lines(const ProjectedTriangle& t) noexcept {
  EdgeLines lines;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2& a = t.at[k];
    const double rise = t.at[(k + 1) % 3].y() - a.y();
    if (rise == 0.0) continue;
    const EdgeLine line{a.x(), a.y(), (t.at[(k + 1) % 3].x() - a.x()) / rise};
    if (t.edges[k].y() < 0.0) {
      lines.left[static_cast<std::size_t>(lines.left_count++)] = line;
    } else {
      lines.right[static_cast<std::size_t>(lines.right_count++)] = line;
    }
  }
  return lines;
}

double at_height(const EdgeLine& line, double v) noexcept {
  return line.u + (v - line.v) * line.by_v;
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
    const auto along_row = [&](double origin, double by_u, double by_v) {
      return Affine{origin, by_u * first_u_, by_v};
    };
    x_ = along_row(t.texel_origin.x(), t.texel_by_at(0, 0), t.texel_by_at(0, 1));
    y_ = along_row(t.texel_origin.y(), t.texel_by_at(1, 0), t.texel_by_at(1, 1));
    h_ = along_row(t.height_origin, t.height_by_at.x(), t.height_by_at.y());
    std::tie(bottom_, top_) = std::minmax({t.at[0].y(), t.at[1].y(), t.at[2].y()});
    is_whole_ = has_inside(t, grid.box);
    last_row_ = grid.rows - 1;
    if (is_whole_) return;
    edges_ = edge_lines(t);
    const auto row_of = [&](double v) { return (v - low_v_) / spacing_v_ - 0.5; };
    first_row_ = first_index(row_of(bottom_), grid.rows);
    last_row_ = end_index(row_of(top_), grid.rows) - 1;
  }

  int first_row() const noexcept { return first_row_; }
  int last_row() const noexcept { return last_row_; }

  /// Sets the part of a row; false where it has none.
  ///
  /// origin  that the texels are counted from
  /// lowest  of the quads [m]
  bool set_row(int row, const Vec2& origin, double lowest, QuadRow& part) const noexcept {
    const double v = low_v_ + spacing_v_ * (row + 0.5);
    part.first = 0;
    part.count = columns_;
    if (!is_whole_) {
      const double within = std::min(std::max(v, bottom_), top_);
      double low = at_height(edges_.left[0], within), high = at_height(edges_.right[0], within);
      if (edges_.left_count > 1) low = std::max(low, at_height(edges_.left[1], within));
      if (edges_.right_count > 1) high = std::min(high, at_height(edges_.right[1], within));
      part.first = first_index((low - first_u_) * per_u_, columns_);
      part.count = end_index((high - first_u_) * per_u_, columns_) - part.first;
      if (part.count <= 0) return false;
    }
    const double h = h_.at(v);
    part.x = static_cast<float>(x_.at(v) - origin.x());
    part.y = static_cast<float>(y_.at(v) - origin.y());
    part.h = static_cast<float>(h + lowest);
    part.h_texels = static_cast<float>(h);
    return true;
  }

 private:
  // The first of `count` indices from a place on, and the one after the last up to it; whatever the
  // place, also where it is no number.
  static int first_index(double cells, int count) noexcept {
    const double from = std::min<double>(count, std::max(0.0, cells - kSpanOverlap));
    const int whole = static_cast<int>(from);
    return whole + (from > whole);
  }
  static int end_index(double cells, int count) noexcept {
    const double to = cells + (1.0 + kSpanOverlap);
    return static_cast<int>(std::min<double>(count, std::max(0.0, to)));
  }

  /// At the first sample of a row: origin + (by_u u + by_v v).
  struct Affine {
    double origin = 0.0, by_first_u = 0.0, by_v = 0.0;
    double at(double v) const noexcept { return origin + (by_first_u + by_v * v); }
  };

  Affine x_, y_, h_;
  double low_v_ = 0.0, spacing_v_ = 1.0, per_u_ = 1.0, first_u_ = 0.0;  // [m], [1/m]
  int columns_ = 0;
  double bottom_ = 0.0, top_ = 0.0;
  int first_row_ = 0, last_row_ = -1;
  bool is_whole_ = false;  // all samples lie on the triangle
  EdgeLines edges_;
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
