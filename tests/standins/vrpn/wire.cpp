#include "wire.h"

#include <cstdio>
#include <cstring>

#include <sys/time.h>

namespace standin {
namespace {

std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }

template <class Bits>
void add_bits(std::string* bytes, Bits bits) {
  for (int shift = 8 * static_cast<int>(sizeof(Bits)) - 8; shift >= 0; shift -= 8) {
    *bytes += static_cast<char>((bits >> shift) & 255U);
  }
}

template <class Bits>
Bits take_bits(std::string_view bytes, std::size_t* at) {
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    const std::size_t index = *at + i;
    bits = static_cast<Bits>(bits << 8);
    bits |= index < bytes.size() ? static_cast<unsigned char>(bytes[index]) : 0U;
  }
  *at += sizeof(Bits);
  return bits;
}

template <class To, class From>
To same_bits(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

}  // namespace

std::string cookie(int major, int minor) {
  char text[kCookieSize + 1] = {};
  std::snprintf(text, sizeof(text), "vrpn: ver. %02d.%02d  0", major % 100, minor % 100);
  return {text, kCookieSize};
}

bool is_cookie_of(std::string_view bytes, int major) {
  return bytes.substr(0, 14) == std::string_view(cookie(major, 0)).substr(0, 14);
}

std::optional<VrpnMessage> read_message(std::string_view bytes, bool* is_broken) {
  *is_broken = false;
  if (bytes.size() < kHeaderSize) {
    return std::nullopt;
  }
  std::size_t at = 0;
  const std::uint32_t length = take_bits<std::uint32_t>(bytes, &at);
  if (length < kHeaderSize || length > 65536) {
    *is_broken = true;
    return std::nullopt;
  }
  VrpnMessage message;
  message.seconds = take_int(bytes, &at);
  message.microseconds = take_int(bytes, &at);
  message.sender = take_int(bytes, &at);
  message.type = take_int(bytes, &at);
  message.size = kHeaderSize + padded(length - kHeaderSize);
  if (bytes.size() < message.size) {
    return std::nullopt;
  }
  message.payload = bytes.substr(kHeaderSize, length - kHeaderSize);
  return message;
}

std::string write_message(int sender, int type, std::string_view payload, std::uint32_t number) {
  timeval t{};
  gettimeofday(&t, nullptr);
  std::string bytes;
  add_int(&bytes, static_cast<std::int32_t>(kHeaderSize + payload.size()));
  add_int(&bytes, static_cast<std::int32_t>(t.tv_sec));
  add_int(&bytes, static_cast<std::int32_t>(t.tv_usec));
  add_int(&bytes, sender);
  add_int(&bytes, type);
  add_int(&bytes, static_cast<std::int32_t>(number));
  bytes += payload;
  bytes.resize(padded(bytes.size()));
  return bytes;
}

void add_int(std::string* bytes, std::int32_t value) {
  add_bits(bytes, static_cast<std::uint32_t>(value));
}
void add_float(std::string* bytes, float value) {
  add_bits(bytes, same_bits<std::uint32_t>(value));
}
void add_double(std::string* bytes, double value) {
  add_bits(bytes, same_bits<std::uint64_t>(value));
}

std::int32_t take_int(std::string_view bytes, std::size_t* at) {
  return static_cast<std::int32_t>(take_bits<std::uint32_t>(bytes, at));
}
float take_float(std::string_view bytes, std::size_t* at) {
  return same_bits<float>(take_bits<std::uint32_t>(bytes, at));
}
double take_double(std::string_view bytes, std::size_t* at) {
  return same_bits<double>(take_bits<std::uint64_t>(bytes, at));
}

std::string description(const std::string& name) {
  std::string payload;
  add_int(&payload, static_cast<std::int32_t>(name.size() + 1));
  payload += name;
  payload += '\0';
  return payload;
}

std::string described_name(std::string_view payload) {
  const std::string_view name = payload.substr(payload.size() < 4 ? payload.size() : 4);
  return std::string(name.substr(0, name.find('\0')));
}

}  // namespace standin
