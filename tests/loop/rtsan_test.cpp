// The same under RealtimeSanitizer (preset rtsan): every THIGMA_RT function is watched by the
// compiler itself.

#include <memory>
#include <mutex>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/mesh/shapes.h"
#include "thigma/session/session_config.h"

#if defined(__has_feature)
#if __has_feature(realtime_sanitizer)
#define THIGMA_HAS_RTSAN 1
#endif
#endif

namespace thigma {
namespace {

#ifdef THIGMA_HAS_RTSAN
constexpr const char* kWhyNot = nullptr;
#else
constexpr const char* kWhyNot = "not built with RealtimeSanitizer: the rtsan preset runs this";
#endif

// Through pointers the optimiser cannot see through, so that the calls stay.
void* (*volatile allocate)(std::size_t) = std::malloc;
void (*volatile release)(void*) = std::free;

[[maybe_unused]] void allocates() THIGMA_RT { release(allocate(64)); }
[[maybe_unused]] void locks() THIGMA_RT {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
}

TEST(Rtsan, TenThousandHapticStepsPass) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  SessionConfig config = test::plane_session();
  config.duration = 10.0;
  HandParams hand = test::plane_hand(HandPath::demo);
  HandDevice device(hand);
  const SessionSummary s = run_lockstep(config, device);
  EXPECT_EQ(s.frames, 10000u);
  EXPECT_EQ(s.end, SessionEnd::duration);
  EXPECT_GT(s.force_max, 0.5);
}

/// A cube in a hand over a sheet, in contact most of the time, with friction and a static
/// coefficient of its own.
struct Rubbing {
  ClodHierarchy cube = build_exact_hierarchy(make_box(Vec3::Constant(2.0 * test::kCubeHalf)));
  ClodHierarchy sheet = build_exact_hierarchy(make_sheet(0.2, 0.2, 8, 8));
  SessionConfig config = test::plane_session();
  HandDevice device{test::plane_hand(HandPath::demo)};

  Rubbing() {
    config.contact.source = nullptr;
    config.contact.object = &cube;
    config.contact.scene = {{&sheet, Pose{}}};
    config.contact.friction = {{0.3, 0.4}};
    config.duration = 10.0;
  }
};

TEST(Rtsan, NorDoTenThousandUnderConstraintsWithFriction) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  Rubbing rubbing;
  use_constraints(rubbing.config);
  const SessionSummary s = run_lockstep(rubbing.config, rubbing.device);
  EXPECT_EQ(s.frames, 10000u);
  EXPECT_EQ(s.end, SessionEnd::duration);
  EXPECT_GT(s.force_max, 0.5);
  EXPECT_GE(s.constraint.active_max, 3);  // and it was the real thing
  EXPECT_GT(s.constraint.rows_max, 3);
  EXPECT_TRUE(s.friction.is_on);
  EXPECT_GT(s.constraint.solve.count, 1000u);
}

TEST(Rtsan, NorDoFramesThatAreHeldBackTapAndBounce) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  Rubbing rubbing;
  rubbing.config.haptic.impacts = {{0.5, {5.0, 150.0, 0.02}}};
  rubbing.config.contact_every = 30;
  use_constraints(rubbing.config);
  int rang = 0;
  SessionSinks sinks;
  sinks.haptic = [&](const HapticSample& s) { rang += s.tap.force.norm() > 0.0 ? 1 : 0; };
  const SessionSummary s = run_lockstep(rubbing.config, rubbing.device, sinks);
  EXPECT_EQ(s.frames, 10000u);
  EXPECT_GT(s.constraint.held_back_frames, 0u);
  EXPECT_GT(rang, 10);
}

TEST(Rtsan, NorDoBristles) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  Rubbing rubbing;
  const SessionSummary s = run_lockstep(rubbing.config, rubbing.device);
  EXPECT_EQ(s.frames, 10000u);
  EXPECT_TRUE(s.friction.is_on);
}

TEST(Rtsan, NorDoesAFaultInContact) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  for (const InjectedFault kind : {InjectedFault::nan, InjectedFault::unplug}) {
    Rubbing rubbing;
    use_constraints(rubbing.config);
    rubbing.config.faults = {{kind, 3.0, 0.05}};
    const SessionSummary s = run_lockstep(rubbing.config, rubbing.device);
    EXPECT_EQ(s.end, SessionEnd::fault);
    EXPECT_GT(s.force_max, 0.2);
  }
}

TEST(RtsanDeathTest, CatchesAPlantedAllocation) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  EXPECT_EXIT(allocates(), testing::ExitedWithCode(43), "malloc");
}

TEST(RtsanDeathTest, CatchesAPlantedLock) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  EXPECT_EXIT(locks(), testing::ExitedWithCode(43), "pthread_mutex_lock");
}

}  // namespace
}  // namespace thigma
