#include <atomic>
#include <mutex>

#include "fuzz/fuzz_target.h"
#include "viewer/server/messages.h"
#include "viewer/server/protocol.h"
#include "viewer/server/web_server.h"
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include "thigma/files/descriptor.h"

namespace thigma::fuzz {
namespace {

/// [ms] Below the ten seconds after which the server gives up a connection that says nothing: they
/// would hide that it waits for one that has ended.
constexpr int kPatience = 8000;

/// The server as a page finds it; what it receives is read as the program reads it.
live::WebServer& server() {
  static live::WebServer* const running = [] {
    live::WebLimits limits;
    limits.messages_per_second = 1 << 30;
    auto* const made = new live::WebServer({}, {{"/index.html", "text/html", "page"}}, limits);
    live::WebHandlers handlers;
    handlers.received = [](live::PageId, std::string_view message, bool is_binary) {
      if (!is_binary) return live::parse_command(message).refusal;
      const live::DeviceMessage device = live::decode_device(message);
      if (device.problem.empty() || live::decode_upload(message)) return live::Refusal{};
      return live::Refusal{live::kBadPayload, device.problem};
    };
    made->start(std::move(handlers));
    return made;
  }();
  return *running;
}

std::string handshake(std::uint16_t port) {
  const std::string host = "127.0.0.1:" + std::to_string(port);
  return "GET /live HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
         "Sec-WebSocket-Key: dGhpZ21hIGZ1enogdGVzdA==\r\nSec-WebSocket-Protocol: "
         "thigma.live.1\r\n\r\n";
}

/// All bytes, a half-closed connection, and what comes back until the server has closed as well.
void talk(std::uint16_t port, std::string_view bytes) {
  const Descriptor s(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int status =
      ::connect(s.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
  require(status == 0, "the server takes connections");
  // A port used up by thousands of closed connections a second is this test's fault, not the
  // server's.
  const linger at_once{1, 0};
  while (!bytes.empty()) {
    const ssize_t n = ::send(s.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n <= 0) break;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  ::shutdown(s.get(), SHUT_WR);
  char back[4096];
  for (;;) {
    pollfd waiting{s.get(), POLLIN, 0};
    require(::poll(&waiting, 1, kPatience) > 0, "the server closes what its client has closed");
    if (::recv(s.get(), back, sizeof back, 0) <= 0) break;
  }
  ::setsockopt(s.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

}  // namespace

/// The first byte says whether the rest are frames behind a right handshake, or all that is sent.
void fuzz_frames(Bytes bytes) {
  if (bytes.empty()) return;
  const std::uint16_t port = server().port();
  const std::string rest(text_of(bytes.subspan(1)));
  talk(port, bytes[0] == std::byte{'f'} ? handshake(port) + rest : rest);
}

}  // namespace thigma::fuzz
