#pragma once
// Inside of the server: the WebSocket of a page.

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>

#include "viewer/server/detail/web_core.h"
#include <boost/beast/websocket.hpp>

namespace thigma::live {

namespace websocket = beast::websocket;

/// One WebSocket. In Core::pages from the end of its handshake until it is gone.
class Page : public std::enable_shared_from_this<Page> {
 public:
  Page(Core& server, beast::tcp_stream stream, PageId id, bool may_control);
  ~Page();
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;

  void accept(const Request& request);
  void send(std::string message, bool is_binary);
  bool offer(std::span<const std::string> messages);
  void close(std::uint16_t code, std::string_view why);
  void hang_up();

  std::size_t waiting_bytes() const;
  bool may_control() const { return may_control_; }

  std::uint64_t dropped = 0;  // offers that were not taken

 private:
  struct Waiting {
    std::string message;
    bool is_binary;
  };

  void open();
  void read();
  void take();
  bool is_too_fast();
  void write();
  void gone();

  Core& server_;
  websocket::stream<beast::tcp_stream> socket_;
  const PageId id_;
  const bool may_control_;
  beast::flat_buffer incoming_;
  std::deque<Waiting> waiting_;  // the front is being written
  bool is_writing_ = false, is_closing_ = false, is_open_ = false, was_open_ = false;
  Clock::time_point window_{};
  int in_window_ = 0;
};

}  // namespace thigma::live
