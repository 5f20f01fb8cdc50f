#pragma once
// The area of one surface that lies inside another, or within a tolerance of it.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/response/potential_law.h"
#include "thigma/response/solid_surface.h"

namespace thigma {

/// What is integrated over the area.
struct OverlapTask {
  const SolidSurface& from;  // the surface
  const SolidSurface& into;  // what it may lie in
  Pose world_from, world_into;
  Vec3 centre = Vec3::Zero();  // of the object's mass [m; world]
  bool is_object = true;       // `from` is the object, `into` a body of the scene; else the reverse
  double tolerance = 0.0;      // [m]
  int exponent = 4;            // p of the law
  double weight = 1.0;         // of all areas
  double size = 0.0;           // of what the area is resolved by: a share of it [m]
};

/// A point of the surface and how deep it lies.
struct OverlapSample {
  Vec3 at = Vec3::Zero();       // [m; frame of what it may lie in]
  double w = 0.0;               // depth + tolerance [m]
  Vec3 outward = Vec3::Zero();  // as of PointDepth
};

/// Depths of the vertices of a surface, as far as the present overlap knows them. Any content of
/// the right size is valid.
struct OverlapScratch {
  std::vector<OverlapSample> vertices;
  std::vector<std::uint32_t> known;  // the overlap it was asked for in, by vertex
  std::uint32_t overlap = 0;
};

/// Room for the vertices of a surface. Thread [offline]; throws std::bad_alloc.
void reserve_overlap(const SolidSurface& surface, OverlapScratch& scratch);

/// Counts of one overlap.
struct OverlapStats {
  std::int64_t points = 0;  // whose depth was asked for
  std::int64_t cells = 0;   // integrated over
};

/// Integrates where depth + tolerance > 0. Triangles are divided until the depth is linear over
/// each part within 1 % of the deepest, or the part smaller than 1/96 of the size. Over a
/// part it is what its corners say, linear between them and cut off where it ends, and integrated
/// without error; so are its gradients, which makes them those of the sum, however coarse it is.
/// What a triangle hides between a 24th of the size is not seen from this side.
///
/// scratch  reserved for task.from
/// moments  added to
/// Thread   [contact]; no failure, nothing allocated.
OverlapStats add_overlap(const OverlapTask& task, OverlapScratch& scratch,
                         PotentialMoments& moments) noexcept;

}  // namespace thigma
