#pragma once
// Percentiles and rates over the last second, for people to read.

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/server/messages.h"
#include "viewer/server/protocol.h"

namespace thigma::live {

/// Collects for a second, then tells of it.
struct TimingWindow {
  double since = 0.0;  // [s; any clock]
  std::uint64_t first_frame = 0, first_update = 0;
  bool has_first = false;                              // they came by the clock when it began
  std::vector<double> step_cpu, wake_late, query_cpu;  // [s]
  std::size_t held_back = 0, squeezed = 0;             // frames
};

/// Adds rows and what has been measured of queries.
void add(std::span<const ChannelRow> rows, std::span<const double> queries, TimingWindow& window);

/// Timing since the window was closed last; empties it.
/// now            [s; the same clock]
/// frame, update  counts so far
/// has_rate       whether frames come by the clock: no rate is told before it is so, nor after
Timing close(double now, bool has_rate, std::uint64_t frame, std::uint64_t update,
             TimingWindow& window);

}  // namespace thigma::live
