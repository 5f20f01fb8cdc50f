#include "thigma/device/detail/stream_socket.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <memory>

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

namespace thigma::detail {
namespace {

/// Waits for one of `events`; false where they did not come in time.
bool wait_for(int fd, short events, std::int64_t end) {
  for (;;) {
    const std::int64_t left = std::max<std::int64_t>(0, end - driver_time_ns());
    const timespec most{left / 1'000'000'000, left % 1'000'000'000};
    pollfd waiting{fd, events, 0};
    const int n = ::ppoll(&waiting, 1, &most, nullptr);
    if (n > 0) return true;
    if (n == 0 || errno != EINTR) return false;
  }
}

std::int64_t end_of(double seconds) {
  return driver_time_ns() + static_cast<std::int64_t>(1e9 * seconds);
}

/// Finishes a connection that was begun.
bool finish(int fd, double seconds, std::string& why) {
  if (!wait_for(fd, POLLOUT, end_of(seconds))) {
    why = "no answer";
    return false;
  }
  int error = 0;
  socklen_t size = sizeof error;
  ::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size);
  if (error != 0) why = std::strerror(error);
  return error == 0;
}

}  // namespace

std::int64_t driver_time_ns() noexcept {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * 1'000'000'000 + now.tv_nsec;
}

void wait_until_ns(std::int64_t time) noexcept {
  const timespec end{time / 1'000'000'000, time % 1'000'000'000};
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &end, nullptr) == EINTR) {
  }
}

Descriptor connect_tcp(const std::string& host, std::uint16_t port, double seconds,
                       std::string& why) {
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int result = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
  if (result != 0) {
    why = ::gai_strerror(result);
    return {};
  }
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(found, ::freeaddrinfo);
  for (const addrinfo* a = found; a != nullptr; a = a->ai_next) {
    Descriptor s(::socket(a->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (!s.is_open()) continue;
    const int at_once = 1;
    ::setsockopt(s.get(), IPPROTO_TCP, TCP_NODELAY, &at_once, sizeof at_once);
    if (::connect(s.get(), a->ai_addr, a->ai_addrlen) != 0 && errno != EINPROGRESS) {
      why = std::strerror(errno);
      continue;
    }
    if (finish(s.get(), seconds, why)) return s;
  }
  return {};
}

Descriptor connect_unix(const std::string& path, std::string& why) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    why = "the path is too long for a socket";
    return {};
  }
  std::memcpy(address.sun_path, path.data(), path.size());
  Descriptor s(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (s.is_open() && ::connect(s.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0)
    return s;
  why = std::strerror(errno);
  return {};
}

Heard hear(int fd, double seconds, std::string& into) {
  if (!wait_for(fd, POLLIN, end_of(seconds))) return Heard::nothing;
  constexpr std::size_t kRoom = 64 * 1024;
  const std::size_t before = into.size();
  into.resize(before + kRoom);
  ssize_t n = 0;
  do {
    n = ::read(fd, into.data() + before, kRoom);
  } while (n < 0 && errno == EINTR);
  into.resize(before + static_cast<std::size_t>(std::max<ssize_t>(0, n)));
  if (n < 0 && errno == EAGAIN) return Heard::nothing;
  return n > 0 ? Heard::bytes : Heard::closed;
}

bool tell(int fd, std::string_view bytes, double seconds) {
  const std::int64_t end = end_of(seconds);
  while (!bytes.empty()) {
    const ssize_t n = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(n));
      continue;
    }
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN && wait_for(fd, POLLOUT, end)) continue;
    return false;
  }
  return true;
}

}  // namespace thigma::detail
