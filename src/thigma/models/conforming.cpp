#include "thigma/models/conforming.h"

#include <cmath>

#include "thigma/models/ring_surface.h"

namespace thigma::models {
namespace {

constexpr double kSocketInner = kJointRadius + kJointClearance;
constexpr double kSocketOuter = 1.30 * kJointRadius;
constexpr double kSocketOpening = 80.0 / 180.0 * kPi;  // of the rim, from the bottom
constexpr double kStemRadius = 0.40 * kJointRadius;
constexpr double kStemTop = 2.0 * kJointRadius;
constexpr double kNeckFillet = 0.25 * kJointRadius;
constexpr double kEdgeFillet = 0.12 * kJointRadius;
constexpr double kJointRelief = 0.0015 * kJointRadius;  // rms: peaks of both fit in the clearance

constexpr double kDiscRadius = 0.100;
constexpr double kDiscRim = 0.003;     // radius of its edge
constexpr double kPlainDensity = 0.3;  // of the flat side and the rim against the wavy side

WaveRelief joint_relief(std::uint64_t seed) {
  return make_waves(seed, kJointRelief, 0.05 * kJointRadius, 0.15 * kJointRadius, 24);
}

/// Height of both wavy discs over (x, y): swells, and ripples as fine as the triangles of 1M.
struct WavyHeight {
  WaveRelief swell, ripple;
  double at(const Vec3& p) const {
    const Vec3 flat(p.x(), p.y(), 0.0);
    return swell.at(flat) + ripple.at(flat);
  }
};

WavyHeight wavy_height(std::uint64_t seed) {
  return {make_waves(2 * seed, 3e-4, 0.030, 0.070, 8),
          make_waves(2 * seed + 1, 4e-6, 0.0015, 0.004, 24)};
}

/// Share of the waves at a point: all of it on the wavy side, none from the rim on.
double wavy_share(double radius) {
  const double x = (kDiscRadius - kDiscRim - radius) / (2.0 * kDiscRim);
  if (x >= 1.0) return 1.0;
  return x <= 0.0 ? 0.0 : x * x * (3.0 - 2.0 * x);
}

}  // namespace

TriangleMesh make_joint_ball(int triangles, std::uint64_t seed) {
  // The fillet touches ball and stem.
  const double out = kStemRadius + kNeckFillet;
  const double reach = kJointRadius + kNeckFillet;
  const double height = std::sqrt(reach * reach - out * out);
  const double neck = arc_tangent2(height, out);
  std::vector<ProfilePoint> profile;
  add_arc(profile, {Vec2::Zero(), kJointRadius, -0.5 * kPi, neck, true});
  add_arc(profile, {{out, height}, kNeckFillet, neck + kPi, kPi, false});
  add_line(profile, {kStemRadius, height}, {kStemRadius, kStemTop - kEdgeFillet});
  add_arc(profile,
          {{kStemRadius - kEdgeFillet, kStemTop - kEdgeFillet}, kEdgeFillet, 0.0, 0.5 * kPi, true});
  add_line(profile, {kStemRadius - kEdgeFillet, kStemTop}, {0.0, kStemTop});
  const WaveRelief relief = joint_relief(2 * seed);
  return make_ring_surface(profile, triangles, [&](const ProfilePoint& at, const SinCos& turn) {
    return turned_place(at, turn, relief.at(turned_place(at, turn)));
  });
}

TriangleMesh make_joint_socket(int triangles, std::uint64_t seed) {
  constexpr double kOutside = 0.6;  // density: the inside matters
  const double rim = kSocketOpening - 0.5 * kPi;
  const double middle = 0.5 * (kSocketInner + kSocketOuter);
  const SinCos at_rim = sin_cos(rim);
  std::vector<ProfilePoint> profile;
  add_arc(profile, {Vec2::Zero(), kSocketOuter, -0.5 * kPi, rim, true, kOutside});
  add_arc(profile, {middle * Vec2(at_rim.cos, at_rim.sin), 0.5 * (kSocketOuter - kSocketInner), rim,
                    rim + kPi, true});
  add_arc(profile, {Vec2::Zero(), kSocketInner, rim, -0.5 * kPi, false});
  const WaveRelief relief = joint_relief(2 * seed + 1);
  return make_ring_surface(profile, triangles, [&](const ProfilePoint& at, const SinCos& turn) {
    return turned_place(at, turn, relief.at(turned_place(at, turn)));
  });
}

TriangleMesh make_conforming_lower(int triangles, std::uint64_t seed) {
  constexpr double kBottom = -0.012;
  const double flat = kDiscRadius - kDiscRim;
  std::vector<ProfilePoint> profile;
  add_line(profile, {0.0, kBottom}, {flat, kBottom}, kPlainDensity);
  add_arc(profile, {{flat, kBottom + kDiscRim}, kDiscRim, -0.5 * kPi, 0.0, true, kPlainDensity});
  add_line(profile, {kDiscRadius, kBottom + kDiscRim}, {kDiscRadius, -kDiscRim}, kPlainDensity);
  add_arc(profile, {{flat, -kDiscRim}, kDiscRim, 0.0, 0.5 * kPi, true});
  add_line(profile, {flat, 0.0}, {0.0, 0.0});
  const WavyHeight waves = wavy_height(seed);
  return make_ring_surface(profile, triangles, [&](const ProfilePoint& at, const SinCos& turn) {
    Vec3 p = turned_place(at, turn);
    if (at.place.y() > -kDiscRim) p.z() += wavy_share(at.place.x()) * waves.at(p);
    return p;
  });
}

TriangleMesh make_conforming_upper(int triangles, std::uint64_t seed) {
  constexpr double kTop = 0.015;
  const double flat = kDiscRadius - kDiscRim;
  const double base = kConformingGap;
  std::vector<ProfilePoint> profile;
  add_line(profile, {0.0, base}, {flat, base});
  add_arc(profile, {{flat, base + kDiscRim}, kDiscRim, -0.5 * kPi, 0.0, true});
  add_line(profile, {kDiscRadius, base + kDiscRim}, {kDiscRadius, kTop - kDiscRim}, kPlainDensity);
  add_arc(profile, {{flat, kTop - kDiscRim}, kDiscRim, 0.0, 0.5 * kPi, true, kPlainDensity});
  add_line(profile, {flat, kTop}, {0.0, kTop}, kPlainDensity);
  const WavyHeight waves = wavy_height(seed);
  return make_ring_surface(profile, triangles, [&](const ProfilePoint& at, const SinCos& turn) {
    Vec3 p = turned_place(at, turn);
    if (at.place.y() < base + kDiscRim) p.z() += wavy_share(at.place.x()) * waves.at(p);
    return p;
  });
}

}  // namespace thigma::models
