#include "thigma/contact/multires/patch_at_level.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

// Weights of the corners of a triangle for the point of its plane below p, clamped to the triangle;
// n across it.
Vec3 clamped_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                     const Vec3& n) noexcept {
  if (!(n.squaredNorm() > 0.0)) return Vec3::Constant(1.0 / 3.0);
  const double u = std::max((c - b).cross(p - b).dot(n), 0.0);
  const double v = std::max((a - c).cross(p - c).dot(n), 0.0);
  const double w = std::max((b - a).cross(p - a).dot(n), 0.0);
  return Vec3(u, v, w) / (u + v + w);
}

}  // namespace

PatchAtLevel patch_at_level(const ClodHierarchy& hierarchy, std::int32_t i) noexcept {
  const ClodNode& node = hierarchy.nodes[idx(i)];
  return {hierarchy, node, level_surface(hierarchy, i),
          node.contact >= 0 ? &hierarchy.level_patches[idx(node.contact)] : nullptr};
}

SurfaceLocation locate(const HullView& view, std::uint32_t feature, const Vec3& p) noexcept {
  SurfaceLocation location;
  if (std::popcount(feature) == 1) {
    location.corner[0] = std::countr_zero(feature);
    return location;
  }
  if (std::popcount(feature) == 2) {
    location.corner[0] = std::countr_zero(feature);
    location.corner[1] = 31 - std::countl_zero(feature);
    const Vec3 e = view.vertices[location.corner[1]] - view.vertices[location.corner[0]];
    const double length2 = e.squaredNorm();
    const double t = length2 > 0.0 ? (p - view.vertices[location.corner[0]]).dot(e) / length2 : 0.5;
    const double clamped = std::min(std::max(t, 0.0), 1.0);
    location.weight = Vec3(1.0 - clamped, clamped, 0.0);
    return location;
  }
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < view.triangle_count; ++t) {
    const HullTriangle& tri = view.triangles[t];
    if ((tri.mask & feature) != (feature != 0 ? tri.mask : 0)) continue;
    const Vec3 &a = view.vertices[tri.corner[0]], &b = view.vertices[tri.corner[1]],
               &c = view.vertices[tri.corner[2]];
    const Vec3 n = (b - a).cross(c - a);
    const double height = n.dot(p - a);
    if (height * height > least * n.squaredNorm()) continue;
    const Vec3 weight = clamped_weights(p, a, b, c, n);
    const double d2 = (weight.x() * a + weight.y() * b + weight.z() * c - p).squaredNorm();
    if (!(d2 < least)) continue;
    least = d2;
    location = {{tri.corner[0], tri.corner[1], tri.corner[2]}, weight, t};
  }
  return location;
}

double support_area(const PatchAtLevel& patch, const SurfaceLocation& location,
                    SupportReading reading) noexcept {
  if (patch.hierarchy.support.empty()) return 0.0;  // no simplified levels
  const std::array<double, 2>* first =
      patch.hierarchy.support.data() + (patch.view.vertices - patch.hierarchy.vertices.data());
  const auto r = static_cast<std::size_t>(reading);
  double area = 0.0;
  for (int k = 0; k < 3; ++k) {
    if (location.weight[k] > 0.0) area += location.weight[k] * first[location.corner[k]][r];
  }
  return area;
}

double distance_to_below(const PatchAtLevel& patch, const SurfaceLocation& location,
                         const Vec3& p) noexcept {
  if (patch.is_finest()) return 0.0;
  const float* vertex = patch.hierarchy.vertex_to_below.data() + patch.level_patch->first_vertex;
  if (location.weight.x() == 1.0) return vertex[location.corner[0]];
  double least = patch.level_patch->to_below;
  if (location.triangle >= 0) {
    least =
        patch.hierarchy
            .triangle_to_below[idx(patch.level_patch->patch.first_triangle + location.triangle)];
  }
  for (int k = 0; k < 3; ++k) {  // distances change no faster than the location
    if (!(location.weight[k] > 0.0)) continue;
    least = std::min(
        least, vertex[location.corner[k]] + (p - patch.view.vertices[location.corner[k]]).norm());
  }
  return least;
}

}  // namespace thigma::detail
