#include "thigma/texture/texel_lookup.h"

#include <algorithm>
#include <array>

namespace thigma {
namespace {

Vec3 vector_of(const Texel& t) noexcept {
  return {static_cast<double>(t.x), static_cast<double>(t.y), static_cast<double>(t.z)};
}

// A texel and the way to the next one. The last texel is its own neighbour: rows and columns are repeated.
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

// Central difference along a row or column of `count` texels, given those at index - 1, index, index + 1.
Vec3 difference(const Vec3& before, const Vec3& after, int index, int count) noexcept {
  const int span = std::min(index + 1, count - 1) - std::max(index - 1, 0);
  if (span <= 0) return Vec3::Zero();
  return (after - before) / span;
}

Vec3 second_difference(const Vec3& before, const Vec3& here, const Vec3& after, int index,
                       int count) noexcept {
  if (index < 1 || index + 1 > count - 1) return Vec3::Zero();
  return after - 2.0 * here + before;
}

Vec3 blend(const Cell& cell, const Vec3& p00, const Vec3& p10, const Vec3& p01,
           const Vec3& p11) noexcept {
  const Vec3 left = p00 + cell.y * (p01 - p00);
  const Vec3 right = p10 + cell.y * (p11 - p10);
  return left + cell.x * (right - left);
}

}  // namespace

Vec3 displacement_at(const HapticTexture& texture, const Vec2& at) noexcept {
  const Cell c = cell_of(texture, at);
  return blend(c, vector_of(texel_at(texture, c.column, c.row)),
               vector_of(texel_at(texture, c.column + 1, c.row)),
               vector_of(texel_at(texture, c.column, c.row + 1)),
               vector_of(texel_at(texture, c.column + 1, c.row + 1)));
}

TexelJet texel_jet(const HapticTexture& texture, const Vec2& at) noexcept {
  const Cell c = cell_of(texture, at);
  std::array<std::array<Vec3, 4>, 4> p;  // p[row][column] around the cell
  std::array<int, 4> columns, rows;
  for (int k = 0; k < 4; ++k) {
    columns[static_cast<std::size_t>(k)] = std::clamp(c.column + k - 1, 0, texture.width - 1);
    rows[static_cast<std::size_t>(k)] = std::clamp(c.row + k - 1, 0, texture.height - 1);
  }
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) p[j][i] = vector_of(texel_at(texture, columns[i], rows[j]));
  }
  TexelJet jet;
  jet.value = blend(c, p[1][1], p[1][2], p[2][1], p[2][2]);
  jet.facet_by_x = (1.0 - c.y) * (p[1][2] - p[1][1]) + c.y * (p[2][2] - p[2][1]);
  jet.facet_by_y = (1.0 - c.x) * (p[2][1] - p[1][1]) + c.x * (p[2][2] - p[1][2]);
  std::array<Vec3, 4> x, y, xx, yy;  // at the four texels around: (0, 0), (1, 0), (0, 1), (1, 1)
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t i = 1 + k % 2, j = 1 + k / 2;
    x[k] = difference(p[j][i - 1], p[j][i + 1], columns[i], texture.width);
    y[k] = difference(p[j - 1][i], p[j + 1][i], rows[j], texture.height);
    xx[k] = second_difference(p[j][i - 1], p[j][i], p[j][i + 1], columns[i], texture.width);
    yy[k] = second_difference(p[j - 1][i], p[j][i], p[j + 1][i], rows[j], texture.height);
  }
  jet.by_x = blend(c, x[0], x[1], x[2], x[3]);
  jet.by_y = blend(c, y[0], y[1], y[2], y[3]);
  jet.by_xx = blend(c, xx[0], xx[1], xx[2], xx[3]);
  jet.by_yy = blend(c, yy[0], yy[1], yy[2], yy[3]);
  jet.by_xy = p[2][2] - p[2][1] - p[1][2] + p[1][1];
  return jet;
}

}  // namespace thigma
