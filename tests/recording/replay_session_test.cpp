#include "thigma/recording/replay_session.h"

#include <bit>

#include "support/plane_session.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::plane_hand;
using test::plane_session;

struct Recorded {
  SessionConfig config = plane_session();
  HapticParams params;
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  SessionSummary summary;

  explicit Recorded(const char* faults = "") {
    config.duration = 0.8;
    config.contact_every = 3;
    config.faults = parse_faults(faults);
    HandParams hand = plane_hand(HandPath::press);
    hand.tremor = 1e-5;
    HandDevice device(hand);
    summary = run_lockstep(config, device,
                           {[this](const HapticSample& s) { samples.push_back(s); },
                            [this](const ContactSample& s) { models.push_back(s); },
                            {}});
    params = config.haptic;
    params.device = device.limits();
  }
  ReplayReport replay() const {
    return replay_session(params, config.world_from_body, samples, models);
  }
};

TEST(ReplaySession, IsIdentical) {
  const Recorded r;
  const ReplayReport report = r.replay();
  EXPECT_TRUE(report.identical) << report.first_difference << ' ' << report.reason;
  EXPECT_EQ(report.state_hash, r.summary.state_hash);
  EXPECT_EQ(report.recorded_hash, r.summary.state_hash);
  EXPECT_EQ(report.frames, r.summary.frames);
  EXPECT_EQ(report.first_difference, -1);
}

TEST(ReplaySession, IsIdenticalThroughFaults) {
  for (const char* fault : {"unplug@0.4", "nan@0.4", "stall=0.1@0.4", "hang=0.1@0.4"}) {
    const Recorded r(fault);
    ASSERT_EQ(r.summary.end, SessionEnd::fault) << fault;
    EXPECT_TRUE(r.replay().identical) << fault << ' ' << r.replay().reason;
  }
}

TEST(ReplaySession, OneChangedBitIsFoundAtItsFrame) {
  const Recorded original;
  for (const int bit : {0, 20, 51}) {
    for (const bool has_digest : {true, false}) {
      Recorded r = original;
      double& x = r.samples[300].device.motion.pose.position.x();
      x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ (std::uint64_t{1} << bit));
      if (!has_digest) {
        if (bit == 0) continue;  // may be lost in rounding: that is what the digest is for
        for (HapticSample& s : r.samples) s.input_digest = 0;
      }
      const ReplayReport report = r.replay();
      EXPECT_FALSE(report.identical);
      EXPECT_EQ(report.first_difference, 300) << bit << ' ' << has_digest << ' ' << report.reason;
    }
  }
}

TEST(ReplaySession, MissingFramesAndModelsAreDifferences) {
  Recorded gap;
  gap.samples.erase(gap.samples.begin() + 100);
  EXPECT_FALSE(gap.replay().identical);
  EXPECT_EQ(gap.replay().first_difference, 101);
  Recorded blind;
  const std::uint64_t used = blind.samples[200].model_sequence;
  std::erase_if(blind.models, [used](const ContactSample& s) { return s.model.sequence == used; });
  const ReplayReport report = blind.replay();
  EXPECT_FALSE(report.identical);
  EXPECT_NE(report.reason.find("contact model"), std::string::npos);
}

TEST(ReplaySession, TakesFramesAndModelsInWhateverOrderTheirThreadsWroteThem) {
  const Recorded r;
  const ReplayReport expected = r.replay();
  for (const std::size_t ahead : {0u, 1u, 40u, 300u}) {  // frames before the models they name
    SessionReplay replay(r.params, r.config.world_from_body);
    std::size_t model = 0;
    for (std::size_t i = 0; i < r.samples.size(); ++i) {
      replay.add(r.samples[i]);
      const std::uint64_t wanted = r.samples[i < ahead ? 0 : i - ahead].model_sequence;
      while (model < r.models.size() && r.models[model].model.sequence <= wanted)
        replay.add(r.models[model++]);
    }
    while (model < r.models.size()) replay.add(r.models[model++]);
    const ReplayReport report = replay.finish();
    EXPECT_TRUE(report.identical) << ahead << ' ' << report.reason;
    EXPECT_EQ(report.state_hash, expected.state_hash);
  }
}

TEST(ReplaySession, AnotherParameterIsADifference) {
  Recorded r;
  r.params.coupling.linear_stiffness *= 1.0 + 1e-12;
  EXPECT_FALSE(r.replay().identical);
}

}  // namespace
}  // namespace thigma
