#pragma once
// The hands of a world session: what their devices say, what they hold, what is sent.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/session/world_session.h"

namespace thigma::detail {

/// A hand of a session: its handle in the world, and what it has put in.
struct SessionHand {
  const World* world = nullptr;
  const WorldHand* config = nullptr;
  HapticDevice* device = nullptr;
  HandHold hold{};
  Coupling taken{};  // as it took hold, before fading
  WorldAim aim{};    // of a free one
  bool has_new_aim = false;
  WorkspaceAnchor anchor{};
  SafetyState safety{};
  Vec3 last_position = Vec3::Zero();
  Quat last_orientation = Quat::Identity();
  DeviceState sample{};
  std::uint64_t takings = 0;
  bool is_holding = false;
  bool has_finished = false;
};

/// All hands of a session. Its config outlives it.
struct SessionHands {
  std::vector<SessionHand> list;
  std::vector<HandHold> holds;  // of those that hold something
  std::vector<Motion> handles;
  std::vector<Wrench> commands;
  std::vector<WorldGrip> grips;

  SessionHands(const WorldSessionConfig& config, std::span<HapticDevice* const> devices);
};

/// What free hands take hold of.
void aim(const WorldAim& aim, SessionHands& hands) noexcept;

/// Reads all devices.
void sample_hands(double now, SessionHands& hands);

/// Hands take hold, move and let go as they were read; false where the session ends: a device has
/// finished or is at fault.
bool move_hands(double now, double dt, const WorldState& state, SessionHands& hands,
                WorldSummary& summary);

/// Sends what the hands feel, and counts it.
void write_hands(const WorldState& state, SessionHands& hands, WorldSummary& summary);

/// Bodies have other numbers: that of `was` is the old one, by the new; who held one that is gone
/// holds nothing. Hands and world are those of `next` from here on.
void renumber(const WorldSessionConfig& next, std::span<const std::int32_t> was,
              SessionHands& hands) noexcept;

/// Zero to every device, whatever another does.
void let_go(SessionHands& hands) noexcept;
/// Zero to one, null to none.
void let_go(HapticDevice* device) noexcept;

}  // namespace thigma::detail
