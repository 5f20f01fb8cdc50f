#include "experiments/never-enters/scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "experiments/common/assets.h"

#include "thigma/import/load_mesh.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kClearance = 1e-3;  // from start to the first touch [m]

Pose at(const Vec3& position, const Vec3& turn = Vec3::Zero()) {
  return {position, rotation_from_vector(turn)};
}

TriangleMesh turned_out(TriangleMesh mesh) {
  return mass_properties(mesh).volume > 0.0 ? mesh : flipped(std::move(mesh));
}

/// Closed ring about z.
TriangleMesh ring(double inner, double outer, double height, int around) {
  const Vec2 corners[4] = {
      {inner, -0.5 * height}, {outer, -0.5 * height}, {outer, 0.5 * height}, {inner, 0.5 * height}};
  return turned_out(make_grid(around, 4, GridEnds::both_joined, [&](int row, int column) {
    const SinCos a = sin_cos(2.0 * kPi * row / around);
    return Vec3(corners[column].x() * a.cos, corners[column].x() * a.sin, corners[column].y());
  }));
}

LedPair peg_in_hole(double clearance) {
  constexpr double kRadius = 0.005, kLength = 0.030;
  const double gap = 0.5 * clearance;
  char name[32];
  std::snprintf(name, sizeof name, "peg %g mm", 1e3 * clearance);
  LedPair pair = make_led_pair(name, make_cylinder(kRadius, kLength, 64, 6, 2),
                               ring(kRadius + gap, 0.012, kLength, 64), {});
  pair.tolerance = 0.2 * gap;
  pair.clearance = gap;
  return pair;
}

/// Inner and outer half ball, joined at the rim, open side up.
TriangleMesh bowl() {
  constexpr double kInner = 0.040, kOuter = 0.043;
  std::vector<Vec2> profile;
  constexpr int kSteps = 16;
  for (int i = 0; i <= kSteps; ++i) {
    const SinCos a = sin_cos(0.5 * kPi * i / kSteps);
    profile.push_back({i == 0 ? 0.0 : kOuter * a.sin, -kOuter * a.cos});
  }
  for (int i = kSteps; i >= 0; --i) {
    const SinCos a = sin_cos(0.5 * kPi * i / kSteps);
    profile.push_back({i == 0 ? 0.0 : kInner * a.sin, -kInner * a.cos});
  }
  return turned_out(make_revolution(profile, 64));
}

/// Four tines of 2 x 2 mm, 30 mm long, on a back and a handle.
TriangleMesh fork() {
  const double xs[] = {-0.010, -0.008, -0.004, -0.002, 0.002, 0.004, 0.008, 0.010};
  const double ys[] = {-0.001, 0.001}, zs[] = {0.0, 0.03, 0.045, 0.10};
  return make_blocks(xs, ys, zs, [](int i, int, int k) {
    if (k == 0) return i % 2 == 0;
    return k == 1 || (i == 2 || i == 3 || i == 4);
  });
}

PressedScene simple(std::string name, std::function<LedPair()> make, const Vec3& slide,
                    const Vec3& twist) {
  PressedScene scene{.name = std::move(name), .make = std::move(make)};
  scene.slide = slide;
  scene.twist = twist;
  return scene;
}

LedPair of_models(const std::string& name, const std::string& object, const std::string& scene,
                  int triangles, const Vec3& start) {
  return make_led_pair(name, make_mesh(model_uri(object, triangles)),
                       make_mesh(model_uri(scene, triangles)), at(start));
}

LedPair gears(int triangles) {
  const TriangleMesh gear = make_mesh(model_uri("gear", triangles));
  double radius = 0.0;
  for (const Vec3& p : gear.positions) radius = std::max(radius, std::hypot(p.x(), p.y()));
  LedPair pair = make_led_pair("gears", gear, gear, at({2.02 * radius, 0.0, 0.0}));
  return placed_apart(std::move(pair), -Vec3::UnitX(), kClearance);
}

std::optional<std::filesystem::path> shared_meshes() {
  const char* shared = std::getenv("THIGMA_SHARED");
  if (shared == nullptr) return {};
  const std::filesystem::path folder = std::filesystem::path(shared) / "meshes";
  if (!std::filesystem::exists(folder / "a01_dental_cast_upper.obj")) return {};
  return folder;
}

TriangleMesh real_mesh(const char* file, double scale) {
  return load_usable_mesh((*shared_meshes() / file).string(), scale, true);
}

Vec3 middle_of(const TriangleMesh& mesh) {
  const Bounds box = bounds_of(mesh.positions);
  return 0.5 * (box.min + box.max);
}

LedPair casts() {
  constexpr double kUnit = 0.24e-3;
  TriangleMesh upper = real_mesh("a01_dental_cast_upper.obj", kUnit);
  TriangleMesh lower = real_mesh("a02_dental_cast_lower.obj", kUnit);
  // Closed about the hinge, and set under the upper teeth.
  const Vec3 hinge = kUnit * Vec3(0.0, 18.55, 97.07);
  const Quat turn = rotation_from_vector(Vec3(-4.0 * kPi / 180.0, 0.0, 0.0));
  for (Vec3& p : lower.positions)
    p = turn * (p - hinge) + hinge + kUnit * Vec3(12.04, 24.09, 27.87);
  return placed_apart(make_led_pair("casts", std::move(lower), std::move(upper), {}), Vec3::UnitZ(),
                      kClearance);
}

LedPair real_gears() {
  return placed_apart(make_led_pair("real gears", real_mesh("a06_gear_medium_40t.obj", 1.0),
                                    real_mesh("a05_gear_large_60t.obj", 1.0), {}),
                      -Vec3::UnitX(), kClearance);
}

/// The spoon stands in the mug's opening, bowl down.
LedPair spoon_in_mug() {
  TriangleMesh spoon = real_mesh("a11_spoon_ycb.obj", 1.0);
  TriangleMesh mug = real_mesh("a12_mug_ycb.obj", 1.0);
  const Vec3 of_spoon = middle_of(spoon), of_mug = middle_of(mug);
  for (Vec3& p : spoon.positions) p -= of_spoon;
  for (Vec3& p : mug.positions) p -= of_mug;
  return placed_apart(make_led_pair("spoon and mug", std::move(spoon), std::move(mug),
                                    at({0.0, 0.0, 0.09}, {0.0, 0.2, 0.0})),
                      -Vec3::UnitZ(), kClearance);
}

}  // namespace

std::vector<PressedScene> built_in_scenes(int triangles) {
  std::vector<PressedScene> scenes;
  scenes.push_back(simple("cube on plate",
                          [] {
                            return make_led_pair("cube on plate",
                                                 make_box(Vec3::Constant(0.02), {4, 4, 4}),
                                                 transformed(make_box({0.1, 0.1, 0.01}, {4, 4, 1}),
                                                             at({0.0, 0.0, -0.005})),
                                                 at({0.0005, 0.0007, 0.01 + kClearance}));
                          },
                          {0.01, 0.0, 0.0}, {0.03, 0.05, 0.2}));
  for (const double clearance : {2e-5, 1e-4, 5e-4}) {
    scenes.push_back(simple("peg", [clearance] { return peg_in_hole(clearance); },
                            {0.0, 0.003, 0.005}, {0.05, 0.08, 0.3}));
    scenes.back().towards = Vec3::UnitX();
  }
  scenes.push_back(simple("bowl and fork",
                          [] {
                            return placed_apart(
                                make_led_pair("bowl and fork", fork(), bowl(),
                                              at({0.004, 0.002, -0.02}, {0.0, 0.3, 0.2})),
                                -Vec3::UnitZ(), kClearance);
                          },
                          {0.006, 0.004, 0.0}, {0.1, 0.1, 0.3}));
  scenes.push_back(simple("gears", [triangles] { return gears(triangles); }, {0.0, 0.001, 0.002},
                          {0.01, 0.01, 0.1}));
  scenes.back().towards = -Vec3::UnitX();
  scenes.push_back(simple("ball joint",
                          [triangles] {
                            LedPair pair = of_models("ball joint", "joint_ball", "joint_socket",
                                                     triangles, Vec3::Zero());
                            pair.tolerance = 1e-4;
                            pair.clearance = 5e-4;
                            return pair;
                          },
                          {0.003, 0.002, 0.0}, {0.3, 0.2, 0.3}));
  scenes.push_back(simple("jaws",
                          [triangles] {
                            return placed_apart(of_models("jaws", "jaw_upper", "jaw_lower",
                                                          triangles, {0.0, 0.0, 0.001}),
                                                -Vec3::UnitZ(), kClearance);
                          },
                          {0.003, 0.002, 0.0}, {0.03, 0.03, 0.03}));
  return scenes;
}

std::vector<PressedScene> real_scenes() {
  if (!shared_meshes()) return {};
  std::vector<PressedScene> scenes;
  scenes.push_back({.name = "casts", .make = casts});
  scenes.back().towards = Vec3::UnitZ();
  scenes.push_back({.name = "real gears", .make = real_gears});
  scenes.back().towards = -Vec3::UnitX();
  scenes.back().slide = {0.0, 0.001, 0.002};
  scenes.back().twist = {0.01, 0.01, 0.1};
  scenes.push_back({.name = "spoon and mug", .make = spoon_in_mug});
  for (PressedScene& scene : scenes) scene.is_real = true;
  return scenes;
}

HandPath pressed_hand(const LedPair& pair, const PressedScene& scene, double press) {
  const Pose start = pair.start;
  const double deep = pair.clearance + press;
  return
      [start, deep, towards = scene.towards, slide = scene.slide, twist = scene.twist](double t) {
        constexpr double kTap = 0.1, kOut = 0.008;
        const double in = std::clamp((t - 0.1) / 0.3, 0.0, 1.0);
        const double by = std::clamp((t - 0.5) / 0.6, 0.0, 1.0);
        const double swing = std::sin(2.0 * kPi * by);
        double out = 0.0;
        if (t > 1.2 && t < 1.5) {
          const double phase = std::fmod(t - 1.2, kTap) / kTap;
          out = kOut * (1.0 - std::fabs(2.0 * phase - 1.0));
        }
        return Pose{start.position + (in * deep - out) * towards + swing * slide,
                    rotation_from_vector(swing * twist) * start.orientation};
      };
}

}  // namespace thigma::experiments
