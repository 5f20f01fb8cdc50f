// Byte vectors of RFC 6455, and what no server may send.
#include "thigma/device/detail/websocket.h"

#include <string>

#include <gtest/gtest.h>

namespace thigma::detail {
namespace {

using namespace std::string_literals;

TEST(WebSocket, answers_the_key_of_the_rfc) {  // 1.3
  EXPECT_EQ(websocket_accept("dGhlIHNhbXBsZSBub25jZQ=="), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
}

TEST(WebSocket, a_right_answer_has_no_fault) {
  const std::string key = "dGhlIHNhbXBsZSBub25jZQ==";
  const std::string head =
      "HTTP/1.1 101 Switching Protocols\r\nupgrade: WebSocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo= \r\n";
  EXPECT_EQ(fault_of_websocket_answer(head, key), "");
  EXPECT_NE(fault_of_websocket_answer(head, "AAAAAAAAAAAAAAAAAAAAAA=="), "");
  EXPECT_EQ(fault_of_websocket_answer("HTTP/1.1 404 Not Found\r\n", key),
            "it answers 404 Not Found");
  EXPECT_EQ(fault_of_websocket_answer("SSH-2.0-OpenSSH_9.2\r\n", key), "it does not speak HTTP");
  EXPECT_EQ(fault_of_websocket_answer("", key), "it does not speak HTTP");
}

TEST(WebSocket, masks_as_the_rfc_does) {  // 5.7
  std::string out;
  append_websocket_frame(WebSocketOp::text, "Hello", 0x37fa213d, out);
  EXPECT_EQ(out, "\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58"s);
}

TEST(WebSocket, reads_whole_parted_and_long_messages_byte_by_byte) {  // 5.7
  const std::string middle(256, 'm'), longer(65536, 'l');
  const std::string bytes = "\x81\x05Hello"s + "\x01\x03Hel"s + "\x89\x02hi"s + "\x80\x02lo"s +
                            "\x82\x7e\x01\x00"s + middle +
                            "\x82\x7f\x00\x00\x00\x00\x00\x01\x00\x00"s + longer + "\x88\x00"s;
  WebSocketReader reader;
  std::string payload;
  std::vector<std::string> seen;
  for (const char c : bytes) {
    reader.add({&c, 1});
    for (;;) {
      const WebSocketEvent event = reader.next(payload);
      if (event == WebSocketEvent::none) break;
      ASSERT_NE(event, WebSocketEvent::broken) << reader.fault();
      seen.push_back(std::to_string(static_cast<int>(event)) + payload);
      if (event == WebSocketEvent::close) break;
    }
  }
  EXPECT_EQ(seen,
            (std::vector<std::string>{"1Hello", "2hi", "1Hello", "1" + middle, "1" + longer, "3"}));
}

TEST(WebSocket, what_no_server_may_send_breaks_the_connection) {
  const std::string cases[] = {"\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58"s,  // masked
                               "\xc1\x05Hello"s,                                 // an extension
                               "\x83\x00"s,                                      // no known kind
                               "\x8b\x00"s,                                      // no known control
                               "\x80\x00"s,            // a part of nothing
                               "\x01\x01H\x81\x01i"s,  // a message within another
                               "\x09\x00"s,            // a ping in parts
                               "\x89\x7e\x00\x7e"s,    // a ping of 126 bytes
                               "\x82\x7f\xff\xff\xff\xff\xff\xff\xff\xff"s,  // of 2^64 - 1 bytes
                               "\x82\x7f\x00\x00\x00\x00\x00\x10\x00\x01"s,  // of 1 MiB and a byte
                               "HTTP/1.1 400 Bad Request\r\n\r\n"s};
  for (const std::string& bytes : cases) {
    WebSocketReader reader;
    reader.add(bytes);
    std::string payload;
    EXPECT_EQ(reader.next(payload), WebSocketEvent::broken) << bytes;
    EXPECT_STRNE(reader.fault(), "");
    reader.add("\x81\x05Hello"s);
    EXPECT_EQ(reader.next(payload), WebSocketEvent::broken);  // for ever
  }
}

}  // namespace
}  // namespace thigma::detail
