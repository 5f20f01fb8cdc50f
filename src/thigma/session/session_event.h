#pragma once
// What is worth a line while a session runs.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thigma {

enum class EventKind : std::uint8_t {
  began,            // a session; only for those who watch several, one after the other
  fault,            // latched; detail: its name
  resumed,          // a fault was cleared; detail: its name
  late,             // a step or a model, ridden out (SafetyLimits); detail: the fault it would be
  grasped,          // the hand took hold
  released,         // and let go
  armed,            // forces are on
  disarmed,         // and off
  not_armed,        // a hand holds the object and nothing arms; detail: why
  deep_contact,     // deeper than a model knew; detail: why
  impact,           // of a simulated body; text: how hard
  at_rest,          // a simulated body
  recording_ended,  // before its session; detail: the file
};
inline constexpr int kEventKinds = 13;

/// Name as it stands in recordings, in messages to pages and in figures.
const char* event_name(EventKind kind) noexcept;

/// The kind of that name; nothing for any other.
std::optional<EventKind> event_of_name(std::string_view name) noexcept;

/// Something worth a line: a fault, grasping, arming, samples lost.
struct SessionEvent {
  double time = 0.0;  // session clock [s]
  std::uint64_t frame = 0;
  EventKind kind = EventKind::began;
  std::string detail{};  // see EventKind; else empty
  // more, for a person: how long nothing stepped, why nothing arms, how deep; or empty
  std::string text{};
};

}  // namespace thigma
