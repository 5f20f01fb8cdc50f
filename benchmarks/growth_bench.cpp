#include "benchmarks/growth_bench.h"

#include <algorithm>
#include <cmath>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/make_model.h"
#include "thigma/multibody/step_world.h"

namespace thigma::bench {
namespace {

constexpr double kStep = 1e-3;  // [s]
constexpr double kFall = 1e-3;  // [m]
constexpr double kDensity = 1000.0;
constexpr int kTriangles = 5000;                             // of a body
constexpr double kRingHeight = 0.012, kBlockHeight = 0.040;  // [m]

/// A surface with what bodies of it need.
struct Solid {
  ClodHierarchy hierarchy;
  MassProperties unit;  // for a density of 1
};

Solid make_solid(const TriangleMesh& mesh) {
  return {build_exact_hierarchy(mesh), mass_properties(mesh)};
}
Solid make_solid(const char* name) { return make_solid(models::make_model({name, kTriangles})); }

/// Surfaces of all scenes; hierarchies outlive the worlds.
struct Solids {
  Solid ring = make_solid("ring"), block = make_solid("box");
};

struct Bodies {
  std::vector<WorldBody> list;

  void add(const Solid& solid, BodyKind kind, const Vec3& place, const Quat& turn) {
    WorldBody body;
    body.name = "body " + std::to_string(list.size());
    body.kind = kind;
    body.shape.hierarchy = &solid.hierarchy;
    body.shape.body_from_mesh.position = -solid.unit.center_of_mass;
    body.mass = kDensity * solid.unit.volume;
    body.inertia = kDensity * solid.unit.inertia;
    body.start.position = place;
    body.start.orientation = turn;
    list.push_back(body);
  }
};

/// What a course of steps took and did.
struct Course {
  std::vector<double> cpu;  // of steps in which something moved [s]
  double rows = 0.0;        // mean of these steps
  double waited = 0.0;      // [s]
  std::int64_t most_rows = 0;
  std::int32_t most_handed = 0, most_pressing = 0, most_parts = 0;
  int asleep_after = -1;  // steps; -1: not all
};

Course play(Bodies bodies, int steps) {
  const World world = make_world(std::move(bodies.list), Vec3(0.0, 0.0, -9.81));
  WorldState state = start_state(world);
  const WorldScratchPtr scratch = reserve_world(world);
  Course course;
  for (int i = 0; i < steps && course.asleep_after < 0; ++i) {
    const double start = thread_cpu();
    const WorldStep step = step_world(world, {}, kStep, state, *scratch);
    course.cpu.push_back(thread_cpu() - start);
    course.rows += static_cast<double>(step.rows);
    course.waited += step.waited;
    course.most_rows = std::max(course.most_rows, step.rows);
    course.most_handed = std::max(course.most_handed, step.most_handed);
    course.most_pressing = std::max(course.most_pressing, step.pressing);
    course.most_parts = std::max(course.most_parts, step.parts);
    if (step.awake == 0) course.asleep_after = i + 1;
  }
  course.rows /= static_cast<double>(std::max<std::size_t>(course.cpu.size(), 1));
  return course;
}

Row row_of(const std::string& name, const Course& course) {
  Row row;
  row.name = name;
  row.unit = "us";
  row.ours = figure_of(course.cpu, 1e6);
  row.contacts_ours = course.rows;
  row.note = "rows at most " + std::to_string(course.most_rows) + ", of a pair to the solver " +
             std::to_string(course.most_handed) + ", pressing " +
             std::to_string(course.most_pressing) + ", parts of a step " +
             std::to_string(course.most_parts) + ", waited " + number("%.3g", 1e3 * course.waited) +
             " ms, ";
  row.note += course.asleep_after < 0
                  ? "not asleep after " + std::to_string(course.cpu.size()) + " steps"
                  : "asleep after " + std::to_string(course.asleep_after) + " steps";
  return row;
}

Row stack(const Solids& solids, int rings, int steps) {
  Bodies bodies;
  const Solid floor = make_solid(make_box(Vec3(0.4, 0.4, 0.02)));
  bodies.add(floor, BodyKind::fixed, Vec3(0.0, 0.0, -0.01), Quat::Identity());
  for (int i = 0; i < rings; ++i)
    bodies.add(solids.ring, BodyKind::moving,
               Vec3(0.0, 0.0, 0.5 * kRingHeight + i * kRingHeight + (i + 1) * 0.1 * kFall),
               Quat::Identity());
  return row_of(std::to_string(rings) + " rings on each other", play(std::move(bodies), steps));
}

/// Rings and blocks in turn, in columns of three, each turned about the vertical.
Row tray(const Solids& solids, int count, int steps) {
  constexpr int kLayers = 3;
  constexpr double kCell = 0.13;  // of a column [m]
  const int side = static_cast<int>(std::ceil(std::sqrt(count / double(kLayers))));
  const double half = 0.5 * kCell * side;
  Bodies bodies;
  const Solid floor = make_solid(make_box(Vec3(2.0 * half + 0.1, 2.0 * half + 0.1, 0.02)));
  const Solid along = make_solid(make_box(Vec3(2.0 * half + 0.1, 0.02, 0.1)));
  const Solid across = make_solid(make_box(Vec3(0.02, 2.0 * half + 0.1, 0.1)));
  bodies.add(floor, BodyKind::fixed, Vec3(0.0, 0.0, -0.01), Quat::Identity());
  for (const double sign : {-1.0, 1.0}) {
    bodies.add(along, BodyKind::fixed, Vec3(0.0, sign * (half + 0.02), 0.05), Quat::Identity());
    bodies.add(across, BodyKind::fixed, Vec3(sign * (half + 0.02), 0.0, 0.05), Quat::Identity());
  }
  Random random(24);
  for (int i = 0; i < count; ++i) {
    const int column = i / kLayers, layer = i % kLayers;
    double z = 0.0;
    const auto is_ring = [&](int k) { return (column + k) % 2 == 0; };
    for (int k = 0; k < layer; ++k) z += kFall + (is_ring(k) ? kRingHeight : kBlockHeight);
    z += kFall + 0.5 * (is_ring(layer) ? kRingHeight : kBlockHeight);
    const Vec3 place(kCell * (column % side + 0.5) - half, kCell * (column / side + 0.5) - half, z);
    const Quat turn(Eigen::AngleAxisd(random.uniform(0.0, 6.28), Vec3::UnitZ()));
    bodies.add(is_ring(layer) ? solids.ring : solids.block, BodyKind::moving, place, turn);
  }
  return row_of(std::to_string(count) + " rings and blocks in a tray",
                play(std::move(bodies), steps));
}

}  // namespace

std::vector<Row> growth_rows(bool quick) {
  const Solids solids;
  if (quick) return {stack(solids, 3, 20), tray(solids, 3, 20)};
  constexpr int kSteps = 1500;
  std::vector<Row> rows = {stack(solids, 10, kSteps), stack(solids, 30, kSteps)};
  for (const int count : {2, 10, 30, 100, 300}) rows.push_back(tray(solids, count, kSteps));
  return rows;
}

}  // namespace thigma::bench
