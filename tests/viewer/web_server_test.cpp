#include "viewer/server/web_server.h"

#include <atomic>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "web_client.h"
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "thigma/session/rt_thread.h"

namespace thigma::live {
namespace {

using test::http_exchange;
using test::WebClient;
using test::WebGreeting;

/// A server of one file that says back what it hears and offers `load` bytes to each page at each
/// tick.
struct Bench {
  std::size_t load = 0;
  std::atomic<int> opened{0}, closed{0}, heard{0};
  std::atomic<std::uint64_t> dropped{0}, taken{0};
  std::atomic<std::size_t> ticks{0};
  std::unique_ptr<WebServer> server;

  explicit Bench(std::size_t load_in = 0, const WebLimits& limits = {},
                 const WebAddress& address = {})
      : load(load_in) {
    server = std::make_unique<WebServer>(
        address, std::vector<WebFile>{{"/index.html", "text/html", "<p>page</p>"}}, limits);
    server->start({[this](PageId) { ++opened; }, [this](PageId) { ++closed; },
                   [this](PageId page, std::string_view message, bool is_binary) -> Refusal {
                     ++heard;
                     if (message == "bad") return {kPolicy, "this is bad"};
                     server->send(page, std::string(message), is_binary);
                     return {};
                   },
                   [this] { tick(); }});
  }
  ~Bench() { server->stop(); }
  void tick() {
    ++ticks;
    if (load == 0) return;
    const std::string messages[] = {std::string(load, 'x')};
    for (const PageId page : server->pages()) (server->offer(page, messages) ? taken : dropped)++;
  }
  std::uint16_t port() const { return server->port(); }
};

/// Connects and says nothing.
class IdleConnection {
 public:
  explicit IdleConnection(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  IdleConnection(IdleConnection&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}
  ~IdleConnection() {
    if (socket_ >= 0) ::close(socket_);
  }

 private:
  int socket_ = -1;
};

template <class Condition>
bool comes_true(Condition condition) {
  for (int i = 0; i < 5000; ++i) {
    if (condition()) return true;
    sleep_ns(1'000'000);
  }
  return false;
}

std::string get(std::uint16_t port, const std::string& path, const std::string& method = "GET",
                const std::string& host = "localhost") {
  return http_exchange(
      port, method + " " + path + " HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n");
}

TEST(WebServer, ServesItsFilesWithTheHeadersThatKeepThemSafe) {
  const Bench b;
  for (const char* path : {"/", "/index.html", "/?theme=dark"}) {
    const std::string answer = get(b.port(), path);
    EXPECT_EQ(answer.rfind("HTTP/1.1 200", 0), 0u) << answer;
    EXPECT_NE(answer.find("<p>page</p>"), std::string::npos);
    EXPECT_NE(answer.find("Content-Security-Policy: default-src 'none'; script-src 'self'"),
              std::string::npos);
    EXPECT_NE(answer.find("X-Content-Type-Options: nosniff"), std::string::npos);
    EXPECT_NE(answer.find("frame-ancestors 'none'"), std::string::npos);
  }
  const std::string head = get(b.port(), "/", "HEAD");
  EXPECT_NE(head.find("Content-Length: 11"), std::string::npos) << head;
  EXPECT_EQ(head.find("<p>"), std::string::npos);
}

TEST(WebServer, PagesOfThisMachineFrameItWhereTheyMay) {
  WebLimits limits;
  limits.may_be_framed = true;
  const Bench b(0, limits);
  const std::string answer = get(b.port(), "/");
  EXPECT_NE(answer.find("frame-ancestors http://127.0.0.1:* http://localhost:*\r\n"),
            std::string::npos)
      << answer;
}

TEST(WebServer, RefusesWhatIsNotItsBusiness) {
  const Bench b;
  const auto status = [](const std::string& answer) { return answer.substr(9, 3); };
  EXPECT_EQ(status(get(b.port(), "/etc/passwd")), "404");
  EXPECT_EQ(status(get(b.port(), "/../index.html")), "404");
  EXPECT_EQ(status(get(b.port(), "/", "DELETE")), "405");
  EXPECT_EQ(status(get(b.port(), "/", "GET", "evil.example")), "403");
  EXPECT_EQ(status(get(b.port(), "/live")), "426");
  EXPECT_EQ(status(http_exchange(b.port(), "nonsense\r\n\r\n")), "400");
  EXPECT_EQ(status(http_exchange(b.port(), "GET / HTTP/1.1\r\nHost: localhost\r\nX: " +
                                               std::string(20000, 'a') + "\r\n\r\n")),
            "431");
  const std::string posted = http_exchange(
      b.port(), "POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5\r\n\r\nhello");
  EXPECT_TRUE(status(posted) == "413" || status(posted) == "405") << posted;
  EXPECT_EQ(get(b.port(), "/").rfind("HTTP/1.1 200", 0), 0u);  // and still lives
}

TEST(WebServer, PagesOfTheServerItselfMayConnect) {
  const Bench b;
  WebClient client(b.port());
  ASSERT_EQ(client.status(), 101) << client.response();
  EXPECT_NE(client.response().find("Sec-WebSocket-Protocol: thigma.live.1"), std::string::npos);
  client.send_text("hello");
  const auto text = client.read();
  ASSERT_TRUE(text);
  EXPECT_EQ(text->data, "hello");
  EXPECT_FALSE(text->is_binary);
  client.send_binary(std::string("\0\1\2", 3));
  const auto binary = client.read();
  ASSERT_TRUE(binary);
  EXPECT_TRUE(binary->is_binary);
  EXPECT_EQ(binary->data.size(), 3u);
}

TEST(WebServer, ForeignPagesMayNot) {
  const Bench b;
  const auto status = [&](const WebGreeting& greeting) {
    return WebClient(b.port(), greeting).status();
  };
  EXPECT_EQ(status({.origin = "http://evil.example"}), 403);
  EXPECT_EQ(status({.origin = "null"}), 403);
  EXPECT_EQ(status({.origin = ""}), 403);
  EXPECT_EQ(status({.origin = "http://127.0.0.1:1"}), 403);
  EXPECT_EQ(status({.origin = "http://evil.example", .host = "evil.example"}), 403);
  EXPECT_EQ(status({.subprotocol = ""}), 426);
  EXPECT_EQ(status({.subprotocol = "thigma.live.2"}), 426);
  EXPECT_EQ(status({.subprotocol = "thigma.live.2, thigma.live.1"}), 101);
  EXPECT_EQ(b.heard, 0);
}

TEST(WebServer, OversizedAndMalformedFramesCloseWithTheirCode) {
  const Bench b(0, {.message_bytes = 4096});
  const auto code_of = [&](auto misbehave) {
    WebClient client(b.port());
    EXPECT_EQ(client.status(), 101);
    misbehave(client);
    return client.close_code();
  };
  EXPECT_EQ(code_of([](WebClient& c) { c.send_text(std::string(4097, 'a')); }), 1009);
  EXPECT_EQ(code_of([](WebClient& c) {  // in pieces
              c.send_frame(1, std::string(4000, 'a'), false);
              c.send_frame(0, std::string(4000, 'a'), true);
            }),
            1009);
  // Announced, never sent: no memory is given for it.
  EXPECT_EQ(code_of([](WebClient& c) {
              c.send_raw(std::string("\x82\xff\x00\x00\x7f\xff\xff\xff\xff\xff", 10));
              c.send_raw("abcd");
            }),
            1009);
  EXPECT_EQ(code_of([](WebClient& c) { c.send_text("\xc3\x28"); }), 1007);  // no UTF-8
  EXPECT_EQ(code_of([](WebClient& c) { c.send_frame(3, "x"); }), 1002);     // no such opcode
  EXPECT_EQ(code_of([](WebClient& c) { c.send_raw(std::string("\x81\x01x")); }), 1002);  // unmasked
  EXPECT_EQ(code_of([](WebClient& c) { c.send_frame(0, "x"); }), 1002);     // continues nothing
  EXPECT_EQ(code_of([](WebClient& c) { c.send_frame(0x71, "x"); }), 1002);  // reserved bits
  WebClient fine(b.port());
  fine.send_text(std::string(4096, 'a'));
  ASSERT_TRUE(fine.read());
  fine.send_text("bad");
  EXPECT_EQ(fine.close_code(), 1008);
  EXPECT_EQ(fine.close_reason(), "this is bad");
  EXPECT_TRUE(comes_true([&] { return b.closed == b.opened; }));
}

TEST(WebServer, TooManyMessagesASecondAreRefused) {
  const Bench b(0, {.messages_per_second = 50});
  WebClient client(b.port());
  for (int i = 0; i < 200; ++i) client.send_text("x");
  EXPECT_EQ(client.close_code(), 1008);
  EXPECT_LE(b.heard, 100);
}

TEST(WebServer, SoManyPagesAndNoMore) {
  const Bench b(0, {.pages = 2});
  WebClient first(b.port());
  auto second = std::make_unique<WebClient>(b.port());
  EXPECT_EQ(second->status(), 101);
  EXPECT_EQ(WebClient(b.port()).status(), 503);
  second.reset();
  ASSERT_TRUE(comes_true([&] { return b.closed == 1; }));
  EXPECT_EQ(WebClient(b.port()).status(), 101);
}

TEST(WebServer, ConnectionsThatAskForNothingLockNobodyOut) {
  WebLimits limits;
  limits.connections = 8;
  Bench b(0, limits);
  WebClient page(b.port());
  ASSERT_EQ(page.status(), 101);
  std::vector<IdleConnection> idle;
  idle.reserve(40);
  for (int i = 0; i < 40; ++i) idle.emplace_back(b.port());
  EXPECT_NE(
      http_exchange(b.port(), "GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n")
          .find("200 OK"),
      std::string::npos);
  WebClient another(b.port());
  EXPECT_EQ(another.status(), 101);
  page.send_text("still here");  // it asked for something, so it keeps its place
  const auto back = page.read();
  ASSERT_TRUE(back);
  EXPECT_EQ(back->data, "still here");
}

TEST(WebServer, APageThatDoesNotReadIsDroppedFromNeverWaitedFor) {
  Bench b(200'000);
  WebClient deaf(b.port());
  WebClient good(b.port());
  ASSERT_EQ(deaf.status(), 101);
  int read = 0;
  // 60 times 200 kB a second fill the buffers of the system at once.
  for (int i = 0; i < 40; ++i) read += good.read().has_value();
  EXPECT_EQ(read, 40);
  EXPECT_TRUE(comes_true([&] { return b.dropped > 20; }));
  const std::size_t before = b.ticks;
  EXPECT_TRUE(comes_true([&] { return b.ticks > before + 30; }));  // the server goes on
  EXPECT_LT(b.taken, b.ticks * 2);
}

TEST(WebServer, APageThatHangsUpOrDiesIsForgotten) {
  const Bench b(1000, {.silence = 0.5});
  {
    const WebClient gone(b.port());
    ASSERT_TRUE(comes_true([&] { return b.opened == 1; }));
  }
  EXPECT_TRUE(comes_true([&] { return b.closed == 1; }));
  const WebClient silent(b.port());  // answers no pings
  EXPECT_EQ(silent.status(), 101);
  EXPECT_TRUE(comes_true([&] { return b.closed == 2; }));
}

TEST(WebServer, StopTellsThePages) {
  auto b = std::make_unique<Bench>();
  WebClient client(b->port());
  ASSERT_TRUE(comes_true([&] { return b->opened == 1; }));
  std::thread stopping([&] { b->server->stop(); });
  EXPECT_EQ(client.close_code(), 1001);
  stopping.join();
  b->server->stop();  // again
}

TEST(WebServer, AWrongTokenIsRefusedAndNoneWatches) {
  const Bench b(0, {}, {.bind = "127.0.0.1", .token = "0123abcd"});
  EXPECT_TRUE(b.server->address().ends_with("/#token=0123abcd"));
  EXPECT_EQ(WebClient(b.port(), {.token = "0123abce"}).status(), 403);
  EXPECT_EQ(WebClient(b.port(), {.token = "0123abcd0"}).status(), 403);
  const WebClient watcher(b.port()), holder(b.port(), {.token = "0123abcd"});
  ASSERT_EQ(watcher.status(), 101);
  ASSERT_EQ(holder.status(), 101);
  ASSERT_TRUE(comes_true([&] { return b.opened == 2; }));
  std::promise<std::vector<bool>> rights;
  b.server->post([&] {
    std::vector<bool> found;
    for (const PageId page : b.server->pages()) found.push_back(b.server->may_control(page));
    rights.set_value(found);
  });
  EXPECT_EQ(rights.get_future().get(), (std::vector<bool>{false, true}));
}

TEST(WebServer, BeyondThisMachineItAnswersToItsNumbersOnly) {
  const Bench b(0, {}, {.bind = "0.0.0.0", .token = "0123abcd"});
  const std::string port = ":" + std::to_string(b.port());
  const auto status_for = [&](const std::string& host) {
    return http_exchange(b.port(),
                         "GET / HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n")
        .substr(9, 3);
  };
  EXPECT_EQ(status_for("192.168.0.2" + port), "200");
  EXPECT_EQ(status_for("localhost" + port), "200");
  EXPECT_EQ(status_for("evil.example" + port), "403");
  EXPECT_EQ(WebClient(b.port(), {.origin = "http://evil.example", .token = "0123abcd"}).status(),
            403);
}

TEST(WebServer, WhatIsNoAddressOfThisMachineIsRefusedInASentence) {
  for (const char* bind : {"203.0.113.1", "nonsense"}) {
    try {
      const WebServer server({.bind = bind}, {});
      ADD_FAILURE() << bind;
    } catch (const PortUnavailable& error) {
      EXPECT_NE(std::string(error.what()).find(bind), std::string::npos);
    }
  }
}

TEST(WebServer, APortInUseIsRefusedInASentence) {
  const Bench b;
  try {
    const WebServer second({.port = b.port()}, {});
    ADD_FAILURE();
  } catch (const PortUnavailable& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(b.port())), std::string::npos);
  }
}

}  // namespace
}  // namespace thigma::live
