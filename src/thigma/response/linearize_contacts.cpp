#include "thigma/response/linearize_contacts.h"

#include <algorithm>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

static_assert(kMaxContactClusters <= kMaxClusters, "a cluster must find room in the model");

// Sum of depth + tolerance over the clusters that press.
double total_reach(const ContactClusters& clusters, double tolerance) noexcept {
  double sum = 0.0;
  for (const ContactCluster& c : clusters.clusters) sum += std::max(c.depth + tolerance, 0.0);
  return sum;
}

}  // namespace

LinearContactModel linearize_contacts(const ContactClusters& clusters, const PenaltyParams& params,
                                      const BodyState& state, double time,
                                      std::uint64_t sequence) noexcept {
  LinearContactModel model;
  model.state = state;
  model.time = time;
  model.sequence = sequence;
  const Mat3 body_from_world = rotation_matrix(state.orientation).transpose();
  const double total = total_reach(clusters, params.tolerance);
  const double equal_share =
      1.0 / static_cast<double>(std::max<std::size_t>(clusters.clusters.size(), 1));
  for (const ContactCluster& cluster : clusters.clusters) {
    const double reach = std::max(cluster.depth + params.tolerance, 0.0);
    const double shared =
        total > 0.0 ? reach / total : equal_share;  // all at -d: none can be preferred
    const double share = params.is_shared ? shared : 1.0;
    PlaneTerm term;
    term.arm_body = body_from_world * (cluster.point - state.position);
    term.normal = cluster.normal;
    term.scene_point = cluster.scene_point;
    term.tangential_anchor = cluster.scene_point;
    term.stiffness = share * params.stiffness;
    term.damping = share * params.damping;
    term.tolerance = params.tolerance;
    term.id = cluster.id;
    model.planes.push_back(term);
  }
  return model;
}

}  // namespace thigma
