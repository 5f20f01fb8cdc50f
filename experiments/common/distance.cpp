#include "experiments/common/distance.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

#include "thigma/convex/gjk.h"
#include "thigma/convex/patch_separation.h"

namespace thigma::experiments {
namespace {

struct Candidate {
  double bound = 0.0;  // the surfaces below are at least this far apart [m]
  std::int32_t a = 0, b = 0;
  bool operator<(const Candidate& other) const { return bound > other.bound; }
};

const ClodNode& node_of(const ClodHierarchy& h, std::int32_t node) {
  return h.nodes[static_cast<std::size_t>(node)];
}

}  // namespace

double least_distance(const ClodHierarchy& object, const Pose& world_from_object,
                      const ClodHierarchy& scene, const Pose& world_from_scene) {
  const RelativePose pose = relative_pose(world_from_object, world_from_scene);
  double best = std::numeric_limits<double>::infinity();
  std::priority_queue<Candidate> open;
  auto consider = [&](std::int32_t a, std::int32_t b) {
    const ClodNode &na = node_of(object, a), &nb = node_of(scene, b);
    const HullView va = hull_view(object, a), vb = hull_view(scene, b);
    GjkCache cache;
    if (na.child_count == 0 && nb.child_count == 0) {
      const PatchSeparation s = patch_separation({va, vb, pose}, best, cache);
      best = std::min(best, s.intersecting ? 0.0 : s.distance);
      return;
    }
    const double outside = na.hausdorff + nb.hausdorff;
    if (spheres_separate(va, vb, pose, best + outside)) return;
    const double bound = closest_points(va, vb, pose, best + outside, cache).distance - outside;
    if (bound < best) open.push({bound, a, b});
  };
  consider(0, 0);
  while (!open.empty() && open.top().bound < best) {
    const Candidate c = open.top();
    open.pop();
    const ClodNode &na = node_of(object, c.a), &nb = node_of(scene, c.b);
    const bool splits_a = nb.child_count == 0 || (na.child_count > 0 && na.radius >= nb.radius);
    const ClodNode& split = splits_a ? na : nb;
    for (std::int32_t i = 0; i < split.child_count; ++i) {
      splits_a ? consider(split.first_child + i, c.b) : consider(c.a, split.first_child + i);
    }
  }
  return best;
}

Placed place_at_distance(const ClodHierarchy& object, const Pose& start, const Vec3& direction,
                         const ClodHierarchy& scene, double wanted, double tolerance) {
  Placed placed{start, false};
  const double most = 8.0 * (object.radius + scene.radius);
  double travel = 0.0;
  for (int i = 0; i < 2000 && travel < most; ++i) {
    const double missing = least_distance(object, placed.pose, scene, Pose{}) - wanted;
    if (missing <= tolerance) {
      placed.is_met = true;
      return placed;
    }
    travel += missing;  // the distance falls by no more than the way gone
    placed.pose.position += missing * direction;
  }
  return {start, false};
}

}  // namespace thigma::experiments
