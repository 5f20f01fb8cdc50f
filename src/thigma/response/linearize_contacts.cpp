#include "thigma/response/linearize_contacts.h"

#include <algorithm>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

static_assert(kMaxContactClusters <= kMaxClusters, "a cluster must find room in the model");

// How much of a cluster is there: below 1 where all it has are a few contacts that are being
// blended in or out. Its weight over its reach is a lone contact's own weight, and never below 1
// for contacts of weight 1; one that does not press yet may before the next model.
double presence(const ContactCluster& cluster, double reach) noexcept {
  constexpr double kRounding = 1e-9;
  if (!(reach > 0.0)) return std::min(cluster.blend, 1.0);
  return cluster.weight < (1.0 - kRounding) * reach ? cluster.weight / reach : 1.0;
}

// depth + tolerance of a cluster that presses, as far as it is there.
double present_reach(const ContactCluster& cluster, double tolerance) noexcept {
  const double reach = std::max(cluster.depth + tolerance, 0.0);
  return presence(cluster, reach) * reach;
}

// How much of everything that presses is there: 1 where one cluster is, and where several together
// are, each as far as it reaches beside the one that counts most. Shares of the stiffness add up to
// it: a contact of no weight presses with nothing also where it is alone.
double presence_of_all(const ContactClusters& clusters, double tolerance,
                       double other_reach) noexcept {
  double most = other_reach;
  for (const ContactCluster& c : clusters.clusters)
    most = std::max(most, present_reach(c, tolerance));
  if (!(most > 0.0)) return 1.0;
  double sum = other_reach / most;
  for (const ContactCluster& c : clusters.clusters) {
    const double reach = std::max(c.depth + tolerance, 0.0);
    sum += presence(c, reach) * std::min(reach / most, 1.0);
  }
  return std::min(sum, 1.0);
}

}  // namespace

double total_indentation(const ContactClusters& clusters, double tolerance) noexcept {
  double sum = 0.0;
  for (const ContactCluster& c : clusters.clusters) sum += present_reach(c, tolerance);
  return sum;
}

LinearContactModel linearize_contacts(const ContactClusters& clusters, const PenaltyParams& params,
                                      const ModelStamp& stamp, double other_reach) noexcept {
  const BodyState& state = stamp.state;
  LinearContactModel model;
  model.state = state;
  model.time = stamp.time;
  model.sequence = stamp.sequence;
  const Mat3 body_from_world = rotation_matrix(state.orientation).transpose();
  const double total = total_indentation(clusters, params.tolerance) + other_reach;
  const double there = presence_of_all(clusters, params.tolerance, other_reach);
  const double equal_share =
      1.0 / static_cast<double>(std::max<std::size_t>(clusters.clusters.size(), 1));
  for (const ContactCluster& cluster : clusters.clusters) {
    const double reach = present_reach(cluster, params.tolerance);
    const double alone = presence(cluster, std::max(cluster.depth + params.tolerance, 0.0));
    // all at -d: none can be preferred
    const double shared = total > 0.0 ? there * reach / total : alone * equal_share;
    const double share = params.is_divided_among_clusters ? shared : alone;
    PlaneTerm term;
    term.arm_body = body_from_world * (cluster.point - state.position);
    term.normal = cluster.normal;
    term.scene_point = cluster.scene_point;
    term.stiffness = share * params.stiffness;
    term.damping = share * params.damping;
    term.tolerance = params.tolerance;
    term.id = cluster.id;
    term.body = cluster.body;
    model.planes.push_back(term);
  }
  return model;
}

}  // namespace thigma
