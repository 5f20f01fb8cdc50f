#pragma once
// Inside of the server: a connection that asks for files, until it becomes a page.

#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "viewer/server/detail/web_core.h"

namespace thigma::live {

inline constexpr std::uint32_t kHeaderBytes = 8192;

/// Requests of one connection, until it becomes a page.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Core& server, tcp::socket socket);
  ~HttpConnection();
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  void read();
  /// Hangs up on a client that has not asked for anything; once.
  void give_up();

 private:
  void take(beast::error_code error);
  void handle(const Request& request);
  void upgrade(const Request& request);
  void serve(std::string_view path, bool keeps_alive);
  void answer(http::status status, const std::string& line, bool keeps_alive);
  void write(http::status status, std::string_view type, std::string body, bool keeps_alive);
  void hang_up();
  void leave_idle();

  Core& server_;
  beast::tcp_stream stream_;
  beast::flat_buffer incoming_{2 * kHeaderBytes};
  std::optional<http::request_parser<http::empty_body>> parser_;
  http::response<http::string_body> response_;
  std::string host_ = "127.0.0.1";
  bool is_head_ = false;
  std::optional<std::list<HttpConnection*>::iterator> idle_;  // place in Core::idle
};

}  // namespace thigma::live
