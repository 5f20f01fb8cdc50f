#include "thigma/contact/front.h"

#include <algorithm>

#include "thigma/contact/detail/carry_contacts.h"
#include "thigma/contact/multires/measure_pair.h"
#include "thigma/contact/surface_crossing.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

// Contacts a query with a budget can hold; refinement stops there.
constexpr std::size_t kMostFound = 1 << 16;
// Contacts that can be carried; others are measured each frame.
constexpr std::size_t kMostCarried = 1 << 16;

// Longest path from the root, and the most children of a node.
struct TreeExtent {
  std::int32_t depth = 0, fan = 1;
};

TreeExtent extent_of(const ClodHierarchy& hierarchy) {
  std::vector<std::int32_t> depths(hierarchy.nodes.size(), 0);
  TreeExtent extent;
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i) {
    const ClodNode& node = hierarchy.nodes[i];
    extent.fan = std::max(extent.fan, node.child_count);
    extent.depth = std::max(extent.depth, depths[i]);
    for (std::int32_t c = 0; c < node.child_count; ++c) {
      // children follow their parent
      depths[idx(node.first_child + c)] = depths[i] + 1;
    }
  }
  return extent;
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
  const TreeExtent a = extent_of(object), b = extent_of(scene);
  const std::size_t stack = idx(a.depth + b.depth + 2) * idx(std::max(a.fan, b.fan));
  ExactFront& exact = front.exact;
  MultiresFront& multires = front.multires;
  exact.stack.reserve(stack);
  const auto n = static_cast<std::size_t>(capacity);
  if (capacity != front.capacity) {
    front.nodes = std::make_unique_for_overwrite<FrontNode[]>(n);
    front.expires = std::make_unique_for_overwrite<float[]>(n);
    front.capacity = capacity;
    front.carried = {};
    for (std::vector<std::int32_t>* list :
         {&exact.active, &exact.next_active, &exact.incoming, &front.work, &exact.saturated}) {
      *list = {};
      list->reserve(n);
    }
    front.work.reserve(2 * n);  // expired nodes and the stack of a descent
  }
  multires.pending.reserve(n + stack);
  if (!object.level_patches.empty() || !scene.level_patches.empty()) {
    multires.queue.reserve(n);
    multires.found.reserve(std::min(n, kMostFound));
    multires.order.reserve(n);
    multires.object_support = detail::support_of_nodes(object);
    multires.scene_support = detail::support_of_nodes(scene);
  }
  front.object_closed = is_closed(object);
  front.scene_closed = is_closed(scene);
  front.object = &object;
  front.scene = &scene;
  clear_front(front);
}

void reserve_carried(ContactFront& front) {
  CarriedContacts& carried = front.carried;
  const auto nodes = idx(front.capacity);
  const std::size_t most = std::min(nodes, kMostCarried);
  carried.place = std::make_unique<std::int32_t[]>(nodes);
  carried.contacts.resize(most);
  carried.free.reserve(most);
  carried.held.reserve(most);
  std::fill_n(carried.place.get(), nodes, -1);
  detail::forget_carried(front);
}

void clear_front(ContactFront& front) noexcept {
  detail::forget_carried(front);
  front.used = 0;
  front.free_head = -1;
  front.alive = 0;
  front.split = 0;
  front.travel = 0.0;
  front.last_step = 0.0;
  front.tolerance = -1.0;
  front.exact.active.clear();
  front.exact.next_active.clear();
  front.exact.incoming.clear();
  front.work.clear();
  front.exact.saturated.clear();
}

}  // namespace thigma
