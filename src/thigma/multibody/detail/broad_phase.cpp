#include "thigma/multibody/detail/broad_phase.h"

#include <algorithm>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

BroadPhase::Swept sweep(const ShapeBox& box, const BodyState& state, double margin) noexcept {
  const Mat3 rotation = rotation_matrix(state.orientation);
  const Vec3 middle = state.position + rotation * box.middle;
  const Vec3 half = rotation.cwiseAbs() * box.half + Vec3::Constant(margin);
  return {middle - half, middle + half};
}

bool overlap(const BroadPhase::Swept& a, const BroadPhase::Swept& b) noexcept {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// Nearly sorted from the step before.
void sort_by_low(BroadPhase& broad) noexcept {
  std::vector<std::int32_t>& order = broad.order;
  const auto key = [&](std::int32_t i) { return broad.boxes[idx(i)].low.x(); };
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::int32_t moved = order[i];
    std::size_t k = i;
    for (; k > 0 && key(order[k - 1]) > key(moved); --k) order[k] = order[k - 1];
    order[k] = moved;
  }
}

}  // namespace

void find_pairs(const World& world, const WorldState& state, std::span<const double> margins,
                std::span<const std::uint8_t> moves, BroadPhase& broad) {
  const std::size_t count = world.bodies.size();
  broad.boxes.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    broad.boxes[i] = sweep(world.boxes[idx(world.shape[i])], state.bodies[i], margins[i]);
  if (broad.order.size() != count) {
    broad.order.resize(count);
    for (std::size_t i = 0; i < count; ++i) broad.order[i] = static_cast<std::int32_t>(i);
  }
  sort_by_low(broad);
  broad.pairs.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t first = broad.order[i];
    const BroadPhase::Swept& box = broad.boxes[idx(first)];
    for (std::size_t k = i + 1; k < count; ++k) {
      const std::int32_t second = broad.order[k];
      const BroadPhase::Swept& other = broad.boxes[idx(second)];
      if (other.low.x() > box.high.x()) break;
      if (moves[idx(first)] == 0 && moves[idx(second)] == 0) continue;
      if (overlap(box, other) && !never_touch(world, first, second))
        broad.pairs.push_back({std::min(first, second), std::max(first, second)});
    }
  }
  std::sort(broad.pairs.begin(), broad.pairs.end());
}

}  // namespace thigma::detail
