#pragma once
// Two convex edges: whether their cones of normals face each other, so that they may touch first.

#include "thigma/constraint/detail/row_search.h"

namespace thigma::detail {

/// Which of the two senses of the object's direction x the scene's may point into the scene.
struct ConesMeet {
  bool plus = false, minus = false;
  double sine = 0.0;  // of the angle between the edges
};

inline RowScratch::EdgeCone cone_of(const ConvexEdge& edge, std::int32_t index,
                                    const Mat3& object_from_scene) noexcept {
  return {index, object_from_scene * edge.direction, object_from_scene * edge.into_left,
          object_from_scene * edge.into_right};
}

/// By the cross product of the object's direction and the scene's [object's mesh frame].
/// slack  sine of the angle by which turning may widen the cones
inline ConesMeet meet(const Vec3& cross, const ConvexEdge& e, const RowScratch::EdgeCone& f,
                      double slack) noexcept {
  ConesMeet found;
  found.sine = cross.norm();
  // Turning by an angle turns the normal by that and by as much over the sine.
  const double s = slack * (1.0 + found.sine);
  const double out_left = cross.dot(e.into_left), out_right = cross.dot(e.into_right);
  const double in_left = cross.dot(f.into_left), in_right = cross.dot(f.into_right);
  found.plus = out_left <= s && out_right <= s && in_left >= -s && in_right >= -s;
  found.minus = out_left >= -s && out_right >= -s && in_left <= s && in_right <= s;
  return found;
}

inline bool cones_meet(const ConvexEdge& e, const RowScratch::EdgeCone& f, double slack) noexcept {
  const ConesMeet found = meet(e.direction.cross(f.direction), e, f, slack);
  return found.plus || found.minus;
}

}  // namespace thigma::detail
