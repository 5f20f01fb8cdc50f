#pragma once
// The surface with the vertices and the one with the planes.

#include "thigma/constraint/detail/row_search.h"
#include "thigma/core/index.h"

namespace thigma::detail {

struct Sides {
  const SurfaceFeatures& points;
  const SurfaceFeatures& planes;
  const Pose& planes_from_points;
  const Mat3& rotation;  // of it
  PointsOf points_of;

  /// A vertex in the frame of the planes.
  Vec3 point(std::int32_t vertex) const noexcept {
    return transform_point(planes_from_points, points.vertices[idx(vertex)]);
  }
  /// The same to rounding, in fewer operations: for many.
  Vec3 placed(std::int32_t vertex) const noexcept {
    return rotation * points.vertices[idx(vertex)] + planes_from_points.position;
  }
};

inline Sides sides_of(const RowSearch& s, PointsOf points_of) noexcept {
  const bool is_object = points_of == PointsOf::object;
  const SurfaceFeatures &object = *s.object.features, &scene = *s.scene.features;
  return {is_object ? object : scene, is_object ? scene : object,
          is_object ? s.scene_from_object : s.object_from_scene,
          is_object ? s.to_scene : s.to_object, points_of};
}

/// Whether the surface about a vertex stays in front of a plane through it, but for what turning
/// may do: only then may the vertex be the first to touch a face of that normal.
///
/// normal  unit [frame of the points]
/// slack   sine of the angle that is let pass
/// Thread  [contact]; no failure
inline bool may_touch(const SurfaceFeatures& points, std::int32_t vertex, const Vec3& normal,
                      double slack) noexcept {
  const std::int32_t last = points.first_direction[idx(vertex) + 1];
  for (std::int32_t i = points.first_direction[idx(vertex)]; i < last; ++i)
    if (points.directions[idx(i)].dot(normal) < -slack) return false;
  return true;
}

}  // namespace thigma::detail
