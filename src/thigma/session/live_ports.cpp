#include "thigma/session/live_ports.h"

#include <algorithm>
#include <span>
#include <utility>

#include "thigma/contact/contact_node.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

ViewedContact viewed(const ContactWorld& world, const Contact& c) noexcept {
  ViewedContact v;
  v.point = c.point;
  v.normal = c.normal;
  v.depth = c.depth;
  v.bound = c.bound;
  v.body = c.body;
  const auto body = static_cast<std::size_t>(c.body);
  const ClodHierarchy* other =
      c.body >= 0 && body < world.scene.size() ? world.scene[body].hierarchy : nullptr;
  v.object_node = world.object != nullptr ? contact_node(*world.object, c.object_patch) : -1;
  v.scene_node = other != nullptr ? contact_node(*other, c.scene_patch) : -1;
  v.object_level = static_cast<std::uint8_t>(std::clamp(c.object_level, 0, 255));
  v.scene_level = static_cast<std::uint8_t>(std::clamp(c.scene_level, 0, 255));
  v.status = c.status;
  v.decided_by = c.decided_by;
  return v;
}

}  // namespace

void view_contacts(const ContactWorld& world, const ContactScratch& scratch, double time,
                   ContactView& view) noexcept {
  const std::span<const Contact> contacts = scratch.contacts.contacts;
  view.time = time;
  view.sequence = scratch.sequence;
  view.found = static_cast<std::int64_t>(contacts.size());
  view.dropped = scratch.contacts.dropped;
  view.front = scratch.contacts.stats.front;
  view.contacts.clear();
  std::size_t stride = 1;
  if (contacts.size() > kViewedContacts) {
    const std::span<const Contact> members =
        scratch.spread.empty() ? contacts : std::span<const Contact>(scratch.spread);
    for (const ContactCluster& cluster : scratch.clusters.clusters) {
      const auto deepest = static_cast<std::size_t>(cluster.deepest_member);
      if (cluster.deepest_member >= 0 && deepest < members.size())
        view.contacts.push_back(viewed(world, members[deepest]));
    }
    const std::size_t room = kViewedContacts - view.contacts.size();
    stride = (contacts.size() + room - 1) / room;
  }
  for (std::size_t i = 0; i < contacts.size(); i += stride)
    view.contacts.push_back(viewed(world, contacts[i]));
}

void apply_tuning(const HapticTuning& tuning, HapticParams& params, HapticState& state) THIGMA_RT {
  const Twist twist = velocity(params.body, state.body);
  params.body = tuning.body;
  const Mat3 rotation = state.body.orientation.toRotationMatrix();
  const Vec3 spin_body = rotation.transpose() * twist.angular;
  state.body.linear_momentum = params.body.mass * twist.linear;
  state.body.angular_momentum = rotation * (params.body.inertia * spin_body);
  const Pose grasp = state.coupling.body_from_grasp;
  const bool is_grasped = state.coupling.is_grasped;
  params.coupling = tuning.coupling;
  state.coupling = tuning.coupling;
  state.coupling.body_from_grasp = grasp;
  state.coupling.is_grasped = is_grasped;
  if (params.passivity.is_on) retune_passivity(params);
}

void apply_tuning(const ContactTuning& tuning, ContactWorld& world) noexcept {
  world.response = tuning.response;
  world.most_friction = tuning.most_friction;
  const bool is_exact = world.resolution.is_exact;
  world.resolution = tuning.resolution;
  world.resolution.is_exact = is_exact;
}

void exchange_contacts(ContactReplacement& other, ContactWorld& world,
                       ContactScratch& scratch) noexcept {
  ContactScratch& next = other.scratch;
  next.sequence = scratch.sequence;
  next.last_time = scratch.last_time;
  std::swap(next.clusters, scratch.clusters);
  next.looked_ahead = scratch.looked_ahead;
  next.separation = scratch.separation;
  next.crowded_ahead = scratch.crowded_ahead;
  next.worth_ahead = scratch.worth_ahead;
  other.world.response = world.response;  // as they were tuned
  other.world.most_friction = world.most_friction;
  std::swap(other.world, world);
  std::swap(next, scratch);
}

Resolution faded_in(const Resolution& asked, double share) noexcept {
  if (asked.is_exact || !(share < 1.0)) return asked;
  const double part = std::max(share, 0.0);
  Resolution now = asked;
  now.metric.haptic *= part;
  now.metric.velocity *= part;
  now.metric.view.pixels *= part;
  return now;
}

bool take_step(LivePorts& live) THIGMA_RT {
  int left = live.steps.load(std::memory_order_relaxed);
  while (left > 0) {
    if (live.steps.compare_exchange_weak(left, left - 1, std::memory_order_relaxed)) return true;
  }
  return false;
}

}  // namespace thigma
