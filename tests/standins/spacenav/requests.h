// Protocol 1 of spacenavd: 32 bytes each way, a type and seven numbers.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace standin {

using Packet = std::array<std::int32_t, 8>;
constexpr std::size_t kPacketSize = 32;

constexpr std::int32_t kTag = 0x7faa0000;
constexpr std::int32_t kChangeProtocol = 0x5500;

// What one client has asked for.
struct SpaceClient {
  int protocol = 0;
  std::int32_t mask = 0x03;  // motions and buttons; 0x04 devices as well in protocol 1
  float sensitivity = 1.0F;
  std::string name;
};

std::string bytes_of(const Packet& packet);
Packet packet_of(std::string_view bytes);

// The answer to a request, empty where there is none. Under the lock of the board.
std::string answer_request(SpaceClient* client, Packet request);

// "SpaceNavigator" and its numbers, as queries and events of devices tell them.
constexpr const char* kDeviceName = "3Dconnexion SpaceNavigator";
constexpr std::int32_t kDeviceType = 0x206;
constexpr std::int32_t kVendor = 0x046d;
constexpr std::int32_t kProduct = 0xc626;

}  // namespace standin
