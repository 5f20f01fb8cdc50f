// Clusters lie on a space-filling curve; each looks a few places up and down it for the partner
// that makes the smallest common box, and pairs that choose each other merge. A few rounds of that
// come close to the best greedy tree at a fraction of its cost.

#include "thigma/clod/detail/cluster_tree.h"

#include <algorithm>
#include <cmath>

namespace thigma::detail {
namespace {

// Places on the curve. Measured on jaws: 8 makes fronts 3 % larger, 500 makes them 1 % smaller.
constexpr std::int32_t kReach = 24;

struct Cluster {
  ClusterBox box;
  std::int32_t index;
};

std::uint64_t spread_bits(std::uint64_t x) {  // 21 bits, two zeros between
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

std::vector<Cluster> sorted_on_curve(std::span<const ClusterBox> boxes) {
  Vec3 low = boxes[0].low, high = boxes[0].high;
  for (const ClusterBox& b : boxes) {
    low = low.cwiseMin(b.low);
    high = high.cwiseMax(b.high);
  }
  const double extent = std::max((high - low).maxCoeff(), 1e-300);
  std::vector<std::pair<std::uint64_t, std::int32_t>> order;
  order.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec3 middle = 0.5 * boxes[i].low + 0.5 * boxes[i].high;
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k) {
      const double place = (middle[k] - low[k]) / extent * 2097151.0;
      key |= spread_bits(static_cast<std::uint64_t>(std::clamp(place, 0.0, 2097151.0))) << k;
    }
    order.emplace_back(key, static_cast<std::int32_t>(i));
  }
  std::sort(order.begin(), order.end());
  std::vector<Cluster> clusters;
  clusters.reserve(boxes.size());
  for (const auto& entry : order)
    clusters.push_back({boxes[static_cast<std::size_t>(entry.second)], entry.second});
  return clusters;
}

ClusterBox united(const ClusterBox& a, const ClusterBox& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

/// Half the surface of the common box: 2 % smaller fronts than by its diagonal, 3 % than by its
/// volume.
double cost(const ClusterBox& a, const ClusterBox& b) {
  const ClusterBox box = united(a, b);
  const Vec3 edge = box.high - box.low;
  return edge.x() * edge.y() + edge.y() * edge.z() + edge.z() * edge.x();
}

std::vector<std::int32_t> best_partners(const std::vector<Cluster>& clusters) {
  const auto n = static_cast<std::int32_t>(clusters.size());
  std::vector<std::int32_t> partner(clusters.size(), -1);
  std::vector<double> best(clusters.size(), 0.0);
  const auto offer = [&](std::int32_t i, std::int32_t j, double value) {
    auto& chosen = partner[static_cast<std::size_t>(i)];
    if (chosen >= 0 && value >= best[static_cast<std::size_t>(i)]) return;
    chosen = j;
    best[static_cast<std::size_t>(i)] = value;
  };
  for (std::int32_t i = 0; i < n; ++i)
    for (std::int32_t j = i + 1; j < std::min(n, i + kReach + 1); ++j) {
      const double value = cost(clusters[static_cast<std::size_t>(i)].box,
                                clusters[static_cast<std::size_t>(j)].box);
      offer(i, j, value);
      offer(j, i, value);
    }
  return partner;
}

}  // namespace

std::vector<Merge> merge_clusters(std::span<const ClusterBox> boxes) {
  std::vector<Cluster> clusters = sorted_on_curve(boxes);
  std::vector<Merge> merges;
  merges.reserve(boxes.size());
  auto next_index = static_cast<std::int32_t>(boxes.size());
  while (clusters.size() > 1) {
    const std::vector<std::int32_t> partner = best_partners(clusters);
    std::vector<Cluster> left;
    left.reserve(clusters.size());
    bool has_merged = false;
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      const auto j = static_cast<std::size_t>(partner[i]);
      if (static_cast<std::size_t>(partner[j]) != i) {
        left.push_back(clusters[i]);
      } else if (i < j) {
        merges.push_back({clusters[i].index, clusters[j].index});
        left.push_back({united(clusters[i].box, clusters[j].box), next_index++});
        has_merged = true;
      }
    }
    // Equal costs can chase each other in a ring: then the first two merge.
    if (!has_merged) {
      merges.push_back({left[0].index, left[1].index});
      left[1] = {united(left[0].box, left[1].box), next_index++};
      left.erase(left.begin());
    }
    clusters.swap(left);
  }
  return merges;
}

}  // namespace thigma::detail
