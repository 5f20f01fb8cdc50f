#include "viewer/server/detail/http_connection.h"

#include <algorithm>
#include <utility>

#include "viewer/server/detail/page.h"
#include "viewer/server/origin.h"

namespace thigma::live {
namespace {

constexpr auto kHttpPatience = std::chrono::seconds(10);

std::string content_policy(std::string_view host, bool may_be_framed) {
  const std::string frames = may_be_framed ? "http://127.0.0.1:* http://localhost:*" : "'none'";
  return "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' "
         "data: blob:; font-src 'self'; connect-src 'self' ws://" +
         std::string(host) + "; base-uri 'none'; form-action 'none'; frame-ancestors " + frames;
}

bool asks_for_subprotocol(const Request& request) {
  for (const auto token : http::token_list(request[http::field::sec_websocket_protocol])) {
    if (view(token) == kSubprotocol) return true;
  }
  return false;
}

/// What a target shows as its token; nothing where it shows none.
std::optional<std::string_view> token_of(std::string_view target) {
  constexpr std::string_view kKey = "?token=";
  const std::size_t at = target.find(kKey);
  if (at == std::string_view::npos) return std::nullopt;
  return target.substr(at + kKey.size());
}

}  // namespace

HttpConnection::HttpConnection(Core& server, tcp::socket socket)
    : server_(server), stream_(std::move(socket)) {
  ++server_.connections;
}

HttpConnection::~HttpConnection() {
  leave_idle();
  --server_.connections;
}

void HttpConnection::leave_idle() {
  if (idle_) server_.idle.erase(*idle_);
  idle_.reset();
}

void HttpConnection::give_up() {
  leave_idle();
  beast::error_code ignored;
  stream_.socket().close(ignored);  // ends the read
}

void HttpConnection::read() {
  idle_ = server_.idle.insert(server_.idle.end(), this);
  parser_.emplace();
  parser_->header_limit(kHeaderBytes);
  parser_->body_limit(0);
  stream_.expires_after(kHttpPatience);
  http::async_read(
      stream_, incoming_, *parser_,
      [self = shared_from_this()](beast::error_code error, std::size_t) { self->take(error); });
}

void HttpConnection::take(beast::error_code error) {
  leave_idle();
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

void HttpConnection::handle(const Request& request) {
  const std::string_view host = view(request[http::field::host]);
  const bool is_open = !is_loopback_address(server_.address.bind);
  if (!is_loopback_host(host) && !(is_open && is_own_host(host))) {
    answer(http::status::forbidden,
           is_open ? "this server answers to its addresses and to its machine's name only"
                   : "this server answers to 127.0.0.1 and localhost only",
           false);
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

void HttpConnection::upgrade(const Request& request) {
  if (!websocket::is_upgrade(request) || !asks_for_subprotocol(request)) {
    answer(http::status::upgrade_required,
           "WebSocket with subprotocol " + std::string(kSubprotocol) + " is spoken here", false);
    return;
  }
  if (!is_own_origin(view(request[http::field::origin]), host_)) {
    answer(http::status::forbidden, "only the page of this server may connect", false);
    return;
  }
  if (server_.pages.size() + server_.upgrading >= server_.limits.pages) {
    answer(http::status::service_unavailable, "too many pages are open", false);
    return;
  }
  const std::string& token = server_.address.token;
  const std::optional<std::string_view> shown = token_of(view(request.target()));
  if (!token.empty() && shown && !is_same_secret(*shown, token)) {
    answer(http::status::forbidden, "the token is not that of this session", false);
    return;
  }
  stream_.expires_never();
  std::make_shared<Page>(server_, std::move(stream_), ++server_.last_id, token.empty() || shown)
      ->accept(request);
}

void HttpConnection::serve(std::string_view path, bool keeps_alive) {
  const auto file = std::find_if(server_.files.begin(), server_.files.end(),
                                 [&](const WebFile& f) { return f.path == path; });
  if (file == server_.files.end()) {
    answer(http::status::not_found, "not here", keeps_alive);
  } else {
    write(http::status::ok, file->type, std::string(file->data), keeps_alive);
  }
}

void HttpConnection::answer(http::status status, const std::string& line, bool keeps_alive) {
  write(status, "text/plain; charset=utf-8", line + "\n", keeps_alive);
}

void HttpConnection::write(http::status status, std::string_view type, std::string body,
                           bool keeps_alive) {
  response_ = {};
  response_.version(11);
  response_.result(status);
  response_.set(http::field::content_type, std::string(type));
  response_.set("Content-Security-Policy", content_policy(host_, server_.limits.may_be_framed));
  response_.set(http::field::cache_control, "no-cache");
  response_.set("X-Content-Type-Options", "nosniff");
  response_.set("Referrer-Policy", "no-referrer");
  response_.set("Cross-Origin-Opener-Policy", "same-origin");
  response_.set("Cross-Origin-Resource-Policy", "same-origin");
  if (status == http::status::method_not_allowed) response_.set(http::field::allow, "GET, HEAD");
  response_.keep_alive(keeps_alive);
  response_.content_length(body.size());
  if (!is_head_) response_.body() = std::move(body);
  http::async_write(stream_, response_,
                    [self = shared_from_this(), keeps_alive](beast::error_code error, std::size_t) {
                      if (error) return;
                      if (keeps_alive && !self->server_.is_stopping) {
                        self->read();
                      } else {
                        self->hang_up();
                      }
                    });
}

void HttpConnection::hang_up() {
  beast::error_code ignored;
  stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
}

}  // namespace thigma::live
