#pragma once
// What keeps the bodies of a world apart after a step, for whoever shows or records it.

#include <cstdint>
#include <vector>

#include "thigma/multibody/step_world.h"

namespace thigma {

/// A row between two bodies, where they are after a step.
struct WorldRow {
  std::int32_t a = -1, b = -1;  // bodies
  RowKind kind = RowKind::scene_plane;
  Vec3 point = Vec3::Zero();    // of a, where the two features are nearest [m; world]
  Vec3 normal = Vec3::UnitZ();  // unit, out of a, into b: point + gap normal is of b [world]
  double gap = 0.0;             // [m]
  Vec3 force = Vec3::Zero();    // on a, friction included, mean of the step; 0: does not press [N]
  double friction = 0.0;        // Coulomb's coefficient of the two, kinetic

  bool presses() const noexcept { return force != Vec3::Zero(); }
};

/// Rows of all pairs that are near each other: those that press, the strongest first, then the
/// nearest. Bodies that sleep with all they touch have none.
///
/// state, scratch  after step_world, which has made a step of dt [s]
/// most            rows wanted at most
/// rows            overwritten
/// returns         how many there are in all
/// Thread          [contact]; throws std::bad_alloc where rows grow
std::size_t read_rows(const WorldState& state, const WorldScratch& scratch, double dt,
                      std::size_t most, std::vector<WorldRow>& rows);

}  // namespace thigma
