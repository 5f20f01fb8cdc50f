// What pages are told, sixty times a second and when something changes.

#include <algorithm>
#include <cmath>
#include <optional>

#include "viewer/server/detail/live_server_state.h"

namespace thigma::live {
namespace {

constexpr std::size_t kMostRows = 250;     // of a batch
constexpr std::uint64_t kIdleTicks = 15;   // a snapshot four times a second where nothing moves
constexpr std::uint64_t kStateTicks = 60;  // `state` once a second

bool is_constrained(const ContactSample* contact) {
  return contact != nullptr && contact->model.constraints.reach > 0.0;
}

std::optional<RowsNow> rows_now(const ContactSample* contact) {
  if (!is_constrained(contact)) return std::nullopt;
  RowsNow now;
  now.rows = contact->rows;
  now.in_model = static_cast<std::int64_t>(contact->model.constraints.rows.size());
  now.halvings = contact->travel_halvings;
  now.left_out = contact->left_out;
  now.travel = contact->travel;
  now.look_ahead = contact->look_ahead;
  return now;
}

double wall_seconds() { return 1e-9 * static_cast<double>(monotonic_ns()); }

}  // namespace

void LiveServer::Impl::collect_rows() {
  rows.clear();
  query_times.clear();
  feed.take_rows(rows);
  feed.take_query_times(query_times);
  add(rows, query_times, window);
  if (rows.size() <= kMostRows) return;
  left_out += rows.size() - kMostRows;
  rows.erase(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(kMostRows));
}

Snapshot LiveServer::Impl::snapshot_now(const HapticNow& now) {
  RigidBody body;
  {
    const std::lock_guard lock(mutex);
    body = tuner.haptic().body;
  }
  Snapshot s = make_snapshot(now, feed.contact(), body, config.haptic.workspace, body_from_mesh,
                             grasp_point, clusters);
  if (state.run == RunPhase::paused) s.bits |= kPaused;
  if (state.run == RunPhase::ended) s.bits |= kEnded;
  if (const ContactSample* contact = feed.contact(); is_constrained(contact)) {
    s.bits |= kConstrained;
    view_rows(now.sample, contact, viewed_rows);
    s.rows = viewed_rows;
  }
  s.haptic_hz = timing.haptic_hz;
  s.contact_hz = timing.contact_hz;
  s.newton_length = 0.4 * scene.object.hierarchy->radius;
  ports->contacts.fetch();
  const ContactView& view = ports->contacts.value();
  s.found = view.found;
  s.dropped = view.dropped;
  s.front = view.front;
  s.contacts = {view.contacts.begin(), view.contacts.size()};
  if (const WorldNow* world = world_feed.newest()) show_world(*world, s);
  return s;
}

/// In a world the object is what the hand holds that is shown.
void LiveServer::Impl::show_world(const WorldNow& world, Snapshot& s) {
  s.bits |= kConstrained;
  viewed_rows.clear();
  for (const WorldRow& row : world.rows)
    viewed_rows.push_back(
        {row.point, row.normal, row.gap, row.force, row.friction, row.kind, row.presses()});
  s.rows = viewed_rows;
  s.found = static_cast<std::int64_t>(world.rows_near);
  if (world.haptic_ticks > 0) s.query_cpu = world.step_cpu;
  if (world.shown_body >= 0) {
    const auto body = static_cast<std::size_t>(world.shown_body);
    s.object = s.ghost = world.bodies[body];
    s.center = (s.object * inverse(scene.world.body_from_mesh[body])).position;
  } else {
    s.object = s.ghost = world.bodies[static_cast<std::size_t>(scene.object.body)];
    s.center = s.object.position;
  }
  if (world.shown_hand < 0) return;
  const ViewedHand& hand = world.hands[static_cast<std::size_t>(world.shown_hand)];
  if (hand.body >= 0) s.ghost = hand.ghost;
  s.handle = hand.handle;
  s.grasp_point = hand.body >= 0 ? hand.grasp_point : s.center;
}

/// Where the second device's handle is, to a page that keeps up and does not know it yet.
void LiveServer::Impl::show_camera(PageId page, const DeviceState& device) {
  if (!device.has_camera) return;
  const Pose& pose = device.camera;
  const auto told = told_cameras.find(page);
  if (told != told_cameras.end() && told->second.position == pose.position &&
      told->second.orientation.coeffs() == pose.orientation.coeffs())
    return;
  server.send(page, camera_message(pose), false);
  told_cameras[page] = pose;
}

void LiveServer::Impl::show() {
  const HapticNow* now = feed.haptic();
  if (now == nullptr) return;
  if (now->sample.fault != last_fault) {
    last_fault = now->sample.fault;
    if (state.run != RunPhase::ended) {
      state.reason = last_fault == Fault::none ? "" : fault_name(last_fault);
      send_state();
    }
  }
  std::erase_if(owed, [&](const auto& late) { return server.offer(late.first, late.second); });
  const std::vector<PageId> pages = server.pages();
  if (pages.empty() || (rows.empty() && ticks % kIdleTicks != 0)) return;
  std::vector<std::string> messages;
  if (!rows.empty()) messages.push_back(encode_channels(rows));
  messages.push_back(encode_snapshot(snapshot_now(*now)));
  if (const WorldNow* world = world_feed.newest()) messages.push_back(encode_bodies(*world));
  for (const PageId page : pages) {
    if (server.offer(page, messages))
      show_camera(page, now->sample.device);
    else if (is_rewound && !rows.empty())
      owed[page].push_back(messages.front());
  }
}

void LiveServer::Impl::send_events() {
  events.clear();
  feed.take_events(events);
  for (const SessionEvent& event : events) {
    if (event.kind == EventKind::began) {
      forget_troubles();
      continue;
    }
    send_to_all(event_message(event));
    if (now_running.replay.empty()) remember(event);
  }
}

/// What pages that come later have to know of an event.
void LiveServer::Impl::remember(const SessionEvent& event) {
  const Trouble trouble{event.detail, event.text, event.time};
  if (event.kind == EventKind::fault) {
    state.fault = trouble;
  } else if (event.kind == EventKind::resumed) {
    state.fault = {};
  } else if (event.kind == EventKind::late) {
    state.late = trouble;
    ++state.lates;
  } else {
    return;
  }
  send_state();
}

void LiveServer::Impl::tick() {
  ++ticks;
  collect_rows();
  show();
  send_events();
  if (ticks % kStateTicks != 0) return;
  const HapticNow* now = feed.haptic();
  const WorldNow* world = world_feed.newest();
  const bool is_apart = world != nullptr && world->haptic_ticks > 0;
  std::uint64_t frame = now != nullptr ? now->sample.frame : 0;
  if (is_apart) frame = world->haptic_ticks - world->haptic_missed;
  // What is paused or shown from a recording has no rate by the wall clock.
  const bool has_rate = now != nullptr && state.run == RunPhase::running && state.replay.empty();
  timing = close(wall_seconds(), has_rate, frame, feed.contact_updates(), window);
  if (now != nullptr) {
    // Session time counts every tick, frames only those that were made.
    const double due = std::floor(now->sample.time * rate + 0.5);
    timing.missed =
        is_apart ? world->haptic_missed
                 : static_cast<std::uint64_t>(std::max(0.0, due - static_cast<double>(frame)));
  }
  send_state();
}

void LiveServer::Impl::send_state_to(PageId page) {
  const char* holds = holder == 0 ? "none" : holder == page ? "you" : "other";
  server.send(page,
              state_message(state, timing, holds, server.dropped(page),
                            left_out + feed.dropped_rows(), dropped_samples),
              false);
}

void LiveServer::Impl::send_state() {
  const std::vector<PageId> pages = server.pages();
  const HapticNow* now = feed.haptic();
  state.time = now != nullptr ? now->sample.time : 0.0;
  state.pages = pages.size();
  state.rows = rows_now(feed.contact());
  for (const PageId page : pages) send_state_to(page);
}

void LiveServer::Impl::send_parameters() { send_to_all(parameters_message(parameters())); }

void LiveServer::Impl::send_to_all(const std::string& text) {
  for (const PageId page : server.pages()) server.send(page, text, false);
}

}  // namespace thigma::live
