#pragma once
// HTTP and WebSocket on one port, of this machine alone unless asked otherwise: files that are part
// of the program, and messages to and from pages. What the messages mean is not known here.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace thigma::live {

/// Counts connections of pages from 1; 0 is none.
using PageId = std::uint32_t;

inline constexpr std::string_view kSubprotocol = "thigma.live.1";

/// A file to serve. The views outlive the server.
struct WebFile {
  std::string_view path;  // "/index.html" is also "/"
  std::string_view type;  // of its content
  std::string_view data;
};

/// Close codes of WebSocket that are used here.
enum CloseCode : std::uint16_t {
  kGoingAway = 1001,
  kBadPayload = 1007,
  kPolicy = 1008,
  kTooBig = 1009,
  kTryLater = 1013
};

/// Why a message is refused; code 0: it is not.
struct Refusal {
  std::uint16_t code = 0;
  std::string why;  // at most 120 bytes are told
};

/// What the server asks of those who know the content. All are called from the server's thread and
/// none throws.
struct WebHandlers {
  std::function<void(PageId)> opened;
  std::function<void(PageId)> closed;
  std::function<Refusal(PageId, std::string_view message, bool is_binary)> received;
  std::function<void()> tick;
};

/// Where the server listens.
struct WebAddress {
  std::uint16_t port = 0;          // 0: any free one
  std::string bind = "127.0.0.1";  // IPv4 or IPv6 address of this machine; "0.0.0.0": all of them
  // what a page has to show for more than watching: `/live?token=...`. "": nothing
  std::string token{};
};

struct WebLimits {
  std::size_t pages = 8;
  std::size_t connections = 64;          // pages and HTTP together
  std::size_t message_bytes = 65536;     // of a page's
  int messages_per_second = 1000;        // of a page's
  std::size_t waiting = 256;             // messages to a page that it has not taken yet
  std::size_t waiting_bytes = 1u << 20;  // of these, with which a page is not sent a level more
  double silence = 10.0;                 // without an answer to pings a page is gone [s]
  double tick = 1.0 / 60.0;              // [s]
  bool may_be_framed = false;            // by pages of any port of this machine, such as notebooks
};

/// The port cannot be had.
class PortUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The server and its one thread, which never waits for a page: what a page does not take is
/// dropped or ends the page.
/// Invariant: bound to the address it was given; from construction to stop() the port is open.
/// Thread: constructor, start, stop, destructor and post from any; everything else from handlers
/// and posted work.
class WebServer {
 public:
  /// Throws PortUnavailable; also for what is no address.
  WebServer(const WebAddress& address, std::vector<WebFile> files, const WebLimits& limits = {});
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  std::uint16_t port() const noexcept;
  /// As a browser takes it, with the token in its fragment, which browsers do not send or log.
  std::string address() const;

  void start(WebHandlers handlers);
  /// Tells all pages that it goes, and ends; at most a fifth of a second. Again: does nothing.
  void stop();
  /// Runs `work` on the server's thread; not at all once it has stopped.
  void post(std::function<void()> work);

  /// Puts a message in the page's queue; a page whose queue is full is closed. Unknown pages:
  /// nothing.
  void send(PageId page, std::string message, bool is_binary);
  /// Sends all of these (binary) when the page has taken everything before; otherwise none,
  /// counted.
  bool offer(PageId page, std::span<const std::string> messages);
  std::size_t waiting_bytes(PageId page) const;  // of what it has not taken yet
  std::uint64_t dropped(PageId page) const;      // offers that were not taken
  std::vector<PageId> pages() const;             // open ones
  /// Whether the page may do more than watch: it came with the token, or there is none.
  bool may_control(PageId page) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace thigma::live
