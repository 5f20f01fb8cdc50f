#include "thigma/device/detail/spacenav_device.h"

#include <array>
#include <cstdlib>
#include <cstring>

#include "thigma/device/detail/address.h"
#include "thigma/device/detail/rate_device.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr double kFull = 350.0;  // counts of a full deflection
constexpr double kDead = 0.04;   // share of it that is none
// Kinds of events of protocol 0; the later ones, of protocol 1, are passed over.
constexpr std::int32_t kMotion = 0, kPress = 1, kRelease = 2, kLastKind = 6;
constexpr std::int32_t kMostCounts = 100'000;

/// The socket: named, or where the daemon puts it.
std::string socket_path(const std::string& named) {
  if (!named.empty()) return named;
  const char* own = std::getenv("SPNAV_SOCKET");
  return own != nullptr && *own != '\0' ? own : "/var/run/spnav.sock";
}

Descriptor connect(const std::string& path) {
  std::string why;
  Descriptor s = connect_unix(path, why);
  if (s.is_open()) return s;
  const bool is_denied = why == std::strerror(EACCES);
  throw DeviceUnavailable("spacenav: " + path + ": " + why + ". " +
                          (is_denied ? "Let your user open it: sudo chmod a+rw " + path + "."
                                     : "Install and start the daemon: sudo apt-get install "
                                       "spacenavd, sudo systemctl start spacenavd."));
}

void listen_to(const Descriptor& socket, const RateParams& params, LinkEnds& ends) {
  SpacenavState state;
  LinkSample sample;
  std::string in;
  while (!ends.is_over.load(std::memory_order_acquire)) {
    const Heard heard = hear(socket.get(), 0.05, in);
    if (heard == Heard::closed) return ends.trouble.lose("spacenavd has gone");
    if (heard == Heard::nothing) continue;
    std::size_t taken = 0;
    for (; in.size() - taken >= kSpacenavEvent; taken += kSpacenavEvent) {
      const std::string fault =
          take_spacenav_event(std::string_view(in).substr(taken, kSpacenavEvent), state);
      if (fault.empty()) continue;
      ends.samples.publish(LinkSample{});  // nothing moves by nonsense
      return ends.trouble.lose(fault.c_str());
    }
    in.erase(0, taken);
    const Twist deflection = spacenav_deflection(state);
    ++sample.count;
    sample.motion.twist = {params.speed * deflection.linear, params.turn * deflection.angular};
    sample.buttons = state.buttons;
    ends.samples.publish(sample);
  }
}

}  // namespace

std::string take_spacenav_event(std::string_view event, SpacenavState& state) {
  std::array<std::int32_t, 8> data{};
  if (event.size() != sizeof data) return "half an event came from the socket";
  std::memcpy(data.data(), event.data(), sizeof data);
  const std::int32_t kind = data[0];
  if (kind < 0 || kind > kLastKind) return "what came from the socket is no event of spacenavd";
  if (kind == kMotion) {
    for (std::size_t i = 1; i < 7; ++i) {
      if (data[i] > kMostCounts || data[i] < -kMostCounts)
        return "spacenavd tells a deflection that no device has";
    }
    state.push = Vec3(data[1], data[2], data[3]);
    state.twist = Vec3(data[4], data[5], data[6]);
  }
  const bool is_button = kind == kPress || kind == kRelease;
  if (!is_button || data[1] < 0 || data[1] > 31) return "";
  const std::uint32_t bit = 1u << data[1];
  state.buttons = kind == kPress ? state.buttons | bit : state.buttons & ~bit;
  return "";
}

Twist spacenav_deflection(const SpacenavState& state) {
  // (x, y, z) of the daemon are (right, up, away): a mirrored frame, whose turns are told as
  // right-handed about the same lines.
  const auto ours = [](const Vec3& v) {
    const auto share = [](double counts) { return beyond_dead_zone(counts / kFull, kDead); };
    return Vec3(share(-v.z()), share(v.x()), share(v.y()));
  };
  return {ours(state.push), ours(state.twist)};
}

std::unique_ptr<HapticDevice> open_spacenav(const std::string& rest, const DeviceContext&) {
  RateParams params;
  const std::size_t mark = rest.find('?');
  if (mark != std::string::npos) {
    for (const auto& [name, value] :
         split_query(std::string_view(rest).substr(mark + 1), "spacenav:")) {
      if (!take_rate_parameter("spacenav:", name, value, params))
        unknown_name("spacenav:", name, {"speed", "turn", "hold"});
    }
  }
  const auto socket = std::make_shared<Descriptor>(connect(socket_path(rest.substr(0, mark))));
  return std::make_unique<RateDevice>(
      "spacenav", params, [socket, params](LinkEnds& ends) { listen_to(*socket, params, ends); });
}

std::vector<std::string> plugged_spacenav() {
  connect(socket_path(""));
  return {"spacenav:"};
}

std::vector<DeviceParameter> spacenav_parameters() { return rate_parameters(); }

}  // namespace thigma::detail
