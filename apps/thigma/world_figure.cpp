#include "world_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <utility>

namespace thigma::app {
namespace {

constexpr std::size_t kMostPoints = 2400;  // some two a pixel of a panel
constexpr std::size_t kMostNames = 8;      // colours of the palette
constexpr const char* kHandsTime = "time of the hands [s]";
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string device_name(const WorldRecordingInfo& info, std::size_t device) {
  if (info.devices.size() == 1) return "";
  return "hand " + std::to_string(device + 1);
}

/// The bodies that go farthest, in their order; of those that go nowhere none.
std::vector<std::size_t> farthest(const WorldExtent& extent) {
  std::vector<std::size_t> bodies(extent.low.size());
  std::iota(bodies.begin(), bodies.end(), std::size_t{0});
  const auto way = [&](std::size_t i) { return (extent.high[i] - extent.low[i]).norm(); };
  std::erase_if(bodies, [&](std::size_t i) { return !(way(i) > 0.0); });
  std::stable_sort(bodies.begin(), bodies.end(),
                   [&](std::size_t a, std::size_t b) { return way(a) > way(b); });
  if (bodies.size() > kMostNames) bodies.resize(kMostNames);
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

std::string note_of(const WorldExtent& extent, const WorldRecordingPass& pass) {
  char text[160];
  std::snprintf(text, sizeof text, "%zu frames, %zu bodies, %.3f s", extent.frames,
                extent.info.bodies.size(), extent.end - extent.begin);
  std::string note = text;
  if (extent.info.is_apart && !extent.info.devices.empty())
    note += "; hands apart from the world, each haptic frame by their clock";
  if (!pass.info.has_end) note += "; cut off: the recording has no end";
  return note;
}

}  // namespace

void WorldExtent::add(const WorldRecordingInfo& of) {
  info = of;
  steps.assign(of.devices.size(), 0);
}

void WorldExtent::add(const RecordedWorldFrame& frame) {
  if (frames++ == 0) {
    begin = frame.time;
    for (const BodyState& y : frame.bodies) low.push_back(y.position);
    high = low;
  }
  end = frame.time;
  for (std::size_t i = 0; i < low.size(); ++i) {
    low[i] = low[i].cwiseMin(frame.bodies[i].position);
    high[i] = high[i].cwiseMax(frame.bodies[i].position);
  }
}

void WorldExtent::add(const HandTick& tick) { ++steps[static_cast<std::size_t>(tick.hand)]; }

void WorldCurves::panel(const char* title, const char* unit, const char* x) {
  panels_.push_back({.title = title, .x = {.label = x}, .y = {.label = unit}});
}

void WorldCurves::frames(const std::string& label,
                         std::function<double(const RecordedWorldFrame&)> value) {
  frame_curves_.push_back(
      {Thinner(label, extent_.frames, kMostPoints), std::move(value), panels_.size() - 1, 0});
}

/// One curve a hand, of what was sent.
void WorldCurves::hands(const char* title, const char* unit,
                        std::function<double(const Wrench&)> of_sent) {
  const bool is_apart = extent_.info.is_apart;
  panel(title, unit, is_apart ? kHandsTime : "time [s]");
  for (std::size_t i = 0; i < extent_.info.devices.size(); ++i) {
    const std::string name = device_name(extent_.info, i);
    if (is_apart)
      step_curves_.push_back({Thinner(name, extent_.steps[i], kMostPoints),
                              [of_sent](const HandTick& t) { return of_sent(t.sent); },
                              panels_.size() - 1, i});
    else
      frames(name, [of_sent, i](const RecordedWorldFrame& f) { return of_sent(f.commands[i]); });
  }
}

void WorldCurves::energies() {
  const bool is_apart = extent_.info.is_apart;
  panel("Energy the hand has put in", "[mJ]", is_apart ? kHandsTime : "time [s]");
  for (std::size_t i = 0; i < extent_.info.devices.size(); ++i) {
    const std::string name = device_name(extent_.info, i);
    if (is_apart)
      step_curves_.push_back({Thinner(name, extent_.steps[i], kMostPoints),
                              [](const HandTick& t) { return 1e3 * t.energy; }, panels_.size() - 1,
                              i});
    else
      frames(name, [i](const RecordedWorldFrame& f) {
        return f.hands[i] ? 1e3 * f.hands[i]->energy : kNone;
      });
  }
}

/// Bodies that slide over a floor have no height but rounding: the axis spans at least a hundredth
/// of the way that the farthest goes.
void WorldCurves::show_noise_small(const std::vector<std::size_t>& drawn) {
  if (drawn.empty()) return;
  double low = extent_.low[drawn[0]].z(), high = low, way = 0.0;
  for (const std::size_t i : drawn) {
    low = std::min(low, extent_.low[i].z());
    high = std::max(high, extent_.high[i].z());
    way = std::max(way, (extent_.high[i] - extent_.low[i]).norm());
  }
  const double least = 0.01 * way, middle = 0.5 * (low + high);
  if (high - low >= least) return;
  panels_.back().y.low = 1e3 * (middle - 0.5 * least);
  panels_.back().y.high = 1e3 * (middle + 0.5 * least);
}

void WorldCurves::bodies() {
  const std::vector<std::size_t> drawn = farthest(extent_);
  panel("Height of the centre of mass", "[mm]");
  show_noise_small(drawn);
  for (const std::size_t i : drawn)
    frames(extent_.info.bodies[i],
           [i](const RecordedWorldFrame& f) { return 1e3 * f.bodies[i].position.z(); });
  panel("Speed of the centre of mass", "[mm/s]");
  for (const std::size_t i : drawn)
    frames(extent_.info.bodies[i], [this, i](const RecordedWorldFrame& f) {
      if (last_.bodies.empty() || !(f.time > last_.time)) return kNone;
      const Vec3 way = f.bodies[i].position - last_.bodies[i].position;
      return 1e3 * way.norm() / (f.time - last_.time);
    });
  panel("Bodies awake, of those that go anywhere", "[count]");
  frames("", [this](const RecordedWorldFrame& f) {
    double awake = 0.0;
    for (std::size_t i = 0; i < f.is_asleep.size(); ++i) {
      if (!f.is_asleep[i]) return kNone;
      awake += !*f.is_asleep[i] && extent_.low[i] != extent_.high[i] ? 1.0 : 0.0;
    }
    return awake;
  });
}

void WorldCurves::joints() {
  panel("Coordinate of the joints", "[m or rad]");
  for (std::size_t i = 0; i < std::min(kMostNames, extent_.info.joints.size()); ++i)
    frames(extent_.info.joints[i],
           [i](const RecordedWorldFrame& f) { return f.joints[i].coordinate; });
}

WorldCurves::WorldCurves(const WorldExtent& extent)
    : extent_(extent), steps_(extent.info.devices.size(), 0) {
  hands("Force sent", "[N]", [](const Wrench& w) { return w.force.norm(); });
  hands("Torque sent, about the handle", "[mN m]",
        [](const Wrench& w) { return 1e3 * w.torque.norm(); });
  energies();
  bodies();
  joints();
}

void WorldCurves::add(const RecordedWorldFrame& frame) {
  if (frames_++ >= extent_.frames) return;  // one that is still being written has grown
  for (auto& curve : frame_curves_) curve.thinner.add(frame.time, curve.value(frame));
  last_ = frame;
}

void WorldCurves::add(const HandTick& tick) {
  const auto hand = static_cast<std::size_t>(tick.hand);
  if (steps_[hand]++ >= extent_.steps[hand]) return;
  for (auto& curve : step_curves_)
    if (curve.device == hand) curve.thinner.add(tick.tick.now, curve.value(tick));
}

plot::Figure WorldCurves::figure(const WorldRecordingPass& pass, const std::string& name) {
  plot::Figure figure{.title = name, .note = note_of(extent_, pass), .columns = 2, .width = 1200};
  const auto put = [this](auto& curves) {
    for (auto& curve : curves) {
      plot::Series series = curve.thinner.take();
      const bool has_any =
          std::any_of(series.y.begin(), series.y.end(), [](double y) { return std::isfinite(y); });
      if (has_any) panels_[curve.panel].series.push_back(std::move(series));
    }
  };
  put(frame_curves_);
  put(step_curves_);
  for (plot::Panel& panel : panels_)
    if (!panel.series.empty()) figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace thigma::app
