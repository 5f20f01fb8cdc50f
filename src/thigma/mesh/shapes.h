#pragma once
// Basic shapes: for tests, and as parts of the models in models/.
//
// Unless a shape says otherwise it is one closed surface with shared vertices, counter-clockwise
// seen from outside, centred at the origin, sizes in metres. Counts below the least a shape needs
// are asserts.

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Which ends of a grid of quadrilaterals are joined to each other.
enum class GridEnds : std::uint8_t { open, rows_joined, columns_joined, both_joined };

/// Grid of rows x columns vertices, each quadrilateral in two triangles; the surface normal is
/// d/dcolumn x d/drow.
///
/// rows, columns  vertices along each way, >= 2 (>= 3 where joined)
/// ends           rows_joined: the last row is followed by row 0; columns_joined likewise
/// point          position of vertex (row, column) [m]
/// Thread         [offline]
TriangleMesh make_grid(int rows, int columns, GridEnds ends,
                       const std::function<Vec3(int, int)>& point);

/// Profile (x = distance from the axis >= 0, y = height) turned about z.
///
/// profile  from bottom to top, >= 2 points; a first or last point on the axis closes the surface
///          there with one vertex, otherwise the surface is open at that end
/// around   segments of a turn, >= 3
TriangleMesh make_revolution(std::span<const Vec2> profile, int around);

/// Surface of the lattice cells for which `is_solid` holds: L-shapes, steps, plates with holes,
/// cavities.
///
/// xs, ys, zs  increasing coordinates of the lattice planes [m], >= 2 each
/// is_solid    of cell (i, j, k), 0..xs.size()-2 and so on. Cells that touch along one edge or at
///             one corner only give a non-manifold surface.
TriangleMesh make_blocks(std::span<const double> xs, std::span<const double> ys,
                         std::span<const double> zs,
                         const std::function<bool(int, int, int)>& is_solid);

TriangleMesh make_tetrahedron(double edge);  // regular; 4 triangles
TriangleMesh make_box(const Vec3& size,
                      std::array<int, 3> segments = {1, 1, 1});     // segments along x, y, z
TriangleMesh make_ball(double radius, int frequency);               // icosahedral, 20 f^2 triangles
TriangleMesh make_ellipsoid(const Vec3& semi_axes, int frequency);  // convex; 20 f^2 triangles
TriangleMesh make_polar_ellipsoid(const Vec3& semi_axes, int around,
                                  int along);  // 2 around (along - 1)
TriangleMesh make_cylinder(double radius, double height, int around, int along = 1,
                           int radial = 1);  // axis z
TriangleMesh make_cone(double radius, double height, int around, int along = 1,
                       int radial = 1);  // tip at +z
TriangleMesh make_capsule(double radius, double height, int around,
                          int along = 1);  // height without its caps
TriangleMesh make_torus(double major_radius, double minor_radius, int around,
                        int across);  // 2 around across
TriangleMesh make_l_shape(
    double size, double thickness);  // arms along +x and +z, corner at the origin; no segments

/// Open: rectangle in the plane z = 0, normals +z, 2 nx ny triangles.
TriangleMesh make_sheet(double size_x, double size_y, int nx, int ny);
/// Open: half a ball's surface, z >= 0.
TriangleMesh make_dome(double radius, int around, int along);
/// Not orientable: band of one half twist, 2 around across triangles; around >= 3, across >= 1.
TriangleMesh make_moebius(double radius, double width, int around, int across = 1);
/// Two components: a ball with a concentric spherical cavity, the inner surface facing inwards.
TriangleMesh make_hollow_ball(double outer_radius, double inner_radius, int frequency);

/// b placed beside a in one mesh; nothing is merged.
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);
/// Scaled about the origin, then posed.
TriangleMesh transformed(TriangleMesh mesh, const Pose& pose, double scale = 1.0);
/// The other side out.
TriangleMesh flipped(TriangleMesh mesh);
/// Every triangle with three vertices of its own, as STL has it.
TriangleMesh unwelded(const TriangleMesh& mesh);

}  // namespace thigma
