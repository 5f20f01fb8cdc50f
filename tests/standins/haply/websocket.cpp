#include "websocket.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include <boost/uuid/detail/sha1.hpp>

namespace standin {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string base64(std::string_view bytes) {
  static constexpr char kLetters[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      group <<= 8;
      group |= i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U;
    }
    for (std::size_t j = 0; j < 4; ++j) {
      const bool is_padding = i + j > bytes.size();
      text += is_padding ? '=' : kLetters[(group >> (18 - 6 * j)) & 63U];
    }
  }
  return text;
}

std::string sha1(std::string_view bytes) {
  boost::uuids::detail::sha1 hash;
  hash.process_bytes(bytes.data(), bytes.size());
  unsigned int words[5];
  hash.get_digest(words);
  std::string digest;
  for (const unsigned int word : words) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      digest += static_cast<char>((word >> shift) & 255U);
    }
  }
  return digest;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) {
    text.remove_suffix(1);
  }
  return text;
}

}  // namespace

std::optional<HttpRequest> read_request(std::string_view bytes) {
  const std::size_t end = bytes.find("\r\n\r\n");
  if (end == std::string_view::npos) {
    return std::nullopt;
  }
  HttpRequest request;
  request.size = end + 4;
  std::string_view head = bytes.substr(0, end);
  const std::string_view first = head.substr(0, head.find("\r\n"));
  const std::size_t space = first.find(' ');
  const std::size_t second = first.find(' ', space + 1);
  if (space != std::string_view::npos && second != std::string_view::npos) {
    request.method = first.substr(0, space);
    request.target = first.substr(space + 1, second - space - 1);
  }
  while (!head.empty()) {
    const std::size_t stop = std::min(head.find("\r\n"), head.size());
    const std::string_view line = head.substr(0, stop);
    head.remove_prefix(std::min(stop + 2, head.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) {
      continue;
    }
    const std::string name = lower(line.substr(0, colon));
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (name == "upgrade") {
      request.is_upgrade = lower(value) == "websocket";
    } else if (name == "sec-websocket-key") {
      request.key = value;
    }
  }
  return request;
}

std::string http_answer(int status, std::string_view body) {
  std::string answer = "HTTP/1.1 " + std::to_string(status);
  answer += status == 200 ? " OK" : " Not Found";
  answer += "\r\nContent-Type: application/json\r\nContent-Length: ";
  answer += std::to_string(body.size()) + "\r\nConnection: close\r\n\r\n";
  answer += body;
  return answer;
}

std::string upgrade_answer(const std::string& key) {
  const std::string accept = base64(sha1(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"));
  return "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
         "Sec-WebSocket-Accept: " +
         accept + "\r\n\r\n";
}

std::optional<WebSocketFrame> read_frame(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  if (bytes.size() < 2) {
    return std::nullopt;
  }
  WebSocketFrame frame;
  frame.is_last = (byte(0) & 0x80U) != 0;
  frame.opcode = byte(0) & 0x0F;
  frame.is_masked = (byte(1) & 0x80U) != 0;
  std::uint64_t length = byte(1) & 0x7FU;
  const std::size_t extra = length == 126 ? 2 : length == 127 ? 8 : 0;
  const std::size_t start = 2 + extra + (frame.is_masked ? 4 : 0);
  if (bytes.size() < start) {
    return std::nullopt;
  }
  if (extra > 0) {
    length = 0;
    for (std::size_t i = 0; i < extra; ++i) {
      length = (length << 8) | byte(2 + i);
    }
  }
  if (bytes.size() - start < length) {
    return std::nullopt;
  }
  frame.payload = bytes.substr(start, length);
  if (frame.is_masked) {
    for (std::size_t i = 0; i < frame.payload.size(); ++i) {
      frame.payload[i] = static_cast<char>(frame.payload[i] ^ bytes[2 + extra + i % 4]);
    }
  }
  frame.size = start + length;
  return frame;
}

std::string write_frame(int opcode, std::string_view payload) {
  std::string frame(1, static_cast<char>(0x80 | opcode));
  const std::size_t size = payload.size();
  if (size < 126) {
    frame += static_cast<char>(size);
  } else {
    const int bytes = size < 65536 ? 2 : 8;
    frame += static_cast<char>(bytes == 2 ? 126 : 127);
    for (int i = bytes - 1; i >= 0; --i) {
      frame += static_cast<char>((size >> (8 * i)) & 255U);
    }
  }
  frame += payload;
  return frame;
}

}  // namespace standin
