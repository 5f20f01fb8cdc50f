#pragma once
// Inside of the server: what its connections share. These files are the only ones that see
// Boost.Beast. Connections keep themselves alive by shared_ptr while an operation of theirs is
// under way, as Asio's callbacks need it; everything runs in one thread, so nothing is locked.

#include <chrono>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "viewer/server/web_server.h"
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

namespace thigma::live {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using tcp = asio::ip::tcp;
using Request = http::request<http::empty_body>;
using Clock = std::chrono::steady_clock;

class Page;
class HttpConnection;

inline std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

inline Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// What all connections share.
struct Core {
  /// Listens at once. Throws PortUnavailable.
  Core(const WebAddress& address, std::vector<WebFile> files, const WebLimits& limits);

  void accept();
  void arm_tick();
  void begin_stop();
  void erase(PageId id);

  WebAddress address;
  std::vector<WebFile> files;
  WebLimits limits;
  WebHandlers handlers;
  // Before io: what it still holds at the end counts itself out.
  PageId last_id = 0;
  std::size_t connections = 0, upgrading = 0;
  std::list<HttpConnection*> idle;  // wait for a request, the longest first
  bool is_stopping = false;
  asio::io_context io{1};
  tcp::acceptor acceptor;
  asio::steady_timer ticker, farewell;
  std::uint16_t port = 0;
  std::map<PageId, std::shared_ptr<Page>> pages;  // open ones
  std::thread thread;
};

}  // namespace thigma::live
