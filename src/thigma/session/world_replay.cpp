#include "thigma/session/world_replay.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <string>

#include "thigma/core/error.h"
#include "thigma/session/world_apart.h"

namespace thigma {
namespace {

/// Says what was recorded, step by step.
class ReplayedDevice final : public HapticDevice {
 public:
  ReplayedDevice(const DeviceLimits& limits, const std::vector<HandTick>& ticks)
      : limits_(limits), ticks_(ticks) {}
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "recorded"; }
  DeviceState read(double) THIGMA_RT override { return ticks_[next_++].device; }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  const DeviceLimits limits_;
  const std::vector<HandTick>& ticks_;
  std::size_t next_ = 0;
};

std::vector<std::unique_ptr<HapticDevice>> devices_of(std::span<const DeviceLimits> limits,
                                                      const RecordedApart& recorded) {
  std::vector<std::unique_ptr<HapticDevice>> devices;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    devices.push_back(nullptr);
    if (!recorded.ticks[i].empty())
      devices[i] = std::make_unique<ReplayedDevice>(limits[i], recorded.ticks[i]);
  }
  return devices;
}

std::vector<HapticDevice*> list_of(const std::vector<std::unique_ptr<HapticDevice>>& devices) {
  std::vector<HapticDevice*> list;
  for (const auto& device : devices) list.push_back(device.get());
  return list;
}

[[noreturn]] void refuse(std::size_t hand, const std::string& what) {
  throw InputError("hand " + std::to_string(hand + 1) + ": " + what);
}

/// Haptic steps are made as soon as there are the news that they had, frames of the world as soon
/// as there are the notes.
class Replay {
 public:
  Replay(const WorldSessionConfig& config, const std::vector<HapticDevice*>& devices,
         const RecordedApart& recorded, const ReplayWatch& watch)
      : recorded_(recorded),
        watch_(watch),
        period_(1.0 / config.rate),
        apart_(config, devices),
        notes_(devices.size()),
        next_(devices.size(), 0) {}

  WorldSummary go() {
    for (std::size_t i = 0; i < notes_.size(); ++i) step_hand(i);
    while (make_frame()) continue;
    for (std::size_t i = 0; i < notes_.size(); ++i)
      if (!is_cut_ && next_[i] < recorded_.ticks[i].size()) refuse_news(i);
    WorldSummary summary = apart_.run->end();
    add_haptic(apart_, Fault::none, summary);
    return summary;
  }

 private:
  [[noreturn]] void refuse_news(std::size_t i) const {
    const HandTick& had = recorded_.ticks[i][next_[i]];
    refuse(i, "haptic step " + std::to_string(had.step) + " has news of frame " +
                  std::to_string(had.news) + ", which the world did not make");
  }

  /// Makes the steps of a hand that had no news beyond those there are.
  void step_hand(std::size_t i) {
    if (apart_.loops[i] == nullptr) return;
    WorldHandLoop& loop = *apart_.loops[i];
    const std::vector<HandTick>& ticks = recorded_.ticks[i];
    for (; next_[i] < ticks.size() && ticks[next_[i]].news <= loop.published; ++next_[i])
      step(i, ticks[next_[i]], loop);
  }

  void step(std::size_t i, const HandTick& had, WorldHandLoop& loop) {
    const HapticSample sample = step_world_hand(loop, had.tick);
    if (const std::uint64_t has = loop.news.value().sequence; has != had.news)
      refuse(i, "haptic step " + std::to_string(had.step) + " has news of frame " +
                    std::to_string(had.news) + " where the world had told of frame " +
                    std::to_string(has));
    loop.notes.fetch();
    notes_[i].push_back(loop.notes.value());
    if (watch_.haptic) watch_.haptic(tick_of(static_cast<std::int32_t>(i), had.tick, sample, loop));
  }

  bool make_frame() {
    for (std::size_t i = 0; i < notes_.size(); ++i) {
      if (apart_.loops[i] == nullptr) continue;
      if (frames_ >= recorded_.seen[i].size()) return false;
      if (!give_note(i, recorded_.seen[i][frames_].read)) return false;
    }
    if (watch_.between) watch_.between(frames_, *apart_.run);
    const WorldFrame* made = apart_.run->make_frame();
    if (made == nullptr) return false;
    ++frames_;
    if (watch_.world) watch_.world(*made);
    for (std::size_t i = 0; i < notes_.size(); ++i) {
      if (apart_.loops[i] == nullptr) continue;
      if (!give_note(i, recorded_.seen[i][made->frame].told)) return false;
      publish_news(*made, period_, i, apart_);
      step_hand(i);
    }
    return true;
  }

  /// The world's side finds this note as the newest one of the hand; false where the recording was
  /// cut off before its step.
  bool give_note(std::size_t i, std::uint64_t frame) {
    std::deque<HandNote>& notes = notes_[i];
    if (frame == 0) {
      apart_.loops[i]->notes.publish(HandNote{});
      return true;
    }
    const bool is_later = notes.empty() || notes.back().frame < frame;
    is_cut_ = is_later && next_[i] == recorded_.ticks[i].size();
    if (is_cut_) return false;
    while (!notes.empty() && notes.front().frame < frame) notes.pop_front();
    if (notes.empty() || notes.front().frame != frame)
      refuse(i, "frame " + std::to_string(frames_) + " of the world has haptic frame " +
                    std::to_string(frame) + ", which was not made before it");
    apart_.loops[i]->notes.publish(notes.front());
    return true;
  }

  const RecordedApart& recorded_;
  const ReplayWatch& watch_;
  const double period_;
  WorldApart apart_;
  std::vector<std::deque<HandNote>> notes_;  // by hand: those that the world may still have
  std::vector<std::size_t> next_;            // by hand: its first step that is not made yet
  std::uint64_t frames_ = 0;
  bool is_cut_ = false;  // at a frame that had notes beyond the last step
};

}  // namespace

WorldSummary replay_world_apart(const WorldSessionConfig& config,
                                std::span<const DeviceLimits> limits, const RecordedApart& recorded,
                                const ReplayWatch& watch) {
  const std::size_t hands = config.hands.size();
  if (limits.size() != hands || recorded.ticks.size() != hands || recorded.seen.size() != hands)
    throw InputError("recorded are " + std::to_string(recorded.ticks.size()) +
                     " hands, expected the " + std::to_string(hands) + " of the world");
  const std::vector<std::unique_ptr<HapticDevice>> devices = devices_of(limits, recorded);
  return Replay(config, list_of(devices), recorded, watch).go();
}

}  // namespace thigma
