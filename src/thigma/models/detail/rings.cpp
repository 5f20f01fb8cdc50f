#include "thigma/models/detail/rings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace thigma::models {
namespace {

constexpr int kFanCount = 8;  // rings up to this are closed by triangles to their centre

/// Scale of the next ring inwards: about as far away as its own vertices are from each other.
double next_scale(int count) { return std::max(0.5, 1.0 - 7.5 / count); }

}  // namespace

Ring add_ring(TriangleMesh& mesh, std::span<const Vec3> points) {
  const Ring ring = {static_cast<std::int32_t>(mesh.positions.size()),
                     static_cast<int>(points.size())};
  mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
  return ring;
}

void join_rings(TriangleMesh& mesh, const Ring& low, const Ring& high,
                const std::function<bool(int)>& is_mirrored) {
  assert(low.count == high.count);
  for (int j = 0; j < low.count; ++j) {
    const int k = (j + 1) % low.count;
    const std::int32_t a = low.first + j, b = low.first + k, c = high.first + k, d = high.first + j;
    if (is_mirrored(j)) {
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({b, c, d});
    } else {
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
}

void close_ring(TriangleMesh& mesh, const Ring& ring, const Vec3& centre, bool is_reversed) {
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    if (is_reversed) std::swap(b, c);
    mesh.triangles.push_back({a, b, c});
  };
  Ring outer = ring;
  while (outer.count > kFanCount) {
    const double scale = next_scale(outer.count);
    Ring inner = {static_cast<std::int32_t>(mesh.positions.size()), (outer.count + 1) / 2};
    for (int j = 0; j < inner.count; ++j) {
      const Vec3 p = mesh.positions[outer.first + 2 * j];
      mesh.positions.push_back(centre + (p - centre) * scale);
    }
    for (int j = 0; j < inner.count; ++j) {
      const std::int32_t a = outer.first + 2 * j;
      const std::int32_t c = outer.first + (2 * j + 2) % (2 * inner.count);
      const std::int32_t p = inner.first + j;
      const std::int32_t q = inner.first + (j + 1) % inner.count;
      if (2 * j + 1 < outer.count) {
        add(a, a + 1, p);
        add(a + 1, q, p);
        add(a + 1, c, q);
      } else {  // odd count: the last inner vertex has no vertex between it and the first
        add(a, c, p);
        add(c, q, p);
      }
    }
    outer = inner;
  }
  const std::int32_t tip = static_cast<std::int32_t>(mesh.positions.size());
  mesh.positions.push_back(centre);
  for (int j = 0; j < outer.count; ++j)
    add(outer.first + j, outer.first + (j + 1) % outer.count, tip);
}

int disc_triangles(int count) {
  int triangles = 0;
  while (count > kFanCount) {
    triangles += count + (count + 1) / 2;
    count = (count + 1) / 2;
  }
  return triangles + count;
}

GridCounts nearest_counts(int triangles, double wished_ratio, int around_step, int around_least,
                          const std::function<long long(int, int)>& total) {
  const double wished = std::sqrt(0.5 * triangles / wished_ratio);
  GridCounts best;
  double best_cost = 0.0;
  const int last = static_cast<int>(1.3 * std::max<double>(around_least, wished));
  const int first =
      std::max(around_least, static_cast<int>(0.75 * wished) / around_step * around_step);
  for (int around = first; around <= last; around += around_step) {
    int along = std::max(2, static_cast<int>(0.5 * triangles / around) - 8);
    while (along > 2 && total(around, along) > triangles) --along;
    while (total(around, along + 1) <= triangles) ++along;
    for (const int k : {along, along + 1}) {
      // A tenth off the wished shape weighs as much as 0.1 % off the count.
      const double off_count =
          std::fabs(static_cast<double>(total(around, k) - triangles)) / triangles;
      const double off_shape = std::fabs(around - wished) / wished;
      const double cost = off_count + 0.01 * off_shape;
      if (best.around == 0 || cost < best_cost) {
        best = {around, k};
        best_cost = cost;
      }
    }
  }
  return best;
}

}  // namespace thigma::models
