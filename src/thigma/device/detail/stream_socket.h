#pragma once
// Streams to services on this machine or near it, with an end to every wait. For the threads of
// drivers, never for the haptic thread.

#include <cstdint>
#include <string>
#include <string_view>

#include "thigma/files/descriptor.h"

namespace thigma::detail {

/// CLOCK_MONOTONIC [ns].
/// Thread   [any].
std::int64_t driver_time_ns() noexcept;

/// Waits until a time of driver_time_ns.
/// Thread   [offline].
void wait_until_ns(std::int64_t time) noexcept;

/// A connection, or none and why in one line.
/// seconds  the wait for each address of the host, at most
/// Thread   [offline].
Descriptor connect_tcp(const std::string& host, std::uint16_t port, double seconds,
                       std::string& why);
Descriptor connect_unix(const std::string& path, std::string& why);

enum class Heard : std::uint8_t { bytes, nothing, closed };

/// Appends what has come to `into`, at most 64 KiB of it.
/// seconds  the wait for a first byte; 0 looks only
/// returns  closed also where the connection broke
/// Thread   [offline].
Heard hear(int fd, double seconds, std::string& into);

/// Sends all; false where the other side took it not in time or is gone.
/// Thread   [offline].
bool tell(int fd, std::string_view bytes, double seconds);

}  // namespace thigma::detail
