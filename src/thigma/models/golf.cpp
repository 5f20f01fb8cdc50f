// Both are star-shaped: every vertex of an ellipsoid is moved along the line to the centre, so that
// nothing can cross.

#include "thigma/models/golf.h"

#include <algorithm>
#include <cmath>

#include "thigma/models/ring_surface.h"

namespace thigma::models {
namespace {

constexpr double kBallRadius = 0.021335;
constexpr int kDimples = 392;
constexpr double kDimpleRadius = 0.093;               // [rad]
constexpr double kDimpleDepth = 0.012 * kBallRadius;  // a quarter of a millimetre

const Vec3 kClubHalf(0.044, 0.060, 0.034);  // of the ellipsoid below face and sole
constexpr double kFaceAt = 0.036;           // along +x
constexpr double kFaceBulge = 0.30;         // radius of the face
constexpr double kSoleAt = 0.026;           // along -z
constexpr double kSoleBulge = 0.15;
constexpr double kEdgeBlend = 0.0012;  // where face and sole meet the body
constexpr double kScoreDepth = 0.0005;
constexpr double kScorePitch = 0.0044;

std::vector<Vec3> dimple_centres() {
  std::vector<Vec3> centres;
  for (int i = 0; i < kDimples; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / kDimples;
    const double turns = 0.6180339887498949 * (i + 0.5);
    const SinCos a = sin_cos(2.0 * kPi * (turns - std::floor(turns)));
    const double r = std::sqrt(1.0 - z * z);
    centres.emplace_back(r * a.cos, r * a.sin, z);
  }
  return centres;
}

/// Distance from the centre, along a unit direction, of a ball of radius `bulge` whose top is at
/// `at` along `axis`.
double cap_distance(const Vec3& direction, const Vec3& axis, double at, double bulge) {
  const double middle = (at - bulge) * axis.dot(direction);
  const double inside = bulge * bulge - (at - bulge) * (at - bulge);
  return middle + std::sqrt(middle * middle + inside);
}

double blended_least(double a, double b, double width) {
  const double h = std::max(width - std::fabs(a - b), 0.0) / width;
  return std::min(a, b) - 0.25 * h * h * width;
}

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// The club as a distance from its centre over unit directions.
struct ClubShape {
  WaveRelief body, face;
  Vec3 hosel = Vec3(0.10, -0.80, 0.85).normalized();

  double at(const Vec3& d) const {
    const Vec3 q = d.cwiseQuotient(kClubHalf);
    double r = 1.0 / std::sqrt(q.squaredNorm());
    // A tower of smooth walls; the face is cut after it.
    const double off = 1.0 - d.dot(hosel);
    r *= 1.0 + 0.45 * smooth_step((0.030 - off) / 0.018);
    r = blended_least(r, cap_distance(d, -Vec3::UnitZ(), kSoleAt, kSoleBulge), kEdgeBlend);
    const double to_face = cap_distance(d, Vec3::UnitX(), kFaceAt, kFaceBulge);
    const double on_face = smooth_step((r - to_face) / kEdgeBlend);
    r = blended_least(r, to_face, kEdgeBlend);
    const Vec3 p = r * d;
    const double line = smooth_step((cosine(2.0 * kPi * p.z() / kScorePitch) - 0.55) / 0.35);
    const double within = smooth_step((0.036 - std::fabs(p.y())) / 0.003);
    r -= kScoreDepth * on_face * line * within;
    return r + on_face * face.at(p) + (1.0 - on_face) * body.at(p);
  }
};

}  // namespace

TriangleMesh make_golf_ball(int triangles) {
  std::vector<ProfilePoint> profile;
  add_arc(profile, {Vec2::Zero(), kBallRadius, -0.5 * kPi, 0.5 * kPi, true});
  const std::vector<Vec3> centres = dimple_centres();
  // 2 (1 - cos) is the squared angle, near enough on a dimple.
  constexpr double kReach = kDimpleRadius * kDimpleRadius;
  return make_ring_surface(profile, triangles, [&](const ProfilePoint& at, const SinCos& turn) {
    const Vec3 d = turned_place(at, turn).normalized();
    double nearest = -1.0;
    for (const Vec3& c : centres) nearest = std::max(nearest, c.dot(d));
    const double inside = std::max(0.0, 1.0 - 2.0 * (1.0 - nearest) / kReach);
    return Vec3((kBallRadius - kDimpleDepth * inside) * d);
  });
}

TriangleMesh make_golf_club(int triangles, std::uint64_t seed) {
  // Turned about the axis from heel to toe, in unit balls; the axes are put in order afterwards.
  std::vector<ProfilePoint> profile;
  add_arc(profile, {Vec2::Zero(), 1.0, -0.5 * kPi, 0.5 * kPi, true});
  ClubShape shape{make_waves(2 * seed, 8e-5, 0.002, 0.006, 24),
                  make_waves(2 * seed + 1, 2.5e-5, 0.0016, 0.004, 24)};
  return make_ring_surface(profile, triangles, [&](const ProfilePoint& at, const SinCos& turn) {
    const Vec3 u = turned_place(at, turn);
    const Vec3 d = Vec3(u.y(), u.z(), u.x()).cwiseProduct(kClubHalf).normalized();
    return Vec3(shape.at(d) * d);
  });
}

}  // namespace thigma::models
