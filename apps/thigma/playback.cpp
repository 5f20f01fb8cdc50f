#include "playback.h"

#include <algorithm>

#include "named_scene.h"

#include "thigma/core/error.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/scene/packed_scene.h"

namespace thigma::app {
namespace {

constexpr double kHistory = 10.0;          // that the plots show [s]
constexpr std::size_t kMostHistory = 200;  // frames of it; a page takes 250 at once

/// Opens what is there to read; where only PATH.part is, the error names it.
FileSource open_recording(const std::string& path) {
  refuse_absent_recording(path);
  return FileSource(path);
}

}  // namespace

Playback::Playback(const std::string& path) : file_(path), source_(open_recording(path)) {
  recording_ = stream_recording(
      source_, path,
      {{},
       [this](const HapticSample& frame, const SamplePlace& place) {
         if (frames_.empty()) frame_ = frame;
         const double newtons = frame.feedback.force.norm();
         frames_.push_back({frame.time, static_cast<float>(newtons), frame.is_grasped, place});
       },
       [this](const ContactSample& contact, const SamplePlace& place) {
         contacts_.push_back({contact.time, place});
       }});
  config_ = read_config(recording_.config, path);
  if (frames_.empty())
    throw InputError(path + ": no frame, in the recording, expected one at least");
}

double Playback::seconds() const { return frames_.back().time; }
double Playback::time() const { return frame_.time; }

std::vector<float> Playback::force_strip(std::size_t parts) const {
  std::vector<float> strip(parts, 0.0f);
  const double begin = frames_.front().time, length = seconds() - begin;
  for (const FrameEntry& frame : frames_) {
    const double share = length > 0.0 ? (frame.time - begin) / length : 0.0;
    const auto part =
        std::min(parts - 1, static_cast<std::size_t>(share * static_cast<double>(parts)));
    strip[part] = std::max(strip[part], frame.force);
  }
  return strip;
}

HapticSample Playback::read(std::size_t index) {
  return read_frame_at(messages_, frames_[index].place);
}

void Playback::send_frame(std::size_t index, const SessionSinks& sinks) {
  frame_ = read(index);
  if (sinks.haptic) sinks.haptic(frame_);
}

void Playback::send_contacts(double time, const SessionSinks& sinks) {
  for (; next_contact_ < contacts_.size() && contacts_[next_contact_].time <= time; ++next_contact_)
    if (sinks.contact) sinks.contact(read_contact_at(messages_, contacts_[next_contact_].place));
}

void Playback::advance_to(double time, std::size_t most, const SessionSinks& sinks) {
  const auto& events = recording_.events;
  for (; most > 0 && next_ < frames_.size() && frames_[next_].time <= time; ++next_, --most) {
    const double now = frames_[next_].time;
    send_contacts(now, sinks);
    send_frame(next_, sinks);
    for (; next_event_ < events.size() && events[next_event_].time <= now; ++next_event_)
      if (sinks.event) sinks.event(events[next_event_]);
  }
}

void Playback::send_history(std::size_t begin, std::size_t end, const SessionSinks& sinks) {
  const std::size_t stride = (end - begin + kMostHistory - 1) / kMostHistory;
  for (std::size_t i = begin; i < end; ++i) {
    // All frames around a change of hold, else the ghost would be drawn from the wrong place.
    const bool changes = i > 0 && frames_[i].is_grasped != frames_[i - 1].is_grasped;
    const bool will_change = i + 1 < end && frames_[i].is_grasped != frames_[i + 1].is_grasped;
    if ((end - 1 - i) % stride == 0 || changes || will_change) send_frame(i, sinks);
  }
}

void Playback::jump_to(double time, const SessionSinks& sinks) {
  const auto at_time = [&](double t) {
    const auto found = std::upper_bound(frames_.begin(), frames_.end(), t,
                                        [](double a, const FrameEntry& f) { return a < f.time; });
    return static_cast<std::size_t>(found - frames_.begin());
  };
  const std::size_t end = std::max<std::size_t>(1, at_time(time));
  const std::size_t begin = std::min(at_time(time - kHistory), end - 1);
  // The ghost follows from where the object was when it was taken hold of.
  std::size_t taken = begin;
  while (taken > 0 && frames_[taken].is_grasped && frames_[taken - 1].is_grasped) --taken;
  if (sinks.haptic && frames_[begin].is_grasped) {
    if (taken > 0) sinks.haptic(read(taken - 1));
    if (taken < begin) sinks.haptic(read(taken));
  }
  const double newest = frames_[end - 1].time;
  const auto after = std::upper_bound(contacts_.begin(), contacts_.end(), newest,
                                      [](double a, const ContactEntry& c) { return a < c.time; });
  next_contact_ = static_cast<std::size_t>(after - contacts_.begin());
  if (next_contact_ > 0 && sinks.contact)
    sinks.contact(read_contact_at(messages_, contacts_[next_contact_ - 1].place));
  send_history(begin, end, sinks);
  next_ = end;
  const auto& events = recording_.events;
  next_event_ = 0;
  while (next_event_ < events.size() && events[next_event_].time <= newest) ++next_event_;
}

void use_recorded_scene(RunOptions& options) {
  if (!options.scene.empty() || !options.object.empty()) return;
  const RecordingInfo recording =
      stream_recording(options.replay, {[](const std::string&) { return false; }, {}, {}});
  const RecordedConfig config = read_config(recording.config, options.replay);
  // The scene that travels with it, or by its name one that is here.
  const std::string& scene = has_packed_scene(options.replay) ? options.replay : config.scene;
  try {
    read_named_scene(scene);
  } catch (const InputError&) {
    throw InputError(options.replay + ": its scene '" + scene +
                     "' is not here, expected --object and --against, or a scene, beside --replay");
  }
  options.scene = scene;
  use_recorded_response(config.params.response, options);
}

void use_recorded_response(ResponseKind recorded, RunOptions& options) {
  if (!options.response.empty() || recorded == ResponseKind::direct) return;
  for (const ResponseName& known : kResponseNames) {
    if (known.kind != recorded) continue;
    options.response = known.name;
    return;
  }
}

}  // namespace thigma::app
