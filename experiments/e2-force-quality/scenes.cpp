#include "experiments/e2-force-quality/scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace {

constexpr double kPi = 3.14159265358979323846;

Pose at(const Vec3& position, const Vec3& turn = Vec3::Zero()) {
  Pose pose;
  pose.position = position;
  pose.orientation = rotation_from_vector(turn);
  return pose;
}

double share(int i, int frames) { return static_cast<double>(i) / (frames - 1); }

/// Closed ring about z, from -height/2 to height/2.
TriangleMesh ring(double inner, double outer, double height, int around) {
  const Vec2 corners[4] = {
      {inner, -0.5 * height}, {outer, -0.5 * height}, {outer, 0.5 * height}, {inner, 0.5 * height}};
  TriangleMesh mesh = make_grid(around, 4, GridEnds::both_joined, [&](int row, int column) {
    const SinCos a = sin_cos(2.0 * kPi * row / around);
    return Vec3(corners[column].x() * a.cos, corners[column].x() * a.sin, corners[column].y());
  });
  return mass_properties(mesh).volume > 0.0 ? mesh : flipped(mesh);
}

QualityScene cone_on_plane(int frames) {
  constexpr double kHeight = 0.050, kPress = 0.001, kTravel = 0.100;
  const SinCos half = sin_cos(15.0 * kPi / 180.0);
  QualityScene s{.name = "cone on plane"};
  // Centred at half its height, tip down.
  s.object = transformed(make_cone(kHeight * half.sin / half.cos, kHeight, 48, 4),
                         at(Vec3::Zero(), Vec3(kPi, 0.0, 0.0)));
  double lowest = 0.0;
  for (const Vec3& p : s.object.positions) lowest = std::min(lowest, p.z());
  s.scene = make_sheet(0.16, 0.08, 32, 16);
  s.tolerance = 1e-4;
  s.length = 0.025;
  for (int i = 0; i < frames; ++i) {
    s.path.push_back(at({kTravel * (share(i, frames) - 0.5), 0.003, -lowest - kPress}));
  }
  s.ideal = [](const Pose&) { return Wrench{Vec3(0.0, 0.0, 0.0011), Vec3::Zero()}; };
  return s;
}

QualityScene sphere_round_sphere(int frames) {
  constexpr double kHeld = 0.020, kStill = 0.030, kDeep = 5e-4;
  QualityScene s{.name = "sphere round sphere"};
  s.object = make_ball(kHeld, 12);
  s.scene = make_ball(kStill, 16);
  s.tolerance = 1e-4;
  s.length = kHeld;
  for (int i = 0; i < frames; ++i) {
    const SinCos a = sin_cos(2.0 * kPi * share(i, frames));
    s.path.push_back(at((kHeld + kStill - kDeep) * Vec3(a.cos, a.sin, 0.0)));
  }
  s.ideal = [](const Pose& p) { return Wrench{6e-4 * p.position.normalized(), Vec3::Zero()}; };
  return s;
}

QualityScene block_in_slot(int frames) {
  constexpr double kSide = 0.020, kClear = 1e-4, kSwing = 3e-4, kTolerance = 2e-5;
  QualityScene s{.name = "block in slot"};
  s.object = make_box(Vec3::Constant(kSide), {4, 4, 4});
  const double inner = 0.5 * kSide + kClear;
  const double xs[] = {-0.03, -inner, inner, 0.03}, ys[] = {-0.02, 0.02}, zs[] = {-0.015, 0.015};
  s.scene = make_blocks(xs, ys, zs, [](int i, int, int) { return i != 1; });
  s.tolerance = kTolerance;
  s.length = 0.5 * kSide;
  for (int i = 0; i < frames; ++i)
    s.path.push_back(at({kSwing * sine(2.0 * kPi * share(i, frames)), 0.0, 0.0}));
  s.ideal = [](const Pose& p) {
    const double x = p.position.x();
    const double reach = std::max(0.0, std::fabs(x) - kClear + kTolerance);
    return Wrench{Vec3(x > 0.0 ? -reach : reach, 0.0, 0.0), Vec3::Zero()};
  };
  return s;
}

QualityScene peg_in_hole(int frames, double clearance) {
  constexpr double kRadius = 0.005, kLength = 0.030, kTilt = kPi / 180.0;
  const double gap = 0.5 * clearance, tolerance = 0.2 * gap;
  QualityScene s{.name = "peg in hole, " + std::to_string(clearance * 1e3).substr(0, 4) + " mm"};
  s.object = make_cylinder(kRadius, kLength, 96, 1);
  s.scene = ring(kRadius + gap, 0.012, kLength, 96);
  s.tolerance = tolerance;
  s.has_torque = true;
  s.length = 0.5 * kLength;
  for (int i = 0; i < frames; ++i)
    s.path.push_back(at(Vec3::Zero(), {0.0, kTilt * sine(2.0 * kPi * share(i, frames)), 0.0}));
  s.ideal = [gap, tolerance](const Pose& p) {
    // Both rims meet the wall at once, as deep: a couple about y and no force.
    const double tilt = vector_from_rotation(p.orientation).y();
    const SinCos a = sin_cos(std::fabs(tilt));
    const double depth = 0.5 * kLength * a.sin - kRadius * (1.0 - a.cos) - gap;
    const double reach = std::max(0.0, depth + tolerance);
    return Wrench{Vec3::Zero(),
                  Vec3(0.0, tilt > 0.0 ? -reach * kLength * 0.5 : reach * kLength * 0.5, 0.0)};
  };
  return s;
}

QualityScene ring_on_cylinder(int frames) {
  QualityScene s{.name = "ring on cylinder"};
  s.object = ring(0.0102, 0.015, 0.010, 96);
  s.scene = make_cylinder(0.010, 0.040, 96, 1);
  s.tolerance = 3e-4;
  s.length = 0.010;
  for (int i = 0; i < frames; ++i)
    s.path.push_back(at(Vec3::Zero(), {0.0, 0.0, 0.5 * share(i, frames)}));
  s.ideal = [](const Pose&) { return Wrench{}; };
  return s;
}

}  // namespace

QualityScene tilted_cube(int segments, int frames) {
  constexpr double kSide = 0.020, kPress = 2e-4, kTilt = 5.0 * kPi / 180.0;
  QualityScene s{.name = "cube face on plane"};
  s.object = make_box(Vec3::Constant(kSide), {segments, segments, segments});
  s.scene = make_sheet(0.06, 0.06, 8, 8);
  s.tolerance = 1e-4;
  s.length = 0.5 * kSide;
  for (int i = 0; i < frames; ++i) {
    const double tilt = kTilt * share(i, frames);
    const SinCos a = sin_cos(tilt);
    // The lower edge stays as deep.
    const double height = 0.5 * kSide * (a.cos + a.sin) - kPress;
    s.path.push_back(at({0.0005, 0.0007, height}, {0.0, tilt, 0.0}));
  }
  s.ideal = [](const Pose&) { return Wrench{Vec3(0.0, 0.0, kPress + 1e-4), Vec3::Zero()}; };
  return s;
}

std::vector<QualityScene> quality_scenes(int frames) {
  std::vector<QualityScene> scenes = {cone_on_plane(frames), sphere_round_sphere(frames),
                                      block_in_slot(frames)};
  for (const double clearance : {2e-5, 1e-4, 5e-4})
    scenes.push_back(peg_in_hole(frames, clearance));
  scenes.push_back(tilted_cube(4, frames));
  scenes.push_back(ring_on_cylinder(frames));
  return scenes;
}

}  // namespace thigma::experiments
