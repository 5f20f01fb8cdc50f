#include "viewer/server/detail/page.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <netinet/tcp.h>

namespace thigma::live {
namespace {

// Of the system: what lies there is old when it is read. All of it may be on its way; of what is
// not, no more than fills the line until the next write, else a page on a slow line sees the past.
constexpr int kSendBuffer = 256 * 1024, kMostUnsent = 16 * 1024;
using MostUnsent = asio::detail::socket_option::integer<IPPROTO_TCP, TCP_NOTSENT_LOWAT>;

}  // namespace

Page::Page(Core& server, beast::tcp_stream stream, PageId id, bool may_control)
    : server_(server), socket_(std::move(stream)), id_(id), may_control_(may_control) {
  ++server_.connections;
  ++server_.upgrading;
}

Page::~Page() {
  --server_.connections;
  if (!was_open_) --server_.upgrading;
}

void Page::accept(const Request& request) {
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
  socket.set_option(MostUnsent(kMostUnsent), ignored);
  socket_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (!error && !self->server_.is_stopping) self->open();
  });
}

void Page::send(std::string message, bool is_binary) {
  if (is_closing_) return;
  if (waiting_.size() >= server_.limits.waiting) {
    close(kTryLater, "the page does not take what it is sent");
    return;
  }
  waiting_.push_back({std::move(message), is_binary});
  if (!is_writing_) write();
}

std::size_t Page::waiting_bytes() const {
  return std::accumulate(waiting_.begin(), waiting_.end(), std::size_t{0},
                         [](std::size_t sum, const Waiting& w) { return sum + w.message.size(); });
}

bool Page::offer(std::span<const std::string> messages) {
  if (is_closing_ || is_writing_) {
    ++dropped;
    return false;
  }
  for (const std::string& message : messages) send(message, true);
  return true;
}

void Page::close(std::uint16_t code, std::string_view why) {
  if (is_closing_) return;
  is_closing_ = true;
  websocket::close_reason reason(static_cast<websocket::close_code>(code));
  reason.reason.assign(why.data(), std::min<std::size_t>(why.size(), 120));
  socket_.async_close(reason, [self = shared_from_this()](beast::error_code) { self->gone(); });
}

void Page::hang_up() {
  beast::error_code ignored;
  beast::get_lowest_layer(socket_).socket().close(ignored);
}

void Page::open() {
  is_open_ = was_open_ = true;
  --server_.upgrading;
  server_.pages.emplace(id_, shared_from_this());
  read();
  if (server_.handlers.opened) server_.handlers.opened(id_);
}

void Page::read() {
  socket_.async_read(incoming_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    if (error) {
      self->gone();
      return;
    }
    self->take();
  });
}

void Page::take() {
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

bool Page::is_too_fast() {
  const Clock::time_point now = Clock::now();
  if (now - window_ >= std::chrono::seconds(1)) {
    window_ = now;
    in_window_ = 0;
  }
  return ++in_window_ > server_.limits.messages_per_second;
}

void Page::write() {
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

void Page::gone() {
  is_closing_ = true;
  if (!is_open_) return;
  is_open_ = false;
  hang_up();
  server_.erase(id_);
}

}  // namespace thigma::live
