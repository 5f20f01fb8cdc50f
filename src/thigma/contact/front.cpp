#include "thigma/contact/front.h"

#include <algorithm>

#include "thigma/contact/detail/level_measure.h"
#include "thigma/contact/surface_crossing.h"

namespace thigma {
namespace {

// Contacts a query with a budget can hold; refinement stops there.
constexpr std::size_t kMostFound = 1 << 16;

// Longest way from the root, and the most children of a node.
void measure(const ClodHierarchy& h, std::int32_t& depth, std::int32_t& fan) {
  std::vector<std::int32_t> depths(h.nodes.size(), 0);
  depth = 0;
  fan = 1;
  for (std::size_t i = 0; i < h.nodes.size(); ++i) {
    const ClodNode& n = h.nodes[i];
    fan = std::max(fan, n.child_count);
    depth = std::max(depth, depths[i]);
    for (std::int32_t c = 0; c < n.child_count; ++c) {
      // children follow their parent
      depths[static_cast<std::size_t>(n.first_child + c)] = depths[i] + 1;
    }
  }
}

}  // namespace

std::int32_t default_front_capacity(const ClodHierarchy& object,
                                    const ClodHierarchy& scene) noexcept {
  // Fronts of conforming surfaces (jaws) need about one node a hierarchy node; four leave room for
  // worse.
  const std::size_t wanted = 4 * (object.nodes.size() + scene.nodes.size());
  return static_cast<std::int32_t>(std::clamp<std::size_t>(wanted, 4096, 2'000'000));
}

void reserve_front(ContactFront& front, const ClodHierarchy& object, const ClodHierarchy& scene,
                   std::int32_t capacity) {
  if (capacity <= 0) capacity = default_front_capacity(object, scene);
  std::int32_t fan_a = 1, fan_b = 1;
  measure(object, front.object_depth, fan_a);
  measure(scene, front.scene_depth, fan_b);
  front.stack_capacity =
      std::int64_t{front.object_depth + front.scene_depth + 2} * std::max(fan_a, fan_b);
  front.stack.reserve(static_cast<std::size_t>(front.stack_capacity));
  const auto n = static_cast<std::size_t>(capacity);
  if (capacity != front.capacity) {
    front.nodes = std::make_unique_for_overwrite<FrontNode[]>(n);
    front.expires = std::make_unique_for_overwrite<float[]>(n);
    front.capacity = capacity;
    for (std::vector<std::int32_t>* list :
         {&front.active, &front.next_active, &front.incoming, &front.work, &front.saturated}) {
      *list = {};
      list->reserve(n);
    }
    front.work.reserve(2 * n);  // expired nodes and the stack of a descent
  }
  front.pending.reserve(n + static_cast<std::size_t>(front.stack_capacity));
  if (!object.level_patches.empty() || !scene.level_patches.empty()) {
    front.queue.reserve(n);
    front.found.reserve(std::min(n, kMostFound));
    front.order.reserve(n);
    front.object_support = detail::largest_support(object);
    front.scene_support = detail::largest_support(scene);
  }
  front.object_closed = is_closed(object);
  front.scene_closed = is_closed(scene);
  front.object = &object;
  front.scene = &scene;
  clear_front(front);
}

void clear_front(ContactFront& front) noexcept {
  front.used = 0;
  front.free_head = -1;
  front.alive = 0;
  front.split = 0;
  front.travel = 0.0;
  front.last_step = 0.0;
  front.tolerance = -1.0;
  front.active.clear();
  front.next_active.clear();
  front.incoming.clear();
  front.work.clear();
  front.saturated.clear();
}

}  // namespace thigma
