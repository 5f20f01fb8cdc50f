#pragma once
// Bodies that come to a world and leave it while it goes on.

#include <cstdint>
#include <optional>
#include <vector>

#include "thigma/scene/world_scene.h"

namespace thigma {

/// A world with one body more or less.
struct WorldChange {
  LoadedWorld world;
  std::vector<std::int32_t> was;  // by body: its number before; -1: it is new
};

/// The same world with another body like one of it, last in the order and at rest at the start.
///
/// like     number of a body; joints of that one do not tie the other
/// center   of mass [m; world]; where it is left out above all that is there in `state`
/// state    of the world as it is
/// errors   InputError by name: a body that stands still, one more than a world may have, a center
///          far beyond all that is there
/// Thread   [offline]
WorldChange with_another(const LoadedWorld& world, std::int32_t like,
                         const std::optional<Vec3>& center, const WorldState& state);

/// The same world without a body.
/// errors   InputError by name: one that stands still, that a joint ties or that a device holds
/// Thread   [offline]
WorldChange without(const LoadedWorld& world, std::int32_t body);

/// The state of a changed world: bodies go on as they were, awake, and a new one is at its start.
///
/// before   of the world it was made of
/// errors   InputError with both names where bodies are in each other
/// Thread   [offline]
WorldState carried_state(const WorldChange& change, const WorldState& before);

}  // namespace thigma
