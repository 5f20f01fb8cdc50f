#include "thigma/models/textured_sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "thigma/models/detail/fine_grid.h"

namespace thigma::models {
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

/// Which triangle of a cell a place within it lies on: 0 below the diagonal, 1 above it; at a pole
/// the only one.
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

/// 1 away from poles, 0 at one, for a place in a row of cells.
double from_pole(const TexturedSheet& sheet, int j, double along) {
  if (sheet.is_ring) return 1.0;
  return j == 0 ? along : j == sheet.along - 1 ? 1.0 - along : 1.0;
}

/// The place on the triangle of a cell at a pole that is nearest along the row: beside it texels
/// continue its edge.
Vec2 on_triangle(const TexturedSheet& sheet, int j, const Vec2& in_cell) {
  const double half = 0.5 * from_pole(sheet, j, in_cell.y());
  return {std::clamp(in_cell.x(), 0.5 - half, 0.5 + half), in_cell.y()};
}

/// The parameters that belong to a place on a triangle: towards a pole it narrows, the sheet does
/// not.
Vec2 parameters(const TexturedSheet& sheet, int i, int j, const Vec2& in_cell) {
  const double width = from_pole(sheet, j, in_cell.y());
  const double x = width > 0.0 ? 0.5 + (in_cell.x() - 0.5) / width : 0.5;
  return {(i + x) / sheet.around, (j + in_cell.y()) / sheet.along};
}

/// Where a chart lies in the map: cells have texels by their size.
struct Chart {
  // where each coarse cell starts, and where the last one ends [texels]
  std::vector<int> columns, rows;
  int first_row = 0;
  int width() const { return columns.back() + 1 + 2 * kGutter; }
  int height() const { return rows.back() + 1 + 2 * kGutter; }
  Vec2 place(int i, int j, const Vec2& in_cell) const {
    const std::size_t c = static_cast<std::size_t>(i), r = static_cast<std::size_t>(j);
    return {kGutter + columns[c] + in_cell.x() * (columns[c + 1] - columns[c]),
            kGutter + first_row + rows[r] + in_cell.y() * (rows[r + 1] - rows[r])};
  }
};

/// Length of the longest coarse edge of every column of cells, and of every row [m].
struct CellSizes {
  std::vector<double> columns, rows;
};

CellSizes cell_sizes(const TexturedSheet& sheet) {
  TriangleMesh mesh;
  const SheetCorners corners =
      add_corners(sheet.coarse, sheet.is_ring, sheet.around, sheet.along, mesh);
  const auto point = [&](int i, int j) {
    return mesh.positions[static_cast<std::size_t>(corners.at(i, j))];
  };
  CellSizes sizes{std::vector<double>(static_cast<std::size_t>(sheet.around), 0.0),
                  std::vector<double>(static_cast<std::size_t>(sheet.along), 0.0)};
  for (int j = 0; j <= sheet.along; ++j) {
    for (int i = 0; i < sheet.around; ++i) {
      double& across = sizes.columns[static_cast<std::size_t>(i)];
      across = std::max(across, (point(i + 1, j) - point(i, j)).norm());
      if (j == sheet.along) continue;
      double& along = sizes.rows[static_cast<std::size_t>(j)];
      along = std::max(along, (point(i, j + 1) - point(i, j)).norm());
    }
  }
  return sizes;
}

Chart chart_of(const CellSizes& sizes, double texel) {
  constexpr double kLeast = 2.0, kMost = 4096.0;  // texels along a cell
  const auto starts = [&](const std::vector<double>& lengths) {
    std::vector<int> at = {0};
    for (const double length : lengths)
      at.push_back(at.back() +
                   static_cast<int>(std::ceil(std::clamp(length / texel, kLeast, kMost))));
    return at;
  };
  return {starts(sizes.columns), starts(sizes.rows), 0};
}

/// Cell that a texel lies in, and where in it, from 0 to 1.
std::pair<int, double> cell_at(const std::vector<int>& starts, int texel) {
  const auto next = std::upper_bound(starts.begin() + 1, starts.end() - 1, texel);
  const int low = *(next - 1), high = *next;
  return {static_cast<int>(next - starts.begin()) - 1,
          static_cast<double>(texel - low) / (high - low)};
}

/// A sheet while its texels are filled.
struct SheetBake {
  const TexturedSheet& sheet;
  SheetCorners corners;
  FineGrid fine;
  std::vector<Vec3> normals;  // of the vertices of the coarse surface, by area
};

std::vector<Vec3> vertex_normals(const TexturedSheet& sheet, const SheetCorners& corners,
                                 const TriangleMesh& coarse) {
  std::vector<Vec3> normals(coarse.positions.size(), Vec3::Zero());
  for (int j = 0; j < sheet.along; ++j) {
    for (int i = 0; i < sheet.around; ++i) {
      const bool is_low = !sheet.is_ring && j == 0,
                 is_high = !sheet.is_ring && j == sheet.along - 1;
      for (int half = is_low ? 1 : 0; half < (is_high ? 1 : 2); ++half) {
        const std::array<std::int32_t, 3> t = triangle_of(corners, i, j, half);
        const auto p = [&](std::size_t k) {
          return coarse.positions[static_cast<std::size_t>(t[k])];
        };
        const Vec3 normal = (p(1) - p(0)).cross(p(2) - p(0));
        for (const std::int32_t k : t) normals[static_cast<std::size_t>(k)] += normal;
      }
    }
  }
  for (Vec3& n : normals)
    if (n.norm() > 0.0) n.normalize();
  return normals;
}

Texel texel_of(const SheetBake& bake, const TriangleMesh& coarse, const Chart& chart, int column,
               int row) {
  const TexturedSheet& sheet = bake.sheet;
  const int wide = chart.columns.back(), high = chart.rows.back();
  const int x = ((column - kGutter) % wide + wide) % wide;
  const int y =
      sheet.is_ring ? ((row - kGutter) % high + high) % high : std::clamp(row - kGutter, 0, high);
  const auto [i, in_x] = cell_at(chart.columns, x);
  const auto [j, in_y] = cell_at(chart.rows, y);
  const Vec2 in_cell = on_triangle(sheet, j, {in_x, in_y});
  const int half = half_of(sheet, j, in_cell);
  const std::array<Vec2, 3> at = places(sheet, j, half);
  const std::array<std::int32_t, 3> t = triangle_of(bake.corners, i, j, half);
  Eigen::Matrix2d edges;
  edges << at[1] - at[0], at[2] - at[0];
  const Vec2 weights = edges.inverse() * (in_cell - at[0]);
  const auto blend = [&](const std::vector<Vec3>& of) -> Vec3 {
    const auto corner = [&](std::size_t k) -> const Vec3& {
      return of[static_cast<std::size_t>(t[k])];
    };
    return corner(0) + weights.x() * (corner(1) - corner(0)) +
           weights.y() * (corner(2) - corner(0));
  };
  const Vec3 on_coarse = blend(coarse.positions);
  const Vec2 uv = parameters(sheet, i, j, in_cell);
  const Vec3 paired = bake.fine.at(uv);
  const Vec3 fine =
      sheet.is_paired ? paired : bake.fine.along(on_coarse, blend(bake.normals), uv, paired);
  const Vec3 d = fine - on_coarse;
  return {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())};
}

void add_chart(const TexturedSheet& sheet, const Chart& chart, TextureSource& source) {
  const SheetCorners corners =
      add_corners(sheet.coarse, sheet.is_ring, sheet.around, sheet.along, source.coarse);
  for (int j = 0; j < sheet.along; ++j) {
    for (int i = 0; i < sheet.around; ++i) {
      const bool is_low = !sheet.is_ring && j == 0,
                 is_high = !sheet.is_ring && j == sheet.along - 1;
      for (int half = is_low ? 1 : 0; half < (is_high ? 1 : 2); ++half) {
        source.coarse.triangles.push_back(triangle_of(corners, i, j, half));
        std::array<Vec2, 3> at = places(sheet, j, half);
        for (Vec2& p : at) p = chart.place(i, j, p);
        source.corners.push_back(at);
      }
    }
  }
  const SheetBake bake{sheet, corners, FineGrid(sheet),
                       vertex_normals(sheet, corners, source.coarse)};
  for (int row = 0; row < chart.height(); ++row)
    for (int column = 0; column < chart.width(); ++column)
      source.texels[static_cast<std::size_t>(chart.first_row + row) *
                        static_cast<std::size_t>(source.width) +
                    static_cast<std::size_t>(column)] =
          texel_of(bake, source.coarse, chart, column, row);
}

/// Charts with texels of one size, and their map.
struct Layout {
  std::vector<Chart> charts;
  int width = 1, height = 0;
};

Layout layout_of(const std::vector<CellSizes>& sizes, double texel) {
  Layout layout;
  for (const CellSizes& of_sheet : sizes) {
    Chart chart = chart_of(of_sheet, texel);
    chart.first_row = layout.height;
    layout.width = std::max(layout.width, chart.width());
    layout.height += chart.height();
    layout.charts.push_back(std::move(chart));
  }
  return layout;
}

/// The layout with the smallest texels whose map has no more than texels x texels, or the smallest
/// there is.
Layout choose_layout(std::span<const TexturedSheet> sheets, int texels) {
  std::vector<CellSizes> sizes;
  double longest = 0.0;
  for (const TexturedSheet& sheet : sheets) {
    sizes.push_back(cell_sizes(sheet));
    for (const std::vector<double>* lengths : {&sizes.back().columns, &sizes.back().rows})
      for (const double length : *lengths) longest = std::max(longest, length);
  }
  double small = longest / kMaxTextureSide, large = longest;
  const double most = static_cast<double>(texels) * texels;
  constexpr int kHalvings = 40;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = std::sqrt(small * large);
    const Layout layout = layout_of(sizes, middle);
    const bool fits = static_cast<double>(layout.width) * layout.height <= most &&
                      std::max(layout.width, layout.height) <= kMaxTextureSide;
    (fits ? large : small) = middle;
  }
  return layout_of(sizes, large);
}

}  // namespace

int coarse_triangles(const TexturedSheet& sheet) {
  return triangle_count(sheet, sheet.around, sheet.along);
}

int fine_triangles(const TexturedSheet& sheet) {
  return triangle_count(sheet, sheet.fine_around, sheet.fine_along);
}

TextureSource make_textured_sheets(std::span<const TexturedSheet> sheets, int texels) {
  const Layout layout = choose_layout(sheets, texels);
  TextureSource source;
  source.width = layout.width;
  source.height = layout.height;
  source.texels.assign(
      static_cast<std::size_t>(source.width) * static_cast<std::size_t>(source.height), Texel{});
  for (std::size_t i = 0; i < sheets.size(); ++i) add_chart(sheets[i], layout.charts[i], source);
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

}  // namespace thigma::models
