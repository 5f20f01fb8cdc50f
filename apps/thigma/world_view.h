#pragma once
// What pages are told of a world.

#include "viewer/server/messages.h"

#include "thigma/scene/world_scene.h"

namespace thigma::app {

/// Surfaces, names and starts of all bodies, and the hands; the world outlives the view.
/// page_hand  number of the hand that pages hold
live::SceneView view_of(const LoadedWorld& world, std::int32_t page_hand);

/// What the live server asks of a session beside its scene: rate, limits of the page's hand.
SessionConfig page_config(const LoadedWorld& world, const DeviceLimits& page);

}  // namespace thigma::app
