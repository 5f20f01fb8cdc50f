#include "scenes/textured_sheet.h"

#include <algorithm>
#include <cmath>

namespace thigma::scenes {
namespace {

constexpr int kGutter = 2;  // texels around a chart, which continue it

using Point = std::function<Vec3(double u, double v)>;

int triangle_count(const TexturedSheet& sheet, int around, int along) {
  return 2 * around * (sheet.is_ring ? along : along - 1);
}

/// Corners of the cells of a sheet in a mesh.
struct SheetCorners {
  std::int32_t first = 0;
  int around = 0, along = 0;
  bool is_ring = false;
  std::int32_t at(int i, int j) const {
    i %= around;
    if (is_ring) return first + (j % along) * around + i;
    if (j == 0) return first;
    if (j == along) return first + 1;
    return first + 2 + (j - 1) * around + i;
  }
};

SheetCorners add_corners(const Point& point, bool is_ring, int around, int along,
                         TriangleMesh& mesh) {
  const SheetCorners corners{static_cast<std::int32_t>(mesh.positions.size()), around, along,
                             is_ring};
  if (!is_ring) {
    mesh.positions.push_back(point(0.0, 0.0));
    mesh.positions.push_back(point(0.0, 1.0));
  }
  for (int j = is_ring ? 0 : 1; j < along; ++j)
    for (int i = 0; i < around; ++i)
      mesh.positions.push_back(
          point(static_cast<double>(i) / around, static_cast<double>(j) / along));
  return corners;
}

/// Which triangle of a cell a place within it lies on: 0 below the diagonal, 1 above it; at a pole the only one.
int half_of(const TexturedSheet& sheet, int j, const Vec2& in_cell) {
  if (!sheet.is_ring && j == 0) return 1;
  if (!sheet.is_ring && j == sheet.along - 1) return 0;
  return in_cell.x() >= in_cell.y() ? 0 : 1;
}

/// Places of the corners of a triangle within its cell. A pole stands in the middle of its side.
std::array<Vec2, 3> places(const TexturedSheet& sheet, int j, int half) {
  const bool is_low = !sheet.is_ring && j == 0, is_high = !sheet.is_ring && j == sheet.along - 1;
  if (half == 0) return {Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(is_high ? 0.5 : 1.0, 1.0)};
  return {Vec2(is_low ? 0.5 : 0.0, 0.0), Vec2(1.0, 1.0), Vec2(0.0, 1.0)};
}

std::array<std::int32_t, 3> triangle_of(const SheetCorners& c, int i, int j, int half) {
  if (half == 0) return {c.at(i, j), c.at(i + 1, j), c.at(i + 1, j + 1)};
  return {c.at(i, j), c.at(i + 1, j + 1), c.at(i, j + 1)};
}

/// The parameters that belong to a place in a cell: towards a pole the triangle narrows, the sheet does not.
Vec2 parameters(const TexturedSheet& sheet, int i, int j, const Vec2& in_cell) {
  double x = in_cell.x();
  const double from_pole = !sheet.is_ring && j == 0                  ? in_cell.y()
                           : !sheet.is_ring && j == sheet.along - 1 ? 1.0 - in_cell.y()
                                                                     : 1.0;
  if (from_pole < 1.0)
    x = from_pole > 0.0 ? std::clamp(0.5 + (x - 0.5) / from_pole, -0.5, 1.5) : 0.5;
  return {(i + x) / sheet.around, (j + in_cell.y()) / sheet.along};
}

/// Where a chart lies in the map.
struct Chart {
  int per_cell = 1;  // texels
  int first_row = 0;
  int columns(const TexturedSheet& s) const { return s.around * per_cell + 1 + 2 * kGutter; }
  int rows(const TexturedSheet& s) const { return s.along * per_cell + 1 + 2 * kGutter; }
};

Texel texel_of(const TexturedSheet& sheet, const SheetCorners& corners, const TriangleMesh& coarse,
               const Chart& chart, int column, int row) {
  const int wide = sheet.around * chart.per_cell, high = sheet.along * chart.per_cell;
  const int x = ((column - kGutter) % wide + wide) % wide;
  const int y = sheet.is_ring ? ((row - kGutter) % high + high) % high
                              : std::clamp(row - kGutter, 0, high);
  const int i = x / chart.per_cell, j = std::min(y / chart.per_cell, sheet.along - 1);
  const Vec2 in_cell(static_cast<double>(x) / chart.per_cell - i,
                     static_cast<double>(y) / chart.per_cell - j);
  const int half = half_of(sheet, j, in_cell);
  const std::array<Vec2, 3> at = places(sheet, j, half);
  const std::array<std::int32_t, 3> t = triangle_of(corners, i, j, half);
  Eigen::Matrix2d edges;
  edges << at[1] - at[0], at[2] - at[0];
  const Vec2 weights = edges.inverse() * (in_cell - at[0]);
  const auto corner = [&](std::size_t k) -> const Vec3& {
    return coarse.positions[static_cast<std::size_t>(t[k])];
  };
  const Vec3 on_coarse = corner(0) + weights.x() * (corner(1) - corner(0)) +
                         weights.y() * (corner(2) - corner(0));
  const Vec2 uv = parameters(sheet, i, j, in_cell);
  const Vec3 d = sheet.fine(uv.x() - std::floor(uv.x()), uv.y()) - on_coarse;
  return {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())};
}

void add_chart(const TexturedSheet& sheet, const Chart& chart, TextureSource& source) {
  const SheetCorners corners =
      add_corners(sheet.coarse, sheet.is_ring, sheet.around, sheet.along, source.coarse);
  for (int j = 0; j < sheet.along; ++j) {
    for (int i = 0; i < sheet.around; ++i) {
      const bool is_low = !sheet.is_ring && j == 0, is_high = !sheet.is_ring && j == sheet.along - 1;
      for (int half = is_low ? 1 : 0; half < (is_high ? 1 : 2); ++half) {
        source.coarse.triangles.push_back(triangle_of(corners, i, j, half));
        std::array<Vec2, 3> at = places(sheet, j, half);
        for (Vec2& p : at)
          p = chart.per_cell * (p + Vec2(i, j)) + Vec2(kGutter, chart.first_row + kGutter);
        source.corners.push_back(at);
      }
    }
  }
  for (int row = 0; row < chart.rows(sheet); ++row)
    for (int column = 0; column < chart.columns(sheet); ++column)
      source.texels[static_cast<std::size_t>(chart.first_row + row) *
                        static_cast<std::size_t>(source.width) +
                    static_cast<std::size_t>(column)] =
          texel_of(sheet, corners, source.coarse, chart, column, row);
}

}  // namespace

int coarse_triangles(const TexturedSheet& sheet) {
  return triangle_count(sheet, sheet.around, sheet.along);
}

int fine_triangles(const TexturedSheet& sheet) {
  return triangle_count(sheet, sheet.fine_around, sheet.fine_along);
}

TextureSource make_textured_sheets(std::span<const TexturedSheet> sheets, int texels) {
  int cells_around = 1, cells_along = 0;
  for (const TexturedSheet& sheet : sheets) {
    cells_around = std::max(cells_around, sheet.around);
    cells_along += sheet.along;
  }
  Chart chart;
  chart.per_cell = std::max(2, texels / std::max(cells_around, cells_along));
  TextureSource source;
  source.width = 1;
  source.height = 0;
  for (const TexturedSheet& sheet : sheets) {
    source.width = std::max(source.width, chart.columns(sheet));
    source.height += chart.rows(sheet);
  }
  source.texels.assign(
      static_cast<std::size_t>(source.width) * static_cast<std::size_t>(source.height), Texel{});
  for (const TexturedSheet& sheet : sheets) {
    add_chart(sheet, chart, source);
    chart.first_row += chart.rows(sheet);
  }
  return source;
}

TriangleMesh make_fine_sheets(std::span<const TexturedSheet> sheets) {
  TriangleMesh mesh;
  for (const TexturedSheet& sheet : sheets) {
    const SheetCorners corners =
        add_corners(sheet.fine, sheet.is_ring, sheet.fine_around, sheet.fine_along, mesh);
    for (int j = 0; j < sheet.fine_along; ++j) {
      const bool is_low = !sheet.is_ring && j == 0,
                 is_high = !sheet.is_ring && j == sheet.fine_along - 1;
      for (int i = 0; i < sheet.fine_around; ++i)
        for (int half = is_low ? 1 : 0; half < (is_high ? 1 : 2); ++half)
          mesh.triangles.push_back(triangle_of(corners, i, j, half));
    }
  }
  return mesh;
}

}  // namespace thigma::scenes
