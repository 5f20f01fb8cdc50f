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

TEST(Rtsan, NorDoTenThousandUnderConstraintsWithFriction) {
  if (kWhyNot != nullptr) GTEST_SKIP() << kWhyNot;
  const ClodHierarchy cube = build_exact_hierarchy(make_box(Vec3::Constant(2.0 * test::kCubeHalf)));
  const ClodHierarchy sheet = build_exact_hierarchy(make_sheet(0.2, 0.2, 8, 8));
  SessionConfig config = test::plane_session();
  config.contact.source = nullptr;
  config.contact.object = &cube;
  config.contact.scene = {{&sheet, Pose{}}};
  config.contact.friction.assign(config.contact.scene.size(), {0.3, 0.3});
  use_constraints(config);
  config.duration = 10.0;
  HandDevice device(test::plane_hand(HandPath::demo));
  const SessionSummary s = run_lockstep(config, device);
  EXPECT_EQ(s.frames, 10000u);
  EXPECT_EQ(s.end, SessionEnd::duration);
  EXPECT_GT(s.force_max, 0.5);
  EXPECT_GE(s.constraint.active_max, 3);  // and it was the real thing
  EXPECT_GT(s.constraint.rows_max, 3);
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
