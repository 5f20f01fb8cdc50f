#include "thigma/contact/distribute_contacts.h"

#include <algorithm>
#include <cmath>

#include "thigma/contact/contact_node.h"
#include "thigma/contact/detail/shared_area.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

constexpr std::size_t kMostParts = 5;  // of a contact

HullView view_of_patch(const ClodHierarchy& hierarchy, std::int32_t patch) noexcept {
  const std::int32_t node = contact_node(hierarchy, patch);
  return node < 0 ? HullView{} : level_surface(hierarchy, node);
}

// While grazing, the way out does not depend on where the surfaces face each other. A
// patch smaller than the least width shares no wider area.
bool can_spread(const Contact& contact, const HullView& a, const HullView& b,
                double tolerance) noexcept {
  return a.triangle_count > 0 && b.triangle_count > 0 && contact.depth + tolerance > 0.0 &&
         std::min(a.radius, b.radius) >= kSpreadFrom * tolerance &&
         contact.status != ContactStatus::grazing;
}

// How much of a contact is divided: none where the area is no wider than a few tolerances, all
// where it is twice that.
double divided_part(const detail::SharedArea& area, double tolerance) noexcept {
  if (!(area.weight > 0.0)) return 0.0;
  const double width = std::sqrt(area.axis[0].squaredNorm() + area.axis[1].squaredNorm());
  const double least = kSpreadFrom * tolerance;
  if (!(width > least)) return 0.0;
  const double part = std::min(width / least - 1.0, 1.0);
  return part * part * (3.0 - 2.0 * part);
}

// The contact divided among four points whose mean and moments are those of the area; false where
// it stays whole.
bool divide(const Contact& contact, const detail::SharedArea& area, const Pose& world_from_object,
            double tolerance, std::vector<Contact>& spread) noexcept {
  const double part = divided_part(area, tolerance);
  if (!(part > 0.0)) return false;
  if (part < 1.0) {
    spread.push_back(contact);
    spread.back().weight *= 1.0 - part;
  }
  Contact c = contact;
  c.weight = contact.weight * part / 4.0;
  for (const Vec3& axis : area.axis) {
    for (const double side : {-std::sqrt(2.0), std::sqrt(2.0)}) {
      c.point = transform_point(world_from_object, area.middle + side * axis);
      c.scene_point = c.point - c.depth * c.normal;
      spread.push_back(c);
    }
  }
  return true;
}

}  // namespace

void distribute_contacts(const PlacedHierarchy& object, std::span<const SceneBody> scene,
                         std::span<const Contact> contacts, double tolerance,
                         std::vector<Contact>& spread) noexcept {
  spread.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& contact = contacts[i];
    const bool is_of_scene = contact.body >= 0 && idx(contact.body) < scene.size();
    const bool has_room =
        spread.size() + kMostParts + (contacts.size() - i - 1) <= spread.capacity();
    if (is_of_scene && has_room) {
      const SceneBody& body = scene[idx(contact.body)];
      const HullView a = view_of_patch(object.hierarchy, contact.object_patch);
      const HullView b = view_of_patch(*body.hierarchy, contact.scene_patch);
      if (can_spread(contact, a, b, tolerance)) {
        const RelativePose pose = relative_pose(object.world_from_body, body.world_from_body);
        const Vec3 normal = object.world_from_body.orientation.conjugate() * contact.normal;
        const detail::SharedArea area =
            detail::shared_area({a, b, pose}, normal, tolerance, kSpreadFrom * tolerance);
        if (divide(contact, area, object.world_from_body, tolerance, spread)) continue;
      }
    }
    if (spread.size() < spread.capacity()) spread.push_back(contact);
  }
}

}  // namespace thigma
