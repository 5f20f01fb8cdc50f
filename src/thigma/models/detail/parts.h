#pragma once
// Simple solids and machine parts at a wished triangle count. All closed, in metres, centred at the
// origin.

#include <vector>

#include "thigma/math/elementary.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::models {

/// Near-icosahedral where 20 f^2 comes within 1 % of the count (2,000 is exact), else with poles;
/// convex.
TriangleMesh make_ellipsoid_near(const Vec3& semi_axes, int triangles);
TriangleMesh make_box_near(const Vec3& size, int triangles);  // segments of nearly equal length
TriangleMesh make_cylinder_near(double radius, double height, int triangles);
TriangleMesh make_cone_near(double radius, double height, int triangles);
TriangleMesh make_torus_near(double major_radius, double minor_radius, int triangles);

/// Turned about z.
/// corners       of the profile (distance from the axis, height), from the axis to the axis,
///               counter-clockwise about the solid [m]; each stays a corner
/// wished_ratio  of vertices along the profile to those around
TriangleMesh make_turned_near(const std::vector<Vec2>& corners, int triangles, double wished_ratio);

TriangleMesh make_gear(int triangles);   // 20 teeth, 50 mm across, 8 mm thick, bore 10 mm; genus 1
TriangleMesh make_probe(int triangles);  // 20 mm thick, 100 mm long, axis z, below a half ball
TriangleMesh make_peg(int triangles);    // 16 mm thick, 50 mm long, axis z, chamfered below
TriangleMesh make_hole(
    int triangles);  // square block 50 mm wide, 20 mm high, with a hole of 16.4 mm along z; genus 1

}  // namespace thigma::models
