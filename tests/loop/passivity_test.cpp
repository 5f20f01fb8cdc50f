#include "thigma/loop/passivity.h"

#include <cmath>

#include <gtest/gtest.h>

#include "thigma/math/elementary.h"

namespace thigma {
namespace {

/// Moves the handle along x(t) with the wrench of a law, held over each tick, and returns the
/// observer.
template <class Position, class Force>
EnergyObserver observe(int ticks, Position position, Force force) {
  EnergyObserver observer;
  for (int k = 0; k <= ticks; ++k) {
    Pose handle;
    handle.position.x() = position(k);
    observe_motion(observer, handle);
    observe_wrench(observer, {Vec3(force(handle.position.x()), 0.0, 0.0), Vec3::Zero()});
  }
  return observer;
}

TEST(EnergyObserver, SampledSpringGivesBackMoreThanItGotByExactlyTheHeldForce) {
  // A spring F = -k x, pressed to X and let back, sampled in steps of X/n: the force lags by a tick
  // each way, so the port gains k X^2 / n. This leak is what damping has to make up for.
  constexpr double k = 500.0, X = 0.01;
  constexpr int n = 20;
  const auto triangle = [](int i) { return X * (i <= n ? i : 2 * n - i) / n; };
  const EnergyObserver e = observe(2 * n, triangle, [](double x) { return -k * x; });
  EXPECT_NEAR(e.energy, -k * X * X / n, 1e-15);
  EXPECT_NEAR(e.energy_min, e.energy, 1e-15);
}

TEST(EnergyObserver, DraggingCostsEnergyAndPushingGainsIt) {
  const auto away = [](int i) { return 1e-3 * i; };
  EXPECT_NEAR(observe(100, away, [](double) { return -2.0; }).energy, 0.2, 1e-12);
  const EnergyObserver pushed = observe(100, away, [](double) { return 2.0; });
  EXPECT_NEAR(pushed.energy, -0.2, 1e-12);
  EXPECT_NEAR(pushed.energy_min, -0.2, 1e-12);
}

TEST(EnergyObserver, CountsTorqueOverTheShorterTurnWhateverTheSignOfTheQuaternion) {
  EnergyObserver observer;
  const auto turned = [](double angle, double sign) {
    const SinCos h = sin_cos(0.5 * angle);
    Pose pose;
    pose.orientation = Quat(sign * h.cos, 0.0, 0.0, sign * h.sin);
    return pose;
  };
  observe_motion(observer, turned(0.3, 1.0));
  observe_wrench(observer, {Vec3::Zero(), Vec3(0.0, 0.0, -0.5)});
  observe_motion(observer, turned(0.5, -1.0));
  EXPECT_NEAR(observer.energy, 0.5 * 0.2, 1e-14);
}

TEST(EnergyObserver, FirstSampleMovesNothing) {
  EnergyObserver observer;
  observe_wrench(observer, {Vec3(1.0, 0.0, 0.0), Vec3::Zero()});
  Pose far;
  far.position.x() = 10.0;
  observe_motion(observer, far);
  EXPECT_EQ(observer.energy, 0.0);
}

}  // namespace
}  // namespace thigma
