#include "benchmarks/baselines/distance_field.h"

#include <algorithm>
#include <limits>

#include "benchmarks/baselines/nearest_point.h"

#include "thigma/clod/surface_deviation.h"

namespace thigma::bench {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

// The grid while it is built: every sample, the nearest triangle known and its distance.
struct Grid {
  const TriangleMesh* mesh = nullptr;
  std::array<int, 3> count{};
  Vec3 origin = Vec3::Zero();
  double cell = 0.0;
  float limit2 = 0.0f;  // square of the distance up to which samples are wanted
  std::vector<std::int32_t> nearest;
  std::vector<float> distance2;

  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * count[1] + j) * count[0] + i;
  }
  Vec3 point(int i, int j, int k) const { return origin + cell * Vec3(i, j, k); }
};

void offer(Grid& grid, std::size_t at, const Vec3& p, std::int32_t triangle) {
  const float d2 = static_cast<float>(nearest_point(*grid.mesh, triangle, p).distance2);
  if (d2 > grid.limit2 || d2 >= grid.distance2[at]) return;
  grid.distance2[at] = d2;
  grid.nearest[at] = triangle;
}

// Every triangle to the samples around it.
void place_triangles(Grid& grid) {
  for (std::size_t t = 0; t < grid.mesh->triangles.size(); ++t) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const std::int32_t v : grid.mesh->triangles[t]) {
      low = low.cwiseMin(grid.mesh->positions[static_cast<std::size_t>(v)]);
      high = high.cwiseMax(grid.mesh->positions[static_cast<std::size_t>(v)]);
    }
    std::array<int, 3> first{}, last{};
    for (int a = 0; a < 3; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      first[axis] =
          std::max(0, static_cast<int>(std::floor((low[a] - grid.origin[a]) / grid.cell)));
      last[axis] =
          std::min(grid.count[axis] - 1,
                   static_cast<int>(std::floor((high[a] - grid.origin[a]) / grid.cell)) + 1);
    }
    for (int k = first[2]; k <= last[2]; ++k) {
      for (int j = first[1]; j <= last[1]; ++j) {
        for (int i = first[0]; i <= last[0]; ++i) {
          offer(grid, grid.index(i, j, k), grid.point(i, j, k), static_cast<std::int32_t>(t));
        }
      }
    }
  }
}

// From one corner of the grid to the opposite: each sample is offered its neighbours' triangles.
void sweep(Grid& grid, const std::array<int, 3>& step) {
  const std::array<std::ptrdiff_t, 3> stride = {
      1, grid.count[0], static_cast<std::ptrdiff_t>(grid.count[0]) * grid.count[1]};
  auto at = [&](int n, std::size_t axis) { return step[axis] > 0 ? n : grid.count[axis] - 1 - n; };
  for (int kk = 0; kk < grid.count[2]; ++kk) {
    for (int jj = 0; jj < grid.count[1]; ++jj) {
      for (int ii = 0; ii < grid.count[0]; ++ii) {
        const int i = at(ii, 0), j = at(jj, 1), k = at(kk, 2);
        const std::size_t own = grid.index(i, j, k);
        const std::array<bool, 3> has = {ii > 0, jj > 0, kk > 0};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (!has[axis]) continue;
          const std::int32_t t =
              grid.nearest[own - static_cast<std::size_t>(step[axis] * stride[axis])];
          if (t >= 0 && t != grid.nearest[own]) offer(grid, own, grid.point(i, j, k), t);
        }
      }
    }
  }
}

Grid make_grid(const TriangleMesh& mesh, const DistanceField& field) {
  Grid grid;
  grid.mesh = &mesh;
  grid.cell = field.cell;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    grid.origin[a] = field.origin[axis];
    grid.count[axis] = DistanceField::kBrick * field.bricks[axis] + 1;
  }
  const float limit = field.band + 2.0f * field.cell;
  grid.limit2 = limit * limit;
  const std::size_t size = static_cast<std::size_t>(grid.count[0]) * grid.count[1] * grid.count[2];
  grid.nearest.assign(size, -1);
  grid.distance2.assign(size, kFar);
  place_triangles(grid);
  for (int pass = 0; pass < 8; ++pass) {
    sweep(grid, {pass & 1 ? -1 : 1, pass & 2 ? -1 : 1, pass & 4 ? -1 : 1});
  }
  return grid;
}

// Samples beyond the limit: the limit, with the sign of a neighbour in the brick. Two neighbours
// with the surface between them are both within a cell of it, so signs spread rightly.
void fill_far(float* samples, float limit) {
  constexpr int kS = DistanceField::kStride;
  for (bool changed = true; changed;) {
    changed = false;
    for (int n = 0; n < DistanceField::kSamples; ++n) {
      if (samples[n] != kFar) continue;
      const std::array<int, 3> at = {n % kS, n / kS % kS, n / kS / kS};
      const std::array<int, 3> stride = {1, kS, kS * kS};
      for (std::size_t axis = 0; axis < 3 && samples[n] == kFar; ++axis) {
        for (const int side : {-1, 1}) {
          const int to = at[axis] + side;
          if (to < 0 || to >= kS || samples[n + side * stride[axis]] == kFar) continue;
          samples[n] = samples[n + side * stride[axis]] < 0.0f ? -limit : limit;
          changed = true;
          break;
        }
      }
    }
  }
}

// True when the brick comes within the band; its samples are then appended.
bool take_brick(const Grid& grid, const SurfaceNormals& normals, const std::array<int, 3>& brick,
                DistanceField& field) {
  std::array<float, DistanceField::kSamples> samples{};
  float least2 = kFar;
  auto each = [&](auto&& visit) {
    int n = 0;
    for (int k = 0; k < DistanceField::kStride; ++k) {
      for (int j = 0; j < DistanceField::kStride; ++j) {
        for (int i = 0; i < DistanceField::kStride; ++i, ++n) {
          visit(n, 4 * brick[0] + i, 4 * brick[1] + j, 4 * brick[2] + k);
        }
      }
    }
  };
  each([&](int, int i, int j, int k) {
    least2 = std::min(least2, grid.distance2[grid.index(i, j, k)]);
  });
  if (!(least2 <= field.band * field.band)) return false;
  each([&](int n, int i, int j, int k) {
    const std::size_t at = grid.index(i, j, k);
    float value = kFar;
    if (grid.nearest[at] >= 0) {
      const Vec3 p = grid.point(i, j, k);
      const NearestPoint q = nearest_point(*grid.mesh, grid.nearest[at], p);
      value = static_cast<float>(std::sqrt(q.distance2));
      if (!is_outside(normals, *grid.mesh, grid.nearest[at], q, p)) value = -value;
    }
    samples[static_cast<std::size_t>(n)] = value;
  });
  fill_far(samples.data(), field.band + 2.0f * field.cell);
  field.samples.insert(field.samples.end(), samples.begin(), samples.end());
  return true;
}

void lay_out(const TriangleMesh& mesh, const FieldParams& params, DistanceField& field) {
  Vec3 low = mesh.positions.front(), high = low;
  for (const Vec3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double cell = (high - low).maxCoeff() / params.cells;
  const double band = params.band > 0.0 ? params.band : 4.0 * cell;
  const double pad = band + cell;
  field.cell = static_cast<float>(cell);
  field.inverse_cell = 1.0f / field.cell;
  field.band = static_cast<float>(band);
  field.pad = static_cast<float>(0.999 * pad);  // the origin is rounded
  field.brick_radius = 0.5f * DistanceField::kBrick * 1.7320509f * field.cell;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    field.origin[axis] = static_cast<float>(low[a] - pad);
    field.bricks[axis] = static_cast<int>(
        std::ceil((high[a] - low[a] + 2.0 * pad) / (DistanceField::kBrick * cell)));
    field.size[axis] = static_cast<float>(DistanceField::kBrick * field.bricks[axis]);
  }
}

}  // namespace

DistanceField build_distance_field(const TriangleMesh& mesh, const FieldParams& params) {
  DistanceField field;
  lay_out(mesh, params, field);
  const Grid grid = make_grid(mesh, field);
  const SurfaceNormals normals = surface_normals(mesh);
  const DeviationTarget target = build_deviation_target(mesh);
  field.table.resize(static_cast<std::size_t>(field.bricks[0]) * field.bricks[1] * field.bricks[2]);
  std::int32_t nearest = 0;
  std::size_t at = 0;
  for (int k = 0; k < field.bricks[2]; ++k) {
    for (int j = 0; j < field.bricks[1]; ++j) {
      for (int i = 0; i < field.bricks[0]; ++i, ++at) {
        const auto first =
            static_cast<std::int32_t>(field.samples.size() / DistanceField::kSamples);
        if (take_brick(grid, normals, {i, j, k}, field)) {
          field.table[at].first = first;
          continue;
        }
        const Vec3 center = grid.point(4 * i + 2, 4 * j + 2, 4 * k + 2);
        const double distance = nearest_distance(target, center, nearest);
        const NearestPoint q = nearest_point(mesh, nearest, center);
        field.table[at].center = static_cast<float>(
            is_outside(normals, mesh, nearest, q, center) ? distance : -distance);
      }
    }
  }
  field.samples.shrink_to_fit();
  return field;
}

std::size_t field_bytes(const DistanceField& field) {
  return sizeof(field) + field.table.size() * sizeof(DistanceField::Brick) +
         field.samples.size() * sizeof(float);
}

}  // namespace thigma::bench
