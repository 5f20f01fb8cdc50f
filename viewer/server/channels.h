#pragma once
// The columns of `channels` (docs/protocol.md), one list: the page's list of them and the rows
// follow it.

#include <array>
#include <string_view>

#include "thigma/loop/samples.h"

namespace thigma::live {

/// A haptic frame as channels have it.
struct ChannelSource {
  const HapticSample& sample;
  Wrench felt;         // on the hand [world axes, device size]
  double state = 0.0;  // of StateBit
};

/// A column.
struct Channel {
  std::string_view name, unit;
  double (*value)(const ChannelSource& s);
};

inline constexpr auto kChannelList = std::to_array<Channel>({
    {"t", "s", [](const ChannelSource& s) { return s.sample.time; }},  // as its own number of a row
    {"force_x", "N", [](const ChannelSource& s) { return s.felt.force.x(); }},
    {"force_y", "N", [](const ChannelSource& s) { return s.felt.force.y(); }},
    {"force_z", "N", [](const ChannelSource& s) { return s.felt.force.z(); }},
    {"torque_x", "N m", [](const ChannelSource& s) { return s.felt.torque.x(); }},
    {"torque_y", "N m", [](const ChannelSource& s) { return s.felt.torque.y(); }},
    {"torque_z", "N m", [](const ChannelSource& s) { return s.felt.torque.z(); }},
    {"penetration", "m", [](const ChannelSource& s) { return s.sample.penetration; }},
    {"stretch", "m",
     [](const ChannelSource& s) { return s.sample.is_grasped ? s.sample.stretch : 0.0; }},
    {"energy", "J", [](const ChannelSource& s) { return s.sample.energy; }},
    {"model_age", "s", [](const ChannelSource& s) { return s.sample.model_age; }},
    {"step_cpu", "s",
     [](const ChannelSource& s) { return static_cast<double>(s.sample.step_cpu); }},
    {"wake_late", "s",
     [](const ChannelSource& s) { return static_cast<double>(s.sample.wake_late); }},
    {"speed", "m/s",
     [](const ChannelSource& s) { return s.sample.device.motion.twist.linear.norm(); }},
    {"touching", "1",
     [](const ChannelSource& s) { return static_cast<double>(s.sample.touching); }},
    {"state", "1", [](const ChannelSource& s) { return s.state; }},
});
inline constexpr std::size_t kChannels = kChannelList.size();

}  // namespace thigma::live
