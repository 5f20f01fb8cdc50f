#include "thigma/contact/clustering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "thigma/math/infinity.h"

// Sec. 5.4.2: Lloyd's method on the contact points, each weighing depth + d. Old clusters seed new
// ones by closest pairs, further seeds are the furthest contacts. Distances are kept in arrays of
// their own, cluster by cluster, so that a pass over tens of thousands of contacts is a few vector
// instructions each.

namespace thigma {
namespace {

constexpr int kMaxIterations = 100;  // of Lloyd's method; a warm start needs a few

// Length of a mean of unit normals below which they oppose each other: rounding of the mean, no
// direction left.
constexpr double kOpposing = 1e-9;

struct Seeds {
  std::array<double, kMaxContactClusters> x{}, y{}, z{};
  int count = 0;
};

double squared_distance(const ClusterScratch& scratch, std::size_t i, const Vec3& p) noexcept {
  const double dx = scratch.x[i] - p.x();
  const double dy = scratch.y[i] - p.y();
  const double dz = scratch.z[i] - p.z();
  return dx * dx + dy * dy + dz * dz;
}

void load(std::span<const Contact> contacts, double tolerance, ClusterScratch& scratch) noexcept {
  const std::size_t n = contacts.size();
  if (scratch.x.size() < n) reserve_clusters(scratch, n);
  scratch.assignment.resize(n);
  scratch.candidate.resize(n);
  scratch.seeds.clear();
  scratch.seed_ids.clear();
  for (std::size_t i = 0; i < n; ++i) {
    const Contact& c = contacts[i];
    scratch.x[i] = c.point.x();
    scratch.y[i] = c.point.y();
    scratch.z[i] = c.point.z();
    scratch.weight[i] = c.weight * std::max(c.depth + tolerance, 0.0);
    scratch.taken[i] = 0;
    scratch.nearest[i] = kInfinity;
  }
}

struct Nearest {
  double squared = kInfinity;
  std::int32_t contact = -1;
};

Nearest nearest_free_contact(const ClusterScratch& scratch, std::size_t n, const Vec3& p) noexcept {
  Nearest best;
  for (std::size_t i = 0; i < n; ++i) {
    const double d2 = squared_distance(scratch, i, p);
    if (d2 < best.squared && !scratch.taken[i]) best = {d2, static_cast<std::int32_t>(i)};
  }
  return best;
}

void take(ClusterScratch& scratch, std::int32_t contact, std::int32_t id, Seeds& seeds) noexcept {
  const auto c = static_cast<std::size_t>(contact);
  scratch.taken[c] = 1;
  scratch.seeds.push_back(contact);
  scratch.seed_ids.push_back(id);
  const auto k = static_cast<std::size_t>(seeds.count++);
  seeds.x[k] = scratch.x[c];
  seeds.y[k] = scratch.y[c];
  seeds.z[k] = scratch.z[c];
}

// First half of Alg. 5.4.2: the closest (contact, old cluster) pair, again and again. Ties go to
// the lowest contact, then to the lowest (deepest) old cluster. An old cluster's nearest contact
// changes only when it is taken.
void seed_from_previous(const ContactClusters& previous, std::size_t n, std::size_t m,
                        ClusterScratch& scratch, Seeds& seeds) noexcept {
  std::array<const ContactCluster*, kMaxContactClusters> old{};
  std::size_t l = 0;
  for (const ContactCluster& c : previous.clusters) old[l++] = &c;
  // Insertion sort: stable without the buffer that std::stable_sort would allocate.
  for (std::size_t i = 1; i < l; ++i) {
    for (std::size_t j = i; j > 0 && old[j]->depth > old[j - 1]->depth; --j)
      std::swap(old[j], old[j - 1]);
  }
  l = std::min(l, m);
  std::array<Nearest, kMaxContactClusters> nearest;
  for (std::size_t k = 0; k < l; ++k) nearest[k] = nearest_free_contact(scratch, n, old[k]->point);
  std::array<bool, kMaxContactClusters> used{};
  for (std::size_t round = 0; round < l; ++round) {
    std::size_t best = l;
    for (std::size_t k = 0; k < l; ++k) {
      if (used[k] || nearest[k].contact < 0) continue;
      const bool closer = best == l || nearest[k].squared < nearest[best].squared ||
                          (nearest[k].squared == nearest[best].squared &&
                           nearest[k].contact < nearest[best].contact);
      if (closer) best = k;
    }
    if (best == l) return;  // only non-finite points are left
    used[best] = true;
    const std::int32_t contact = nearest[best].contact;
    take(scratch, contact, old[best]->id, seeds);
    for (std::size_t k = 0; k < l; ++k) {
      if (!used[k] && nearest[k].contact == contact)
        nearest[k] = nearest_free_contact(scratch, n, old[k]->point);
    }
  }
}

void lower_nearest(ClusterScratch& scratch, std::size_t n, std::size_t seed) noexcept {
  const Vec3 p(scratch.x[seed], scratch.y[seed], scratch.z[seed]);
  for (std::size_t i = 0; i < n; ++i)
    scratch.nearest[i] = std::min(scratch.nearest[i], squared_distance(scratch, i, p));
}

// Second half: the contact furthest from all seeds; the deepest when there is none yet. Ties: the
// lowest index.
void seed_furthest(std::span<const Contact> contacts, std::size_t m, ClusterScratch& scratch,
                   Seeds& seeds) noexcept {
  const std::size_t n = contacts.size();
  if (scratch.seeds.size() == m) return;
  for (const std::int32_t seed : scratch.seeds)
    lower_nearest(scratch, n, static_cast<std::size_t>(seed));
  while (scratch.seeds.size() < m) {
    std::size_t best = n;
    const bool first = scratch.seeds.empty();
    for (std::size_t i = 0; i < n; ++i) {
      if (scratch.taken[i]) continue;
      const bool better = best == n || (first ? contacts[i].depth > contacts[best].depth
                                              : scratch.nearest[i] > scratch.nearest[best]);
      if (better) best = i;
    }
    take(scratch, static_cast<std::int32_t>(best), -1, seeds);
    lower_nearest(scratch, n, best);
  }
}

// Alg. 5.4.3 into s.candidate. Ties: the lowest cluster.
void assign_clusters(const Seeds& seeds, std::size_t n, ClusterScratch& scratch) noexcept {
  const auto count = static_cast<std::size_t>(seeds.count);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = scratch.x[i], y = scratch.y[i], z = scratch.z[i];
    double best = kInfinity;
    std::int32_t cluster = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double dx = x - seeds.x[k], dy = y - seeds.y[k], dz = z - seeds.z[k];
      const double d2 = dx * dx + dy * dy + dz * dz;
      cluster = d2 < best ? static_cast<std::int32_t>(k) : cluster;
      best = d2 < best ? d2 : best;
    }
    scratch.candidate[i] = cluster;
  }
}

struct Sums {
  Vec3 weighted = Vec3::Zero(), plain = Vec3::Zero();
  double weight = 0.0;
  std::int32_t count = 0;
};

// Alg. 5.4.4. A cluster without members keeps its place; one whose members all weigh nothing takes
// their mean.
void compute_representatives(const ClusterScratch& scratch, std::size_t n, Seeds& seeds) noexcept {
  std::array<Sums, kMaxContactClusters> sums;
  for (std::size_t i = 0; i < n; ++i) {
    Sums& t = sums[static_cast<std::size_t>(scratch.assignment[i])];
    const Vec3 p(scratch.x[i], scratch.y[i], scratch.z[i]);
    t.weighted += scratch.weight[i] * p;
    t.plain += p;
    t.weight += scratch.weight[i];
    ++t.count;
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(seeds.count); ++k) {
    const Sums& t = sums[k];
    if (t.count == 0) continue;
    const Vec3 mean = t.weight > 0.0 ? Vec3(t.weighted / t.weight) : Vec3(t.plain / t.count);
    seeds.x[k] = mean.x();
    seeds.y[k] = mean.y();
    seeds.z[k] = mean.z();
  }
}

// Eqs. 5.34-5.36 of every cluster that kept a member; clusters by seed.
void summarize(std::span<const Contact> contacts, const Seeds& seeds, const ClusterScratch& scratch,
               std::array<ContactCluster, kMaxContactClusters>& out) noexcept {
  struct Moments {
    double depth = 0.0, plain_depth = 0.0, blend = 0.0;
    Vec3 normal = Vec3::Zero(), plain_normal = Vec3::Zero();
  };
  std::array<Moments, kMaxContactClusters> moments;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    const auto k = static_cast<std::size_t>(scratch.assignment[i]);
    const double w = scratch.weight[i];
    moments[k].depth += w * c.depth;
    moments[k].plain_depth += c.depth;
    moments[k].normal += w * c.normal;
    moments[k].plain_normal += c.normal;
    ContactCluster& cluster = out[k];
    cluster.weight += w;
    moments[k].blend += c.weight;
    if (cluster.member_count++ == 0)
      cluster.first_member = cluster.deepest_member = static_cast<std::int32_t>(i);
    if (c.depth > contacts[static_cast<std::size_t>(cluster.deepest_member)].depth) {
      cluster.deepest_member = static_cast<std::int32_t>(i);
    }
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(seeds.count); ++k) {
    ContactCluster& cluster = out[k];
    if (cluster.member_count == 0) continue;
    const bool weighs = cluster.weight > 0.0;
    const double total = weighs ? cluster.weight : static_cast<double>(cluster.member_count);
    const Contact& deepest = contacts[static_cast<std::size_t>(cluster.deepest_member)];
    cluster.point = Vec3(seeds.x[k], seeds.y[k], seeds.z[k]);
    cluster.depth = (weighs ? moments[k].depth : moments[k].plain_depth) / total;
    const Vec3 mean = (weighs ? moments[k].normal : moments[k].plain_normal) / total;
    const double length = std::sqrt(mean.squaredNorm());
    cluster.normal = length > kOpposing ? Vec3(mean / length) : deepest.normal;
    cluster.scene_point = cluster.point - cluster.depth * cluster.normal;
    cluster.blend = moments[k].blend;
    cluster.body = deepest.body;
    cluster.id = scratch.seed_ids[k];
  }
}

// Orders clusters by decreasing depth (ties: lowest member), names new ones, renumbers the
// assignment.
void publish(const std::array<ContactCluster, kMaxContactClusters>& by_seed, std::size_t count,
             ClusterScratch& scratch, ContactClusters& result) noexcept {
  std::array<std::size_t, kMaxContactClusters> order{};
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (by_seed[k].member_count > 0) order[kept++] = k;
  }
  std::sort(order.begin(), order.begin() + kept, [&](std::size_t i, std::size_t j) {
    if (by_seed[i].depth != by_seed[j].depth) return by_seed[i].depth > by_seed[j].depth;
    return by_seed[i].first_member < by_seed[j].first_member;
  });
  std::array<std::int32_t, kMaxContactClusters> rank{};
  result.clusters.clear();
  for (std::size_t i = 0; i < kept; ++i) {
    rank[order[i]] = static_cast<std::int32_t>(i);
    ContactCluster cluster = by_seed[order[i]];
    if (cluster.id < 0) {
      cluster.id = result.next_id;
      result.next_id =
          result.next_id == std::numeric_limits<std::int32_t>::max() ? 0 : result.next_id + 1;
    }
    result.clusters.push_back(cluster);
  }
  for (std::int32_t& cluster : scratch.assignment)
    cluster = rank[static_cast<std::size_t>(cluster)];
}

double cost(const ClusterScratch& scratch, const ContactClusters& result) noexcept {
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < scratch.assignment.size(); ++i) {
    const ContactCluster& cluster =
        result.clusters[static_cast<std::size_t>(scratch.assignment[i])];
    sum += scratch.weight[i] * squared_distance(scratch, i, cluster.point);
    total += scratch.weight[i];
  }
  return total > 0.0 ? sum / total : 0.0;
}

}  // namespace

void reserve_clusters(ClusterScratch& scratch, std::size_t contacts) {
  if (contacts <= scratch.x.size()) return;
  for (std::vector<double>* v :
       {&scratch.x, &scratch.y, &scratch.z, &scratch.weight, &scratch.nearest}) {
    v->resize(contacts);
  }
  scratch.taken.resize(contacts);
  scratch.assignment.reserve(contacts);
  scratch.candidate.reserve(contacts);
}

void cluster_contacts(std::span<const Contact> contacts, const ContactClusters& previous,
                      const ClusterParams& params, ClusterScratch& scratch,
                      ContactClusters& result) noexcept {
  const std::size_t n = contacts.size();
  load(contacts, params.tolerance, scratch);
  result.next_id = previous.next_id;
  result.iterations = 0;
  result.cost = 0.0;
  if (n == 0) {
    result.clusters.clear();
    return;
  }
  const auto wanted =
      static_cast<std::size_t>(std::clamp(params.max_clusters, 1, kMaxContactClusters));
  const std::size_t m = std::min(wanted, n);
  Seeds seeds;
  seed_from_previous(previous, n, m, scratch, seeds);
  seed_furthest(contacts, m, scratch, seeds);
  for (int i = 0; i < kMaxIterations; ++i) {
    assign_clusters(seeds, n, scratch);
    if (i > 0 && scratch.candidate == scratch.assignment) break;
    scratch.assignment.swap(scratch.candidate);
    ++result.iterations;
    compute_representatives(scratch, n, seeds);
  }
  std::array<ContactCluster, kMaxContactClusters> by_seed{};
  summarize(contacts, seeds, scratch, by_seed);
  publish(by_seed, m, scratch, result);
  result.cost = cost(scratch, result);
}

}  // namespace thigma
