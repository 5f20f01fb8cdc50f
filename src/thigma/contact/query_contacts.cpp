#include "thigma/contact/query_contacts.h"

#include <algorithm>
#include <limits>

#include "thigma/contact/exact/exact_query.h"
#include "thigma/contact/multires/multires_query.h"
#include "thigma/math/infinity.h"

namespace thigma {
namespace {

// Of a set that nobody gave room: more than hands and eyes tell apart.
constexpr std::size_t kContactRoom = 4096;

bool is_answerable(const detail::QueryFrame& frame) noexcept {
  return !frame.object.nodes.empty() && !frame.scene.nodes.empty() &&
         frame.query.tolerance >= 0.0 && frame.pose.rotation.allFinite() &&
         frame.pose.translation.allFinite();
}

}  // namespace

void query_contacts(const PlacedHierarchy& object, const PlacedHierarchy& scene,
                    const ContactQuery& query, ContactFront& front, ContactSet& contacts) noexcept {
  if (contacts.contacts.capacity() == 0) contacts.contacts.reserve(kContactRoom);
  detail::QueryFrame frame = detail::make_frame(object, scene, query, front, contacts);
  if (!is_answerable(frame)) return;
  if (query.resolution.is_exact)
    detail::query_exact(frame);
  else
    detail::query_multires(frame);
}

void query_scene(const PlacedHierarchy& object, std::span<const SceneBody> bodies,
                 const ContactQuery& query, std::span<ContactFront> fronts,
                 ContactSet& contacts) noexcept {
  clear(contacts);
  ContactQuery one = query;
  const std::size_t count = std::min(bodies.size(), fronts.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (bodies[i].hierarchy == nullptr) continue;
    one.body = static_cast<std::int32_t>(i);
    query_contacts(object, {*bodies[i].hierarchy, bodies[i].world_from_body}, one, fronts[i],
                   contacts);
  }
}

double unreported_separation(const ContactFront& front) noexcept {
  if (front.tolerance < 0.0) return kInfinity;
  if (!front.has_levels && !front.exact.saturated.empty()) return front.tolerance;
  float first = std::numeric_limits<float>::infinity();
  for (std::int32_t i = 0; i < front.used; ++i) {
    if (!(front.expires[i] < first)) continue;
    const FrontNode& node = front.nodes[i];
    const bool is_culled = !front.has_levels || node.decision == FrontNode::Decision::apart;
    if (node.a >= 0 && node.first_child < 0 && is_culled) first = front.expires[i];
  }
  const double proven = front.tolerance + std::max(static_cast<double>(first) - front.travel, 0.0);
  return front.has_levels ? std::min(proven, front.multires.unremembered) : proven;
}

double least_distance(const ContactSet& contacts) noexcept {
  double least = kInfinity;
  for (const Contact& c : contacts.contacts) least = std::min(least, -c.depth);
  return least;
}

}  // namespace thigma
