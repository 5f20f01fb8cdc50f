#include "viewer/server/feed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/math/rotation.h"

namespace thigma::live {
namespace {

constexpr std::size_t kMostEvents = 1000;  // that wait; a page that late is told of the newest only

Pose pose_of(const BodyState& body) { return {body.position, body.orientation}; }

/// To world axes; sizes stay those of the device.
Wrench in_world(const Workspace& workspace, const Wrench& device) {
  const Quat& q = workspace.world_from_device.orientation;
  return {q._transformVector(device.force), q._transformVector(device.torque)};
}

std::uint16_t state_bits(const HapticSample& s) {
  return static_cast<std::uint16_t>(
      (s.is_grasped ? kGrasped : 0) | (s.is_armed ? kArmed : 0) |
      (s.fault != Fault::none ? kFaulty : 0) | (s.device.weight < 1.0 ? kFading : 0) |
      (s.is_held_back ? kHeldBack : 0) | (s.is_squeezed ? kSqueezed : 0));
}

/// What is felt: the force sent, and the torque whether the device can give it or not.
Wrench on_hand(const Workspace& workspace, const HapticSample& s) {
  return in_world(workspace, {s.command.force, s.feedback.torque});
}

}  // namespace

void LiveFeed::begin_session(const Workspace& workspace) noexcept {
  workspace_ = workspace;
  was_grasped_ = false;
  next_frame_ = 0;
}

void LiveFeed::observe(const HapticSample& s) {
  // The grasp is taken at the body's state before the step: that of the frame before. Where that
  // frame is not known, as after a seek, a step's way is what the ghost is off by.
  if (s.is_grasped && !was_grasped_) {
    const Pose before = next_frame_ > 0 && s.frame == next_frame_ ? last_body_ : pose_of(s.body);
    body_from_grasp_ = inverse(before) * s.handle.pose;
  }
  was_grasped_ = s.is_grasped;
  last_body_ = pose_of(s.body);
  next_frame_ = s.frame + 1;

  const ChannelSource source{s, on_hand(workspace_, s), static_cast<double>(state_bits(s))};
  ChannelRow row;
  row.time = s.time;
  for (std::size_t i = 0; i < row.values.size(); ++i)
    row.values[i] = static_cast<float>(kChannelList[i + 1].value(source));
  rows_.push(row);

  HapticNow& now = haptic_.draft();
  now.sample = s;
  now.ghost = s.is_grasped ? s.handle.pose * inverse(body_from_grasp_) : pose_of(s.body);
  haptic_.publish();
}

void LiveFeed::observe(const ContactSample& sample) {
  query_times_.push(sample.query_cpu);
  contact_.publish(sample);
  contact_updates_.fetch_add(1, std::memory_order_relaxed);
}

void LiveFeed::observe_world_step(double cpu) {
  query_times_.push(cpu);
  contact_updates_.fetch_add(1, std::memory_order_relaxed);
}

void LiveFeed::observe(const SessionEvent& event) {
  const std::lock_guard lock(events_mutex_);
  if (events_.size() >= kMostEvents) events_.erase(events_.begin());
  events_.push_back(event);
}

void LiveFeed::take_rows(std::vector<ChannelRow>& rows) {
  for (std::size_t left = rows_.capacity(); left > 0; --left) {
    const ChannelRow* row = rows_.front();
    if (row == nullptr) return;
    rows.push_back(*row);
    rows_.pop();
  }
}

void LiveFeed::take_query_times(std::vector<double>& times) {
  for (std::size_t left = query_times_.capacity(); left > 0; --left) {
    const double* time = query_times_.front();
    if (time == nullptr) return;
    times.push_back(*time);
    query_times_.pop();
  }
}

void LiveFeed::take_events(std::vector<SessionEvent>& events) {
  const std::lock_guard lock(events_mutex_);
  events.insert(events.end(), events_.begin(), events_.end());
  events_.clear();
}

void LiveFeed::forget() {
  haptic_.fetch();
  contact_.fetch();
  has_haptic_ = has_contact_ = false;
}

const HapticNow* LiveFeed::haptic() {
  if (haptic_.fetch()) has_haptic_ = true;
  return has_haptic_ ? &haptic_.value() : nullptr;
}

const ContactSample* LiveFeed::contact() {
  if (contact_.fetch()) has_contact_ = true;
  return has_contact_ ? &contact_.value() : nullptr;
}

Snapshot make_snapshot(const HapticNow& now, const ContactSample* contact, const RigidBody& body,
                       const Workspace& workspace, const Pose& body_from_mesh,
                       const Vec3& grasp_point, std::vector<ViewedCluster>& clusters) {
  const HapticSample& h = now.sample;
  const Pose world_from_body = pose_of(h.body);
  Snapshot s;
  s.time = h.time;
  s.frame = h.frame;
  s.bits = state_bits(h);
  s.fault = h.fault;
  s.object = world_from_body * body_from_mesh;
  s.ghost = now.ghost * body_from_mesh;
  s.handle = h.handle.pose;
  s.grasp_point = transform_point(world_from_body, grasp_point);
  s.center = h.body.position;
  s.on_hand = on_hand(workspace, h);
  s.contact = h.contact;
  s.penetration = h.penetration;
  s.stretch = h.is_grasped ? h.stretch : 0.0;
  s.energy = h.energy;
  s.model_age = h.model_age;
  s.model_weight = h.model_weight;
  s.query_cpu = contact != nullptr ? contact->query_cpu : std::numeric_limits<double>::quiet_NaN();
  clusters.clear();
  if (contact != nullptr) {
    const BodyAtState at = at_state(body, h.body);
    for (const PlaneTerm& term : contact->model.planes) {
      const PlaneForce force = plane_force(term, at);
      clusters.push_back({transform_point(world_from_body, term.arm_body), term.normal, force.depth,
                          h.model_weight * force.wrench.force, term.id});
    }
  }
  s.clusters = clusters;
  return s;
}

void view_rows(const HapticSample& haptic, const ContactSample* contact,
               std::vector<ViewedRow>& rows) {
  rows.clear();
  if (contact == nullptr) return;
  const Mat3 rotation = rotation_matrix(haptic.body.orientation);
  for (const ContactRow& row : contact->model.constraints.rows) {
    const RowAtState at = row_at(row, haptic.body.position, rotation);
    if (!std::isfinite(at.gap)) continue;
    ViewedRow viewed;
    // The arm ends on the object's feature but for its planes, where it ends on the scene's point.
    viewed.point = haptic.body.position + at.arm;
    if (row.kind == RowKind::object_plane) viewed.point -= at.gap * at.normal;
    viewed.normal = at.normal;
    viewed.gap = at.gap;
    viewed.friction = row.friction.kinetic;
    viewed.kind = row.kind;
    for (const PressingRow& pressing : haptic.pressing) {
      if (pressing.id != row.id) continue;
      viewed.presses = true;
      viewed.force = pressing.force;
    }
    rows.push_back(viewed);
  }
  const auto before = [](const ViewedRow& a, const ViewedRow& b) {
    return a.presses != b.presses ? a.presses : a.gap < b.gap;
  };
  std::stable_sort(rows.begin(), rows.end(), before);
  if (rows.size() > kViewedRows) rows.resize(kViewedRows);
}

}  // namespace thigma::live
