#pragma once
// Numbers and poses as bytes of the binary messages (docs/protocol.md).

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "viewer/server/protocol.h"

#include "thigma/math/pose.h"

namespace thigma::live::detail {

static_assert(std::endian::native == std::endian::little, "messages are the bytes in memory");

inline constexpr std::uint8_t kLayout = 1;
inline constexpr std::size_t kHeader = 16;
inline constexpr float kUnknownOnWire = std::numeric_limits<float>::quiet_NaN();

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

inline void put_header(std::string& out, MessageKind kind, std::uint16_t extra, std::size_t count,
                       double time) {
  put(out, static_cast<std::uint8_t>(kind));
  put(out, kLayout);
  put(out, extra);
  put(out, static_cast<std::uint32_t>(count));
  put(out, time);
}

/// What no float can say is not known.
inline void put_float(std::string& out, double value) {
  const auto narrow = static_cast<float>(value);
  put(out, std::isfinite(narrow) ? narrow : kUnknownOnWire);
}

inline void put_vector(std::string& out, const Vec3& v) {
  for (int i = 0; i < 3; ++i) put_float(out, v[i]);
}

inline void put_pose(std::string& out, const Pose& pose) {
  put_vector(out, pose.position);
  for (int i = 0; i < 4; ++i) put_float(out, pose.orientation.coeffs()[i]);
}

}  // namespace thigma::live::detail
