#include "thigma/scene/start_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "thigma/contact/least_separation.h"
#include "thigma/core/error.h"
#include "thigma/loop/contact_step.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/math/infinity.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/scene/detail/winding_number.h"

namespace thigma {
namespace {

/// Distance queries for a body that is moved about. Exact: where a session starts does not depend
/// on whether its levels are there yet, and levels may stand apart where surfaces overlap.
struct Prober {
  ContactWorld world;  // own tolerance
  ContactScratch scratch;
  std::vector<SeparationScratch> separations;  // one a scene body
  double radius = 0.0;                         // of the object [m]
  double reach = 0.0;                          // farther apart than this nothing is looked for [m]
  double look_first = 0.0;                     // [m]
  // contacts are not of a traversal of the surfaces alone: of relief, or of another source
  bool is_vague = false;

  /// Whether one of the two lies in the solid of the other though their surfaces are apart.
  bool is_swallowed(const Pose& pose, const Contact& nearest) const {
    if (world.object == nullptr || nearest.body < 0 ||
        static_cast<std::size_t>(nearest.body) >= world.scene.size())
      return false;
    const SceneBody& body = world.scene[static_cast<std::size_t>(nearest.body)];
    const Pose world_from_mesh = pose * world.body_from_mesh;
    return detail::is_inside(*body.hierarchy,
                             transform_point(inverse(body.world_from_body), nearest.point)) ||
           detail::is_inside(*world.object,
                             transform_point(inverse(world_from_mesh), nearest.scene_point));
  }

  /// closest, where an object inside another is as deep as its way to the surface is long.
  std::optional<Contact> deepest(const Pose& pose) { return deepest(pose, closest(pose)); }
  std::optional<Contact> deepest(const Pose& pose, std::optional<Contact> nearest) const {
    if (!nearest || nearest->depth >= 0.0 || !is_swallowed(pose, *nearest)) return nearest;
    nearest->depth = -nearest->depth;
    nearest->normal = -nearest->normal;
    return nearest;
  }

  /// The deepest contact at a pose, looking farther and farther; nothing within `reach`: no value.
  std::optional<Contact> closest(const Pose& pose) {
    for (double tolerance = first_look(pose);; tolerance = kStep * separation()) {
      look(pose, std::min(tolerance, reach));
      const std::vector<Contact>& contacts = scratch.contacts.contacts;
      if (!contacts.empty()) {
        return *std::max_element(
            contacts.begin(), contacts.end(),
            [](const Contact& a, const Contact& b) { return a.depth < b.depth; });
      }
      if (tolerance >= reach) return std::nullopt;
    }
  }

  /// How far to look first: to the nearest two patches, where a search finds them. Surfaces that
  /// conform have a million pairs a little farther, and each farther look measures them again.
  double first_look(const Pose& pose) {
    if (is_vague || world.object == nullptr) return look_first;
    ContactSet unknown;
    unknown.dropped = 1;  // the search begins at the roots
    SeparationInterval nearest{.low = reach};
    for (std::size_t i = 0; i < world.scene.size(); ++i) {
      const SeparationInterval one = least_separation(
          {*world.object, pose * world.body_from_mesh},
          {*world.scene[i].hierarchy, world.scene[i].world_from_body}, unknown,
          {.tolerance = reach, .width = 0.0, .budget = kSearchBudget}, separations[i]);
      nearest.low = std::min(nearest.low, one.low);
      nearest.high = std::min(nearest.high, one.high);
    }
    const bool is_found = nearest.high <= kNear * nearest.low;
    const double looks = is_found ? (1.0 + kMargin) * nearest.high : nearest.low;
    return std::max(look_first, looks);
  }
  static constexpr std::int64_t kSearchBudget = 20'000;
  static constexpr double kNear = 2.0;
  static constexpr double kMargin = 1e-6;  // times the distance: more than it is rounded by

  // Small: surfaces that conform have a million pairs a little farther than the nearest.
  static constexpr double kStep = 1.02;

  /// How far the objects are apart at least, by the last query, which found nothing; where nobody
  /// can say, some more than that query looked [m].
  double separation() const {
    if (is_vague) return 1.5 * world.tolerance;
    double least = kInfinity;
    for (const ContactFront& front : scratch.fronts)
      least = std::min(least, unreported_separation(front));
    return std::max(std::min(least, reach), world.tolerance);
  }

  /// All contacts within a tolerance.
  void look(const Pose& pose, double tolerance) {
    StampedBody at;
    at.state.position = pose.position;
    at.state.orientation = pose.orientation;
    world.tolerance = tolerance;
    find_contacts(world, at, scratch);
  }

  /// Which way is out: the contacts' normals weighted by depth, as a hand would be pushed.
  Vec3 way_out() const {
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : scratch.contacts.contacts) {
      sum -= std::max(contact.depth + world.tolerance, 0.0) * contact.normal;
    }
    return sum;
  }
};

double extent(const ContactWorld& world, double object_radius) {
  double size = object_radius;
  for (const SceneBody& body : world.scene) size = std::max(size, body.hierarchy->radius);
  return size;
}

Prober make_prober(const ContactWorld& world) {
  Prober prober{world};
  prober.world.resolution = {};
  // Analytic scenes have no hierarchy to take a size from; their tolerance is about a hundredth of
  // it.
  prober.radius = world.object != nullptr ? world.object->radius : 100.0 * world.tolerance;
  prober.reach = 4.0 * extent(world, prober.radius);
  reserve_query(world, prober.scratch);
  prober.separations.resize(world.scene.size());
  return prober;
}

/// Moves the object out, by what is missing, until `wanted` is between it and the scene; the way it
/// went [m].
double move_out(Prober& prober, const Contact& deepest, double wanted, const Vec3& out,
                Pose& pose) {
  const Vec3 given = pose.position;
  double travel = 0.0;
  std::optional<Contact> nearest = deepest;
  while (nearest && -nearest->depth < wanted) {
    travel += std::max(wanted + nearest->depth, 0.05 * wanted);
    if (travel > prober.reach + wanted) {
      throw InputError("the objects overlap as given and cannot be moved apart along (" +
                       std::to_string(out.x()) + ", " + std::to_string(out.y()) + ", " +
                       std::to_string(out.z()) + "); expected a pose from which they can");
    }
    pose.position = given + travel * out;
    nearest = prober.deepest(pose);
  }
  return travel;
}

}  // namespace

StartPlacement find_start(const ContactWorld& world, const Pose& world_from_body, double gap,
                          const Vec3* way_out) {
  Prober prober = make_prober(world);
  StartPlacement start;
  start.world_from_body = world_from_body;
  start.clearance = 0.2 * prober.radius;
  const double tolerance = world.tolerance + relief_of(world.textures);
  const double wanted = std::max(gap > 0.0 ? gap : 0.1 * prober.radius, 3.0 * tolerance);

  prober.is_vague = !world.textures.is_empty() || world.source;
  prober.look_first = prober.is_vague ? wanted : 0.05 * tolerance;

  std::optional<Contact> nearest = prober.closest(start.world_from_body);
  if (!nearest) return start;
  const bool is_through = nearest->depth > 0.0;
  nearest = prober.deepest(start.world_from_body, nearest);
  start.has_scene = true;
  start.given_gap = -nearest->depth;
  Vec3 out = -nearest->normal;
  if (is_through) {
    prober.look(start.world_from_body, wanted);
    out = prober.way_out();
  }
  if (way_out != nullptr) out = *way_out;
  if (!(out.norm() > 0.0)) out = -nearest->normal;
  out.normalize();
  start.approach = -out;

  double travel = 0.0;
  if (start.given_gap < 2.0 * tolerance) {
    start.is_moved = true;
    travel = move_out(prober, *nearest, wanted, out, start.world_from_body);
  }

  // And back, by the distance there is: a surface at that distance or more is not passed.
  double back = 0.0;
  Pose pose = start.world_from_body;
  const double most = travel + prober.reach;
  while (back < most) {
    pose.position = start.world_from_body.position + back * start.approach;
    nearest = prober.closest(pose);
    if (!nearest) break;  // moving past: there is nothing that way
    const double distance = -nearest->depth;
    if (distance <= tolerance) break;
    back += std::max(distance - 0.5 * tolerance, 0.5 * tolerance);
  }
  start.clearance = back;
  return start;
}

StartPlacement place_at_start(const std::optional<Vec3>& approach, SessionConfig& config) {
  const Vec3 out = approach ? Vec3(-*approach) : Vec3::Zero();
  const StartPlacement start =
      find_start(config.contact, config.world_from_body, 0.0, approach ? &out : nullptr);
  config.world_from_body = start.world_from_body;
  return start;
}

DeviceContext device_context(const Workspace& workspace, const Vec3& approach, double clearance,
                             double object_radius, std::uint64_t seed) {
  DeviceContext context;
  context.approach = workspace.world_from_device.orientation.conjugate()._transformVector(approach);
  context.clearance = clearance / workspace.motion_scale;
  context.object_radius = object_radius / workspace.motion_scale;
  context.seed = seed;
  return context;
}

DeviceContext device_context(const SessionConfig& config, const StartPlacement& start,
                             double object_radius, std::uint64_t seed) {
  return device_context(config.haptic.workspace, start.approach, start.clearance, object_radius,
                        seed);
}

}  // namespace thigma
