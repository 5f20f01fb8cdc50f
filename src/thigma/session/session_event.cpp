#include <array>

#include "thigma/session/session.h"

namespace thigma {
namespace {

constexpr std::array<const char*, kEventKinds> kNames = {
    "began",     "fault",    "resumed",  "late",      "grasped",
    "released",  "armed",    "disarmed", "not_armed", "deep_contact",
    "held_back", "squeezed", "impact",   "at_rest",   "recording_ended"};
static_assert(static_cast<int>(EventKind::recording_ended) + 1 == kEventKinds);

}  // namespace

const char* event_name(EventKind kind) noexcept { return kNames[static_cast<std::size_t>(kind)]; }

std::optional<EventKind> event_of_name(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i]) return static_cast<EventKind>(i);
  return std::nullopt;
}

const char* end_name(SessionEnd end) noexcept {
  switch (end) {
    case SessionEnd::duration:
      return "duration";
    case SessionEnd::device_finished:
      return "device_finished";
    case SessionEnd::stopped:
      return "stopped";
    case SessionEnd::fault:
      return "fault";
  }
  return "";
}

}  // namespace thigma
