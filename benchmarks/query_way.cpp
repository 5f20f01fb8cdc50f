#include "benchmarks/query_way.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "thigma/contact/clustering.h"
#include "thigma/core/error.h"

namespace thigma::bench {
namespace {

constexpr std::size_t kRoom = 400'000;
constexpr int kClusters = 16;

double number_of(const std::string& word, std::size_t equals) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str() + equals + 1, &end);
  if (*end != '\0' || end == word.c_str() + equals + 1)
    throw InputError(word + ": no number after =, expected one");
  return value;
}

void take_word(const std::string& word, Resolution& way) {
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  if (word == "levels" || word == "exact") {
    way.is_exact = word == "exact";
  } else if (word == "plain") {
    way.interpolates = false;
  } else if (word == "d=ring") {
    way.reading = SupportReading::one_ring;
  } else if (word == "d=flood") {
    way.reading = SupportReading::flood;
  } else if (word == "d=patch") {
    way.reading = SupportReading::patch;
  } else if (name == "carry" && equals != std::string::npos) {
    way.carry = number_of(word, equals);
  } else if (name == "s0" && equals != std::string::npos) {
    way.metric.haptic = number_of(word, equals);
  } else if (name == "cap" && equals != std::string::npos) {
    way.deviation_cap = number_of(word, equals);
  } else {
    throw InputError(word +
                     ": way to query, expected exact, levels, s0=X, cap=X, carry=X, d=ring, "
                     "d=flood, d=patch or plain");
  }
}

/// One query after another, and the force of its clusters.
struct Asker {
  const StoredPair& pair;
  ContactQuery query;
  ContactFront front{};
  ContactSet set{};
  ClusterScratch scratch{};

  Asker(const StoredPair& p, const Resolution& way)
      : pair(p), query{.tolerance = p.tolerance, .resolution = way} {
    reserve_front(front, pair.object, pair.scene);
    set.contacts.reserve(kRoom);
  }

  void ask(const Pose& pose) {
    clear(set);
    query_contacts({pair.object, pose}, {pair.scene}, query, front, set);
  }

  Vec3 force() {
    ContactClusters clusters;
    cluster_contacts(set.contacts, {}, {.max_clusters = kClusters, .tolerance = pair.tolerance},
                     scratch, clusters);
    Vec3 sum = Vec3::Zero();
    for (const ContactCluster& c : clusters.clusters)
      sum -= std::max(c.depth + pair.tolerance, 0.0) * c.normal;
    return sum;
  }

  double separation() const {
    return std::clamp(least_distance(set), 0.0, pair.tolerance) / pair.radius;
  }
};

}  // namespace

Resolution query_way(const std::string& words) {
  Resolution way;
  way.is_exact = false;
  std::istringstream list(words);
  for (std::string word; std::getline(list, word, ',');) take_word(word, way);
  return way;
}

WayQuality way_quality(const StoredPair& pair, const Resolution& way) {
  constexpr std::size_t kStride = 8;
  Asker asked(pair, way), exact(pair, Resolution{});
  WayQuality quality;
  double error = 0.0, size = 0.0, steps = 0.0, sum = 0.0, compared = 0.0;
  Vec3 last = Vec3::Zero();
  for (std::size_t i = 0; i < pair.path.size(); ++i) {
    asked.ask(pair.path[i]);
    const Vec3 force = asked.force();
    quality.contacts += static_cast<double>(asked.set.contacts.size());
    if (i > 0) steps += (force - last).squaredNorm();
    sum += force.norm();
    last = force;
    if (i % kStride != 0) continue;
    exact.ask(pair.path[i]);
    const Vec3 truth = exact.force();
    error += (force - truth).squaredNorm();
    size += truth.squaredNorm();
    quality.separation += std::fabs(asked.separation() - exact.separation());
    compared += 1.0;
  }
  const double poses = static_cast<double>(pair.path.size());
  quality.force = std::sqrt(error / size);
  quality.step = std::sqrt(steps / (poses - 1.0)) / (sum / poses);
  quality.separation /= compared;
  quality.contacts /= poses;
  return quality;
}

}  // namespace thigma::bench
