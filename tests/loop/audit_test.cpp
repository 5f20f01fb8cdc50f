// The fast threads neither allocate, lock nor call the system: counted, in contact, with recording
// on.

#include "support/audit.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/latest.h"
#include "thigma/core/spsc_ring.h"
#include "thigma/device/hand.h"
#include "thigma/loop/contact_step.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/recording/recording.h"
#include "thigma/session/session.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

using test::AuditCounts;
using test::AuditScope;

// Through a pointer the optimiser cannot see through, so that the planted pair of calls stays.
void* (*volatile allocate)(std::size_t) = std::malloc;

/// Does something forbidden in one frame.
class PlantingDevice final : public HapticDevice {
 public:
  enum class Plant { nothing, allocation, lock, system_call };
  PlantingDevice(HapticDevice& inner, Plant plant) : inner_(inner), plant_(plant) {}
  const DeviceLimits& limits() const override { return inner_.limits(); }
  std::string name() const override { return inner_.name(); }
  DeviceState read(double now) THIGMA_RT override { return inner_.read(now); }
  void write(const Wrench& wrench) THIGMA_RT override {
    inner_.write(wrench);
    if (++count_ != 700) return;
    if (plant_ == Plant::allocation) std::free(allocate(64));
    if (plant_ == Plant::lock) const std::lock_guard lock(mutex_);
    if (plant_ == Plant::system_call) syscall(SYS_getppid);
  }

 private:
  HapticDevice& inner_;
  Plant plant_;
  int count_ = 0;
  std::mutex mutex_;
};

struct AuditResult {
  bool sees_system_calls = false;
  AuditCounts haptic, contact;
  int touching_frames = 0, coarse_frames = 0;
  std::set<std::int32_t> cluster_ids;
  std::uint64_t dropped = 0;
};

/// A ball of 320 triangles that a hand slides over a rippled sheet.
struct Scene {
  ClodHierarchy ball = build_exact_hierarchy(make_ball(0.01, 4));
  ClodHierarchy sheet = build_exact_hierarchy(rippled_sheet());
  SessionConfig config;

  static TriangleMesh rippled_sheet() {
    TriangleMesh mesh = make_sheet(0.08, 0.08, 40, 40);
    for (Vec3& p : mesh.positions) p.z() = 5e-4 * sine(800.0 * p.x()) * cosine(700.0 * p.y());
    return mesh;
  }
  Scene() {
    const double mass = 0.010;
    config.haptic.body = make_body(mass, 0.4 * mass * 1e-4 * Mat3::Identity());
    config.haptic.coupling.linear_stiffness = 300.0;
    config.haptic.coupling.linear_damping = 2.0;
    config.haptic.coupling.angular_stiffness = 0.03;
    config.haptic.coupling.angular_damping = 1e-4;
    config.contact.object = &ball;
    config.contact.scene = {{&sheet, Pose{}}};
    config.contact.tolerance = 2e-4;
    // more than there are contacts: they come and go
    config.contact.max_clusters = kMaxContactClusters;
    config.contact.response.damping = 1.0;
    config.world_from_body.position = {0.0, 0.0, 0.0115};
  }
};

/// Warms up, then watches `haptic_frames` haptic steps and a contact step every tenth, all in one
/// thread, while this thread writes the recording.
AuditResult audit(PlantingDevice::Plant plant, int haptic_frames,
                  ResponseKind response = ResponseKind::coupled, bool has_levels = false) {
  Scene scene;
  if (has_levels) {
    scene.ball = build_clod(make_ball(0.01, 10));
    scene.sheet = build_clod(Scene::rippled_sheet());
    scene.config.contact.resolution.is_exact = false;
  }
  scene.config.contact.friction.assign(scene.config.contact.scene.size(), {0.3, 0.4});
  if (response == ResponseKind::constrained) use_constraints(scene.config);
  scene.config.contact.potential_law.area = 2e-5;
  if (response == ResponseKind::potential) use_potential(scene.config);
  HandParams hand;
  hand.program.path = HandPath::slide;
  hand.program.clearance = 0.001;
  HandDevice simulated(hand);
  PlantingDevice device(simulated, plant);
  const auto models = std::make_unique<Latest<LinearContactModel>>();
  const auto bodies = std::make_unique<Latest<StampedBody>>();
  const auto ring = std::make_unique<SpscRing<HapticSample>>(16384);
  HapticParams params = scene.config.haptic;
  params.device = device.limits();
  HapticState state = initial_state(params, scene.config.world_from_body);
  ContactScratch scratch;
  reserve_contact_scratch(scene.config.contact, scratch);
  ContactSample contact;
  AuditResult result;
  std::atomic<bool> done{false};

  const auto contact_frame = [&](double now) {
    contact_step(scene.config.contact, {state.body, now, state.frame, state.wanted_speed}, scratch,
                 contact);
    models->publish(contact.model);
  };
  const auto frames = [&](int count, bool is_watched) {
    std::array<std::int32_t, 64> ids{};
    for (int i = 0; i < count; ++i) {
      const double now = 1e-3 * static_cast<double>(state.frame);
      std::size_t id_count = 0;
      HapticSample sample;
      if (is_watched) {
        const AuditScope scope;
        if (i % 10 == 0) contact_frame(now);
        const AuditCounts c = scope.counts();
        sample = haptic_step(params, {&device, models.get(), bodies.get(), ring.get()},
                             {now, 1e-3, Fault::none}, state);
        const AuditCounts both = scope.counts();
        result.contact.allocations += c.allocations;
        result.contact.frees += c.frees;
        result.contact.locks += c.locks;
        result.contact.system_calls += c.system_calls;
        result.haptic.allocations += both.allocations - c.allocations;
        result.haptic.frees += both.frees - c.frees;
        result.haptic.locks += both.locks - c.locks;
        result.haptic.system_calls += both.system_calls - c.system_calls;
      } else {
        if (i % 10 == 0) contact_frame(now);
        sample = haptic_step(params, {&device, models.get(), bodies.get(), ring.get()},
                             {now, 1e-3, Fault::none}, state);
      }
      if (sample.touching > 0) ++result.touching_frames;
      if (contact.coarse > 0) ++result.coarse_frames;
      for (const PlaneTerm& term : contact.model.planes) {
        if (id_count < ids.size()) ids[id_count++] = term.id;
      }
      for (std::size_t k = 0; k < id_count; ++k) result.cluster_ids.insert(ids[k]);
    }
  };
  std::thread fast([&] {
    frames(600, false);
    result.touching_frames = 0;
    result.cluster_ids.clear();
    result.sees_system_calls = test::forbid_system_calls();
    frames(haptic_frames / 2, true);
    scene.config.contact.distributes_wide_contacts = false;
    frames(haptic_frames - haptic_frames / 2, true);
    done = true;
  });
  const std::string path = (std::filesystem::temp_directory_path() /
                            ("thigma-audit-" + std::to_string(getpid()) + ".mcap"))
                               .string();
  {
    RecordingWriter recording(path, "{}");
    while (!done || ring->front() != nullptr) {
      while (const HapticSample* sample = ring->front()) {
        recording.write(*sample);
        ring->pop();
      }
      sleep_ns(1'000'000);
    }
    fast.join();
    recording.close({});
  }
  std::filesystem::remove(path);
  result.dropped = ring->dropped();
  return result;
}

TEST(Audit, TenThousandHapticAndAThousandContactStepsTouchNeitherMemoryNorLocksNorSystem) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const AuditResult r = audit(PlantingDevice::Plant::nothing, 10000);
  EXPECT_TRUE(r.sees_system_calls) << "seccomp is not available: system calls were not watched";
  EXPECT_EQ(r.haptic.total(), 0) << "allocations " << r.haptic.allocations << ", frees "
                                 << r.haptic.frees << ", locks " << r.haptic.locks
                                 << ", system calls " << r.haptic.system_calls;
  EXPECT_EQ(r.contact.total(), 0) << "allocations " << r.contact.allocations << ", frees "
                                  << r.contact.frees << ", locks " << r.contact.locks
                                  << ", system calls " << r.contact.system_calls;
  // And it was the real thing: in contact, clusters coming and going, every sample recorded.
  EXPECT_GT(r.touching_frames, 8000);
  EXPECT_GT(r.cluster_ids.size(), 5u);
  EXPECT_EQ(r.dropped, 0u);
}

TEST(Audit, NorDoTheyUnderConstraints) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const AuditResult r = audit(PlantingDevice::Plant::nothing, 5000, ResponseKind::constrained);
  EXPECT_EQ(r.haptic.total(), 0);
  EXPECT_EQ(r.contact.total(), 0) << "allocations " << r.contact.allocations;
  EXPECT_GT(r.touching_frames, 3000);
}

TEST(Audit, NorDoTheyUnderThePotential) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const AuditResult r = audit(PlantingDevice::Plant::nothing, 5000, ResponseKind::potential);
  EXPECT_EQ(r.haptic.total(), 0);
  EXPECT_EQ(r.contact.total(), 0) << "allocations " << r.contact.allocations;
  EXPECT_GT(r.touching_frames, 3000);
}

TEST(Audit, NorDoTheyWhereFarPairsStayCoarse) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const AuditResult r =
      audit(PlantingDevice::Plant::nothing, 5000, ResponseKind::constrained, true);
  EXPECT_EQ(r.haptic.total(), 0);
  EXPECT_EQ(r.contact.total(), 0) << "allocations " << r.contact.allocations;
  EXPECT_GT(r.touching_frames, 3000);
  EXPECT_GT(r.coarse_frames, 100);
}

TEST(Audit, CatchesAPlantedAllocation) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const AuditResult r = audit(PlantingDevice::Plant::allocation, 200);
  EXPECT_EQ(r.haptic.allocations, 1);
  EXPECT_EQ(r.haptic.frees, 1);
}

TEST(Audit, CatchesAPlantedLock) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  EXPECT_GE(audit(PlantingDevice::Plant::lock, 200).haptic.locks, 1);
}

TEST(Audit, CatchesAPlantedSystemCall) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const AuditResult r = audit(PlantingDevice::Plant::system_call, 200);
  if (!r.sees_system_calls) GTEST_SKIP() << "seccomp is not available";
  EXPECT_EQ(r.haptic.system_calls, 1);
}

}  // namespace
}  // namespace thigma
