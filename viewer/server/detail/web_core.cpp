#include "viewer/server/detail/web_core.h"

#include "viewer/server/detail/http_connection.h"
#include "viewer/server/detail/page.h"

namespace thigma::live {

Core::Core(const WebAddress& wanted, std::vector<WebFile> files_in, const WebLimits& limits_in)
    : address(wanted),
      files(std::move(files_in)),
      limits(limits_in),
      acceptor(io),
      ticker(io),
      farewell(io) {
  try {
    const tcp::endpoint here(asio::ip::make_address(address.bind), address.port);
    acceptor.open(here.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.bind(here);
    acceptor.listen();
    port = acceptor.local_endpoint().port();
  } catch (const boost::system::system_error& error) {
    throw PortUnavailable("port " + std::to_string(address.port) + " on " + address.bind + ": " +
                          error.code().message());
  }
}

void Core::accept() {
  acceptor.async_accept([this](beast::error_code error, tcp::socket socket) {
    if (is_stopping) return;
    // Who only holds a place gives it up for who comes.
    const bool has_room = connections < limits.connections || !idle.empty();
    if (!error && connections >= limits.connections && has_room) idle.front()->give_up();
    if (!error && has_room) std::make_shared<HttpConnection>(*this, std::move(socket))->read();
    if (error) {  // out of descriptors, say: not at once again
      farewell.expires_after(std::chrono::milliseconds(100));
      farewell.async_wait([this](beast::error_code) {
        if (!is_stopping) accept();
      });
      return;
    }
    accept();
  });
}

void Core::arm_tick() {
  ticker.expires_after(duration_of(limits.tick));
  ticker.async_wait([this](beast::error_code error) {
    if (error || is_stopping) return;
    if (handlers.tick) handlers.tick();
    arm_tick();
  });
}

void Core::erase(PageId id) {
  if (pages.erase(id) == 0) return;
  if (handlers.closed) handlers.closed(id);
  if (is_stopping && pages.empty()) io.stop();
}

void Core::begin_stop() {
  if (is_stopping) return;
  is_stopping = true;
  beast::error_code ignored;
  acceptor.close(ignored);
  ticker.cancel();
  if (pages.empty()) {
    io.stop();
    return;
  }
  const auto open = pages;
  for (const auto& [id, page] : open) page->close(kGoingAway, "the session has ended");
  farewell.expires_after(std::chrono::milliseconds(200));
  farewell.async_wait([this](beast::error_code) { io.stop(); });
}

}  // namespace thigma::live
