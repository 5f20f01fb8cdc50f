#pragma once
// Small procedural meshes and the hand that touches them, for tests of the whole loop.

#include <memory>
#include <string>
#include <vector>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/device/hand.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/scene/start_placement.h"
#include "thigma/session/session.h"

namespace thigma::test {

/// A 10 g object of a few hundred triangles over a gently rippled sheet; contact 2 kN/m, as the
/// issue's closed loop.
struct MeshSession {
  ClodHierarchy object;
  ClodHierarchy ground;
  SessionConfig config;
  StartPlacement start;

  static TriangleMesh rippled_sheet() {
    TriangleMesh mesh = make_sheet(0.12, 0.12, 30, 30);
    for (Vec3& p : mesh.positions) p.z() = 2e-4 * sine(400.0 * p.x()) * cosine(350.0 * p.y());
    return mesh;
  }

  explicit MeshSession(double coupling_stiffness = 300.0,
                       const TriangleMesh& mesh = make_ball(0.015, 4))
      : object(build_exact_hierarchy(mesh)), ground(build_exact_hierarchy(rippled_sheet())) {
    const double mass = 0.010, radius = object.radius;
    const double moment = 0.4 * mass * radius * radius;
    config.haptic.body = make_body(mass, moment * Mat3::Identity());
    Coupling& c = config.haptic.coupling;
    c.linear_stiffness = coupling_stiffness;
    c.linear_damping = 2.0 * 0.7 * std::sqrt(coupling_stiffness * mass);
    c.angular_stiffness = 0.3 * coupling_stiffness * radius * radius;
    c.angular_damping = 2.0 * 0.7 * std::sqrt(c.angular_stiffness * moment);
    config.contact.object = &object;
    config.contact.scene = {{&ground, Pose{}}};
    config.contact.tolerance = 0.01 * radius;
    config.contact.response.stiffness = 2000.0;
    config.contact.response.damping = 2.0 * 0.7 * std::sqrt(2000.0 * mass);
    config.world_from_body.position.z() = radius + 0.003;
    start = find_start(config.contact, config.world_from_body);
    config.world_from_body = start.world_from_body;
  }
  MeshSession(const MeshSession&) = delete;
  MeshSession& operator=(const MeshSession&) = delete;

  HandParams hand(HandPath path, int dof = 6) const {
    HandParams h;
    h.senses_rotation = h.actuates_rotation = dof == 6;
    h.program.path = path;
    h.program.approach = start.approach;
    h.program.clearance = start.clearance;
    h.program = scale_to_object(h.program, object.radius);
    h.program.twist_by_buttons = dof == 3;
    return h;
  }
};

/// What a session told, kept.
struct Kept {
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  SessionSummary summary;

  Kept(const SessionConfig& config, HapticDevice& device) {
    summary = run_lockstep(config, device,
                           {[this](const HapticSample& s) { samples.push_back(s); },
                            [this](const ContactSample& s) { models.push_back(s); },
                            {}});
  }
};

}  // namespace thigma::test
