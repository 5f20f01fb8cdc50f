#include "thigma/contact/detail/level_side.h"

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

Side side_of(const ClodHierarchy& h, std::int32_t i) noexcept {
  const ClodNode& node = h.nodes[at(i)];
  return {h, node, level_surface(h, i),
          node.contact >= 0 ? &h.level_patches[at(node.contact)] : nullptr};
}

Place find_place(const HullView& view, std::uint32_t feature, const Vec3& p) noexcept {
  Place place;
  if (std::popcount(feature) == 1) {
    place.corner[0] = std::countr_zero(feature);
    return place;
  }
  if (std::popcount(feature) == 2) {
    place.corner[0] = std::countr_zero(feature);
    place.corner[1] = 31 - std::countl_zero(feature);
    const Vec3 e = view.vertices[place.corner[1]] - view.vertices[place.corner[0]];
    const double length2 = e.squaredNorm();
    const double t = length2 > 0.0 ? (p - view.vertices[place.corner[0]]).dot(e) / length2 : 0.5;
    const double clamped = std::min(std::max(t, 0.0), 1.0);
    place.weight = Vec3(1.0 - clamped, clamped, 0.0);
    return place;
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
    place = {{tri.corner[0], tri.corner[1], tri.corner[2]}, weight, t};
  }
  return place;
}

double support_area(const Side& side, const Place& place, SupportReading reading) noexcept {
  if (side.h.support.empty()) return 0.0;  // no simplified levels
  const std::array<double, 2>* first =
      side.h.support.data() + (side.view.vertices - side.h.vertices.data());
  const auto r = static_cast<std::size_t>(reading);
  double area = 0.0;
  for (int k = 0; k < 3; ++k) {
    if (place.weight[k] > 0.0) area += place.weight[k] * first[place.corner[k]][r];
  }
  return area;
}

double distance_to_below(const Side& side, const Place& place, const Vec3& p) noexcept {
  if (side.is_finest()) return 0.0;
  const float* vertex = side.h.vertex_to_below.data() + side.patch->first_vertex;
  if (place.weight.x() == 1.0) return vertex[place.corner[0]];
  double least = side.patch->to_below;
  if (place.triangle >= 0) {
    least = side.h.triangle_to_below[at(side.patch->patch.first_triangle + place.triangle)];
  }
  for (int k = 0; k < 3; ++k) {  // distances change no faster than the place
    if (!(place.weight[k] > 0.0)) continue;
    least =
        std::min(least, vertex[place.corner[k]] + (p - side.view.vertices[place.corner[k]]).norm());
  }
  return least;
}

}  // namespace thigma::detail
