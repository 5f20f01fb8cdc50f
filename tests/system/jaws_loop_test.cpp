// The loop closed on the jaws: contact 2 kN/m, coupling 200 and 500
// N/m, 10 g, dof 6 and 3. Coarser jaws by default, the full ones with THIGMA_FULL set.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "support/full.h"
#include "support/mesh_session.h"
#include <gtest/gtest.h>

#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

struct Jaws {
  ClodHierarchy upper, lower;
  SceneDescription scene;
  LoadedObject object;
  SessionConfig config;
  StartPlacement start;

  Jaws() : scene(read_scene("jaws")) {
    if (!test::is_full()) {
      scene.object.model->triangles = 14000;
      scene.statics[0].model->triangles = 12000;
    }
    scene.contact.stiffness = 2000.0;
    object = load_object(scene.object);
    upper = build_exact_hierarchy(object.mesh);
    lower = build_exact_hierarchy(load_object(scene.statics[0]).mesh);
    set_coupling(300.0);
    start = find_start(config.contact, config.world_from_body);
  }

  void set_coupling(double stiffness) {
    scene.coupling.linear_stiffness = stiffness;
    config = make_session_config(scene, object);
    config.contact.object = &upper;
    config.contact.scene = {{&lower, scene.statics[0].world_from_mesh}};
    config.contact_every = 4;  // 250 Hz, as a loaded machine would
    config.contact_latency = 4;
    config.world_from_body = start.has_scene ? start.world_from_body : config.world_from_body;
  }
};

Jaws& jaws() {
  static Jaws the;
  return the;
}

struct Case {
  double coupling;
  int dof;
};

class JawsLoop : public testing::TestWithParam<Case> {
 protected:
  HandParams hand(HandPath path) const {
    HandParams h;
    h.senses_rotation = h.actuates_rotation = GetParam().dof == 6;
    h.program.path = path;
    h.program.approach = jaws().start.approach;
    h.program.clearance = jaws().start.clearance;
    h.program = scale_to_object(h.program, jaws().object.ball.radius);
    h.program.twist_by_buttons = GetParam().dof == 3;
    return h;
  }

  test::Kept run(HandPath path, double duration) const {
    jaws().set_coupling(GetParam().coupling);
    jaws().config.duration = duration;
    HandDevice device(hand(path));
    test::Kept kept(jaws().config, device);
    std::printf(
        "  coupling %.0f N/m, dof %d: force max %.3f N, torque max %.4f N m, penetration max %.3f "
        "mm, "
        "contacts mean %.0f\n",
        GetParam().coupling, GetParam().dof, kept.summary.force_max, kept.summary.torque_max,
        1e3 * kept.summary.penetration_max, kept.summary.contacts_mean);
    return kept;
  }
};

struct Window {
  double drift = 0.0;  // from first to last frame [m]
  double swing = 0.0;  // peak to peak beyond the drift [m]
};

/// Handle along the approach over frames [from, to).
Window window_of(const test::Kept& kept, const Vec3& along, std::size_t from, std::size_t to) {
  double low = 1e300, high = -1e300;
  const auto at = [&](std::size_t i) {
    return along.dot(kept.samples[i].device.motion.pose.position);
  };
  for (std::size_t i = from; i < to; ++i) {
    low = std::min(low, at(i));
    high = std::max(high, at(i));
  }
  const double drift = std::fabs(at(to - 1) - at(from));
  return {drift, high - low - drift};
}

double force_change(const test::Kept& kept, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t i = from + 1; i < to; ++i) {
    sum += (kept.samples[i].command.force - kept.samples[i - 1].command.force).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(to - from - 1));
}

TEST_P(JawsLoop, RestsAndPressesWithinAnEncoderStep) {
  const test::Kept kept = run(HandPath::press, 4.0);
  ASSERT_EQ(kept.summary.end, SessionEnd::duration);
  const Vec3 along = jaws().start.approach;
  const double encoder = hand(HandPath::press).encoder;
  EXPECT_NEAR(kept.samples.back().command.force.norm(), 1.0, 0.2);
  // Without friction a pressed jaw slips down its teeth now and then, so "at rest" is a quarter of
  // a second in which it does not get anywhere. An encoder step along each axis: the approach need
  // not be an axis of the device.
  const double step = encoder * along.lpNorm<1>() * 1.001;
  int rests = 0;
  for (std::size_t from = 1500; from + 250 <= kept.samples.size(); from += 125) {
    const Window window = window_of(kept, along, from, from + 250);
    if (window.drift > step) continue;
    ++rests;
    EXPECT_LE(window.swing, step) << "from frame " << from;
  }
  EXPECT_GE(rests, 2);
  EXPECT_LT(kept.summary.force_max, 2.0);
  EXPECT_LT(kept.summary.penetration_max, 1e-3);
}

TEST_P(JawsLoop, SlidesAndTapsWithoutGrowth) {
  const test::Kept kept = run(HandPath::demo, 14.0);
  ASSERT_EQ(kept.summary.end, SessionEnd::duration);
  EXPECT_GT(kept.summary.force_max, 0.5);
  EXPECT_LT(kept.summary.force_max, 3.0);
  // The program repeats: its second half is no rougher than its first.
  EXPECT_LT(force_change(kept, 1000, 14000), 0.05);
  EXPECT_LE(force_change(kept, 7000, 14000), 1.5 * force_change(kept, 500, 7000) + 2e-3);
  if (GetParam().dof == 3) {
    for (const HapticSample& s : kept.samples) ASSERT_EQ(s.command.torque, Vec3::Zero());
    EXPECT_GT(kept.summary.torque_max, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Gains, JawsLoop,
                         testing::Values(Case{200.0, 6}, Case{500.0, 6}, Case{200.0, 3},
                                         Case{500.0, 3}),
                         [](const testing::TestParamInfo<Case>& each) {
                           return "coupling" +
                                  std::to_string(static_cast<int>(each.param.coupling)) + "dof" +
                                  std::to_string(each.param.dof);
                         });

}  // namespace
}  // namespace thigma
