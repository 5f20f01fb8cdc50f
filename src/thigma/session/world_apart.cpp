#include "thigma/session/world_apart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "thigma/session/detail/world_hands.h"

namespace thigma {
namespace {

/// A page that is lost lets go; whoever comes next takes hold anew.
bool may_resume(const WorldHandLoop& loop) THIGMA_RT {
  return loop.is_free && loop.state.safety.fault == Fault::device_lost;
}

}  // namespace

WorldApart::WorldApart(const WorldSessionConfig& of, std::span<HapticDevice* const> given)
    : config(&of), devices(given.begin(), given.end()), last(given.size(), 0.0) {
  if (devices.size() != of.hands.size())
    throw std::invalid_argument(std::to_string(devices.size()) + " devices, expected the " +
                                std::to_string(of.hands.size()) + " of the hands");
  for (std::size_t i = 0; i < devices.size(); ++i) {
    loops.push_back(nullptr);
    relays.push_back(nullptr);
    scratch.emplace_back();
    world_devices.push_back(nullptr);
    if (devices[i] == nullptr) continue;
    loops[i] = std::make_unique<WorldHandLoop>(of.hands[i], *devices[i], of.rate);
    relays[i] = std::make_unique<HandRelay>(*loops[i], 1.0 / of.rate);
    scratch[i] = reserve_hand_model(of.world);
    world_devices[i] = relays[i].get();
  }
  run = std::make_unique<WorldRun>(of, world_devices);
}

WorldApart::~WorldApart() {
  run.reset();  // of the relays
  let_go(*this);
}

void let_go(const WorldApart& apart) {
  for (HapticDevice* device : apart.devices) detail::let_go(device);
}

void publish_news(const WorldFrame& frame, double step, WorldApart& apart) {
  const bool has_changed = apart.run->changes() != apart.changes;
  apart.changes = apart.run->changes();
  for (std::size_t i = 0; i < apart.loops.size(); ++i) {
    if (apart.loops[i] == nullptr) continue;
    if (has_changed) apart.scratch[i] = reserve_hand_model(apart.run->world());
    publish_news(*apart.run, {frame.grips[i], frame.handles[i], apart.config->hands[i], step},
                 *apart.loops[i], *apart.relays[i], *apart.scratch[i], apart.last[i]);
  }
}

Fault step_hands(const HapticTick& tick, WorldApart& apart) THIGMA_RT {
  Fault fault = Fault::none;
  for (const auto& loop : apart.loops) {
    if (loop == nullptr) continue;
    const HapticSample sample = step_world_hand(*loop, tick);
    if (fault == Fault::none && !may_resume(*loop)) fault = sample.fault;
  }
  return fault;
}

void add_haptic(const WorldApart& apart, Fault fault, WorldSummary& summary) {
  for (std::size_t i = 0; i < apart.loops.size(); ++i) {
    summary.haptic.emplace_back();
    if (apart.loops[i] == nullptr) continue;
    summary.haptic[i] = apart.loops[i]->summary;
    if (summary.hands[i].fault == Fault::none)
      summary.hands[i].fault = apart.loops[i]->state.safety.fault;
  }
  if (summary.fault == Fault::none) summary.fault = fault;
}

WorldSummary run_world_apart(const WorldSessionConfig& config,
                             std::span<HapticDevice* const> devices, const ApartLockstep& how) {
  WorldApart apart(config, devices);
  const double period = 1.0 / config.rate;
  const auto ticks = static_cast<std::uint64_t>(std::llround(config.duration * config.rate));
  const WorldFrame* made = nullptr;  // by the step that is under way
  std::uint64_t due = 0;
  Fault fault = Fault::none;
  for (std::uint64_t tick = 0; tick < ticks && fault == Fault::none; ++tick) {
    if (made != nullptr && tick == due) {
      publish_news(*made, period, apart);
      made = nullptr;
    }
    const double now = static_cast<double>(tick) * period;
    for (std::size_t i = 0; i < apart.loops.size(); ++i) {
      WorldHandLoop* loop = apart.loops[i].get();
      if (loop == nullptr) continue;
      const HapticSample sample = step_world_hand(*loop, {now, period});
      if (how.haptic) how.haptic(i, sample);
      if (fault == Fault::none && !may_resume(*loop)) fault = sample.fault;
    }
    if (made != nullptr) continue;
    made = apart.run->make_frame();
    if (made == nullptr) break;
    const int lasts = how.lasts ? how.lasts(made->frame) : how.world_every;
    due = tick + static_cast<std::uint64_t>(std::max(lasts, 1));
    if (how.world) how.world(*made);
  }
  WorldSummary summary = apart.run->end();
  add_haptic(apart, fault, summary);
  return summary;
}

}  // namespace thigma
