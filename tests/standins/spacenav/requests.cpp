#include "requests.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "../common/board.h"

namespace standin {
namespace {

enum Request : std::int32_t {
  kSetName = 0x1000,
  kSetSensitivity,
  kGetSensitivity,
  kSetMask,
  kGetMask,
  kDeviceNameRequest = 0x2000,
  kDevicePath,
  kAxesCount,
  kButtonsCount,
  kUsbId,
  kDeviceTypeRequest,
  kSetGlobalSensitivity = 0x3000,
  kGetGlobalSensitivity,
  kGetDeadZone = 0x3005,
  kSetRepeat = 0x3018,
  kGetRepeat = 0x3019
};

constexpr std::size_t kChunk = 24;               // bytes of a string in one packet
constexpr std::int32_t kContinuation = 0x10000;  // bit of the packets after the first

float as_float(std::int32_t bits) {
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}
std::int32_t as_bits(float value) {
  std::int32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

std::string text_answer(std::int32_t type, std::string_view text) {
  std::string bytes;
  std::int32_t flag = 0;
  do {
    Packet packet{};
    packet[0] = type;
    const std::size_t size = std::min(text.size(), kChunk);
    std::memcpy(packet.data() + 1, text.data(), size);
    packet[7] = static_cast<std::int32_t>(text.size()) | flag;
    bytes += bytes_of(packet);
    text.remove_prefix(size);
    flag = kContinuation;
  } while (!text.empty());
  return bytes;
}

// Collects a name; the last seven-th number is how much is left, this packet's included.
void take_name(SpaceClient* client, const Packet& packet) {
  const auto left = static_cast<std::size_t>(packet[7] & 0xffff);
  if ((packet[7] & kContinuation) == 0) {
    client->name.clear();
  }
  client->name.append(reinterpret_cast<const char*>(packet.data() + 1), std::min(left, kChunk));
  note(0, ("client name " + client->name).substr(0, 39).c_str(), packet[7]);
}

std::string done(Packet packet, std::int32_t status) {
  packet[7] = status;
  return bytes_of(packet);
}

// What asks for the device, -1 where there is none.
std::string answer_device(const Packet& request) {
  Packet packet = request;
  if (is_on(0, k_unplug) || !is_on(0, k_count)) {
    return done(packet, -1);
  }
  switch (request[0] & 0xffff) {
    case kDeviceNameRequest:
      return text_answer(request[0], kDeviceName);
    case kDevicePath:
      return text_answer(request[0], "/dev/input/event7");
    case kAxesCount:
      packet[1] = 6;
      break;
    case kButtonsCount:
      packet[1] = 2;
      break;
    case kUsbId:
      packet[1] = kVendor;
      packet[2] = kProduct;
      break;
    default:
      packet[1] = kDeviceType;
  }
  return done(packet, 0);
}

}  // namespace

std::string bytes_of(const Packet& packet) {
  return {reinterpret_cast<const char*>(packet.data()), kPacketSize};
}

Packet packet_of(std::string_view bytes) {
  Packet packet{};
  std::memcpy(packet.data(), bytes.data(), std::min(bytes.size(), kPacketSize));
  return packet;
}

std::string answer_request(SpaceClient* client, Packet request) {
  const std::int32_t type = request[0] & 0xffff;
  switch (type) {
    case kSetName:
      take_name(client, request);
      return {};  // the daemon does not answer this one
    case kSetSensitivity:
      if (!std::isfinite(as_float(request[1]))) {
        return done(request, -1);
      }
      client->sensitivity = as_float(request[1]);
      put(0, k_sensitivity, static_cast<double>(client->sensitivity));
      return done(request, 0);
    case kGetSensitivity:
      request[1] = as_bits(client->sensitivity);
      return done(request, 0);
    case kSetMask:
      client->mask = request[1];
      return done(request, 0);
    case kGetMask:
      request[1] = client->mask;
      return done(request, 0);
    case kGetGlobalSensitivity:
      request[1] = as_bits(1.0F);
      return done(request, 0);
    case kGetDeadZone:
      request[2] = static_cast<std::int32_t>(get(0, k_dead_zone));
      return done(request, request[1] >= 0 && request[1] < 6 ? 0 : -1);
    case kSetRepeat:
      put(0, k_repeat_ms, request[1]);
      return done(request, 0);
    case kGetRepeat:
      request[1] = static_cast<std::int32_t>(get(0, k_repeat_ms));
      return done(request, 0);
    default:
      break;
  }
  if (type >= kDeviceNameRequest && type <= kDeviceTypeRequest) {
    return answer_device(request);
  }
  add(0, k_bad_messages);
  note(0, "unknown request", type);
  return done(request, -1);
}

}  // namespace standin
