#pragma once
// Size and mass of a mesh, by exact integration over its surface.

#include <span>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// A ball.
struct Ball {
  Vec3 center = Vec3::Zero();  // [m; body frame]
  double radius = 0.0;         // [m]
};

/// Axis-aligned bounds; min > max when empty.
struct Bounds {
  Vec3 min = Vec3::Constant(1.0);
  Vec3 max = Vec3::Constant(-1.0);
};

/// Mass properties of the solid a closed surface encloses, for unit density.
/// volume is signed: negative when the surface is inside out; regions enclosed twice count twice.
/// Of an open surface only area means anything.
struct MassProperties {
  double area = 0.0;                   // [m^2]
  double volume = 0.0;                 // [m^3]
  Vec3 center_of_mass = Vec3::Zero();  // [m; body frame]; of the bounds when the volume is 0
  Mat3 inertia = Mat3::Zero();  // about the centre of mass, body axes, density 1 kg/m^3 [kg m^2]
};

/// Area, volume, centre of mass and inertia tensor. The sums run about the middle of the bounds and
/// in their scale, so that neither a large offset nor a small unit costs digits.
///
/// mesh      positions finite, indices in range; zero-area triangles add nothing
/// Thread    [offline].
/// Source    divergence theorem; tetrahedra from a common origin: the integral of x x^T over one
///           with edges a, b, c is det(a, b, c) / 120 (a a^T + b b^T + c c^T + s s^T),
///           s = a + b + c.
MassProperties mass_properties(const TriangleMesh& mesh);

/// Smallest ball around the points, to 1e-9 of its radius; all of them lie inside it to rounding.
///
/// points    finite (n); an empty span gives radius 0 at the origin
/// Thread    [offline]; deterministic.
/// Source    farthest-point pivoting over support sets of at most four points (after Gaertner
///           1999).
Ball enclosing_ball(std::span<const Vec3> points);

/// Smallest axis-aligned box of the points.
Bounds bounds_of(std::span<const Vec3> points);

}  // namespace thigma
