// The contact thread's frame, Sec. 5.1.2: query, cluster, linearise.

#include "thigma/runtime/contact_step.h"

#include <algorithm>
#include <limits>

#include "thigma/response/linearize_contacts.h"

namespace thigma {
namespace {

Pose world_from_mesh(const ContactWorld& world, const BodyState& body) noexcept {
  return Pose{body.position, body.orientation} * world.body_from_mesh;
}

}  // namespace

void reserve_contact_scratch(const ContactWorld& world, ContactScratch& scratch) {
  scratch.fronts.resize(world.scene.size());
  for (std::size_t i = 0; i < world.scene.size(); ++i) {
    reserve_front(scratch.fronts[i], *world.object, *world.scene[i].hierarchy);
  }
  scratch.contacts.contacts.reserve(world.capacity);
  reserve_clusters(scratch.clustering, world.capacity);
}

void find_contacts(const ContactWorld& world, const StampedBody& at,
                   ContactScratch& scratch) noexcept {
  clear(scratch.contacts);
  const Pose pose = world_from_mesh(world, at.state);
  if (!world.scene.empty()) {
    ContactQuery query;
    query.tolerance = world.tolerance;
    query.keep_directions = true;
    query_scene(*world.object, pose, world.scene, query, scratch.fronts, scratch.contacts);
  }
  if (world.source) world.source(pose, world.tolerance, scratch.contacts);
}

void make_model(const ContactWorld& world, const StampedBody& at, ContactScratch& scratch,
                ContactSample& sample) noexcept {
  ClusterParams clustering;
  clustering.max_clusters = world.max_clusters;
  clustering.tolerance = world.tolerance;
  cluster_contacts(scratch.contacts.contacts, scratch.clusters, clustering, scratch.clustering,
                   scratch.clusters);

  PenaltyParams response = world.response;
  response.tolerance =
      world.tolerance;  // one d: what the query starts at is what the force starts at
  sample.model =
      linearize_contacts(scratch.clusters, response, at.state, at.time, ++scratch.sequence);

  sample.time = at.time;
  sample.contacts = static_cast<std::int64_t>(scratch.contacts.contacts.size());
  sample.dropped = scratch.contacts.dropped;
  sample.front = scratch.contacts.stats.front;
  sample.tests = scratch.contacts.stats.tests;
  sample.clusters = static_cast<std::int32_t>(scratch.clusters.clusters.size());
  sample.depth_max = -std::numeric_limits<double>::infinity();
  for (const Contact& contact : scratch.contacts.contacts) {
    sample.depth_max = std::max(sample.depth_max, contact.depth);
  }
  sample.model_digest = model_digest(sample.model);
}

void contact_step(const ContactWorld& world, const StampedBody& at, ContactScratch& scratch,
                  ContactSample& sample) noexcept {
  find_contacts(world, at, scratch);
  make_model(world, at, scratch, sample);
}

}  // namespace thigma
