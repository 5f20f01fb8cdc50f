#include "thigma/convex/hull.h"

#include <algorithm>

#include "thigma/convex/quickhull.h"
#include "thigma/core/error.h"

namespace thigma {

ConvexHull build_hull(std::span<const Vec3> points, double relative_tolerance) {
  if (points.empty()) throw InputError("convex hull: no point, expected at least one");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite())
      throw InputError("convex hull: point " + std::to_string(i) + " is not finite");
  Quickhull grown;
  start_hull(grown, points, relative_tolerance);
  complete_hull(grown);
  return to_hull(grown, points);
}

ConvexHull to_hull(const Quickhull& grown, std::span<const Vec3> points) {
  ConvexHull hull;
  hull.dimension = grown.dimension;
  std::vector<std::int32_t> place(points.size(), -1);
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  if (grown.dimension < 3) hull.source = grown.vertices;
  for (const GrowingFace& face : grown.faces) {
    if (!face.is_alive) continue;
    for (const std::int32_t v : face.corner)
      if (place[at(v)]++ < 0) hull.source.push_back(v);
  }
  std::sort(hull.source.begin(), hull.source.end());
  for (std::size_t i = 0; i < hull.source.size(); ++i) {
    place[at(hull.source[i])] = static_cast<std::int32_t>(i);
    hull.vertices.push_back(points[at(hull.source[i])]);
  }
  for (const GrowingFace& face : grown.faces)
    if (face.is_alive)
      hull.triangles.push_back(
          {place[at(face.corner[0])], place[at(face.corner[1])], place[at(face.corner[2])]});
  if (grown.dimension == 2) {
    const auto& rim = grown.vertices;
    for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
      const std::int32_t a = place[at(rim[0])], b = place[at(rim[i])], c = place[at(rim[i + 1])];
      hull.triangles.push_back({a, b, c});
      hull.triangles.push_back({a, c, b});
    }
  }
  return hull;
}

}  // namespace thigma
