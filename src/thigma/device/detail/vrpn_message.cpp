#include "thigma/device/detail/vrpn_message.h"

#include <bit>
#include <cmath>

namespace thigma::detail {
namespace {

constexpr std::string_view kOurs = "vrpn: ver. 07.38  0";
constexpr std::size_t kSameVersion = 14;  // up to the last dot: the minor number does not matter
constexpr std::size_t kAlign = 8;
constexpr std::size_t kHead = 24;  // five numbers of 32 bits, and a sequence number
constexpr std::size_t kMostPayload = 64 * 1024;

std::size_t aligned(std::size_t n) { return (n + kAlign - 1) / kAlign * kAlign; }

/// Numbers are big-endian.
template <class Word>
void put(Word word, std::string& out) {
  for (int i = static_cast<int>(sizeof word) - 1; i >= 0; --i)
    out += static_cast<char>(word >> (8 * i));
}

void put(std::int32_t value, std::string& out) { put(static_cast<std::uint32_t>(value), out); }
void put(float value, std::string& out) { put(std::bit_cast<std::uint32_t>(value), out); }

template <class Word>
Word word_at(std::string_view bytes, std::size_t at) {
  Word word = 0;
  for (std::size_t i = 0; i < sizeof word; ++i)
    word = static_cast<Word>(word << 8) | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

std::int32_t int_at(std::string_view bytes, std::size_t at) {
  return static_cast<std::int32_t>(word_at<std::uint32_t>(bytes, at));
}

double double_at(std::string_view bytes, std::size_t at) {
  return std::bit_cast<double>(word_at<std::uint64_t>(bytes, at));
}

/// What poses and velocities begin with: sensor, filling, a vector, a quaternion x y z w.
bool read_report(std::string_view payload, std::size_t size, VrpnReport& report) {
  if (payload.size() != size) return false;
  report.sensor = int_at(payload, 0);
  for (std::size_t i = 0; i < 3; ++i)
    report.vector[static_cast<int>(i)] = double_at(payload, 8 + 8 * i);
  for (std::size_t i = 0; i < 4; ++i)
    report.quaternion.coeffs()[static_cast<int>(i)] = double_at(payload, 32 + 8 * i);
  return true;
}

void press(std::int64_t button, bool is_pressed, std::uint32_t& buttons) {
  if (button < 0 || button > 31) return;
  const std::uint32_t bit = 1u << button;
  buttons = is_pressed ? buttons | bit : buttons & ~bit;
}

}  // namespace

std::string vrpn_cookie() {
  std::string cookie(kOurs);
  cookie.resize(kVrpnCookie, '\0');
  return cookie;
}

std::string fault_of_vrpn_cookie(std::string_view cookie) {
  if (cookie.substr(0, kSameVersion) == kOurs.substr(0, kSameVersion)) return "";
  constexpr std::string_view kAny = "vrpn: ver. ";
  if (cookie.substr(0, kAny.size()) != kAny) return "it is no VRPN server";
  std::string version;
  for (const char c : cookie.substr(kAny.size(), 5)) version += c >= ' ' && c <= '~' ? c : '?';
  return "it speaks VRPN " + version + ", expected 07";
}

void append_vrpn_message(const VrpnMessage& message, std::string& out) {
  const double whole = std::floor(message.time);
  put(static_cast<std::uint32_t>(kHead + message.payload.size()), out);
  put(static_cast<std::uint32_t>(whole), out);
  put(static_cast<std::uint32_t>(1e6 * (message.time - whole)), out);
  put(message.sender, out);
  put(message.type, out);
  put(std::uint32_t{0}, out);  // a sequence number, which nobody reads
  out += message.payload;
  out.append(aligned(message.payload.size()) - message.payload.size(), '\0');
}

bool VrpnReader::next(VrpnMessage& message) {
  if (is_broken_ || in_.size() < kHead) return false;
  const std::size_t length = word_at<std::uint32_t>(in_, 0);
  if (length < kHead || length > kHead + kMostPayload) {
    is_broken_ = true;
    return false;
  }
  const std::size_t whole = kHead + aligned(length - kHead);
  if (in_.size() < whole) return false;
  message.time = word_at<std::uint32_t>(in_, 4) + 1e-6 * word_at<std::uint32_t>(in_, 8);
  message.sender = int_at(in_, 12);
  message.type = int_at(in_, 16);
  message.payload = in_.substr(kHead, length - kHead);
  in_.erase(0, whole);
  return true;
}

std::string vrpn_name_payload(const std::string& name) {
  std::string payload;
  put(static_cast<std::uint32_t>(name.size() + 1), payload);
  return payload + name + '\0';
}

bool read_vrpn_name(std::string_view payload, std::string& name) {
  constexpr std::size_t kMostName = 100;
  if (payload.size() < 5 || payload.size() > 4 + kMostName) return false;
  const std::size_t length = word_at<std::uint32_t>(payload, 0);
  if (length != payload.size() - 4 || payload.back() != '\0') return false;
  name = payload.substr(4, length - 1);
  return true;
}

bool read_vrpn_pose(std::string_view payload, VrpnReport& report) {
  return read_report(payload, 64, report);
}

bool read_vrpn_velocity(std::string_view payload, VrpnReport& report) {
  if (!read_report(payload, 72, report)) return false;
  report.time = double_at(payload, 64);
  return true;
}

bool read_vrpn_button(std::string_view payload, std::uint32_t& buttons) {
  if (payload.size() != 8) return false;
  press(int_at(payload, 0), int_at(payload, 4) != 0, buttons);
  return true;
}

bool read_vrpn_buttons(std::string_view payload, std::uint32_t& buttons) {
  if (payload.size() < 4) return false;
  const std::size_t count = word_at<std::uint32_t>(payload, 0);
  if (payload.size() != 4 + 4 * count) return false;
  for (std::size_t i = 0; i < count; ++i)
    press(static_cast<std::int64_t>(i), int_at(payload, 4 + 4 * i) != 0, buttons);
  return true;
}

bool read_vrpn_number(std::string_view payload, std::int32_t& number) {
  if (payload.size() != 4) return false;
  number = int_at(payload, 0);
  return true;
}

std::string vrpn_force_field(const Vec3& origin, const Vec3& force, const Mat3& jacobian,
                             double radius) {
  std::string payload;
  for (int i = 0; i < 3; ++i) put(static_cast<float>(origin[i]), payload);
  for (int i = 0; i < 3; ++i) put(static_cast<float>(force[i]), payload);
  for (int i = 0; i < 9; ++i) put(static_cast<float>(jacobian(i / 3, i % 3)), payload);
  put(static_cast<float>(radius), payload);
  return payload;
}

}  // namespace thigma::detail
