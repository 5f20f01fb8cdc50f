// Taking up a hand model: the body in the hand goes back by no more than it must.

#include "multibody/held_bench.h"
#include <gtest/gtest.h>

#include "thigma/multibody/hand_step.h"

namespace thigma {
namespace {

using test::HeldBench;
using test::make_beside;

TEST(HandTake, WhereTheWorldHasSomethingTheBodyGoesBackByNoMoreThanItMust) {
  for (const double into : {1e-5, 1e-3}) {
    HeldBench held;
    make_beside(held);
    held.step_world();
    held.body = held.bench.state.bodies[2];
    held.body.position.x() += 0.5e-3 + into;
    EXPECT_EQ(held.least_distance(), 0.0);
    const double before = held.body.position.x();
    const HandCorrection correction = held.look(2e-3);
    EXPECT_GT(held.least_distance(), 0.0) << into;
    EXPECT_LT(held.least_distance(), 1e-6) << into;
    EXPECT_NEAR(correction.way, before - held.body.position.x(), 1e-12);
    EXPECT_NEAR(correction.way, into, 1e-6 + 1e-3 * into);
  }
}

TEST(HandTake, WhereNothingIsTheBodyStaysWhereItIs) {
  HeldBench held;
  make_beside(held);
  held.step_world();
  held.body = held.bench.state.bodies[2];
  held.body.position.x() -= 1e-4;
  const BodyState before = held.body;
  EXPECT_EQ(held.look(2e-3).way, 0.0);
  EXPECT_EQ(held.body.position, before.position);
  EXPECT_EQ(held.body.orientation.coeffs(), before.orientation.coeffs());
}

}  // namespace
}  // namespace thigma
