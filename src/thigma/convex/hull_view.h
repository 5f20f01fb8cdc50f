#pragma once
// One convex hull as the pair queries read it: small, flat, not owning, in the frame of its body.

#include <cstdint>

#include "thigma/math/types.h"

namespace thigma {

/// The most vertices a hull of a hierarchy may have; subsets of them are 32-bit masks.
inline constexpr int kMaxHullVertices = 32;

/// A face of the hull that belongs to the surface: where the surface is, contact may push along its
/// normal.
struct RealFace {
  Vec3 normal;                 // unit, outward [body frame]
  double offset = 0.0;         // normal . p of the plane [m]
  std::uint32_t vertices = 0;  // mask of the hull vertices on the face
};

/// An edge of the hull that is an edge of the surface, convex or flat, interior or boundary.
struct RealEdge {
  std::uint8_t tail = 0, head = 0;  // hull vertices
  // into the hull's real faces, -1 where the patch ends
  std::int16_t face_left = -1, face_right = -1;
  // Only where the patch ends and the object's surface goes on over a convex or flat edge: the unit
  // normal of the triangle beyond, so that the edge's normal cone is exact. Zero at reflex edges
  // and where the surface ends.
  Vec3 beyond = Vec3::Zero();
};

/// A triangle of the original mesh, by hull vertices. All triangles of a patch lie on its hull.
struct HullTriangle {
  std::uint8_t corner[3] = {0, 0, 0};  // counter-clockwise from outside
  std::uint32_t mask = 0;              // the three corners
};

/// Non-owning view of a hull of 1..32 vertices.
/// Inner nodes of a hierarchy have vertices only; finest patches have real faces, edges and
/// triangles too.
struct HullView {
  const Vec3* vertices = nullptr;  // [m; body frame]
  int vertex_count = 0;
  // The same vertices minus `center`, in single precision, as x[lanes] y[lanes] z[lanes]; lanes is
  // vertex_count rounded up to a multiple of 8, padded by repeating the last vertex. 32-byte
  // aligned.
  const float* lanes = nullptr;
  int lane_count = 0;
  Vec3 center = Vec3::Zero();  // of the bounding sphere [m; body frame]
  double radius = 0.0;         // of the bounding sphere [m]
  const RealFace* faces = nullptr;
  int face_count = 0;
  const RealEdge* edges = nullptr;
  int edge_count = 0;
  const HullTriangle* triangles = nullptr;
  int triangle_count = 0;
  double thickness = 0.0;  // smallest width of the hull along a real face's normal [m]
};

}  // namespace thigma
