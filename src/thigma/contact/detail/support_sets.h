#pragma once
// Closest points of two disjoint hulls from the vertices that support them, bit-identical however
// these were found.

#include "thigma/convex/gjk.h"
#include "thigma/convex/hull_view.h"

namespace thigma::detail {

// Times the sum of the radii. Distances below kNear leave the direction too uncertain for kActive,
// which has to be far above the rounding of a height (1e-16 / kNear = 1e-10) and far below the
// height of a real neighbour.
inline constexpr double kNear = 1e-6;
inline constexpr double kActive = 1e-8;

/// Two hulls about the centre of a.
struct Placement {
  const HullView& a;
  const HullView& b;
  const RelativePose& pose;
  Vec3 offset;  // from the centre of a to that of b [m; frame of a]
  double size;  // sum of the radii [m]

  Placement(const HullView& hull_a, const HullView& hull_b, const RelativePose& x)
      : a(hull_a),
        b(hull_b),
        pose(x),
        offset(x.rotation * b.center + x.translation - a.center),
        size(a.radius + b.radius) {}
  Vec3 of_a(int i) const noexcept { return a.vertices[i] - a.center; }
  Vec3 of_b(int i) const noexcept { return pose.rotation * (b.vertices[i] - b.center) + offset; }
};

/// Masks of hull vertices.
struct SupportSets {
  std::uint32_t a = 0, b = 0;
};

/// The vertices within kActive of the two planes across the line from p to q, both about the centre
/// of a.
SupportSets support_sets(const Placement& place, const Vec3& p, const Vec3& q) noexcept;

/// Which features count: those of the original surface, or all of the hull.
enum class Features : std::uint8_t { real, any };

struct SupportedDistance {
  double distance = 0.0;                    // [m]
  Vec3 p = Vec3::Zero(), q = Vec3::Zero();  // closest points about the centre of a [m; frame of a]
  Vec3 normal = Vec3::UnitZ();              // unit, from p to q
};

/// Closest points by a closed form in the vertices of the sets, taken in order, when these prove to
/// be the support sets of the hulls: a vertex, an edge or a face on each side, not both more than a
/// vertex unless two crossing edges, the points well inside them, and farther apart than kNear.
/// False otherwise: then the closest points may not be unique. Thread [contact]; no failure, no
/// allocation.
bool closest_by_support(const Placement& place, const SupportSets& sets, Features features,
                        SupportedDistance& out) noexcept;

}  // namespace thigma::detail
