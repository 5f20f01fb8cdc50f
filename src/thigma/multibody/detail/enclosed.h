#pragma once
// Whether a surface lies wholly inside another, clear of it: what a search for surfaces that are
// near each other does not see.

#include <array>
#include <optional>
#include <vector>

#include "thigma/constraint/surface_features.h"
#include "thigma/multibody/world.h"

namespace thigma::detail {

/// A place on a surface, and the way out of it [mesh frame].
struct SurfaceProbe {
  Vec3 point = Vec3::Zero();  // [m]
  Vec3 normal = Vec3::UnitZ();
};

/// What the test needs of a surface.
struct ShapeParts {
  bool is_closed = false;  // else it has no inside
  // Of each connected part the middles of its outermost triangles, along each axis to and fro.
  std::vector<std::array<SurfaceProbe, 6>> parts;
};

/// Parts of a surface.
/// Thread    [offline]; throws std::bad_alloc.
ShapeParts find_parts(const BodyShape& shape, const SurfaceFeatures& features);

/// Parts of the shapes that were asked for, each once.
class PartsOfShapes {
 public:
  explicit PartsOfShapes(const World& world) : world_(world), known_(world.shapes.size()) {}
  /// shape     of a pair kind
  /// Thread    [offline]; throws std::bad_alloc.
  const ShapeParts& of(std::int32_t shape);

 private:
  const World& world_;
  std::vector<std::optional<ShapeParts>> known_;
};

/// Whether a part of one body's surface lies inside another body's closed one. Rays from its
/// outermost triangles count how often they leave the other; a place that touches it has no say,
/// the others vote.
///
/// inner, outer  bodies whose surfaces are not through each other
/// Thread        [offline]; throws std::bad_alloc.
bool is_enclosed(const World& world, const WorldState& state, std::int32_t inner,
                 std::int32_t outer, PartsOfShapes& parts);

}  // namespace thigma::detail
