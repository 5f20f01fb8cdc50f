#include "thigma/texture/haptic_texture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/math/plane_cross.h"
#include "thigma/texture/detail/height_quads.h"
#include "thigma/texture/detail/large_pages.h"
#include "thigma/texture/detail/texture_error.h"

namespace thigma {
namespace {

using detail::ask_for_large_pages;
using detail::fail;

std::string place(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

void check_sizes(const TextureSource& source, const std::string& name) {
  const std::int64_t width = source.width, height = source.height;
  if (width < 1 || height < 1 || width > kMaxTextureSide || height > kMaxTextureSide ||
      width * height > kMaxTexels) {
    fail(name, "a map of " + std::to_string(width) + " x " + std::to_string(height) + " texels",
         "sides of 1 to 16384 and at most 67108864 texels");
  }
  if (source.texels.size() != static_cast<std::size_t>(width * height)) {
    fail(name, std::to_string(source.texels.size()) + " texels",
         std::to_string(width * height) + " for " + std::to_string(width) + " x " +
             std::to_string(height));
  }
  if (source.coarse.triangles.empty()) fail(name, "no triangle", "a coarse surface");
  if (source.corners.size() != source.coarse.triangles.size())
    fail(name, "no texture coordinates", "three for every triangle");
}

double extent(const TriangleMesh& mesh) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

void check_texels(const TextureSource& source, const std::string& name) {
  const double largest = extent(source.coarse);
  for (std::size_t i = 0; i < source.texels.size(); ++i) {
    const Texel& t = source.texels[i];
    if (!std::isfinite(t.x) || !std::isfinite(t.y) || !std::isfinite(t.z))
      fail(name, place("texel", i) + " is not finite", "numbers");
    const double size = Vec3(t.x, t.y, t.z).norm();
    if (size > largest)
      fail(name, place("texel", i) + " is farther away than the coarse surface is large",
           "less relief");
  }
}

void check_corners(const TextureSource& source, const std::string& name) {
  const Vec2 limit(source.width - 0.5, source.height - 0.5);
  for (std::size_t t = 0; t < source.corners.size(); ++t) {
    const std::array<Vec2, 3>& c = source.corners[t];
    for (const Vec2& p : c) {
      const bool is_inside =
          p.x() >= -0.5 && p.y() >= -0.5 && p.x() <= limit.x() && p.y() <= limit.y();
      if (!is_inside) fail(name, place("triangle", t) + " leaves the map", "coordinates within it");
    }
    const Vec2 a = c[1] - c[0], b = c[2] - c[0];
    constexpr double kFlat = 1e-9;  // of the edges' product: below, the map back is rounding
    if (!(std::fabs(cross(a, b)) > kFlat * a.norm() * b.norm()))
      fail(name, place("triangle", t) + " has no area in the map",
           "texture coordinates that span it");
  }
}

struct Area {
  double on_surface = 0.0;  // [m^2]
  double in_map = 0.0;      // [texels]
};

// Visits the texels whose centres are inside a triangle: visit(column, row, is_strictly_inside).
template <class Visit>
void for_texels(const TextureSource& source, const std::array<Vec2, 3>& corners,
                const Visit& visit) {
  const Vec2 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Vec2 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  const int first_column = std::max(0, static_cast<int>(std::ceil(low.x())));
  const int last_column = std::min(source.width - 1, static_cast<int>(std::floor(high.x())));
  const int first_row = std::max(0, static_cast<int>(std::ceil(low.y())));
  const int last_row = std::min(source.height - 1, static_cast<int>(std::floor(high.y())));
  const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
  constexpr double kEdge = 1e-9;  // of the triangle: nearer to an edge a texel may belong to two
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const Vec2 p(column, row);
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& a = corners[k];
        least = std::min(least, cross(corners[(k + 1) % 3] - a, p - a) / area);
      }
      if (least >= 0.0) visit(column, row, least > kEdge);
    }
  }
}

// Owners of texels, to find overlaps; on the way the range of displacements along coarse normals.
double measure_relief(const TextureSource& source, const std::string& name, Area& area) {
  std::vector<std::int32_t> owners(source.texels.size(), -1);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t t = 0; t < source.corners.size(); ++t) {
    const auto& [a, b, c] = source.coarse.triangles[t];
    const auto at = [&](std::int32_t i) {
      return source.coarse.positions[static_cast<std::size_t>(i)];
    };
    const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
    const double length = normal.norm();
    const std::array<Vec2, 3>& corners = source.corners[t];
    area.on_surface += 0.5 * length;
    area.in_map += 0.5 * std::fabs(cross(corners[1] - corners[0], corners[2] - corners[0]));
    for_texels(source, corners, [&](int column, int row, bool is_strictly_inside) {
      const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(source.width) +
                            static_cast<std::size_t>(column);
      if (is_strictly_inside && owners[i] >= 0) {
        fail(name,
             place("triangles", static_cast<std::size_t>(owners[i])) + " and " + std::to_string(t) +
                 " overlap at texel (" + std::to_string(column) + ", " + std::to_string(row) + ")",
             "charts that do not overlap");
      }
      if (is_strictly_inside) owners[i] = static_cast<std::int32_t>(t);
      if (length == 0.0) return;
      const Texel& texel = source.texels[i];
      const double height = Vec3(texel.x, texel.y, texel.z).dot(normal) / length;
      low = std::min(low, height);
      high = std::max(high, height);
    });
  }
  return high > low ? 0.5 * (high - low) : 0.0;
}

Texel least(const Texel& a, const Texel& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Texel largest(const Texel& a, const Texel& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

// Columns of the next level, or of the first one over `texels` texels.
int halved(int cells) { return std::max(1, (cells + 1) / 2); }

BoundsLevel first_level(const HapticTexture& texture) {
  BoundsLevel level{halved(texture.width - 1), halved(texture.height - 1), {}};
  for (int j = 0; j < level.rows; ++j) {
    for (int i = 0; i < level.columns; ++i) {
      TexelBounds bounds{texel_at(texture, 2 * i, 2 * j), texel_at(texture, 2 * i, 2 * j)};
      for (int row = 2 * j; row <= std::min(2 * j + 2, texture.height - 1); ++row) {
        for (int column = 2 * i; column <= std::min(2 * i + 2, texture.width - 1); ++column) {
          bounds.low = least(bounds.low, texel_at(texture, column, row));
          bounds.high = largest(bounds.high, texel_at(texture, column, row));
        }
      }
      level.cells.push_back(bounds);
    }
  }
  return level;
}

BoundsLevel next_level(const BoundsLevel& fine) {
  BoundsLevel level{halved(fine.columns), halved(fine.rows), {}};
  const auto cell = [&](int i, int j) -> const TexelBounds& {
    return fine.cells[static_cast<std::size_t>(std::min(j, fine.rows - 1)) *
                          static_cast<std::size_t>(fine.columns) +
                      static_cast<std::size_t>(std::min(i, fine.columns - 1))];
  };
  for (int j = 0; j < level.rows; ++j) {
    for (int i = 0; i < level.columns; ++i) {
      TexelBounds bounds = cell(2 * i, 2 * j);
      for (int k = 1; k < 4; ++k) {
        const TexelBounds& other = cell(2 * i + k % 2, 2 * j + k / 2);
        bounds.low = least(bounds.low, other.low);
        bounds.high = largest(bounds.high, other.high);
      }
      level.cells.push_back(bounds);
    }
  }
  return level;
}

// Bounds of the texels under a triangle: of up to four cells at least as large as its box.
TexelBounds bounds_under(const HapticTexture& texture, const std::array<Vec2, 3>& corners) {
  const Vec2 last(texture.width - 1.0, texture.height - 1.0), around = Vec2::Ones();
  const Vec2 low = (corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]) - around)
                       .cwiseMax(0.0)
                       .cwiseMin(last),
             high = (corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]) + around)
                        .cwiseMax(0.0)
                        .cwiseMin(last);
  std::size_t level = 0;  // of cells of 2^(level + 1) texels
  while (level + 1 < texture.pyramid.size() &&
         std::ldexp(1.0, static_cast<int>(level) + 1) < (high - low).maxCoeff())
    ++level;
  const BoundsLevel& cells = texture.pyramid[level];
  const auto cell = [&](double at, int count) {
    return std::min(static_cast<int>(at) >> (level + 1), count - 1);
  };
  TexelBounds all = cells.cells[static_cast<std::size_t>(cell(low.y(), cells.rows) * cells.columns +
                                                         cell(low.x(), cells.columns))];
  for (int row = cell(low.y(), cells.rows); row <= cell(high.y(), cells.rows); ++row) {
    for (int column = cell(low.x(), cells.columns); column <= cell(high.x(), cells.columns);
         ++column) {
      const TexelBounds& here = cells.cells[static_cast<std::size_t>(row * cells.columns + column)];
      all = {least(all.low, here.low), largest(all.high, here.high)};
    }
  }
  return all;
}

std::vector<Texel> padded(const std::vector<Texel>& texels, int width, int height) {
  std::vector<Texel> out;
  out.reserve(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1));
  ask_for_large_pages(out.data(), out.capacity() * sizeof(Texel));
  for (int row = 0; row <= height; ++row) {
    const auto start =
        texels.begin() + static_cast<std::ptrdiff_t>(std::min(row, height - 1)) * width;
    out.insert(out.end(), start, start + width);
    out.push_back(*(start + (width - 1)));
  }
  return out;
}

}  // namespace

HapticTexture make_texture(TextureSource source, const std::string& name) {
  check_sizes(source, name);
  check_texels(source, name);
  check_corners(source, name);
  HapticTexture texture;
  Area area;
  texture.amplitude = measure_relief(source, name, area);
  texture.texel_size = std::sqrt(area.on_surface / area.in_map);
  if (!(texture.texel_size > 0.0)) fail(name, "no triangle with an area", "a coarse surface");
  texture.width = source.width;
  texture.height = source.height;
  texture.texels = padded(source.texels, source.width, source.height);
  texture.coarse = std::move(source.coarse);
  texture.corners = std::move(source.corners);
  texture.pyramid.push_back(first_level(texture));
  while (texture.pyramid.back().cells.size() > 1)
    texture.pyramid.push_back(next_level(texture.pyramid.back()));
  texture.under.reserve(texture.corners.size());
  for (const std::array<Vec2, 3>& corners : texture.corners)
    texture.under.push_back(bounds_under(texture, corners));
  detail::fill_height_quads(texture);
  return texture;
}

HapticTexture make_plain_texture(TriangleMesh coarse, const std::string& name) {
  HapticTexture texture;
  if (coarse.triangles.empty()) fail(name, "no triangle", "a coarse surface");
  // All triangles share the one texel: nothing is looked up that could tell them apart.
  texture.corners.assign(coarse.triangles.size(),
                         {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.0, 0.5)});
  Area area;
  for (const auto& [a, b, c] : coarse.triangles) {
    const auto at = [&](std::int32_t i) { return coarse.positions[static_cast<std::size_t>(i)]; };
    area.on_surface += 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
    area.in_map += 0.5;
  }
  texture.coarse = std::move(coarse);
  texture.width = texture.height = 1;
  texture.texels.assign(4, Texel{});
  texture.texel_size = std::sqrt(area.on_surface / area.in_map);
  texture.pyramid.push_back(first_level(texture));
  detail::fill_height_quads(texture);
  return texture;
}

}  // namespace thigma
