#pragma once
// Which of several planes that all keep two features apart forbids least of what nothing else does.

#include <array>
#include <span>

#include "thigma/constraint/detail/row_search.h"
#include "thigma/core/static_vector.h"

namespace thigma::detail {

/// Of the travel: what a plane that adds next to nothing to what is known forbids at most, and by
/// how much one has to forbid less than another to be the better one.
inline constexpr double kNothing = 0.05, kEqual = 1e-3;

/// Times the least height: so that a plane that is tilted a little still leaves it.
inline constexpr double kSpare = 1.2;

/// Begins what is known with the nearest contact of the two bodies. Other contacts say nothing:
/// from a patch to the neighbour of the one that it lies on the nearest way leads aside.
///
/// contacts  of any bodies; those with others are passed over
/// search    its `known` is written
/// Thread    [contact]; no failure
void find_known(std::span<const Contact> contacts, RowSearch& search) noexcept;

/// Adds a limit; of those of about one direction the nearest is kept. Thread [contact].
void add_known(RowSearch& search, const KnownLimit& limit) noexcept;

/// The same of a vertex over a triangle, both surfaces convex towards each other there.
///
/// points        of which body the vertex is
/// plane_normal  the triangle's [its mesh frame]
/// height        of the vertex over it [m]
/// Thread        [contact]; no failure
void add_known(RowSearch& search, PointsOf points, const Vec3& plane_normal, double height) noexcept;

/// Whether something known has about this normal. Thread [contact].
bool is_known(const RowSearch& search, const Vec3& normal) noexcept;

/// How far the object could go beyond a plane within the travel, if only the known limits held it:
/// what a row with that plane forbids of its own. At most 0 where it adds nothing.
///
/// normal   unit, out of the object, into the scene [scene's mesh frame]
/// height   of the vertex over the plane [m]
/// Thread   [contact]; no failure
/// Source   A way x with n . x <= g and |x| <= t has m . x <= g (m . n) + t |m - (m . n) n|.
double forbidden(const RowSearch& search, const Vec3& normal, double height) noexcept;

/// The same, where the vertex has planes of its own as well.
double forbidden(const RowSearch& search, PointsOf points, const Vec3& point, std::int32_t vertex,
                 const VertexSide& side, const GuardPlane& plane) noexcept;

/// Whether a vertex may be given a row with a plane at this height though the triangle or edge
/// behind it is farther: not where it would push what nothing else pushes.
bool may_keep(const RowSearch& search, double height, double distance) noexcept;

/// Planes through a convex edge that the surface about it lies behind: its faces', and between
/// them the one that two points lie farthest in front of. Zero normals: none.
///
/// edge     with its faces; on_edge: a point of it; a, b: the points [all in its mesh frame]
/// Thread   [contact]; no failure
struct EdgePlanes {
  std::array<Vec3, 3> normal{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  // unit, outward
};
EdgePlanes planes_through(const ConvexEdge& edge, const Vec3& on_edge, const Vec3& a,
                          const Vec3& b) noexcept;

/// Unit normals near to one that is wished for, of planes that some points do not lie behind.
using Normals = StaticVector<Vec3, 11>;

/// The wish itself and what is nearest to it where some of the ways point behind its plane: at
/// most one of these is the best, all of them will do.
///
/// wish      unit
/// ways      from a point of the plane to those that have to stay in front of it; at most 4 [m]
/// rounding  lengths below it are none [m]
/// Thread    [contact]; no failure
/// Source    Projection onto a polyhedral cone: none, one or two of the ways lie in the plane.
Normals normals_near(const Vec3& wish, std::span<const Vec3> ways, double rounding) noexcept;

/// What is known to be near, as wishes for planes that `points` are kept in front of: unit, out of
/// the surface with the planes [its mesh frame]. Thread [contact].
Vec3 wish_of(const RowSearch& search, PointsOf points, const KnownLimit& known) noexcept;

/// The height below which a plane may not be given to a vertex so far from what lies behind it, see
/// may_keep [m].
double least_height(const RowSearch& search, double distance) noexcept;

}  // namespace thigma::detail
