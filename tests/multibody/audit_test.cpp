// A step of a world takes no memory once it is warm: counted, with bodies that meet and part.

#include "support/audit.h"

#include "multibody/held_bench.h"
#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/multibody/detail/row_cut.h"
#include "thigma/multibody/hand_step.h"

namespace thigma {
namespace {

TEST(WorldAudit, StepsTakeNoMemoryOnceWarm) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::WorldBench bench;
  test::add_floor(bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.03, 0.02)));
  for (int i = 0; i < 6; ++i) {
    const double side = i % 2 == 0 ? -1.0 : 1.0;
    WorldBody& body = bench.add(block, BodyKind::moving, Vec3(0.03 * side, 0.0, 0.02 + 0.03 * i));
    body.restitution = 0.5;
    body.start.linear_momentum.x() = -0.4 * side * body.mass;
  }
  bench.make();
  bench.world.sleeps = false;
  const WorldState start = bench.state;
  for (int i = 0; i < 400; ++i) bench.step();
  const std::uint64_t warm = bench.step().pressing;
  EXPECT_GT(warm, 0u);
  bench.state = start;  // the same again
  std::int64_t taken = 0, queries = 0;
  for (int i = 0; i < 400; ++i) {
    const test::AuditScope scope;
    queries += bench.step().queries;
    const test::AuditCounts counts = scope.counts();
    taken += counts.allocations + counts.locks;
  }
  EXPECT_GT(queries, 20);
  EXPECT_EQ(taken, 0);
}

TEST(WorldAudit, FittingSurfacesTakeNoMemoryOnceWarm) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::WorldBench bench;
  test::add_floor(bench);
  const auto ring = test::body_mesh(make_torus(0.04, 0.006, 48, 24));
  for (int i = 0; i < 3; ++i)
    bench.add(ring, BodyKind::moving, Vec3(0.0, 0.0, 0.006 + 0.0121 * i + 1e-4));
  bench.make();
  bench.world.sleeps = false;
  const WorldState start = bench.state;
  for (int i = 0; i < 100; ++i) bench.step();
  bench.state = start;  // the same again
  std::int64_t taken = 0, handed = 0, rows = 0;
  for (int i = 0; i < 100; ++i) {
    const test::AuditScope scope;
    const WorldStep step = bench.step();
    handed += step.handed;
    rows += step.rows;
    const test::AuditCounts counts = scope.counts();
    taken += counts.allocations + counts.locks;
  }
  EXPECT_GT(handed, 0);
  EXPECT_GT(rows, handed);  // some were cut
  EXPECT_EQ(taken, 0);
}

TEST(WorldAudit, LevelsOfDetailTakeNoMemoryOnceWarm) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::WorldBench bench;
  const auto with_levels = [](const TriangleMesh& mesh) {
    auto made = test::body_mesh(mesh);
    made->hierarchy = build_clod(mesh);
    return made;
  };
  bench.add(with_levels(make_ball(0.1, 12)), BodyKind::fixed, Vec3(0.0, 0.0, -0.1));
  const auto ring = with_levels(make_torus(0.04, 0.012, 36, 18));
  for (int i = 0; i < 2; ++i)
    bench.add(ring, BodyKind::moving, Vec3(0.005 * i, 0.0, 0.02 + 0.03 * i));
  bench.make();
  bench.world.threshold = 0.05;
  bench.world.sleeps = false;
  bench.scratch = reserve_world(bench.world);
  const WorldState start = bench.state;
  for (int i = 0; i < 150; ++i) bench.step();
  bench.state = start;  // the same again
  std::int64_t taken = 0, coarse = 0;
  for (int i = 0; i < 150; ++i) {
    const test::AuditScope scope;
    coarse += bench.step().coarse;
    const test::AuditCounts counts = scope.counts();
    taken += counts.allocations + counts.locks;
  }
  EXPECT_GT(coarse, 0);
  EXPECT_EQ(taken, 0);
}

TEST(WorldAudit, JointsTakeNoMemoryOnceWarm) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::WorldBench bench;
  test::add_floor(bench);
  const auto link = test::body_mesh(make_box(Vec3(0.03, 0.008, 0.005)));
  std::vector<WorldJoint> joints;
  std::vector<BodyState> start{bench.bodies[0].start};
  for (std::int32_t i = 0; i < 6; ++i) {
    bench.add(link, BodyKind::moving, Vec3(0.03 * (i + 0.5), 0.0, 0.1));
    start.push_back(bench.bodies.back().start);
    WorldJoint joint;
    joint.name = "joint " + std::to_string(i);
    joint.kind = i % 2 == 0 ? JointKind::ball : JointKind::hinge;
    joint.a = i + 1;
    joint.b = i == 0 ? -1 : i;
    place_joint(joint, joint_frame(Vec3(0.03 * i, 0.0, 0.1), Vec3::UnitY()), start);
    if (joint.kind == JointKind::hinge) {
      joint.lower = -1.0;
      joint.stiffness = 1e-4;
    }
    joints.push_back(joint);
  }
  bench.world = make_world(bench.bodies, Vec3(0.0, 0.0, -9.81), joints);
  bench.state = start_state(bench.world);
  bench.scratch = reserve_world(bench.world);
  bench.world.sleeps = false;
  const WorldState before = bench.state;
  std::int32_t pressing = 0;
  for (int i = 0; i < 500; ++i) pressing = std::max(pressing, bench.step().pressing);
  EXPECT_GT(pressing, 0);  // its end lies on the floor
  bench.state = before;
  std::int64_t taken = 0;
  for (int i = 0; i < 500; ++i) {
    const test::AuditScope scope;
    bench.step();
    const test::AuditCounts counts = scope.counts();
    taken += counts.allocations + counts.locks;
  }
  EXPECT_EQ(taken, 0);
}

TEST(WorldAudit, HapticStepsTakeNoMemoryAtAll) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::WorldBench bench;
  test::add_floor(bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.03, 0.02)));
  for (int i = 0; i < 4; ++i)
    bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.010002 + 0.020002 * i));
  bench.add(block, BodyKind::held, Vec3(0.0, 0.0, 0.092)).restitution = 0.5;
  bench.make();
  HandHold hand;
  hand.body = 5;
  hand.coupling.linear_stiffness = 1000.0;
  hand.coupling.linear_damping = 16.0;
  BodyState held = bench.state.bodies[5];
  grasp(hand.coupling, held, {held.position, held.orientation});
  hand.handle.pose = {held.position, held.orientation};
  const HandModelScratchPtr scratch = reserve_hand_model(bench.world);
  const auto model = std::make_unique<HandModel>();
  HandMemory memory;
  HandScratch step_scratch;
  reserve_hand_step(step_scratch);
  std::int64_t taken = 0, pressing = 0;
  for (int i = 0; i < 300; ++i) {
    hand.handle.pose.position.z() -= 2e-5;
    bench.step(1e-3, {.hands = {&hand, 1}});
    ++model->sequence;
    make_hand_model(bench.world, bench.state, *bench.scratch, {5, 1e-3, 1e-3}, *scratch, *model);
    const test::AuditScope scope;
    take_hand_model(*model, held, memory);
    const BodyAtState at = at_state(bench.world.rigid[5], held);
    StepForces forces;
    forces.wrench = coupling_wrench(hand.coupling, hand.handle, at, &forces.jacobian);
    const ConstrainedStep step = step_hand(*model, at, forces, 1e-3, memory, step_scratch);
    const test::AuditCounts counts = scope.counts();
    taken += counts.allocations + counts.locks;
    pressing += step.solution.active;
    held = step.state;
  }
  EXPECT_GT(pressing, 100);
  EXPECT_EQ(taken, 0);
}

/// Allocations and locks of so many haptic steps, each with a model of its own.
template <class Each>
std::int64_t taken_by(test::HeldBench& held, int steps, const Vec3& by, Each each) {
  std::int64_t taken = 0;
  for (int i = 0; i < steps; ++i) {
    held.hand.handle.pose.position += by;
    held.step_world();
    ++held.model->sequence;
    make_hand_model(held.bench.world, held.bench.state, *held.bench.scratch,
                    {held.hand.body, 1e-3, 1e-3}, *held.scratch, *held.model);
    const test::AuditScope scope;
    take_hand_model(*held.model, held.body, held.memory);
    const ConstrainedStep step = held.step();
    const test::AuditCounts counts = scope.counts();
    taken += counts.allocations + counts.locks;
    each(step);
  }
  return taken;
}

TEST(WorldAudit, HapticStepsAmongJointsTakeNoMemoryAtAll) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::HeldBench held;
  test::WorldBench& bench = held.bench;
  test::add_floor(bench);
  const auto block = test::body_mesh(make_box(Vec3(0.03, 0.03, 0.03)));
  bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.02));
  bench.add(block, BodyKind::held, Vec3(-0.0305, 0.0, 0.02));
  held.make(2);
  std::vector<BodyState> start;
  for (const WorldBody& body : bench.bodies) start.push_back(body.start);
  // The neighbour is a drawer with an end, a spring and a motor; the held one hangs on the world.
  std::vector<WorldJoint> joints(2);
  joints[0].name = "rail";
  joints[0].kind = JointKind::slider;
  joints[0].a = 1;
  joints[0].lower = -0.001;
  joints[0].upper = 0.004;
  joints[0].damping = 1.0;
  joints[0].motor.is_on = true;
  joints[0].motor.most = 0.1;
  joints[1].name = "cord";
  joints[1].kind = JointKind::spring;
  joints[1].a = 2;
  joints[1].stiffness = 5.0;
  joints[1].rest = 0.01;
  for (WorldJoint& joint : joints)
    place_joint(joint, joint_frame(Vec3(0.0, 0.0, 0.02), Vec3::UnitX()), start);
  bench.world = make_world(bench.bodies, Vec3(0.0, 0.0, -9.81), joints);
  bench.state = start_state(bench.world);
  bench.scratch = reserve_world(bench.world);
  held.scratch = reserve_hand_model(bench.world);
  std::int32_t pressing = 0, jointed = 0;
  const std::int64_t taken =
      taken_by(held, 300, Vec3(3e-5, 0.0, 0.0), [&](const ConstrainedStep& step) {
        pressing += step.solution.active > 0 ? 1 : 0;
        jointed += held.step_scratch.joint_rows.rows.size() > 5 ? 1 : 0;
      });
  EXPECT_GT(pressing, 50);
  EXPECT_GT(jointed, 200);
  EXPECT_EQ(taken, 0);
}

TEST(WorldAudit, HapticStepsWhoseRowsAreCutTakeNoMemoryAtAll) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::HeldBench held;
  test::add_floor(held.bench);
  const auto ring = test::body_mesh(make_torus(0.04, 0.006, 48, 24));
  held.bench.add(ring, BodyKind::moving, Vec3(0.0, 0.0, 0.006 + 1e-5));
  held.bench.add(ring, BodyKind::held, Vec3(0.0, 0.0, 0.018 + 5e-5));
  held.make(2);
  std::int32_t cut = 0, pressing = 0;
  const std::int64_t taken =
      taken_by(held, 100, Vec3(0.0, 0.0, -2e-5), [&](const ConstrainedStep& step) {
        const std::vector<detail::RowCut::Pair>& pairs = held.step_scratch.cut.pairs;
        cut += std::any_of(pairs.begin(), pairs.end(),
                           [](const detail::RowCut::Pair& pair) { return pair.handed < pair.rows; })
                   ? 1
                   : 0;
        pressing += step.solution.active > 0 ? 1 : 0;
      });
  EXPECT_GT(cut, 10);
  EXPECT_GT(pressing, 10);
  EXPECT_EQ(taken, 0);
}

TEST(WorldAudit, SeesAnAllocation) {
  if (const char* why = test::why_no_audit()) GTEST_SKIP() << why;
  test::WorldBench bench;
  test::add_floor(bench);
  bench.add(test::body_mesh(make_box(Vec3(0.04, 0.03, 0.02))), BodyKind::moving,
            Vec3(0.0, 0.0, 0.02));
  bench.make();
  bench.scratch = reserve_world(bench.world, 0);  // no pair: the first one takes memory
  const test::AuditScope scope;
  for (int i = 0; i < 60; ++i) bench.step();
  EXPECT_GT(scope.counts().allocations, 0);
}

}  // namespace
}  // namespace thigma
