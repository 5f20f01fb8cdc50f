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

/// The world's frames, made when a haptic step had their news.
class Replay {
 public:
  Replay(const WorldSessionConfig& config, const std::vector<HapticDevice*>& devices,
         const RecordedApart& recorded, const ReplayWatch& watch)
      : recorded_(recorded),
        watch_(watch),
        period_(1.0 / config.rate),
        apart_(config, devices),
        notes_(devices.size()),
        is_told_(devices.size(), 1) {}

  WorldSummary go() {
    std::size_t steps = 0;
    for (const auto& ticks : recorded_.ticks) steps = std::max(steps, ticks.size());
    for (std::size_t n = 0; n < steps; ++n)
      for (std::size_t i = 0; i < notes_.size(); ++i)
        if (n < recorded_.ticks[i].size()) step(i, recorded_.ticks[i][n]);
    is_ending_ = true;
    while (make_frame()) continue;
    WorldSummary summary = apart_.run->end();
    add_haptic(apart_, Fault::none, summary);
    return summary;
  }

 private:
  void step(std::size_t i, const HandTick& had) {
    WorldHandLoop& loop = *apart_.loops[i];
    while (loop.published < had.news)
      if (!advance(i))
        refuse(i, "haptic step " + std::to_string(had.step) + " has news of frame " +
                      std::to_string(had.news) + ", which the world did not make");
    const HapticSample sample = step_world_hand(loop, had.tick);
    if (const std::uint64_t has = loop.news.value().sequence; has != had.news)
      refuse(i, "haptic step " + std::to_string(had.step) + " has news of frame " +
                    std::to_string(had.news) + " where the world had told of frame " +
                    std::to_string(has));
    loop.notes.fetch();
    notes_[i].push_back(loop.notes.value());
    if (watch_.haptic) watch_.haptic(tick_of(static_cast<std::int32_t>(i), had.tick, sample, loop));
  }

  /// Lets the next news come to a hand; false where there are none.
  bool advance(std::size_t i) {
    if (is_told_[i] != 0 && !make_frame()) return false;
    tell(i);
    return true;
  }

  void tell(std::size_t i) {
    is_told_[i] = 1;
    give_note(i, recorded_.seen[i][made_->frame].told);
    publish_news(*made_, period_, i, apart_);
  }

  bool make_frame() {
    for (std::size_t i = 0; i < is_told_.size(); ++i) {
      if (is_told_[i] != 0) continue;
      if (is_ending_ && !has_note(i, recorded_.seen[i][made_->frame].told)) return false;
      tell(i);
    }
    for (std::size_t i = 0; i < is_told_.size(); ++i) {
      if (apart_.loops[i] == nullptr) continue;
      if (frames_ >= recorded_.seen[i].size()) return false;
      // Of a recording that was cut off the last steps may be missing.
      const std::uint64_t read = recorded_.seen[i][frames_].read;
      if (is_ending_ && !has_note(i, read)) return false;
      give_note(i, read);
    }
    if (watch_.between) watch_.between(frames_, *apart_.run);
    made_ = apart_.run->make_frame();
    if (made_ == nullptr) return false;
    ++frames_;
    for (std::size_t i = 0; i < is_told_.size(); ++i)
      is_told_[i] = apart_.loops[i] == nullptr ? 1 : 0;
    if (watch_.world) watch_.world(*made_);
    return true;
  }

  bool has_note(std::size_t i, std::uint64_t frame) const {
    return frame == 0 || (!notes_[i].empty() && notes_[i].back().frame >= frame);
  }

  /// The world's side finds this note as the newest one of the hand.
  void give_note(std::size_t i, std::uint64_t frame) {
    std::deque<HandNote>& notes = notes_[i];
    if (frame == 0) return apart_.loops[i]->notes.publish(HandNote{});
    while (!notes.empty() && notes.front().frame < frame) notes.pop_front();
    if (notes.empty() || notes.front().frame != frame)
      refuse(i, "frame " + std::to_string(frames_) + " of the world has haptic frame " +
                    std::to_string(frame) + ", which was not made before it");
    apart_.loops[i]->notes.publish(notes.front());
  }

  const RecordedApart& recorded_;
  const ReplayWatch& watch_;
  const double period_;
  WorldApart apart_;
  std::vector<std::deque<HandNote>> notes_;  // by hand: those that the world may still have
  std::vector<std::uint8_t> is_told_;        // by hand: of the frame made last
  const WorldFrame* made_ = nullptr;
  std::uint64_t frames_ = 0;
  bool is_ending_ = false;  // all haptic steps are made
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
