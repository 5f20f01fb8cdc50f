#include "thigma/texture/texel_lookup.h"

#include <algorithm>
#include <array>

#include "thigma/texture/texel_vector.h"

namespace thigma {
namespace {

using Vec4 = Eigen::Vector4d;  // a texel
using detail::texel_vector;

// A texel and the way to the next one. The last texel is its own neighbour: rows and columns are
// repeated.
struct Cell {
  int column = 0, row = 0;
  double x = 0.0, y = 0.0;
};

Cell cell_of(const HapticTexture& texture, const Vec2& at) noexcept {
  // Not std::clamp: a coordinate that is not a number has to give a texel, too.
  const double x = at.x() > 0.0 ? std::min(at.x(), texture.width - 1.0) : 0.0;
  const double y = at.y() > 0.0 ? std::min(at.y(), texture.height - 1.0) : 0.0;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  return {column, row, x - column, y - row};
}

// Central difference along a row or column of `count` texels, given those at index - 1, index,
// index + 1.
double share_of_difference(int index, int count) noexcept {
  const int span = std::min(index + 1, count - 1) - std::max(index - 1, 0);
  return span > 0 ? 1.0 / span : 0.0;  // of 1 or 2: exact
}

// Second differences there are only between three texels.
double share_of_second(int index, int count) noexcept {
  return index < 1 || index + 1 > count - 1 ? 0.0 : 1.0;
}

// In place: as a call it takes longer than what it does.
[[gnu::always_inline]] inline Vec4 blend(const Cell& cell, const Vec4& p00, const Vec4& p10,
                                         const Vec4& p01, const Vec4& p11) noexcept {
  const Vec4 left = p00 + cell.y * (p01 - p00);
  const Vec4 right = p10 + cell.y * (p11 - p10);
  return left + cell.x * (right - left);
}

}  // namespace

Vec3 displacement_at(const HapticTexture& texture, const Vec2& at) noexcept {
  const Cell c = cell_of(texture, at);
  const Texel* const top = &texel_at(texture, c.column, c.row);
  const Texel* const bottom = &texel_at(texture, c.column, c.row + 1);
  return blend(c, texel_vector(top[0]), texel_vector(top[1]), texel_vector(bottom[0]),
               texel_vector(bottom[1]))
      .head<3>();
}

TexelFacet texel_facet(const HapticTexture& texture, const Vec2& at) noexcept {
  const Cell c = cell_of(texture, at);
  const Texel* const top = &texel_at(texture, c.column, c.row);
  const Texel* const bottom = &texel_at(texture, c.column, c.row + 1);
  const Vec4 p00 = texel_vector(top[0]), p10 = texel_vector(top[1]), p01 = texel_vector(bottom[0]),
             p11 = texel_vector(bottom[1]);
  return {blend(c, p00, p10, p01, p11).head<3>(),
          ((1.0 - c.y) * (p10 - p00) + c.y * (p11 - p01)).head<3>(),
          ((1.0 - c.x) * (p01 - p00) + c.x * (p11 - p10)).head<3>()};
}

TexelJet texel_jet(const HapticTexture& texture, const Vec2& at) noexcept {
  const Cell c = cell_of(texture, at);
  std::array<std::array<Vec4, 4>, 4> p;  // p[row][column] around the cell
  // of the two middle ones
  std::array<double, 2> column_share, column_second, row_share, row_second;
  std::array<int, 4> columns;
  for (int k = 0; k < 4; ++k)
    columns[static_cast<std::size_t>(k)] = std::clamp(c.column + k - 1, 0, texture.width - 1);
  for (int j = 0; j < 4; ++j) {
    const int row = std::clamp(c.row + j - 1, 0, texture.height - 1);
    const Texel* const texels = &texel_at(texture, 0, row);
    for (std::size_t i = 0; i < 4; ++i)
      p[static_cast<std::size_t>(j)][i] = texel_vector(texels[columns[i]]);
    if (j != 1 && j != 2) continue;
    const std::size_t k = static_cast<std::size_t>(j - 1);
    row_share[k] = share_of_difference(row, texture.height);
    row_second[k] = share_of_second(row, texture.height);
    column_share[k] = share_of_difference(columns[k + 1], texture.width);
    column_second[k] = share_of_second(columns[k + 1], texture.width);
  }
  TexelJet jet;
  jet.value = blend(c, p[1][1], p[1][2], p[2][1], p[2][2]).head<3>();
  jet.facet_by_x = ((1.0 - c.y) * (p[1][2] - p[1][1]) + c.y * (p[2][2] - p[2][1])).head<3>();
  jet.facet_by_y = ((1.0 - c.x) * (p[2][1] - p[1][1]) + c.x * (p[2][2] - p[1][2])).head<3>();
  std::array<Vec4, 4> x, y, xx, yy;  // at the four texels around: (0, 0), (1, 0), (0, 1), (1, 1)
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t column = k % 2, row = k / 2, i = 1 + column, j = 1 + row;
    x[k] = (p[j][i + 1] - p[j][i - 1]) * column_share[column];
    y[k] = (p[j + 1][i] - p[j - 1][i]) * row_share[row];
    xx[k] = (p[j][i + 1] - 2.0 * p[j][i] + p[j][i - 1]) * column_second[column];
    yy[k] = (p[j + 1][i] - 2.0 * p[j][i] + p[j - 1][i]) * row_second[row];
  }
  jet.by_x = blend(c, x[0], x[1], x[2], x[3]).head<3>();
  jet.by_y = blend(c, y[0], y[1], y[2], y[3]).head<3>();
  jet.by_xx = blend(c, xx[0], xx[1], xx[2], xx[3]).head<3>();
  jet.by_yy = blend(c, yy[0], yy[1], yy[2], yy[3]).head<3>();
  jet.by_xy = (p[2][2] - p[2][1] - p[1][2] + p[1][1]).head<3>();
  return jet;
}

}  // namespace thigma
