#include "experiments/relief/fine_bodies.h"

#include <algorithm>
#include <string>

#include "thigma/core/index.h"
#include "thigma/models/textured_parts.h"

namespace thigma::experiments::relief {
namespace {

bool is_slab(const std::string& name) {
  return name == "ridged_plate" || name == "striped_block" || name == "ridged_block";
}

/// Rows and columns of a slab's top that become vertices; the last always.
std::vector<int> places(int texels, int step) {
  std::vector<int> list;
  for (int i = 0; i < texels - 1; i += step) list.push_back(i);
  list.push_back(texels - 1);
  return list;
}

/// The top of a slab by its texels, walls from its border down, and the bottom.
TriangleMesh slab_mesh(const HapticTexture& texture, int texels, int step) {
  Vec3 low = texture.coarse.positions[0], high = low;
  for (const Vec3& p : texture.coarse.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const std::vector<int> at = places(texels, step);
  const int n = static_cast<int>(at.size());
  TriangleMesh mesh;
  const auto add_grid = [&](bool is_top) {
    for (const int row : at) {
      for (const int column : at) {
        const double x = low.x() + (high.x() - low.x()) * column / (texels - 1),
                     y = low.y() + (high.y() - low.y()) * row / (texels - 1);
        const double up = static_cast<double>(texel_at(texture, column, row).z);
        mesh.positions.push_back({x, y, is_top ? high.z() + up : low.z()});
      }
    }
  };
  add_grid(true);
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (std::int32_t j = 0; j + 1 < n; ++j)
    for (std::int32_t i = 0; i + 1 < n; ++i)
      add(j * n + i, j * n + i + 1, (j + 1) * n + i + 1, (j + 1) * n + i);
  std::vector<std::int32_t> border;  // anticlockwise from above
  for (std::int32_t i = 0; i + 1 < n; ++i) border.push_back(i);
  for (std::int32_t j = 0; j + 1 < n; ++j) border.push_back(j * n + n - 1);
  for (std::int32_t i = n - 1; i > 0; --i) border.push_back((n - 1) * n + i);
  for (std::int32_t j = n - 1; j > 0; --j) border.push_back(j * n);
  const std::int32_t first = n * n, count = static_cast<std::int32_t>(border.size());
  for (const std::int32_t v : border) {
    const Vec3 p = mesh.positions[idx(v)];
    mesh.positions.push_back({p.x(), p.y(), low.z()});
  }
  mesh.positions.push_back({0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), low.z()});
  for (std::int32_t k = 0; k < count; ++k) {
    const std::int32_t next = (k + 1) % count;
    add(border[idx(k)], first + k, first + next, border[idx(next)]);
    mesh.triangles.push_back({first + k, first + count, first + next});
  }
  return mesh;
}

double depth_in(const DepthSurface& a, const Pose& b_from_a, const DepthSurface& b) {
  const DepthSurface::Node& all = b.nodes.front();
  double deepest = 0.0;
  for (const Vec3& p : a.mesh.positions) {
    const Vec3 q = transform_point(b_from_a, p);
    if (!(q.array() >= all.low.array()).all() || !(q.array() <= all.high.array()).all()) continue;
    deepest = std::max(deepest, -signed_distance(b, q));
  }
  return deepest;
}

}  // namespace

DepthSurface fine_surface(const SceneObject& object, const HapticTexture& texture, int step) {
  if (!object.is_textured) return make_depth_surface(texture.coarse);
  const std::string name = object.textured_model ? object.textured_model->name : "";
  if (is_slab(name)) {
    constexpr int kTexels = 1024;
    return make_depth_surface(slab_mesh(texture, kTexels, step));
  }
  return make_depth_surface(models::make_fine_sheets(models::textured_part(name)));
}

double vertex_depth(const DepthSurface& a, const Pose& world_from_a, const DepthSurface& b,
                    const Pose& world_from_b) {
  return std::max(depth_in(a, inverse(world_from_b) * world_from_a, b),
                  depth_in(b, inverse(world_from_a) * world_from_b, a));
}

}  // namespace thigma::experiments::relief
