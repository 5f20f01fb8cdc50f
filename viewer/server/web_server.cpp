// The only source that sees Boost.Beast. Connections keep themselves alive by shared_ptr while an operation of
// theirs is under way, as Asio's callbacks need it; everything runs in one thread, so nothing is locked.

#include "viewer/server/web_server.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <thread>

#include "viewer/server/origin.h"
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace thigma::live {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;
using Request = http::request<http::empty_body>;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kHeaderBytes = 8192;
constexpr auto kHttpPatience = std::chrono::seconds(10);
constexpr int kSendBuffer = 256 * 1024;  // of the system: what lies there is old when it is read

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

std::chrono::steady_clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

std::string content_policy(std::string_view host) {
  return "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' "
         "data: "
         "blob:; font-src 'self'; connect-src 'self' ws://" +
         std::string(host) + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
}

bool asks_for_subprotocol(const Request& request) {
  for (const auto token : http::token_list(request[http::field::sec_websocket_protocol])) {
    if (view(token) == kSubprotocol) return true;
  }
  return false;
}

class Page;

/// What all connections share.
struct Core {
  Core(std::uint16_t wanted, std::vector<WebFile> files_in, const WebLimits& limits_in)
      : files(std::move(files_in)), limits(limits_in), acceptor(io), ticker(io), farewell(io) {
    try {
      const tcp::endpoint here(asio::ip::make_address("127.0.0.1"), wanted);
      acceptor.open(here.protocol());
      acceptor.set_option(asio::socket_base::reuse_address(true));
      acceptor.bind(here);
      acceptor.listen();
      port = acceptor.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw PortUnavailable("port " + std::to_string(wanted) +
                            " on 127.0.0.1: " + error.code().message());
    }
  }

  void accept();
  void arm_tick();
  void begin_stop();
  void erase(PageId id);

  std::vector<WebFile> files;
  WebLimits limits;
  WebHandlers handlers;
  // Before io: what it still holds at the end counts itself out.
  PageId last_id = 0;
  std::size_t connections = 0, upgrading = 0;
  bool is_stopping = false;
  asio::io_context io{1};
  tcp::acceptor acceptor;
  asio::steady_timer ticker, farewell;
  std::uint16_t port = 0;
  std::map<PageId, std::shared_ptr<Page>> pages;  // open ones
  std::thread thread;
};

/// One WebSocket.
class Page : public std::enable_shared_from_this<Page> {
 public:
  Page(Core& server, beast::tcp_stream stream, PageId id)
      : server_(server), socket_(std::move(stream)), id_(id) {
    ++server_.connections;
    ++server_.upgrading;
  }
  ~Page() {
    --server_.connections;
    if (!was_open_) --server_.upgrading;
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void accept(const Request& request) {
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = std::chrono::seconds(5);
    timeout.idle_timeout = duration_of(server_.limits.silence);
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
      response.set(http::field::sec_websocket_protocol, std::string(kSubprotocol));
    }));
    socket_.read_message_max(server_.limits.message_bytes);
    beast::error_code ignored;
    tcp::socket& socket = beast::get_lowest_layer(socket_).socket();
    socket.set_option(tcp::no_delay(true), ignored);
    socket.set_option(asio::socket_base::send_buffer_size(kSendBuffer), ignored);
    socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (!error && !self->server_.is_stopping) self->open();
    });
  }

  void send(std::string message, bool is_binary) {
    if (is_closing_) return;
    if (waiting_.size() >= server_.limits.waiting) {
      close(kTryLater, "the page does not take what it is sent");
      return;
    }
    waiting_.push_back({std::move(message), is_binary});
    if (!is_writing_) write();
  }

  bool offer(std::span<const std::string> messages) {
    if (is_closing_ || is_writing_) {
      ++dropped;
      return false;
    }
    for (const std::string& message : messages) send(message, true);
    return true;
  }

  void close(std::uint16_t code, std::string_view why) {
    if (is_closing_) return;
    is_closing_ = true;
    websocket::close_reason reason(static_cast<websocket::close_code>(code));
    reason.reason.assign(why.data(), std::min<std::size_t>(why.size(), 120));
    socket_.async_close(reason, [self = shared_from_this()](beast::error_code) { self->gone(); });
  }

  void hang_up() {
    beast::error_code ignored;
    beast::get_lowest_layer(socket_).socket().close(ignored);
  }

  std::uint64_t dropped = 0;

 private:
  struct Waiting {
    std::string message;
    bool is_binary;
  };

  void open() {
    is_open_ = was_open_ = true;
    --server_.upgrading;
    server_.pages.emplace(id_, shared_from_this());
    read();
    if (server_.handlers.opened) server_.handlers.opened(id_);
  }

  void read() {
    socket_.async_read(incoming_,
                       [self = shared_from_this()](beast::error_code error, std::size_t) {
                         if (error) {
                           self->gone();
                           return;
                         }
                         self->take();
                       });
  }

  void take() {
    const auto data = incoming_.cdata();
    const std::string_view message(static_cast<const char*>(data.data()), data.size());
    Refusal refusal;
    if (is_too_fast()) {
      refusal = {kPolicy, "too many messages a second"};
    } else if (!is_closing_ && server_.handlers.received) {
      refusal = server_.handlers.received(id_, message, socket_.got_binary());
    }
    incoming_.consume(incoming_.size());
    if (refusal.code != 0) {
      close(refusal.code, refusal.why);
    } else {
      read();
    }
  }

  bool is_too_fast() {
    const Clock::time_point now = Clock::now();
    if (now - window_ >= std::chrono::seconds(1)) {
      window_ = now;
      in_window_ = 0;
    }
    return ++in_window_ > server_.limits.messages_per_second;
  }

  void write() {
    is_writing_ = true;
    socket_.binary(waiting_.front().is_binary);
    socket_.async_write(asio::buffer(waiting_.front().message),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          self->is_writing_ = false;
                          if (error) {
                            self->gone();
                            return;
                          }
                          self->waiting_.pop_front();
                          if (!self->waiting_.empty() && !self->is_closing_) self->write();
                        });
  }

  void gone() {
    is_closing_ = true;
    if (!is_open_) return;
    is_open_ = false;
    hang_up();
    server_.erase(id_);
  }

  Core& server_;
  websocket::stream<beast::tcp_stream> socket_;
  const PageId id_;
  beast::flat_buffer incoming_;
  std::deque<Waiting> waiting_;  // the front is being written
  bool is_writing_ = false, is_closing_ = false, is_open_ = false, was_open_ = false;
  Clock::time_point window_{};
  int in_window_ = 0;
};

/// Requests of one connection, until it becomes a page.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Core& server, tcp::socket socket) : server_(server), stream_(std::move(socket)) {
    ++server_.connections;
  }
  ~HttpConnection() { --server_.connections; }
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  void read() {
    parser_.emplace();
    parser_->header_limit(kHeaderBytes);
    parser_->body_limit(0);
    stream_.expires_after(kHttpPatience);
    http::async_read(
        stream_, incoming_, *parser_,
        [self = shared_from_this()](beast::error_code error, std::size_t) { self->take(error); });
  }

 private:
  void take(beast::error_code error) {
    if (server_.is_stopping) return;
    if (error == http::error::header_limit) {
      answer(http::status::request_header_fields_too_large, "the request is too long", false);
    } else if (error == http::error::body_limit) {
      answer(http::status::payload_too_large, "a request has no body here", false);
    } else if (error.category() == make_error_code(http::error::bad_method).category() &&
               error != http::error::end_of_stream && error != http::error::partial_message) {
      answer(http::status::bad_request, "no HTTP", false);
    } else if (!error) {
      handle(parser_->get());
    }
  }

  void handle(const Request& request) {
    const std::string_view host = view(request[http::field::host]);
    if (!is_loopback_host(host)) {
      answer(http::status::forbidden, "this server answers to 127.0.0.1 and localhost only", false);
      return;
    }
    host_ = host;
    is_head_ = request.method() == http::verb::head;
    std::string_view path = view(request.target());
    path = path.substr(0, path.find('?'));
    if (path == "/live") {
      upgrade(request);
    } else if (request.method() != http::verb::get && !is_head_) {
      answer(http::status::method_not_allowed, "GET and HEAD only", request.keep_alive());
    } else {
      serve(path == "/" ? "/index.html" : path, request.keep_alive());
    }
  }

  void upgrade(const Request& request) {
    if (!websocket::is_upgrade(request) || !asks_for_subprotocol(request)) {
      answer(http::status::upgrade_required,
             "WebSocket with subprotocol " + std::string(kSubprotocol) + " is spoken here", false);
    } else if (!is_own_origin(view(request[http::field::origin]), host_)) {
      answer(http::status::forbidden, "only the page of this server may connect", false);
    } else if (server_.pages.size() + server_.upgrading >= server_.limits.pages) {
      answer(http::status::service_unavailable, "too many pages are open", false);
    } else {
      stream_.expires_never();
      std::make_shared<Page>(server_, std::move(stream_), ++server_.last_id)->accept(request);
    }
  }

  void serve(std::string_view path, bool keeps_alive) {
    const auto file = std::find_if(server_.files.begin(), server_.files.end(),
                                   [&](const WebFile& f) { return f.path == path; });
    if (file == server_.files.end()) {
      answer(http::status::not_found, "not here", keeps_alive);
    } else {
      write(http::status::ok, file->type, std::string(file->data), keeps_alive);
    }
  }

  void answer(http::status status, const std::string& line, bool keeps_alive) {
    write(status, "text/plain; charset=utf-8", line + "\n", keeps_alive);
  }

  void write(http::status status, std::string_view type, std::string body, bool keeps_alive) {
    response_ = {};
    response_.version(11);
    response_.result(status);
    response_.set(http::field::content_type, std::string(type));
    response_.set("Content-Security-Policy", content_policy(host_));
    response_.set(http::field::cache_control, "no-cache");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Cross-Origin-Opener-Policy", "same-origin");
    response_.set("Cross-Origin-Resource-Policy", "same-origin");
    if (status == http::status::method_not_allowed) response_.set(http::field::allow, "GET, HEAD");
    response_.keep_alive(keeps_alive);
    response_.content_length(body.size());
    if (!is_head_) response_.body() = std::move(body);
    http::async_write(
        stream_, response_,
        [self = shared_from_this(), keeps_alive](beast::error_code error, std::size_t) {
          if (error) return;
          if (keeps_alive && !self->server_.is_stopping) {
            self->read();
          } else {
            self->hang_up();
          }
        });
  }

  void hang_up() {
    beast::error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  Core& server_;
  beast::tcp_stream stream_;
  beast::flat_buffer incoming_{2 * kHeaderBytes};
  std::optional<http::request_parser<http::empty_body>> parser_;
  http::response<http::string_body> response_;
  std::string host_ = "127.0.0.1";
  bool is_head_ = false;
};

void Core::accept() {
  acceptor.async_accept([this](beast::error_code error, tcp::socket socket) {
    if (is_stopping) return;
    if (!error && connections < limits.connections)
      std::make_shared<HttpConnection>(*this, std::move(socket))->read();
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

}  // namespace

struct WebServer::Impl {
  Core core;
};

WebServer::WebServer(std::uint16_t port, std::vector<WebFile> files, const WebLimits& limits)
    : impl_(new Impl{{port, std::move(files), limits}}) {}

WebServer::~WebServer() {
  stop();
  impl_->core.pages.clear();
}

std::uint16_t WebServer::port() const noexcept { return impl_->core.port; }

std::string WebServer::address() const {
  return "http://127.0.0.1:" + std::to_string(impl_->core.port);
}

void WebServer::start(WebHandlers handlers) {
  impl_->core.handlers = std::move(handlers);
  impl_->core.accept();
  impl_->core.arm_tick();
  impl_->core.thread = std::thread([this] { impl_->core.io.run(); });
}

void WebServer::stop() {
  if (!impl_->core.thread.joinable()) return;
  asio::post(impl_->core.io, [this] { impl_->core.begin_stop(); });
  impl_->core.thread.join();
}

void WebServer::post(std::function<void()> work) { asio::post(impl_->core.io, std::move(work)); }

void WebServer::send(PageId page, std::string message, bool is_binary) {
  const auto found = impl_->core.pages.find(page);
  if (found == impl_->core.pages.end()) return;
  const std::shared_ptr<Page> kept = found->second;
  kept->send(std::move(message), is_binary);
}

bool WebServer::offer(PageId page, std::span<const std::string> messages) {
  const auto found = impl_->core.pages.find(page);
  return found != impl_->core.pages.end() && found->second->offer(messages);
}

std::uint64_t WebServer::dropped(PageId page) const {
  const auto found = impl_->core.pages.find(page);
  return found == impl_->core.pages.end() ? 0 : found->second->dropped;
}

std::vector<PageId> WebServer::pages() const {
  std::vector<PageId> ids;
  for (const auto& [id, page] : impl_->core.pages) ids.push_back(id);
  return ids;
}

}  // namespace thigma::live
