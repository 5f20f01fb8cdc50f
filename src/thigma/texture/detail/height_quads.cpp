#include "thigma/texture/detail/height_quads.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/math/plane_cross.h"
#include "thigma/texture/detail/large_pages.h"

namespace thigma::detail {
namespace {

// Heights closer than this are one, of a step: with the half by which they are rounded less than
// 1/65,536 of the range.
constexpr double kOfStep = 0.125;
// The same of the longest displacement: normals of triangles in one plane differ by rounding.
constexpr double kRounding = 0x1p-44;

Vec3 vector_of(const Texel& t) noexcept { return Vec3(t.x, t.y, t.z); }

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double height) noexcept {
    low = std::min(low, height);
    high = std::max(high, height);
  }
  double step() const noexcept { return high > low ? (high - low) / kMostSteps : 0.0; }
};

void set_steps(const Range& range, HeightQuads& quads) noexcept {
  quads.low = range.low <= range.high ? range.low : 0.0;
  quads.step = range.step();
}

std::uint16_t steps_of(const HeightQuads& quads, double height) noexcept {
  if (!(quads.step > 0.0)) return 0;
  const double steps = std::floor((height - quads.low) / quads.step + 0.5);
  return static_cast<std::uint16_t>(std::clamp(steps, 0.0, double{kMostSteps}));
}

const Texel& longest(const std::vector<Texel>& texels) noexcept {
  return *std::max_element(texels.begin(), texels.end(), [](const Texel& a, const Texel& b) {
    return vector_of(a).squaredNorm() < vector_of(b).squaredNorm();
  });
}

// The direction that all displacements lie along, and their range; false without one.
bool find_direction(const HapticTexture& texture, HeightQuads& quads) noexcept {
  const Vec3 most = vector_of(longest(texture.texels));
  const double length = most.norm();
  quads.along = length > 0.0 ? Vec3(most / length) : Vec3::UnitZ();
  Range range;
  for (const Texel& t : texture.texels) range.add(vector_of(t).dot(quads.along));
  const double close = kOfStep * range.step();
  const bool is_one =
      std::all_of(texture.texels.begin(), texture.texels.end(), [&](const Texel& t) {
        const Vec3 d = vector_of(t);
        return (d - d.dot(quads.along) * quads.along).norm() <= close;
      });
  if (is_one) set_steps(range, quads);
  return is_one;
}

// Samples over a triangle may be read so far beside it [texels]: by the rounding of coordinates in
// single precision, up to 16384 texels.
constexpr double kBeside = 1.0 / 32.0;

// Visits the cells that samples over a triangle may read: visit(index).
template <class Visit>
void for_cells(const HapticTexture& texture, const std::array<Vec2, 3>& c, const Visit& visit) {
  const Vec2 last(texture.width - 1.0, texture.height - 1.0), beside = Vec2::Constant(kBeside);
  const Vec2 low = (c[0].cwiseMin(c[1]).cwiseMin(c[2]) - beside).cwiseMax(0.0).cwiseMin(last);
  const Vec2 high = (c[0].cwiseMax(c[1]).cwiseMax(c[2]) + beside).cwiseMax(0.0).cwiseMin(last);
  const double turn = cross(c[1] - c[0], c[2] - c[0]) > 0.0 ? 1.0 : -1.0;
  for (int row = static_cast<int>(low.y()); row <= static_cast<int>(high.y()); ++row) {
    for (int column = static_cast<int>(low.x()); column <= static_cast<int>(high.x()); ++column) {
      // Coordinates beyond the outermost centres are read at them.
      const Vec2 from(column > 0 ? column : -1.0, row > 0 ? row : -1.0);
      const Vec2 middle = 0.5 * (from + Vec2(column + 1.0, row + 1.0));
      const Vec2 half = Vec2(column + 1.0, row + 1.0) - middle + beside;
      bool may_read = true;
      for (std::size_t k = 0; may_read && k < 3; ++k) {
        const Vec2 edge = c[(k + 1) % 3] - c[k];
        may_read = turn * cross(edge, middle - c[k]) + std::fabs(edge.x()) * half.y() +
                       std::fabs(edge.y()) * half.x() >=
                   0.0;
      }
      if (may_read)
        visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width) +
              static_cast<std::size_t>(column));
    }
  }
}

std::array<Vec3, 4> corners_of(const HapticTexture& texture, std::size_t cell) noexcept {
  const int column = static_cast<int>(cell % static_cast<std::size_t>(texture.width)),
            row = static_cast<int>(cell / static_cast<std::size_t>(texture.width));
  return {vector_of(texel_at(texture, column, row)), vector_of(texel_at(texture, column + 1, row)),
          vector_of(texel_at(texture, column, row + 1)),
          vector_of(texel_at(texture, column + 1, row + 1))};
}

// Unit normals; zero for triangles without area, which no height map has.
std::vector<Vec3> normals_of(const TriangleMesh& mesh) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  const auto at = [&](std::int32_t i) { return mesh.positions[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
    const double length = normal.norm();
    normals.push_back(length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::Zero()));
  }
  return normals;
}

// The first triangle over each cell, -1 for none.
std::vector<std::int32_t> owners_of(const HapticTexture& texture,
                                    const std::vector<Vec3>& normals) {
  std::vector<std::int32_t> owners(
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height), -1);
  for (std::size_t t = 0; t < normals.size(); ++t) {
    if (normals[t].isZero()) continue;
    for_cells(texture, texture.corners[t], [&](std::size_t cell) {
      if (owners[cell] < 0) owners[cell] = static_cast<std::int32_t>(t);
    });
  }
  return owners;
}

void mark_mixed(const HapticTexture& texture, const std::vector<Vec3>& normals,
                const std::vector<std::int32_t>& owners, HeightQuads& quads) {
  const double close = kOfStep * quads.step + kRounding * vector_of(longest(texture.texels)).norm();
  for (std::size_t t = 0; t < normals.size(); ++t) {
    if (normals[t].isZero()) continue;
    for_cells(texture, texture.corners[t], [&](std::size_t cell) {
      const Vec3 apart = normals[t] - normals[static_cast<std::size_t>(owners[cell])];
      if (apart.isZero()) return;
      for (const Vec3& d : corners_of(texture, cell))
        if (std::fabs(apart.dot(d)) > close) quads.cells[cell].steps[0] = kMixedCell;
    });
  }
}

}  // namespace

void fill_height_quads(HapticTexture& texture) {
  HeightQuads& quads = texture.quads;
  const std::size_t count =
      static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
  quads.cells.reserve(count);
  ask_for_large_pages(quads.cells.data(), count * sizeof(HeightQuad));
  quads.cells.resize(count);
  std::vector<Vec3> normals;
  std::vector<std::int32_t> owners;
  const bool is_one = find_direction(texture, quads);
  if (!is_one) {
    quads.along.setZero();
    normals = normals_of(texture.coarse);
    owners = owners_of(texture, normals);
    Range range;
    for (std::size_t cell = 0; cell < count; ++cell) {
      if (owners[cell] < 0) continue;
      for (const Vec3& d : corners_of(texture, cell))
        range.add(normals[static_cast<std::size_t>(owners[cell])].dot(d));
    }
    set_steps(range, quads);
  }
  for (std::size_t cell = 0; cell < count; ++cell) {
    if (!is_one && owners[cell] < 0) continue;
    const Vec3& along = is_one ? quads.along : normals[static_cast<std::size_t>(owners[cell])];
    const std::array<Vec3, 4> corners = corners_of(texture, cell);
    for (std::size_t k = 0; k < 4; ++k)
      quads.cells[cell].steps[k] = steps_of(quads, along.dot(corners[k]));
  }
  if (!is_one) mark_mixed(texture, normals, owners, quads);
}

}  // namespace thigma::detail
