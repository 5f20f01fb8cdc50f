#include "thigma/device/detail/gamepad_device.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>

#include <linux/input.h>
#include <sys/ioctl.h>

#include "thigma/device/detail/address.h"
#include "thigma/device/detail/rate_device.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr double kDead = 0.10;  // share of a stick's way that is none, where `flat` is not more
constexpr int kButtons[] = {BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_TL, BTN_TR};

bool has_bit(const unsigned char* bits, int bit) { return (bits[bit / 8] >> (bit % 8) & 1) != 0; }

bool is_gamepad(int fd) {
  unsigned char keys[KEY_MAX / 8 + 1] = {}, axes[ABS_MAX / 8 + 1] = {};
  if (::ioctl(fd, EVIOCGBIT(EV_KEY, sizeof keys), keys) < 0) return false;
  if (::ioctl(fd, EVIOCGBIT(EV_ABS, sizeof axes), axes) < 0) return false;
  return has_bit(keys, BTN_SOUTH) && has_bit(axes, ABS_X) && has_bit(axes, ABS_Y);
}

/// Where every axis and button is now; what the kernel does not tell stays.
void ask_where(int fd, PadState& state) {
  for (int i = 0; i < kPadAxes; ++i) {
    input_absinfo info{};
    if (::ioctl(fd, EVIOCGABS(i), &info) < 0 || info.maximum <= info.minimum) continue;
    const auto axis = static_cast<std::size_t>(i);
    state.ranges[axis] = {info.minimum, info.maximum, info.flat};
    state.values[axis] = info.value;
  }
  unsigned char keys[KEY_MAX / 8 + 1] = {};
  if (::ioctl(fd, EVIOCGKEY(sizeof keys), keys) < 0) return;
  for (std::size_t i = 0; i < std::size(kButtons); ++i)
    take_pad_event(EV_KEY, static_cast<std::uint16_t>(kButtons[i]), has_bit(keys, kButtons[i]),
                   state);
}

/// From -1 to 1, 0 in the middle.
double stick(const PadState& state, int axis) {
  const auto i = static_cast<std::size_t>(axis);
  const PadRange& r = state.ranges[i];
  const double half = 0.5 * (static_cast<double>(r.greatest) - r.least);
  const double value = (state.values[i] - 0.5 * (static_cast<double>(r.greatest) + r.least)) / half;
  return beyond_dead_zone(value, std::clamp(r.flat / half, kDead, 0.5));
}

/// From 0 to 1.
double trigger(const PadState& state, int axis) {
  const auto i = static_cast<std::size_t>(axis);
  const PadRange& r = state.ranges[i];
  const double whole = static_cast<double>(r.greatest) - r.least;
  return beyond_dead_zone((static_cast<double>(state.values[i]) - r.least) / whole, kDead);
}

double bumper(const PadState& state, int bit) {
  return (state.buttons >> bit & 1u) != 0 ? 1.0 : 0.0;
}

std::vector<std::string> event_files() {
  std::vector<std::string> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/input", ignored)) {
    if (entry.path().filename().string().rfind("event", 0) == 0) files.push_back(entry.path());
  }
  // event2 before event10
  std::sort(files.begin(), files.end(), [](const std::string& a, const std::string& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
  return files;
}

struct FoundPads {
  std::vector<std::string> files;
  int denied = 0;  // event devices that the user may not open
};

FoundPads find_pads() {
  FoundPads found;
  for (const std::string& file : event_files()) {
    const Descriptor fd(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!fd.is_open()) {
      found.denied += errno == EACCES || errno == EPERM ? 1 : 0;
    } else if (is_gamepad(fd.get())) {
      found.files.push_back(file);
    }
  }
  return found;
}

constexpr const char* kPermit =
    "Let your user read it: a udev rule (docs/device_services.md), or sudo usermod -aG input $USER "
    "and log "
    "in again.";

/// The event device of an address.
std::string file_of(const std::string& place) {
  if (!place.empty() && place[0] == '/') return place;
  std::size_t number = 0;
  const char* const end = place.data() + place.size();
  if (!place.empty() && (std::from_chars(place.data(), end, number).ec != std::errc{} ||
                         std::to_string(number) != place))
    throw DeviceAddressError("gamepad: " + detail::quoted(place) +
                             ", expected gamepad:, gamepad:NUMBER or gamepad:/dev/input/eventN");
  const FoundPads found = find_pads();
  if (number < found.files.size()) return found.files[number];
  const std::string what = found.files.empty()
                               ? "gamepad: none is plugged in"
                               : "gamepad: no number " + std::to_string(number) + ", " +
                                     std::to_string(found.files.size()) + " plugged in";
  if (found.denied > 0)
    throw DeviceUnavailable(what + " as far as your user may look, which is not into " +
                            std::to_string(found.denied) + " event devices. " + kPermit);
  throw DeviceUnavailable(what + ". Plug it in, or pair it.");
}

Descriptor open_file(const std::string& file) {
  Descriptor fd(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (fd.is_open() && is_gamepad(fd.get())) return fd;
  if (fd.is_open())
    throw DeviceUnavailable("gamepad: " + file +
                            " is no gamepad. Plug one in; `thigma devices` lists them.");
  const int error = errno;
  throw DeviceUnavailable("gamepad: " + file + ": " + std::strerror(error) + ". " +
                          (error == EACCES || error == EPERM ? kPermit : "Plug it in."));
}

void publish(const PadState& state, const RateParams& params, LinkSample& sample, LinkEnds& ends) {
  const Twist deflection = pad_deflection(state);
  ++sample.count;
  sample.motion.twist = {params.speed * deflection.linear, params.turn * deflection.angular};
  sample.buttons = state.buttons;
  ends.samples.publish(sample);
}

void listen_to(const Descriptor& fd, const RateParams& params, LinkEnds& ends) {
  PadState state = plain_pad();
  ask_where(fd.get(), state);
  LinkSample sample;
  publish(state, params, sample, ends);
  std::string in;
  while (!ends.is_over.load(std::memory_order_acquire)) {
    const Heard heard = hear(fd.get(), 0.05, in);
    if (heard == Heard::closed) {
      ends.samples.publish(LinkSample{});
      return ends.trouble.lose("the gamepad is not there any more: unplugged");
    }
    std::size_t taken = 0;
    for (; in.size() - taken >= sizeof(input_event); taken += sizeof(input_event)) {
      input_event event{};
      std::memcpy(&event, in.data() + taken, sizeof event);
      take_pad_event(event.type, event.code, event.value, state);
      if (event.type == EV_SYN && event.code == SYN_DROPPED) ask_where(fd.get(), state);
    }
    in.erase(0, taken);
    if (taken > 0) publish(state, params, sample, ends);
  }
}

}  // namespace

PadState plain_pad() {
  PadState state;
  for (const int axis : {ABS_Z, ABS_RZ}) state.ranges[static_cast<std::size_t>(axis)] = {0, 255, 0};
  return state;
}

void take_pad_event(std::uint16_t type, std::uint16_t code, std::int32_t value, PadState& state) {
  if (type == EV_ABS && code < kPadAxes) {
    const PadRange& range = state.ranges[code];
    state.values[code] = std::clamp(value, range.least, range.greatest);
  }
  if (type != EV_KEY) return;
  for (std::uint32_t i = 0; i < std::size(kButtons); ++i) {
    if (code != kButtons[i]) continue;
    state.buttons = value != 0 ? state.buttons | 1u << i : state.buttons & ~(1u << i);
  }
}

Twist pad_deflection(const PadState& state) {
  Twist twist;
  twist.linear = {stick(state, ABS_Y), stick(state, ABS_X),
                  trigger(state, ABS_RZ) - trigger(state, ABS_Z)};
  twist.angular = {bumper(state, 4) - bumper(state, 5), stick(state, ABS_RY),
                   -stick(state, ABS_RX)};
  return twist;
}

std::unique_ptr<HapticDevice> open_gamepad(const std::string& rest, const DeviceContext&) {
  RateParams params;
  const std::size_t mark = rest.find('?');
  if (mark != std::string::npos) {
    for (const auto& [name, value] :
         split_query(std::string_view(rest).substr(mark + 1), "gamepad:")) {
      if (!take_rate_parameter("gamepad:", name, value, params))
        unknown_name("gamepad:", name, {"speed", "turn", "hold"});
    }
  }
  const std::string file = file_of(rest.substr(0, mark));
  const auto fd = std::make_shared<Descriptor>(open_file(file));
  char name[128] = "";
  if (::ioctl(fd->get(), EVIOCGNAME(sizeof name - 1), name) < 0) name[0] = '\0';
  return std::make_unique<RateDevice>(
      std::string("gamepad: ") + (name[0] != '\0' ? name : file.c_str()), params,
      [fd, params](LinkEnds& ends) { listen_to(*fd, params, ends); });
}

std::vector<std::string> plugged_gamepads() {
  const FoundPads found = find_pads();
  std::vector<std::string> addresses;
  for (std::size_t i = 0; i < found.files.size(); ++i)
    addresses.push_back("gamepad:" + std::to_string(i));
  if (addresses.empty()) file_of("");  // says why
  return addresses;
}

std::vector<DeviceParameter> gamepad_parameters() { return rate_parameters(); }

}  // namespace thigma::detail
