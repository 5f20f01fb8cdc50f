#pragma once
// One frame of the contact side under the potential response: from a pose to the springs of the
// haptic thread.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "thigma/contact/contact.h"
#include "thigma/response/linearize_contacts.h"
#include "thigma/response/overlap_area.h"
#include "thigma/response/textured_world.h"

namespace thigma {

/// What areas are measured on. Constant while a session runs.
struct PotentialWorld {
  SolidSurface object;
  Pose body_from_mesh;
  std::vector<SceneBody> bodies;
  std::vector<std::shared_ptr<const SolidSurface>> scene;  // one a body
  double reach = 0.0;  // of the object's farthest vertex from its centre of mass [m]
};

/// Surfaces of an object and of the bodies of a scene; bodies of one hierarchy without relief share
/// theirs.
///
/// body_from_mesh  of the object, its body frame at the centre of mass
/// textures        of the surfaces: where one has relief its fine surface is measured; empty: none
/// errors          std::invalid_argument for relief of more texels than make_solid_surface takes
/// Thread          [offline]; throws std::bad_alloc
PotentialWorld make_potential_world(const ClodHierarchy& object, const Pose& body_from_mesh,
                                    std::span<const SceneBody> bodies,
                                    const TexturedWorld& textures = {});

/// Working memory.
struct PotentialScratch {
  OverlapScratch object;
  std::vector<OverlapScratch> scene;  // one a body
};

/// Room for the surfaces of a world. Thread [offline]; throws std::bad_alloc.
void reserve_potential(const PotentialWorld& world, PotentialScratch& scratch);

/// How the law stands at a pose.
struct PotentialContact {
  PotentialMoments moments;
  std::int32_t body = -1;  // of the scene: the one that presses most
  OverlapStats stats;
};

/// Half the area is the object's inside the scene, half the scene's inside the object: neither
/// surface is preferred, and a tip is felt whichever body has it.
///
/// state      of the object
/// tolerance  d of the law [m]
/// scratch    reserved for the world
/// Thread     [contact]; no failure, nothing allocated.
PotentialContact measure_potential(const PotentialWorld& world, const BodyState& state,
                                   const PotentialLaw& law, double tolerance,
                                   PotentialScratch& scratch) noexcept;

/// Contact model of one frame: springs that are the law to second order at the stamp's state.
/// Thread    [contact]; no failure.
LinearContactModel potential_model(const PotentialContact& contact, const PenaltyParams& penalty,
                                   const PotentialLaw& law, const ModelStamp& stamp) noexcept;

}  // namespace thigma
