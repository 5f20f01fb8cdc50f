#pragma once
// Signs of determinants, exactly: what geometry decides by comparing, rounding must not decide.

#include "thigma/math/types.h"

namespace thigma {

/// Side of the plane through a, b, c on which d lies: +1 in front (where a, b, c run
/// counter-clockwise), -1 behind, 0 exactly on it. Antisymmetric in any two points.
///
/// Exact while no nonzero coordinate is below about 1e-85 or above 1e50 (then products underflow or
/// overflow).
/// Thread    [offline] by use; neither allocates nor throws. A rounded determinant answers where it
///           is certain, expansions of doubles (Dekker 1971, Priest 1991) where it is not.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept;

/// +1 when a, b, c run counter-clockwise, -1 clockwise, 0 exactly on a line. As orient3d.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) noexcept;

/// Whether three points lie exactly on one line, or coincide.
bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c) noexcept;

/// Whether the closed segment p q and the closed triangle a b c have a point in common, exactly.
/// The triangle must not be collinear; p = q is allowed.
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                            const Vec3& c) noexcept;

/// Whether two closed triangles of one plane, a b c and d e f, have a point in common, exactly.
/// Neither is collinear.
bool coplanar_triangles_meet(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                             const Vec3& e, const Vec3& f) noexcept;

}  // namespace thigma
