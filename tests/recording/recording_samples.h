#pragma once
// Seeded telemetry for the recording tests: every field set, no two alike.

#include <bit>
#include <string>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/recording/recording.h"

namespace thigma::test {

inline void flip_last_bit(double& value) {
  value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ 1u);
}

inline Wrench random_wrench(Random& random) { return {random.in_cube(3.0), random.in_cube(0.1)}; }

inline BodyState random_body(Random& random) {
  return {random.in_cube(0.2), random.orientation(), random.in_cube(1e-3), random.in_cube(1e-6)};
}

inline HapticSample sample(std::uint64_t frame) {
  Random random(frame + 17);
  HapticSample s;
  s.frame = frame;
  s.time = static_cast<double>(frame) * 1e-3;
  s.elapsed = 1e-3 * random.uniform(0.9, 1.1);
  s.device.time = s.time - 1e-4 * random.uniform();
  s.device.motion.pose = {random.in_cube(0.1), random.orientation()};
  s.device.motion.twist = {random.in_cube(0.5), random.in_cube(2.0)};
  s.device.buttons = static_cast<std::uint32_t>(random.below(4));
  s.model_sequence = frame / 10;
  s.handle.pose = {random.in_cube(0.1), random.orientation()};
  s.handle.twist = {random.in_cube(0.5), random.in_cube(2.0)};
  s.body = random_body(random);
  s.coupling = random_wrench(random);
  s.contact = random_wrench(random);
  s.feedback = random_wrench(random);
  s.command = random_wrench(random);
  s.model_age = random.uniform(0.0, 0.02);
  s.model_weight = random.uniform();
  s.penetration = random.uniform(-1e-3, 1e-3);
  s.stretch = random.uniform(0.0, 1e-2);
  s.energy = random.uniform(-1e-6, 1.0);
  s.touching = static_cast<std::int32_t>(random.below(6));
  s.is_grasped = frame % 2 == 0;
  s.is_armed = frame % 3 == 0;
  s.fault = frame > 400 ? Fault::pose_jump : Fault::none;
  s.step_cpu = static_cast<float>(random.uniform(1e-6, 2e-6));
  s.wake_late = static_cast<float>(random.uniform(0.0, 1e-4));
  s.device.has_true_handle = frame % 2 == 1;
  if (s.device.has_true_handle) s.device.true_handle = {random.in_cube(0.1), random.orientation()};
  s.device.has_camera = frame % 3 == 1;
  if (s.device.has_camera) s.device.camera = {random.in_cube(0.1), random.orientation()};
  if (frame % 5 == 0) s.device.weight = random.uniform();
  if (frame % 4 == 1) {  // the others are of a penalty session
    s.wanted_speed = random.uniform();
    s.solve_residual = random.uniform(0.0, 1e-9);
    s.is_held_back = frame % 8 == 1;
    s.is_squeezed = frame % 8 == 5;
    for (std::uint64_t i = 0; i < 3; ++i)
      s.pressing.push_back({random.below(1u << 30) << 33, random.in_cube(3.0)});
  }
  s.input_digest = input_digest(s);
  return s;
}

inline ContactSample contact_sample(std::uint64_t sequence) {
  Random random(sequence + 99);
  ContactSample c;
  c.time = static_cast<double>(sequence) * 1e-2;
  c.published = c.time + 1e-3;
  c.query_cpu = random.uniform(1e-4, 1e-3);
  c.step_cpu = 2.0 * c.query_cpu;
  c.contacts = static_cast<std::int64_t>(random.below(1000));
  c.front = 4000;
  c.tests = 4100;
  c.clusters = 3;
  c.depth_max = random.uniform(-1e-3, 1e-3);
  c.mandatory_tests = static_cast<std::int64_t>(random.below(1000));
  c.unrefined = static_cast<std::int64_t>(random.below(100));
  c.level_changes = static_cast<std::int32_t>(random.below(10));
  c.bound_max = random.uniform(0.0, 1e-3);
  for (std::size_t i = 0; i < 5; ++i) {
    c.object_levels[i] = static_cast<std::int32_t>(random.below(50));
    c.scene_levels[i] = static_cast<std::int32_t>(random.below(50));
  }
  if (sequence % 2 == 1) {
    c.rows = static_cast<std::int64_t>(300 + random.below(100));
    c.travel_halvings = static_cast<std::int32_t>(random.below(7));
    c.left_out = static_cast<std::int64_t>(random.below(10));
    c.travel = random.uniform(0.0, 1e-3);
    c.look_ahead = random.uniform(0.0, 1e-3);
    c.coarse = static_cast<std::int64_t>(random.below(100));
  }
  c.model.sequence = sequence;
  c.model.time = c.time;
  c.model.state = random_body(random);
  for (int i = 0; i < 3; ++i) {
    PlaneTerm plane;
    plane.arm_body = random.in_cube(0.05);
    plane.normal = random.direction();
    plane.scene_point = random.in_cube(0.1);
    plane.stiffness = 2000.0;
    plane.damping = random.uniform();
    plane.tolerance = 1e-3;
    plane.id = i;
    plane.body = i == 1 ? 2 : 0;
    if (i == 1) plane.friction = {0.3, 0.4};
    c.model.planes.push_back(plane);
  }
  DepthTerm depth;
  depth.depth = random.uniform(-1e-3, 1e-3);
  depth.linear = random.direction();
  depth.angular = random.in_cube(0.1);
  depth.stiffness = 5000.0;
  depth.damping = random.uniform();
  depth.tolerance = 1e-4;
  depth.id = 7;
  depth.body = 1;
  depth.friction.at_rest = 0.2;
  depth.arm_body = random.in_cube(0.05);
  c.model.depths.push_back(depth);
  c.model_digest = model_digest(c.model);
  return c;
}

/// A recording of `frames` haptic frames and a tenth as many contact frames; returns its path.
inline std::string write_recording(const std::string& name, std::uint64_t frames) {
  const std::string path = ::testing::TempDir() + "thigma_" + name;
  RecordingWriter writer(path, R"({"version":1,"note":"made by a test"})");
  for (std::uint64_t i = 0; i < frames; ++i) {
    if (i % 10 == 0) writer.write(contact_sample(i / 10));
    writer.write(sample(i));
    if (i == 7) writer.write(SessionEvent{0.007, 7, EventKind::armed, ""});
    if (i == 401) writer.write(SessionEvent{0.401, 401, EventKind::fault, "pose_jump"});
  }
  writer.close({.frames = frames, .state_hash = 0x0123456789abcdefull, .dropped = 2});
  return path;
}

}  // namespace thigma::test
