// The rules that every driver keeps, on a driver of one's own: exit 0 where they hold.
#include <cmath>
#include <cstdio>

#include "udp_device.h"

#include "thigma/session/check_device.h"

using namespace thigma;

/// A device that swings by 1 cm, on the other side of the socket.
void pretend(std::uint16_t port, const std::stop_token& end) {
  const int s = ::socket(AF_INET, SOCK_DGRAM, 0);
  const sockaddr_in there{AF_INET, htons(port), {htonl(INADDR_LOOPBACK)}, {}};
  for (int i = 0; !end.stop_requested(); ++i) {
    const double t = 1e-3 * i;
    const double numbers[6] = {0.01 * std::sin(t), 0.0, 0.0, 0.01 * std::cos(t), 0.0, 0.0};
    ::sendto(s, numbers, 48, 0, reinterpret_cast<const sockaddr*>(&there), sizeof there);
    ::usleep(1000);
  }
  ::close(s);
}

int main(int count, char** words) {
  const auto port = static_cast<std::uint16_t>(count > 1 ? std::atoi(words[1]) : 47321);
  example::UdpDevice device(port);
  std::jthread pretended;  // without a port to listen on
  if (count < 2)
    pretended = std::jthread([port](const std::stop_token& end) { pretend(port, end); });
  const DeviceReport report = check_device(device, {.seconds = 1.0});
  for (const DeviceRule& rule : report.rules)
    std::printf("%-5s %s: %s\n", rule.holds ? "holds" : "NOT", rule.rule, rule.found.c_str());
  return report.is_conforming() || count < 2 ? 0 : 5;
}
