#include "playback.h"

#include <algorithm>

#include "scenes/scene_file.h"

#include "thigma/core/error.h"

namespace thigma::app {
namespace {

constexpr double kHistory = 10.0;         // that the plots show [s]
constexpr std::size_t kMostHistory = 200;  // frames of it; a page takes 250 at once

RecordedConfig config_of(const std::string& path, const Recording& recording) {
  try {
    return read_config(recording.config);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace

Playback::Playback(const std::string& path)
    : file_(path), recording_(read_recording(path)), config_(config_of(path, recording_)) {
  if (recording_.frames.empty())
    throw InputError(path + ": no frame, in the recording, expected one at least");
}

double Playback::seconds() const { return recording_.frames.back().time; }
double Playback::time() const { return frame().time; }
const HapticSample& Playback::frame() const { return recording_.frames[next_ == 0 ? 0 : next_ - 1]; }

void Playback::tell_contacts(double time, const SessionSinks& sinks) {
  const auto& contacts = recording_.contacts;
  for (; next_contact_ < contacts.size() && contacts[next_contact_].time <= time; ++next_contact_)
    if (sinks.contact) sinks.contact(contacts[next_contact_]);
}

void Playback::advance_to(double time, std::size_t most, const SessionSinks& sinks) {
  const auto& frames = recording_.frames;
  const auto& events = recording_.events;
  for (; most > 0 && next_ < frames.size() && frames[next_].time <= time; ++next_, --most) {
    tell_contacts(frames[next_].time, sinks);
    if (sinks.haptic) sinks.haptic(frames[next_]);
    for (; next_event_ < events.size() && events[next_event_].time <= frames[next_].time; ++next_event_)
      if (sinks.event) sinks.event(events[next_event_]);
  }
}

void Playback::jump_to(double time, const SessionSinks& sinks) {
  const auto& frames = recording_.frames;
  const auto at_time = [&](double t) {
    const auto found = std::upper_bound(
        frames.begin(), frames.end(), t, [](double a, const HapticSample& f) { return a < f.time; });
    return static_cast<std::size_t>(found - frames.begin());
  };
  const std::size_t end = std::max<std::size_t>(1, at_time(time));
  const std::size_t begin = std::min(at_time(time - kHistory), end - 1);
  // The ghost follows from where the object was when it was taken hold of.
  std::size_t taken = begin;
  while (taken > 0 && frames[taken].is_grasped && frames[taken - 1].is_grasped) --taken;
  if (sinks.haptic && frames[begin].is_grasped) {
    if (taken > 0) sinks.haptic(frames[taken - 1]);
    if (taken < begin) sinks.haptic(frames[taken]);
  }
  const auto& contacts = recording_.contacts;
  const auto newest = std::upper_bound(contacts.begin(), contacts.end(), frames[end - 1].time,
                                       [](double a, const ContactSample& c) { return a < c.time; });
  next_contact_ = static_cast<std::size_t>(newest - contacts.begin());
  if (next_contact_ > 0 && sinks.contact) sinks.contact(contacts[next_contact_ - 1]);
  const std::size_t stride = (end - begin + kMostHistory - 1) / kMostHistory;
  for (std::size_t i = begin; i < end && sinks.haptic; ++i) {
    // All frames around a change of hold, else the ghost would be drawn from the wrong place.
    const bool changes = i > 0 && frames[i].is_grasped != frames[i - 1].is_grasped;
    const bool will_change = i + 1 < end && frames[i].is_grasped != frames[i + 1].is_grasped;
    if ((end - 1 - i) % stride == 0 || changes || will_change) sinks.haptic(frames[i]);
  }
  next_ = end;
  next_event_ = 0;
  while (next_event_ < recording_.events.size() &&
         recording_.events[next_event_].time <= frames[end - 1].time)
    ++next_event_;
}

void use_recorded_scene(RunOptions& options) {
  if (!options.scene.empty() || !options.object.empty()) return;
  const std::string scene = config_of(options.replay, read_recording(options.replay)).scene;
  try {
    scenes::read_scene(scene);
  } catch (const InputError&) {
    throw InputError(options.replay + ": its scene '" + scene +
                     "' is not here, expected --object and --against, or a scene, beside --replay");
  }
  options.scene = scene;
}

}  // namespace thigma::app
