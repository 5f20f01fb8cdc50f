#pragma once
// Directional depth between two fine meshes, exactly: what a texture's depth is compared with.
// Shares no code with textures.

#include <cstdint>
#include <span>

#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::experiments {

/// One side of a contact: a fine mesh, and the coarse triangles that the contact is about, which
/// say where to look.
struct FineSide {
  const TriangleMesh* fine = nullptr;       // [m; body frame]
  const TriangleMesh* coarse = nullptr;     // [m; the same frame]
  std::span<const std::int32_t> triangles;  // of `coarse`
  Pose world_from_body;
};

struct FineDepth {
  bool is_found = false;    // some place has both surfaces over it
  double depth = 0.0;       // the largest sum of heights [m]
  double u = 0.0, v = 0.0;  // where [m; contact plane]
  // the end of a side's coarse triangles holds it: it would be deeper beyond
  bool is_at_rim = false;
};

/// The largest depth along the third axis of a frame, over the places where coarse triangles of
/// both sides lie that face each other. Heights are those of the outermost fine triangle that faces
/// the same way and lies no farther than `band` from the outermost coarse one, along the axis.
///
/// world_from_contact, origin  the frame: columns u, v, n; n from the object into the scene
/// Both surfaces are flat between edges, so the largest sum is over a vertex, or where edges of the
/// four meshes cross: all of them are tried that could hold it, and only rounding is left (1e-12 of
/// the coordinates).
/// Thread   [offline]; deterministic.
FineDepth fine_depth(const FineSide& object, const FineSide& scene, const Mat3& world_from_contact,
                     const Vec3& origin, double band);

}  // namespace thigma::experiments
