#include "thigma/session/fault_injection.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "thigma/core/error.h"

namespace thigma {
namespace {

constexpr double kMostSeconds = 1e6;  // counted in nanoseconds, of which 64 bits hold 292 years

[[noreturn]] void refuse(std::string_view item) {
  throw InputError("--fault: '" + std::string(item) +
                   "', expected unplug@T, nan@T, stall=S@T or hang=S@T with S and T from 0 to 1e6 "
                   "seconds, comma-separated");
}

double parse_seconds(std::string_view text, std::string_view item) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() ||
      !(value >= 0.0 && value <= kMostSeconds)) {
    refuse(item);
  }
  return value;
}

FaultEvent parse_event(std::string_view item) {
  FaultEvent event;
  const std::size_t at = item.find('@');
  if (at == std::string_view::npos) refuse(item);
  event.time = parse_seconds(item.substr(at + 1), item);
  std::string_view name = item.substr(0, at);
  const std::size_t equals = name.find('=');
  const bool has_duration = equals != std::string_view::npos;
  if (has_duration) {
    event.duration = parse_seconds(name.substr(equals + 1), item);
    name = name.substr(0, equals);
  }
  if (name == "unplug" && !has_duration) {
    event.kind = InjectedFault::unplug;
  } else if (name == "nan" && !has_duration) {
    event.kind = InjectedFault::nan;
  } else if (name == "stall" && has_duration) {
    event.kind = InjectedFault::stall;
  } else if (name == "hang" && has_duration) {
    event.kind = InjectedFault::hang;
  } else {
    refuse(item);
  }
  return event;
}

class FaultyDevice final : public HapticDevice {
 public:
  FaultyDevice(HapticDevice& inner, const std::vector<FaultEvent>& events)
      : inner_(inner), events_(events) {}

  const DeviceLimits& limits() const override { return inner_.limits(); }
  std::string name() const override { return inner_.name(); }
  const char* trouble() const THIGMA_RT override { return inner_.trouble(); }

  DeviceState read(double now) THIGMA_RT override {
    DeviceState state = inner_.read(now);
    if (active_fault(events_, InjectedFault::unplug, now) != nullptr)
      state.status = DeviceStatus::lost;
    const FaultEvent* nan = active_fault(events_, InjectedFault::nan, now);
    if (nan != nullptr && !gave_nan_) {
      state.motion.pose.position.setConstant(std::numeric_limits<double>::quiet_NaN());
      gave_nan_ = true;
    }
    return state;
  }

  // A lost device gets the zero wrench too: the driver may still be listening.
  void write(const Wrench& wrench) THIGMA_RT override { inner_.write(wrench); }

 private:
  HapticDevice& inner_;
  const std::vector<FaultEvent> events_;
  bool gave_nan_ = false;
};

}  // namespace

std::vector<FaultEvent> parse_faults(std::string_view text) {
  std::vector<FaultEvent> events;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    events.push_back(parse_event(text.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    text = text.substr(comma + 1);
    if (text.empty()) refuse("");
  }
  return events;
}

const FaultEvent* active_fault(const std::vector<FaultEvent>& events, InjectedFault kind,
                               double now) THIGMA_RT {
  for (const FaultEvent& event : events) {
    if (event.kind != kind || now < event.time) continue;
    const bool is_span = kind == InjectedFault::stall || kind == InjectedFault::hang;
    if (!is_span || now < event.time + event.duration) return &event;
  }
  return nullptr;
}

std::unique_ptr<HapticDevice> make_faulty_device(HapticDevice& inner,
                                                 const std::vector<FaultEvent>& events) {
  return std::make_unique<FaultyDevice>(inner, events);
}

}  // namespace thigma
