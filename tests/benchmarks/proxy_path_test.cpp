#include "benchmarks/proxy_path.h"

#include <algorithm>
#include <memory>

#include "benchmarks/proxy_methods.h"
#include <gtest/gtest.h>

#include "thigma/constraint/build_constraints.h"

namespace thigma::bench {
namespace {

constexpr double kSeconds = 1.5;  // comes down and presses

class ProxyPath : public ::testing::Test {
 protected:
  static const ProxyScene& spoon() {
    static const ProxyScene scene = load_proxy_scene({.scene = "cup_spoon", .triangles = 3000});
    return scene;
  }
  static PlayedSession play_exact() {
    SceneSession session = open_proxy_session(spoon());
    ContactScratch scratch;
    reserve_contact_scratch(session.config.contact, scratch);
    return play_session(session, kSeconds, [&](const StampedBody& body, ContactSample& sample) {
      contact_step(session.config.contact, body, scratch, sample);
    });
  }
};

TEST_F(ProxyPath, IsThatOfALockstepSessionBitForBit) {
  const PlayedSession played = play_exact();
  SceneSession session = open_proxy_session(spoon());
  session.config.duration = kSeconds;
  std::vector<std::uint64_t> models;
  std::vector<Vec3> forces;
  run_lockstep(session,
               {.haptic = [&](const HapticSample& s) { forces.push_back(s.command.force); },
                .contact = [&](const ContactSample& s) { models.push_back(s.model_digest); },
                .event = {}});
  EXPECT_EQ(played.models, models);
  ASSERT_EQ(played.forces.size(), forces.size());
  for (std::size_t i = 0; i < forces.size(); ++i) ASSERT_EQ(played.forces[i], forces[i]) << i;
  const auto largest = std::max_element(forces.begin(), forces.end(),
                                        [](auto& a, auto& b) { return a.norm() < b.norm(); });
  EXPECT_GT(largest->norm(), 0.2) << "nothing was touched";
}

TEST_F(ProxyPath, RemembersWhatItAnsweredAndFindsItAgain) {
  const PlayedSession played = play_exact();
  SceneSession session = open_proxy_session(spoon());
  const ContactWorld& world = session.config.contact;
  const std::vector<AskedQuery> asked = asked_on(world, played.bodies);
  MethodRun query{"query"}, rows{"rows"}, carried{"carried"}, its_rows{"its rows"};
  run_engine(world, played.bodies, query, rows);
  ContactWorld carrying = world;
  carrying.resolution.carry = 0.1;
  run_engine(carrying, played.bodies, carried, its_rows);
  const Checked truth = find_truths(world, asked, 30);
  for (MethodRun* method : {&query, &rows}) compare_reports(truth, *method);
  EXPECT_EQ(query.quality.recall, 1.0);
  EXPECT_EQ(query.quality.error_max, 0.0);
  EXPECT_EQ(query.seconds.size(), played.bodies.size());
  EXPECT_GT(query.contacts(), 1.0);
  // Whatever was carried, no contact of the exact query is missing.
  for (std::size_t k = 0; k < truth.frames.size(); ++k)
    EXPECT_GE(carried.reports[truth.frames[k]].points.size(), truth.reports[k].points.size()) << k;
}

TEST_F(ProxyPath, ShellsKeepTheObjectOutsideAboutAsExactRowsDo) {
  const PlayedSession played = play_exact();
  SceneSession session = open_proxy_session(spoon());
  const std::vector<AskedQuery> asked = asked_on(session.config.contact, played.bodies);
  const ShellPair shells = build_shells(spoon().scene, asked);
  const PlayedSession with_shells = play_shell(session, shells, kSeconds);
  const double error = force_error(with_shells, played);
  EXPECT_GT(error, 0.0);
  EXPECT_LT(error, 0.3);
  EXPECT_EQ(force_error(played, played), 0.0);
  // 3,000 triangles: vertices alone leave the other's edges room to enter by some of that.
  const double radius = session.config.contact.constraints->reach;
  EXPECT_LT(deepest_on(session.config.contact, with_shells.bodies), 0.05 * radius);
  EXPECT_LE(deepest_on(session.config.contact, played.bodies), 0.0);
}

}  // namespace
}  // namespace thigma::bench
