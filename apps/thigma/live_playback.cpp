#include "live_playback.h"

#include <limits>

#include "thigma/session/rt_thread.h"

namespace thigma::app {
namespace {

using Kind = live::LiveRequest::Kind;

constexpr std::int64_t kFrame = 10'000'000;  // between two pictures [ns]
constexpr std::size_t kMostFrames = 240;     // of a recording, at once
constexpr std::size_t kStripParts = 300;     // of the strip of force beside its slider

/// What watches without writing anything.
SessionSinks watchers(live::LiveServer& server) {
  return {[&server](const HapticSample& sample) { server.observe(sample); },
          [&server](const ContactSample& sample) { server.observe(sample); },
          [&server](const SessionEvent& event) { server.observe(event); }};
}

/// Contacts are not part of a recording: they are found again where the object was.
void find_contacts(const LivePlayback& show, ContactScratch& scratch) {
  const HapticSample& frame = show.playback.frame();
  ContactSample sample;
  contact_step(show.config.contact, {frame.body, frame.time, frame.frame}, scratch, sample);
  view_contacts(show.config.contact, scratch, frame.time, show.server.ports().contacts.draft());
  show.server.ports().contacts.publish();
}

/// Does what a page asked for, where that is moving about in the recording; returns whether it was.
bool move_within(const LivePlayback& show, const live::LiveRequest& request,
                 const SessionSinks& sinks) {
  if (request.kind != Kind::seek && request.kind != Kind::reset) return false;
  show.server.rewind();
  show.playback.jump_to(request.kind == Kind::seek ? request.number : 0.0, sinks);
  show.server.answer(request, "");
  return true;
}

}  // namespace

SessionConfig recorded_config(const SessionConfig& scene, const RecordedConfig& recorded) {
  SessionConfig config = scene;
  config.haptic = recorded.params;
  config.rate = recorded.rate_hz;
  config.contact.resolution = recorded.resolution;
  config.contact.friction = recorded.friction;
  // there are no levels then
  config.contact.resolution.is_exact |= scene.contact.resolution.is_exact;
  return config;
}

void show_playback(LivePlayback show) {
  Playback& playback = show.playback;
  const SessionSinks sinks = watchers(show.server);
  show.server.prepare_session(show.config);
  live::LiveStart start;
  start.device = playback.config().device;
  start.is_simulated = true;
  start.replay = playback.file();
  start.replay_seconds = playback.seconds();
  start.replay_force = playback.force_strip(kStripParts);
  show.server.begin_session(start);
  ContactScratch scratch;
  reserve_contact_scratch(show.config.contact, scratch);
  playback.jump_to(0.0, sinks);
  double due = playback.time();
  std::int64_t last = monotonic_ns();
  while (!show.is_told_to_stop()) {
    const std::int64_t now = monotonic_ns();
    const std::uint64_t before = playback.frame().frame;
    if (std::optional<live::LiveRequest>& request = show.poll()) {
      if (!move_within(show, *request, sinks)) break;
      request.reset();
      due = playback.time();
    }
    if (take_step(show.server.ports())) {
      playback.advance_to(std::numeric_limits<double>::infinity(), 1, sinks);
      due = playback.time();
    } else if (!show.server.ports().is_paused && !playback.is_over()) {
      due += 1e-9 * static_cast<double>(now - last) * show.server.replay_speed();
      playback.advance_to(due, kMostFrames, sinks);
    }
    last = now;
    if (playback.frame().frame != before || scratch.sequence == 0) find_contacts(show, scratch);
    sleep_ns(kFrame);
  }
  show.server.end_session(SessionEnd::stopped, 0);
}

}  // namespace thigma::app
