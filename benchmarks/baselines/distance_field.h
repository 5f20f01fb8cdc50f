#pragma once
// A signed distance field of a mesh on a sparse grid: what the point shell is tested against.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <emmintrin.h>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::bench {

struct FieldParams {
  int cells = 240;    // along the longest side of the mesh's box
  double band = 0.0;  // distance from the surface up to which there are samples [m]; 0: four cells
};

/// Distances, negative inside, sampled in bricks of 4 x 4 x 4 cells around the surface. A brick
/// holds its 5 x 5 x 5 corners, so that all eight of a cell lie in it. Elsewhere a brick is one
/// number: the distance of its centre.
struct DistanceField {
  static constexpr int kBrick = 4;      // cells along a side
  static constexpr int kStride = 5;     // samples along a side
  static constexpr int kSamples = 125;  // of a brick
  struct Brick {
    std::int32_t first = -1;  // into samples, in bricks; -1 without any
    float center = 0.0f;      // distance at its centre, of those without [m]
  };
  std::array<float, 3> origin{};           // of sample 0 [m; mesh frame]
  std::array<float, 3> size{};             // of the grid, in cells
  float cell = 0.0f, inverse_cell = 0.0f;  // [m], [1/m]
  float band = 0.0f;                       // [m]
  float pad = 0.0f;                        // of the grid around the box of the mesh, at least [m]
  float brick_radius = 0.0f;               // half the diagonal of a brick [m]
  std::array<int, 3> bricks{};             // counts
  std::vector<Brick> table;                // x fastest
  std::vector<float> samples;              // [m]
};

/// Field of a closed, oriented mesh; of an open one the sign is that of the nearest normal.
///
/// Samples are distances in single precision, to the nearest triangle that sweeps from all eight
/// corners carry to them; the sign is of the angle-weighted normal at the nearest point.
/// Thread [offline]; deterministic; throws std::bad_alloc.
DistanceField build_distance_field(const TriangleMesh& mesh, const FieldParams& params = {});

/// Bytes the field occupies.
std::size_t field_bytes(const DistanceField& field);

/// A cell of a brick with samples, and the place in it.
struct FieldCell {
  const float* corner = nullptr;       // its lowest; null outside the samples
  float x = 0.0f, y = 0.0f, z = 0.0f;  // in the cell, 0..1
  float bound = 0.0f;                  // without samples: no more than the distance there [m]
};

/// Where a point of the mesh frame lies.
inline FieldCell find_cell(const DistanceField& field, float px, float py, float pz) {
  FieldCell cell;
  const float x = (px - field.origin[0]) * field.inverse_cell;
  const float y = (py - field.origin[1]) * field.inverse_cell;
  const float z = (pz - field.origin[2]) * field.inverse_cell;
  if (!(x >= 0.0f && y >= 0.0f && z >= 0.0f && x < field.size[0] && y < field.size[1] &&
        z < field.size[2])) {
    auto over = [](float v, float high) { return v < 0.0f ? -v : (v > high ? v - high : 0.0f); };
    const float ex = over(x, field.size[0]), ey = over(y, field.size[1]),
                ez = over(z, field.size[2]);
    cell.bound = field.cell * std::sqrt(ex * ex + ey * ey + ez * ez) + field.pad;
    return cell;
  }
  const int i = static_cast<int>(x), j = static_cast<int>(y), k = static_cast<int>(z);
  const DistanceField::Brick& brick = field.table[static_cast<std::size_t>(
      ((k >> 2) * field.bricks[1] + (j >> 2)) * field.bricks[0] + (i >> 2))];
  if (brick.first < 0) {
    cell.bound = brick.center - field.brick_radius;
    return cell;
  }
  cell.corner =
      field.samples.data() +
      (static_cast<std::size_t>(brick.first) * DistanceField::kSamples +
       static_cast<std::size_t>(
           ((k & 3) * DistanceField::kStride + (j & 3)) * DistanceField::kStride + (i & 3)));
  cell.x = x - static_cast<float>(i);
  cell.y = y - static_cast<float>(j);
  cell.z = z - static_cast<float>(k);
  return cell;
}

/// The eight corners of a cell with samples: (0,0) (1,0) (0,1) (1,1) at the lower z, and the rise
/// to the upper one.
struct FieldCorners {
  __m128 low, rise;
};

inline FieldCorners load_corners(const float* corner) {
  constexpr int kRow = DistanceField::kStride, kLayer = kRow * kRow;
  auto pair = [](const float* p) { return reinterpret_cast<const __m64*>(p); };
  const __m128 zero = _mm_setzero_ps();
  const __m128 low = _mm_loadh_pi(_mm_loadl_pi(zero, pair(corner)), pair(corner + kRow));
  const __m128 high =
      _mm_loadh_pi(_mm_loadl_pi(zero, pair(corner + kLayer)), pair(corner + kLayer + kRow));
  return {low, _mm_sub_ps(high, low)};
}

// (x0, x1) of four corners, interpolated along y.
inline __m128 along_y(__m128 corners, float y) {
  const __m128 upper = _mm_movehl_ps(corners, corners);
  return _mm_add_ps(corners, _mm_mul_ps(_mm_set1_ps(y), _mm_sub_ps(upper, corners)));
}
inline float lane1(__m128 v) { return _mm_cvtss_f32(_mm_shuffle_ps(v, v, 1)); }
inline float along_x(__m128 pair, float x) {
  const float a = _mm_cvtss_f32(pair);
  return a + x * (lane1(pair) - a);
}

/// Trilinear distance in a cell with samples [m].
inline float cell_distance(const FieldCell& cell) {
  const FieldCorners c = load_corners(cell.corner);
  const __m128 level = _mm_add_ps(c.low, _mm_mul_ps(_mm_set1_ps(cell.z), c.rise));
  return along_x(along_y(level, cell.y), cell.x);
}

/// Its gradient times the cell: of the same interpolation, so it costs no further sample [m].
inline std::array<float, 3> cell_rise(const FieldCell& cell) {
  const FieldCorners c = load_corners(cell.corner);
  const __m128 level = _mm_add_ps(c.low, _mm_mul_ps(_mm_set1_ps(cell.z), c.rise));
  const __m128 row = along_y(level, cell.y);
  const __m128 rise_y = _mm_sub_ps(_mm_movehl_ps(level, level), level);
  return {lane1(row) - _mm_cvtss_f32(row), along_x(rise_y, cell.x),
          along_x(along_y(c.rise, cell.y), cell.x)};
}

/// No more than the distance at a point, but for the error of the interpolation [m].
inline float least_distance_at(const DistanceField& field, float x, float y, float z) {
  const FieldCell cell = find_cell(field, x, y, z);
  return cell.corner == nullptr ? cell.bound : cell_distance(cell);
}

}  // namespace thigma::bench
