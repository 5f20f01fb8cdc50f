#pragma once
// Closed surfaces from a profile, with nearly equilateral triangles and an exact count.

#include <functional>
#include <vector>

#include "thigma/math/elementary.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::models {

/// A point of the outline that is turned about the axis z.
struct ProfilePoint {
  Vec2 place = Vec2::Zero();   // distance from the axis, height [m]
  Vec2 normal = Vec2::Zero();  // out of the solid, unit, same axes
  double density = 1.0;        // of triangle edges per length against other points
};

/// A circular arc of a profile.
struct ProfileArc {
  Vec2 centre = Vec2::Zero();   // [m]
  double radius = 0.0;          // [m]
  double from = 0.0, to = 0.0;  // angles from the axis of distance towards that of height [rad]
  bool is_outer = true;         // the solid is on the side of the centre
  double density = 1.0;
};

/// Points along an arc, both ends included.
void add_arc(std::vector<ProfilePoint>& profile, const ProfileArc& arc);

/// Points along a straight piece, both ends included; the solid is on its left.
void add_line(std::vector<ProfilePoint>& profile, const Vec2& from, const Vec2& to,
              double density = 1.0);

/// Turns a profile into rings whose vertex counts follow their length, and joins neighbours.
///
/// profile    from the axis to the axis, counter-clockwise about the solid: from its bottom
///            outwards; finer than the edges asked for
/// triangles  met exactly where even (one less where odd), from a few hundred upwards
/// place      where the surface is, for a point of the profile and a turn about z; small changes
///            only, or such that no two triangles cross
/// Thread     [offline]
TriangleMesh make_ring_surface(
    const std::vector<ProfilePoint>& profile, int triangles,
    const std::function<Vec3(const ProfilePoint& at, const SinCos& turn)>& place);

/// The place of a turned profile itself, moved along its normal.
Vec3 turned_place(const ProfilePoint& at, const SinCos& turn, double outwards = 0.0);

/// A relief: the sum of plane waves of random directions, smooth and the same at any triangle
/// count.
struct WaveRelief {
  std::vector<Vec3> wave;     // [rad/m]
  std::vector<double> phase;  // [rad]
  double amplitude = 0.0;     // of each wave [m]
  double at(const Vec3& p) const;
};

/// rms                 of the relief [m]
/// shortest, longest   wave lengths [m]
WaveRelief make_waves(std::uint64_t seed, double rms, double shortest, double longest, int count);

}  // namespace thigma::models
