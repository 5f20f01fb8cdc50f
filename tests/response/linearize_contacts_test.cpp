#include "thigma/response/linearize_contacts.h"

#include <vector>

#include "support/jacobian.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

ContactCluster cluster_at(Random& random, const BodyState& state, double depth) {
  ContactCluster c;
  c.point = state.position + random.in_cube(0.03);
  c.normal = random.direction();
  c.depth = depth;
  c.weight = 1.0;  // of contacts with weight 1
  c.scene_point = c.point - depth * c.normal;
  c.id = static_cast<std::int32_t>(random.below(1000));
  return c;
}

BodyState resting_state(Random& random) {
  BodyState state;
  state.position = random.in_cube(0.1);
  state.orientation = random.orientation();
  return state;
}

TEST(LinearizeContacts, terms_reproduce_the_clusters_where_they_were_found) {
  Random random(1);
  const RigidBody body = test::random_body(random);
  for (int i = 0; i < 50; ++i) {
    const BodyState state = resting_state(random);
    ContactClusters clusters;
    for (int k = 0; k < 5; ++k)
      clusters.clusters.push_back(cluster_at(random, state, random.uniform(-1e-3, 2e-3)));
    const LinearContactModel model = linearize_contacts(
        clusters, {.stiffness = 1000.0, .damping = 3.0, .tolerance = 1e-3}, {state, 0.25, 7});
    EXPECT_EQ(model.time, 0.25);
    EXPECT_EQ(model.sequence, 7u);
    EXPECT_EQ(to_vector(model.state), to_vector(state));
    ASSERT_EQ(model.planes.size(), 5u);
    for (int k = 0; k < 5; ++k) {
      const PlaneForce f = plane_force(model.planes[k], at_state(body, state));
      EXPECT_NEAR(f.depth, clusters.clusters[k].depth, 1e-15);
      EXPECT_EQ(model.planes[k].id, clusters.clusters[k].id);
      EXPECT_EQ(model.planes[k].normal, clusters.clusters[k].normal);
      const Vec3 arm = clusters.clusters[k].point - state.position;
      EXPECT_LE((f.wrench.torque - arm.cross(f.wrench.force)).norm(), 1e-13);
    }
  }
}

Contact blended_contact(double x, double depth, double weight) {
  Contact c;
  c.point = {x, 0.0, 0.0};
  c.normal = Vec3::UnitZ();
  c.depth = depth;
  c.scene_point = {x, 0.0, -depth};
  c.weight = weight;
  return c;
}

// A contact that fades in where nothing else is must not take its share of the stiffness at once.
TEST(LinearizeContacts, ABlendedContactEntersWithItsWeight) {
  const PenaltyParams params{.stiffness = 2000.0, .damping = 0.0, .tolerance = 1e-3};
  const RigidBody body = make_body(0.1, 1e-4 * Mat3::Identity());
  double before = 0.0;
  ClusterScratch scratch;
  for (const double weight : {0.0, 0.01, 0.1, 0.5, 0.9, 0.99, 1.0}) {
    const std::vector<Contact> contacts = {blended_contact(0.0, 0.0, 1.0),
                                           blended_contact(0.05, 5e-4, weight)};
    ContactClusters clusters;
    cluster_contacts(contacts, {}, {.max_clusters = 5, .tolerance = 1e-3}, scratch, clusters);
    ASSERT_EQ(clusters.clusters.size(), 2u);
    const LinearContactModel model = linearize_contacts(clusters, params, {BodyState{}, 0.0, 1});
    const double force = contact_wrench(model, body, BodyState{}).force.norm();
    // k (sum p r^2) / (sum p r) with reaches of 1 and 1.5 mm.
    const double expected = 2000.0 * 1e-3 * (1.0 + 2.25 * weight) / (1.0 + 1.5 * weight);
    EXPECT_NEAR(force, expected, 1e-9);
    EXPECT_GE(force, before);
    before = force;
  }
}

double force_of(const ContactClusters& clusters, double tolerance) {
  const RigidBody body = make_body(0.1, 1e-4 * Mat3::Identity());
  const PenaltyParams params{.stiffness = 2000.0, .damping = 0.0, .tolerance = tolerance};
  return contact_wrench(linearize_contacts(clusters, params, {BodyState{}, 0.0, 1}), body,
                        BodyState{})
      .force.norm();
}

double force_of(const std::vector<Contact>& contacts) {
  ContactClusters clusters;
  ClusterScratch scratch;
  cluster_contacts(contacts, {}, {.max_clusters = 5, .tolerance = 1e-3}, scratch, clusters);
  return force_of(clusters, 1e-3);
}

// Where nothing else presses it has nobody to share the stiffness with.
TEST(LinearizeContacts, ABlendedContactThatIsAlonePressesByItsWeight) {
  constexpr double kAlone = 2000.0 * 1.5e-3;
  for (const double weight : {0.0, 0.01, 0.5, 1.0}) {
    const Contact contact = blended_contact(0.05, 5e-4, weight);
    EXPECT_NEAR(force_of({contact}), weight * kAlone, 1e-9);
    // beside one that does not press
    EXPECT_NEAR(force_of({contact, blended_contact(0.0, -1e-3, 1.0)}), weight * kAlone, 1e-9);
    // beside one that begins to
    EXPECT_NEAR(force_of({contact, blended_contact(0.0, -1e-3 + 1e-9, 1.0)}), weight * kAlone,
                weight > 0.0 ? 1e-3 : 1e-5);
  }
}

// A query reports what its bound does not rule out. Before the next model the object may come so
// far that it presses.
TEST(LinearizeContacts, ABlendedContactThatDoesNotPressYetWillByItsWeight) {
  ClusterScratch scratch;
  ContactClusters clusters;
  cluster_contacts(std::vector<Contact>{blended_contact(0.05, -1.001e-3, 0.07)}, {},
                   {.max_clusters = 5, .tolerance = 1e-3}, scratch, clusters);
  const LinearContactModel model = linearize_contacts(
      clusters, {.stiffness = 2000.0, .damping = 0.0, .tolerance = 1e-3}, {BodyState{}, 0.0, 1});
  ASSERT_EQ(model.planes.size(), 1u);
  EXPECT_NEAR(model.planes[0].stiffness, 0.07 * 2000.0, 1e-9);
}

// A contact and what it is blended with, in two places, are one.
TEST(LinearizeContacts, HalvesOfABlendAreOneContact) {
  for (const double weight : {0.25, 0.5, 0.75})
    EXPECT_NEAR(
        force_of({blended_contact(0.0, 0.0, weight), blended_contact(0.05, 0.0, 1.0 - weight)}),
        2000.0 * 1e-3, 1e-9);
}

// n pairs of a flat contact: however many there are, and however many clusters they make, the floor
// is as stiff.
TEST(LinearizeContacts, force_of_a_flat_contact_does_not_grow_with_pairs_or_clusters) {
  const double depth = 4e-4;
  const PenaltyParams params{.stiffness = 2000.0, .damping = 0.0, .tolerance = 1e-3};
  const RigidBody body = make_body(0.1, 1e-4 * Mat3::Identity());
  for (const int pairs : {1, 4, 40, 400}) {
    for (const int limit : {1, 3, 5, 16}) {
      Random random(2);
      std::vector<Contact> contacts(pairs);
      for (Contact& c : contacts) {
        c.point = Vec3(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), -depth);
        c.scene_point = c.point + Vec3(0.0, 0.0, depth);
        c.normal = Vec3(0.0, 0.0, -1.0);
        c.depth = depth;
      }
      ContactClusters clusters;
      ClusterScratch scratch;
      cluster_contacts(contacts, {}, {.max_clusters = limit, .tolerance = params.tolerance},
                       scratch, clusters);
      const LinearContactModel model = linearize_contacts(clusters, params, {{}, 0.0, 1});
      const Wrench w = contact_wrench(model, body, {});
      EXPECT_NEAR(w.force.z(), params.stiffness * (depth + params.tolerance), 1e-9)
          << pairs << ' ' << limit;
    }
  }
}

TEST(LinearizeContacts, new_cluster_enters_without_a_jump) {
  Random random(3);
  const RigidBody body = test::random_body(random);
  const BodyState state = resting_state(random);
  const PenaltyParams params{.stiffness = 2000.0, .damping = 0.0, .tolerance = 1e-3};
  ContactClusters one;
  one.clusters.push_back(cluster_at(random, state, 5e-4));
  ContactClusters two = one;
  two.clusters.push_back(cluster_at(random, state, -1e-3 + 1e-9));
  const Wrench before =
      contact_wrench(linearize_contacts(one, params, {state, 0.0, 1}), body, state);
  const Wrench after =
      contact_wrench(linearize_contacts(two, params, {state, 0.0, 2}), body, state);
  EXPECT_LE((before.force - after.force).norm(), 1e-5);
}

TEST(LinearizeContacts, full_stiffness_for_each_cluster_on_request) {
  Random random(4);
  const BodyState state = resting_state(random);
  ContactClusters clusters;
  for (int k = 0; k < 3; ++k) clusters.clusters.push_back(cluster_at(random, state, 1e-3));
  const PenaltyParams each{
      .stiffness = 500.0, .damping = 2.0, .tolerance = 0.0, .is_divided_among_clusters = false};
  for (const PlaneTerm& term : linearize_contacts(clusters, each, {state, 0.0, 1}).planes) {
    EXPECT_EQ(term.stiffness, 500.0);
    EXPECT_EQ(term.damping, 2.0);
  }
}

TEST(LinearizeContacts, no_cluster_no_term_and_no_weight_no_nan) {
  Random random(5);
  const RigidBody body = test::random_body(random);
  const BodyState state = resting_state(random);
  EXPECT_EQ(linearize_contacts({}, {}, {state, 0.0, 1}).planes.size(), 0u);
  ContactClusters touching;
  touching.clusters.push_back(cluster_at(random, state, -1e-3));
  touching.clusters.push_back(cluster_at(random, state, -1e-3));
  const LinearContactModel model =
      linearize_contacts(touching, {.tolerance = 1e-3}, {state, 0.0, 1});
  EXPECT_LE(contact_wrench(model, body, state).force.norm(), 1e-9);
  EXPECT_EQ(model.planes[0].stiffness, model.planes[1].stiffness);
}

}  // namespace
}  // namespace thigma
