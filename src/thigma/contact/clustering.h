#pragma once
// Contact clustering: many contacts become at most K representative ones, so that stiffness is
// bounded.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/contact/contact.h"
#include "thigma/core/static_vector.h"

namespace thigma {

inline constexpr int kMaxContactClusters = 16;

struct ClusterParams {
  int max_clusters = 5;  // K, 1..kMaxContactClusters; values outside are clamped
  // d of the query: a contact weighs max(depth + d, 0), times its own weight [m]
  double tolerance = 0.0;
};

/// One cluster S and its representative contact.
struct ContactCluster {
  Vec3 point = Vec3::Zero();  // p: weighted centroid of the members' points [m; world]
  // p_0 = p - depth * normal: a point of the plane, not of a surface [m; world]
  Vec3 scene_point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();  // unit, out of the grasped object [world]
  double depth = 0.0;           // weighted mean of the members' [m]
  double weight = 0.0;          // sum of the members' weights, 0 when all are at -d [m]
  double blend = 1.0;           // sum of Contact::weight of the members
  // persistent: inherited from the previous cluster that seeded this one
  std::int32_t id = -1;
  std::int32_t member_count = 0;
  std::int32_t first_member = -1;    // lowest contact index of its members
  std::int32_t deepest_member = -1;  // contact index; ties: the lowest
  // static object of the deepest member; members may touch several
  std::int32_t body = 0;
};

/// Clusters of one frame, by decreasing depth. Also the warm start of the next frame.
struct ContactClusters {
  StaticVector<ContactCluster, kMaxContactClusters> clusters;
  std::int32_t next_id = 0;  // for the next new cluster
  int iterations = 0;        // assignments that changed
  double cost = 0.0;         // Eq. 5.32 [m^2]; 0 when all weights are
};

/// Working memory of cluster_contacts; after a call also where each contact went.
/// Any content is valid input. Grows to the largest set seen; reserve_clusters does so ahead of
/// time.
struct ClusterScratch {
  std::vector<double> x, y, z, weight;  // of the contacts
  std::vector<double> nearest;          // squared distances [m^2]
  // cluster of each contact, index into ContactClusters::clusters
  std::vector<std::int32_t> assignment;
  std::vector<std::int32_t> candidate;  // the assignment being built
  std::vector<std::uint8_t> taken;      // contacts used as seeds
  // contact of each initial representative, Alg. 5.4.2 order
  StaticVector<std::int32_t, kMaxContactClusters> seeds;
  StaticVector<std::int32_t, kMaxContactClusters> seed_ids;  // id it inherits, -1 for a new cluster
};

/// Room for sets of up to `contacts` contacts.
/// Thread    [offline]; throws std::bad_alloc.
void reserve_clusters(ClusterScratch& scratch, std::size_t contacts);

/// Weighted K-means over contacts of any bodies, warm-started from the previous clusters.
///
/// contacts  of all bodies together
/// previous  of the last frame, in any order; may be empty. Only points, depths, ids and next_id
///           are read
/// scratch   working memory; assignment, seeds and seed_ids are results
/// result    overwritten; may be the same object as previous
/// Thread    [contact]; no failure; allocates only when the set outgrows the scratch.
/// Source    Algs. 5.4.1-5.4.4, Eqs. 5.32-5.36. Deviates: rules for ties, zero weights, emptied
///           clusters and opposing normals, and a stop on a repeated assignment
///           (docs/deviations.md, contact clustering).
void cluster_contacts(std::span<const Contact> contacts, const ContactClusters& previous,
                      const ClusterParams& params, ClusterScratch& scratch,
                      ContactClusters& result) noexcept;

}  // namespace thigma
