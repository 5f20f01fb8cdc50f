#include "thigma/loop/contact_step.h"

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/constraint/build_constraints.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/conforming.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

using test::kCubeHalf;
using test::plane_session;

StampedBody at_height(double z) {
  StampedBody at;
  at.state.position = {0.0, 0.0, z};
  at.time = 1.25;
  return at;
}

/// Two surfaces, one above the other and kept out of it by rows, and contact frames of them.
struct KeptOut {
  ClodHierarchy above, below;
  SessionConfig config;
  ContactScratch scratch;
  ContactSample sample;
  StampedBody body;

  KeptOut(const TriangleMesh& object, const TriangleMesh& scene, double height)
      : above(build_exact_hierarchy(object)),
        below(build_exact_hierarchy(scene)),
        body(at_height(height)) {
    config.haptic.body = make_body(0.01, 1e-6 * Mat3::Identity());
    config.contact.object = &above;
    config.contact.scene = {{&below, Pose{}}};
    use_constraints(config);
    reserve_contact_scratch(config.contact, scratch);
  }
  KeptOut(const KeptOut&) = delete;  // the session names its surfaces
  KeptOut& operator=(const KeptOut&) = delete;

  /// How far the next frame looks ahead, so much later [s], where the hand wants to go so far until
  /// the model after the next [m].
  double look(double period, double wanted = 0.0) {
    body.time += period;
    body.wanted_speed = wanted / (2.0 * period);
    contact_step(config.contact, body, scratch, sample);
    return sample.look_ahead;
  }
};

/// A cube of 2 cm over a flat sheet, as good as at rest on it.
struct CubeOverSheet : KeptOut {
  CubeOverSheet()
      : KeptOut(make_box({0.02, 0.02, 0.02}), make_sheet(0.08, 0.08, 4, 4), 0.01 + 1e-5) {}
};

TEST(ContactStep, MakesATermAClusterForTheStateItWasGiven) {
  const SessionConfig config = plane_session();
  ContactScratch scratch;
  reserve_contact_scratch(config.contact, scratch);
  ContactSample sample;
  contact_step(config.contact, at_height(kCubeHalf + 1.0), scratch, sample);
  EXPECT_EQ(sample.contacts, 0);
  EXPECT_EQ(sample.model.sequence, 1u);
  EXPECT_TRUE(sample.model.planes.empty());
  contact_step(config.contact, at_height(kCubeHalf - 1e-4), scratch, sample);
  EXPECT_EQ(sample.contacts, 4);
  EXPECT_EQ(sample.model.sequence, 2u);
  EXPECT_EQ(sample.model.time, 1.25);
  EXPECT_EQ(sample.time, 1.25);
  EXPECT_EQ(sample.clusters, static_cast<std::int32_t>(sample.model.planes.size()));
  ASSERT_FALSE(sample.model.planes.empty());
  double stiffness = 0.0;
  for (const PlaneTerm& term : sample.model.planes) {
    stiffness += term.stiffness;
    EXPECT_NEAR((term.normal + Vec3::UnitZ()).norm(), 0.0, 1e-12);
    EXPECT_NEAR(term.arm_body.z(), -kCubeHalf, 1e-12);
    EXPECT_EQ(term.tolerance, config.contact.tolerance);
  }
  EXPECT_NEAR(stiffness, 2000.0, 1e-9);  // of the contact as a whole
  EXPECT_NEAR(sample.depth_max, 1e-4, 1e-15);
  EXPECT_EQ(sample.model_digest, model_digest(sample.model));
}

TEST(ContactStep, ClustersKeepTheirIdsOverFrames) {
  const SessionConfig config = plane_session();
  ContactScratch scratch;
  reserve_contact_scratch(config.contact, scratch);
  ContactSample first, second;
  contact_step(config.contact, at_height(kCubeHalf - 1e-4), scratch, first);
  contact_step(config.contact, at_height(kCubeHalf - 1.1e-4), scratch, second);
  ASSERT_EQ(first.model.planes.size(), second.model.planes.size());
  for (std::size_t i = 0; i < first.model.planes.size(); ++i) {
    EXPECT_EQ(first.model.planes[i].id, second.model.planes[i].id);
  }
}

TEST(ContactStep, TellsOfTheRowsOfItsModelAndOfWhatHadNoRoom) {
  CubeOverSheet cube;
  const SessionConfig& config = cube.config;
  ContactSample& sample = cube.sample;
  contact_step(config.contact, at_height(0.02), cube.scratch, sample);
  EXPECT_EQ(sample.rows, 0);
  EXPECT_GT(sample.travel, 1e-3);  // free as far as the traversal has proven
  contact_step(config.contact, at_height(0.01 + 1e-5), cube.scratch, sample);
  EXPECT_EQ(sample.rows, 4);
  EXPECT_EQ(sample.model.constraints.rows.size(), 4u);
  EXPECT_EQ(sample.travel_halvings, 0);
  EXPECT_EQ(sample.left_out, 0);
  EXPECT_EQ(sample.travel, sample.model.constraints.travel);
  // Nothing is known yet of how soon models follow each other.
  EXPECT_EQ(sample.look_ahead, config.contact.constraints->least_look_ahead);
  EXPECT_GT(sample.travel, 0.5 * sample.look_ahead);

  SessionConfig narrow = config;
  narrow.contact.capacity = 1;
  ContactScratch little;
  reserve_contact_scratch(narrow.contact, little);
  // Too little room for the rows of a travel: less of it, until all there are fit.
  contact_step(narrow.contact, at_height(0.01 + 1e-5), little, sample);
  EXPECT_EQ(sample.left_out, 0);
  EXPECT_GT(sample.travel_halvings, 0);
  EXPECT_GT(sample.travel, 0.0);
  EXPECT_LT(sample.travel, 1e-5);
  // What is as good as touched has no room in any.
  contact_step(narrow.contact, at_height(0.01 + 1e-9), little, sample);
  EXPECT_GT(sample.left_out, 0);
  EXPECT_EQ(sample.travel, 0.0);
  // Then less is looked at.
  const double looked = sample.look_ahead;
  contact_step(narrow.contact, at_height(0.01 + 1e-9), little, sample);
  EXPECT_LT(sample.look_ahead, looked);
}

// At rest: a hand that starts has gone less far by the next model, the sooner it comes.
TEST(ContactStep, LooksHalfAsFarWhereModelsComeSoon) {
  CubeOverSheet cube;
  const auto looks_after = [&](double period) {
    const double ahead = cube.look(period);
    EXPECT_EQ(cube.sample.rows, 4);
    return ahead;
  };
  const double least = cube.config.contact.constraints->least_look_ahead;
  EXPECT_EQ(looks_after(1e-3), least);
  for (int i = 0; i < 20; ++i) looks_after(1e-3);
  EXPECT_EQ(looks_after(1e-3), 0.5 * least);
  EXPECT_EQ(looks_after(3e-3), least);
  EXPECT_EQ(looks_after(1e-3), least) << "one that is late is not alone";
  // Models that come now after one millisecond, now after two.
  for (int i = 0; i < 50; ++i) EXPECT_EQ(looks_after(i % 2 == 0 ? 1e-3 : 2e-3), least) << i;
  for (int i = 0; i < 50; ++i) looks_after(0.5e-3);
  EXPECT_EQ(looks_after(0.5e-3), 0.5 * least);
}

// A step farther than needed finds half as many pairs again, and with a hand that gets faster a
// query does not look at all there is at once.
TEST(ContactStep, LooksNoFartherThanWantedByMoreThanAStep) {
  constexpr double kStep = 1.19;
  struct Case {
    double period, margin, growth;  // [s]; of what is wanted; a model
  };
  for (const Case& c : {Case{1e-3, 1.0, 4.0}, Case{3e-3, 2.0, 8.0}}) {
    CubeOverSheet cube;
    const auto looks = [&](double wanted) { return cube.look(c.period, wanted); };
    for (int i = 0; i < 30; ++i) looks(0.0);
    const double least = cube.sample.look_ahead;
    for (const double wanted : {1.1 * least, 1.5 * least, 1.9 * least}) {
      const double looked = looks(wanted);
      EXPECT_GE(looked, c.margin * wanted * (1.0 - 1e-12)) << c.period;
      EXPECT_LE(looked, kStep * c.margin * wanted) << c.period;
    }
    const double before = looks(0.0), far = 15.0 * least;
    const double grown = looks(far);
    EXPECT_LT(grown, c.margin * far) << c.period;
    EXPECT_LE(grown, c.growth * before) << c.period;
    EXPECT_GT(grown, c.growth * before / kStep) << c.period;
    for (int i = 0; i < 3; ++i) looks(far);
    EXPECT_GE(cube.sample.look_ahead, c.margin * far) << c.period;
    EXPECT_LE(cube.sample.look_ahead, kStep * c.margin * far) << c.period;
  }
}

/// A disc over one it conforms to, with 0.1 mm between them.
struct Conforming : KeptOut {
  Conforming()
      : KeptOut(models::make_conforming_upper(12'000, 1), models::make_conforming_lower(12'000, 1),
                -5e-5) {
    config.contact.resolution.carry = 0.1;
    // Room for all: what has none is looked at in every frame.
    reserve_front(scratch.fronts[0], above, below, 300'000);
    reserve_carried(scratch.fronts[0]);
  }

  /// Frames in which much was looked at, a millisecond each.
  int tries_in(int frames, double wanted = 0.0) {
    constexpr int kMany = 1000;
    int count = 0;
    for (int k = 0; k < frames; ++k) {
      look(1e-3, wanted);
      count += sample.tests > kMany;
    }
    return count;
  }
};

// Surfaces that conform have thousands of pairs a little farther than they look. Each try looks at
// all that is between: at rest there is none, and where more is wanted they are far apart.
TEST(ContactStep, LooksFartherInACrowdOnlyWhereMoreIsWanted) {
  Conforming discs;
  discs.tries_in(20);
  ASSERT_LT(discs.sample.look_ahead, discs.config.contact.constraints->least_look_ahead);
  const double looked = discs.sample.look_ahead;
  EXPECT_EQ(discs.tries_in(200), 0);
  EXPECT_EQ(discs.sample.look_ahead, looked);
  const int tries = discs.tries_in(200, 2e-3);
  EXPECT_GE(tries, 1);
  EXPECT_LE(tries, 6);
}

// A disc that is taken away at 0.1 mm a model: what lay close by is soon no reason to look no
// farther than that, however rarely models come.
TEST(ContactStep, LooksAsFarAsWantedSoonAfterACrowdIsLeft) {
  for (const double period : {1e-3, 3e-3, 1e-2, 3e-2}) {
    Conforming discs;
    for (int k = 0; k < 20; ++k) discs.look(period);
    const double wanted = 1e-3;
    ASSERT_LT(discs.sample.look_ahead, 0.1 * wanted);
    for (int k = 0; k < 40; ++k) {
      discs.body.state.position.z() += 1e-4;
      discs.look(period, wanted);
    }
    EXPECT_GE(discs.sample.look_ahead, wanted) << period;
  }
}

// What is searched beyond the rows that fit takes its time and says nothing. Far around the lowest
// point of a ball over a ball of many triangles more rows are needed.
TEST(ContactStep, LooksNotMuchFartherThanRowsFit) {
  KeptOut balls(make_ball(0.01, 24), make_ball(0.02, 30), 0.0302);
  constexpr double kPeriod = 3e-3, kMore = 1.5, kWanted = 2e-3;
  int cut = 0;
  double held = 0.0;  // how far the last model held, where it was cut
  for (int k = 0; k < 60; ++k) {
    const double looked = balls.look(kPeriod, kWanted);
    ASSERT_EQ(balls.sample.left_out, 0);
    if (held > 0.0) {
      EXPECT_LE(looked, kMore * held) << k;
      EXPECT_GT(looked, held) << k;
    }
    const bool is_cut = balls.sample.travel_halvings > 0;
    cut += is_cut;
    held = is_cut ? balls.sample.travel : 0.0;
    EXPECT_LE(balls.sample.travel_halvings, 1) << k;
  }
  EXPECT_GT(cut, 0);
  // Gone from the ball, it may look as far as is wanted at once.
  balls.body.state.position.z() += 0.02;
  for (int k = 0; k < 2; ++k) balls.look(kPeriod, kWanted);
  EXPECT_GE(balls.sample.look_ahead, kWanted);
}

TEST(ContactStep, CountsWhatDoesNotFit) {
  SessionConfig config = plane_session();
  config.contact.capacity = 3;
  ContactScratch scratch;
  reserve_contact_scratch(config.contact, scratch);
  ContactSample sample;
  contact_step(config.contact, at_height(kCubeHalf - 1e-4), scratch, sample);
  EXPECT_EQ(sample.contacts, 3);
  EXPECT_EQ(sample.dropped, 1);
}

TEST(ContactStep, QueriesEveryStaticBodyWhereverTheCentreOfMassIs) {
  // Two boxes side by side under a ball whose mesh frame is off its centre of mass.
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(0.01, 4));
  const ClodHierarchy box = build_exact_hierarchy(make_box(Vec3(0.02, 0.02, 0.02)));
  ContactWorld world;
  world.object = &ball;
  world.body_from_mesh.position = {0.0, 0.0, 0.003};
  world.tolerance = 1e-4;
  Pose left, right;
  left.position = {-0.0101, 0.0, -0.01};
  right.position = {0.0101, 0.0, -0.01};
  world.scene = {{&box, left}, {&box, right}};
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  ContactSample sample;
  StampedBody at = at_height(0.0098 - 0.003);  // the ball's bottom 0.2 mm below the boxes' tops
  at.state.position.x() = 0.010;
  contact_step(world, at, scratch, sample);
  EXPECT_GT(sample.contacts, 0);
  for (const Contact& c : scratch.contacts.contacts) EXPECT_EQ(c.body, 1);
  EXPECT_NEAR(sample.depth_max, 2e-4, 1e-4);
  at.state.position.x() = -0.010;
  contact_step(world, at, scratch, sample);
  for (const Contact& c : scratch.contacts.contacts) EXPECT_EQ(c.body, 0);
  EXPECT_GT(sample.contacts, 0);
}

TEST(ContactStep, QueriesAtTheResolutionAndCountsLevels) {
  const ClodHierarchy ball = build_clod(make_ball(0.02, 16));
  const ClodHierarchy box = build_clod(make_box(Vec3(0.1, 0.1, 0.01), {16, 16, 2}));
  ContactWorld world;
  world.object = &ball;
  world.tolerance = 4e-4;
  Pose below;
  below.position.z() = -0.005;
  world.scene = {{&box, below}};
  world.resolution.is_exact = false;
  world.resolution.metric.haptic = 0.5;  // coarse
  world.resolution.deviation_cap = kNoCap;
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  ContactSample coarse, exact;
  contact_step(world, at_height(0.0202), scratch, coarse);
  EXPECT_EQ(coarse.level_changes, 0);  // nothing came before
  std::int64_t counted = 0, above = 0;
  for (std::size_t i = 0; i < coarse.object_levels.size(); ++i) {
    counted += coarse.object_levels[i];
    if (i > 0) above += coarse.object_levels[i] + coarse.scene_levels[i];
  }
  EXPECT_EQ(counted, coarse.contacts);
  EXPECT_GT(above, 0);
  EXPECT_GT(coarse.bound_max, 0.0);
  std::int64_t decided = 0;
  for (const std::int32_t n : coarse.decided_by) decided += n;
  EXPECT_EQ(decided, coarse.contacts);
  EXPECT_GT(coarse.decided_by[static_cast<std::size_t>(LevelDecision::haptic)], 0);
  EXPECT_GT(coarse.triangles_below, static_cast<double>(coarse.contacts));
  EXPECT_LE(coarse.triangles_below, 0.5 * static_cast<double>(coarse.contacts) *
                                        (ball.triangle_count + box.triangle_count));
  world.resolution.is_exact = true;
  contact_step(world, at_height(0.0202), scratch, exact);
  EXPECT_EQ(exact.object_levels[0], exact.contacts);
  EXPECT_EQ(exact.bound_max, 0.0);
}

}  // namespace
}  // namespace thigma
