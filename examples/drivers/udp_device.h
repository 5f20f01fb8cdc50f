#pragma once
// A driver of one's own: a device that tells place and velocity over UDP and is told a force, six
// doubles there and three back. Its thread talks; the haptic step exchanges newest values with it.
#include <thread>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include "thigma/core/latest.h"
#include "thigma/device/haptic_device.h"

namespace example {

using namespace thigma;

class UdpDevice final : public HapticDevice {
 public:
  explicit UdpDevice(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    const sockaddr_in here{AF_INET, htons(port), {htonl(INADDR_LOOPBACK)}, {}};
    const timeval most{0, 10'000};  // no wait lasts longer
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &most, sizeof most);
    if (::bind(socket_, reinterpret_cast<const sockaddr*>(&here), sizeof here) != 0) return;
    talk_ = std::jthread([this](const std::stop_token& end) { talk(end); });
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "udp"; }
  DeviceState read(double now) THIGMA_RT override {
    if (samples_.fetch()) state_.time = now;  // an old time is how silence is seen
    state_.status = samples_.value().count > 0 ? DeviceStatus::ok : DeviceStatus::not_ready;
    state_.motion.pose.position = Vec3(samples_.value().numbers);
    state_.motion.twist.linear = Vec3(samples_.value().numbers + 3);
    return state_;
  }
  void write(const Wrench& wrench) THIGMA_RT override { forces_.publish({wrench.force}); }

 private:
  struct Sample {
    double numbers[6] = {};
    long count = 0;
  };
  struct Force {
    Vec3 force = Vec3::Zero();
  };
  void talk(const std::stop_token& end) {
    sockaddr_in there{};
    for (int unrenewed = 0; !end.stop_requested();) {
      socklen_t size = sizeof there;
      auto* const to = reinterpret_cast<sockaddr*>(&there);
      Sample& next = samples_.draft();
      if (::recvfrom(socket_, next.numbers, 48, 0, to, &size) != 48) continue;
      next.count = ++count_;
      samples_.publish();
      unrenewed = forces_.fetch() ? 0 : unrenewed + 1;  // the haptic step hangs: let go
      const Vec3 force = unrenewed < 50 ? forces_.value().force : Vec3(Vec3::Zero());
      ::sendto(socket_, force.data(), 24, 0, to, size);
    }
    const Vec3 zero = Vec3::Zero();
    ::sendto(socket_, zero.data(), 24, 0, reinterpret_cast<sockaddr*>(&there), sizeof there);
    ::close(socket_);
  }
  const int socket_;
  const DeviceLimits limits_{
      .max_force = 4.0, .senses_rotation = false, .actuates_rotation = false};
  Latest<Sample> samples_;
  Latest<Force> forces_;
  DeviceState state_;
  long count_ = 0;
  std::jthread talk_;  // ends before the rest
};

}  // namespace example
