// Relief under constraints: fine surfaces stay outside each other, by points of both.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

#include "support/fine_plates.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/constraint/build_constraints.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/dynamics/coupling.h"
#include "thigma/loop/contact_step.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/textured_model.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

constexpr double kStep = 1e-3, kSide = 0.04, kThick = 0.01;
constexpr int kTexels = 401;

using Relief = std::function<double(double x, double y)>;

HapticTexture slab(const Relief& relief) {
  return make_texture(models::make_textured_slab({{kSide, kSide, kThick}, kTexels, relief}),
                      "slab");
}

/// Something on a plate with relief.
struct Bench {
  HapticTexture object_texture, plate_texture;
  ClodHierarchy object, plate;
  SessionConfig config;
  ContactScratch scratch;
  double amplitude = 0.0;

  Bench(HapticTexture top, HapticTexture bottom, double friction)
      : object_texture(std::move(top)),
        plate_texture(std::move(bottom)),
        object(build_exact_hierarchy(object_texture.coarse)),
        plate(build_exact_hierarchy(plate_texture.coarse)) {
    ContactWorld& world = config.contact;
    world.object = &object;
    world.scene = {{&plate, Pose{}}};
    world.tolerance = 2e-4;
    world.textures.object = make_textured_body(object_texture, object);
    world.textures.scene = {make_textured_body(plate_texture, plate)};
    amplitude = object_texture.amplitude + plate_texture.amplitude;
    config.contact.friction.assign(config.contact.scene.size(), {friction, friction});
    use_constraints(config);
    reserve_contact_scratch(world, scratch);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;
};

/// What a run has shown.
struct Slid {
  double deepest = -1.0;  // of any looked-at frame [m]
  double least = 0.0;     // energy of the hand: put in [J], least
  int held_back = 0, frames = 0;
  std::vector<Vec3> place, force;  // of the body, and by the coupling on the hand
};

struct SlidePath {
  int every = 1, frames = 1500, look = 11;
  double stiffness = 1000.0;
  Pose start;
  std::function<Pose(double)> hand;
  std::function<double(const Pose&)> depth;  // of the fine surfaces at a pose of the object
};

Slid slide(Bench& bench, const SlidePath& run) {
  const ContactWorld& world = bench.config.contact;
  const double mass = 0.05, reach = world.constraints->reach;
  const RigidBody body = make_body(mass, Mat3(0.4 * mass * reach * reach * Mat3::Identity()));
  Coupling coupling;
  coupling.linear_stiffness = run.stiffness;
  coupling.linear_damping = 2.0 * std::sqrt(run.stiffness * mass) * 0.35;
  coupling.angular_stiffness = 0.5;
  coupling.angular_damping = 5e-4;
  BodyState state;
  state.position = run.start.position;
  state.orientation = run.start.orientation;
  grasp(coupling, state, run.start);
  RowMemory memory;
  auto used = std::make_unique<ConstraintModel>();
  auto made = std::make_unique<ContactSample>();
  double wanted = 0.0, spent = 0.0;
  Slid slid;
  Pose last = run.hand(0.0);
  Wrench felt;
  contact_step(world, {state, 0.0, 0, 0.0}, bench.scratch, *made);
  *used = made->model.constraints;
  for (int k = 0; k < run.frames; ++k) {
    if (k > 0 && (k - 1) % run.every == 0) *used = made->model.constraints;
    if (k % run.every == 0)
      contact_step(world, {state, (k + 1) * kStep, 0, wanted}, bench.scratch, *made);
    const Pose now = run.hand(k * kStep);
    const Motion motion{
        now,
        {(now.position - last.position) / kStep,
         vector_from_rotation(now.orientation * last.orientation.conjugate()) / kStep}};
    spent -= felt.force.dot(now.position - last.position) +
             felt.torque.dot(kStep * motion.twist.angular);
    slid.least = std::min(slid.least, spent);
    last = now;
    StepForces forces;
    forces.wrench = coupling_wrench(coupling, motion, body, state, &forces.jacobian);
    const ConstrainedStep step = constrained_step(
        at_state(body, state), forces, {*used, bench.config.haptic.constraint, kStep}, memory);
    state = step.state;
    wanted = step.wanted_speed;
    slid.held_back += step.is_held_back;
    felt = coupling_reaction(coupling, motion, body, state);
    slid.place.push_back(state.position);
    slid.force.push_back(felt.force);
    if (k % run.look == 0)
      slid.deepest = std::max(slid.deepest, run.depth({state.position, state.orientation}));
  }
  slid.frames = run.frames;
  return slid;
}

void print(const char* name, int every, const Bench& bench, const Slid& slid) {
  std::printf(
      "%s every %d: deepest %.2f um (%.2f %% of amplitude), held back %d of %d, energy %.3g mJ\n",
      name, every, 1e6 * slid.deepest, 100.0 * slid.deepest / bench.amplitude, slid.held_back,
      slid.frames, 1e3 * slid.least);
}

TEST(ReliefConstraints, ABallSlidOverRidgesStaysOutside) {
  const Relief ridges = [](double x, double) { return 5e-4 * std::sin(2.0 * M_PI * x / 0.008); };
  const TriangleMesh ball = make_ball(0.002, 12);
  const test::FinePlate fine = test::fine_plate(kSide, kThick, kTexels, ridges);
  for (const int every : {1, 3, 10, 33}) {
    Bench bench(make_plain_texture(ball, "ball"), slab(ridges), 0.0);
    SlidePath run;
    run.every = every;
    run.start.position = {-0.012, 0.0007, 0.0085};
    run.hand = [&](double t) {
      const double in = std::clamp(t / 0.2, 0.0, 1.0), by = std::clamp((t - 0.2) / 1.2, 0.0, 1.0);
      return Pose{run.start.position + Vec3(0.024 * by, 0.0, -0.004 * in), Quat::Identity()};
    };
    run.depth = [&](const Pose& pose) {
      return std::max(test::depth_of_points(ball.positions, pose, fine),
                      test::depth_in_convex(fine, inverse(pose), ball));
    };
    const Slid slid = slide(bench, run);
    print("ball", every, bench, slid);
    EXPECT_LE(slid.deepest, 0.02 * bench.amplitude) << every;
    EXPECT_GE(slid.least, -1e-6) << every;
  }
}

/// How often a number rises through its mean, by when it first and last does [1/frame].
double rate_of(const std::vector<double>& values, double* swing) {
  double low = values[0], high = values[0];
  for (const double v : values) low = std::min(low, v), high = std::max(high, v);
  *swing = 0.5 * (high - low);
  const double mean = 0.5 * (low + high);
  double first = -1.0, last = -1.0;
  int count = 0;
  bool is_low = false;
  for (std::size_t i = 1; i < values.size(); ++i) {
    is_low = is_low || values[i] < mean - 0.3 * *swing;
    if (!is_low || values[i] < mean) continue;
    is_low = false;
    const double at = static_cast<double>(i) - (values[i] - mean) / (values[i] - values[i - 1]);
    if (count++ == 0) first = at;
    last = at;
  }
  return (count - 1) / (last - first);
}

TEST(ReliefConstraints, TheHandFeelsTheRidges) {
  const double pitch = 0.008, speed = 0.02, stiffness = 500.0;
  const Relief ridges = [=](double x, double) { return 3e-4 * std::sin(2.0 * M_PI * x / pitch); };
  const TriangleMesh ball = make_ball(0.002, 16);
  const test::FinePlate fine = test::fine_plate(kSide, kThick, kTexels, ridges);
  const Vec3 start(-0.014, 0.0007, 0.0078);
  // Where the ball would rest, place by place.
  std::vector<double> rests;
  for (int i = 0; i < 80; ++i) {
    const Vec3 at(0.001 + pitch * i / 80.0, start.y(), start.z());
    rests.push_back(test::depth_of_points(ball.positions, {at, Quat::Identity()}, fine));
  }
  const double rise = 0.5 * (*std::max_element(rests.begin(), rests.end()) -
                             *std::min_element(rests.begin(), rests.end()));
  for (const int every : {1, 3, 10, 33}) {
    Bench bench(make_plain_texture(ball, "ball"), slab(ridges), 0.0);
    SlidePath run;
    run.every = every;
    run.frames = 1700;
    run.stiffness = stiffness;
    run.start.position = start;
    run.hand = [&](double t) {
      const double in = std::clamp(t / 0.1, 0.0, 1.0);
      return Pose{start + Vec3(speed * std::max(t - 0.2, 0.0), 0.0, -0.0024 * in),
                  Quat::Identity()};
    };
    run.depth = [](const Pose&) { return 0.0; };
    const Slid slid = slide(bench, run);
    std::vector<double> force, height;
    for (std::size_t k = 300; k < slid.force.size(); ++k) {
      force.push_back(slid.force[k].z());
      height.push_back(slid.place[k].z());
    }
    double force_swing = 0.0, height_swing = 0.0;
    const double force_rate = rate_of(force, &force_swing) / kStep;
    const double height_rate = rate_of(height, &height_swing) / kStep;
    const double decibel = 20.0 * std::log10(force_swing / (stiffness * rise));
    std::printf(
        "felt every %d: force %.3f Hz, height %.3f Hz, of %.3f; force %.2f dB, held back %d\n",
        every, force_rate, height_rate, speed / pitch, decibel, slid.held_back);
    if (every > 3) continue;  // at lower rates the object waits at the end of its travel
    const double off = (every == 1 ? 0.02 : 0.03) * speed / pitch;  // 2.2 % at 333 Hz
    EXPECT_NEAR(force_rate, speed / pitch, off) << every;
    EXPECT_NEAR(height_rate, speed / pitch, off) << every;
    EXPECT_NEAR(decibel, 0.0, 1.0) << every;
  }
}

TEST(ReliefConstraints, WithFrictionNothingIsGivenOutAndRestIsRest) {
  const Relief ridges = [](double x, double) { return 5e-4 * std::sin(2.0 * M_PI * x / 0.008); };
  const TriangleMesh ball = make_ball(0.002, 12);
  const test::FinePlate fine = test::fine_plate(kSide, kThick, kTexels, ridges);
  for (const int every : {1, 3, 10, 33}) {
    Bench bench(make_plain_texture(ball, "ball"), slab(ridges), 0.4);
    SlidePath run;
    run.every = every;
    run.frames = 1600;
    run.start.position = {-0.012, 0.0007, 0.0085};
    run.hand = [&](double t) {
      const double in = std::clamp(t / 0.2, 0.0, 1.0), by = std::clamp((t - 0.2) / 0.8, 0.0, 1.0);
      return Pose{run.start.position + Vec3(0.008 * by, 0.0, -0.004 * in), Quat::Identity()};
    };
    run.depth = [&](const Pose& pose) {
      return std::max(test::depth_of_points(ball.positions, pose, fine),
                      test::depth_in_convex(fine, inverse(pose), ball));
    };
    const Slid slid = slide(bench, run);
    print("friction", every, bench, slid);
    EXPECT_LE(slid.deepest, 0.02 * bench.amplitude) << every;
    EXPECT_GE(slid.least, -1e-6) << every;
    double step = 0.0;
    for (std::size_t k = slid.force.size() - 200; k < slid.force.size(); ++k)
      step = std::max(step, (slid.force[k] - slid.force[k - 1]).norm());
    std::printf("  largest step of the force at rest %.3g mN\n", 1e3 * step);
    if (every > 10) continue;  // at 30 Hz it still follows the hand
    EXPECT_LE(step, 5e-3) << every;
  }
}

TEST(ReliefConstraints, RidgedPlatesStayOutsideEachOther) {
  const Relief ridges = [](double x, double) { return 2.5e-4 * std::sin(2.0 * M_PI * x / 0.008); };
  const test::FinePlate fine = test::fine_plate(kSide, kThick, kTexels, ridges);
  std::vector<Vec3> points;
  for (int j = 0; j < kTexels; j += 2)
    for (int i = 0; i < kTexels; ++i) points.push_back(fine.point(i, j));
  for (const double yaw : {0.0, 0.3}) {
    for (const int every : {1, 3, 10, 33}) {
      Bench bench(slab(ridges), slab(ridges), 0.0);
      SlidePath run;
      run.every = every;
      run.look = 31;
      run.frames = 900;
      run.start.position = {-0.006, 0.0007, 0.0112};
      run.start.orientation =
          rotation_from_vector({0.0, 0.0, yaw}) * rotation_from_vector({0.0, M_PI, 0.0});
      run.hand = [&](double t) {
        const double in = std::clamp(t / 0.2, 0.0, 1.0), by = std::clamp((t - 0.2) / 0.7, 0.0, 1.0);
        return Pose{
            run.start.position + Vec3(0.007 * by, 0.004 * by, -0.004 * in),
            rotation_from_vector(0.1 * std::sin(6.0 * by) * Vec3::UnitZ()) * run.start.orientation};
      };
      run.depth = [&](const Pose& pose) {
        return std::max(test::depth_of_points(points, pose, fine),
                        test::depth_of_points(points, inverse(pose), fine));
      };
      const Slid slid = slide(bench, run);
      char name[40];
      std::snprintf(name, sizeof name, "plates at %.2f", yaw);
      print(name, every, bench, slid);
      // At 30 Hz a turn of the plate within one model goes farther than its blocks tell.
      EXPECT_LE(slid.deepest, (every > 10 ? 0.05 : 0.02) * bench.amplitude) << every;
      EXPECT_GE(slid.least, -1e-6) << every;
    }
  }
}

}  // namespace
}  // namespace thigma
