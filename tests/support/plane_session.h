#pragma once
// A session without meshes: a small cube over the half space z <= 0, for tests of everything but
// the contact query.

#include <memory>

#include "thigma/device/hand.h"
#include "thigma/session/session.h"

namespace thigma::test {

inline constexpr double kCubeHalf = 0.02;  // [m]

/// Contacts of the cube's corners with the plane z = 0, as the exact query would give them.
inline void plane_contacts(const Pose& world_from_mesh, double tolerance, ContactSet& set) {
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 local((corner & 1) ? kCubeHalf : -kCubeHalf, (corner & 2) ? kCubeHalf : -kCubeHalf,
                     (corner & 4) ? kCubeHalf : -kCubeHalf);
    Contact contact;
    contact.point = transform_point(world_from_mesh, local);
    if (contact.point.z() > tolerance) continue;
    contact.scene_point = {contact.point.x(), contact.point.y(), 0.0};
    contact.normal = -Vec3::UnitZ();
    contact.depth = -contact.point.z();
    contact.object_patch = corner;
    contact.scene_patch = 0;
    if (set.contacts.size() == set.contacts.capacity()) {
      ++set.dropped;
      continue;
    }
    set.contacts.push_back(contact);
  }
}

/// The cube, 10 g, `gap` above the plane; contact 2 kN/m, coupling 300 N/m.
inline SessionConfig plane_session(double gap = 0.005) {
  SessionConfig config;
  const double mass = 0.010;
  const double moment = mass * 4.0 * kCubeHalf * kCubeHalf / 6.0;
  config.haptic.body = make_body(mass, moment * Mat3::Identity());
  config.haptic.coupling.linear_stiffness = 300.0;
  config.haptic.coupling.linear_damping = 2.0;
  config.haptic.coupling.angular_stiffness = 0.3;
  config.haptic.coupling.angular_damping = 5e-4;
  config.contact.source = plane_contacts;
  config.contact.tolerance = 2e-4;
  config.contact.max_clusters = 5;
  config.contact.response.stiffness = 2000.0;
  config.contact.response.damping = 1.0;
  config.contact.capacity = 64;
  config.world_from_body.position = {0.0, 0.0, kCubeHalf + gap};
  config.duration = 1.0;
  return config;
}

/// A hand above the plane that runs `path` over the gap of plane_session.
inline HandParams plane_hand(HandPath path, double gap = 0.005) {
  HandParams hand;
  hand.program.path = path;
  hand.program.clearance = gap;
  return hand;
}

/// A device under the test's control.
class HeldDevice final : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return device_limits; }
  std::string name() const override { return "held"; }
  DeviceState read(double now) THIGMA_RT override {
    state.time = now;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override {
    written = wrench;
    ++writes;
  }

  DeviceLimits device_limits{.holds_person = false};
  DeviceState state;
  Wrench written;
  int writes = 0;
};

}  // namespace thigma::test
