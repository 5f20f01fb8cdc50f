#include "reference/depth_hessian.h"

#include <cstdint>

#include "thigma/depth/detail/prepared_contact.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using Mat26 = Eigen::Matrix<double, 2, 6>;

/// A surface at a point of the plane, and what moves it. All in the contact frame; the point from
/// the centre.
struct Moved {
  Vec3 point;
  Eigen::Matrix<double, 3, 2> by_at;
  Vec2 slope;
  Mat2 curvature;
};

// A motion w = (t, r) takes p to p + t + r x p + r x (r x p) / 2. Over a point s of the plane then
// lies what was over s + sigma: sigma = sigma_1 + sigma_2 follows from the point, as does the
// height there.

Vec2 first_shift(const Moved& m, const Vec6& w) noexcept {
  const Vec3 t = w.head<3>(), r = w.tail<3>();
  return -(t + r.cross(m.point)).head<2>();
}

// The part of the height over s that is quadratic in the motion.
double quadratic_part(const Moved& m, const Vec6& w) noexcept {
  const Vec3 r = w.tail<3>();
  const Vec2 first = first_shift(m, w);
  const Vec3 second = r.cross(Vec3(m.by_at * first)) + 0.5 * r.cross(r.cross(m.point));
  return -m.slope.dot(second.head<2>()) + 0.5 * first.dot(m.curvature * first) + second.z();
}

// Second derivatives by the motion at a fixed point of the plane.
Mat6 by_motion_twice(const Moved& m) noexcept {
  Mat6 second;
  Vec6 own;
  for (int i = 0; i < 6; ++i) own[i] = quadratic_part(m, Vec6::Unit(i));
  for (int i = 0; i < 6; ++i) {
    second(i, i) = 2.0 * own[i];
    for (int j = 0; j < i; ++j) {
      second(i, j) = quadratic_part(m, Vec6::Unit(i) + Vec6::Unit(j)) - own[i] - own[j];
      second(j, i) = second(i, j);
    }
  }
  return second;
}

// By the motion once, and once by the point of the plane.
Mat26 by_motion_and_place(const Moved& m) noexcept {
  Mat26 mixed;
  for (int i = 0; i < 6; ++i) {
    const Vec6 w = Vec6::Unit(i);
    const Mat3 turn = skew(Vec3(w.tail<3>()));
    const Eigen::Matrix<double, 3, 2> turned = turn * m.by_at;
    mixed.col(i) = m.curvature * first_shift(m, w) - turned.topRows<2>().transpose() * m.slope +
                   turned.row(2).transpose();
  }
  return mixed;
}

}  // namespace

DepthHessian depth_hessian(const DepthContact& contact, const DepthSamples& sample,
                           GradientScratch& scratch) noexcept {
  if (!sample.is_found) return {};
  const double texel = detail::finer_texel(contact);
  const Vec2 around = Vec2::Constant(2.0 * texel);
  const PlaneBox over{sample.at - around, sample.at + around};
  detail::project_sides(contact, sample.frame, over, scratch.object, scratch.scene);
  const SurfaceJet object = surface_jet(scratch.object, sample.at),
                   scene = surface_jet(scratch.scene, sample.at);
  if (!object.is_covered || !scene.is_covered) return {};
  const SmoothPeak peak = smooth_peak(object, scene, texel);
  if (!peak.is_near) return {};
  const Vec2 at = sample.at + peak.step;
  std::int32_t any = -1;
  if (height_at(scratch.object, at, any) == kNoSurface) return {};  // held by the end of a side
  any = -1;
  if (height_at(scratch.scene, at, any) == kNoSurface) return {};
  const SurfaceJet there = carried(object, peak.step);
  const Mat3 contact_from_world = sample.frame.world_from_contact.transpose();
  const Vec3 centre = contact_from_world * (contact.centre - sample.frame.origin);
  Moved moved{there.point - centre, {}, envelope_slope(object, scene, peak, 0), object.curvature};
  moved.by_at << 1.0, 0.0, 0.0, 1.0, moved.slope.transpose();
  const Mat26 mixed = by_motion_and_place(moved);
  // The place of the maximum follows the motion: that adds mixed^T bowl^-1 mixed.
  Mat6 second = by_motion_twice(moved) + mixed.transpose() * peak.bowl.inverse() * mixed;
  // What turns next is the turned object: half the bracket of two rotations.
  const Vec3 angular = moved.point.cross(Vec3(-moved.slope.x(), -moved.slope.y(), 1.0));
  second.bottomRightCorner<3, 3>() -= 0.5 * skew(angular);
  Mat6 to_world = Mat6::Zero();
  to_world.topLeftCorner<3, 3>() = to_world.bottomRightCorner<3, 3>() =
      sample.frame.world_from_contact;
  DepthHessian result;
  result.gradient_by_motion = to_world * second * to_world.transpose();
  result.is_valid =
      result.gradient_by_motion.allFinite() && second.topLeftCorner<3, 3>().norm() * texel <= 1.0;
  return result;
}

}  // namespace thigma
