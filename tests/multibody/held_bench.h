#pragma once
// A body in a hand on both sides: in its world, and in haptic steps.

#include <algorithm>
#include <memory>

#include "multibody/world_bench.h"

#include "thigma/multibody/hand_step.h"
#include "thigma/multibody/step_world.h"

namespace thigma::test {

/// A body in a hand, on both sides.
struct HeldBench {
  static constexpr double kStep = 1e-3;  // [s]
  WorldBench bench;
  HandHold hand;
  HandModelScratchPtr scratch;
  std::unique_ptr<HandModel> model = std::make_unique<HandModel>();
  HandMemory memory;
  HandScratch step_scratch;
  BodyState body;  // of the haptic side

  void make(std::int32_t held) {
    bench.make();
    scratch = reserve_hand_model(bench.world);
    reserve_hand_step(step_scratch);
    hand.body = held;
    hand.coupling.linear_stiffness = 1000.0;
    hand.coupling.linear_damping = 16.0;
    hand.coupling.angular_stiffness = 2.0;
    hand.coupling.angular_damping = 0.02;
    body = bench.state.bodies[static_cast<std::size_t>(held)];
    hand.handle.pose = {body.position, body.orientation};
    grasp(hand.coupling, body, hand.handle.pose);
  }
  void step_world() { bench.step(kStep, {.hands = {&hand, 1}}); }
  HandCorrection look(double way) {
    ++model->sequence;
    make_hand_model(bench.world, bench.state, *bench.scratch, {hand.body, way, kStep}, *scratch,
                    *model);
    return take_hand_model(*model, body, memory);
  }
  ConstrainedStep step() {
    const RigidBody& rigid = bench.world.rigid[static_cast<std::size_t>(hand.body)];
    const BodyAtState at = at_state(rigid, body);
    StepForces forces;
    forces.wrench = coupling_wrench(hand.coupling, hand.handle, at, &forces.jacobian);
    const ConstrainedStep made = step_hand(*model, at, forces, kStep, memory, step_scratch);
    body = made.state;
    return made;
  }
  /// Least distance to another body of where the haptic side has it, 0 where it is in one [m].
  double least_distance() {
    BodyState& of_world = bench.state.bodies[static_cast<std::size_t>(hand.body)];
    const BodyState kept = of_world;
    of_world = body;
    double least = kInfinity;
    for (std::size_t i = 0; i < bench.bodies.size(); ++i)
      if (static_cast<std::int32_t>(i) != hand.body)
        least = std::min(least, bench.distance(i, static_cast<std::size_t>(hand.body)));
    of_world = kept;
    return least;
  }
};

/// A block in the hand beside one on a floor.
inline void make_beside(HeldBench& held) {
  add_floor(held.bench);
  const auto block = body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  held.bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.02 + 3e-6));
  held.bench.add(block, BodyKind::held, Vec3(-0.0405, 0.0, 0.03));
  held.make(2);
}

}  // namespace thigma::test
