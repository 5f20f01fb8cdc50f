#include "experiments/common/replay.h"

#include "experiments/common/contact_profile.h"
#include "experiments/common/hands.h"
#include <gtest/gtest.h>

namespace thigma::experiments {
namespace {

/// Small jaws and a short press, made once.
struct Jaws {
  Assets assets;
  Pair pair;
  PenaltyParams gains;
  Path path;
};

const Jaws& jaws() {
  static const Jaws* made = [] {
    Jaws* j = new Jaws;
    j->pair = scene_pair(j->assets, "jaws", 2000);
    j->gains = direct_gains(j->pair);
    HandScript hand = jaws_hand(j->pair.radius);
    hand.seconds = 0.4;
    j->path = record_path(j->pair, as_in_text(0.025), j->gains, hand);
    return j;
  }();
  return *made;
}

TEST(DirectGains, ReachTheMaximumForceWhereSurfacesMeet) {
  const PenaltyParams gains = direct_gains(jaws().pair, 0.02, 3.0);
  EXPECT_NEAR(gains.tolerance, 0.02 * jaws().pair.radius, 1e-12);
  EXPECT_NEAR(gains.stiffness * gains.tolerance, 3.0, 1e-12);
}

TEST(RecordedPath, StartsApartComesIntoContactAndStaysInReach) {
  const Profile exact = replay(jaws().pair, jaws().path, as_in_text(0.0), jaws().gains);
  ASSERT_EQ(exact.force.size(), 400u);
  EXPECT_EQ(exact.force_size.front(), 0.0);
  const Span span = in_contact(exact);
  EXPECT_GT(span.end - span.begin, 150u);
  for (const double f : exact.force_size) EXPECT_LT(f, 10.0);  // the hand presses with a newton
}

TEST(RecordedPath, IsTheSameEachTime) {
  HandScript hand = jaws_hand(jaws().pair.radius);
  hand.seconds = 0.4;
  const Path again = record_path(jaws().pair, as_in_text(0.025), jaws().gains, hand);
  ASSERT_EQ(again.poses.size(), jaws().path.poses.size());
  EXPECT_EQ(again.poses.back().position, jaws().path.poses.back().position);
  EXPECT_EQ(again.poses.back().orientation.coeffs(), jaws().path.poses.back().orientation.coeffs());
}

TEST(Replay, PushesTheObjectOutOfTheScene) {
  const Profile exact = replay(jaws().pair, jaws().path, as_in_text(0.0), jaws().gains);
  Vec3 sum = Vec3::Zero();
  for (const Vec3& f : exact.force) sum += f;
  EXPECT_LT(sum.dot(jaws().pair.approach), 0.0);
}

TEST(Replay, OfOneResolutionIsLikeItself) {
  const Profile exact = replay(jaws().pair, jaws().path, as_in_text(0.0), jaws().gains);
  const Likeness same = compare(exact, exact, jaws().path.step);
  EXPECT_NEAR(same.correlation, 1.0, 1e-12);
  EXPECT_EQ(same.force_error, 0.0);
  EXPECT_NEAR(same.shape_error, 0.0, 1e-6);
}

TEST(Replay, ErrorOfAScaledAndShiftedForceIsNoneAfterTheFit) {
  Profile exact = replay(jaws().pair, jaws().path, as_in_text(0.0), jaws().gains);
  Profile other = exact;
  for (std::size_t i = 0; i < other.force.size(); ++i) {
    other.force[i] = 2.0 * exact.force[i] + Vec3(0.1, 0.0, -0.2);
    other.force_size[i] = other.force[i].norm();
  }
  const Likeness like = compare(other, exact, jaws().path.step);
  EXPECT_GT(like.force_error, 0.5);
  EXPECT_NEAR(like.shape_error, 0.0, 1e-9);
}

TEST(InContact, IsFromTheFirstForceToTheLast) {
  Profile p;
  p.force_size = {0.0, 0.0, 1.0, 0.0, 2.0, 0.0};
  const Span span = in_contact(p);
  EXPECT_EQ(span.begin, 2u);
  EXPECT_EQ(span.end, 5u);
  EXPECT_EQ(cut(p.force_size, span), (std::vector<double>{1.0, 0.0, 2.0}));
  p.force_size = {0.0, 0.0};
  EXPECT_EQ(in_contact(p).begin, in_contact(p).end);
}

}  // namespace
}  // namespace thigma::experiments
