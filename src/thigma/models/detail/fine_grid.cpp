#include "thigma/models/detail/fine_grid.h"

#include <algorithm>
#include <cmath>

namespace thigma::models {

FineGrid::FineGrid(const TexturedSheet& sheet)
    : around_(sheet.fine_around), along_(sheet.fine_along), is_ring_(sheet.is_ring) {
  for (int j = 0; j <= along_; ++j) {
    const bool is_again = is_ring_ && j == along_, is_pole = !is_ring_ && (j == 0 || j == along_);
    for (int i = 0; i < around_; ++i)
      corners_.push_back(sheet.fine(is_pole ? 0.0 : static_cast<double>(i) / around_,
                                    is_again ? 0.0 : static_cast<double>(j) / along_));
  }
}

const Vec3& FineGrid::corner(int i, int j) const {
  i = (i % around_ + around_) % around_;
  if (is_ring_) j = (j % along_ + along_) % along_;
  return corners_[static_cast<std::size_t>(j) * static_cast<std::size_t>(around_) +
                  static_cast<std::size_t>(i)];
}

namespace {

/// A cell, and a place in it from 0 to 1.
struct CellPlace {
  int i = 0, j = 0;
  double a = 0.0, b = 0.0;
};

CellPlace cell_place(const Vec2& cells, int along, bool is_ring) {
  const double x = std::floor(cells.x()), y = std::floor(cells.y());
  CellPlace place{static_cast<int>(x), static_cast<int>(y), cells.x() - x, cells.y() - y};
  if (!is_ring && (place.j < 0 || place.j >= along)) {
    place.j = std::clamp(place.j, 0, along - 1);
    place.b = std::clamp(cells.y() - place.j, 0.0, 1.0);
  }
  return place;
}

}  // namespace

Vec3 FineGrid::at(const Vec2& uv) const {
  const CellPlace c = cell_place(Vec2(uv.x() * around_, uv.y() * along_), along_, is_ring_);
  const Vec3 &origin = corner(c.i, c.j), &far = corner(c.i + 1, c.j + 1);
  // At a pole a cell is one triangle; its two rows of corners are told apart by the place along
  // them.
  if (c.a >= c.b) {
    const Vec3& side = corner(c.i + 1, c.j);
    return origin + c.a * (side - origin) + c.b * (far - side);
  }
  const Vec3& side = corner(c.i, c.j + 1);
  return origin + c.b * (side - origin) + c.a * (far - side);
}

Vec3 FineGrid::along(const Vec3& point, const Vec3& direction, const Vec2& start,
                     const Vec3& other) const {
  constexpr int kMostSteps = 40;
  constexpr double kLongest = 8.0, kSlack = 1e-9;  // cells
  const double reach = 2.0 * (other - point).norm();
  Vec2 cells(start.x() * around_, start.y() * along_);
  for (int step = 0; step < kMostSteps; ++step) {
    const CellPlace c = cell_place(cells, along_, is_ring_);
    // triangles of a pole have no (u, v) to walk by
    if (!is_ring_ && (c.j == 0 || c.j == along_ - 1)) return other;
    const bool is_low = c.a >= c.b;
    const Vec3 &origin = corner(c.i, c.j), &far = corner(c.i + 1, c.j + 1);
    const Vec3& side = is_low ? corner(c.i + 1, c.j) : corner(c.i, c.j + 1);
    Mat3 columns;  // by a, by b, minus the way along the line
    columns << (is_low ? side - origin : far - side), (is_low ? far - side : side - origin),
        -direction;
    const double area = columns.determinant();
    if (area == 0.0) return other;
    const Vec3 found = columns.inverse() * (point - origin);
    const bool is_inside =
        found.x() >= -kSlack && found.y() >= -kSlack && found.x() <= 1.0 + kSlack &&
        found.y() <= 1.0 + kSlack &&
        (is_low ? found.x() >= found.y() - kSlack : found.y() >= found.x() - kSlack);
    if (is_inside) {
      const bool faces_along = columns.col(0).cross(columns.col(1)).dot(direction) > 0.0;
      return faces_along && std::fabs(found.z()) <= reach ? Vec3(point + found.z() * direction)
                                                          : other;
    }
    const Vec2 to(c.i + found.x(), c.j + found.y());
    const Vec2 way = to - cells;
    // Over the edge, so that the next triangle is another one; shorter and shorter where it goes to
    // and fro.
    const double longest = step < kMostSteps / 2 ? kLongest : 0.5;
    const double length = way.norm();
    cells += way * std::min(1.0 + 1e-6, longest / std::max(length, 1e-12));
  }
  return other;
}

}  // namespace thigma::models
