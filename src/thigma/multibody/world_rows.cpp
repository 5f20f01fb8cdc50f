#include "thigma/multibody/world_rows.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma {
namespace {

/// Where the first body of a pair is in the frame of the second, and that in the world.
struct PairPlace {
  Vec3 position;
  Mat3 rotation, world_from_second;
  Vec3 second;  // centre of mass [m; world]
};

WorldRow row_of(const detail::NearPair& pair, std::size_t number, const PairPlace& place,
                const RowAtState& at, double dt) noexcept {
  const ContactRow& model = pair.model.rows[number];
  WorldRow row;
  row.a = pair.first;
  row.b = pair.second;
  row.kind = model.kind;
  row.gap = at.gap;
  row.friction = model.friction.kinetic;
  row.normal = place.world_from_second * at.normal;
  Vec3 point = place.position + at.arm;
  // The arm ends on the first body's feature but for its planes, where it ends on the other's.
  if (model.kind == RowKind::object_plane) point -= at.gap * at.normal;
  row.point = place.second + place.world_from_second * point;
  const TangentPair across = tangents_of(at.normal);
  const Vec3& impulse = pair.history[number].impulse;
  row.force = -1.0 / dt *
              (place.world_from_second * (impulse.x() * at.normal + impulse.y() * across.first +
                                          impulse.z() * at.normal.cross(across.first)));
  return row;
}

}  // namespace

std::size_t read_rows(const WorldState& state, const WorldScratch& scratch, double dt,
                      std::size_t most, std::vector<WorldRow>& rows) {
  rows.clear();
  for (const detail::NearPair* pair : scratch.pairs.near) {
    const BodyState &first = state.bodies[idx(pair->first)],
                    &second = state.bodies[idx(pair->second)];
    const BodyState relative = detail::relative_state(first, second);
    const PairPlace place{relative.position, rotation_matrix(relative.orientation),
                          rotation_matrix(second.orientation), second.position};
    for (std::size_t i = 0; i < pair->model.rows.size(); ++i) {
      const RowAtState at = row_at(pair->model.rows[i], place.position, place.rotation);
      if (std::isfinite(at.gap)) rows.push_back(row_of(*pair, i, place, at, dt));
    }
  }
  const auto before = [](const WorldRow& x, const WorldRow& y) {
    if (x.presses() != y.presses()) return x.presses();
    return x.presses() ? x.force.squaredNorm() > y.force.squaredNorm() : x.gap < y.gap;
  };
  const std::size_t all = rows.size();
  std::stable_sort(rows.begin(), rows.end(), before);
  rows.resize(std::min(all, most));
  return all;
}

}  // namespace thigma
