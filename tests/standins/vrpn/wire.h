// The bytes of VRPN: cookie, header, and the payloads of the messages that a tracker, buttons and
// a force device exchange. Everything is big endian.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace standin {

constexpr std::size_t kCookieSize = 24;
constexpr std::size_t kHeaderSize = 24;

// Types of messages below zero belong to the connection.
enum SystemType {
  kSenderDescription = -1,
  kTypeDescription = -2,
  kUdpDescription = -3,
  kLogDescription = -4
};

// "vrpn: ver. 07.38  0", padded with zeros; the last character is the log mode.
std::string cookie(int major, int minor);
// Whether all up to the last point is the same as ours; minor versions may differ.
bool is_cookie_of(std::string_view bytes, int major);

struct VrpnMessage {
  std::int32_t sender = 0;
  std::int32_t type = 0;
  std::int32_t seconds = 0;
  std::int32_t microseconds = 0;
  std::string payload;
  std::size_t size = 0;  // bytes with padding
};

// Nothing while it is not complete. A length below the header's or above 64 KiB makes
// `is_broken`.
std::optional<VrpnMessage> read_message(std::string_view bytes, bool* is_broken);

// The time is that of the real-time clock.
std::string write_message(int sender, int type, std::string_view payload, std::uint32_t number);

// Payloads.
void add_int(std::string* bytes, std::int32_t value);
void add_float(std::string* bytes, float value);
void add_double(std::string* bytes, double value);
// Zeros' worth of nothing where the payload is too short: `at` moves on.
std::int32_t take_int(std::string_view bytes, std::size_t* at);
float take_float(std::string_view bytes, std::size_t* at);
double take_double(std::string_view bytes, std::size_t* at);

// The payload of a description of a sender or type: length with the zero, name, zero.
std::string description(const std::string& name);
std::string described_name(std::string_view payload);

}  // namespace standin
