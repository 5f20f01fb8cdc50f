#include "thigma/session/world_apart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "thigma/session/detail/world_hands.h"

namespace thigma {
namespace {

/// The fault of a step that ends the session, or none. A page that is lost lets go; whoever comes
/// next takes hold anew. By the sample: in the step in which it is back the latch is open already.
Fault fault_of(const WorldHandLoop& loop, const HapticSample& sample) THIGMA_RT {
  const bool may_resume = loop.is_free && sample.fault == Fault::device_lost;
  return may_resume ? Fault::none : sample.fault;
}

}  // namespace

WorldApart::WorldApart(const WorldSessionConfig& of, std::span<HapticDevice* const> given)
    : config(&of),
      devices(given.begin(), given.end()),
      last(given.size(), 0.0),
      sent(given.size()),
      seen(given.size()),
      changes(given.size(), 0) {
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

void publish_news(const WorldFrame& frame, double step, std::size_t hand, WorldApart& apart) {
  WorldHandLoop* loop = apart.loops[hand].get();
  if (loop == nullptr) return;
  if (apart.changes[hand] != apart.run->changes()) {
    apart.changes[hand] = apart.run->changes();
    apart.scratch[hand] = reserve_hand_model(apart.run->world());
  }
  HandRelay& relay = *apart.relays[hand];
  publish_news(*apart.run,
               {frame.grips[hand], frame.handles[hand], apart.config->hands[hand], step}, *loop,
               relay, *apart.scratch[hand], apart.last[hand]);
  const HandNote& note = loop->notes.value();
  apart.sent[hand] = note.sent;
  apart.seen[hand] = {relay.seen, note.frame};
}

void publish_news(const WorldFrame& frame, double step, WorldApart& apart) {
  for (std::size_t i = 0; i < apart.loops.size(); ++i) publish_news(frame, step, i, apart);
}

Fault step_hand(const HapticTick& tick, std::size_t hand, WorldApart& apart) THIGMA_RT {
  WorldHandLoop& loop = *apart.loops[hand];
  const HapticSample sample = step_world_hand(loop, tick);
  if (!apart.ticks.empty())
    apart.ticks[hand]->push(tick_of(static_cast<std::int32_t>(hand), tick, sample, loop));
  return fault_of(loop, sample);
}

void add_haptic(const WorldApart& apart, Fault fault, WorldSummary& summary) {
  for (std::size_t i = 0; i < apart.loops.size(); ++i) {
    summary.haptic.emplace_back();
    if (apart.loops[i] == nullptr) continue;
    summary.haptic[i] = apart.loops[i]->summary;
    if (summary.hands[i].fault == Fault::none)
      summary.hands[i].fault = apart.loops[i]->state.safety.fault;
    summary.hands[i].trouble = apart.loops[i]->device.trouble();
  }
  if (summary.fault == Fault::none) summary.fault = fault;
}

WorldSummary run_world_apart(const WorldSessionConfig& config,
                             std::span<HapticDevice* const> devices, const ApartLockstep& how) {
  WorldApart apart(config, devices);
  const double period = 1.0 / config.rate;
  const std::uint64_t ticks = frames_of(config);
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
      if (fault == Fault::none) fault = fault_of(*loop, sample);
    }
    if (made != nullptr) continue;
    if (how.between) how.between(*apart.run);
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
