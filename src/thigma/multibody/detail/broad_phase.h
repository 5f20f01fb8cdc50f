#pragma once
// Pairs of bodies whose boxes, swept by as far as they may go, overlap.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/multibody/world.h"

namespace thigma::detail {

/// Two bodies, the lower number first.
struct BodyPairIndex {
  std::int32_t a = -1, b = -1;
  friend auto operator<=>(const BodyPairIndex&, const BodyPairIndex&) = default;
};

/// Working memory: grows while warming up, never after. `order` is kept from call to call.
struct BroadPhase {
  struct Swept {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  };
  std::vector<Swept> boxes;
  std::vector<std::int32_t> order;   // by the boxes' first coordinate
  std::vector<BodyPairIndex> pairs;  // result, sorted
};

/// Pairs that may come within their margins of each other, one of which moves and is awake.
///
/// margins  by body: how far any of its points may go, and what has to be looked ahead [m]
/// moves    by body: whether it is awake and not fixed
void find_pairs(const World& world, const WorldState& state, std::span<const double> margins,
                std::span<const std::uint8_t> moves, BroadPhase& broad);

}  // namespace thigma::detail
