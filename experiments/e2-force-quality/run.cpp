// Protocol E2 (docs/sources.md): force and torque on six analytic scenes, through the exact query,
// clusters and the contact model.

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/all_experiments.h"
#include "experiments/e2-force-quality/scenes.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/loop/contact_step.h"

namespace thigma::experiments {
namespace e2_force_quality {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kStiffness = 1000.0;  // [N/m]; errors do not depend on it

struct Quality {
  std::vector<Wrench> measured, ideal;  // for stiffness 1 (scenes.h)
  double scale = 1.0;                   // least squares
  double magnitude = 0.0, direction = 0.0,
         torque = 0.0;  // e_mag, e_dir [rad], torque error over force * length
  double step = 0.0;    // largest change of the force over its largest
};

std::vector<Wrench> measure(const QualityScene& scene) {
  const ClodHierarchy object = build_exact_hierarchy(scene.object);
  const ClodHierarchy still = build_exact_hierarchy(scene.scene);
  ContactWorld world;
  world.object = &object;
  world.scene = {SceneBody{&still, Pose{}}};
  world.tolerance = scene.tolerance;
  world.response = {.stiffness = kStiffness, .damping = 0.0};
  world.capacity = 400'000;
  const RigidBody body = make_body(0.01, 1e-6 * Mat3::Identity());
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  ContactSample sample;
  std::vector<Wrench> wrenches;
  double time = 0.0;
  for (const Pose& pose : scene.path) {
    BodyState state;
    state.position = pose.position;
    state.orientation = pose.orientation;
    contact_step(world, {state, time, wrenches.size()}, scratch, sample);
    Wrench w = contact_wrench(sample.model, body, state);
    wrenches.push_back({w.force / kStiffness, w.torque / kStiffness});
    time += 1e-3;
  }
  return wrenches;
}

Quality judge(const QualityScene& scene) {
  Quality q;
  q.measured = measure(scene);
  double product = 0.0, square = 0.0;
  for (const Pose& pose : scene.path) q.ideal.push_back(scene.ideal(pose));
  const auto part = [&](const Wrench& w) { return scene.has_torque ? w.torque : w.force; };
  double most = 0.0;
  for (std::size_t i = 0; i < q.ideal.size(); ++i) {
    product += part(q.measured[i]).dot(part(q.ideal[i]));
    square += part(q.measured[i]).squaredNorm();
    most = std::max(most, part(q.ideal[i]).norm());
  }
  // Where nothing should act there is nothing to scale to: 1 mm of spring stands for what is large.
  q.scale = square > 0.0 && product > 0.0 ? product / square : 1.0;
  double off = 0.0, size = 0.0, angle = 0.0, torque = 0.0;
  int angles = 0;
  const double unit =
      most > 0.0 ? (scene.has_torque ? most : most * scene.length) : 1e-3 * scene.length;
  for (std::size_t i = 0; i < q.ideal.size(); ++i) {
    const Vec3 found = q.scale * part(q.measured[i]), ideal = part(q.ideal[i]);
    off += (found.norm() - ideal.norm()) * (found.norm() - ideal.norm());
    size += ideal.squaredNorm();
    const Vec3 turn = q.scale * q.measured[i].torque - q.ideal[i].torque;
    torque = std::max(torque, turn.norm() / unit);
    if (i > 0) {
      q.step = std::max(
          q.step, (found - q.scale * part(q.measured[i - 1])).norm() / (most > 0.0 ? most : 1e-3));
    }
    if (!(ideal.norm() > 0.05 * most) || most == 0.0) continue;
    const double length = found.norm();
    ++angles;
    angle += length > 0.0
                 ? std::acos(std::clamp(found.dot(ideal) / (length * ideal.norm()), -1.0, 1.0))
                 : 90.0 * kDegree;
  }
  q.magnitude = size > 0.0 ? std::sqrt(off / size)
                           : std::sqrt(off / static_cast<double>(q.ideal.size())) / 1e-3;
  q.direction = angles > 0 ? angle / angles : 0.0;
  q.torque = torque;
  return q;
}

void add(const std::string& name, const Quality& q, Outcome& outcome) {
  add_row(outcome.tables[0], {name, q.magnitude, q.direction / kDegree, q.torque, q.step, q.scale});
  plot::Series force{.label = name}, ideal;
  for (std::size_t i = 0; i < q.measured.size(); ++i) {
    force.x.push_back(static_cast<double>(i));
    force.y.push_back(1e3 * q.scale * q.measured[i].force.norm());
  }
  outcome.figure.panels[0].series.push_back(force);
}

/// Largest spread of the force over tessellations of the cube, over its mean.
double spread(const std::vector<int>& segments, int frames, const Context& context,
              Outcome& outcome) {
  std::vector<std::vector<Wrench>> all;
  outcome.tables.push_back(
      {.name = "tessellation", .columns = {"triangles", "mean force [m]", "least", "largest"}});
  for (const int n : segments) {
    tell(context, "cube of " + std::to_string(12 * n * n) + " triangles");
    all.push_back(measure(tilted_cube(n, frames)));
    double sum = 0.0, least = 1e300, most = 0.0;
    for (const Wrench& w : all.back()) {
      sum += w.force.norm();
      least = std::min(least, w.force.norm());
      most = std::max(most, w.force.norm());
    }
    add_row(outcome.tables.back(), {12.0 * n * n, sum / frames, least, most});
  }
  double worst = 0.0;
  for (int i = 0; i < frames; ++i) {
    double least = 1e300, most = 0.0, sum = 0.0;
    for (const auto& one : all) {
      const double f = one[static_cast<std::size_t>(i)].force.norm();
      least = std::min(least, f);
      most = std::max(most, f);
      sum += f;
    }
    worst = std::max(worst, (most - least) / (sum / static_cast<double>(all.size())));
  }
  return worst;
}

}  // namespace
}  // namespace e2_force_quality

Outcome run_e2_force_quality(const Context& context) {
  using namespace e2_force_quality;
  Outcome outcome;
  outcome.tables = {{.columns = {"scene", "magnitude error", "direction error [deg]",
                                 "largest torque error", "largest step", "scale"}}};
  outcome.figure = {.title = "Force on analytic scenes (protocol E2)",
                    .note = "for stiffness 1: force as a length",
                    .panels = {{.x = {.label = "frame"}, .y = {.label = "force [mm]"}}},
                    .panel_height = 420};
  const int frames = context.quick ? 100 : 1000;
  int index = 0;
  for (const QualityScene& scene : quality_scenes(frames)) {
    tell(context, scene.name);
    const Quality q = judge(scene);
    add(scene.name, q, outcome);
    const std::string id = std::to_string(++index);
    outcome.claims.push_back(stated("magnitude-" + id,
                                    scene.name + ": error of magnitude (goal 1 %)",
                                    100.0 * q.magnitude, "%"));
    outcome.claims.push_back(stated("direction-" + id,
                                    scene.name + ": error of direction (goal 1 degree)",
                                    q.direction / kDegree, "deg"));
  }
  const std::vector<int> segments =
      context.quick ? std::vector<int>{1, 2, 4, 8, 16} : std::vector<int>{1, 4, 16, 64, 290};
  outcome.claims.push_back(stated("spread",
                                  "cube face over five tessellations: spread of the force over "
                                  "its mean, the largest along the tilt",
                                  spread(segments, context.quick ? 30 : 100, context, outcome)));
  return outcome;
}

}  // namespace thigma::experiments
