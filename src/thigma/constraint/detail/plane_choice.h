#pragma once
// Which of several planes that all keep two features apart forbids least of what nothing else does.

#include <array>
#include <span>

#include "thigma/constraint/detail/row_search.h"
#include "thigma/core/static_vector.h"

namespace thigma::detail {

/// Of the travel: by how much a plane has to forbid less than another to be the better one.
inline constexpr double kEqual = 1e-3;

/// Of the travel: with nothing nearer the object is in the air.
inline constexpr double kInTheAir = 0.1;

/// Begins what is known with the nearest contact of the two bodies. Other contacts say nothing:
/// from a patch to the neighbour of the one that it lies on the nearest way leads aside.
///
/// contacts  of any bodies; those with others are passed over
/// search    its `known` is written
/// Thread    [contact]; no failure
void find_known(std::span<const Contact> contacts, RowSearch& search) noexcept;

/// Whether nothing is so near that the object slides on it. Thread [contact].
bool is_in_the_air(const RowSearch& search) noexcept;

/// Adds a limit; of those of about one direction the nearest is kept. Thread [contact].
void add_known(RowSearch& search, const KnownLimit& limit) noexcept;

/// The same of a vertex over a triangle, both surfaces convex towards each other there.
///
/// points        of which body the vertex is
/// plane_normal  the triangle's [its mesh frame]
/// height        of the vertex over it [m]
/// Thread        [contact]; no failure
void add_known(RowSearch& search, PointsOf points, const Vec3& plane_normal,
               double height) noexcept;

/// Whether something known has about this normal. Thread [contact].
bool is_known(const RowSearch& search, const Vec3& normal) noexcept;

/// How far the object could go beyond a plane on the way that it is likely to go, if only the known
/// limits held it: what a row with that plane forbids of its own, 0 where it adds nothing.
///
/// at       of what the plane may meet: of the vertex, or of the edges where they are nearest; the
///          likely way goes along the normal there [scene's mesh frame]
/// normal   unit, out of the object, into the scene [scene's mesh frame]
/// height   of the vertex over the plane [m]
/// Thread   [contact]; no failure
/// Source   A way x with n . x <= g and |x| <= t has m . x <= g (m . n) + t |m - (m . n) n|.
double forbidden(const RowSearch& search, const Vec3& at, const Vec3& normal,
                 double height) noexcept;

/// The same, where the vertex has planes of its own as well.
double forbidden(const RowSearch& search, PointsOf points, const Vec3& point, std::int32_t vertex,
                 const VertexSide& side, const GuardPlane& plane) noexcept;

/// Whether a vertex may be given a row with a plane at this height though the triangle or edge
/// behind it is farther: not where it would push what nothing else pushes.
bool may_keep(const RowSearch& search, double height, double distance) noexcept;

/// The least height over a plane of others at which a vertex may share it. Where something is near
/// the object slides on, so the plane has to be beyond where it is likely to come until the next
/// model; in the air half of the distance to what is behind the plane is enough, and far fewer rows
/// are needed.
double least_shared(const RowSearch& search, double distance) noexcept;

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

}  // namespace thigma::detail
