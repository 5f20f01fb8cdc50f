#include "benchmarks/bench_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "benchmarks/probe.h"

#include "thigma/math/elementary.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/scene_file.h"

namespace thigma::bench {
namespace {

constexpr int kKnot = 8;  // poses between two solved heights

TriangleMesh model_mesh(const SceneObject& object, const std::string& name, int triangles,
                        double scale) {
  models::ModelRequest model = object.model.value_or(models::ModelRequest{});
  double unit = object.unit_scale;
  if (!name.empty()) {
    model = {.name = name};
    unit = scale;
  }
  if (triangles > 0) model.triangles = triangles;
  TriangleMesh mesh = models::make_model(model);
  for (Vec3& p : mesh.positions) p *= unit;
  return mesh;
}

// Sum of turns about the axes, small enough for their order not to matter.
Quat turned(const Vec3& angles) {
  Quat q = Quat::Identity();
  for (int a = 0; a < 3; ++a) {
    const SinCos half = sin_cos(0.5 * angles[a]);
    Quat turn(half.cos, 0.0, 0.0, 0.0);
    turn.vec()[a] = half.sin;
    q = q * turn;
  }
  return q.normalized();
}

// Place of the object at s in 0..1 of the path, but for its height.
Pose level_pose(const BenchPair& pair, double s) {
  const PathShape& path = pair.request.path;
  const double turn = 2.0 * kPi * s;
  const Vec3 side = pair.approach.unitOrthogonal(), other = pair.approach.cross(side);
  const Quat q = turned(path.turn * Vec3(sine(turn), sine(2.0 * turn + 1.0), sine(turn + 2.0)));
  const Vec3 center = transform_point(pair.start, pair.object.center);
  Pose pose;
  pose.orientation = (q * pair.start.orientation).normalized();
  pose.position = center - pose.orientation._transformVector(pair.object.center) +
                  path.slide * pair.radius * (sine(turn) * side + sine(2.0 * turn + 0.5) * other);
  return pose;
}

double wanted_gap(const BenchPair& pair, double s) {
  const PathShape& path = pair.request.path;
  const double swing = sine(8.0 * kPi * s) * (0.8 + 0.2 * sine(14.0 * kPi * s));
  return pair.radius * (path.height + path.swing * swing);
}

Pose raised(const BenchPair& pair, Pose pose, double height) {
  pose.position -= height * pair.approach;
  return pose;
}

// Least distance of the shells, infinite beyond 3 % of the radius [m].
double shell_gap(const BenchPair& pair, const Pose& pose, std::vector<ShellContact>& contacts) {
  query_shells(pair.object_shell, pose, pair.scene_shell, Pose{}, 0.03 * pair.radius, contacts);
  double gap = std::numeric_limits<double>::infinity();
  for (const ShellContact& c : contacts) gap = std::min(gap, -c.depth);
  return gap;
}

double solve_height(const BenchPair& pair, double s, double height) {
  std::vector<ShellContact> contacts;
  const Pose level = level_pose(pair, s);
  const double gap = wanted_gap(pair, s), step = 0.025 * pair.radius;
  for (int turn = 0; turn < 200; ++turn) {
    const double found = shell_gap(pair, raised(pair, level, height), contacts);
    if (std::fabs(found - gap) < 1e-4 * pair.radius) break;
    // A rigid motion changes the least distance by no more than its length.
    height += std::clamp(gap - found, -step, step);
  }
  return height;
}

}  // namespace

std::vector<PairRequest> level_pairs() {
  return {
      {.name = "jaws", .scene = "jaws", .path = {.turn = 0.004, .slide = 0.005}},
      {.name = "jaws-grinding",
       .scene = "jaws",
       .path = {.turn = 0.001, .slide = 0.004, .swing = 0.001}},
      {.name = "ball-joint", .scene = "ball_joint", .path = {.turn = 0.2, .slide = 0.005}},
      {.name = "cup-spoon", .scene = "cup_spoon", .path = {.turn = 0.1, .slide = 0.02}},
      {.name = "golf", .scene = "golf", .path = {.turn = 0.15, .slide = 0.15}},
      {.name = "ellipsoid",
       .scene = "ellipsoid",
       .scene_model = "golf_ball",
       .path = {.turn = 0.8, .slide = 0.5}},
  };
}

BenchPair make_pair(const PairRequest& request) {
  const SceneDescription scene = read_scene(request.scene);
  BenchPair pair;
  pair.request = request;
  pair.object_mesh = model_mesh(scene.object, request.object_model, request.object_triangles, 1.0);
  pair.scene_mesh = model_mesh(scene.statics.front(), request.scene_model, request.scene_triangles,
                               request.scene_scale);
  pair.object = build_measured(pair.object_mesh, pair.object_cost);
  pair.scene = build_measured(pair.scene_mesh, pair.scene_cost);
  pair.radius = std::min(pair.object.radius, pair.scene.radius);
  pair.tolerance = request.tolerance * pair.radius;
  const Pose scene_from_world = inverse(scene.statics.front().world_from_mesh);
  pair.start = scene_from_world * scene.object.world_from_mesh;
  pair.approach = scene_from_world.orientation._transformVector(
      scene.device.approach.value_or(-Vec3::UnitZ()).normalized());
  const double begun = thread_cpu();
  // The band holds what a query of 3 % of the radius may ask for.
  auto field = [&](const ClodHierarchy& h) {
    return ShellParams{.field = {.band = std::max(0.03 * pair.radius, 0.02 * h.radius)}};
  };
  pair.object_shell = build_point_shell(pair.object_mesh, field(pair.object));
  pair.scene_shell = build_point_shell(pair.scene_mesh, field(pair.scene));
  pair.shell_seconds = thread_cpu() - begun;
  return pair;
}

std::vector<Pose> make_path(const BenchPair& pair, int frames) {
  std::vector<Pose> poses;
  poses.reserve(static_cast<std::size_t>(frames));
  double low = 0.0, high = 0.0;
  for (int i = 0; i < frames; ++i) {
    const double s = static_cast<double>(i) / frames;
    if (!pair.request.path.is_solved) {
      poses.push_back(raised(pair, level_pose(pair, s), wanted_gap(pair, s)));
      continue;
    }
    if (i % kKnot == 0) {
      low = i == 0 ? solve_height(pair, 0.0, 0.0) : high;
      high = solve_height(pair, static_cast<double>(i + kKnot) / frames, low);
    }
    const double share = static_cast<double>(i % kKnot) / kKnot;
    poses.push_back(raised(pair, level_pose(pair, s), low + share * (high - low)));
  }
  return poses;
}

}  // namespace thigma::bench
