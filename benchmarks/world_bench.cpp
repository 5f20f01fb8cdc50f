#include "benchmarks/world_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "benchmarks/baselines/bullet_world.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"
#include "thigma/multibody/step_world.h"

namespace thigma::bench {
namespace {

constexpr double kStep = 1e-3;  // [s]
constexpr double kGravity = 9.81;
constexpr double kDensity = 1000.0;
constexpr int kRounds = 10, kManyRounds = 100;  // of Bullet's solver: its default, and more

/// Boxes, the first of them the floor, for both engines.
struct Boxes {
  std::vector<BulletBox> boxes;
  std::vector<std::unique_ptr<ClodHierarchy>> hierarchies;
  World world;
  WorldState state;
  WorldScratchPtr scratch;
  BulletWorldPtr bullet;

  void add(const Vec3& size, bool moves, double friction, const Pose& start,
           const Vec3& velocity = Vec3::Zero()) {
    const double mass = moves ? kDensity * size.x() * size.y() * size.z() : 0.0;
    boxes.push_back({size, mass, friction, start, velocity});
  }
  void make(int rounds = kRounds) {
    std::vector<WorldBody> bodies;
    for (const BulletBox& box : boxes) {
      const auto same = std::find_if(boxes.begin(), boxes.begin() + std::ptrdiff_t(bodies.size()),
                                     [&](const BulletBox& b) { return b.size == box.size; });
      const auto known = static_cast<std::size_t>(same - boxes.begin());
      hierarchies.push_back(nullptr);
      if (known == bodies.size())
        hierarchies.back() =
            std::make_unique<ClodHierarchy>(build_exact_hierarchy(make_box(box.size)));
      WorldBody body;
      body.name = "box " + std::to_string(bodies.size());
      body.kind = box.mass > 0.0 ? BodyKind::moving : BodyKind::fixed;
      body.shape.hierarchy = hierarchies[known].get();
      body.mass = box.mass;
      const Vec3 square = box.size.cwiseProduct(box.size);
      body.inertia = box.mass / 12.0 *
                     Vec3(square.y() + square.z(), square.x() + square.z(), square.x() + square.y())
                         .asDiagonal()
                         .toDenseMatrix();
      body.friction = {box.friction, box.friction};
      body.start.position = box.start.position;
      body.start.orientation = box.start.orientation;
      body.start.linear_momentum = box.mass * box.velocity;
      bodies.push_back(body);
    }
    const Vec3 gravity(0.0, 0.0, -kGravity);
    world = make_world(std::move(bodies), gravity);
    world.sleeps = false;
    state = start_state(world);
    scratch = reserve_world(world);
    constexpr double kUnit = 0.04;  // the boxes are about 1 for Bullet
    bullet = make_bullet_world(boxes, gravity, kUnit, rounds);
  }
};

/// CPU times of steps, and mean rows of ours.
struct Course {
  std::vector<double> ours, theirs;
  double rows = 0.0;
};

Course play(Boxes& boxes, int steps) {
  Course course;
  for (int i = 0; i < steps; ++i) {
    double start = thread_cpu();
    const WorldStep step = step_world(boxes.world, {}, kStep, boxes.state, *boxes.scratch);
    course.ours.push_back(thread_cpu() - start);
    course.rows += static_cast<double>(step.rows) / steps;
    if (!boxes.bullet) continue;
    start = thread_cpu();
    step_bullet(*boxes.bullet, kStep);
    course.theirs.push_back(thread_cpu() - start);
  }
  return course;
}

Row row_of(const char* name, const Course& course, int rounds = kRounds) {
  Row row;
  row.name = name;
  row.unit = "us";
  row.ours = figure_of(course.ours, 1e6);
  if (!course.theirs.empty()) {
    row.baseline = "Bullet boxes, single precision, " + std::to_string(rounds) + " rounds";
    row.theirs = figure_of(course.theirs, 1e6);
  }
  row.contacts_ours = course.rows;
  return row;
}

std::string both(const char* what, const char* format, double ours, double theirs,
                 bool has_bullet) {
  std::string text = std::string(what) + " " + number(format, ours);
  if (has_bullet) text += ", Bullet " + number(format, theirs);
  return text;
}

Pose at(double x, double y, double z) { return {Vec3(x, y, z), Quat::Identity()}; }

void add_floor(Boxes& boxes, double friction) {
  boxes.add(Vec3(4.0, 4.0, 0.02), false, friction, at(0.0, 0.0, -0.01));
}

Row tower(bool quick, int rounds) {
  Boxes boxes;
  add_floor(boxes, 0.5);
  constexpr int kBlocks = 30;
  for (int i = 0; i < kBlocks; ++i)
    boxes.add(Vec3(0.04, 0.04, 0.02), true, 0.5, at(0.0, 0.0, 0.01 + 0.02 * i + 2e-6 * (i + 1)));
  boxes.make(rounds);
  const Course course = play(boxes, quick ? 60 : 5000);
  double ours = 0.0, theirs = 0.0;
  for (std::size_t i = 1; i <= kBlocks; ++i) {
    const Vec3& start = boxes.boxes[i].start.position;
    ours = std::max(ours, (boxes.state.bodies[i].position - start).norm());
    if (boxes.bullet)
      theirs = std::max(theirs, (bullet_pose(*boxes.bullet, i).position - start).norm());
  }
  Row row = row_of("tower of 30 blocks", course, rounds);
  row.note = both("a block went by at most [um]", "%.3g", 1e6 * ours, 1e6 * theirs,
                  boxes.bullet != nullptr);
  return row;
}

Row slide(bool quick) {
  Boxes boxes;
  const double friction = 0.3, speed = 1.5;
  add_floor(boxes, friction);
  boxes.add(Vec3(0.06, 0.06, 0.02), true, friction, at(-0.3, 0.0, 0.01 + 2e-6),
            Vec3(speed, 0.0, 0.0));
  boxes.make();
  const int steps = quick ? 60 : 1000;
  const Course course = play(boxes, steps);
  const double time = std::min(kStep * steps, speed / (friction * kGravity));
  const double way = speed * time - 0.5 * friction * kGravity * time * time;
  const double ours = boxes.state.bodies[1].position.x() + 0.3;
  const double theirs = boxes.bullet ? bullet_pose(*boxes.bullet, 1).position.x() + 0.3 : 0.0;
  Row row = row_of("block slides to a stop", course);
  row.note = both("way off Coulomb's by [%]", "%.3g", 100.0 * (ours / way - 1.0),
                  100.0 * (theirs / way - 1.0), boxes.bullet != nullptr);
  return row;
}

Row pile(bool quick) {
  Boxes boxes;
  add_floor(boxes, 0.4);
  Random random(5);
  constexpr int kBoxes = 30;
  for (int i = 0; i < kBoxes; ++i)
    boxes.add(Vec3(0.05, 0.04, 0.03), true, 0.4,
              {Vec3(0.02 * random.normal(), 0.02 * random.normal(), 0.06 + 0.07 * i),
               random.orientation()});
  boxes.make();
  const Course course = play(boxes, quick ? 60 : 3000);
  double ours = 0.0, theirs = 0.0;
  for (std::size_t i = 1; i <= kBoxes; ++i) {
    ours = std::max(ours, velocity(boxes.world.rigid[i], boxes.state.bodies[i]).linear.norm());
    if (boxes.bullet) theirs = std::max(theirs, bullet_speed(*boxes.bullet, i));
  }
  Row row = row_of("pile of 30 boxes falls", course);
  row.note = both("fastest box at the end [mm/s]", "%.3g", 1e3 * ours, 1e3 * theirs,
                  boxes.bullet != nullptr);
  return row;
}

}  // namespace

std::vector<Row> world_rows(bool quick) {
  return {slide(quick), tower(quick, kRounds), tower(quick, kManyRounds), pile(quick)};
}

}  // namespace thigma::bench
